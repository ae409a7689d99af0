//! The numbers of a table row by row: what each column says of the motion.

use csv::StringRecord;

use super::super::hemisphere::signed;
use super::super::quantity::{Dimension, LATITUDE, LONGITUDE, unit_of, units_of};
use super::super::rows::{is_missing, number, part_of};
use super::super::{TimeFormat, sides};
use super::motion::{Motion, Row, SLOWEST_UNIT};
use super::{Draft, Question, clock};
use crate::base::math::{atan2, hypot};
use crate::base::text::nearest;

/// Largest number of columns that a question names.
const MOST: usize = 3;

impl Draft<'_> {
    /// The format of the time that is found.
    pub(super) fn format_of_time(&self) -> TimeFormat {
        let word = self.value("time_format").map_or("s", |quoted| quoted.trim_matches('"'));
        let found = TimeFormat::WORDS.iter().find(|(known, _)| *known == word);
        found.map_or(TimeFormat::Number, |(_, format)| *format)
    }

    /// The unit of the time that is found [s].
    pub(super) fn time_si(&self) -> f64 {
        let column = self.value("time").unwrap_or_default();
        if column.contains(", scale = 1e-4") {
            return 1e-4;
        }
        let mut units = units_of(Dimension::Time);
        let unit = units.find(|unit| column.contains(&format!("unit = \"{unit}\"")));
        unit_of(Dimension::Time, unit.unwrap_or("s")).map_or(1.0, |(_, si)| si)
    }

    /// The motion of the table; `None`: it has no positions.
    pub(super) fn motion(&self) -> Option<Motion> {
        self.motion_over(self.place("time").map(|place| (place, self.format_of_time())))
    }

    /// The motion over the times in this column, or over the number of the row.
    pub(super) fn motion_over(&self, time: Option<(usize, TimeFormat)>) -> Option<Motion> {
        self.motion_of(time, |cells| self.number_of(cells, "heading"))
    }

    /// The motion of the table with another heading.
    pub(super) fn motion_with(&self, heading: impl Fn(&StringRecord) -> Option<f64>) -> Option<Motion> {
        self.motion_of(self.place("time").map(|place| (place, self.format_of_time())), heading)
    }

    fn motion_of(
        &self,
        time: Option<(usize, TimeFormat)>,
        heading: impl Fn(&StringRecord) -> Option<f64>,
    ) -> Option<Motion> {
        let mut clock = clock(time.map_or(TimeFormat::Number, |(_, format)| format));
        let velocity = self.found("east").zip(self.found("north"));
        let si = |unit: &str| unit_of(Dimension::Speed, unit).map_or(1.0, |(_, si)| si);
        let of_speed = self.found("speed");
        let unit = velocity.map(|(east, _)| east.unit).or(of_speed.map(|speed| speed.unit));
        let speed_units: Vec<f64> = match unit {
            Some("") => units_of(Dimension::Speed).map(si).filter(|si| *si >= SLOWEST_UNIT).collect(),
            _ => vec![1.0],
        };
        let speed_si = unit.map_or(1.0, si);
        let unit = self.found("track").map_or("", |track| track.unit);
        let unit = if unit.is_empty() && self.is_small("track") { "rad" } else { unit };
        let (_, track_si) = unit_of(Dimension::Angle, unit)?;
        let letters = [("latitude", LATITUDE), ("longitude", LONGITUDE)]
            .map(|(key, quantity)| self.place(key).and_then(|place| self.hemisphere(quantity, place)));
        let row = |(index, cells): (usize, &StringRecord)| {
            let time = match time {
                None => index as f64,
                Some((place, _)) => clock.next(&self.grid.separator.with_point(cells.get(place)?))?,
            };
            let latitude = self.coordinate(cells, "latitude", LATITUDE, letters[0])?;
            let longitude = self.coordinate(cells, "longitude", LONGITUDE, letters[1])?;
            let value = |key| self.number_of(cells, key).unwrap_or(f64::NAN);
            let (speed, course) = match velocity {
                Some(_) => {
                    let [east, north] = ["east", "north"].map(value);
                    (hypot(east, north), atan2(east, north))
                }
                None => (value("speed"), value("track") * track_si),
            };
            let heading = heading(cells).unwrap_or(f64::NAN);
            // So a row without a fix is written.
            let has_fix = latitude != 0.0 || longitude != 0.0;
            has_fix.then_some(Row { time, latitude, longitude, speed: speed * speed_si, course, heading })
        };
        let rows: Vec<Row> = self.grid.rows.iter().enumerate().filter_map(row).collect();
        (rows.len() > 1).then(|| Motion::new(rows, time.is_some(), speed_units))
    }

    /// The number of a quantity in a row.
    pub(super) fn number_of(&self, cells: &StringRecord, key: &str) -> Option<f64> {
        let found = self.found(key)?;
        number(part_of(cells.get(found.place)?, found.part)?, self.grid.separator)
    }

    /// A latitude or a longitude in a row, with the sign of its letter.
    fn coordinate(
        &self,
        cells: &StringRecord,
        key: &str,
        quantity: usize,
        letter: Option<usize>,
    ) -> Option<f64> {
        let found = self.found(key)?;
        let cell = part_of(cells.get(found.place)?, found.part).filter(|cell| !is_missing(cell, None))?;
        let letter = letter.map(|place| (place, cells.get(place).unwrap_or_default()));
        let degrees =
            signed((found.place, cell), letter, sides(quantity)?, self.grid.separator).ok().flatten()?;
        let mut size = degrees.abs();
        for (place, part) in found.sixtieths.iter().zip([60.0, 3600.0]) {
            let Some(place) = *place else { continue };
            size += number(cells.get(place)?, self.grid.separator)? / part;
        }
        Some(size.copysign(degrees))
    }

    /// Asks for the column of a quantity, and names those whose names are near.
    pub(super) fn ask_for_column(&mut self, key: &'static str) {
        let names = self.grid.names.iter();
        let begin = key.get(..3).unwrap_or(key);
        let is_like = |name: &str| name.to_lowercase().contains(begin);
        let like = names.clone().enumerate().filter(|(_, name)| is_like(name)).map(|(place, _)| place);
        let mut places: Vec<usize> = like.take(MOST).collect();
        if places.is_empty() {
            let near = nearest(key, names.clone());
            places.extend(near.and_then(|near| names.clone().position(|name| name == near)));
        }
        let mut answers: Vec<String> =
            places.iter().map(|place| format!("{key} = {}", self.column(*place, ""))).collect();
        if answers.is_empty() {
            answers.push(format!("{key} = \"COLUMN\""));
        }
        self.ask(Question { sentence: format!("no column is understood as the {key}"), answers });
    }
}
