//! Where the flights of a check begin.

use super::DURATIONS_S;
use super::drift::Steps;
use crate::base::error::Error;
use crate::base::memory::room;

/// Most flights of a duration.
const MOST: usize = 48;
/// Flights of a duration begin at least this part of it apart.
const APART: f64 = 0.5;
/// Least number of a duration that has room.
const ROOM: f64 = 2.0;

/// The flights of one duration.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Flights {
    pub duration_s: f64,
    /// Begins of the flights on the clock of the path [s].
    pub starts_s: Vec<f64>,
    /// Number of flights that do not overlap.
    pub apart: usize,
}

/// The flights of all durations.
pub(super) struct Starts {
    pub spans: Vec<Flights>,
}

impl Starts {
    /// Evenly spread over the part from `first_s` to `last_s` [s], without those in which the record has a gap.
    pub fn new(steps: &Steps, (first_s, last_s): (f64, f64)) -> Result<Self, Error> {
        let mut spans = room(DURATIONS_S.len())?;
        let length_s = last_s - first_s;
        for duration_s in DURATIONS_S.into_iter().filter(|duration_s| ROOM * duration_s <= length_s) {
            let spare_s = length_s - duration_s;
            let count = (1 + (spare_s / (APART * duration_s)) as usize).min(MOST);
            let spacing_s = if count > 1 { spare_s / (count - 1) as f64 } else { 0.0 };
            let mut starts_s = room(count)?;
            let begins = (0..count).map(|place| first_s + place as f64 * spacing_s);
            starts_s.extend(begins.filter(|&start_s| steps.is_whole(start_s, start_s + duration_s)));
            let mut apart = 0;
            let mut free_s = f64::NEG_INFINITY;
            for &start_s in &starts_s {
                // A start that is early by rounding does not overlap.
                if start_s >= free_s - 1e-6 * duration_s {
                    apart += 1;
                    free_s = start_s + duration_s;
                }
            }
            if apart >= ROOM as usize {
                spans.push(Flights { duration_s, starts_s, apart });
            }
        }
        Ok(Self { spans })
    }
}
