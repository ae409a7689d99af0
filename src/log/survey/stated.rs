//! Lines of units that state one that is not understood.

use super::super::quantity::{Dimension, QUANTITIES, units_of};
use super::super::words::{is_understood, unit};
use super::{ATTITUDE, Draft, Question, VELOCITIES};
use crate::base::text::excerpt;

/// Fewest cells of a line of units.
const FEWEST: usize = 3;

impl Draft<'_> {
    /// What the line of units says of a column, if it is not understood as a whole.
    fn not_understood(&self, key: &str, place: usize) -> Option<String> {
        let dimension = QUANTITIES.iter().find(|quantity| quantity.key == key)?.dimension;
        let lines = self.grid.units.iter();
        let mut lines = lines.filter(|row| row.iter().filter(|cell| unit(cell).is_some()).count() >= FEWEST);
        let cell = lines
            .find_map(|row| row.get(place).map(str::trim).filter(|cell| !is_understood(cell, dimension)));
        cell.map(excerpt)
    }

    /// Asks about units that are stated and not understood: they are not those that the quantities have without one.
    pub(super) fn unknown_units(&mut self) {
        self.unknown_units_of_places();
        self.unknown_units_of_groups();
    }

    fn unknown_units_of_places(&mut self) {
        for key in ["time", "latitude", "longitude", "height"] {
            let is_text = key == "time" && self.value("time_format").is_some();
            let Some(place) = self.place(key).filter(|_| self.value(key).is_some() && !is_text) else {
                continue;
            };
            let Some(cell) = self.not_understood(key, place) else { continue };
            let mut parts: Vec<(String, String)> = match key {
                "latitude" | "longitude" => {
                    vec![
                        (String::new(), "as they are".to_owned()),
                        (", sign = -1".to_owned(), "the other side".to_owned()),
                    ]
                }
                "height" => units_of(Dimension::Length)
                    .map(|unit| (format!(", unit = \"{unit}\""), unit.to_owned()))
                    .collect(),
                _ => units_of(Dimension::Time)
                    .map(|unit| (format!(", unit = \"{unit}\""), unit.to_owned()))
                    .collect(),
            };
            if key == "height" {
                parts.push((", scale = 30.48".to_owned(), "hundreds of feet".to_owned()));
                parts.push((", sign = -1".to_owned(), "m, positive down".to_owned()));
            }
            let first = self.grid.numbers(place).first().copied().unwrap_or(0.0);
            let answers = parts
                .iter()
                .map(|(part, words)| {
                    format!("{key} = {}  # {words}: begins at {first}", self.column(place, part))
                })
                .collect();
            let name = excerpt(&self.grid.names[place]);
            self.remove(key);
            self.forget_unit(key);
            self.ask(Question {
                sentence: format!("{name} is in {cell}, which is not understood: what is its unit?"),
                answers,
            });
        }
    }

    fn unknown_units_of_groups(&mut self) {
        for group in VELOCITIES.into_iter().chain([ATTITUDE]) {
            if !self.has_all(&group) {
                continue;
            }
            let told = |key: &&str| Some((self.place(key)?, self.not_understood(key, self.place(key)?)?));
            let Some((place, cell)) = group.iter().find_map(told) else { continue };
            let lines: Vec<String> =
                group.iter().filter_map(|key| Some(format!("{key} = {}", self.value(key)?))).collect();
            let mut answers = vec![format!(
                "{}  # as they are; scale, sign and unit read them in another way",
                lines.join("\n")
            )];
            if group == ATTITUDE {
                answers.push("attitude = \"coordinated\"".to_owned());
                self.is_attitude_asked = true;
            }
            let name = excerpt(&self.grid.names[place]);
            for key in group {
                self.remove(key);
                self.forget_unit(key);
            }
            self.ask(Question {
                sentence: format!("{name} is in {cell}, which is not understood: how is it read?"),
                answers,
            });
        }
    }
}
