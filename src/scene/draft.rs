//! A scene while it is read or written: plain numbers, texts and indices, one place for each key.

use nalgebra::Vector3;

use super::{
    Failing, FlightPath, FlightSource, PlannedAction, PlannedFailure, PlannedUpdate, Scene, Temperature,
    Updated,
};
use crate::Options;
use crate::error::Error;
use crate::flight::{Channel, FlightStart, Manoeuvre, ManoeuvreFields, Sinusoid};
use crate::sensors::{Axis, FAILURE_KIND_COUNT, Failure, FailureFields, SensorOutput};

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
    /// The items of lists that are being read or written.
    pub manoeuvre: ManoeuvreFields,
    pub sinusoid: SinusoidDraft,
    pub failure: FailureDraft,
    pub update: UpdateDraft,
    pub action: PlannedAction,
}

/// A sinusoid of any channel.
#[derive(Debug, Clone, PartialEq)]
pub struct SinusoidDraft {
    pub channel: Channel,
    pub amplitude_rad: f64,
    pub amplitude_m_s: f64,
    pub frequency_hz: f64,
    pub phase_rad: f64,
}

/// A failure of any kind.
#[derive(Debug, Clone, PartialEq)]
pub struct FailureDraft {
    pub sensor: usize,
    pub axis: usize,
    pub kind: usize,
    pub from_s: f64,
    pub until_s: f64,
    pub size: f64,
    pub density: f64,
    pub interval_s: f64,
    pub duration_s: f64,
    pub probability: f64,
}

/// An update of any kind.
#[derive(Debug, Clone, PartialEq)]
pub struct UpdateDraft {
    pub updated: Updated,
    pub at_s: f64,
    pub every_s: f64,
    pub sigma_m: Vector3<f64>,
    pub sigma_m_s: Vector3<f64>,
}

/// Time constant of the closed loop if the scene does not state it [s].
pub const DEFAULT_CLOSED_LOOP_TIME_S: f64 = 30.0;

/// The kinds of failures, and the quantities that each of them uses. Drop-outs use one of the two.
pub const FAILURE_KINDS: [(&str, &[&str]); FAILURE_KIND_COUNT] = [
    ("none", &["size", "density", "interval_s", "duration_s", "probability"]),
    ("stuck", &[]),
    ("dead", &[]),
    ("bias_step", &["size"]),
    ("spikes", &["size", "interval_s", "duration_s"]),
    ("noise", &["density"]),
    ("drop_outs", &["interval_s", "probability"]),
];

impl Default for SinusoidDraft {
    fn default() -> Self {
        Self {
            channel: Channel::Course,
            amplitude_rad: 0.0,
            amplitude_m_s: 0.0,
            frequency_hz: 0.0,
            phase_rad: 0.0,
        }
    }
}

impl SinusoidDraft {
    pub fn to_sinusoid(&self) -> Sinusoid {
        let amplitude = if self.channel == Channel::Speed { self.amplitude_m_s } else { self.amplitude_rad };
        Sinusoid {
            channel: self.channel,
            amplitude,
            frequency_hz: self.frequency_hz,
            phase_rad: self.phase_rad,
        }
    }
}

impl From<&Sinusoid> for SinusoidDraft {
    fn from(sinusoid: &Sinusoid) -> Self {
        let Sinusoid { channel, amplitude, frequency_hz, phase_rad } = *sinusoid;
        let is_speed = channel == Channel::Speed;
        Self {
            channel,
            amplitude_rad: if is_speed { 0.0 } else { amplitude },
            amplitude_m_s: if is_speed { amplitude } else { 0.0 },
            frequency_hz,
            phase_rad,
        }
    }
}

impl Default for FailureDraft {
    fn default() -> Self {
        Self {
            sensor: 0,
            axis: 0,
            kind: 0,
            from_s: 0.0,
            until_s: f64::NAN,
            size: 0.0,
            density: 0.0,
            interval_s: 0.0,
            duration_s: 0.0,
            probability: 0.0,
        }
    }
}

