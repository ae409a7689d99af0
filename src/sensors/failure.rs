//! How a sensor can fail, as an instructor sets it.

use crate::base::error::{Error, Rule, check_range};
use crate::base::snapshot::{ANY, Numbers, Reader, Stored, Writer};
use crate::signal::Increment;

/// Axis of a triad, sensor axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// First axis.
    X = 0,
    /// Second axis.
    Y = 1,
    /// Third axis.
    Z = 2,
}

/// An output that can fail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SensorOutput {
    /// A gyro; the unit u of failures is rad/s.
    Gyro(Axis),
    /// An accelerometer; the unit u of failures is m/s².
    Accelerometer(Axis),
    /// The altimeter; the unit u of failures is m.
    Altimeter,
}

impl SensorOutput {
    /// All outputs.
    pub const ALL: [Self; 7] = [
        Self::Gyro(Axis::X),
        Self::Gyro(Axis::Y),
        Self::Gyro(Axis::Z),
        Self::Accelerometer(Axis::X),
        Self::Accelerometer(Axis::Y),
        Self::Accelerometer(Axis::Z),
        Self::Altimeter,
    ];

    /// The output in an increment; of the altimeter none.
    pub(crate) fn of(self, increment: &Increment) -> Option<f64> {
        match self {
            Self::Gyro(axis) => Some(increment.angle[axis as usize]),
            Self::Accelerometer(axis) => Some(increment.velocity[axis as usize]),
            Self::Altimeter => None,
        }
    }

    /// The output of a sensor, gyro, accelerometer or altimeter counted from 0, along an axis; the altimeter has one, whatever the axis.
    pub(crate) fn of_sensor(sensor: usize, axis: usize) -> Self {
        Self::ALL[(3 * sensor + axis).min(Self::ALL.len() - 1)]
    }

    /// Its sensor and its axis, as [`Self::of_sensor`] takes them; 0 of the altimeter.
    #[cfg(feature = "scenes")]
    pub(crate) fn parts(self) -> (usize, usize) {
        match self {
            Self::Gyro(axis) => (0, axis as usize),
            Self::Accelerometer(axis) => (1, axis as usize),
            Self::Altimeter => (2, 0),
        }
    }
}

/// A failure of one output. It lasts from the interval after it is set until it is cleared or replaced by another one.
///
/// Bias steps, spikes and noise are added to the signal before dead zone, range and quantization, so the output still looks like
/// data. The other failures replace the output. Noise processes, filters and residuals continue during a failure.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Failure {
    /// The output holds its mean over the interval before the failure. If there was no such interval, it holds its first value.
    #[default]
    Stuck,
    /// No signal: gyros and accelerometers output 0, the altimeter outputs nothing. The built-in test detects this failure.
    Dead,
    /// An additional bias.
    BiasStep {
        /// Size of the bias [u].
        size: f64,
    },
    /// A train of rectangular pulses. The first pulse begins at once.
    Spikes {
        /// Height of a pulse [u].
        size: f64,
        /// Time from the start of one pulse to the start of the next pulse [s].
        interval_s: f64,
        /// Length of a pulse [s].
        duration_s: f64,
    },
    /// Additional white noise.
    Noise {
        /// Density N of the noise [u √s].
        density: f64,
    },
    /// Each sample interval is lost with the same probability, independently of the others. A lost interval is as with
    /// [`Self::Dead`].
    RandomDropOuts {
        /// Probability that an interval is lost [1].
        probability: f64,
    },
    /// One sample interval is lost in each period of `interval_s`. The first loss comes at once.
    PeriodicDropOuts {
        /// Time from one loss to the next [s]. If it is shorter than a sample interval, each interval is lost.
        interval_s: f64,
    },
}

