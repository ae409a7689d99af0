//! A scene while it is read or written: plain numbers, texts and indices, one place for each key.

use super::{Failing, FlightPath, FlightSource, PlannedFailure, Scene, Temperature};
use crate::error::{Error, Rule};
use crate::flight::{Channel, FlightStart, MAX_SINUSOIDS, Manoeuvre, Sinusoid};
use crate::sensors::{Axis, Failure, SensorOutput};

/// A scene in the making. A number that may be missing is NaN.
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
    pub manoeuvre: ManoeuvreDraft,
    pub sinusoid: SinusoidDraft,
    pub failure: FailureDraft,
}

/// A manoeuvre of any kind.
#[derive(Debug, Clone, PartialEq)]
pub struct ManoeuvreDraft {
    pub kind: usize,
    pub duration_s: f64,
    pub ramp_s: f64,
    pub speed_change_m_s: f64,
    pub height_change_m: f64,
    pub heading_change_rad: f64,
    pub bank_rad: f64,
    pub turns: f64,
    pub sinusoids: Vec<Sinusoid>,
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

/// Time in which a manoeuvre sets in where the scene does not say [s].
const DEFAULT_RAMP_S: f64 = 5.0;

/// Time constant of the closed loop where the scene does not say [s].
pub const DEFAULT_CLOSED_LOOP_TIME_S: f64 = 30.0;

/// The kinds of manoeuvres, and the keys that each of them uses.
pub const KINDS: [(&str, &[&str]); 9] = [
    ("rest", &["duration_s"]),
    ("straight", &["duration_s"]),
    ("accelerate", &["duration_s", "speed_change_m_s"]),
    ("climb", &["duration_s", "ramp_s", "height_change_m"]),
    ("turn", &["ramp_s", "heading_change_deg", "bank_deg"]),
    ("roll", &["duration_s", "turns"]),
    ("loop", &["duration_s", "ramp_s", "turns"]),
    ("s_turn", &["duration_s", "ramp_s", "heading_change_deg", "turns"]),
    ("sinusoids", &["duration_s", "ramp_s"]),
];

/// The kinds of failures, and the quantities that each of them uses. Drop-outs use one of the two.
pub const FAILURE_KINDS: [(&str, &[&str]); 7] = [
    ("none", &["size", "density", "interval_s", "duration_s", "probability"]),
    ("stuck", &[]),
    ("dead", &[]),
    ("bias_step", &["size"]),
    ("spikes", &["size", "interval_s", "duration_s"]),
    ("noise", &["density"]),
    ("drop_outs", &["interval_s", "probability"]),
];

impl Default for ManoeuvreDraft {
    fn default() -> Self {
        Self {
            kind: 0,
            duration_s: 0.0,
            ramp_s: DEFAULT_RAMP_S,
            speed_change_m_s: 0.0,
            height_change_m: 0.0,
            heading_change_rad: 0.0,
            bank_rad: 0.0,
            turns: 0.0,
            sinusoids: Vec::new(),
        }
    }
}

impl ManoeuvreDraft {
    /// The manoeuvre; of a field that its kind does not use, nothing is asked.
    pub fn to_manoeuvre(&self) -> Manoeuvre {
        let Self { duration_s, ramp_s, speed_change_m_s, height_change_m, turns, bank_rad, .. } = *self;
        let heading_change_rad = self.heading_change_rad;
        match self.kind {
            0 => Manoeuvre::Rest { duration_s },
            1 => Manoeuvre::Straight { duration_s },
            2 => Manoeuvre::Accelerate { duration_s, speed_change_m_s },
            3 => Manoeuvre::Climb { duration_s, height_change_m, ramp_s },
            4 => Manoeuvre::Turn { heading_change_rad, bank_rad, ramp_s },
            5 => Manoeuvre::Roll { duration_s, turns },
            6 => Manoeuvre::Loop { duration_s, turns, ramp_s },
            7 => Manoeuvre::STurn {
                duration_s,
                heading_amplitude_rad: heading_change_rad,
                cycles: turns,
                ramp_s,
            },
            _ => {
                let none = SinusoidDraft::default().to_sinusoid();
                let mut terms = [none; MAX_SINUSOIDS];
                terms.iter_mut().zip(&self.sinusoids).for_each(|(term, sinusoid)| *term = *sinusoid);
                Manoeuvre::Sinusoids { duration_s, ramp_s, terms, count: self.sinusoids.len() }
            }
        }
    }
}

impl From<&Manoeuvre> for ManoeuvreDraft {
    fn from(manoeuvre: &Manoeuvre) -> Self {
        let mut draft = Self::default();
        match *manoeuvre {
            Manoeuvre::Rest { duration_s } => (draft.kind, draft.duration_s) = (0, duration_s),
            Manoeuvre::Straight { duration_s } => (draft.kind, draft.duration_s) = (1, duration_s),
            Manoeuvre::Accelerate { duration_s, speed_change_m_s } => {
                (draft.kind, draft.duration_s, draft.speed_change_m_s) = (2, duration_s, speed_change_m_s);
            }
            Manoeuvre::Climb { duration_s, height_change_m, ramp_s } => {
                (draft.kind, draft.duration_s, draft.ramp_s) = (3, duration_s, ramp_s);
                draft.height_change_m = height_change_m;
            }
            Manoeuvre::Turn { heading_change_rad, bank_rad, ramp_s } => {
                (draft.kind, draft.ramp_s, draft.bank_rad) = (4, ramp_s, bank_rad);
                draft.heading_change_rad = heading_change_rad;
            }
            Manoeuvre::Roll { duration_s, turns } => {
                (draft.kind, draft.duration_s, draft.turns) = (5, duration_s, turns);
            }
            Manoeuvre::Loop { duration_s, turns, ramp_s } => {
                (draft.kind, draft.duration_s, draft.turns, draft.ramp_s) = (6, duration_s, turns, ramp_s);
            }
            Manoeuvre::STurn { duration_s, heading_amplitude_rad, cycles, ramp_s } => {
                (draft.kind, draft.duration_s, draft.turns, draft.ramp_s) = (7, duration_s, cycles, ramp_s);
                draft.heading_change_rad = heading_amplitude_rad;
            }
            Manoeuvre::Sinusoids { duration_s, ramp_s, terms, count } => {
                (draft.kind, draft.duration_s, draft.ramp_s) = (8, duration_s, ramp_s);
                draft.sinusoids = terms[..count].to_vec();
            }
        }
        draft
    }
}

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
        let Self { size, density, interval_s, duration_s, probability, .. } = *self;
        match self.kind {
            0 => None,
            1 => Some(Failure::Stuck),
            2 => Some(Failure::Dead),
            3 => Some(Failure::BiasStep { size }),
            4 => Some(Failure::Spikes { size, interval_s, duration_s }),
            5 => Some(Failure::Noise { density }),
            _ if interval_s != 0.0 => Some(Failure::PeriodicDropOuts { interval_s }),
            _ => Some(Failure::RandomDropOuts { probability }),
        }
    }

    /// What is planned, checked; `None` if it is switched off.
    pub fn to_planned(&self) -> Result<Option<PlannedFailure>, Error> {
        let Some(failure) = self.to_failure() else { return Ok(None) };
        failure.validate(self.output())?;
        if self.until_s <= self.from_s {
            let rule = Rule::AtLeast("must be more than from_s =", self.from_s);
            return Err(Error::invalid("failure.until_s", self.until_s, rule));
        }
        let until_s = if self.until_s.is_nan() { f64::INFINITY } else { self.until_s };
        Ok(Some(PlannedFailure {
            output: self.output(),
            failing: Failing { from_s: self.from_s, until_s },
            failure,
        }))
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
        let mut draft = Self { sensor, axis, from_s, until_s, ..Self::default() };
        match planned.failure {
            Failure::Stuck => draft.kind = 1,
            Failure::Dead => draft.kind = 2,
            Failure::BiasStep { size } => (draft.kind, draft.size) = (3, size),
            Failure::Spikes { size, interval_s, duration_s } => {
                (draft.kind, draft.size) = (4, size);
                (draft.interval_s, draft.duration_s) = (interval_s, duration_s);
            }
            Failure::Noise { density } => (draft.kind, draft.density) = (5, density),
            Failure::RandomDropOuts { probability } => (draft.kind, draft.probability) = (6, probability),
            Failure::PeriodicDropOuts { interval_s } => (draft.kind, draft.interval_s) = (6, interval_s),
        }
        draft
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
            manoeuvre: ManoeuvreDraft::default(),
            sinusoid: SinusoidDraft::default(),
            failure: FailureDraft::default(),
            scene: scene.clone(),
        }
    }
}

impl Draft {
    /// The scene, with the manoeuvres that its flight is made of where it is neither a log nor a built-in one.
    pub fn into_scene(mut self, manoeuvres: Vec<Manoeuvre>) -> Scene {
        let some = |number: f64| (!number.is_nan()).then_some(number);
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
        scene.options.closed_loop_time_s = self.closed_loop.then_some(self.closed_loop_time_s);
        scene.options.intake.period_s = some(self.sample_period_s);
        scene.output.every_s = some(self.every_s);
        scene
    }
}