impl FailureDraft {
    pub fn output(&self) -> SensorOutput {
        let axis = [Axis::X, Axis::Y, Axis::Z][self.axis];
        match self.sensor {
            0 => SensorOutput::Gyro(axis),
            1 => SensorOutput::Accelerometer(axis),
            _ => SensorOutput::Altimeter,
        }
    }

    /// The failure; `None` if it is switched off.
    pub fn to_failure(&self) -> Option<Failure> {
        let Self { kind, size, density, interval_s, duration_s, probability, .. } = *self;
        FailureFields { kind, size, density, interval_s, duration_s, probability }.to_failure()
    }

    /// The planned failure, checked; `None` if it is switched off.
    pub fn to_planned(&self) -> Result<Option<PlannedFailure>, Error> {
        let Some(failure) = self.to_failure() else { return Ok(None) };
        let until_s = if self.until_s.is_nan() { f64::INFINITY } else { self.until_s };
        PlannedFailure::new(self.output(), failure, self.from_s, until_s).map(Some)
    }
}

impl From<&PlannedFailure> for FailureDraft {
    fn from(planned: &PlannedFailure) -> Self {
        let (sensor, axis) = match planned.output {
            SensorOutput::Gyro(axis) => (0, axis as usize),
            SensorOutput::Accelerometer(axis) => (1, axis as usize),
            SensorOutput::Altimeter => (2, 0),
        };
        let Failing { from_s, until_s } = planned.failing;
        let until_s = if until_s.is_infinite() { f64::NAN } else { until_s };
        let FailureFields { kind, size, density, interval_s, duration_s, probability } =
            Some(planned.failure).into();
        Self { sensor, axis, kind, from_s, until_s, size, density, interval_s, duration_s, probability }
    }
}

impl Default for UpdateDraft {
    fn default() -> Self {
        Self {
            updated: Updated::Position,
            at_s: f64::NAN,
            every_s: f64::NAN,
            sigma_m: Vector3::zeros(),
            sigma_m_s: Vector3::zeros(),
        }
    }
}

impl UpdateDraft {
    /// The planned update, checked.
    pub fn to_planned(&self) -> Result<PlannedUpdate, Error> {
        let Self { updated, at_s, every_s, sigma_m, sigma_m_s } = *self;
        let every_s = if every_s.is_nan() { f64::INFINITY } else { every_s };
        let sigma_n = if updated == Updated::Velocity { sigma_m_s } else { sigma_m };
        let planned = PlannedUpdate { updated, at_s, every_s, sigma_n };
        planned.validate().map(|()| planned)
    }
}

impl From<&PlannedUpdate> for UpdateDraft {
    fn from(planned: &PlannedUpdate) -> Self {
        let PlannedUpdate { updated, at_s, every_s, sigma_n } = *planned;
        let every_s = if every_s.is_infinite() { f64::NAN } else { every_s };
        let none = Self { updated, at_s, every_s, ..Self::default() };
        match updated {
            Updated::Velocity => Self { sigma_m_s: sigma_n, ..none },
            _ => Self { sigma_m: sigma_n, ..none },
        }
    }
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
            closed_loop_time_s: scene.options.closed_loop_time_s.unwrap_or(DEFAULT_CLOSED_LOOP_TIME_S),
            sample_period_s: scene.options.intake.period_s.unwrap_or(f64::NAN),
            every_s: scene.output.every_s.unwrap_or(f64::NAN),
            manoeuvre: ManoeuvreFields::default(),
            sinusoid: SinusoidDraft::default(),
            failure: FailureDraft::default(),
            update: UpdateDraft::default(),
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
        scene
    }
}

/// A number that may be missing.
fn some(number: f64) -> Option<f64> {
    (!number.is_nan()).then_some(number)
}
