//! A look at a table: the `[log]` that reads it, of a known format or guessed from names, units and values.

mod attitude;
mod evidence;
mod formats;
mod height;
mod letters;
pub(super) mod motion;
mod near;
mod position;
mod quaternion;
mod stated;
mod times;
mod units;
mod vehicles;

use super::grid::Grid;
use super::guess::{Guess, guess};
use super::known::{Key, Known, Value, known};
use super::nameless::{nameless, rtklib};
use super::quantity::{Dimension, QUANTITIES, unit_of};
use super::text::decoded;
use super::{Clock, LogMapping, Separator, TimeFormat};
use crate::base::text::{MAX_TEXT_VALUE, excerpt, text_in_quotes};

pub use near::nearest_names;

/// What a table has.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// The format, if it is a known one.
    pub format: Option<&'static str>,
    /// Lines of `[log]`.
    pub text: String,
    /// What is not sure, in sentences.
    pub doubts: Vec<String>,
    /// What must be answered before the log flies: the text has no key for it.
    pub questions: Vec<Question>,
}

/// What a table does not say, and a flight needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// What is asked.
    pub sentence: String,
    /// Lines of `[log]`, each with what it would mean behind `#`; one of them is the answer.
    pub answers: Vec<String>,
}

/// Rate below which rows are smoothed \[Hz\]: at this rate a turn is seen by a few rows.
const SLOW_HZ: f64 = 10.0;

/// Fewest different heights that show the steps of a transponder, and rows that show a vehicle.
const FEW: usize = 5;

/// The quantities of each form of the velocity, and those of the attitude: all of them or none.
const VELOCITIES: [[&str; 3]; 2] = [["east", "north", "up"], ["speed", "track", "climb"]];
const ATTITUDE: [&str; 3] = ["roll", "pitch", "heading"];
const QUATERNION: [&str; 4] = ["q0", "q1", "q2", "q3"];

/// The `[log]` of a table; `None`: no line at its beginning has names of quantities, and its numbers are of no known format.
pub fn survey(table: &[u8]) -> Option<Survey> {
    let table = decoded(table).ok()?;
    if let Some(found) = rtklib(&table) {
        return Some(found);
    }
    let Some(grid) = Grid::of(&table) else { return nameless(&table) };
    let known = known(&grid.names);
    let (places, keys, doubts, questions) = Default::default();
    let mut draft = Draft {
        grid: &grid,
        places,
        keys,
        doubts,
        questions,
        open_time: None,
        is_position_open: false,
        is_attitude_asked: false,
        reading: 0,
        without_fix: 0,
    };
    match known {
        Some(known) => draft.of_known(known),
        None => draft.guess(),
    }
    if known.is_none() {
        draft.minutes_apart();
    }
    draft.position(known.is_some());
    if known.is_none() {
        draft.letters();
        draft.attitude();
        draft.quaternion();
    }
    draft.null_rows();
    draft.height(known.is_some());
    if known.is_none() {
        draft.unknown_units();
        draft.attitude_like();
    }
    draft.only_one();
    draft.complete();
    let text = draft.layout().chain(draft.keys).map(|(key, value)| format!("{key} = {value}\n")).collect();
    let format = known.map(|known| known.name);
    Some(Survey { format, text, doubts: draft.doubts, questions: draft.questions })
}

/// The column of a quantity.
struct Place {
    key: &'static str,
    place: usize,
    /// What its name or a line of units states; empty: nothing.
    unit: &'static str,
    /// The part of its cells, from 1; 0: all of them.
    part: usize,
    /// The columns of its minutes and seconds.
    sixtieths: [Option<usize>; 2],
}

/// The keys of `[log]`, while they are found.
struct Draft<'g> {
    grid: &'g Grid,
    /// The column of each quantity that has one.
    places: Vec<Place>,
    /// Each with its value in TOML.
    keys: Vec<(&'static str, String)>,
    doubts: Vec<String>,
    questions: Vec<Question>,
    /// The column of the time, if its meaning is to be asked, and the question.
    open_time: Option<(usize, String)>,
    /// Whether the position may be in degrees and in radians.
    is_position_open: bool,
    is_attitude_asked: bool,
    /// How the position is read, by its place in the readings.
    reading: usize,
    /// Rows before the first fix that are left out.
    without_fix: usize,
}

