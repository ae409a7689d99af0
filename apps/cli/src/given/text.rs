//! Text of a scene, and its origin.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use sins::log::LogMapping;
use sins::scene::{BUILTIN_SCENES, Fault, Scene, nearest};

use super::file::read_text;
use super::kind::{FileKind, is_record_at};
use super::settings::Settings;
use crate::failure::Failure;

/// Text of a scene.
pub struct Text {
    bytes: Vec<u8>,
    pub origin: String,
    /// Path of the file; `None` for a built-in scene.
    pub path: Option<PathBuf>,
    pub name: String,
}

impl Text {
    /// Text of the built-in scene `name`, or of the file `name`.
    pub fn find(name: &OsStr) -> Result<Self, Failure> {
        let path = Path::new(name);
        let builtin = |known: &str| BUILTIN_SCENES.iter().find(|(name, _)| *name == known);
        if let Some((name, text)) = name.to_str().and_then(builtin) {
            let (bytes, name) = (text.as_bytes().to_vec(), (*name).to_owned());
            return Ok(Self { bytes, origin: format!("{name} (built in)"), path: None, name });
        }
        if path.extension().is_none_or(|ending| ending != "toml") && !path.exists() {
            if path.extension().is_some() || path.components().count() > 1 {
                return Err(Failure::of_file(path, &"no such file"));
            }
            let near = nearest(&path.to_string_lossy(), BUILTIN_SCENES.iter().map(|(name, _)| *name));
            let hint = match near {
                Some(near) => format!("did you mean {near}?"),
                None => "`sins scene list` lists the built-in scenes".to_owned(),
            };
            return Err(Failure::of_file(path, &format!("no such scene; {hint}")));
        }
        let bytes = read_text(path)?;
        if is_header(&bytes) {
            return Err(Failure::of_file(path, &"is a flight log: the name of its file must end in .csv"));
        }
        let origin = path.display().to_string();
        Ok(Self { bytes, origin, path: Some(path.to_owned()), name: name_of(path) })
    }

    /// Scene `text`, which flies the log at `path`.
    pub fn for_log(path: &Path, text: &str) -> Self {
        let bytes = text.as_bytes().to_vec();
        Self { bytes, origin: path.display().to_string(), path: None, name: name_of(path) }
    }

    pub fn parse(&self, settings: &Settings) -> Result<Scene, Failure> {
        let pairs = settings.pairs()?;
        let parsed = Scene::parse_with(&self.bytes, &pairs);
        let mut scene = parsed.map_err(|faults| self.failure(&faults, settings))?;
        if let Some(of_tables) = settings.mappings()? {
            scene.log = of_tables.log;
            if *of_tables.imu != LogMapping::of_imu() {
                scene.imu = of_tables.imu;
            }
        }
        Ok(scene)
    }

    /// The scene of the text alone, of which its title speaks; `None`: the settings replace nothing in it, or the title itself.
    pub fn titled(&self, settings: &Settings) -> Option<Scene> {
        let is_changed =
            settings.pairs().is_ok_and(|pairs| !pairs.is_empty()) && !settings.has("flight.title");
        is_changed.then(|| Scene::parse(&self.bytes).ok()).flatten()
    }

