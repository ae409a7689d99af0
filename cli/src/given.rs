//! The scene that the command line names, and its flight sample by sample.

use std::ffi::OsStr;
use std::io::Read;
use std::path::{Path, PathBuf};

use sins::Error;
use sins::flight::Flight;
use sins::log::{FlightLog, LogError};
use sins::scene::{BUILTIN_SCENES, Fault, FlightSource, MAX_TEXT, Scene, nearest};
use sins::truth::FlightSample;

use crate::failure::Failure;
use crate::units::rounded;


/// What is set of a scene beside its text.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Settings {
    /// Errors of gyros and accelerometers to begin with: ideal, strategic, navigation, tactical, industrial, consumer, paper2
    #[arg(long, value_name = "GRADE")]
    pub preset: Option<String>,
    /// Sets a key of the scene, as gyro.bias_deg_h=0.01; `sins keys` lists them. Any number of times
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
}

/// What `--preset` sets.
const PRESETS: [&str; 2] = ["gyro.preset", "accelerometer.preset"];

impl Settings {
    /// Keys and values, in the order of [`Self::words`].
    fn pairs(&self) -> Result<Vec<(&str, &str)>, Failure> {
        let presets = self.preset.iter().flat_map(|grade| PRESETS.map(|key| (key, grade.as_str())));
        let set = self.set.iter().map(|text| {
            let expected = || Failure::new(format!("--set {text}: expected KEY=VALUE, as gyro.bias_deg_h=0.01"));
            text.split_once('=').map(|(key, value)| (key.trim(), value.trim())).ok_or_else(expected)
        });
        presets.map(Ok).chain(set).collect()
    }

    /// The setting of a number, from 1, as it was given.
    fn words(&self, number: usize) -> String {
        let presets = self.preset.iter().flat_map(|grade| PRESETS.map(|_| format!("--preset {grade}")));
        let set = self.set.iter().map(|text| format!("--set {text}"));
        presets.chain(set).nth(number.saturating_sub(1)).unwrap_or_default()
    }

    fn has(&self, key: &str) -> bool {
        self.set.iter().any(|text| text.split('=').next().is_some_and(|name| name.trim() == key))
    }
}

/// Rounding of times that must not take a sample away [intervals].
const ROUNDING: f64 = 1e-9;

/// A scene with its flight.
#[derive(Debug)]
pub struct Given {
    pub scene: Scene,
    /// What it is called: its file without the ending, or the built-in scene.
    pub name: String,
    /// The scene's file, or the built-in scene.
    pub origin: String,
    /// All files that were read.
    pub inputs: Vec<PathBuf>,
    /// The scene in words.
    pub title: String,
    /// Number of samples.
    pub count: usize,
    /// Time between two samples, of a log on average [s].
    pub period_s: f64,
    /// Time from the first sample to the last [s].
    pub duration_s: f64,
    motion: Motion,
}

#[derive(Debug)]
enum Motion {
    Flight(Flight),
    Log(PathBuf, FlightLog),
}

/// The text of a scene and where it is from.
struct Text {
    bytes: Vec<u8>,
    origin: String,
    /// None: built in.
    path: Option<PathBuf>,
    name: String,
}

impl Given {
    /// The scene called `name` (built in, a file, or a log), with `log` in the place of its flight. A log alone is flown by the
    /// simulator of the scene in the text `for_logs`.
    pub fn load(
        name: Option<&OsStr>,
        log: Option<&Path>,
        settings: &Settings,
        for_logs: &str,
    ) -> Result<Self, Failure> {
        let (text, log) = match name {
            Some(name) if is_log(name) && log.is_some() => {
                let what = format!("{}: is a log, and --log names another", Path::new(name).display());
                return Err(Failure::new(what));
            }
            Some(name) if is_log(name) => (Text::for_log(Path::new(name), for_logs), Some(Path::new(name))),
            Some(name) => (Text::find(name)?, log),
            None => match log {
                Some(path) => (Text::for_log(path, for_logs), log),
                None => return Err(Failure::new("which scene? `sins scene list` lists those that are built in")),
            },
        };
        let mut scene = text.parse(settings)?;
        let mut inputs: Vec<PathBuf> = text.path.iter().cloned().collect();
        let mut name = text.name.clone();
        if let Some(log) = log {
            scene.flight = FlightSource::Log(log.to_string_lossy().into_owned());
            if !settings.has("flight.hours") {
                scene.duration_s = None;
            }
            if !settings.has("flight.title") {
                scene.title.clear();
            }
            name = name_of(log);
        }
        let motion = match &scene.flight {
            FlightSource::Log(file) => {
                let path = match log {
                    Some(path) => path.to_owned(),
                    None => text.folder().join(file),
                };
                let log = read_log(&path).map_err(|failure| text.at("flight", "file", failure))?;
                if scene.temperature.is_some() && log.samples()[0].temperature_c.is_some() {
                    let what = Failure::new("flight.temperature_c: the log has a column of that name");
                    return Err(text.at("flight", "temperature_c", what));
                }
                inputs.push(path.clone());
                Motion::Log(path, log)
            }
            _ => Motion::Flight(scene.flight()?),
        };
        let (count, period_s, duration_s) = extent(&scene, &motion)?;
        let title = title(&scene, &motion);
        Ok(Self { scene, name, origin: text.origin, inputs, title, count, period_s, duration_s, motion })
    }

