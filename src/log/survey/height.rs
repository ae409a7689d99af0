//! Heights that the table has not, that state no unit where two are usual, or that are none of a flight.

use super::super::quantity::{Dimension, unit_of};
use super::super::words::{unit_in_name, words};
use super::{Draft, Question, largest};
use crate::base::text::excerpt;

/// The largest height of a flight \[m\].
const HIGHEST_M: f64 = 1e5;

/// Below it is no land, also where the ellipsoid is above the sea \[m\].
const DEEPEST_M: f64 = 550.0;

/// Words in the names of heights, and names of flight levels, which count hundreds of feet.
const LIKE: [&str; 6] = ["alt", "height", "elev", "hgt", "höhe", "hoehe"];
const LEVELS: [&str; 2] = ["fl", "flightlevel"];
const LEVEL: (&str, f64) = (", scale = 30.48", 30.48);
const HIGHEST_LEVEL: f64 = 660.0;

/// Names of ADS-B, whose heights are in feet in most files.
const OF_TRANSPONDERS: [&str; 2] = ["altgeom", "altbaro"];

/// Largest number of columns that a question names.
const MOST: usize = 4;

impl Draft<'_> {
    /// Asks for a height that the table has not, or that nothing states whole.
    pub(super) fn height(&mut self, is_known: bool) {
        let Some(place) = self.place("height").filter(|_| self.value("height").is_some()) else {
            return self.ask_for_height();
        };
        let is_stated = self.found("height").is_some_and(|found| !found.unit.is_empty());
        let is_in_feet = self.value("height").is_some_and(|value| value.contains("\"ft\""));
        let name = &self.grid.names[place];
        let is_of_transponder = OF_TRANSPONDERS.contains(&words(name).concat().as_str());
        let name = excerpt(name);
        let numbers = self.numbers("height").unwrap_or_default();
        let highest = largest(&numbers);
        let unit = if is_in_feet { "ft" } else { self.found("height").map_or("", |found| found.unit) };
        let size = unit_of(Dimension::Length, unit).map_or(1.0, |(_, size)| size);
        let is_below = numbers.iter().all(|height| *height < 0.0) && highest * size > DEEPEST_M;
        let is_ground = name.to_lowercase().contains("elev");
        let other = self.other_height(place).filter(|_| is_ground);
        let answer =
            |(unit, size): (&str, f64)| self.answer_of_height(place, &format!(", unit = \"{unit}\""), size);
        let (mut answers, sentence) = if is_of_transponder && !is_known && !is_stated && !is_in_feet {
            let answers = [("ft", 0.3048), ("m", 1.0)].map(answer).to_vec();
            (answers, format!("{name} is in feet in most tables: what is its unit?"))
        } else if is_below {
            let part = if unit.is_empty() { String::new() } else { format!(", unit = \"{unit}\"") };
            let down =
                format!("height = {}  # it counts down", self.column(place, &format!("{part}, sign = -1")));
            let up = format!("height = {}  # under water", self.column(place, &part));
            (vec![down, up], format!("{name} is below any land: {:.0} m", -highest * size))
        } else if let Some(other) = other.filter(|_| !is_known) {
            let of = |place: usize| self.answers_of(place);
            let answers = [place, other].into_iter().flat_map(of).collect();
            (
                answers,
                format!("{name} may be that of the ground, beside {}", excerpt(&self.grid.names[other])),
            )
        } else if !is_stated && !is_in_feet && !is_known && highest <= HIGHEST_M && self.has_knots() {
            let mut answers = [("ft", 0.3048), ("m", 1.0)].map(answer).to_vec();
            if highest < HIGHEST_LEVEL {
                answers.push(self.answer_of_height(place, LEVEL.0, LEVEL.1));
            }
            (answers, format!("{name} has no unit, and other columns have knots or feet per minute"))
        } else if !is_stated && highest > HIGHEST_M {
            let units = [("mm", 1e-3), ("cm", 1e-2), ("ft", 0.3048)];
            let is_flown = |(_, size): &(&str, f64)| highest * size <= HIGHEST_M;
            let answers = units.into_iter().filter(is_flown).map(answer).collect();
            (answers, format!("{name} is above 100 km in m"))
        } else {
            return;
        };
        if highest > HIGHEST_M {
            answers.retain(|answer| !answer.contains("\"m\""));
            answers.push(format!("height = {}  # an orbit", self.column(place, ", unit = \"m\"")));
        }
        self.remove("height");
        self.forget_unit("height");
        self.ask(Question { sentence, answers });
    }

    /// Columns whose names are like those of heights, and that are not read.
    fn like_heights(&self) -> impl Iterator<Item = usize> + '_ {
        let is_like = |name: &str| {
            let lower = name.to_lowercase();
            is_level(name) || LIKE.iter().any(|word| lower.contains(word))
        };
        let is_read = |place: usize| self.places.iter().any(|found| found.place == place);
        let names = self.grid.names.iter().enumerate();
        names.filter(move |(place, name)| is_like(name) && !is_read(*place)).map(|(place, _)| place)
    }

    /// A height beside the one that is read, of numbers.
    fn other_height(&self, place: usize) -> Option<usize> {
        let is_other = |other: &usize| {
            let is_ground = self.grid.names[*other].to_lowercase().contains("elev");
            *other != place && !is_ground && self.has_numbers(*other)
        };
        self.like_heights().find(is_other)
    }

    /// Whether a column of the table has knots or feet per minute.
    fn has_knots(&self) -> bool {
        let unit = |name: &str| unit_in_name(name, Dimension::Speed);
        self.grid.names.iter().any(|name| matches!(unit(name), Some("kt" | "ft/min")))
    }

    /// What a column would mean as the height.
    fn answers_of(&self, place: usize) -> Vec<String> {
        let name = &self.grid.names[place];
        match unit_in_name(name, Dimension::Length) {
            _ if is_level(name) => vec![self.answer_of_height(place, LEVEL.0, LEVEL.1)],
            Some(unit) => {
                let (_, size) = unit_of(Dimension::Length, unit).unwrap_or(("m", 1.0));
                vec![self.answer_of_height(place, &format!(", unit = \"{unit}\""), size)]
            }
            None => vec![
                self.answer_of_height(place, "", 1.0),
                self.answer_of_height(place, ", unit = \"ft\"", 0.3048),
            ],
        }
    }

    fn ask_for_height(&mut self) {
        let like = self.like_heights().take(MOST);
        let mut answers: Vec<String> = like.flat_map(|place| self.answers_of(place)).collect();
        answers.push("height = 0  # all the way".to_owned());
        self.ask(Question { sentence: "no column is understood as the height".to_owned(), answers });
    }

    /// A column of heights in a unit of this size \[m\], with where it begins.
    fn answer_of_height(&self, place: usize, part: &str, size: f64) -> String {
        let first = self.grid.numbers(place).first().map(|first| first * size);
        let begins = first.map_or("no number".to_owned(), |first| format!("begins at {first:.1} m"));
        format!("height = {}  # {begins}", self.column(place, part))
    }
}

/// Whether a name is that of flight levels.
fn is_level(name: &str) -> bool {
    LEVELS.contains(&words(name).concat().as_str())
}
