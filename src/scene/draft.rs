//! A scene while it is read or written: plain numbers, texts and indices, one place for each key.

use nalgebra::Vector3;

use super::key::Section;
use super::{
    Failing, FlightPath, FlightSource, PlannedAction, PlannedFailure, PlannedUpdate, Scene, Temperature,
    Updated,
};
use crate::base::error::Error;
use crate::log::LogColumn;
use crate::sensors::{FailureFields, SensorOutput};
use crate::simulator::Options;
use crate::truth::flight::{FlightStart, Manoeuvre, ManoeuvreFields, Sinusoid};

/// A scene while it is read or written. A number that may be missing is NaN.
#[derive(Debug, Clone, PartialEq)]
pub struct Draft {
    pub scene: Scene,
    pub file: String,
    pub builtin: String,
    pub start: FlightStart,
    pub repeat: u64,
    pub duration_s: f64,
    pub temperature_c: f64,
    pub temperature_change_c_s: f64,
    pub closed_loop: bool,
    pub closed_loop_time_s: f64,
    pub sample_period_s: f64,
    pub every_s: f64,
    pub log_rate_hz: f64,
    pub log_missing: f64,
    pub imu_rate_hz: f64,
    pub imu_missing: f64,
    pub log_position_sigma_m: f64,
    pub log_attitude_sigma_rad: f64,
    /// The items of lists that are being read or written.
    pub manoeuvre: ManoeuvreFields,
    pub sinusoid: Sinusoid,
    pub failure: FailureDraft,
    pub update: PlannedUpdate,
    pub action: PlannedAction,
}

/// A failure of any kind.
#[derive(Debug, Clone, PartialEq)]
pub struct FailureDraft {
    pub sensor: usize,
    pub axis: usize,
    pub from_s: f64,
    pub until_s: f64,
    pub fields: FailureFields,
}

/// An update without its times.
pub const NO_UPDATE: PlannedUpdate = PlannedUpdate {
    updated: Updated::Position,
    at_s: f64::NAN,
    every_s: f64::NAN,
    sigma_n: Vector3::new(0.0, 0.0, 0.0),
};

impl Default for FailureDraft {
    fn default() -> Self {
        Self { sensor: 0, axis: 0, from_s: 0.0, until_s: f64::NAN, fields: FailureFields::default() }
    }
}

impl FailureDraft {
    pub fn output(&self) -> SensorOutput {
        SensorOutput::of_sensor(self.sensor, self.axis)
    }

    /// The planned failure, checked; `None` if it is switched off.
    pub fn to_planned(&self) -> Result<Option<PlannedFailure>, Error> {
        let Some(failure) = self.fields.kind() else { return Ok(None) };
        let until_s = if self.until_s.is_nan() { f64::INFINITY } else { self.until_s };
        PlannedFailure::new(self.output(), failure, self.from_s, until_s).map(Some)
    }
}

impl From<&PlannedFailure> for FailureDraft {
    fn from(planned: &PlannedFailure) -> Self {
        let (sensor, axis) = planned.output.parts();
        let Failing { from_s, until_s } = planned.failing;
        let until_s = if until_s.is_infinite() { f64::NAN } else { until_s };
        Self { sensor, axis, from_s, until_s, fields: (&planned.failure).into() }
    }
}

/// The planned update of a draft, checked: one without the time to the next is the only one.
pub fn planned_update(draft: &PlannedUpdate) -> Result<PlannedUpdate, Error> {
    let every_s = if draft.every_s.is_nan() { f64::INFINITY } else { draft.every_s };
    let planned = PlannedUpdate { every_s, ..*draft };
    planned.validate().map(|()| planned)
}

/// The draft of a planned update.
pub fn update_draft(planned: &PlannedUpdate) -> PlannedUpdate {
    let every_s = if planned.every_s.is_infinite() { f64::NAN } else { planned.every_s };
    PlannedUpdate { every_s, ..*planned }
}

