//! Tables of several vehicles, of which one is read.

use csv::StringRecord;

use super::super::rows::number;
use super::{Draft, FEW};
use crate::base::math::hypot;
use crate::base::text::{MAX_TEXT_VALUE, excerpt, text_in_quotes};

/// Names of columns that tell vehicles apart.
const VEHICLES: [&str; 15] = [
    "icao24",
    "icao",
    "hex",
    "hexident",
    "callsign",
    "registration",
    "tail",
    "tailnumber",
    "aircraft",
    "aircraftid",
    "vehicle",
    "vehicleid",
    "mmsi",
    "deviceid",
    "id",
];

/// A step of this many of the largest ones of a path is one of the path.
const NEAR: f64 = 5.0;

impl Draft<'_> {
    /// The rows of one vehicle, if a column tells several apart: of the first one that has most.
    pub(super) fn only_one(&mut self) {
        let grid = self.grid;
        let letters = |name: &str| name.chars().filter(|letter| letter.is_alphanumeric()).collect::<String>();
        let place_of =
            |known: &&str| grid.names.iter().position(|name| letters(name).to_lowercase() == *known);
        let Some(place) = VEHICLES.iter().find_map(place_of) else { return };
        let mut cells: Vec<&str> = grid.cells(place).collect();
        cells.sort_unstable();
        let vehicles: Vec<&[&str]> = cells.chunk_by(|one, other| one == other).collect();
        let Some(most) = vehicles
            .iter()
            .min_by_key(|rows| core::cmp::Reverse(rows.len()))
            .filter(|most| vehicles.len() > 1 && most.len() > FEW)
        else {
            return;
        };
        let name = excerpt(&grid.names[place]);
        if self.is_one_path(place, vehicles.len()) {
            self.doubt(format!("{name} numbers {} parts of one path: all rows are read", vehicles.len()));
            return;
        }
        let (column, only) = (self.named_or_numbered(place), most[0]);
        let is_written = only.len() <= MAX_TEXT_VALUE && !only.chars().any(char::is_control);
        // A key of a text takes no number.
        if !column.starts_with('"') || !is_written {
            return;
        }
        self.doubt(format!(
            "{name} has {} vehicles: the rows of {} are read; only = ... takes another",
            vehicles.len(),
            excerpt(only)
        ));
        self.set("only_column", column);
        self.set("only", text_in_quotes(only));
    }

    /// Whether the rows of each of `count` cells of a column follow each other, and the path goes on from one to the next.
    fn is_one_path(&self, place: usize, count: usize) -> bool {
        let keys = ["latitude", "longitude"].map(|key| self.place(key));
        let [Some(latitude), Some(longitude)] = keys else { return false };
        let value = |row: &StringRecord, place: usize| number(row.get(place)?, self.grid.separator);
        let rows = self
            .grid
            .rows
            .iter()
            .filter_map(|row| Some((row.get(place)?, value(row, latitude)?, value(row, longitude)?)));
        let rows: Vec<(&str, f64, f64)> = rows.collect();
        let step = |two: &[(&str, f64, f64)]| hypot(two[1].1 - two[0].1, two[1].2 - two[0].2);
        let (within, between): (Vec<_>, Vec<_>) = rows.windows(2).partition(|two| two[0].0 == two[1].0);
        let usual = within.iter().map(|two| step(two)).fold(0.0, f64::max);
        between.len() + 1 == count && between.iter().all(|two| step(two) <= NEAR * usual)
    }
}
