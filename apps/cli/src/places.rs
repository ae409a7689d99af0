//! Places of the outputs of a scene: from the command line, otherwise from the scene. Places from a scene stay below the current
//! folder, whoever wrote the scene.

use std::path::{Component, Path, PathBuf};

use crate::failure::Failure;
use crate::given::Given;

/// Default folder of all outputs.
pub const OUTPUT_FOLDER: &str = "sins_out";

/// Where a command that flies one scene writes.
#[derive(Debug, Default, clap::Args)]
pub struct OutputArguments {
    /// Folder of all outputs [default: the scene's output.folder, or sins_out]
    #[arg(short, long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Base name of the outputs [default: the scene's output.name, or the name of its file]
    #[arg(long)]
    name: Option<String>,
    /// Shows neither progress nor summary
    #[arg(short, long)]
    quiet: bool,
    /// Also replaces files that this program did not write
    #[arg(long)]
    pub force: bool,
}

impl OutputArguments {
    /// Folder and base name of the outputs of `given`.
    pub fn places(&self, given: &Given) -> Result<(PathBuf, String), Failure> {
        let output = &given.scene.output;
        let folder = match &self.out {
            Some(folder) => folder.clone(),
            None if output.folder.is_empty() => PathBuf::from(OUTPUT_FOLDER),
            None => below(Path::new(""), &output.folder, "output.folder", "--out")?,
        };
        let (name, key) = match &self.name {
            Some(name) => (name, "--name"),
            None if output.name.is_empty() => (&given.name, "the scene's name"),
            None => (&output.name, "output.name"),
        };
        Ok((folder, base_name(name, key)?))
    }

    /// Whether neither progress nor summary is shown for `given`.
    pub fn is_quiet(&self, given: &Given) -> bool {
        self.quiet || given.scene.output.quiet
    }
}

/// `name`, if files can have it with an ending.
pub fn base_name(name: &str, key: &str) -> Result<String, Failure> {
    let is_of_folder = name.contains(['/', '\\']) || name.chars().any(char::is_control);
    if is_of_folder || name.trim_matches(['.', ' ']).is_empty() {
        let what =
            format!("{key} \"{name}\": expected a name without a folder, with more than dots and spaces");
        return Err(Failure::new(what));
    }
    Ok(name.to_owned())
}

/// Name of the picture of a scene.
pub fn svg(scene: &str) -> Result<String, Failure> {
    Ok(format!("{}.svg", base_name(scene, "the scene's name")?))
}

/// `file` below `folder`; refuses a path that leads out of the folder.
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

/// The file beside `path` with the same name and another ending.
pub fn beside(path: &Path, ending: &str) -> PathBuf {
    path.with_file_name(format!("{}{ending}", path.file_stem().unwrap_or_default().to_string_lossy()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_more_than_dots() {
        for name in [".", "..", "", " ", ". .", "a/b", "..\\b", "a\tb"] {
            assert!(base_name(name, "--name").unwrap_err().to_string().starts_with("--name \""), "{name:?}");
        }
        for name in ["a", ".a", "a.", "a b", "é"] {
            assert_eq!(base_name(name, "--name").unwrap(), name);
        }
    }

    #[test]
    fn files_of_a_scene_stay_below_the_folder() {
        let of = |file| below(Path::new("out"), file, "output.imu", "--imu").map_err(|e| e.to_string());
        assert_eq!(of("a/imu.csv"), Ok(PathBuf::from("out/a/imu.csv")));
        for file in ["/etc/passwd", "../imu.csv", "a/../../imu.csv", ".", "", "./imu.csv", "a\0b"] {
            assert!(of(file).unwrap_err().contains("output.imu"), "{file:?}");
        }
    }
}
