//! A piece of a flight: its checked samples, and figures of the whole piece.

use core::fmt;

use nalgebra::Vector3;

use crate::base::error::{Error, check_integer};
use crate::base::math::{relative_rotation, rotation_vector};
use crate::simulator::Options;
use crate::truth::{Extreme, FlightSample, Intake, Recent, TruthPoint, TruthSummary};

/// Least number of samples of a piece: one interval.
pub const MIN_SAMPLES: usize = 2;
/// Largest number of samples of a piece: an hour at 100 Hz.
pub const MAX_SAMPLES: usize = 360_000;

/// A rejected piece, or a rejected requirement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refusal {
    /// The error: which value was rejected, and why.
    pub error: Error,
    /// The sample at which it showed, if it is one's fault.
    pub sample: Option<usize>,
    /// The piece of that sample.
    pub piece: usize,
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        Self { error, sample: None, piece: 0 }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.error, f)?;
        match self.sample {
            Some(index) => write!(f, " (samples[{index}])"),
            None => Ok(()),
        }
    }
}

impl core::error::Error for Refusal {}

/// A piece of a flight.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Piece {
    /// Length on the time base [s].
    pub duration_s: f64,
    /// Largest speed against the Earth [m/s].
    pub speed_m_s: f64,
    /// Largest change of the velocity since the first sample [m/s].
    pub velocity_change_m_s: f64,
    /// How hard its motion is.
    pub motion: Motion,
}

impl Piece {
    /// Checks the samples each by itself and against the one before, as a simulator does.
    pub fn new(options: &Options, samples: &[FlightSample]) -> Result<Self, Refusal> {
        options.validate()?;
        check_integer("count", samples.len(), MIN_SAMPLES as u64, MAX_SAMPLES as u64)?;
        let earth = options.earth();
        let mut intake = Intake::new(earth, options.axes, options.intake)?;
        let mut summary = TruthSummary::default();
        let mut piece = Self::default();
        let mut start_v_e = Vector3::zeros();
        for (index, sample) in samples.iter().enumerate() {
            intake.push(sample).map_err(|error| Refusal { error, sample: Some(index), piece: 0 })?;
            // The first point is taken with the second, which may be the source of its velocity.
            if index > 0 {
                intake.take();
            }
            let Some(recent) = intake.recent() else { continue };
            if index == 1 {
                start_v_e = recent.current.state.v_e;
            }
            let change = (recent.next.state.v_e - start_v_e).norm_squared().sqrt();
            piece.velocity_change_m_s = piece.velocity_change_m_s.max(change);
            piece.motion.add_vibration(&recent);
            summary.add(&earth, options.axes, &recent);
        }
        piece.duration_s = summary.last_s - summary.first_s;
        piece.speed_m_s = summary.speed_max.value;
        (piece.motion.rate_max, piece.motion.force_max) = (summary.rate_max, summary.force_max);
        Ok(piece)
    }
}

/// How hard a motion is. A piece with smaller values than the flight is calmer than the flight, and does not stand for it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// Largest angular rate, as in [`TruthSummary`] [rad/s].
    pub rate_max: Extreme,
    /// Largest specific force, as in [`TruthSummary`] [m/s²].
    pub force_max: Extreme,
    /// Largest vibration: change of the mean rate from an interval to the next, divided by the time between their middles
    /// [rad/s²].
    pub vibration_max: Extreme,
}

impl Motion {
    fn add_vibration(&mut self, recent: &Recent<'_>) {
        let Recent { next, current, before: [Some(before), _] } = *recent else { return };
        let rate = |from: &TruthPoint, to: &TruthPoint| {
            rotation_vector(&relative_rotation(&from.state.q_eb, &to.state.q_eb)) / to.interval_s
        };
        let change = (rate(current, next) - rate(before, current)).norm_squared().sqrt();
        let between_s = 0.5 * (next.interval_s + current.interval_s);
        self.vibration_max.take_larger(change / between_s, next.time_s);
    }

    /// Largest rate, specific force and vibration.
    pub fn values(&self) -> [f64; 3] {
        [self.rate_max.value, self.force_max.value, self.vibration_max.value]
    }

    /// Keeps the values of `other` that are larger.
    pub(super) fn include(&mut self, other: &Self) {
        let Self { rate_max, force_max, vibration_max } = other;
        self.rate_max.take_larger(rate_max.value, rate_max.time_s);
        self.force_max.take_larger(force_max.value, force_max.time_s);
        self.vibration_max.take_larger(vibration_max.value, vibration_max.time_s);
    }
}
