//! What a column that is not read says of the motion, against what flies.

use super::flown::{Flown, There};
use super::follows::{AT_UNIT, FOLLOWS_WELL, Follows, LOW_M, displacement, short, times};
use super::{Like, Unread};
use crate::base::math::{hypot, ln, wrap_angle};
use crate::base::units::DEG;
use crate::log::quantity::{Dimension, HEADING, HEIGHT, SPEED, TIME, TRACK, VELOCITY, unit_of, units_of};
use crate::log::survey::motion::{COURSE_FITS_DEG, Motion, READINGS, Row, SLOWEST_UNIT, median};
use crate::log::words::unit_and_words;

/// What a column says.
#[derive(Debug, Clone, PartialEq)]
pub enum Said {
    /// Nothing that can be compared: too few rows, no motion, or one number all the way.
    Nothing,
    /// What flies: the quantity, and the unit.
    Agrees(String),
    /// Something else, which may be none of the quantities.
    Unlike,
    /// Something else than its quantity: how.
    Contradicts(String),
}

/// Fewest rows, most rows, and number of parts of the flight over which times are compared.
const FEWEST: usize = 32;
const MOST_ROWS: usize = 20_000;
const PARTS: usize = 16;

/// Slowest mean speed over ground that is compared \[m/s\].
const SLOW_M_S: f64 = 0.5;

/// Largest angle to the course of a column whose name does not say that it has one.
const COURSE_AGREES_DEG: f64 = 5.0;

/// Angles whose sum with a course is the one of a mirrored path \[deg\], and what mirrors it.
const MIRRORS: [(f64, &str); 3] = [
    (0.0, "has the longitude lost its sign?"),
    (180.0, "has the latitude lost its sign?"),
    (90.0, "are latitude and longitude exchanged?"),
];

/// Smallest angle of a course or a heading that contradicts: one may be magnetic, and a vehicle drifts.
const CONTRADICTS_DEG: f64 = 60.0;

/// Least ratio of a speed to that of a record that contradicts, as a logarithm, of a quarter: below it noise and rare rows explain it.
const RECORD_CONTRADICTS: f64 = 0.22;

/// Longest time between two rows over which a track is told \[s\]: rarer ones cut circles and turns short.
const DENSE_S: f64 = 2.0;

/// Largest step of the numbers of a speed that widens what agrees, as a share of them.
const COARSEST: f64 = 0.3;

/// Names of speeds that are over ground, without blanks and marks.
const OVER_GROUND: [&str; 5] = ["groundspeed", "gndspd", "gspeed", "gs", "sog"];

/// Sizes of the numbers of a time by that of what flies: seconds, and what counts hours, minutes, days and parts of a second.
const CLOCKS: [f64; 11] =
    [1.0, 1e3, 1e6, 1e9, 1e7, 1e4, 10.0, 100.0, 1.0 / 60.0, 1.0 / 3600.0, 1.0 / 86400.0];
const CLOCK_FITS: f64 = 0.06;

/// Steps of a time over which its rate is told.
const TELLS: f64 = 20.0;

/// What a column says of the motion.
pub fn compare(column: &Unread, flown: &Flown<'_>) -> Said {
    let every = column.values.len().div_ceil(MOST_ROWS).max(1);
    let values = column.values.iter().step_by(every);
    // A negative speed, or a course of -1, is none.
    let is_missing = |value: f64| match column.quantity {
        Some(SPEED) => value < 0.0,
        Some(TRACK) => value == -1.0,
        _ => false,
    };
    let values = values.filter(|[_, value]| !is_missing(*value));
    let rows = values.filter_map(|[time_s, value]| Some((*time_s, *value, flown.at(*time_s)?)));
    let rows: Vec<(f64, f64, There)> = rows.collect();
    let is_constant = rows.windows(2).all(|two| two[0].1 == two[1].1);
    // A steady speed is one.
    let is_speed = column.quantity == Some(SPEED) && rows.iter().any(|(_, value, _)| *value != 0.0);
    if rows.len() < FEWEST || is_constant && !is_speed {
        return Said::Nothing;
    }
    let of = Compared { column, rows: &rows };
    match column.quantity {
        Some(TIME) => of.time(),
        Some(HEIGHT) => of.height(),
        Some(HEADING) => of.heading(flown.has_attitude),
        Some(SPEED) => of.speed(),
        Some(TRACK) => of.course(),
        Some(quantity) => of.component(component(quantity)),
        None => of.any(flown.has_attitude),
    }
}