    fn failure(&self, faults: &[Fault], settings: &Settings) -> Failure {
        let sentence = |fault: &Fault| match fault {
            Fault { line: 0, column, sentence, .. } => {
                format!("{}: {sentence}", settings.argument(*column))
            }
            Fault { line, column, sentence, .. } => format!("{}:{line}:{column}: {sentence}", self.origin),
        };
        let mut failures: Vec<Failure> = Vec::new();
        let mut said = Vec::new();
        for fault in faults {
            // --preset sets several keys: what is wrong with its word is one fault.
            if fault.line == 0 {
                let about = fault.sentence.split_once(": ").map(|(_, about)| about);
                let one = (settings.argument(fault.column), about);
                if said.contains(&one) {
                    continue;
                }
                said.push(one);
            }
            failures.push(Failure::new(sentence(fault)));
        }
        let has_ending = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "toml");
        if let Some(path) = self.path.as_ref().filter(|path| !has_ending(path)) {
            let what = match FileKind::of(&self.bytes) {
                Some(_) => {
                    "a flight of your own is a log in a file .csv; docs/your_log.md says what a log has"
                }
                None => {
                    "is read as a scene in TOML, because its name does not end in .csv; --log or --columns reads it as a log"
                }
            };
            // Without a value it is no scene, and each line is a fault.
            if !self.bytes.contains(&b'=') {
                failures.truncate(1);
            }
            failures.push(Failure::of_file(path, &what));
        }
        Failure::all(failures)
    }

    pub fn folder(&self) -> &Path {
        self.path.as_deref().and_then(Path::parent).unwrap_or(Path::new(""))
    }

    /// `failure` with the line of `key`, if the line is found.
    pub fn at(&self, section: &str, key: &str, failure: Failure) -> Failure {
        let Some(path) = &self.path else { return failure };
        let text = String::from_utf8_lossy(&self.bytes);
        match line_of(&text, section, key) {
            Some(line) => Failure::of_line(path, line, &failure),
            None => failure,
        }
    }
}

/// Line of `key` in `[section]`, if the text writes the key in this form.
fn line_of(text: &str, section: &str, key: &str) -> Option<u64> {
    let head = format!("[{section}]");
    let mut is_inside = false;
    for (line, number) in text.lines().zip(1..) {
        let line = line.trim();
        if line.starts_with('[') {
            is_inside = line.split('#').next().is_some_and(|begin| begin.trim() == head);
        } else if is_inside && line.split('=').next().is_some_and(|name| name.trim() == key) {
            return Some(number);
        }
    }
    None
}

/// Whether `name` is the name of a flight log, or of a file that is a flight record.
pub fn is_log(name: &OsStr) -> bool {
    const ENDINGS: [&str; 4] = ["csv", "igc", "gpx", "fdr"];
    let path = Path::new(name);
    let has_ending =
        path.extension().is_some_and(|ending| ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known)));
    name == "-" || has_ending || is_record_at(path)
}

/// Whether `name` is the name of a scene: of a built-in one, or of a file that ends in .toml.
pub fn is_scene(name: &OsStr) -> bool {
    let is_builtin = || BUILTIN_SCENES.iter().any(|(known, _)| name == *known);
    Path::new(name).extension().is_some_and(|ending| ending == "toml") || is_builtin()
}

/// Whether a text begins with the header of a flight log.
fn is_header(text: &[u8]) -> bool {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let is_empty = |line: &&[u8]| line.starts_with(b"#") || line.trim_ascii().is_empty();
    let header = text.split(|byte| *byte == b'\n').find(|line| !is_empty(line));
    let is_mark = |byte: &u8| !(byte.is_ascii_alphanumeric() || *byte == b'_');
    header.is_some_and(|line| {
        line.split(is_mark).any(|word| word.eq_ignore_ascii_case(b"time_s")) && !line.contains(&b'=')
    })
}

/// Name of a file without folder and ending.
pub fn name_of(path: &Path) -> String {
    match path.file_stem() {
        Some(stem) if path != Path::new("-") => stem.to_string_lossy().into_owned(),
        _ => "log".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_have_their_lines() {
        let text = "# [flight]\n[gyro]\nfile = 1\n[flight] # here\n  file = \"a.csv\"\n";
        assert_eq!(line_of(text, "flight", "file"), Some(5));
        assert_eq!(line_of(text, "flight", "builtin"), None);
    }

    #[test]
    fn logs_have_their_names() {
        assert!(is_log(OsStr::new("a/b.CSV")) && is_log(OsStr::new("-")) && !is_log(OsStr::new("patrol")));
        assert_eq!((name_of(Path::new("a/b.csv")), name_of(Path::new("-"))), ("b".into(), "log".into()));
    }
}
