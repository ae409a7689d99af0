//! Scenes: a flight, the simulator that flies it, the failures and updates on the way, and the unit, as a text in TOML.
//!
//! [`Scene::parse`] reads a scene, and reports every fault of a text at once. [`Scene::write`] writes a text that reads
//! back as the same scene to the bit. [`Scene::parse_with`] sets single keys in addition to the text; [`Scene::value`],
//! [`Scene::set`] and [`Scene::set_items`] read and change a scene key by key. The keys of a scene, with unit and meaning, are one
//! table (`table`); reading, writing and the list of keys ([`keys`]) use it.

mod builtin;
mod change;
mod check;
mod column;
mod draft;
mod examine;
mod fault;
mod key;
mod limits;
mod list;
mod panel;
mod play;
mod read;
mod reader;
mod samples;
mod schedule;
mod setting;
mod site;
mod table;
mod update;
mod value;
mod write;
mod written;

pub(crate) use crate::base::text::MAX_TEXT_VALUE;
pub use crate::base::text::{About, Fault, excerpt, listed, nearest, text_in_quotes};
pub use builtin::{BUILTIN_SCENES, builtin};
pub use examine::NO_FLIGHT;
pub use fault::MAX_FAULTS;
pub use limits::Limits;
pub(crate) use list::key_line;
pub use list::{KeyKind, KeyLine, key_of_field, keys, keys_text};
pub use panel::{Action, PlannedAction, UnitPlan};
pub(crate) use play::shown;
pub use play::{Itinerary, Play, Shown, Source, Spacing, Stopped};
pub(crate) use read::utf8;
pub use samples::Samples;
pub use schedule::FliesScene;
pub use update::{PlannedUpdate, Updated};
pub use write::ChangedKey;

use crate::log::LogMapping;

use crate::base::error::{Error, Rule, check_integer};
use crate::base::memory::room;
use crate::sensors::{Failure, SensorOutput};
use crate::simulator::{BudgetEffect, ErrorParameters, Options, Simulator};
use crate::truth::flight::{Flight, FlightStart, MAX_MANOEUVRES, Manoeuvre};

/// Largest size of a scene's text [bytes].
pub const MAX_TEXT: usize = 1 << 20;

/// A scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Title: the scene in a few words; empty: none.
    pub title: String,
    /// The true motion.
    pub flight: FlightSource,
    /// How the table of its log is read.
    pub log: Box<LogMapping>,
    /// How a record of an IMU is read, by a program that identifies its sensors; the flight does not need it.
    pub imu: Box<LogMapping>,
    /// How long to fly [s]; `None`: the whole flight.
    pub duration_s: Option<f64>,
    /// Sample rate of a built-in or composed flight [Hz]; a log has its own time stamps.
    pub rate_hz: f64,
    /// Temperature of the sensors; `None`: samples have none but those of a log.
    pub temperature: Option<Temperature>,
    /// The simulator. The stated period of a flight that is not a log follows from its rate.
    pub options: Options,
    /// All that makes the INS err, but for failures.
    pub errors: ErrorParameters,
    /// Failures of sensors; those of one output do not overlap in time.
    pub failures: Vec<PlannedFailure>,
    /// Updates of the position and of the velocity.
    pub updates: Vec<PlannedUpdate>,
    /// The unit.
    pub unit: UnitPlan,
    /// What is done at its panel.
    pub panel: Vec<PlannedAction>,
    /// What a program that flies the scene writes.
    pub output: Output,
}

/// Where the true motion comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum FlightSource {
    /// A flight log, by its path as seen from the scene's own folder.
    Log(String),
    /// The flight of a built-in scene, by its name.
    Builtin(String),
    /// A flight that is composed of manoeuvres.
    Path(FlightPath),
}

/// A start and the manoeuvres from there on.
#[derive(Debug, Clone, PartialEq)]
pub struct FlightPath {
    /// Where the flight begins.
    pub start: FlightStart,
    /// The manoeuvres, flown one after the other.
    pub manoeuvres: Vec<Manoeuvre>,
    /// How many times all of them are flown.
    pub repeat: usize,
}

/// Temperature of the sensors: a straight line over the time of the flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Temperature {
    /// At the start [°C].
    pub at_start_c: f64,
    /// Rate of change [°C/s].
    pub change_c_s: f64,
}

/// A failure and its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlannedFailure {
    /// The output that fails.
    pub output: SensorOutput,
    /// Its time.
    pub failing: Failing,
    /// Its kind, with the quantities of this kind.
    pub failure: Failure,
}

/// A span of time since the start of the flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Failing {
    /// Its start [s].
    pub from_s: f64,
    /// Its end [s]; infinite: the end of the flight.
    pub until_s: f64,
}

/// What a program that flies the scene writes; the library itself writes nothing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Output {
    /// Folder of the files; empty: the program's choice.
    pub folder: String,
    /// Base name of the files; empty: that of the scene.
    pub name: String,
    /// File of the measured increments; empty: none.
    pub imu: String,
    /// Spacing of the records [s]; `None`: the program's choice.
    pub every_s: Option<f64>,
    /// Whether the program shows neither progress nor summary.
    pub quiet: bool,
}

