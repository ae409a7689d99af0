//! Scenes that every host flies to the same end: those of `c_examples/scenes`, the built-in ones, and random ones.
#![allow(dead_code, unused_imports)] // each program uses a part of it

mod end;
mod logs;
mod named;
mod random;

pub use end::{End, end_of, line};
pub use named::named_scenes;
pub use random::{Coverage, random_scene};

use std::path::Path;
use std::sync::Arc;

use super::draws;

use sins::log::FlightLog;
use sins::scene::{Play, Scene, Source};

/// A scene as text. If its flight is a log, the scene names the file NAME.csv.
#[derive(Debug, Clone)]
pub struct FlownScene {
    pub name: String,
    pub text: String,
    /// The text of its log.
    pub log: Option<String>,
}

impl FlownScene {
    pub fn scene(&self) -> Scene {
        let faults = |faults| panic!("{}: {faults:?}\n{}", self.name, self.text);
        Scene::parse(self.text.as_bytes()).unwrap_or_else(faults)
    }

    /// Its samples.
    pub fn source(&self, scene: &Scene) -> Source {
        match &self.log {
            Some(log) => Source::Log(Arc::new(self.parsed(scene, log))),
            None => Source::flight_of(scene).unwrap(),
        }
    }

    fn parsed(&self, scene: &Scene, log: &str) -> FlightLog {
        let fault =
            |error| panic!("{}: {error:?}\n{}\n{}", self.name, self.text, &log[..log.len().min(1000)]);
        scene.read_log(log.as_bytes()).unwrap_or_else(fault)
    }

    pub fn play(&self) -> Play {
        let scene = self.scene();
        let source = self.source(&scene);
        Play::new(Arc::new(scene), source).unwrap()
    }

    /// Writes its files into a folder.
    pub fn write(&self, folder: &Path) {
        std::fs::write(folder.join(format!("{}.toml", self.name)), &self.text).unwrap();
        if let Some(log) = &self.log {
            std::fs::write(folder.join(format!("{}.csv", self.name)), log).unwrap();
        }
    }
}