impl From<&Scene> for Draft {
    fn from(scene: &Scene) -> Self {
        let (mut file, mut builtin, mut start, mut repeat) =
            (String::new(), String::new(), FlightStart::default(), 1);
        match &scene.flight {
            FlightSource::Log(name) => file.clone_from(name),
            FlightSource::Builtin(name) => builtin.clone_from(name),
            FlightSource::Path(path) => (start, repeat) = (path.start, path.repeat as u64),
        }
        Self {
            file,
            builtin,
            start,
            repeat,
            duration_s: scene.duration_s.unwrap_or(f64::NAN),
            temperature_c: scene.temperature.map_or(f64::NAN, |temperature| temperature.at_start_c),
            temperature_change_c_s: scene.temperature.map_or(0.0, |temperature| temperature.change_c_s),
            closed_loop: scene.options.closed_loop_time_s.is_some(),
            closed_loop_time_s: scene
                .options
                .closed_loop_time_s
                .unwrap_or(Options::DEFAULT_CLOSED_LOOP_TIME_S),
            sample_period_s: scene.options.intake.period_s.unwrap_or(f64::NAN),
            every_s: scene.output.every_s.unwrap_or(f64::NAN),
            log_rate_hz: scene.log.rate_hz.unwrap_or(f64::NAN),
            log_missing: scene.log.missing.unwrap_or(f64::NAN),
            imu_rate_hz: scene.imu.rate_hz.unwrap_or(f64::NAN),
            imu_missing: scene.imu.missing.unwrap_or(f64::NAN),
            log_position_sigma_m: scene.log.position_sigma_m.unwrap_or(f64::NAN),
            log_attitude_sigma_rad: scene.log.attitude_sigma_rad.unwrap_or(f64::NAN),
            manoeuvre: ManoeuvreFields::default(),
            sinusoid: Sinusoid::NONE,
            failure: FailureDraft::default(),
            update: NO_UPDATE,
            action: PlannedAction::default(),
            scene: scene.clone(),
        }
    }
}

impl Draft {
    /// The draft of the default scene. Not inlined: its stack is not needed while a scene is read.
    #[inline(never)]
    pub fn of_nothing() -> Box<Self> {
        Box::new(Self::from(&Scene::default()))
    }

    /// The columns of `[log]` or of `[imu]`.
    pub fn columns(&self, section: Section) -> &[LogColumn] {
        let Scene { log, imu, .. } = &self.scene;
        if section == Section::Imu { &imu.columns } else { &log.columns }
    }

    /// The same to be changed.
    pub fn columns_mut(&mut self, section: Section) -> &mut [LogColumn] {
        let Scene { log, imu, .. } = &mut self.scene;
        if section == Section::Imu { &mut imu.columns } else { &mut log.columns }
    }

    /// The options of the scene.
    pub fn options(&self) -> Options {
        let mut options = self.scene.options;
        options.closed_loop_time_s = self.closed_loop.then_some(self.closed_loop_time_s);
        options.intake.period_s = some(self.sample_period_s);
        options
    }

    /// The scene. Its flight is made of `manoeuvres` if it is neither a log nor a built-in flight.
    pub fn into_scene(mut self, manoeuvres: Vec<Manoeuvre>) -> Scene {
        let options = self.options();
        let mut scene = self.scene;
        scene.flight = if !self.file.is_empty() {
            FlightSource::Log(self.file)
        } else if !self.builtin.is_empty() {
            FlightSource::Builtin(self.builtin)
        } else {
            self.start.ellipsoid = scene.options.ellipsoid;
            FlightSource::Path(FlightPath { start: self.start, manoeuvres, repeat: self.repeat as usize })
        };
        scene.duration_s = some(self.duration_s);
        let change_c_s = self.temperature_change_c_s;
        scene.temperature = some(self.temperature_c).map(|at_start_c| Temperature { at_start_c, change_c_s });
        scene.options = options;
        scene.output.every_s = some(self.every_s);
        scene.log.rate_hz = some(self.log_rate_hz);
        scene.log.missing = some(self.log_missing);
        scene.imu.rate_hz = some(self.imu_rate_hz);
        scene.imu.missing = some(self.imu_missing);
        scene.log.position_sigma_m = some(self.log_position_sigma_m);
        scene.log.attitude_sigma_rad = some(self.log_attitude_sigma_rad);
        scene
    }
}

/// A number that may be missing.
fn some(number: f64) -> Option<f64> {
    (!number.is_nan()).then_some(number)
}