/// Stored as a number for the kind and three further numbers. The numbers of the kinds are part of the format.
impl Stored for Failure {
    fn save(&self, to: &mut Writer<'_>) {
        let (kind, numbers) = match *self {
            Self::Stuck => (0, [0.0; 3]),
            Self::Dead => (1, [0.0; 3]),
            Self::BiasStep { size } => (2, [size, 0.0, 0.0]),
            Self::Spikes { size, interval_s, duration_s } => (3, [size, interval_s, duration_s]),
            Self::Noise { density } => (4, [density, 0.0, 0.0]),
            Self::RandomDropOuts { probability } => (5, [probability, 0.0, 0.0]),
            Self::PeriodicDropOuts { interval_s } => (6, [interval_s, 0.0, 0.0]),
        };
        to.count(kind);
        Numbers::save(&numbers, to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        let kind = from.count(6)?;
        let mut numbers = [0.0; 3];
        Numbers::load(&mut numbers, from, ANY)?;
        let [first, second, third] = numbers;
        *self = match kind {
            0 => Self::Stuck,
            1 => Self::Dead,
            2 => Self::BiasStep { size: first },
            3 => Self::Spikes { size: first, interval_s: second, duration_s: third },
            4 => Self::Noise { density: first },
            5 => Self::RandomDropOuts { probability: first },
            _ => Self::PeriodicDropOuts { interval_s: first },
        };
        Ok(())
    }
}

impl Failure {
    /// Checks every field.
    pub fn validate(&self, output: SensorOutput) -> Result<(), Error> {
        let limit = match output {
            SensorOutput::Gyro(_) => 100.0,
            SensorOutput::Accelerometer(_) => 1e4,
            SensorOutput::Altimeter => 1e5,
        };
        let check_size = |size| check_range("failure.size", size, -limit, limit);
        let check_interval = |interval_s| check_range("failure.interval_s", interval_s, 1e-4, 1e9);
        match *self {
            Self::Stuck | Self::Dead => Ok(()),
            Self::BiasStep { size } => check_size(size),
            Self::Spikes { size, interval_s, duration_s } => {
                check_size(size)?;
                check_interval(interval_s)?;
                check_range("failure.duration_s", duration_s, 1e-9, 1e9)?;
                if duration_s > interval_s {
                    let rule = Rule::AtMost("must be at most failure.interval_s =", interval_s.into());
                    return Err(Error::invalid("failure.duration_s", duration_s, rule));
                }
                Ok(())
            }
            Self::Noise { density } => check_range("failure.density", density, 0.0, limit),
            Self::RandomDropOuts { probability } => check_range("failure.probability", probability, 0.0, 1.0),
            Self::PeriodicDropOuts { interval_s } => check_interval(interval_s),
        }
    }

    /// Whether it is added before the output electronics.
    pub(super) fn is_added(&self) -> bool {
        matches!(self, Self::BiasStep { .. } | Self::Spikes { .. } | Self::Noise { .. })
    }
}

/// The kinds of failures, and the quantities that each of them uses. Drop-outs use one of the two.
pub(crate) const FAILURE_KINDS: [(&str, &[&str]); 7] = [
    ("none", &["size", "density", "interval_s", "duration_s", "probability"]),
    ("stuck", &[]),
    ("dead", &[]),
    ("bias_step", &["size"]),
    ("spikes", &["size", "interval_s", "duration_s"]),
    ("noise", &["density"]),
    ("drop_outs", &["interval_s", "probability"]),
];

/// A failure of any kind, or none. It has the quantities of all kinds; those that its kind does not use are 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct FailureFields {
    /// Index in [`FAILURE_KINDS`].
    pub kind: usize,
    pub size: f64,
    pub density: f64,
    pub interval_s: f64,
    pub duration_s: f64,
    pub probability: f64,
}

impl FailureFields {
    /// The failure; `None` for kind 0. Quantities that the kind does not use are ignored. Drop-outs with an interval are periodic.
    pub fn to_failure(self) -> Option<Failure> {
        let Self { kind, size, density, interval_s, duration_s, probability } = self;
        match kind {
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
}

impl From<Option<Failure>> for FailureFields {
    fn from(failure: Option<Failure>) -> Self {
        let none = Self::default();
        let Some(failure) = failure else { return none };
        match failure {
            Failure::Stuck => Self { kind: 1, ..none },
            Failure::Dead => Self { kind: 2, ..none },
            Failure::BiasStep { size } => Self { kind: 3, size, ..none },
            Failure::Spikes { size, interval_s, duration_s } => {
                Self { kind: 4, size, interval_s, duration_s, ..none }
            }
            Failure::Noise { density } => Self { kind: 5, density, ..none },
            Failure::PeriodicDropOuts { interval_s } => Self { kind: 6, interval_s, ..none },
            Failure::RandomDropOuts { probability } => Self { kind: 6, probability, ..none },
        }
    }
}
