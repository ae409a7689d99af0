//! A vehicle that flies level above the air: neither an orbit nor a free fall, so its height is in a smaller unit than metres.

use super::finding::At;
use super::row::Row;
use crate::base::units::STANDARD_GRAVITY as G;
use crate::earth::Earth;

/// Height above which nothing carries a vehicle \[m\].
const AIR_M: f64 = 100e3;

/// Least time between two of the three heights that are compared, and most between the first and the last \[s\].
const BETWEEN_S: f64 = 30.0;
const AT_MOST_S: f64 = 180.0;

/// Speed against the ground below which a vehicle is in no orbit, and no upper stage \[m/s\].
const SLOW_M_S: f64 = 1000.0;

/// Specific force up, as a share of gravity, of level flight.
const LEVEL: core::ops::Range<f64> = 0.7..1.3;

#[derive(Debug, Clone)]
pub(super) struct AboveAir {
    /// Two heights before \[m\], the newer first, and when they were.
    past: [Option<(At, f64)>; 2],
    /// Where it first flew level, and its height then \[m\].
    pub found: Option<(At, f64)>,
}

impl AboveAir {
    pub const fn new() -> Self {
        Self { past: [None; 2], found: None }
    }

    /// Adds a row.
    pub fn add(&mut self, earth: &Earth, row: &Row) {
        let height_m = row.place.height_m;
        if self.found.is_some() || height_m < AIR_M || row.step_m() > SLOW_M_S * row.interval_s {
            self.past = [None; 2];
            return;
        }
        let since_s = |(at, _): (At, f64)| row.at.time_s - at.time_s;
        let [newer, older] = self.past;
        if newer.is_some_and(|newer| since_s(newer) < BETWEEN_S) {
            return;
        }
        if let [Some(newer), Some(older)] =
            [newer, older].map(|past| past.filter(|&past| since_s(past) < AT_MOST_S))
        {
            let (second_s, whole_s) = (since_s(newer), since_s(older));
            let first_s = whole_s - second_s;
            let up = 2.0 * ((height_m - newer.1) / second_s - (newer.1 - older.1) / first_s) / whole_s;
            let share = earth.equatorial_radius_m / (earth.equatorial_radius_m + height_m);
            if LEVEL.contains(&(1.0 + up / (G * share * share))) {
                self.found = Some((older.0, older.1));
            }
        }
        self.past = [Some((row.at, height_m)), newer];
    }
}
