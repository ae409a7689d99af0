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
