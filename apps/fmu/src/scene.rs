//! The scene that the parameters define.
//!
//! A parameter at its start value keeps the value of the scene, because many tools set every parameter to its start value. So a
//! parameter cannot reset a key of the scene to its default; such a key has to be changed in the scene.

use std::path::{Component, Path};

use sins::scene::{Fault, KeyKind, KeyLine, MAX_TEXT, Scene, builtin, keys};

use crate::parameters::{FAILURE, FAILURES, SCENE_BUILTIN, SCENE_FILE, SCENE_TEXT, SECTIONS, subscript};
use crate::table::{Table, table};
use crate::values::{Value, Values};
use crate::variable::Variable;

/// Name of a log that replaces the flight of every scene.
const FLIGHT: &str = "inputs";

/// Parameters that are not at their start value, for the text of a scene.
struct Changed<'v> {
    table: &'v Table,
    values: &'v Values,
}

impl<'v> Changed<'v> {
    /// The variable of this name and its value.
    fn any(&self, name: &str) -> Option<(&'v Variable, Value)> {
        let (variable, place) = self.table.named(name)?;
        Some((variable, self.values.get(variable.start.base(), place)?))
    }

    /// The variable of this name and its value, if the value is not the start value.
    fn value(&self, name: &str) -> Option<(&'v Variable, Value)> {
        self.any(name).filter(|(variable, value)| *value != variable.start)
    }

    fn text(&self, name: &str) -> Option<String> {
        match self.value(name)?.1 {
            Value::String(text) => Some(text),
            _ => None,
        }
    }

    /// Value of a key in TOML. Elements at their start value are taken from `numbers`.
    fn of_key(&self, key: &KeyLine, path: &str, numbers: &[f64]) -> Option<String> {
        let KeyKind::Numbers(count) = key.kind else {
            return self.value(path).map(|(variable, value)| toml(variable, &value));
        };
        let changed: Vec<Option<(&Variable, Value)>> =
            (0..count).map(|index| self.value(&format!("{path}{}", subscript(count, index)))).collect();
        if changed.iter().all(Option::is_none) {
            return None;
        }
        let elements: Vec<String> = changed
            .into_iter()
            .enumerate()
            .map(|(index, element)| match element {
                Some((variable, value)) => toml(variable, &value),
                None => format!("{:?}", numbers.get(index).copied().unwrap_or(0.0)),
            })
            .collect();
        Some(if count == 1 { elements.concat() } else { format!("[{}]", elements.join(", ")) })
    }

    /// A failure as a part of a scene; empty if there is none.
    fn failure(&self, slot: usize) -> String {
        let path = |name: &str| format!("{FAILURE}[{slot}].{name}");
        if self.value(&path("kind")).is_none() {
            return String::new();
        }
        let word = |name: &str| self.any(&path(name)).map(|(variable, value)| toml(variable, &value));
        let sensor = word("sensor");
        let is_altimeter = sensor.as_deref() == Some("\"altimeter\"");
        let mut text = format!("\n[[{FAILURE}]]\n");
        for key in keys().iter().filter(|key| key.section == FAILURE) {
            let value = match key.name {
                "sensor" => sensor.clone(),
                "axis" if is_altimeter => None,
                "axis" => word("axis"),
                name => self.of_key(key, &path(name), &[]),
            };
            if let Some(value) = value {
                text.push_str(&format!("{} = {value}\n", key.name));
            }
        }
        text
    }
}

/// A value in TOML. An integer without a word of its enumeration stays a number, which the scene refuses.
fn toml(variable: &Variable, value: &Value) -> String {
    match value {
        Value::Real(number) => format!("{number:?}"),
        Value::Boolean(flag) => flag.to_string(),
        Value::String(text) => text.clone(),
        Value::Integer(number) => {
            let index = number.checked_sub(1).and_then(|index| usize::try_from(index).ok());
            let word = variable.words.and_then(|words| words.get(index?));
            word.map_or(number.to_string(), |word| format!("\"{word}\""))
        }
    }
}

