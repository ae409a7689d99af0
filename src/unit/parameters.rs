//! Times and limits of a unit, from their table.

use super::table::UNIT;
use crate::base::error::Error;
use crate::base::parameter::Range;
use crate::base::rows::check;
use crate::base::snapshot::stored;

// The struct with its checks and numbers, which build.rs writes from the table.
include!(concat!(env!("OUT_DIR"), "/unit.rs"));

impl UnitParameters {
    /// The same with the defaults of the table in place of zeros.
    pub(super) fn with_defaults(mut self) -> Self {
        for (row, number) in UNIT.iter().zip(self.numbers_mut()) {
            match row.field.range {
                Range::OrDefault(default, ..) if *number == 0.0 => *number = default,
                _ => {}
            }
        }
        self
    }

    /// Length of a whole alignment at `latitude_rad` \[s\].
    pub(super) fn alignment_at_s(&self, latitude_rad: f64) -> f64 {
        if self.alignment_s != 0.0 {
            return self.alignment_s;
        }
        let degrees = latitude_rad.to_degrees();
        60.0 * (5.0 + 0.002 * degrees * degrees)
    }
}
