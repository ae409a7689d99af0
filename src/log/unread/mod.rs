//! Columns of a table that are not read, as evidence: what they say of the motion is compared with what flies.

mod compare;
mod flown;
mod follows;

use csv::StringRecord;

use super::clock::Clock;
use super::columns::Columns;
use super::guess::guess;
use super::mapping::TimeFormat;
use super::quantity::{Dimension, HEADING, HEIGHT, QUANTITIES, RATE, SPEED, TIME, TRACK, VELOCITY, unit_of};
use super::rows::{is_missing, number};
use super::words::{unit_and_words, words};
use super::{FlightLog, LogMapping, Separator};
use crate::base::error::Error;
use crate::base::memory::room_for_one_more;
use crate::base::text::{Fault, excerpt};
use crate::judge::Finding;
use compare::{Said, compare};
use flown::Flown;

/// Most columns that are looked at, and most whose names a note has.
pub const MOST: usize = 24;
const MOST_NAMED: usize = 8;

/// What a name is like that does not say its quantity, by a word in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Like {
    Speed,
    Direction,
    Height,
}

const LIKE: [(Like, &[&str]); 3] = [
    (Like::Speed, &["vel", "speed", "spd", "geschw", "climb", "vario", "steig"]),
    (Like::Direction, &["course", "track", "kurs", "cog", "bearing", "heading", "hdg", "yaw"]),
    (Like::Height, &["alt", "height", "elevation", "hgt", "höhe", "hoehe"]),
];

/// A column of the motion that is not read.
#[derive(Debug, Clone, PartialEq)]
pub struct Unread {
    place: usize,
    name: String,
    /// The quantity that its name says.
    quantity: Option<usize>,
    /// What its name is like otherwise.
    like: Option<Like>,
    /// The unit that its name states; empty: none.
    unit: &'static str,
    /// The unit of the velocities that are read, which it may have too; empty: none is stated.
    beside: &'static str,
    /// -1: its name says that it has the opposite sign.
    sign: f64,
    /// Whether it is of a flight record: a speed is over ground, and the path through the rare rows may be shorter than the way.
    of_record: bool,
    /// How its times are written, as those of a column of the time.
    format: Option<TimeFormat>,
    /// The times of the rows [s], and its numbers there.
    values: Vec<[f64; 2]>,
}

/// The columns that are not read, while the rows are.
#[derive(Debug)]
pub struct Evidence {
    columns: Vec<(Unread, Clock)>,
    line: u64,
    separator: Separator,
    missing: Option<f64>,
}

impl Evidence {
    /// The columns of the names on `line`, but those that are read and that of the vehicles.
    pub fn new(
        names: &StringRecord,
        line: u64,
        columns: &Columns,
        mapping: &LogMapping,
        only: Option<usize>,
    ) -> Self {
        let is_read =
            |place: usize| only == Some(place) || columns.iter().flatten().any(|column| column.reads(place));
        let unread = names.iter().enumerate().filter(|(place, _)| !is_read(*place));
        let beside = mapping.columns[VELOCITY].unit;
        let of_motion = unread.filter_map(|(place, name)| {
            Some((Unread { beside, ..Unread::of(place, name)? }, clock(TimeFormat::Number)))
        });
        let separator = mapping.separator;
        Self { columns: of_motion.take(MOST).collect(), line, separator, missing: mapping.missing }
    }

    /// Those of a record, which are none of a table without names.
    pub fn of_record(columns: &[Unread]) -> Self {
        let columns = columns.iter().map(|column| (column.clone(), clock(TimeFormat::Number))).collect();
        Self { columns, line: 0, separator: Separator::Comma, missing: None }
    }

    /// Takes the numbers of a row of a record that is read, at its time.
    pub fn take_numbers(&mut self, row: &[f64], time_s: f64) -> Result<(), Error> {
        for (column, _) in &mut self.columns {
            if let Some(value) = row.get(column.place).filter(|value| value.is_finite()) {
                room_for_one_more(&mut column.values)?;
                column.values.push([time_s, *value]);
            }
        }
        Ok(())
    }

    /// Takes the cells of a row that is read, at its time.
    pub fn take(&mut self, row: &StringRecord, time_s: f64) -> Result<(), Error> {
        for (column, clock) in &mut self.columns {
            let Some(cell) = row.get(column.place).filter(|cell| !is_missing(cell, self.missing)) else {
                continue;
            };
            let Some(value) = column.value(cell, self.separator, clock) else { continue };
            room_for_one_more(&mut column.values)?;
            column.values.push([time_s, value]);
        }
        Ok(())
    }

    /// The columns with their numbers, and the line of their names.
    pub fn finish(self) -> (Vec<Unread>, u64) {
        (self.columns.into_iter().map(|(column, _)| column).collect(), self.line)
    }
}

fn clock(time_format: TimeFormat) -> Clock {
    Clock::new(&LogMapping { time_format, ..LogMapping::default() })
}

