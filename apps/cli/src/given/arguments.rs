//! The arguments of a command that flies one scene.

use std::ffi::OsString;
use std::path::PathBuf;

use super::{Given, Json, Settings, Trust};
use crate::failure::Failure;

/// The scene to fly.
#[derive(Debug, clap::Args)]
pub struct SceneArguments {
    /// A built-in scene (`sins scene list`), a file SCENE.toml, or a flight log LOG.csv, also in IGC, GPX or FDR ("-": standard input)
    #[arg(value_name = "SCENE")]
    scene: Option<OsString>,
    /// Flies this flight log instead of the scene's own flight
    #[arg(long, value_name = "LOG.csv")]
    log: Option<PathBuf>,
    #[command(flatten)]
    settings: Settings,
    #[command(flatten)]
    trust: Trust,
}

/// How long to fly the scene.
#[derive(Debug, clap::Args)]
pub struct Hours {
    /// How long to fly, in place of what the scene sets (flight.hours)
    #[arg(long, value_name = "HOURS")]
    hours: Option<String>,
}

impl SceneArguments {
    /// [`Self::load`], flown for `hours`.
    pub fn load_for(&self, hours: &Hours, for_logs: &str) -> Result<Given, Failure> {
        self.load_judged(hours, Json { is_wanted: false }, for_logs)
    }

    /// [`Self::load_for`], with what is found in its log printed in JSON, if that is wanted.
    pub fn load_judged(&self, hours: &Hours, json: Json, for_logs: &str) -> Result<Given, Failure> {
        let settings = Settings { hours: hours.hours.clone(), ..self.settings.clone() };
        let trust = Trust { json: json.is_wanted, ..self.trust };
        Given::load(self.scene.as_deref(), self.log.as_deref(), &settings, &trust, for_logs)
    }

    /// The scene; a log without a scene is flown by the simulator of the scene in the text `for_logs`.
    pub fn load(&self, for_logs: &str) -> Result<Given, Failure> {
        Given::load(self.scene.as_deref(), self.log.as_deref(), &self.settings, &self.trust, for_logs)
    }
}