/// The component of a velocity: east, north, up.
fn component(quantity: usize) -> usize {
    if quantity >= SPEED { 2 } else { quantity - VELOCITY }
}

pub struct Compared<'c> {
    pub(super) column: &'c Unread,
    /// Time [s], number, and what flies.
    pub(super) rows: &'c [(f64, f64, There)],
}

impl Compared<'_> {
    /// The sizes of the units that the column may have.
    pub(super) fn sizes(&self, dimension: Dimension) -> Vec<(&'static str, f64)> {
        let is_speed = self.column.quantity == Some(SPEED);
        let slowest = if is_speed { SLOWEST_UNIT } else { 0.0 };
        let may_be_slow = |unit: &str| !self.column.unit.is_empty() || unit == self.column.beside;
        let units =
            units_of(dimension).filter(|unit| self.column.unit.is_empty() || *unit == self.column.unit);
        let sizes = units.filter_map(|unit| unit_of(dimension, unit));
        sizes.filter(|(unit, size)| may_be_slow(unit) || *size >= slowest).collect()
    }

    /// The motion that flies, with the numbers of the column as speeds and as courses in units of these sizes.
    fn motion(&self, speed_si: f64, angle: f64) -> Motion {
        let row = |(time, value, there): &(f64, f64, There)| Row {
            time: *time,
            latitude: there.latitude,
            longitude: there.longitude,
            speed: value * speed_si,
            course: value * angle,
            heading: f64::NAN,
        };
        Motion::new(self.rows.iter().map(row).collect(), true, vec![1.0])
    }

    /// Sizes of the units that the column may have as an angle [rad].
    fn angles(&self) -> Vec<f64> {
        match unit_of(Dimension::Angle, self.column.unit) {
            Some((_, size)) if !self.column.unit.is_empty() => vec![size],
            _ => vec![DEG, 1.0, 0.01 * DEG],
        }
    }

    /// The ratio of the way to that of the column in m/s; `None`: nothing moves.
    fn speed_ratio(&self) -> Option<f64> {
        let motion = self.motion(1.0, DEG);
        let [along_m, _] = self.ways();
        let is_moving = along_m > SLOW_M_S * self.duration_s() && !motion.is_at_rest();
        is_moving.then(|| motion.fit(&READINGS[0], false, 1.0).ratio)?
    }

    pub(super) fn duration_s(&self) -> f64 {
        self.rows[self.rows.len() - 1].0 - self.rows[0].0
    }

    /// Whether the rows show each turn.
    fn is_dense(&self) -> bool {
        median(self.rows.windows(2).map(|two| two[1].0 - two[0].0)).is_some_and(|step_s| step_s <= DENSE_S)
    }

    /// The way over ground, and up and down [m].
    fn ways(&self) -> [f64; 2] {
        let steps = self.rows.windows(2).map(|two| displacement(&two[0].2, &two[1].2));
        steps.fold([0.0; 2], |[along, up], [e, n, u]| [along + hypot(e, n), up + u.abs()])
    }

    fn speed(&self) -> Said {
        let Some(ratio) = self.speed_ratio().filter(|ratio| ratio.is_finite()) else { return Said::Nothing };
        // Numbers of few digits are right to half a step.
        let tolerance = AT_UNIT + 0.5 * self.relative_step();
        let sizes = self.sizes(Dimension::Speed);
        let near: Vec<&(&str, f64)> =
            sizes.iter().filter(|(_, size)| ln(ratio / size).abs() < tolerance).collect();
        if let [(unit, _)] = near[..] {
            return Said::Agrees(format!("speed in {unit}"));
        }
        if !near.is_empty() {
            return Said::Agrees("speed".to_owned());
        }
        // Another one may be through the air, or along the path.
        let words = unit_and_words(&self.column.name).1.concat();
        let may_contradict = match self.column.of_record {
            true => sizes.iter().all(|(_, size)| ln(ratio / size).abs() > RECORD_CONTRADICTS),
            false => OVER_GROUND.iter().any(|name| words.ends_with(name)),
        };
        if !may_contradict || !self.is_dense() {
            return Said::Unlike;
        }
        let stated = unit_of(Dimension::Speed, self.column.unit).map_or(1.0, |(_, size)| size);
        Said::Contradicts(times("the speed that flies", ratio / stated, self.column, Dimension::Speed).0)
    }

    /// The smallest step of the numbers, by their median.
    fn relative_step(&self) -> f64 {
        let steps = self.rows.windows(2).map(|two| (two[1].1 - two[0].1).abs()).filter(|step| *step > 0.0);
        let usual = median(self.rows.iter().map(|(_, value, _)| value.abs())).unwrap_or(0.0);
        let least = steps.fold(f64::INFINITY, f64::min);
        if usual > 0.0 && least.is_finite() { (least / usual).min(COARSEST) } else { 0.0 }
    }

    /// The median angle between the track and the column [deg], in that of its units that fits best; `None`: nothing moves.
    fn course_deg(&self) -> Option<f64> {
        self.speed_ratio()?;
        let fits = |size: f64| self.motion(1.0, size).fit(&READINGS[0], false, 1.0).course_deg;
        self.angles().into_iter().filter_map(fits).min_by(f64::total_cmp)
    }

    fn course(&self) -> Said {
        match self.course_deg() {
            None => Said::Nothing,
            Some(course_deg) if course_deg < COURSE_FITS_DEG => Said::Agrees("course".to_owned()),
            Some(_) if self.mirrored().is_some() => self.against(),
            Some(course_deg) if course_deg < CONTRADICTS_DEG || !self.is_dense() => Said::Unlike,
            Some(course_deg) => Said::Contradicts(format!("the track is {course_deg:.0} deg off its course")),
        }
    }

    /// What mirrors a path that turns where the column turns the other way.
    fn mirrored(&self) -> Option<&'static str> {
        let is_told =
            self.is_dense() && self.speed_ratio().is_some() && self.motion(1.0, DEG).turns(&READINGS[0]);
        let is_it = |(add, _): &(f64, &str)| {
            let fits = |size: f64| {
                let motion = self.motion(1.0, -size).turned(add * DEG);
                motion
                    .fit(&READINGS[0], false, 1.0)
                    .course_deg
                    .is_some_and(|off_deg| off_deg < COURSE_FITS_DEG)
            };
            self.angles().into_iter().any(fits)
        };
        MIRRORS.iter().find(|mirror| is_told && is_it(mirror)).map(|(_, why)| *why)
    }

    fn against(&self) -> Said {
        let why = self.mirrored().unwrap_or_default();
        Said::Contradicts(format!("the track turns the other way ({why})"))
    }

    /// The median angle between the heading that flies and the column [deg], in that of its units that fits best.
    fn heading_deg(&self) -> f64 {
        let off = |size: f64| {
            let turns =
                self.rows.iter().map(|(_, value, there)| wrap_angle(there.heading - value * size).abs());
            median(turns).unwrap_or(0.0) / DEG
        };
        self.angles().into_iter().map(off).fold(f64::INFINITY, f64::min)
    }

    fn heading(&self, has_attitude: bool) -> Said {
        let heading_deg = self.heading_deg();
        match heading_deg {
            _ if heading_deg < COURSE_FITS_DEG => Said::Agrees("heading".to_owned()),
            _ if !has_attitude && self.mirrored().is_some() => self.against(),
            // A heading that was assumed proves nothing.
            _ if !has_attitude || heading_deg < CONTRADICTS_DEG => Said::Unlike,
            _ => Said::Contradicts(format!("the heading that flies is {heading_deg:.0} deg off")),
        }
    }

    fn time(&self) -> Said {
        // Stamps of few digits need longer parts.
        let steps = self.rows.windows(2).map(|two| (two[1].1 - two[0].1).abs()).filter(|step| *step > 0.0);
        let least = TELLS * steps.fold(f64::INFINITY, f64::min);
        let all = (self.rows[self.rows.len() - 1].1 - self.rows[0].1).abs();
        let parts = ((all / least) as usize).min(PARTS);
        if parts == 0 {
            return Said::Nothing;
        }
        let size = (self.rows.len() - 1) / parts;
        let ratio = |value: fn(f64) -> f64| {
            let parts = self.rows.windows(size + 1).step_by(size);
            median(parts.map(|part| (value(part[size].1) - value(part[0].1)) / (part[size].0 - part[0].0)))
        };
        let Some(ratio_of_numbers) = ratio(|value| value).filter(|ratio| *ratio > 0.0) else {
            return Said::Nothing;
        };
        let stated = unit_of(Dimension::Time, self.column.unit).filter(|_| !self.column.unit.is_empty());
        let is_it = |ratio: f64, size: f64| ln(ratio / size).abs() < CLOCK_FITS;
        let fits = match stated {
            Some((_, size)) => is_it(ratio_of_numbers * size, 1.0),
            None if self.column.format.is_some() => is_it(ratio_of_numbers, 1.0),
            None => {
                CLOCKS.iter().any(|size| is_it(ratio_of_numbers, *size))
                    || ratio(hours_minutes_seconds).is_some_and(|ratio| is_it(ratio, 1.0))
            }
        };
        let size = stated.map_or(1.0, |(_, size)| size);
        match fits {
            true => Said::Agrees("time".to_owned()),
            // It counts something else: frames, ticks.
            false if stated.is_none() && self.column.format.is_none() => Said::Unlike,
            false => Said::Contradicts(format!(
                "it runs {} times as fast as the time that flies",
                short(ratio_of_numbers * size)
            )),
        }
    }

    /// Which quantity a column has whose name does not say it.
    fn any(&self, has_attitude: bool) -> Said {
        let of_speed = || {
            let unit = self.near(self.speed_ratio()?, Dimension::Speed, AT_UNIT)?;
            Some(format!("speed in {unit}")).filter(|_| self.motion(1.0, DEG).turns(&READINGS[0]))
        };
        let of_axis = |axis: usize| {
            let Follows { correlation, ratio } = self.follows(axis)?;
            let unit =
                self.near(ratio, Dimension::Speed, AT_UNIT).filter(|_| correlation.abs() > FOLLOWS_WELL)?;
            let sign = if correlation < 0.0 { "-" } else { "" };
            Some(format!("{sign}{} in {unit}", ["east", "north", "up"][axis]))
        };
        let of_height = || {
            let (follows, spreads) = self.heights();
            let Follows { correlation, ratio } = follows.filter(|_| spreads[0] > LOW_M)?;
            let unit = self.near(ratio, Dimension::Length, AT_UNIT).filter(|_| correlation > FOLLOWS_WELL)?;
            Some(format!("height in {unit}"))
        };
        let of_course = || {
            let turns = self.motion(1.0, DEG).turns(&READINGS[0]);
            let is_course =
                turns && self.course_deg().is_some_and(|course_deg| course_deg < COURSE_AGREES_DEG);
            let is_heading = turns && has_attitude && self.heading_deg() < COURSE_AGREES_DEG;
            (is_course || is_heading).then(|| if is_heading { "heading" } else { "course" }.to_owned())
        };
        let found = match self.column.like {
            Some(Like::Speed) => (0..3).find_map(of_axis).or_else(of_speed),
            Some(Like::Direction) => of_course(),
            Some(Like::Height) => of_height(),
            None => None,
        };
        found.map_or(Said::Unlike, Said::Agrees)
    }
}

/// Seconds of a number hhmmss.
fn hours_minutes_seconds(number: f64) -> f64 {
    let [hours, minutes] = [(number / 1e4).trunc(), (number / 100.0).trunc() % 100.0];
    3600.0 * hours + 60.0 * minutes + number % 100.0
}
