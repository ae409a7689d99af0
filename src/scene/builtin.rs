//! The scenes that come with the library.

use super::Scene;

/// The built-in scenes: name and text.
pub const BUILTIN_SCENES: &[(&str, &str)] = &[
    ("simulation1", include_str!("flights/simulation1.toml")),
    ("simulation2", include_str!("flights/simulation2.toml")),
    ("rest", include_str!("flights/rest.toml")),
    ("patrol", include_str!("flights/patrol.toml")),
    ("racetrack", include_str!("flights/racetrack.toml")),
    ("aerobatics", include_str!("flights/aerobatics.toml")),
    ("over_the_pole", include_str!("flights/over_the_pole.toml")),
    ("coning", include_str!("flights/coning.toml")),
    ("commuter", include_str!("flights/commuter.toml")),
    ("rock_size", include_str!("flights/rock_size.toml")),
    ("spin_accel", include_str!("flights/spin_accel.toml")),
    ("gen_nav", include_str!("flights/gen_nav.toml")),
];

/// The built-in scene of `name`.
pub fn builtin(name: &str) -> Option<Scene> {
    let (_, text) = BUILTIN_SCENES.iter().find(|(known, _)| *known == name)?;
    Scene::parse(text.as_bytes()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_built_in_scene_is_read_and_has_a_flight() {
        for (name, text) in BUILTIN_SCENES {
            let scene = Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{name}: {faults:?}"));
            assert!(!scene.title.is_empty(), "{name}");
            let flight = scene.flight().unwrap();
            assert!((60.0..=flight.duration_s()).contains(&scene.flown_s().unwrap()), "{name}");
            assert!(scene.simulator().is_ok(), "{name}");
            let named = Scene::parse(format!("[flight]\nbuiltin = \"{name}\"\n").as_bytes()).unwrap();
            assert_eq!(named.flown_s(), scene.flown_s(), "{name} as the flight of another scene");
        }
    }
}
