//! Positions that stand in several columns: letters of hemispheres, and minutes apart from their degrees.

use super::super::column::SIXTIETHS;
use super::super::guess::hemisphere_of;
use super::super::hemisphere::{Sides, sides, sign_of};
use super::super::quantity::{LATITUDE, LONGITUDE};
use super::super::rows::number;
use super::super::words::words;
use super::motion::READINGS;
use super::times::SPEEDS;
use super::{Draft, Question, largest};
use crate::base::text::excerpt;

/// Key, quantity and beginning of the names of each part of a position.
const PARTS: [(&str, usize, &str); 2] = [("latitude", LATITUDE, "lat"), ("longitude", LONGITUDE, "lon")];

/// Words of the names of columns with the minutes, and with the seconds, of an angle.
const MINUTES: [&str; 7] = ["min", "mins", "minute", "minutes", "arcmin", "m", "mm"];
const SECONDS: [&str; 7] = ["sec", "secs", "second", "seconds", "arcsec", "s", "ss"];

impl Draft<'_> {
    /// The column with the letters of the hemisphere of a quantity in column `place`, if its numbers have not their signs anyway.
    pub(super) fn hemisphere(&self, quantity: usize, place: usize) -> Option<usize> {
        let letters = self.letters_of(quantity, place)?;
        (!self.has_signs_of(letters, quantity, place)).then_some(letters)
    }

    /// The column with the letters of a hemisphere: its name says so, or it stands beside, and most of its cells are such letters. The
    /// reader refuses the others.
    fn letters_of(&self, quantity: usize, place: usize) -> Option<usize> {
        let own = sides(quantity)?;
        let other = sides(if quantity == LATITUDE { LONGITUDE } else { LATITUDE })?;
        let (_, _, begin) = PARTS.into_iter().find(|(_, part, _)| *part == quantity)?;
        let has_letters = |letters: &usize| 2 * self.count(*letters, own) > self.grid.cells(*letters).count();
        let is_of_name = |name: &str| {
            hemisphere_of(name) == Some(quantity)
                || name.to_lowercase().contains(begin) && hemisphere_of(name).is_none()
        };
        let names = self.grid.names.iter().enumerate();
        let of_name = names.filter(|(letters, name)| *letters != place && is_of_name(name));
        let mut of_name = of_name.map(|(letters, _)| letters);
        // Directions of the wind have letters of both.
        let mut beside = [Some(place + 1), place.checked_sub(1)].into_iter().flatten();
        of_name
            .find(has_letters)
            .or_else(|| beside.find(|letters| has_letters(letters) && self.count(*letters, other) == 0))
    }

    /// Number of cells that are letters of these hemispheres.
    fn count(&self, place: usize, sides: Sides) -> usize {
        self.grid.cells(place).filter(|cell| sign_of(cell, sides).is_some()).count()
    }

    /// Whether some numbers are negative, and each number has the sign of its letter.
    fn has_signs_of(&self, letters: usize, quantity: usize, place: usize) -> bool {
        let Some(sides) = sides(quantity) else { return false };
        let signs = || {
            self.grid.rows.iter().filter_map(|row| {
                Some((number(row.get(place)?, self.grid.separator)?, sign_of(row.get(letters)?, sides)?))
            })
        };
        signs().any(|(number, _)| number < 0.0) && signs().all(|(number, sign)| number * sign >= 0.0)
    }

    /// Asks about letters of hemispheres that are not read, and would change the place.
    pub(super) fn letters(&mut self) {
        let grid = self.grid;
        for (key, quantity, _) in PARTS {
            let (Some(place), Some(sides)) = (self.place(key), sides(quantity)) else { continue };
            match self.letters_of(quantity, place) {
                Some(letters) if self.has_signs_of(letters, quantity, place) => {
                    let name = excerpt(&grid.names[letters]);
                    self.doubt(format!("{name} is not used: the {key} has its sign"));
                    continue;
                }
                Some(_) => continue,
                None => {}
            }
            let is_letter = |cell: &str| sign_of(cell, sides);
            let Some(letters) = self.unread_letters(is_letter).filter(|_| self.is_positive(key)) else {
                continue;
            };
            let Some(value) = self.value(key).map(str::to_owned) else { continue };
            let name = excerpt(&grid.names[letters]);
            let part = format!("hemisphere = {}", self.named_or_numbered(letters));
            let answers = vec![
                format!("{key} = {}", with_part(&value, &part)),
                format!("{key} = {value}  # {name} is something else"),
            ];
            self.remove(key);
            self.ask(Question { sentence: format!("is {name} the hemisphere of the {key}?"), answers });
        }
        let keys = ["latitude", "longitude"];
        let Some(letters) = self.unread_letters(sign_of_two) else { return };
        let [Some(latitude), Some(longitude)] = keys.map(|key| self.value(key).map(str::to_owned)) else {
            return;
        };
        let name = excerpt(&grid.names[letters]);
        let mut cells = grid.cells(letters);
        let first = cells.next().unwrap_or_default();
        if !keys.iter().all(|key| self.is_positive(key)) {
            return;
        }
        let mut answers = Vec::new();
        if cells.all(|cell| cell == first) {
            let sign = |value: &str, letter: char| {
                let is_negative = first.contains([letter, letter.to_ascii_lowercase()]);
                if is_negative { with_part(value, "sign = -1") } else { value.to_owned() }
            };
            answers.push(format!(
                "latitude = {}\nlongitude = {}  # {}",
                sign(&latitude, 'S'),
                sign(&longitude, 'W'),
                excerpt(first)
            ));
        }
        answers.push(format!("latitude = {latitude}\nlongitude = {longitude}  # {name} is something else"));
        keys.iter().for_each(|key| self.remove(key));
        self.ask(Question { sentence: format!("is {name} the hemispheres of the position?"), answers });
    }

    /// A column whose cells all are letters, some of them of a negative side. Those of the wind are none of a position.
    fn unread_letters(&self, sign_of: impl Fn(&str) -> Option<f64>) -> Option<usize> {
        let is_it = |place: &usize| {
            let mut signs = self.grid.cells(*place).map(&sign_of).peekable();
            let begins = signs.peek().is_some_and(Option::is_some);
            let is_wind = self.grid.names[*place].to_lowercase().contains("wind");
            begins
                && !is_wind
                && self.grid.cells(*place).any(|cell| sign_of(cell) == Some(-1.0))
                && signs.all(|sign| sign.is_some())
        };
        (0..self.grid.names.len()).find(is_it)
    }

    fn is_positive(&self, key: &str) -> bool {
        self.numbers(key).is_some_and(|numbers| numbers.iter().all(|number| *number >= 0.0))
    }

    /// Takes whole degrees beside columns of their minutes and seconds together where the path is then one of a vehicle, and asks about
    /// them otherwise.
    pub(super) fn minutes_apart(&mut self) {
        let found = PARTS.map(|(key, _, begin)| self.sixtieths(key, begin));
        if let [Some(latitude), Some(longitude)] = found {
            for ((key, ..), sixtieths) in PARTS.into_iter().zip([latitude, longitude]) {
                self.set_sixtieths(key, sixtieths);
            }
            let motion = self.motion().filter(|motion| motion.is_timed && self.value("time").is_some());
            let speed = motion.and_then(|motion| motion.speed(&READINGS[0], false, self.time_si()));
            let is_of_vehicle = speed.is_some_and(|speed| speed <= *SPEEDS.end());
            // Whole minutes alone lack their seconds.
            let is_complete = |[minutes, seconds]: &[Option<usize>; 2]| {
                let is_whole =
                    |minutes: usize| self.grid.numbers(minutes).iter().all(|own| own.fract() == 0.0);
                seconds.is_some() || !minutes.is_some_and(is_whole)
            };
            if is_of_vehicle && [latitude, longitude].iter().all(is_complete) {
                return PARTS
                    .iter()
                    .zip([latitude, longitude])
                    .for_each(|((key, ..), its)| self.take_sixtieths(key, its));
            }
            PARTS.iter().for_each(|(key, ..)| self.set_sixtieths(key, [None; 2]));
        }
        for ((key, ..), sixtieths) in PARTS.into_iter().zip(found) {
            let (Some([Some(minutes), _]), Some(place)) = (sixtieths, self.place(key)) else { continue };
            let [name, minutes] = [place, minutes].map(|place| excerpt(&self.grid.names[place]));
            let sentence = format!(
                "{name} has whole degrees in each row: are their minutes in {minutes}? Then give its part minutes, as {{ col = {name}, minutes = {minutes} }}"
            );
            let answers = vec![format!("{key} = {}  # whole degrees", self.column(place, ""))];
            self.remove(key);
            self.ask(Question { sentence, answers });
        }
    }

    /// The columns of the minutes and the seconds of whole degrees; `None`: there are none.
    fn sixtieths(&self, key: &str, begin: &str) -> Option<[Option<usize>; 2]> {
        let grid = self.grid;
        let place = self.place(key).filter(|_| self.value(key).is_some())?;
        let degrees = grid.numbers(place);
        let is_whole = degrees.iter().all(|number| number.fract() == 0.0) && largest(&degrees) <= 180.0;
        let column = |behind: usize, spellings: &[&str]| {
            let is_it = |other: &usize| {
                let name = &grid.names[*other];
                let is_near = *other == place + behind || name.to_lowercase().contains(begin);
                let numbers = grid.numbers(*other);
                is_near
                    && self.places.iter().all(|found| found.place != *other)
                    && words(name).iter().any(|word| spellings.contains(&word.as_str()))
                    && !numbers.is_empty()
                    && largest(&numbers) <= 60.0
            };
            (0..grid.names.len()).find(is_it)
        };
        let minutes = column(1, &MINUTES).filter(|_| is_whole)?;
        Some([Some(minutes), column(2, &SECONDS)])
    }

    fn set_sixtieths(&mut self, key: &str, sixtieths: [Option<usize>; 2]) {
        let found = self.places.iter_mut().filter(|found| found.key == key);
        found.for_each(|found| found.sixtieths = sixtieths);
    }

    /// Reads the minutes and seconds of a quantity, and says so.
    fn take_sixtieths(&mut self, key: &str, sixtieths: [Option<usize>; 2]) {
        let Some(mut value) = self.value(key).map(str::to_owned) else { return };
        for (part, place) in SIXTIETHS.iter().zip(sixtieths) {
            let Some(place) = place else { continue };
            value = with_part(&value, &format!("{part} = {}", self.named_or_numbered(place)));
            self.doubt(format!("{} is taken as the {part} of the {key}", excerpt(&self.grid.names[place])));
        }
        self.replace(key, value);
    }
}

/// The sign of two letters, as SW: -1 if one of them is of a negative side.
fn sign_of_two(cell: &str) -> Option<f64> {
    let (north, east) = cell.split_at_checked(1)?;
    let signs = [sign_of(north, sides(LATITUDE)?)?, sign_of(east, sides(LONGITUDE)?)?];
    Some(signs[0].min(signs[1]))
}

/// The value of a key, a column in TOML, with one more part.
pub fn with_part(value: &str, part: &str) -> String {
    match value.strip_suffix(" }") {
        Some(table) => format!("{table}, {part} }}"),
        None => format!("{{ col = {value}, {part} }}"),
    }
}
