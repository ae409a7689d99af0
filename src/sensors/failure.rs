//! How a sensor can fail, as an instructor sets it.

use crate::base::error::{Error, Rule, check_range, check_within};
use crate::base::kinds::kinds;
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
    pub(crate) fn parts(self) -> (usize, usize) {
        match self {
            Self::Gyro(axis) => (0, axis as usize),
            Self::Accelerometer(axis) => (1, axis as usize),
            Self::Altimeter => (2, 0),
        }
    }
}

/// What a failure does to the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Acts {
    /// It adds to the signal before dead zone, range and quantization.
    Added,
    /// It replaces the output behind them.
    Replaces,
}

kinds! {
    /// A failure of one output. It lasts from the interval after it is set until it is cleared or replaced by another one.
    ///
    /// Bias steps, spikes and noise are added to the signal before dead zone, range and quantization, so the output still looks like
    /// data. The other failures replace the output. Noise processes, filters and residuals continue during a failure.
    Failure of "failure", flat FailureFields none "none" {
        /// Size of a bias step, height of a pulse [u].
        size = 0.0,
        /// Density N of the noise [u √s].
        density = 0.0,
        /// Time from the start of one pulse or loss to the start of the next [s].
        interval_s = 0.0,
        /// Length of a pulse [s].
        duration_s = 0.0,
        /// Probability that an interval is lost [1].
        probability = 0.0,
    } {
        /// The output stays at its mean over the interval before the failure, as sins_imu reported it; without such an interval, at
        /// its first value. It is not flagged, because it looks like valid data.
        Stuck = 1 "stuck" acts Replaces,
        /// No signal. A gyro or an accelerometer gives 0, and is flagged SINS_IMU_..._INVALID, as by a built-in test. Without the
        /// altimeter nothing stabilizes the vertical channel of SINS_VERTICAL_DAMPED; this is flagged
        /// SINS_NAVIGATION_VERTICAL_UNAIDED.
        Dead = 2 "dead" acts Replaces,
        /// An additional bias; its value is in the field `size`. Not flagged.
        BiasStep = 3 "bias_step" { size } acts Added,
        /// Rectangular pulses. The field `size` is their height, duration_s their length. A pulse starts every interval_s; the first
        /// starts immediately. A sample of the altimeter shows the mean of the pulses over the sample interval. A gyro or an
        /// accelerometer is flagged only if a pulse saturates it.
        Spikes = 4 "spikes" { size, interval_s, duration_s } acts Added,
        /// Additional white noise; its density is in the field `density`. A sample of the altimeter shows the mean of the noise over
        /// the sample interval. Not flagged.
        Noise = 5 "noise" { density } acts Added,
        /// Sample intervals are lost: in each of them the output acts as with SINS_FAILURE_DEAD. Either each interval is lost
        /// independently with the probability in the field `probability`, or one interval is lost every interval_s, the first
        /// immediately.
        DropOuts = 6 "drop_outs" { interval_s, probability } acts Replaces,
    }
}

impl Default for Failure {
    /// The one that needs no quantity and no interval before it.
    fn default() -> Self {
        Self::Dead
    }
}

/// Stored as the number of the kind with the quantities that it uses.
impl Stored for Failure {
    fn save(&self, to: &mut Writer<'_>) {
        to.count(FailureFields::from(self).kind);
        Numbers::save(&self.fields().1, to);
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        let mut fields =
            FailureFields { kind: from.count(FailureFields::KINDS.len() - 1)?, ..Default::default() };
        let mut numbers = [0.0; 5];
        Numbers::load(&mut numbers, from, ANY)?;
        fields.numbers_mut().into_iter().zip(numbers).for_each(|(to, number)| *to = number);
        let rule = Rule::Sentence("is not a failure");
        *self = fields.kind().ok_or_else(|| from.refused(fields.kind as u64, rule))?;
        Ok(())
    }
}

impl Failure {
    /// Greatest size and density, of a gyro, an accelerometer and the altimeter [u].
    pub(crate) const GREATEST: [f64; 3] = [100.0, 1e4, 1e5];
    // Ranges of the other quantities.
    pub(crate) const INTERVALS_S: (f64, f64) = (1e-4, 1e9);
    pub(crate) const DURATIONS_S: (f64, f64) = (1e-9, 1e9);
    pub(crate) const PROBABILITIES: (f64, f64) = (0.0, 1.0);

    /// Checks every field.
    pub fn validate(&self, output: SensorOutput) -> Result<(), Error> {
        let limit = Self::GREATEST[output.parts().0];
        let check_size = |size| check_range("failure.size", size, -limit, limit);
        let check_interval = |interval_s| check_within("failure.interval_s", interval_s, Self::INTERVALS_S);
        match *self {
            Self::Stuck | Self::Dead => Ok(()),
            Self::BiasStep { size } => check_size(size),
            Self::Spikes { size, interval_s, duration_s } => {
                check_size(size)?;
                check_interval(interval_s)?;
                check_within("failure.duration_s", duration_s, Self::DURATIONS_S)?;
                if duration_s > interval_s {
                    let rule = Rule::AtMost("must be at most failure.interval_s =", interval_s.into());
                    return Err(Error::invalid("failure.duration_s", duration_s, rule));
                }
                Ok(())
            }
            Self::Noise { density } => check_range("failure.density", density, 0.0, limit),
            Self::DropOuts { interval_s: 0.0, probability } => {
                check_within("failure.probability", probability, Self::PROBABILITIES)
            }
            Self::DropOuts { interval_s, probability } => {
                check_interval(interval_s)?;
                let rule = Rule::Zero(": drop-outs with failure.interval_s do not use it");
                if probability == 0.0 {
                    Ok(())
                } else {
                    Err(Error::invalid("failure.probability", probability, rule))
                }
            }
        }
    }

    /// The kind in a scene's word, then size, density, interval_s, duration_s and probability: 0 if the kind does not use them.
    pub fn fields(&self) -> (&'static str, [f64; 5]) {
        let mut fields = FailureFields::from(self);
        (FailureFields::KINDS[fields.kind].0, fields.numbers_mut().map(|number| *number))
    }

    /// Whether it differs from run to run.
    pub fn is_random(&self) -> bool {
        match self {
            Self::Noise { .. } => true,
            Self::DropOuts { interval_s, .. } => *interval_s == 0.0,
            Self::Stuck | Self::Dead | Self::BiasStep { .. } | Self::Spikes { .. } => false,
        }
    }
}