impl Unread {
    /// A column of a record, as its format defines it.
    pub fn defined(place: usize, name: &str, quantity: usize, unit: &'static str) -> Self {
        Self {
            place,
            name: name.to_owned(),
            quantity: Some(quantity),
            like: None,
            unit,
            beside: "",
            sign: 1.0,
            of_record: true,
            format: None,
            values: Vec::new(),
        }
    }

    /// A column of a record whose name says its quantity, but for the time. Its angles are in degrees.
    pub fn of_name(place: usize, name: &str) -> Option<Self> {
        let found = Self::of(place, name)?;
        let quantity = found.quantity.filter(|quantity| *quantity != TIME)?;
        let is_angle = QUANTITIES[quantity].dimension == Dimension::Angle;
        let unit = if is_angle && found.unit.is_empty() { "deg" } else { found.unit };
        Some(Self { of_record: true, unit, ..found })
    }

    /// That of a name; `None`: it is none of the motion.
    fn of(place: usize, name: &str) -> Option<Self> {
        let is_of_motion = |quantity: &usize| {
            matches!(*quantity, TIME | HEIGHT | HEADING)
                || (VELOCITY..RATE).contains(quantity)
                || (SPEED..TRACK + 2).contains(quantity)
        };
        // A letter without a unit is also a temperature, or a humidity.
        let is_letter = unit_and_words(name).1.concat().chars().count() == 1;
        let found = guess(name).filter(|found| !is_letter || !found.unit.is_empty());
        let like = || {
            let small = words(name).concat();
            let is_in = |(_, known): &&(Like, &[&str])| known.iter().any(|word| small.contains(word));
            let unit = unit_and_words(name).0;
            let of_motion = [Dimension::Angle, Dimension::Length, Dimension::Speed];
            let is_of_motion = unit.is_empty() || of_motion.iter().any(|its| unit_of(*its, unit).is_some());
            LIKE.iter().find(is_in).filter(|_| is_of_motion).map(|(like, _)| *like)
        };
        let (quantity, like, unit, sign) = match found {
            Some(found) if is_of_motion(&found.quantity) => {
                (Some(found.quantity), None, found.unit, found.sign)
            }
            None => (None, Some(like()?), unit_and_words(name).0, 1.0),
            Some(_) => return None,
        };
        Some(Self {
            place,
            name: name.to_owned(),
            quantity,
            like,
            unit,
            beside: "",
            sign,
            of_record: false,
            format: None,
            values: Vec::new(),
        })
    }

    /// The number of a cell; of a column of the time that is no number, the time.
    fn value(&mut self, cell: &str, separator: Separator, time: &mut Clock) -> Option<f64> {
        if self.quantity != Some(TIME) || self.format.is_none() && number(cell, separator).is_some() {
            return number(cell, separator);
        }
        if self.format.is_none() && self.values.is_empty() {
            let formats = [TimeFormat::Iso, TimeFormat::Hms];
            self.format = formats.into_iter().find(|format| clock(*format).next(cell).is_some());
            *time = clock(self.format?);
        }
        self.format.and_then(|_| time.next(cell))
    }
}

impl FlightLog {
    /// Compares the columns that are not read with the samples, which fly: adds a finding, and notes.
    pub(super) fn compared(mut self) -> Self {
        let (columns, line) = core::mem::take(&mut self.unread);
        let flown = Flown::new(&self.samples, self.has_attitude);
        let (mut contradicting, mut agreeing, mut other) = (Vec::new(), Vec::new(), Vec::new());
        for column in &columns {
            let name = excerpt(&column.name);
            match compare(column, &flown) {
                Said::Nothing => {}
                Said::Agrees(what) => agreeing.push(format!("{name} ({what})")),
                Said::Unlike => other.push(name),
                Said::Contradicts(how) => contradicting
                    .push((column, format!("{name} is not read, and contradicts what flies: {how}"))),
            }
        }
        let mut note = |column: usize, sentence: String| {
            self.notes.push(Fault { line: line as usize, column, sentence, ..Fault::default() });
        };
        for (column, sentence) in contradicting.iter().take(MOST_NAMED) {
            note(column.place + 1, sentence.clone());
        }
        if !agreeing.is_empty() {
            note(1, format!("not read, and in agreement with what flies: {}", named(&agreeing)));
        }
        if !other.is_empty() {
            // What a record has beside its positions cannot be named in [log].
            let asks = if columns[0].of_record { "" } else { "; is one of them a quantity of [log]?" };
            note(1, format!("not read, and other than what flies: {}{asks}", named(&other)));
        }
        if let Some((first, _)) = contradicting.first() {
            let what = first.quantity.map_or("", |quantity| match quantity {
                VELOCITY..RATE => ["velocity east", "velocity north", "velocity up"][quantity - VELOCITY],
                _ => QUANTITIES[quantity].key,
            });
            self.of_rows.push((Finding::of_unread(contradicting.len() as u64, what), line));
        }
        self
    }
}

/// Some names in a row.
fn named(names: &[String]) -> String {
    let more = names.len().saturating_sub(MOST_NAMED);
    let first = names[..names.len() - more].join(", ");
    if more == 0 { first } else { format!("{first} and {more} more") }
}
