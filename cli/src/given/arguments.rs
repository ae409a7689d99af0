//! The arguments of a command that flies one scene.

use std::ffi::OsString;
use std::path::PathBuf;

use super::{Given, Settings, Trust};
use crate::failure::Failure;

/// The scene to fly.
#[derive(Debug, clap::Args)]
pub struct SceneArguments {
    /// A built-in scene (`sins scene list`), a file SCENE.toml, or a flight log LOG.csv ("-": standard input)
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

impl SceneArguments {
    /// The scene; a log without a scene is flown by the simulator of the scene in the text `for_logs`.
    pub fn load(&self, for_logs: &str) -> Result<Given, Failure> {
        Given::load(self.scene.as_deref(), self.log.as_deref(), &self.settings, &self.trust, for_logs)
    }
}
