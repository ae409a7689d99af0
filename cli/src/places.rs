//! Where the outputs of a scene go: the command line's places, or else the scene's. Those stay below the folder of the moment,
//! whoever wrote the scene.

use std::path::{Component, Path, PathBuf};

use crate::failure::Failure;
use crate::given::Given;

/// Folder of all outputs, where nothing else is said.
pub const OUTPUT_FOLDER: &str = "sins_out";

/// Folder and base name of the outputs of `given`; `out` and `name` are the command line's.
pub fn places(out: Option<&Path>, name: Option<&str>, given: &Given) -> Result<(PathBuf, String), Failure> {
    let output = &given.scene.output;
    let folder = match out {
        Some(folder) => folder.to_owned(),
        None if output.folder.is_empty() => PathBuf::from(OUTPUT_FOLDER),
        None => below(Path::new(""), &output.folder, "output.folder", "--out")?,
    };
    let name = name.or(Some(output.name.as_str()).filter(|name| !name.is_empty()));
    let name = name.unwrap_or(&given.name).to_owned();
    if name.is_empty() || name.contains(['/', '\\']) || name.chars().any(char::is_control) {
        return Err(Failure::new(format!("--name \"{name}\": expected a name without a folder")));
    }
    Ok((folder, name))
}

/// `file` below `folder`; refuses what leads out of it.
pub fn below(folder: &Path, file: &str, key: &str, option: &str) -> Result<PathBuf, Failure> {
    let path = Path::new(file);
    let is_plain = |part: Component<'_>| matches!(part, Component::Normal(_));
    if file.contains('\0') || !path.components().all(is_plain) || path.components().next().is_none() {
        let what = format!(
            "{key} = \"{file}\": expected a name below the folder of the outputs ({option}), without .."
        );
        return Err(Failure::new(what));
    }
    Ok(folder.join(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_a_scene_stay_below_the_folder() {
        let of = |file| below(Path::new("out"), file, "output.imu", "--imu").map_err(|e| e.to_string());
        assert_eq!(of("a/imu.csv"), Ok(PathBuf::from("out/a/imu.csv")));
        for file in ["/etc/passwd", "../imu.csv", "a/../../imu.csv", ".", "", "./imu.csv", "a\0b"] {
            assert!(of(file).unwrap_err().contains("output.imu"), "{file:?}");
        }
    }
}