impl Draft<'_> {
    fn value(&self, key: &str) -> Option<&str> {
        self.keys.iter().find(|(known, _)| *known == key).map(|(_, value)| value.as_str())
    }

    fn has_all(&self, keys: &[&str]) -> bool {
        keys.iter().all(|key| self.value(key).is_some())
    }

    fn set(&mut self, key: &'static str, value: impl Into<String>) {
        self.keys.push((key, value.into()));
    }

    /// Sets a key that has a value to another one.
    fn replace(&mut self, key: &str, value: String) {
        let old = self.keys.iter_mut().filter(|(known, _)| *known == key);
        old.for_each(|(_, old)| old.clone_from(&value));
    }

    fn remove(&mut self, key: &str) {
        self.keys.retain(|(known, _)| *known != key);
    }

    /// Takes back what was said of the unit of a quantity that is not read.
    fn forget_unit(&mut self, key: &str) {
        let Some(place) = self.place(key) else { return };
        let taken = format!("{} is taken as ", excerpt(&self.grid.names[place]));
        self.doubts.retain(|doubt| !doubt.starts_with(&taken));
    }

    fn ask(&mut self, question: Question) {
        self.questions.push(question);
    }

    fn add_place(&mut self, key: &'static str, place: usize, unit: &str) {
        let dimension =
            QUANTITIES.iter().find(|quantity| quantity.key == key).map(|quantity| quantity.dimension);
        let unit = Some(unit).filter(|unit| !unit.is_empty());
        let unit = unit.zip(dimension).and_then(|(unit, dimension)| unit_of(dimension, unit));
        self.places.push(Place {
            key,
            place,
            unit: unit.map_or("", |(unit, _)| unit),
            part: 0,
            sixtieths: [None; 2],
        });
    }

    fn doubt(&mut self, sentence: impl Into<String>) {
        self.doubts.push(sentence.into());
    }

    /// The keys of a known format, as far as their columns are there.
    fn of_known(&mut self, known: &'static Known) {
        for Key { name: key, value } in known.keys {
            if let Value::Column { name: column, unit, part, .. } = *value {
                let place = self.grid.names.iter().position(|name| name == column);
                let Some(place) = place.filter(|_| self.value(key).is_none()) else { continue };
                self.places.push(Place { key, place, unit, part, sixtieths: [None; 2] });
            }
            self.set(key, value.text());
        }
        if !known.doubt.is_empty() {
            self.doubt(known.doubt);
        }
    }

    /// Keys from the names of the columns.
    fn guess(&mut self) {
        let guesses = self.grid.names.iter().enumerate();
        let mut guesses: Vec<(Guess, usize)> =
            guesses.filter_map(|(place, name)| Some((guess(name)?, place))).collect();
        guesses.sort_by_key(|(guess, _)| (guess.quantity, guess.rank));
        let of_quantities: Vec<_> =
            guesses.chunk_by(|(one, _), (other, _)| one.quantity == other.quantity).collect();
        let mut of_time: &[(Guess, usize)] = &[];
        for them in &of_quantities {
            let (guess, place) = them[0];
            let about = &QUANTITIES[guess.quantity];
            if about.dimension == Dimension::Time {
                of_time = them;
                continue;
            }
            let stated = self.stated(guess.unit, about.dimension, place);
            self.add_place(about.key, place, stated.unwrap_or(""));
        }
        self.times(of_time);
        for them in of_quantities {
            let Some((&(guess, place), others)) = them.split_first() else { continue };
            let about = &QUANTITIES[guess.quantity];
            if about.dimension == Dimension::Time {
                continue;
            }
            let name = excerpt(&self.grid.names[place]);
            for (_, other) in others {
                self.doubt(format!(
                    "{}: column {} ({name}) is taken, column {} ({}) is not",
                    about.key,
                    place + 1,
                    other + 1,
                    excerpt(&self.grid.names[*other])
                ));
            }
            if about.key == "variation" && !["heading", "track"].iter().any(|key| self.is_magnetic(key)) {
                self.doubt(format!("{name} is not used: no name says that the heading is magnetic"));
                continue;
            }
            let unit = self.stated(guess.unit, about.dimension, place);
            let unit = unit.unwrap_or_else(|| self.unstated(about.key, about.dimension, &name));
            let is_usual =
                unit.is_empty() || unit_of(about.dimension, "").is_some_and(|(usual, _)| usual == unit);
            let unit = if is_usual { String::new() } else { format!(", unit = \"{unit}\"") };
            let sign = if guess.sign < 0.0 { ", sign = -1" } else { "" };
            let hemisphere = self.hemisphere(guess.quantity, place).map_or(String::new(), |letters| {
                format!(", hemisphere = {}", self.named_or_numbered(letters))
            });
            self.set(about.key, self.column(place, &format!("{unit}{sign}{hemisphere}")));
            let lower = self.grid.names[place].to_lowercase();
            if about.key == "height" && !lower.contains("wgs") && !lower.contains("ellips") {
                self.doubt(format!("{name} may be above the sea: set geoid if it matters"));
            }
        }
        if self.value("variation").is_none() && self.is_magnetic("heading") {
            self.doubt("the heading may be magnetic: set variation");
        }
    }

    /// The unit of a column that its name or a line of units states.
    fn stated(&self, of_name: &'static str, dimension: Dimension, place: usize) -> Option<&'static str> {
        let of_lines =
            || self.grid.stated(place).find_map(|unit| unit_of(dimension, unit)).map(|(unit, _)| unit);
        Some(of_name).filter(|unit| !unit.is_empty()).or_else(of_lines)
    }

    /// A column in TOML: its name, or its number if another has the same name or a scene cannot write it.
    fn named_or_numbered(&self, place: usize) -> String {
        let name = &self.grid.names[place];
        let is_single = self.grid.names.iter().filter(|other| *other == name).count() == 1;
        let is_written =
            !name.is_empty() && name.len() <= MAX_TEXT_VALUE && !name.chars().any(char::is_control);
        if is_single && is_written { text_in_quotes(name) } else { (place + 1).to_string() }
    }

    /// The value of a key: a column, with more than its place.
    fn column(&self, place: usize, more: &str) -> String {
        let column = self.named_or_numbered(place);
        // A number alone would be a constant.
        let is_named = column.starts_with('"');
        if is_named && more.is_empty() { column } else { format!("{{ col = {column}{more} }}") }
    }

    /// Whether the name of a quantity's column says that it counts from magnetic north.
    fn is_magnetic(&self, key: &str) -> bool {
        let name = self.place(key).map_or(String::new(), |place| self.grid.names[place].to_lowercase());
        name.contains("mag") || name.contains("compass") || name == "hdg"
    }

    /// Quantities that come together, those that every flight has, and the repair of what is slow or lacks an attitude.
    fn complete(&mut self) {
        for group in VELOCITIES.into_iter().chain([ATTITUDE]) {
            let (found, lacking): (Vec<&str>, Vec<&str>) =
                group.into_iter().partition(|key| self.value(key).is_some());
            let is_second = group == VELOCITIES[1] && self.has_all(&VELOCITIES[0]);
            if found.is_empty() || (lacking.is_empty() && !is_second) {
                continue;
            }
            self.keys.retain(|(key, _)| !found.contains(key));
            found.iter().for_each(|key| self.forget_unit(key));
            let why = if is_second {
                "east, north and up are the velocity".to_owned()
            } else {
                format!("there is no {}", lacking.join(", "))
            };
            self.doubt(format!("left out: {}; {why}", found.join(", ")));
        }
        for key in ["latitude", "longitude"] {
            if self.place(key).is_none() {
                self.ask_for_column(key);
            }
        }
        let has_attitude = self.has_all(&ATTITUDE) || self.has_all(&QUATERNION) || self.is_attitude_asked;
        if self.value("attitude").is_none() && !has_attitude {
            self.set("attitude", "\"coordinated\"");
            self.doubt("no whole attitude is read: that of a coordinated flight without wind is taken");
        }
        let is_slow = self.rate_hz().is_some_and(|rate| rate < SLOW_HZ);
        if self.value("smooth").is_none() && (is_slow || self.value("attitude").is_some()) {
            self.set("smooth", "\"auto\"");
        }
        match self.open_time.take() {
            Some((place, sentence)) => self.ask_what_time(place, sentence),
            None if self.place("time").is_none() && self.value("time").is_none() => self.ask_for_time(),
            None => {}
        }
    }

    /// The keys about separator, comments and lines.
    fn layout(&self) -> impl Iterator<Item = (&'static str, String)> + use<> {
        let grid = self.grid;
        let word = Separator::WORDS
            .iter()
            .find(|(_, separator)| *separator == grid.separator)
            .map_or("", |(word, _)| word);
        let numbers = |number: usize, usual: usize| {
            Some(number).filter(|number| *number > usual).map(|number| number.to_string())
        };
        let separator = (grid.separator != Separator::Comma).then(|| format!("\"{word}\""));
        let comment = (grid.comment != '#').then(|| format!("\"{}\"", grid.comment));
        let keys = [
            ("separator", separator),
            ("comment", comment),
            ("header", numbers(grid.header, 1)),
            ("skip", numbers(grid.skip + self.without_fix, 0)),
        ];
        keys.into_iter().filter_map(|(key, value)| Some((key, value?)))
    }

    /// The mean rate of the rows.
    fn rate_hz(&self) -> Option<f64> {
        let place = self.place("time").filter(|_| self.open_time.is_none())?;
        Some(self.rate_over(place, self.format_of_time())? / self.time_si())
    }

    /// The place of the column of a quantity.
    fn place(&self, key: &str) -> Option<usize> {
        self.found(key).map(|found| found.place)
    }

    fn found(&self, key: &str) -> Option<&Place> {
        self.places.iter().find(|found| found.key == key)
    }

    /// The numbers of a quantity, if there are any.
    fn numbers(&self, key: &str) -> Option<Vec<f64>> {
        self.place(key).map(|place| self.grid.numbers(place)).filter(|values| !values.is_empty())
    }
}

fn clock(time_format: TimeFormat) -> Clock {
    Clock::new(&LogMapping { time_format, ..LogMapping::default() })
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

#[cfg(test)]
pub mod tests;