impl Default for Scene {
    /// The recommended simulator with ideal sensors, at rest for an hour at latitude 0, longitude 0, height 0.
    fn default() -> Self {
        let rest = Manoeuvre::Rest { duration_s: 3600.0 };
        let start = FlightStart::default();
        Self {
            title: String::new(),
            flight: FlightSource::Path(FlightPath { start, manoeuvres: vec![rest], repeat: 1 }),
            log: Box::default(),
            imu: Box::new(LogMapping::of_imu()),
            duration_s: None,
            rate_hz: 100.0,
            temperature: None,
            options: Options::default(),
            errors: ErrorParameters::default(),
            failures: Vec::new(),
            updates: Vec::new(),
            unit: UnitPlan::default(),
            panel: Vec::new(),
            output: Output::default(),
        }
    }
}

impl FlightPath {
    /// The trajectory.
    pub fn flight(&self) -> Result<Flight, Error> {
        Flight::new(&self.start, &self.all()?).map_err(|error| self.of_manoeuvre(error))
    }

    /// Its length [s], without making it.
    pub fn length_s(&self) -> Result<f64, Error> {
        Flight::length_s(&self.start, &self.all()?).map_err(|error| self.of_manoeuvre(error))
    }

    /// `error` with the place of its manoeuvre among [`Self::manoeuvres`], whichever time that is flown.
    fn of_manoeuvre(&self, error: Error) -> Error {
        Error { index: error.index.map(|index| index % self.manoeuvres.len().max(1)), ..error }
    }

    /// Checks how many times the manoeuvres are flown, as the field `repeat`.
    pub(crate) fn check_repeat(&self, repeat: &'static str) -> Result<(), Error> {
        let most = (MAX_MANOEUVRES / self.manoeuvres.len().max(1)).max(1);
        check_integer(repeat, self.repeat, 1, most as u64)
    }

    fn all(&self) -> Result<Vec<Manoeuvre>, Error> {
        self.check_repeat("flight.repeat")?;
        let mut manoeuvres = room(self.manoeuvres.len() * self.repeat)?;
        for _ in 0..self.repeat {
            manoeuvres.extend_from_slice(&self.manoeuvres);
        }
        Ok(manoeuvres)
    }
}

impl Scene {
    /// Whether the flight is a log.
    pub fn is_log(&self) -> bool {
        matches!(self.flight, FlightSource::Log(_))
    }

    /// The manoeuvres of the scene itself.
    pub(crate) fn manoeuvres(&self) -> &[Manoeuvre] {
        match &self.flight {
            FlightSource::Path(path) => &path.manoeuvres,
            FlightSource::Log(_) | FlightSource::Builtin(_) => &[],
        }
    }

    /// Whether two runs of the scene differ.
    pub fn is_random(&self) -> bool {
        let has_failure = self.failures.iter().any(|planned| planned.failure.is_random());
        let has_fix = self.updates.iter().any(|planned| planned.sigma_n.iter().any(|sigma| *sigma > 0.0));
        has_failure || has_fix || BudgetEffect::set_in(&self.errors).any(|effect| effect.is_random)
    }

    /// Number of items in its lists.
    pub(crate) fn items(&self) -> usize {
        self.manoeuvres().len() + self.failures.len() + self.updates.len() + self.panel.len()
    }

    /// The options of the simulator: those of the scene, and, if the flight is not a log, the period of its sample rate.
    pub fn simulator_options(&self) -> Options {
        let mut options = self.options;
        if !self.is_log() {
            options.intake.period_s = Some(1.0 / self.rate_hz);
        }
        options
    }

    /// The simulator of the scene. It has no failure yet: [`Self::prepare`] sets failures at their times.
    pub fn simulator(&self) -> Result<Box<[Simulator; 1]>, Error> {
        self.errors.simulator(&self.simulator_options())
    }

    /// The flight, on the scene's ellipsoid. A log has no such flight.
    pub fn flight(&self) -> Result<Flight, Error> {
        self.path()?.flight()
    }

    /// The start and the manoeuvres of the flight, also of a built-in flight.
    pub(crate) fn path(&self) -> Result<FlightPath, Error> {
        let mut path = match &self.flight {
            FlightSource::Path(path) => path.clone(),
            // A built-in scene may fly the flight of another one.
            FlightSource::Builtin(name) => match builtin(name) {
                Some(scene) => scene.path()?,
                None => return Err(Error::bad_state("the scene names no built-in flight")),
            },
            FlightSource::Log(_) => {
                return Err(Error::bad_state("the flight of the scene is a log; read the log"));
            }
        };
        path.start.ellipsoid = self.options.ellipsoid;
        Ok(path)
    }

    /// How long the flight is flown [s]: the duration that the scene sets, which must not exceed the flight; else that of the
    /// built-in scene; else the whole flight.
    pub fn flown_s(&self) -> Result<f64, Error> {
        let flight_s = self.path()?.length_s()?;
        let of_builtin = || match &self.flight {
            FlightSource::Builtin(name) => builtin(name).and_then(|scene| scene.duration_s),
            _ => None,
        };
        match self.duration_s.or_else(of_builtin) {
            // The durations may differ by the rounding of a program's arithmetic.
            Some(wanted_s) if wanted_s > flight_s * (1.0 + 1e-9) => {
                let rule = Rule::AtMost("must be at most the duration of the flight:", flight_s.into());
                Err(Error::invalid("flight.duration_s", wanted_s, rule))
            }
            Some(wanted_s) => Ok(wanted_s.min(flight_s)),
            None => Ok(flight_s),
        }
    }
}
