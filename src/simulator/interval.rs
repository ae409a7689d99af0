//! The interval flown last.

use super::Saturation;
use crate::signal::Increment;
use crate::snapshot::stored;

/// Ideal and measured signals of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ImuInterval {
    /// Time of its end [s].
    pub time_s: f64,
    /// Its length [s].
    pub interval_s: f64,
    /// What perfect sensors give.
    pub ideal: Increment,
    /// What the modelled sensors give.
    pub measured: Increment,
    /// Whether some of that was beyond their range.
    pub saturation: Saturation,
}

stored!(ImuInterval { time_s: 1e12, interval_s: 1e3, ideal, measured, saturation });

/// The interval flown last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum LastInterval {
    /// There is none.
    None,
    /// It left its increments in the chain.
    Flown { time_s: f64, interval_s: f64, sensors_were_ideal: bool, saturation: Saturation },
    /// A snapshot keeps the sums alone.
    Loaded(ImuInterval),
}
