//! `sins scene` and `sins keys`: scenes as texts.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use sins::scene::{BUILTIN_SCENES, FlightSource, KeyLine, builtin, keys, keys_text};

use crate::failure::Failure;
use crate::fly::{self, FOR_LOGS};
use crate::given::{Given, Json, Settings, Trust, is_log, read_scene};
use crate::output::Outputs;
use crate::rows::{self, number};
use crate::terminal::print;
use crate::units::{six_digits, time_text};

/// Lists, checks and writes scenes
#[derive(Debug, clap::Subcommand)]
pub enum Order {
    /// Lists the built-in scenes
    List,
    /// Reports every fault of scenes, the first of a flight log with its line, and what is doubtful in it, and summarizes those without
    /// faults. What shows only in flight, such as a mechanization at a pole, is reported by `sins fly`
    Check {
        /// Files SCENE.toml and LOG.csv, or built-in scenes
        #[arg(required = true, value_name = "SCENE")]
        scenes: Vec<OsString>,
        #[command(flatten)]
        settings: Settings,
        #[command(flatten)]
        trust: Trust,
        #[command(flatten)]
        json: Json,
    },
    /// Writes a scene in TOML: the keys that are set, each with its meaning and unit
    Write {
        /// A built-in scene, or a file SCENE.toml
        #[arg(value_name = "SCENE")]
        scene: OsString,
        #[command(flatten)]
        settings: Settings,
        /// Output file [default: standard output]
        #[arg(short, long, value_name = "FILE.toml")]
        output: Option<PathBuf>,
        /// Replaces an existing file
        #[arg(long)]
        force: bool,
    },
}

pub fn run(order: &Order) -> Result<(), Failure> {
    match order {
        Order::List => list(),
        Order::Check { scenes, settings, trust, json } => {
            check(scenes, settings, &Trust { json: json.is_wanted, ..*trust })
        }
        Order::Write { scene, settings, output, force } => {
            if is_log(scene) {
                let what = format!("{}: is a flight log, not a scene", scene.display());
                return Err(Failure::new(what));
            }
            let mut scene_in = read_scene(scene, settings)?;
            let folder = |path: &Path| path.parent().map(Path::to_owned).unwrap_or_default();
            if let (FlightSource::Log(file), Some(path)) = (&mut scene_in.flight, output)
                && Path::new(file.as_str()).is_relative()
                && folder(path) != folder(Path::new(scene))
            {
                // The name of a log is relative to the scene.
                let log = folder(Path::new(scene)).join(file.as_str());
                *file = std::path::absolute(&log).unwrap_or(log).to_string_lossy().into_owned();
            }
            let text = scene_in.write();
            match output {
                // Users edit scenes, so an existing scene is replaced only with --force.
                Some(path) => Outputs::new(&[PathBuf::from(scene)], *force).write(path, "", &text),
                None => print(&text),
            }
        }
    }
}

fn list() -> Result<(), Failure> {
    let line = |(name, _): &(&str, &str)| {
        let title = builtin(name).map_or_else(String::new, |scene| scene.title);
        format!("{name:<14} {title}\n")
    };
    print(&BUILTIN_SCENES.iter().map(line).collect::<String>())
}

/// Checks every scene, also after a scene with faults.
fn check(scenes: &[OsString], settings: &Settings, trust: &Trust) -> Result<(), Failure> {
    let (mut good, mut bad) = (String::new(), Vec::new());
    for name in scenes {
        let loaded = Given::load(Some(name), None, settings, trust, FOR_LOGS);
        match loaded.and_then(|given| fly::check(&given).map(|()| given)) {
            Ok(given) => {
                let (duration, rate_hz) = (time_text(given.duration_s), six_digits(1.0 / given.period_s));
                let title = given.title.trim_end_matches('.');
                let gaps = given.gaps_text().map_or_else(String::new, |gaps| format!("; gaps: {gaps}"));
                good += &format!("{}: {title}, {duration} at {rate_hz} Hz{gaps}\n", given.origin);
            }
            Err(failure) => bad.push(failure),
        }
    }
    if !trust.json {
        print(&good)?;
    }
    if bad.is_empty() { Ok(()) } else { Err(Failure::all(bad)) }
}

/// Prints the output of `sins keys`.
pub fn print_keys() -> Result<(), Failure> {
    let head = "\
A scene is a text in TOML: sections, [section], with lines key = value; # begins a comment. The list has for each key its meaning,
its values, its unit, and the name of the same key in SI units. `sins fly SCENE --set section.key=value` sets a key in addition
to the text. A preset is applied first, wherever it stands; other keys then change single errors.

";
    print(&format!("{head}{}", keys_text()))
}

/// The sections whose name begins with `word`; without one, the keys whose name contains it, below their sections.
pub fn print_keys_of(word: &str) -> Result<(), Failure> {
    let text = keys_text();
    let name = |section: &str| section.trim_start_matches('[').starts_with(word);
    let mut found: Vec<String> = text
        .split("\n\n")
        .filter(|section| name(section))
        .map(|section| section.trim_end().to_owned())
        .collect();
    if found.is_empty() {
        found = text.split("\n\n").filter_map(|section| keys_with(section, word)).collect();
    }
    if found.is_empty() {
        return Err(Failure::new(format!("{word}: no section begins with it, and no key contains it")));
    }
    print(&(found.join("\n\n") + "\n"))
}

/// The head of a section, and its keys whose name contains `word`.
fn keys_with(section: &str, word: &str) -> Option<String> {
    let (head, keys) = section.split_once('\n')?;
    let has = |line: &&str| line.split(':').next().is_some_and(|name| name.contains(word));
    let keys: Vec<&str> = keys.lines().filter(has).collect();
    (!keys.is_empty()).then(|| format!("{head}\n{}", keys.join("\n")))
}

/// Columns of `sins keys --fields`.
const FIELDS: [&str; 12] = [
    "section",
    "key",
    "takes",
    "unit",
    "minimum",
    "maximum",
    "zero_is_off",
    "default",
    "si_key",
    "si_unit",
    "si_per_unit",
    "condition",
];

/// Prints the output of `sins keys --fields`.
pub fn print_key_fields() -> Result<(), Failure> {
    let row = |key: KeyLine| {
        let limit = |end: Option<f64>| end.map_or_else(String::new, number);
        vec![
            key.section.to_owned(),
            key.name.to_owned(),
            key.takes,
            key.unit.to_owned(),
            limit(key.limits.map(|limits| limits.low)),
            limit(key.limits.map(|limits| limits.high)),
            key.limits.is_some_and(|limits| limits.zero_is_off).to_string(),
            key.default,
            key.si_name.unwrap_or_default().to_owned(),
            key.si_unit.to_owned(),
            number(key.unit_si),
            key.condition,
        ]
    };
    print(&rows::text(&FIELDS, keys().into_iter().map(row))?)
}
