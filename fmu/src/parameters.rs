//! The parameters: a scene, single keys of a scene, and failures.
//!
//! A parameter at its start value keeps the value of the scene, because many tools set every parameter to its start value. So a
//! parameter cannot reset a key of the scene to its default; such a key has to be changed in the scene.

use std::path::{Component, Path};

use sins::scene::{KeyKind, KeyLine, MAX_TEXT, Scene, builtin, keys};

use crate::values::{Value, Values};
use crate::variables::{Role, Table, Variable, table};

/// Sections that are parameters, and sections whose parameters may change in flight.
const SECTIONS: [&str; 7] = ["options", "gyro", "accelerometer", "altimeter", "start", "mounting", "gravity"];
const TUNABLE: [&str; 3] = ["gyro", "accelerometer", "altimeter"];

/// The section of failures, and the number of failures that are parameters.
const FAILURE: &str = "failure";
pub const FAILURES: usize = 8;

const SCENE_FILE: &str = "scene_file";
const SCENE_TEXT: &str = "scene_text";
const SCENE_BUILTIN: &str = "scene_builtin";

/// Name of a log that replaces the flight of every scene.
const FLIGHT: &str = "inputs";

/// The parameters as variables.
pub fn variables() -> impl Iterator<Item = Variable> {
    let scene = |name, doc| Variable::new(name, Role::Fixed, Value::String(String::new()), doc);
    let scenes = [
        scene(SCENE_FILE, "scene: a file in the folder resources of this unit; its flight does not count"),
        scene(SCENE_TEXT, "scene: its text; its flight does not count"),
        scene(SCENE_BUILTIN, "scene: the name of a built-in one; its flight does not count"),
    ];
    let default = Scene::default();
    let of_keys = keys().into_iter().filter(|key| SECTIONS.contains(&key.section)).flat_map(move |key| {
        let role = if TUNABLE.contains(&key.section) { Role::Tunable } else { Role::Fixed };
        let path = format!("{}.{}", key.section, key.name);
        let numbers = default.numbers(&path).unwrap_or_default();
        let value = default.value(&path).unwrap_or_default();
        of_key(&key, &path, role, &numbers, value.trim_matches('"'))
    });
    let failures = (1..=FAILURES).flat_map(|slot| {
        let of_failure = keys().into_iter().filter(|key| key.section == FAILURE);
        of_failure.flat_map(move |key| {
            of_key(&key, &format!("{FAILURE}[{slot}].{}", key.name), Role::Tunable, &[0.0], "none")
        })
    });
    scenes.into_iter().chain(of_keys).chain(failures)
}

/// The variables of a key: one for each number.
fn of_key(key: &KeyLine, path: &str, role: Role, numbers: &[f64], word: &str) -> Vec<Variable> {
    let doc = key.doc;
    match key.kind {
        KeyKind::Numbers(count) => (0..count)
            .map(|index| {
                let name = format!("{path}{}", subscript(count, index));
                // A key without a default has the start value 0.
                let start = numbers.get(index).copied().filter(|number| number.is_finite()).unwrap_or(0.0);
                let variable =
                    Variable::new(name, role, Value::Real(start), doc).in_unit(key.unit, key.unit_si);
                Variable { limits: limits(key, start), ..variable }
            })
            .collect(),
        KeyKind::Words(words) => {
            let start = words.iter().position(|known| *known == word).unwrap_or(0);
            let variable = Variable::new(path, role, Value::Integer(start as i32 + 1), doc);
            vec![Variable { words: Some(words), ..variable }]
        }
        KeyKind::Whole => {
            vec![Variable::new(path, role, Value::Integer(word.parse().unwrap_or(0)), doc)]
        }
        KeyKind::Text => vec![Variable::new(path, role, Value::String(word.to_owned()), doc)],
        KeyKind::Flag => vec![Variable::new(path, role, Value::Boolean(word == "true"), doc)],
    }
}

/// Limits for the model description; `None` if the start value is not within them, which FMI does not allow.
fn limits(key: &KeyLine, start: f64) -> Option<(f64, f64)> {
    let limits = key.limits?;
    let low = if limits.zero_is_off { limits.low.min(0.0) } else { limits.low };
    (low..=limits.high).contains(&start).then_some((low, limits.high))
}

/// Indices after the name of an element: FMI counts from 1, and matrices have row and column.
fn subscript(count: usize, index: usize) -> String {
    match count {
        1 => String::new(),
        9 => format!("[{},{}]", index / 3 + 1, index % 3 + 1),
        _ => format!("[{}]", index + 1),
    }
}

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
    let base = parse(&text, &[])?;
    for slot in 1..=FAILURES {
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
    let mut scene = parse(&text, &settings)?;
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

/// Parses a scene, which need not have a flight. `Err` is a sentence with the first fault and the number of faults.
fn parse(text: &str, settings: &[(String, String)]) -> Result<Scene, String> {
    let mut settings: Vec<(&str, &str)> =
        settings.iter().map(|(path, value)| (path.as_str(), value.as_str())).collect();
    let parsed = Scene::parse_with(text.as_bytes(), &settings).or_else(|faults| {
        settings.push(("flight.file", FLIGHT));
        Scene::parse_with(text.as_bytes(), &settings)
            .map_err(|others| if others.len() < faults.len() { others } else { faults })
    });
    parsed.map_err(|faults| {
        let more = match faults.len() {
            0 | 1 => String::new(),
            count => format!(" (and {} faults more)", count - 1),
        };
        faults.first().map_or_else(String::new, |fault| format!("{fault}{more}"))
    })
}
