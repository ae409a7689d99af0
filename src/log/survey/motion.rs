//! The motion in a table: positions row by row, and what the columns of speed and course say of it.

use super::super::rows::of_degrees_and_minutes;
use crate::base::math::{atan2, hypot, ln, sin_cos, wrap_angle};
use crate::base::units::DEG;

/// Radius of the Earth, for comparisons \[m\].
const RADIUS_M: f64 = 6.371e6;

/// Number of parts of a log whose speeds are compared, and the share of the usual way that a part needs.
const PARTS: usize = 16;
const MOVING: f64 = 0.1;

/// A step has this many of the finest steps of the numbers, so that their rounding is not taken for a way.
const FINEST: f64 = 5.0;

/// Largest misfit of a speed \[1\] and of a course \[deg\], which may be magnetic.
const SPEED_FITS: f64 = 0.05;
pub const COURSE_FITS_DEG: f64 = 25.0;

/// At rest a step goes on in the direction of the one before by less than this part of it, in the mean of squares.
const ONWARD: f64 = 0.3;

/// The units that a speed over ground has which states none are those from km/h on \[m/s\]: with mm/s times in ms would be times in s.
pub const SLOWEST_UNIT: f64 = 0.27;

/// A reading is impossible if more than one in so many rows is nowhere on the Earth.
const FEWEST_LOST: usize = 100;

/// A reading is the only one if the misfit of each other is larger by this factor, and by this difference.
const ALONE: f64 = 3.0;
const ALONE_BY: f64 = 0.003;

/// A way to read the numbers of a position.
pub struct Reading {
    pub words: &'static str,
    /// What a column of `[log]` says of it.
    pub part: &'static str,
    pub degrees: fn(f64) -> Option<f64>,
}

/// Degrees come first.
pub const READINGS: [Reading; 9] = [
    Reading { words: "degrees", part: "", degrees: |number| Some(number) },
    Reading {
        words: "degrees and minutes (ddmm.mmm)",
        part: ", unit = \"ddmm\"",
        degrees: of_degrees_and_minutes,
    },
    Reading { words: "minutes", part: ", unit = \"arcmin\"", degrees: |number| Some(number / 60.0) },
    Reading { words: "seconds of arc", part: ", unit = \"arcsec\"", degrees: |number| Some(number / 3600.0) },
    Reading { words: "1e-5 deg", part: ", scale = 1e-5", degrees: |number| Some(number * 1e-5) },
    Reading { words: "1e-6 deg", part: ", scale = 1e-6", degrees: |number| Some(number * 1e-6) },
    Reading { words: "1e-7 deg", part: ", scale = 1e-7", degrees: |number| Some(number * 1e-7) },
    Reading {
        words: "semicircles",
        part: ", unit = \"semicircle\"",
        degrees: |number| Some(number * 180.0 / 2_147_483_648.0),
    },
    Reading { words: "radians", part: ", unit = \"rad\"", degrees: |number| Some(number / DEG) },
];

/// A row with a position.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// In the unit of the table; the number of the row if the table has no time.
    pub time: f64,
    pub latitude: f64,
    pub longitude: f64,
    /// Not a number where the table has none; in m/s if `Motion::speed_units` has 1 alone.
    pub speed: f64,
    /// Course over ground [rad], or not a number.
    pub course: f64,
    /// As the table has it, or not a number.
    pub heading: f64,
}

/// The rows of a table in motion.
pub struct Motion {
    pub rows: Vec<Row>,
    pub is_timed: bool,
    /// Sizes of the units that the speed may have \[m/s\].
    pub speed_units: Vec<f64>,
    /// Rows of a step.
    stride: usize,
}

/// A step of the path.
struct Step {
    way_m: f64,
    track: f64,
    /// Way that the speed says, in the units of the table.
    said: f64,
    course: f64,
    heading: f64,
    time: f64,
}

/// How a reading agrees with the columns of speed and course.
#[derive(Debug, Clone, Copy, Default)]
pub struct Fit {
    /// Speed of the positions by that of the column.
    pub ratio: Option<f64>,
    pub course_deg: Option<f64>,
}

