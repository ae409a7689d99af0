//! Settings of a scene on the command line.

use std::path::PathBuf;

use sins::log::LogMapping;
use sins::scene::{NO_FLIGHT, Scene};

use super::{read_scene, read_text};
use crate::failure::Failure;

/// Settings in addition to the text of a scene.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Settings {
    /// Grade of gyros and accelerometers, and of the errors of the start: ideal, strategic, navigation, tactical, industrial, consumer or
    /// paper2; --set then changes single errors
    #[arg(long, value_name = "GRADE")]
    pub preset: Option<String>,
    /// Sets a key of the scene, such as gyro.bias_deg_h=0.01; `sins keys` lists all keys. Can be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Reads the log by the [log] of this file, which names the column of each quantity. A file is then a log, unless its name ends in
    /// .toml or is that of a built-in scene
    #[arg(long, value_name = "FILE.toml")]
    pub columns: Option<PathBuf>,
    /// `--hours` of the commands that have it: another `flight.hours`.
    #[arg(skip)]
    pub hours: Option<String>,
}

/// The keys that `--preset` sets.
const PRESETS: [&str; 3] = ["gyro.preset", "accelerometer.preset", "start.preset"];

impl Settings {
    /// Keys and values, in the order of [`Self::argument`].
    pub fn pairs(&self) -> Result<Vec<(&str, &str)>, Failure> {
        let presets = self.preset.iter().flat_map(|grade| PRESETS.map(|key| (key, grade.as_str())));
        let set = self.set.iter().map(|text| {
            let expected = || {
                Failure::new(format!("--set {text}: expected KEY=VALUE, for example gyro.bias_deg_h=0.01"))
            };
            text.split_once('=').map(|(key, value)| (key.trim(), value.trim())).ok_or_else(expected)
        });
        let hours = self.hours.iter().map(|hours| Ok(("flight.hours", hours.as_str())));
        presets.map(Ok).chain(set).chain(hours).collect()
    }

    /// The mapping of the file that the command line names, with what it sets of `log` in addition.
    pub fn mapping(&self) -> Result<Option<Box<LogMapping>>, Failure> {
        Ok(self.mappings()?.map(|scene| scene.log))
    }

    /// `[log]` and `[imu]` of that file.
    pub fn mappings(&self) -> Result<Option<Scene>, Failure> {
        let Some(path) = &self.columns else { return Ok(None) };
        // The file need not have a flight.
        let text = read_text(path)?;
        let faults = Scene::parse(&text).err().unwrap_or_default();
        let has_no_flight = faults.iter().any(|fault| fault.sentence == NO_FLIGHT);
        let flight = has_no_flight.then(|| "flight.file=log.csv".to_owned());
        let is_of_table = |text: &str| ["log.", "imu."].iter().any(|section| text.starts_with(section));
        let of_tables = self.set.iter().filter(|text| is_of_table(text.trim_start())).cloned();
        let set = flight.into_iter().chain(of_tables).collect();
        read_scene(path.as_os_str(), &Self { set, ..Self::default() }).map(Some)
    }

    /// The argument of setting `number`, counted from 1.
    pub fn argument(&self, number: usize) -> String {
        let presets = self.preset.iter().flat_map(|grade| PRESETS.map(|_| format!("--preset {grade}")));
        let set = self.set.iter().map(|text| format!("--set {text}"));
        let hours = self.hours.iter().map(|hours| format!("--hours {hours}"));
        presets.chain(set).chain(hours).nth(number.saturating_sub(1)).unwrap_or_default()
    }

    /// Whether the command line sets `key`.
    pub fn has(&self, key: &str) -> bool {
        let is_set =
            self.set.iter().any(|text| text.split('=').next().is_some_and(|name| name.trim() == key));
        is_set || key == "flight.hours" && self.hours.is_some()
    }
}
