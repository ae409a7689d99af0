//! Requirements: which fraction of the runs has which error within which limit, and when.

use sins::units::{ARCMIN, ARCSEC, DEG};

use super::results::State;
use crate::units::{ANGLE, Family, LENGTH, NMI_PER_HOUR, SPEED};

pub const HOUR_S: f64 = 3600.0;
pub const NMI: f64 = 1852.0;

/// How an error is computed from the errors of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measure {
    /// Magnitude of one of the nine errors.
    State(usize),
    /// Magnitude of the horizontal part of the error whose east component has this place.
    Horizontal(usize),
    /// Magnitude of the position error along the track of the truth, and across it.
    Along,
    Cross,
}

/// The quantities: name, measure, units.
pub const QUANTITIES: [(&str, Measure, &Family); 14] = [
    ("position_horizontal", Measure::Horizontal(0), LENGTH),
    ("position_along", Measure::Along, LENGTH),
    ("position_cross", Measure::Cross, LENGTH),
    ("position_east", Measure::State(0), LENGTH),
    ("position_north", Measure::State(1), LENGTH),
    ("position_up", Measure::State(2), LENGTH),
    ("velocity_horizontal", Measure::Horizontal(3), SPEED),
    ("velocity_east", Measure::State(3), SPEED),
    ("velocity_north", Measure::State(4), SPEED),
    ("velocity_up", Measure::State(5), SPEED),
    ("misalignment_horizontal", Measure::Horizontal(6), ANGLE),
    ("misalignment_east", Measure::State(6), ANGLE),
    ("misalignment_north", Measure::State(7), ANGLE),
    ("misalignment_up", Measure::State(8), ANGLE),
];

/// The keys of a limit: name, SI, units, whether it grows with the time since the start.
pub const LIMITS: [(&str, f64, &Family, bool); 10] = [
    ("limit_m", 1.0, LENGTH, false),
    ("limit_km", 1e3, LENGTH, false),
    ("limit_nmi", NMI, LENGTH, false),
    ("limit_nmi_h", NMI_PER_HOUR.si, LENGTH, true),
    ("limit_m_s", 1.0, SPEED, false),
    ("limit_ft_s", 0.3048, SPEED, false),
    ("limit_kn", NMI / HOUR_S, SPEED, false),
    ("limit_deg", DEG, ANGLE, false),
    ("limit_arcmin", ARCMIN, ANGLE, false),
    ("limit_arcsec", ARCSEC, ANGLE, false),
];

/// A requirement.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirement {
    /// Title and source of its file.
    pub title: String,
    pub source: String,
    pub quantity: &'static str,
    pub measure: Measure,
    pub family: &'static Family,
    pub percent: f64,
    /// Limit [SI]; [SI/s] if it grows.
    pub limit: f64,
    pub grows: bool,
    /// Time since the start [s]; `None`: the end of the flight.
    pub time_s: Option<f64>,
    /// Durations of the flights to which it applies: above the first, up to the second [s].
    pub applies_s: [f64; 2],
}

impl Measure {
    /// The error [SI] of a run whose truth flies in the direction `track_rad`.
    pub fn of(self, state: &State, track_rad: f64) -> f64 {
        match self {
            Self::State(place) => state[place].abs(),
            Self::Horizontal(east) => state[east].hypot(state[east + 1]),
            Self::Along => along_cross(state, track_rad)[0].abs(),
            Self::Cross => along_cross(state, track_rad)[1].abs(),
        }
    }
}

/// Components of the position error along the track, and to the right of it [m].
pub fn along_cross(state: &State, track_rad: f64) -> [f64; 2] {
    let (sine, cosine) = track_rad.sin_cos();
    [state[0] * sine + state[1] * cosine, state[0] * cosine - state[1] * sine]
}

impl Requirement {
    /// The limit [SI] at `time_s` since it began to grow.
    pub fn limit_at(&self, time_s: f64) -> f64 {
        if self.grows { self.limit * time_s } else { self.limit }
    }

    /// Whether it applies to a flight that lasts `duration_s`.
    pub fn applies(&self, duration_s: f64) -> bool {
        self.applies_s[0] < duration_s && duration_s <= self.applies_s[1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_track_turns_the_position_error() {
        let state = [3.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        // To the north: along is north, cross is east. To the east: along is east, cross is south.
        for (track_deg, [along, cross]) in [(0.0, [4.0, 3.0]), (90.0, [3.0, -4.0]), (180.0, [-4.0, -3.0])] {
            let found = along_cross(&state, track_deg * DEG);
            assert!(
                (found[0] - along).abs() < 1e-15 * 5.0 && (found[1] - cross).abs() < 1e-15 * 5.0,
                "{found:?}"
            );
            assert!((Measure::Cross.of(&state, track_deg * DEG) - f64::abs(cross)).abs() < 5e-15);
        }
        assert_eq!(Measure::Horizontal(0).of(&state, 1.0), 5.0);
    }
}
