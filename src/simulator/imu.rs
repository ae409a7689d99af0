//! The interval flown last, and what is reported of its signals.

use crate::base::snapshot::{CLOCK_S, stored};
use crate::signal::Increment;
use crate::truth::INTERVALS_S;

/// Ideal and measured signals of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ImuInterval {
    /// Time of the end of the interval [s].
    pub time_s: f64,
    /// Length of the interval [s].
    pub interval_s: f64,
    /// Increment that perfect sensors measure.
    pub ideal: Increment,
    /// Increment that the modelled sensors measure.
    pub measured: Increment,
    /// Measured increment after the compensation: the INS navigates on it.
    pub compensated: Increment,
    /// Flags of the built-in test of the modelled sensors.
    pub flags: ImuFlags,
}

impl ImuInterval {
    /// Mean measured signals: angular rate [rad/s] and specific force [m/s²] in place of the increments.
    pub(crate) fn mean_measured(&self) -> Increment {
        let Self { measured: Increment { angle, velocity }, interval_s, .. } = self;
        Increment { angle: angle / *interval_s, velocity: velocity / *interval_s }
    }
}

stored!(ImuInterval { time_s: CLOCK_S, interval_s: INTERVALS_S.1, ideal, measured, compensated, flags } then |imu, from| {
    from.require(imu.interval_s >= INTERVALS_S.0, imu.interval_s, "is no interval")
});

/// What the built-in test of the sensors reports of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ImuFlags {
    /// A gyro was beyond its range.
    pub gyro_saturated: bool,
    /// An accelerometer was beyond its range.
    pub accel_saturated: bool,
    /// A gyro had no signal: dead, or dropped out.
    pub gyro_invalid: bool,
    /// An accelerometer had no signal: dead, or dropped out.
    pub accel_invalid: bool,
}

stored!(ImuFlags { gyro_saturated, accel_saturated, gyro_invalid, accel_invalid });

/// The interval flown last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum LastInterval {
    /// No interval was flown yet.
    None,
    /// The increments of the interval are in the chain.
    InParts {
        time_s: f64,
        interval_s: f64,
        /// The INS navigated on the ideal increments.
        on_ideal: bool,
        /// Sum of the measured increments, if the INS compensated them.
        measured: Option<Increment>,
        flags: ImuFlags,
        vertical_unaided: bool,
    },
    /// The ideal increments are known as their sum only, as a snapshot and an ensemble keep them. The increments on which the INS
    /// navigated are in the chain, in an ensemble their sum alone.
    Summed { imu: ImuInterval, vertical_unaided: bool },
}

impl LastInterval {
    /// Sets the end of the interval to `now_s` [s], because time has been moved.
    pub fn move_to(&mut self, now_s: f64) {
        match self {
            Self::None => {}
            Self::InParts { time_s, .. } => *time_s = now_s,
            Self::Summed { imu, .. } => imu.time_s = now_s,
        }
    }

    /// Length of the interval \[s\], if there was one.
    pub fn length_s(&self) -> Option<f64> {
        match *self {
            Self::None => None,
            Self::InParts { interval_s, .. } => Some(interval_s),
            Self::Summed { imu, .. } => Some(imu.interval_s),
        }
    }

    /// Whether nothing aided the vertical channel, if there was an interval.
    pub fn vertical_unaided(&self) -> Option<bool> {
        match *self {
            Self::None => None,
            Self::InParts { vertical_unaided, .. } | Self::Summed { vertical_unaided, .. } => {
                Some(vertical_unaided)
            }
        }
    }
}
