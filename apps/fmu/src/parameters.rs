//! The parameters: a scene, single keys of a scene, and failures.

use sins::scene::{KeyKind, KeyLine, Scene, keys};

use crate::values::Value;
use crate::variable::{Role, Variable};

/// Sections that are parameters, and sections whose parameters may change in flight.
pub const SECTIONS: [&str; 8] =
    ["options", "gyro", "accelerometer", "altimeter", "start", "mounting", "gravity", "unit"];
const TUNABLE: [&str; 3] = ["gyro", "accelerometer", "altimeter"];

/// The section of failures, and the number of failures that are parameters.
pub const FAILURE: &str = "failure";
pub const FAILURES: usize = 8;

pub const SCENE_FILE: &str = "scene_file";
pub const SCENE_TEXT: &str = "scene_text";
pub const SCENE_BUILTIN: &str = "scene_builtin";

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
pub fn subscript(count: usize, index: usize) -> String {
    match count {
        1 => String::new(),
        9 => format!("[{},{}]", index / 3 + 1, index % 3 + 1),
        _ => format!("[{}]", index + 1),
    }
}
