//! The interval flown last.

use super::{ImuFlags, ImuInterval};

/// The interval flown last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum LastInterval {
    /// No interval was flown yet.
    None,
    /// The increments of the interval are in the chain.
    Flown {
        time_s: f64,
        interval_s: f64,
        /// The INS navigated on the ideal increments.
        on_ideal: bool,
        /// The INS compensated the measured increments.
        is_compensated: bool,
        flags: ImuFlags,
        vertical_unaided: bool,
    },
    /// Only the sums of the increments are known, as a snapshot stores only these.
    Loaded { imu: ImuInterval, vertical_unaided: bool },
}

impl LastInterval {
    /// Sets the end of the interval to `now_s` [s], because time has been moved.
    pub fn move_to(&mut self, now_s: f64) {
        match self {
            Self::None => {}
            Self::Flown { time_s, .. } => *time_s = now_s,
            Self::Loaded { imu, .. } => imu.time_s = now_s,
        }
    }

    /// Whether nothing aided the vertical channel, if there was an interval.
    pub fn vertical_unaided(&self) -> Option<bool> {
        match *self {
            Self::None => None,
            Self::Flown { vertical_unaided, .. } | Self::Loaded { vertical_unaided, .. } => {
                Some(vertical_unaided)
            }
        }
    }
}
