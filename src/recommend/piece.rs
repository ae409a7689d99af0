//! A piece of a flight: its checked samples, and figures of the whole piece.

use core::fmt;

use nalgebra::Vector3;

use crate::error::{Error, check_integer};
use crate::simulator::Options;
use crate::truth::{FlightSample, Intake, TruthPoint};

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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Length on the time base [s].
    pub duration_s: f64,
    /// Largest speed against the Earth [m/s].
    pub speed_m_s: f64,
    /// Largest change of the velocity since the first sample [m/s].
    pub velocity_change_m_s: f64,
}

impl Piece {
    /// Checks the samples each by itself and against the one before, as a simulator does.
    pub fn new(options: &Options, samples: &[FlightSample]) -> Result<Self, Refusal> {
        options.validate()?;
        check_integer("count", samples.len(), MIN_SAMPLES as i64, MAX_SAMPLES as i64)?;
        let mut intake = Intake::new(options.earth(), options.axes, options.intake)?;
        let mut first: Option<(f64, Vector3<f64>)> = None;
        let mut piece = Self { duration_s: 0.0, speed_m_s: 0.0, velocity_change_m_s: 0.0 };
        let mut add = |point: &TruthPoint| {
            let v_e = point.state.v_e;
            let (start_s, start_v_e) = *first.get_or_insert((point.time_s, v_e));
            piece.duration_s = point.time_s - start_s;
            piece.speed_m_s = piece.speed_m_s.max(v_e.norm_squared().sqrt());
            let change = (v_e - start_v_e).norm_squared().sqrt();
            piece.velocity_change_m_s = piece.velocity_change_m_s.max(change);
        };
        for (index, sample) in samples.iter().enumerate() {
            intake.push(sample).map_err(|error| Refusal { error, sample: Some(index), piece: 0 })?;
            // The velocity of a first sample without one is known with the second.
            if intake.waiting() > 1 {
                intake.front().iter().for_each(|point| add(point));
                intake.take();
            }
        }
        intake.front().iter().for_each(|point| add(point));
        Ok(piece)
    }
}