impl Motion {
    pub fn new(rows: Vec<Row>, is_timed: bool, speed_units: Vec<f64>) -> Self {
        let differences = |of: fn(&Row) -> f64| {
            rows.windows(2).map(move |two| (of(&two[1]) - of(&two[0])).abs()).collect::<Vec<f64>>()
        };
        let [latitudes, longitudes] = [differences(|row| row.latitude), differences(|row| row.longitude)];
        let changes = latitudes.iter().chain(&longitudes).filter(|change| **change > 0.0);
        let finest = changes.copied().fold(f64::INFINITY, f64::min);
        let larger = latitudes.iter().zip(&longitudes).map(|(one, other)| one.max(*other));
        let usual = median(larger.filter(|step| *step > 0.0)).unwrap_or(f64::INFINITY);
        let stride = (FINEST * finest / usual).ceil().clamp(1.0, (rows.len() / PARTS).max(1) as f64);
        Self { is_timed, speed_units, stride: if stride.is_nan() { 1 } else { stride as usize }, rows }
    }

    /// The same with the first row of each time alone: stamps may be coarser than the rows.
    pub fn by_stamps(self) -> Self {
        let Self { mut rows, is_timed, speed_units, .. } = self;
        rows.dedup_by_key(|row| row.time);
        Self::new(rows, is_timed, speed_units)
    }

    /// The same with other courses \[rad\].
    pub fn turned(mut self, by: f64) -> Self {
        self.rows.iter_mut().for_each(|row| row.course += by);
        self
    }

    /// The place of a row; `None`: it is none on the Earth.
    fn place(&self, row: &Row, reading: &Reading, is_exchanged: bool) -> Option<[f64; 2]> {
        let (latitude, longitude) =
            if is_exchanged { (row.longitude, row.latitude) } else { (row.latitude, row.longitude) };
        let place = [(reading.degrees)(latitude)?, (reading.degrees)(longitude)?];
        (place[0].abs() <= 90.0 && place[1].abs() <= 360.0).then_some(place)
    }

    /// The first place; `None`: with this reading more than a few rows are nowhere on the Earth.
    pub fn first_place(&self, reading: &Reading, is_exchanged: bool) -> Option<[f64; 2]> {
        let places = self.rows.iter().map(|row| self.place(row, reading, is_exchanged));
        let first = self.rows.iter().find_map(|row| self.place(row, reading, is_exchanged))?;
        let lost = places.filter(Option::is_none).count();
        (lost * FEWEST_LOST <= self.rows.len()).then_some(first)
    }

    fn steps(&self, reading: &Reading, is_exchanged: bool) -> Vec<Step> {
        let step = |rows: &[Row]| {
            let [from, to] = [rows.first()?, rows.last()?];
            let [a, b] = [self.place(from, reading, is_exchanged)?, self.place(to, reading, is_exchanged)?];
            let (way_m, track) = way(a, b);
            let said =
                rows.windows(2).map(|two| 0.5 * (two[0].speed + two[1].speed) * (two[1].time - two[0].time));
            Some(Step {
                way_m,
                track,
                said: said.sum(),
                course: rows[rows.len() / 2].course,
                heading: rows[rows.len() / 2].heading,
                time: to.time - from.time,
            })
        };
        let steps = self.rows.windows(self.stride + 1).step_by(self.stride).filter_map(step);
        steps.filter(|step| step.time > 0.0).collect()
    }

    /// The median speed over ground, if times are of this unit \[m/s\].
    pub fn speed(&self, reading: &Reading, is_exchanged: bool, time_si: f64) -> Option<f64> {
        median(self.steps(reading, is_exchanged).iter().map(|step| step.way_m / (step.time * time_si)))
    }

    /// Whether the positions move to and fro, as noise does at rest.
    pub fn is_at_rest(&self) -> bool {
        let steps = self.steps(&READINGS[0], false);
        let steps: Vec<&Step> = steps.iter().filter(|step| step.way_m > 0.0).collect();
        let along = |two: &[&Step]| two[0].way_m * two[1].way_m * sin_cos(two[1].track - two[0].track).1;
        let onward: f64 = steps.windows(2).map(along).sum();
        steps.len() >= PARTS
            && onward < ONWARD * steps.iter().map(|step| step.way_m * step.way_m).sum::<f64>()
    }

    /// The mean rate of the rows, if times are of this unit [Hz].
    pub fn rate_hz(&self, time_si: f64) -> Option<f64> {
        let [first, .., last] = self.rows[..] else { return None };
        Some((self.rows.len() - 1) as f64 / ((last.time - first.time) * time_si))
    }

