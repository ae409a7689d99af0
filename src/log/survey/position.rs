//! Positions that are no degrees: the readings that agree with the other columns, and those that are asked about.

use core::f64::consts::{FRAC_PI_2, PI};

use super::letters::with_part;
use super::motion::{COURSE_FITS_DEG, Motion, READINGS, Reading, Row, alone};
use super::times::SPEEDS;
use super::{Draft, Question};
use crate::base::text::excerpt;

/// A course that is off by more is one of other signs \[deg\].
const OPPOSITE_DEG: f64 = 90.0;

impl Draft<'_> {
    /// Looks for the reading of a position that is none in degrees, or contradicts the speed of the table in degrees: one that agrees with
    /// speed and course alone is taken, and otherwise asked about. Known formats write whole numbers of 1e-7 deg.
    pub(super) fn position(&mut self, is_known: bool) {
        let [Some(latitude), Some(longitude)] = ["latitude", "longitude"].map(|key| self.place(key)) else {
            return;
        };
        let is_rad = self.is_position_in_radians();
        let Some(motion) = self.motion().filter(|_| !is_rad) else { return };
        if self.is_position_open {
            return self.ask_for_radians([latitude, longitude], &motion);
        }
        let time_si = self.time_si();
        let degrees = &READINGS[0];
        let is_possible = motion.first_place(degrees, false).is_some();
        if is_known {
            return self.known_position([latitude, longitude], &motion, is_possible);
        }
        let is_timed = motion.is_timed && self.value("time").is_some();
        let fit = motion.fit(degrees, false, time_si);
        if is_possible && motion.is_at_rest() {
            return;
        }
        let is_opposite = fit.course_deg.is_some_and(|course_deg| course_deg > OPPOSITE_DEG);
        let has_course = motion.rows.iter().any(|row| row.course.is_finite() && row.course != 0.0);
        if is_possible && !(is_timed && motion.contradicts(&fit)) {
            if is_opposite && has_course {
                return self.ask_for_signs(&motion);
            }
            if let Some(ratio) = fit.ratio.filter(|_| is_timed && motion.misfit(&fit).is_none()) {
                self.doubt(format!("the positions have {ratio:.3} times the speed of the table in m/s"));
            }
            return;
        }
        let candidates = READINGS.iter().flat_map(|reading| [(reading, false), (reading, true)]);
        let fitting = candidates.filter_map(|(reading, is_exchanged)| {
            motion.first_place(reading, is_exchanged)?;
            let fit = motion.fit(reading, is_exchanged, time_si);
            // Speed alone may fit exchanged columns by chance.
            let misfit = motion.misfit(&fit).filter(|_| !is_exchanged || fit.course_deg.is_some())?;
            Some(((reading, is_exchanged), misfit))
        });
        match alone(fitting.collect()).filter(|_| is_timed) {
            Some((reading, is_exchanged)) => {
                let columns = if is_exchanged { [longitude, latitude] } else { [latitude, longitude] };
                let exchanged = if is_exchanged { ", exchanged" } else { "" };
                let why = format!("{exchanged}: speed and course agree with no other reading");
                self.take(columns, reading, &why);
            }
            None if is_possible && is_opposite && has_course => self.ask_for_signs(&motion),
            None if is_possible => {
                let course_deg = fit.course_deg.unwrap_or(0.0);
                self.doubt(format!("the positions move {course_deg:.0} deg off the course of the table"));
            }
            None => self.ask_for_position([latitude, longitude], &motion, time_si),
        }
    }

    /// The position of a known format, which may be degrees in each.
    fn known_position(&mut self, columns: [usize; 2], motion: &Motion, is_possible: bool) {
        let is_whole = |row: &Row| row.latitude.fract() == 0.0 && row.longitude.fract() == 0.0;
        if !is_possible && motion.rows.iter().all(is_whole) {
            self.take(columns, &READINGS[6], "");
        } else if !is_possible {
            self.ask_for_position(columns, motion, self.time_si());
        } else if self.value("roll").is_some_and(|roll| roll.contains("unit = \"rad\"")) {
            // Beside angles in radians, a small position may be in radians too.
            let is_small = |row: &Row| row.latitude.abs() <= FRAC_PI_2 && row.longitude.abs() <= PI;
            if motion.rows.iter().all(is_small) {
                self.ask_for_radians(columns, motion);
            }
        }
    }

    /// Reads the position from these columns in this way, and says so.
    fn take(&mut self, columns: [usize; 2], reading: &Reading, why: &str) {
        if let Some(found) = READINGS.iter().position(|known| known.part == reading.part) {
            self.reading = found;
        }
        for (key, place) in ["latitude", "longitude"].into_iter().zip(columns) {
            let value = self.column_of_position(key, place, reading);
            self.replace(key, value);
            let name = excerpt(&self.grid.names[place]);
            self.doubt(format!("{name} is taken as {key} in {}{why}", reading.words));
        }
        for (key, place) in ["latitude", "longitude"].into_iter().zip(columns) {
            let found = self.places.iter_mut().filter(|found| found.key == key);
            found.for_each(|found| found.place = place);
        }
    }

    /// A column of a position in TOML.
    fn column_of_position(&self, key: &str, place: usize, reading: &Reading) -> String {
        let of_name = self.place(key) == Some(place);
        let part = self.value(key).filter(|_| of_name).and_then(|value| {
            let at = value
                .find(", part = ")
                .or_else(|| value.find(", hemisphere = "))
                .or_else(|| value.find(", minutes = "))?;
            value.get(at..)?.strip_suffix(" }")
        });
        self.column(place, &format!("{}{}", reading.part, part.unwrap_or("")))
    }

    /// Asks whether a position is in degrees or in radians.
    fn ask_for_radians(&mut self, columns: [usize; 2], motion: &Motion) {
        let is_timed = motion.is_timed && self.value("time").is_some();
        let mut answers = Vec::new();
        for reading in [&READINGS[0], &READINGS[READINGS.len() - 1]] {
            let Some([first, second]) = motion.first_place(reading, false) else { continue };
            let speed = motion.speed(reading, false, self.time_si()).filter(|_| is_timed);
            let speed = speed.map_or(String::new(), |speed| format!(", {speed:.1} m/s"));
            let [latitude, longitude] = [("latitude", columns[0]), ("longitude", columns[1])]
                .map(|(key, place)| self.column_of_position(key, place, reading));
            answers.push(format!(
                "latitude = {latitude}\nlongitude = {longitude}  # {}: from {first:.4}, {second:.4} deg{speed}",
                reading.words
            ));
        }
        let names = columns.map(|place| excerpt(&self.grid.names[place]));
        let sentence = format!("{} and {} are small: degrees or radians?", names[0], names[1]);
        for key in ["latitude", "longitude"] {
            self.remove(key);
        }
        self.ask(Question { sentence, answers });
    }

    /// Asks for the signs of a position that moves against the course of the table.
    fn ask_for_signs(&mut self, motion: &Motion) {
        let [Some(latitude), Some(longitude)] =
            ["latitude", "longitude"].map(|key| self.value(key).map(str::to_owned))
        else {
            return;
        };
        let mut answers = Vec::new();
        for signs in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
            let mirrored = |row: &Row| Row {
                latitude: row.latitude * signs[0],
                longitude: row.longitude * signs[1],
                ..*row
            };
            let rows = motion.rows.iter().map(mirrored).collect();
            let fit = Motion::new(rows, motion.is_timed, Vec::new()).fit(&READINGS[0], false, 1.0);
            if fit.course_deg.is_some_and(|course_deg| course_deg < COURSE_FITS_DEG) {
                let value = |value: &str, sign: f64| match sign < 0.0 {
                    true => with_part(value, "sign = -1"),
                    false => value.to_owned(),
                };
                answers.push(format!(
                    "latitude = {}\nlongitude = {}  # the course of the table agrees",
                    value(&latitude, signs[0]),
                    value(&longitude, signs[1])
                ));
            }
        }
        answers.push(format!("latitude = {latitude}\nlongitude = {longitude}  # the course is another one"));
        for key in ["latitude", "longitude"] {
            self.remove(key);
        }
        let sentence =
            "the positions move against the course of the table: are their signs missing?".to_owned();
        self.ask(Question { sentence, answers });
    }

    /// Asks how a position is read, with what each reading would mean.
    fn ask_for_position(&mut self, [latitude, longitude]: [usize; 2], motion: &Motion, time_si: f64) {
        let mut answers = Vec::new();
        for (reading, is_exchanged) in READINGS.iter().flat_map(|reading| [(reading, false), (reading, true)])
        {
            let Some([first, second]) = motion.first_place(reading, is_exchanged) else { continue };
            let is_fit = || motion.misfit(&motion.fit(reading, is_exchanged, time_si)).is_some();
            let speed = motion.speed(reading, is_exchanged, time_si).filter(|_| motion.is_timed);
            if speed.is_some_and(|speed| !SPEEDS.contains(&speed)) || is_exchanged && !is_fit() {
                continue;
            }
            let columns = if is_exchanged { [longitude, latitude] } else { [latitude, longitude] };
            let [one, other] = [("latitude", columns[0]), ("longitude", columns[1])]
                .map(|(key, place)| self.column_of_position(key, place, reading));
            let speed = speed.map_or(String::new(), |speed| format!(", {speed:.1} m/s"));
            let said = motion.said().map_or(String::new(), |said| format!("; the table says {said:.1}"));
            answers.push(format!(
                "latitude = {one}\nlongitude = {other}  # {}: from {first:.4}, {second:.4} deg{speed}{said}",
                reading.words
            ));
        }
        let names = [latitude, longitude].map(|place| excerpt(&self.grid.names[place]));
        let hint = if answers.is_empty() { ": are they metres of a map?" } else { "" };
        let sentence = format!("{} and {} are no degrees{hint}", names[0], names[1]);
        for key in ["latitude", "longitude"] {
            self.remove(key);
        }
        self.ask(Question { sentence, answers });
    }
}