/// The scene that the parameters define; `resources` is the unit's folder of resources.
pub fn scene(values: &Values, resources: Option<&Path>) -> Result<Scene, String> {
    let changed = Changed { table: &table(), values };
    let mut text = scene_text(&changed, resources)?;
    let base = parse(&text, &[]).map_err(|faults| first(&faults, |fault| format!("scene, line {fault}")))?;
    // The last line before each slot.
    let mut slots = [0; FAILURES];
    for (slot, before) in (1..).zip(&mut slots) {
        *before = text.lines().count();
        text.push_str(&changed.failure(slot));
    }
    let settings: Vec<(String, String)> = keys()
        .iter()
        .filter(|key| SECTIONS.contains(&key.section))
        .filter_map(|key| {
            let path = format!("{}.{}", key.section, key.name);
            let value = changed.of_key(key, &path, &base.numbers(&path).unwrap_or_default())?;
            Some((path, value))
        })
        .collect();
    let mut scene =
        parse(&text, &settings).map_err(|faults| first(&faults, |fault| of_parameter(fault, &slots)))?;
    // The master gives the samples, so the scene has no flight of its own.
    scene.flight = sins::scene::FlightSource::Log(FLIGHT.to_owned());
    Ok(scene)
}

/// The text of the scene, from the parameter that gives it.
fn scene_text(changed: &Changed<'_>, resources: Option<&Path>) -> Result<String, String> {
    let given = [SCENE_FILE, SCENE_TEXT, SCENE_BUILTIN].map(|name| changed.text(name));
    match given {
        // The recommended options and ideal sensors.
        [None, None, None] => Ok(String::new()),
        [Some(file), None, None] => read(&file, resources),
        [None, Some(text), None] => Ok(text),
        [None, None, Some(name)] => builtin(&name)
            .map(|scene| scene.write())
            .ok_or_else(|| format!("{SCENE_BUILTIN}: there is no scene \"{name}\"")),
        _ => Err(format!("{SCENE_FILE}, {SCENE_TEXT}, {SCENE_BUILTIN}: set one of them")),
    }
}

/// A file below the folder of resources.
fn read(file: &str, resources: Option<&Path>) -> Result<String, String> {
    let folder = resources.ok_or_else(|| format!("{SCENE_FILE}: the master gave no folder of resources"))?;
    let is_plain = |part: Component<'_>| matches!(part, Component::Normal(_));
    if !Path::new(file).components().all(is_plain) {
        return Err(format!("{SCENE_FILE} = \"{file}\": expected a file below resources, without .."));
    }
    let path = folder.join(file);
    let refused = |why: &dyn std::fmt::Display| format!("{SCENE_FILE} = \"{}\": {why}", path.display());
    let size = std::fs::metadata(&path).map_err(|error| refused(&error))?.len();
    if size > MAX_TEXT as u64 {
        return Err(refused(&format!("{size} bytes: must be at most {MAX_TEXT}")));
    }
    std::fs::read_to_string(&path).map_err(|error| refused(&error))
}

/// Parses a scene, which need not have a flight.
fn parse(text: &str, settings: &[(String, String)]) -> Result<Scene, Vec<Fault>> {
    let mut settings: Vec<(&str, &str)> =
        settings.iter().map(|(path, value)| (path.as_str(), value.as_str())).collect();
    Scene::parse_with(text.as_bytes(), &settings).or_else(|faults| {
        settings.push(("flight.file", FLIGHT));
        Scene::parse_with(text.as_bytes(), &settings)
            .map_err(|others| if others.len() < faults.len() { others } else { faults })
    })
}

/// The first fault, and the number of the others.
fn first(faults: &[Fault], sentence: impl Fn(&Fault) -> String) -> String {
    let more = match faults.len() {
        0 | 1 => String::new(),
        count => format!(" (and {} faults more)", count - 1),
    };
    faults.first().map(sentence).unwrap_or_default() + &more
}

/// The sentence of a fault with the name of the variable. `slots` are the last lines before the failures' parts of the text.
fn of_parameter(fault: &Fault, slots: &[usize]) -> String {
    let sentence = &fault.sentence;
    match slots.partition_point(|before| *before < fault.line) {
        0 if fault.line == 0 => of_element(sentence).unwrap_or_else(|| sentence.clone()),
        0 => format!("scene, line {fault}"),
        slot => sentence.replacen("failure.", &format!("{FAILURE}[{slot}]."), 1),
    }
}

/// The sentence of a fault of one element of a key, with the subscript of FMI.
fn of_element(sentence: &str) -> Option<String> {
    let (element, rest) = sentence.split_once(']')?;
    let (path, index) = element.split_once('[')?;
    let (section, name) = path.split_once('.')?;
    let key = keys().into_iter().find(|key| key.section == section && key.name == name)?;
    let KeyKind::Numbers(count) = key.kind else { return None };
    Some(format!("{path}{}{rest}", subscript(count, index.parse().ok()?)))
}
