//! Positions that stand in several columns: letters of hemispheres, and minutes apart from their degrees.

use super::super::guess::hemisphere_of;
use super::super::hemisphere::{Sides, sides, sign_of};
use super::super::quantity::{LATITUDE, LONGITUDE};
use super::super::rows::number;
use super::super::words::words;
use super::{Draft, Question, largest};
use crate::base::text::excerpt;

/// Key, quantity and beginning of the names of each part of a position.
const PARTS: [(&str, usize, &str); 2] = [("latitude", LATITUDE, "lat"), ("longitude", LONGITUDE, "lon")];

/// Words of the names of columns with the minutes or seconds of an angle.
const MINUTES: [&str; 9] = ["min", "mins", "minute", "minutes", "arcmin", "sec", "secs", "second", "seconds"];

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

    /// Asks about whole degrees beside a column that may have their minutes.
    pub(super) fn minutes_apart(&mut self) {
        let grid = self.grid;
        for (key, _, begin) in PARTS {
            let Some(place) = self.place(key).filter(|_| self.value(key).is_some()) else { continue };
            let degrees = grid.numbers(place);
            let is_whole = degrees.iter().all(|number| number.fract() == 0.0) && largest(&degrees) <= 180.0;
            let is_minutes = |other: &usize| {
                let name = &grid.names[*other];
                let is_near = *other == place + 1 || name.to_lowercase().contains(begin);
                let numbers = grid.numbers(*other);
                is_near
                    && self.places.iter().all(|found| found.place != *other)
                    && words(name).iter().any(|word| MINUTES.contains(&word.as_str()))
                    && !numbers.is_empty()
                    && largest(&numbers) <= 60.0
            };
            let Some(other) = (0..grid.names.len()).find(is_minutes).filter(|_| is_whole) else { continue };
            let [name, minutes] = [place, other].map(|place| excerpt(&grid.names[place]));
            let sentence = format!(
                "{name} has whole degrees in each row: are their minutes in {minutes}? Write both into one column then, as 47.305, or as 4718.3 with unit = \"ddmm\""
            );
            let answers = vec![format!("{key} = {}  # whole degrees", self.column(place, ""))];
            self.remove(key);
            self.ask(Question { sentence, answers });
        }
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

#[cfg(test)]
mod tests {
    use super::super::super::LogError;
    use super::super::conventions::{Row, assert_asks, doubts_of, errors, flight, look, table};

    /// The flight in the south-west without signs, with the cells of more columns before and behind.
    fn text(names: &str, row: impl Fn(usize, [String; 2]) -> String) -> (String, Vec<Row>) {
        let rows = flight(-33.9, -70.6);
        let text = table(&format!("t,{names},alt (m)"), &rows, |index, values| {
            let place = [values[1], values[2]].map(|degrees| format!("{:.9}", -degrees));
            format!("{:.1},{},{:.3}", values[0], row(index, place), values[3])
        });
        (text, rows)
    }

    #[test]
    fn letters_are_read_where_they_stand_and_one_that_is_none_is_refused() {
        for names in ["lat,lon,lat_dir,lon_dir", "lat,lon,GPSLatitudeRef,GPSLongitudeRef", "lat,lon,N/S,E/W"]
        {
            let (text, rows) = text(names, |_, [latitude, longitude]| format!("{latitude},{longitude},S,W"));
            let (found, samples) = look(&text);
            assert!(errors(&samples.unwrap(), &rows).0 < 0.01, "{names}: {found:?}");
        }
        let (text, _) = text("lat,N/S,lon,E/W", |index, [latitude, longitude]| {
            format!("{latitude},{},{longitude},W", if index == 77 { "?" } else { "S" })
        });
        let (found, samples) = look(&text);
        assert!(found.questions.is_empty(), "{found:?}");
        let Err(LogError::Fault(fault)) = samples else { panic!("{found:?}") };
        assert!(fault.line == 79 && fault.sentence.contains("expected N or S, found \"?\""), "{fault:?}");
    }

    #[test]
    fn letters_that_are_not_read_are_asked_about() {
        for (names, letters, words) in [
            ("lat,lon,note,d1,d2", "x,S,W", "latitude = { col = \"lat\", hemisphere = \"d1\" }"),
            ("lat,lon,note,d1,d2", "x,S,W", "longitude = { col = \"lon\", hemisphere = \"d2\" }"),
            (
                "lat,lon,note,where",
                "x,SW",
                "latitude = { col = \"lat\", sign = -1 }\nlongitude = { col = \"lon\", sign = -1 }  # SW",
            ),
        ] {
            let row = |_, [latitude, longitude]: [String; 2]| format!("{latitude},{longitude},{letters}");
            assert_asks(&text(names, row).0, words);
        }
        // Letters that change nothing, and those of a wind.
        for (names, letters) in [
            ("lat,lon,note,d1,d2", "x,N,E"),
            ("lat,lon,note,where", "x,NE"),
            ("lat,lon,note,wind", "x,S"),
            ("lat,lon,note,wind dir", "x,SW"),
        ] {
            let row = |_, [latitude, longitude]: [String; 2]| format!("{latitude},{longitude},{letters}");
            assert!(look(&text(names, row).0).0.questions.is_empty(), "{names}");
        }
    }

    #[test]
    fn signs_that_agree_with_their_letters_count_once() {
        let row = |_, [latitude, longitude]: [String; 2]| format!("-{latitude},S,-{longitude},W");
        let (text, rows) = text("lat,N/S,lon,E/W", row);
        let (found, samples) = look(&text);
        assert!(errors(&samples.unwrap(), &rows).0 < 0.01 && doubts_of(&found, "has its sign"), "{found:?}");
        // One that disagrees is refused.
        let (found, samples) = look(&text.replacen(",S,", ",N,", 1));
        assert!(found.text.contains("hemisphere = \"N/S\"") && samples.is_err(), "{found:?}");
    }

    #[test]
    fn whole_degrees_beside_minutes_are_asked_about() {
        let rows = flight(47.3, 8.4);
        for names in
            ["lat deg,lat min,lon deg,lon min", "lat,minutes,lon,min", "Lat (deg),LatMin,Lon (deg),LonMin"]
        {
            let apart = |degrees: f64| format!("{},{:.6}", degrees.trunc(), degrees.fract() * 60.0);
            let text = table(&format!("t,{names},alt (m)"), &rows, |_, row| {
                format!("{:.1},{},{},{:.3}", row[0], apart(row[1]), apart(row[2]), row[3])
            });
            let found = assert_asks(&text, "are their minutes in");
            assert_eq!(found.questions.len(), 2, "{found:?}");
        }
        // Degrees with decimals need none.
        let text = table("t,lat,min,lon,alt (m)", &rows, |_, row| {
            format!("{:.1},{:.8},3,{:.8},{:.3}", row[0], row[1], row[2], row[3])
        });
        assert!(look(&text).0.questions.is_empty());
    }

    #[test]
    fn a_course_that_the_positions_contradict_is_asked_about() {
        for (latitude, longitude, answer) in [
            (
                -33.9,
                70.6,
                "latitude = { col = \"lat\", sign = -1 }\nlongitude = \"lon\"  # the course of the table",
            ),
            (
                -33.9,
                -70.6,
                "latitude = { col = \"lat\", sign = -1 }\nlongitude = { col = \"lon\", sign = -1 }  # the",
            ),
        ] {
            let rows = flight(latitude, longitude);
            let course = |row: &Row, more: f64| (row[5] + more) % 360.0;
            let text = |more: f64| {
                table("t,lat,lon,alt (m),speed (m/s),course", &rows[..100], |_, row| {
                    let place = [row[1], row[2]].map(|degrees| format!("{:.9}", degrees.abs()));
                    format!("{:.1},{},{:.3},40,{:.2}", row[0], place.join(","), row[3], course(row, more))
                })
            };
            assert_asks(&text(0.0), answer);
        }
    }
}
