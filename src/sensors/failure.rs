//! How a sensor can fail, as an instructor sets it.

use crate::error::{Error, Rule, check_range};
use crate::snapshot::{ANY, Numbers, Reader, Stored, Writer};

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

    /// The output of a sensor, gyro, accelerometer or altimeter counted from 0, along an axis; the altimeter has one, whatever the axis.
    pub(crate) fn of(sensor: usize, axis: usize) -> Self {
        Self::ALL[(3 * sensor + axis).min(Self::ALL.len() - 1)]
    }

    /// Its sensor and its axis, as [`Self::of`] takes them; 0 of the altimeter.
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
                    let rule = Rule::AtMost("must be at most failure.interval_s =", interval_s);
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
