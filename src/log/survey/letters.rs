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

#[cfg(test)]
mod tests {
    use super::super::super::{FlightLog, LogError};
    use super::super::conventions::{Row, assert_asks, doubts_of, errors, flight, look, table};
    use crate::scene::Scene;

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
    fn degrees_minutes_and_seconds_apart_are_read_where_a_vehicle_moves() {
        for [latitude, longitude] in [[47.3, 8.4], [-33.9, -70.6], [0.001, -0.002]] {
            let rows = flight(latitude, longitude);
            for (names, count, letters) in [
                ("lat deg,lat min,lon deg,lon min", 2, false),
                ("lat,minutes,lon,min", 2, false),
                ("Lat (deg),LatMin,Lon (deg),LonMin", 2, false),
                ("lat_deg,lat_min,lat_sec,lon_deg,lon_min,lon_sec", 3, false),
                ("LatD,LatM,LatS,LonD,LonM,LonS", 3, false),
                ("lat_dd,lat_mm,lat_ss,lon_dd,lon_mm,lon_ss", 3, false),
                ("LatD,LatM,LatS,NS,LonD,LonM,LonS,EW", 3, true),
                ("lat_deg,lat_min,lat_sec,N/S,lon_deg,lon_min,lon_sec,E/W", 3, true),
            ] {
                let apart = |degrees: f64, sides: [&str; 2]| {
                    let (size, is_negative) = (degrees.abs(), degrees < 0.0);
                    let minutes = size.fract() * 60.0;
                    let sign = if is_negative && !letters { "-" } else { "" };
                    let first = format!("{sign}{}", size.trunc());
                    let parts = match count {
                        2 => format!("{first},{minutes:.8}"),
                        _ => format!("{first},{},{:.6}", minutes.trunc(), minutes.fract() * 60.0),
                    };
                    let letter = sides[usize::from(is_negative)];
                    if letters { format!("{parts},{letter}") } else { parts }
                };
                let text = table(&format!("t,{names},alt (m)"), &rows, |_, row| {
                    let [latitude, longitude] = [apart(row[1], ["N", "S"]), apart(row[2], ["E", "W"])];
                    format!("{:.1},{latitude},{longitude},{:.3}", row[0], row[3])
                });
                let (found, samples) = look(&text);
                assert!(errors(&samples.unwrap(), &rows).0 < 0.05, "{names}: {found:?}");
                assert!(doubts_of(&found, "is taken as the minutes of the latitude"), "{found:?}");
            }
        }
    }

    #[test]
    fn minutes_beyond_their_range_are_refused_at_their_cell() {
        let read = |cells: &str| {
            let text = "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"t\"\nlatitude = { col = \"d\", minutes = \"m\", seconds = \"s\" }\nlongitude = 8\nheight = 0\nroll = 0\npitch = 0\nheading = 0\n";
            let scene = Scene::parse(text.as_bytes()).unwrap();
            assert_eq!(Scene::parse(scene.write().as_bytes()).unwrap().log, scene.log);
            FlightLog::parse_with(
                format!("t,d,m,s\n0,{cells}\n1,{cells}\n2,-0,30,36\n").as_bytes(),
                &scene.log,
            )
        };
        let log = read("47,18,15").unwrap();
        let degrees = [0, 2].map(|row| log.samples()[row].place.latitude_rad.to_degrees());
        assert!(
            (degrees[0] - (47.0 + 18.0 / 60.0 + 15.0 / 3600.0)).abs() < 1e-12
                && (degrees[1] + 0.51).abs() < 1e-12,
            "{degrees:?}"
        );
        assert!(read("47,,15").is_err());
        let signed = read("-47,-18,-15").unwrap();
        assert_eq!(signed.samples()[0].place.latitude_rad, -log.samples()[0].place.latitude_rad);
        for (cells, column, words) in [
            ("47,60.1,0", 3, "expected minutes"),
            ("47.3,18,1", 3, "expected whole degrees beside minutes, found 47.3"),
            ("47,18.5,1", 4, "expected whole minutes beside seconds, found 18.5"),
            ("47,-18,1", 3, "expected minutes"),
            ("47,18,-1", 4, "expected seconds"),
            ("47,x,1", 3, "found \"x\""),
        ] {
            let Err(LogError::Fault(fault)) = read(cells) else { panic!("{cells}") };
            assert!((fault.line, fault.column) == (2, column) && fault.sentence.contains(words), "{fault:?}");
        }
        for more in ["seconds = \"s\"", "minutes = \"m\", unit = \"rad\""] {
            let text = format!("[flight]\nfile = \"a.csv\"\n[log]\nlatitude = {{ col = \"d\", {more} }}\n");
            let faults = Scene::parse(text.as_bytes()).unwrap_err();
            assert!(faults[0].sentence.contains("seconds stand beside minutes"), "{faults:?}");
        }
    }

    #[test]
    fn whole_degrees_beside_minutes_of_no_vehicle_are_asked_about() {
        let rows = flight(47.3, 8.4);
        // Minutes that jump.
        let text = table("t,lat deg,lat min,lon deg,lon min,alt (m)", &rows, |index, row| {
            format!("{:.1},47,{},8,{},{:.3}", row[0], (index * 37) % 60, (index * 23) % 60, row[3])
        });
        let found = assert_asks(&text, "are their minutes in");
        assert_eq!(found.questions.len(), 2, "{found:?}");
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