    /// The sample `index`.
    pub fn sample(&self, index: usize) -> Result<FlightSample, Error> {
        match &self.motion {
            // Rounding must not carry the last time over the end.
            Motion::Flight(flight) => {
                flight.sample_at((index as f64 * self.period_s).min(flight.duration_s()))
            }
            Motion::Log(_, log) => Ok(log.samples()[index]),
        }
    }

    /// Time stamp of the first sample [s].
    pub fn start_s(&self) -> f64 {
        match &self.motion {
            Motion::Flight(_) => 0.0,
            Motion::Log(_, log) => log.samples()[0].time_s,
        }
    }

    /// The flight in closed form; none of a log.
    pub fn flight(&self) -> Option<&Flight> {
        match &self.motion {
            Motion::Flight(flight) => Some(flight),
            Motion::Log(..) => None,
        }
    }

    /// Where the sample `index` stands: the line of a log, or the time.
    pub fn place(&self, index: usize) -> String {
        match &self.motion {
            Motion::Flight(_) => {
                format!("{}: at {} s", self.origin, rounded(index as f64 * self.period_s, 10))
            }
            Motion::Log(path, log) => {
                format!("{}:{}", path.display(), log.line(index).unwrap_or_default())
            }
        }
    }

    /// `error` about the sample `index`.
    pub fn refusal(&self, index: usize, error: &dyn std::fmt::Display) -> Failure {
        Failure::new(format!("{}: {error}", self.place(index)))
    }
}

impl Text {
    /// A built-in scene, or the file of that name.
    fn find(name: &OsStr) -> Result<Self, Failure> {
        let path = Path::new(name);
        let builtin = |known: &str| BUILTIN_SCENES.iter().find(|(name, _)| *name == known);
        if let Some((name, text)) = name.to_str().and_then(builtin) {
            let (bytes, name) = (text.as_bytes().to_vec(), (*name).to_owned());
            return Ok(Self { bytes, origin: format!("{name} (built in)"), path: None, name });
        }
        if !path.extension().is_some_and(|ending| ending == "toml") && !path.exists() {
            let near = nearest(&path.to_string_lossy(), BUILTIN_SCENES.iter().map(|(name, _)| *name));
            let hint = match near {
                Some(near) => format!("did you mean {near}?"),
                None => "`sins scene list` lists those that are built in".to_owned(),
            };
            return Err(Failure::of_file(path, &format!("no such scene; {hint}")));
        }
        let mut bytes = Vec::new();
        // A device may have no end.
        let most = MAX_TEXT as u64 + 1;
        let read = std::fs::File::open(path).and_then(|file| file.take(most).read_to_end(&mut bytes));
        read.map_err(|error| Failure::of_file(path, &format!("cannot be read: {error}")))?;
        let origin = path.display().to_string();
        Ok(Self { bytes, origin, path: Some(path.to_owned()), name: name_of(path) })
    }

    /// The scene that flies a log.
    fn for_log(path: &Path, text: &str) -> Self {
        let bytes = text.as_bytes().to_vec();
        Self { bytes, origin: path.display().to_string(), path: None, name: name_of(path) }
    }

    fn parse(&self, settings: &Settings) -> Result<Scene, Failure> {
        let pairs = settings.pairs()?;
        Scene::parse_with(&self.bytes, &pairs).map_err(|faults| self.failure(&faults, settings))
    }

