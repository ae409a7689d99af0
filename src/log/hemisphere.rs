//! Latitudes and longitudes whose sign is the letter of a hemisphere.

use super::Separator;
use super::quantity::{LATITUDE, LONGITUDE};
use super::rows::number;
use crate::base::text::excerpt;

/// The letters and the words of a hemisphere, the positive one first.
pub type Sides = [[&'static str; 2]; 2];

/// The hemispheres of a quantity; `None`: it has none.
pub fn sides(quantity: usize) -> Option<Sides> {
    match quantity {
        LATITUDE => Some([["N", "north"], ["S", "south"]]),
        LONGITUDE => Some([["E", "east"], ["W", "west"]]),
        _ => None,
    }
}

/// The sign that a letter or a word of a hemisphere stands for.
pub fn sign_of(text: &str, [positive, negative]: Sides) -> Option<f64> {
    let is_of = |side: [&str; 2]| side.iter().any(|word| word.eq_ignore_ascii_case(text));
    if is_of(positive) {
        return Some(1.0);
    }
    is_of(negative).then_some(-1.0)
}

/// The number in a cell, with the sign of its letter, which stands in the cell (48.1N, N48.1, 48.1° N) or in one of its own; `None`: there
/// is no number. Each cell has its place in the row, and an error the place of its cell.
pub fn signed(
    (place, text): (usize, &str),
    letter: Option<(usize, &str)>,
    sides: Sides,
    separator: Separator,
) -> Result<Option<f64>, (usize, String)> {
    let plain = number(text, separator);
    let (found, at, letter) = match letter {
        Some((at, letter)) => (plain, at, letter),
        None => match with_letter(text, separator).filter(|_| plain.is_none()) {
            Some((number, letter)) => (Some(number), place, letter),
            None => return Ok(plain),
        },
    };
    let Some(sign) = sign_of(letter, sides) else {
        let [[positive, _], [negative, _]] = sides;
        return Err((at, format!("expected {positive} or {negative}, found \"{}\"", excerpt(letter))));
    };
    if found.is_some_and(|number| number < 0.0) {
        let letter = excerpt(letter);
        return Err((
            place,
            format!("a negative number with the letter {letter}: expected one sign, not two"),
        ));
    }
    Ok(found.map(|number| sign * number))
}

/// The number and the letter of a cell that has both.
fn with_letter(text: &str, separator: Separator) -> Option<(f64, &str)> {
    let is_mark = |letter: char| letter == '°' || letter.is_whitespace();
    let digits = text.trim_matches(char::is_alphabetic);
    let letter = text.strip_prefix(digits).or_else(|| text.strip_suffix(digits))?;
    let number = number(digits.trim_matches(is_mark), separator)?;
    (!letter.is_empty()).then_some((number, letter))
}

#[cfg(test)]
mod tests {
    use super::super::{FlightLog, LogError};
    use crate::scene::Scene;

    /// Latitude and longitude of the first row \[deg\], or line, column and sentence of the fault, of a table read by lines of `[log]`.
    fn read(cells: [&str; 4], keys: &str) -> Result<[f64; 2], (usize, usize, String)> {
        let text = format!(
            "[flight]\nfile = \"a.csv\"\n[log]\ntime = \"t\"\nheight = 0\nroll = 0\npitch = 0\nheading = 0\n{keys}"
        );
        let scene = Scene::parse(text.as_bytes()).unwrap();
        // What a scene writes reads the same.
        assert_eq!(Scene::parse(scene.write().as_bytes()).unwrap().log, scene.log);
        let row = cells.join(",");
        let table = format!("t,lat,N/S,lon,E/W\n0,{row}\n1,{row}\n");
        match FlightLog::parse_with(table.as_bytes(), &scene.log) {
            Ok(log) => {
                let place = log.samples()[0].place;
                Ok([place.latitude_rad, place.longitude_rad].map(f64::to_degrees))
            }
            Err(LogError::Fault(fault)) => Err((fault.line, fault.column, fault.sentence)),
            Err(error) => panic!("{error:?}"),
        }
    }

    const OF_COLUMNS: &str =
        "latitude = { col = \"lat\", hemisphere = \"N/S\" }\nlongitude = { col = 4, hemisphere = 5 }\n";
    const OF_CELLS: &str = "latitude = \"lat\"\nlongitude = \"lon\"\n";

    #[test]
    fn a_letter_gives_the_sign() {
        for ([latitude, longitude], expected) in
            [(["N", "E"], [33.5, 70.5]), (["s", "West"], [-33.5, -70.5]), (["SOUTH", "east"], [-33.5, 70.5])]
        {
            let found = read(["33.5", latitude, "70.5", longitude], OF_COLUMNS).unwrap();
            let is_near = |index: usize| (found[index] - expected[index]).abs() < 1e-12;
            assert!(is_near(0) && is_near(1), "{found:?}, not {expected:?}");
            for [latitude, longitude] in [
                [format!("33.5{latitude}"), format!("70.5{longitude}")],
                [format!("{latitude}33.5"), format!("{longitude} 70.5")],
                [format!("33.5° {latitude}"), format!("70.5°{longitude}")],
            ] {
                let found = read([&latitude, "", &longitude, ""], OF_CELLS).unwrap();
                let is_near = |index: usize| (found[index] - expected[index]).abs() < 1e-12;
                assert!(is_near(0) && is_near(1), "{latitude} {longitude}: {found:?}, not {expected:?}");
            }
        }
    }

    #[test]
    fn what_is_no_hemisphere_is_refused_at_its_cell() {
        for (cells, keys, column, words) in [
            (["33.5", "E", "70.5", "E"], OF_COLUMNS, 3, "lat: expected N or S, found \"E\""),
            (["33.5", "N", "70.5", "1"], OF_COLUMNS, 5, "column 4: expected E or W, found \"1\""),
            (["-33.5", "S", "70.5", "E"], OF_COLUMNS, 2, "lat: a negative number with the letter S"),
            (["33.5N", "N", "70.5", "E"], OF_COLUMNS, 2, "lat: expected a finite number, found \"33.5N\""),
            (["33.5E", "", "70.5", ""], OF_CELLS, 2, "lat: expected N or S, found \"E\""),
            (["33.5", "", "-70.5W", ""], OF_CELLS, 4, "lon: a negative number with the letter W"),
            (["N33.5S", "", "70.5", ""], OF_CELLS, 2, "lat: expected a finite number, found \"N33.5S\""),
        ] {
            let (line, found, sentence) = read(cells, keys).unwrap_err();
            assert_eq!((line, found), (2, column), "{sentence}");
            assert!(sentence.starts_with(words), "{sentence}");
        }
        // A row without a letter has no position.
        let (_, _, sentence) = read(["33.5", "", "70.5", "E"], OF_COLUMNS).unwrap_err();
        assert_eq!(sentence, "0 samples: a flight has at least two");
    }

    #[test]
    fn only_a_column_of_the_position_has_a_hemisphere() {
        for (key, words) in [
            (
                "height = { col = \"h\", hemisphere = 2 }",
                "log.height.hemisphere: only latitude and longitude have one",
            ),
            (
                "latitude = { value = 2, hemisphere = 2 }",
                "log.latitude: a value has no file, no part and no hemisphere; give its col",
            ),
            (
                "latitude = { col = 1, hemisphere = 0 }",
                "log.latitude.hemisphere: expected a column from 1 to 1000",
            ),
        ] {
            let faults =
                Scene::parse(format!("[flight]\nfile = \"a.csv\"\n[log]\n{key}\n").as_bytes()).unwrap_err();
            assert!(faults[0].sentence.contains(words), "{faults:?}");
        }
    }

    /// A letter that is not read would leave the flight in the wrong hemisphere.
    #[test]
    fn a_letter_that_is_not_read_is_noted() {
        let table = "time_s,latitude_deg,N/S,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n\
            0,33,S,70,0,0,0,0\n1,33,S,70,0,0,0,0\n";
        let log = FlightLog::parse(table.as_bytes()).unwrap();
        assert_eq!(log.notes()[0].sentence, "N/S is not read; is it log.latitude.hemisphere?");
        assert_eq!((log.notes()[0].line, log.notes()[0].column), (1, 3));
    }
}
