//! The units of columns: what their names and lines of units do not say, their values do.

use csv::StringRecord;

use super::super::quantity::Dimension;
use super::super::rows::number;
use super::motion::{READINGS, Reading};
use super::times::SPEEDS;
use super::{Draft, FEW, largest};

/// Largest latitude, and largest angle \[rad\].
const QUARTER: f64 = core::f64::consts::FRAC_PI_2;
const TURN: f64 = 4.0 * QUARTER;

/// A position of which one part is this or more is not at 0, 0, in degrees and in radians.
const ELSEWHERE: f64 = 0.05;

/// Step of the heights that a transponder sends [ft], and the number of different ones that show it.
const TRANSPONDER_FT: f64 = 25.0;

impl Draft<'_> {
    /// The unit of a column that states none, by its values; empty: the usual one.
    pub(super) fn unstated(&mut self, key: &str, dimension: Dimension, name: &str) -> &'static str {
        let (unit, doubt) = match dimension {
            Dimension::Angle if key == "latitude" || key == "longitude" => match self.is_in_radians() {
                Some(true) => {
                    ("rad", format!("{name} is taken as radians: so it has the speed of a vehicle"))
                }
                Some(false) => return "",
                None => {
                    self.is_position_open = true;
                    return "";
                }
            },
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

    /// Whether the position is in radians, both parts in one unit; `None`: it may be in degrees near the equator and Greenwich too, and
    /// neither its speed nor that of the table tells.
    fn is_in_radians(&self) -> Option<bool> {
        let is_small = |key, most| self.numbers(key).is_some_and(|values| largest(&values) <= most);
        let latitudes = self.numbers("latitude").unwrap_or_default();
        let has_fractions = latitudes.iter().any(|angle| angle.fract() != 0.0);
        if !(is_small("latitude", QUARTER) && is_small("longitude", TURN) && has_fractions) {
            return Some(false);
        }
        let Some(motion) = self.motion() else { return Some(false) };
        if !motion.is_timed || self.value("time").is_none() || motion.is_at_rest() {
            return None;
        }
        let time_si = self.time_si();
        let fits = |reading: &Reading| motion.misfit(&motion.fit(reading, false, time_si)).is_some();
        let is_vehicle = |reading: &Reading| {
            motion.speed(reading, false, time_si).is_some_and(|speed| SPEEDS.contains(&speed))
        };
        let [degrees, radians] = [&READINGS[0], &READINGS[READINGS.len() - 1]];
        match (fits(degrees), fits(radians)) {
            (true, false) => Some(false),
            (false, true) => Some(true),
            _ => match (is_vehicle(degrees), is_vehicle(radians)) {
                (true, false) => Some(false),
                (false, true) => Some(true),
                _ => None,
            },
        }
    }

    /// Rows with 0, 0 in place of a position are those before the first fix, and left out if the first fix is elsewhere.
    pub(super) fn null_rows(&mut self) {
        let [Some(latitude), Some(longitude)] = ["latitude", "longitude"].map(|key| self.place(key)) else {
            return;
        };
        let grid = self.grid;
        let number = |row: &StringRecord, place: usize| number(row.get(place)?, grid.separator);
        let places: Vec<Option<[f64; 2]>> =
            grid.rows.iter().map(|row| Some([number(row, latitude)?, number(row, longitude)?])).collect();
        let is_null = |place: &Option<[f64; 2]>| *place == Some([0.0, 0.0]);
        let nulls = places.iter().filter(|place| is_null(place)).count();
        let fix = places.iter().position(|place| place.is_some() && !is_null(place));
        let Some((fix, place)) = fix.and_then(|fix| Some((fix, places[fix]?))) else {
            if nulls > 0 {
                self.doubt("the position is 0, 0 in each row that was looked at: the first fix may stand behind them");
            }
            return;
        };
        let before = places[..fix].iter().rposition(is_null).map_or(0, |last| last + 1);
        if largest(&place) < ELSEWHERE {
            return;
        }
        self.without_fix = before;
        let behind = nulls - places[..before].iter().filter(|place| is_null(place)).count();
        if before > 0 {
            self.doubt(format!(
                "the first {before} rows are left out: their position is 0, 0, as before a fix"
            ));
        }
        if behind > 0 {
            let rows = if behind == 1 { "row has" } else { "rows have" };
            self.doubt(format!("{behind} {rows} the position 0, 0 behind the first fix"));
        }
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