    fn failure(&self, faults: &[Fault], settings: &Settings) -> Failure {
        let sentence = |fault: &Fault| match fault {
            Fault { line: 0, column, sentence } => {
                format!("{}: {sentence}", settings.words(*column))
            }
            Fault { line, column, sentence } => format!("{}:{line}:{column}: {sentence}", self.origin),
        };
        Failure::all(faults.iter().map(|fault| Failure::new(sentence(fault))).collect())
    }

    fn folder(&self) -> &Path {
        self.path.as_deref().and_then(Path::parent).unwrap_or(Path::new(""))
    }

    /// `failure`, with the line of the key that it is about.
    fn at(&self, section: &str, key: &str, failure: Failure) -> Failure {
        let Some(path) = &self.path else { return failure };
        let text = String::from_utf8_lossy(&self.bytes);
        match line_of(&text, section, key) {
            Some(line) => Failure::of_line(path, line, &failure),
            None => failure,
        }
    }
}

/// Reads the scene of the file `path`, or of that name, and nothing of its flight.
pub fn read_scene(name: &OsStr, settings: &Settings) -> Result<Scene, Failure> {
    Text::find(name)?.parse(settings)
}

/// The line of `key` of `[section]`, if the text has it in that form.
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

/// Number of samples, time between them, duration [s].
fn extent(scene: &Scene, motion: &Motion) -> Result<(usize, f64, f64), Failure> {
    match motion {
        Motion::Flight(_) => {
            let period_s = 1.0 / scene.rate_hz;
            let intervals = (scene.flown_s()? / period_s + ROUNDING).floor();
            Ok((intervals as usize + 1, period_s, intervals * period_s))
        }
        Motion::Log(path, log) => {
            let samples = log.samples();
            let wanted_s = scene.duration_s.unwrap_or(f64::INFINITY) * (1.0 + ROUNDING);
            let is_flown = |sample: &&FlightSample| sample.time_s - samples[0].time_s <= wanted_s;
            let count = samples.iter().take_while(is_flown).count();
            if count < 2 {
                let what = format!("flight.hours: the log has no second sample within {} s", rounded(wanted_s, 6));
                return Err(Failure::of_file(path, &what));
            }
            let duration_s = samples[count - 1].time_s - samples[0].time_s;
            Ok((count, duration_s / (count - 1) as f64, duration_s))
        }
    }
}

/// The scene in words: its own, or what its flight says of itself.
fn title(scene: &Scene, motion: &Motion) -> String {
    let own = scene.title.clone();
    match (motion, &scene.flight) {
        _ if !own.is_empty() => own,
        (Motion::Log(_, log), _) if log.title.is_empty() => "recorded flight".to_owned(),
        (Motion::Log(_, log), _) => log.title.clone(),
        (_, FlightSource::Builtin(name)) => {
            sins::scene::builtin(name).map_or_else(String::new, |scene| scene.title)
        }
        (_, FlightSource::Path(path)) => {
            format!("Flight of {} manoeuvres", path.manoeuvres.len() * path.repeat)
        }
        (_, FlightSource::Log(_)) => String::new(),
    }
}

/// Whether the name is one of a flight log.
pub fn is_log(name: &OsStr) -> bool {
    name == "-" || Path::new(name).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// What a file is called: without folder and ending.
fn name_of(path: &Path) -> String {
    match path.file_stem() {
        Some(stem) if path != Path::new("-") => stem.to_string_lossy().into_owned(),
        _ => "log".to_owned(),
    }
}

/// A device has no end, or waits for a keyboard.
fn is_device(path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        let is_one = |metadata: std::fs::Metadata| {
            metadata.file_type().is_char_device() || metadata.file_type().is_block_device()
        };
        std::fs::metadata(path).is_ok_and(is_one)
    }
    #[cfg(not(unix))]
    {
        let _ = path;
        false
    }
}

/// The log at `path`; "-": of standard input.
fn read_log(path: &Path) -> Result<FlightLog, Failure> {
    if is_device(path) {
        return Err(Failure::of_file(path, &"is a device: a log is a file or a pipe"));
    }
    let read = if path == Path::new("-") {
        let mut bytes = Vec::new();
        std::io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        std::fs::read(path)
    };
    let text = read.map_err(|error| Failure::of_file(path, &format!("cannot be read: {error}")))?;
    match FlightLog::parse(&text) {
        Ok(log) => Ok(log),
        Err(LogError::Fault(fault)) => Err(Failure::of_line(path, fault.line as u64, &fault.sentence)),
        Err(LogError::Memory(error)) => Err(Failure::of_file(path, &error)),
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
