//! Heights that the table has not, that state no unit where two are usual, or that are none of a flight.

use super::super::quantity::{Dimension, unit_of};
use super::super::words::{unit_in_name, words};
use super::{Draft, Question, largest};
use crate::base::text::excerpt;

/// The largest height of a flight \[m\].
const HIGHEST_M: f64 = 1e5;

/// Words in the names of heights, and names of flight levels, which count hundreds of feet.
const LIKE: [&str; 6] = ["alt", "height", "elev", "hgt", "höhe", "hoehe"];
const LEVELS: [&str; 2] = ["fl", "flightlevel"];
const LEVEL: (&str, f64) = (", scale = 30.48", 30.48);

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
        let highest = largest(&self.numbers("height").unwrap_or_default());
        let answer =
            |(unit, size): (&str, f64)| self.answer_of_height(place, &format!(", unit = \"{unit}\""), size);
        let (mut answers, sentence) = if is_of_transponder && !is_known && !is_stated && !is_in_feet {
            let answers = [("ft", 0.3048), ("m", 1.0)].map(answer).to_vec();
            (answers, format!("{name} is in feet in most tables: what is its unit?"))
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

    fn ask_for_height(&mut self) {
        let grid = self.grid;
        let read: Vec<usize> = self.places.iter().map(|found| found.place).collect();
        let is_level = |name: &str| LEVELS.contains(&words(name).concat().as_str());
        let is_like = |name: &str| {
            let lower = name.to_lowercase();
            is_level(name) || LIKE.iter().any(|word| lower.contains(word))
        };
        let names = grid.names.iter().enumerate();
        let like = names.filter(|(place, name)| is_like(name) && !read.contains(place));
        let answers_of = |(place, name): (usize, &str)| match unit_in_name(name, Dimension::Length) {
            _ if is_level(name) => vec![self.answer_of_height(place, LEVEL.0, LEVEL.1)],
            Some(unit) => {
                let (_, size) = unit_of(Dimension::Length, unit).unwrap_or(("m", 1.0));
                vec![self.answer_of_height(place, &format!(", unit = \"{unit}\""), size)]
            }
            None => vec![
                self.answer_of_height(place, "", 1.0),
                self.answer_of_height(place, ", unit = \"ft\"", 0.3048),
            ],
        };
        let mut answers: Vec<String> = like.take(MOST).flat_map(answers_of).collect();
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
