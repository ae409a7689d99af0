//! The units of columns: what their names and lines of units do not say, their values do.

use super::super::quantity::Dimension;
use super::motion::READINGS;
use super::times::SPEEDS;
use super::{Draft, FEW, largest};

/// Largest latitude, and largest angle \[rad\].
const QUARTER: f64 = core::f64::consts::FRAC_PI_2;
const TURN: f64 = 4.0 * QUARTER;

/// Step of the heights that a transponder sends [ft], and the number of different ones that show it.
const TRANSPONDER_FT: f64 = 25.0;

impl Draft<'_> {
    /// The unit of a column that states none, by its values; empty: the usual one.
    pub(super) fn unstated(&mut self, key: &str, dimension: Dimension, name: &str) -> &'static str {
        let (unit, doubt) = match dimension {
            Dimension::Angle if key == "latitude" || key == "longitude" => {
                // Both in one unit. Near the equator and Greenwich degrees are as small: the speed tells.
                let is_small = |key, most| self.numbers(key).is_some_and(|values| largest(&values) <= most);
                let radians = &READINGS[READINGS.len() - 1];
                let speed = self.motion().and_then(|motion| motion.speed(radians, false, self.time_si()));
                let is_slow = speed.is_none_or(|speed| speed <= *SPEEDS.end());
                if !(is_small("latitude", QUARTER) && is_small("longitude", TURN) && is_slow) {
                    return "";
                }
                ("rad", format!("{name} is taken as radians: no latitude is above {QUARTER:.2}"))
            }
            Dimension::Angle if key == "track" && self.is_small(key) => {
                ("rad", format!("{name} is taken as radians: no value is above {TURN:.2}"))
            }
            Dimension::Length if key == "height" && self.has_steps_of_feet() => (
                "ft",
                format!(
                    "{name} is taken as ft: its values are multiples of {TRANSPONDER_FT}, as a transponder's are"
                ),
            ),
            Dimension::Length => ("", format!("{name} is taken as m: nothing states its unit")),
            Dimension::Speed => ("", format!("{name} is taken as m/s: nothing states its unit")),
            _ => return "",
        };
        self.doubt(doubt);
        unit
    }

    /// Whether the angles of a quantity are those of radians: none is above a turn, and some have fractions.
    pub(super) fn is_small(&self, key: &str) -> bool {
        let angles = self.numbers(key).unwrap_or_default();
        largest(&angles) <= TURN && angles.iter().any(|angle| angle.fract() != 0.0)
    }

    /// Whether the heights have the steps of a transponder.
    fn has_steps_of_feet(&self) -> bool {
        let heights = self.numbers("height").unwrap_or_default();
        let mut different = heights.clone();
        different.sort_by(f64::total_cmp);
        different.dedup();
        different.len() > FEW && heights.iter().all(|height| height % TRANSPONDER_FT == 0.0)
    }
}