    /// The median of the speeds that the column of the speed has, in its unit.
    pub fn said(&self) -> Option<f64> {
        median(self.rows.iter().map(|row| row.speed).filter(|speed| speed.is_finite()))
    }

    /// How a reading agrees with the speed in m/s and with the course.
    pub fn fit(&self, reading: &Reading, is_exchanged: bool, time_si: f64) -> Fit {
        let steps = self.steps(reading, is_exchanged);
        let with_speed: Vec<&Step> = steps.iter().filter(|step| step.said.is_finite()).collect();
        let all: f64 = with_speed.iter().map(|step| step.said).sum();
        let size = with_speed.len().div_ceil(PARTS).max(1);
        let parts = with_speed.chunks(size).map(|part| {
            let sum = |of: fn(&Step) -> f64| part.iter().map(|step| of(step)).sum::<f64>();
            (sum(|step| step.way_m), sum(|step| step.said))
        });
        let count = with_speed.len().div_ceil(size).max(1) as f64;
        let moving = parts.filter(|(_, said)| *said > MOVING * all / count);
        let ratio = median(moving.map(|(way_m, said)| way_m / (said * time_si)));
        let course = median_turn(&steps, |step| step.course);
        Fit { ratio, course_deg: course.map(|course| course / DEG) }
    }

    /// The median angle between the track and the heading that `heading` makes of the numbers of the table [rad]; `None`: there is none, or
    /// no motion.
    pub fn turn(&self, reading: &Reading, heading: impl Fn(f64) -> f64) -> Option<f64> {
        median_turn(&self.steps(reading, false), |step| heading(step.heading))
    }

    /// Whether the track is a quarter of a radian or more off its first direction for half of the time.
    pub fn turns(&self, reading: &Reading) -> bool {
        let steps = self.steps(reading, false);
        let first = steps.first().map_or(0.0, |step| step.track);
        median_turn(&steps, |_| first).is_some_and(|turn| turn > 0.25)
    }

    /// Whether speed and course both contradict a reading. A speed alone may be one through the air.
    pub fn contradicts(&self, fit: &Fit) -> bool {
        let is_other_way = fit.course_deg.is_some_and(|course_deg| course_deg >= COURSE_FITS_DEG);
        fit.ratio.is_some() && self.misfit(fit).is_none() && is_other_way
    }

    /// How badly a reading fits; `None`: it contradicts the speed or the course, or there is no speed.
    pub fn misfit(&self, fit: &Fit) -> Option<f64> {
        let of_unit = |unit: &f64| fit.ratio.map(|ratio| ln(ratio / unit).abs());
        let speed = self.speed_units.iter().filter_map(of_unit).fold(f64::INFINITY, f64::min);
        let course_deg = fit.course_deg.unwrap_or(0.0);
        (speed < SPEED_FITS && course_deg < COURSE_FITS_DEG).then_some(speed + course_deg * DEG)
    }
}

/// The way [m] and the track [rad] from one place to another one near it, latitudes and longitudes in degrees.
pub fn way(from: [f64; 2], to: [f64; 2]) -> (f64, f64) {
    let (_, cosine) = sin_cos(0.5 * (from[0] + to[0]) * DEG);
    let north = (to[0] - from[0]) * DEG;
    let east = wrap_angle((to[1] - from[1]) * DEG) * cosine;
    (RADIUS_M * hypot(north, east), atan2(east, north))
}

/// The median angle between the track and another direction, of steps in motion \[rad\].
fn median_turn(steps: &[Step], of: impl Fn(&Step) -> f64) -> Option<f64> {
    let mean_m = steps.iter().map(|step| step.way_m).sum::<f64>() / steps.len().max(1) as f64;
    let moving = steps.iter().filter(|step| step.way_m > MOVING * mean_m);
    let turns = moving.map(|step| (step.track, of(step))).filter(|(_, other)| other.is_finite());
    median(turns.map(|(track, other)| wrap_angle(track - other).abs()))
}

/// The candidate that fits alone.
pub fn alone<T>(mut candidates: Vec<(T, f64)>) -> Option<T> {
    candidates.sort_by(|(_, one), (_, other)| one.total_cmp(other));
    let is_alone = match candidates.as_slice() {
        [(_, best), (_, next), ..] => *next > ALONE * best && *next > best + ALONE_BY,
        some => !some.is_empty(),
    };
    candidates.into_iter().next().filter(|_| is_alone).map(|(found, _)| found)
}

pub fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}
