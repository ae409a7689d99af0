//! The time and the units of columns: what their names and lines of units do not say, their values do.

use super::super::TimeFormat;
use super::super::quantity::{Dimension, unit_of};
use super::{Draft, FEW, clock, largest};
use crate::base::math::{hypot, sin_cos};
use crate::base::text::excerpt;
use crate::base::units::DEG;

/// Speeds over ground of vehicles \[m/s\], and the radius of the Earth \[m\], for comparisons.
const SPEEDS: core::ops::RangeInclusive<f64> = 0.3..=1000.0;
const RADIUS_M: f64 = 6.371e6;

/// Largest latitude, and largest angle \[rad\].
const QUARTER: f64 = core::f64::consts::FRAC_PI_2;
const TURN: f64 = 4.0 * QUARTER;

/// Step of the heights that a transponder sends [ft], and the number of different ones that show it.
const TRANSPONDER_FT: f64 = 25.0;

impl Draft<'_> {
    /// The keys of the time.
    pub(super) fn time(&mut self, place: usize, unit: &str) {
        let grid = self.grid;
        let name = excerpt(&grid.names[place]);
        let is_read = |cell: &str, format| clock(format).next(&grid.separator.with_point(cell)).is_some();
        let first = grid.cells(place).next().unwrap_or("0");
        let formats =
            [TimeFormat::Number, TimeFormat::Iso, TimeFormat::Dmy, TimeFormat::Mdy, TimeFormat::Hms];
        let mut format = formats.into_iter().find(|format| is_read(first, *format));
        if let Some(TimeFormat::Dmy | TimeFormat::Mdy) = format {
            let reads_alone =
                |one, other| grid.cells(place).any(|cell| is_read(cell, one) && !is_read(cell, other));
            let is_day_first = reads_alone(TimeFormat::Dmy, TimeFormat::Mdy);
            if !is_day_first && !reads_alone(TimeFormat::Mdy, TimeFormat::Dmy) {
                self.doubt(format!(
                    "{name} is taken as day, month, year: no day is above 12; otherwise time_format = \"mdy\""
                ));
            } else if !is_day_first {
                format = Some(TimeFormat::Mdy);
            }
        }
        match format.filter(|format| *format != TimeFormat::Hms || first.contains(':')) {
            None => return self.doubt(format!("{name} is no time that can be read: {}", excerpt(first))),
            Some(TimeFormat::Number) => {}
            Some(format) => {
                self.set("time", self.column(place, ""));
                let word =
                    TimeFormat::WORDS.iter().find(|(_, known)| *known == format).map_or("", |(word, _)| word);
                return self.set("time_format", format!("\"{word}\""));
            }
        }
        let stated = if unit.is_empty() {
            grid.stated(place).find(|unit| unit_of(Dimension::Time, unit).is_some())
        } else {
            Some(unit)
        };
        let unit = stated.unwrap_or_else(|| {
            let (unit, why) = self.unit_of_time(&grid.numbers(place));
            if unit != "s" {
                self.doubt(format!("{name} is taken as {unit}: {why}"));
            }
            unit
        });
        let unit = if unit == "s" { String::new() } else { format!(", unit = \"{unit}\"") };
        self.set("time", self.column(place, &unit));
    }

    /// The unit of times that state none, and why: the one that gives the speed of a vehicle, or at rest the one that its steps suggest.
    fn unit_of_time(&self, times: &[f64]) -> (&'static str, String) {
        for (unit, si) in [("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)] {
            if let Some(speed) = self.speed(DEG, si).filter(|speed| SPEEDS.contains(speed)) {
                return (unit, format!("the speed over ground is then {speed:.1} m/s"));
            }
        }
        let step =
            median(times.windows(2).map(|two| two[1] - two[0]).filter(|step| *step > 0.0)).unwrap_or(0.0);
        let unit = if step >= 3e6 {
            "ns"
        } else if step >= 3e3 {
            "us"
        } else if step >= 3.0 {
            "ms"
        } else {
            "s"
        };
        (unit, format!("its usual step is {step}"))
    }

    /// The unit of a column that states none, by its values; empty: the usual one.
    pub(super) fn unstated(&mut self, key: &str, dimension: Dimension, name: &str) -> &'static str {
        let (unit, doubt) = match dimension {
            Dimension::Angle if key == "latitude" || key == "longitude" => {
                // Both in one unit. Near the equator and Greenwich degrees are as small: the speed tells.
                let is_small = |key, most| self.numbers(key).is_some_and(|values| largest(&values) <= most);
                let is_slow = self.speed(1.0, 1.0).is_none_or(|speed| speed <= *SPEEDS.end());
                if !(is_small("latitude", QUARTER) && is_small("longitude", TURN) && is_slow) {
                    return "";
                }
                ("rad", format!("{name} is taken as radians: no latitude is above {QUARTER:.2}"))
            }
            Dimension::Angle if key != "variation" => {
                let angles: Vec<f64> = ["roll", "pitch", "heading", "track"]
                    .into_iter()
                    .filter_map(|key| self.numbers(key))
                    .flatten()
                    .collect();
                let has_fractions = angles.iter().any(|value| value.fract() != 0.0);
                if !has_fractions || largest(&angles) > TURN {
                    return "";
                }
                // A heading above 2 and never above a turn in radians.
                let of_position = self.value("latitude").is_some_and(|value| value.contains("\"rad\""));
                let is_radian =
                    of_position || self.numbers("heading").is_some_and(|values| largest(&values) > 2.0);
                let (unit, taken) = if is_radian { ("rad", "radians") } else { ("", "degrees") };
                (unit, format!("{name} is taken as {taken}: no angle of the attitude is above {TURN:.2}"))
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

    /// Whether the heights have the steps of a transponder.
    fn has_steps_of_feet(&self) -> bool {
        let heights = self.numbers("height").unwrap_or_default();
        let mut different = heights.clone();
        different.sort_by(f64::total_cmp);
        different.dedup();
        different.len() > FEW && heights.iter().all(|height| height % TRANSPONDER_FT == 0.0)
    }

    /// The median speed over ground, if positions are of this unit and times of that one \[m/s\].
    fn speed(&self, angle_si: f64, time_si: f64) -> Option<f64> {
        let (latitudes, longitudes, times) =
            (self.numbers("latitude")?, self.numbers("longitude")?, self.numbers("time")?);
        if latitudes.len() != times.len() || longitudes.len() != times.len() {
            return None;
        }
        let speed = |row: usize| {
            let step = |values: &[f64]| (values[row] - values[row - 1]) * angle_si;
            let (_, cos) = sin_cos(latitudes[row] * angle_si);
            RADIUS_M * hypot(step(&latitudes), step(&longitudes) * cos)
                / ((times[row] - times[row - 1]) * time_si)
        };
        median((1..times.len()).filter(|row| times[*row] > times[row - 1]).map(speed))
    }
}

fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}
