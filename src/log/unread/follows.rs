//! How what flies follows the numbers of a column: velocities and heights.

use super::Unread;
use super::compare::{Compared, Said};
use super::flown::There;
use crate::base::math::{ln, sin_cos};
use crate::log::quantity::{Dimension, unit_of, units_of};
use crate::log::survey::motion::{median, way};

/// Parts of the flight over which increments are compared: fewest, most, and shortest time of one [s].
const PARTS: [f64; 2] = [16.0, 512.0];
const PART_S: f64 = 2.0;

/// Slowest motion along an axis that is compared, in the mean of squares \[m/s\].
const STILL_M_S: f64 = 0.1;

/// Changes of a height below which it is level \[m\].
pub const LOW_M: f64 = 30.0;

/// Correlation above which one series follows another, and largest deviation of their ratio from a unit, as a logarithm: an instrument of
/// pressure errs by a tenth and more.
const FOLLOWS: f64 = 0.9;
const NEAR_UNIT: f64 = 0.2;

/// The same of a column whose name does not say its quantity.
pub const FOLLOWS_WELL: f64 = 0.98;
pub const AT_UNIT: f64 = 0.05;

/// Hundreds of feet, over metres.
const LEVEL: f64 = 30.48;

/// Largest offset of a height that is of another kind, and its share of the height.
const OFFSET_M: f64 = 300.0;
const OFFSET_SHARE: f64 = 0.15;

/// How one series follows another: their correlation, and the size of the first by that of the second.
pub struct Follows {
    pub correlation: f64,
    pub ratio: f64,
}

impl Compared<'_> {
    /// Increments of the way along an axis in parts of the flight, and those that the column says.
    pub(super) fn increments(&self, axis: usize) -> Vec<[f64; 2]> {
        let (first, duration_s) = (&self.rows[0], self.duration_s());
        let parts = (duration_s / PART_S).clamp(PARTS[0], PARTS[1]);
        let part_s = duration_s / parts;
        let mut increments = Vec::new();
        let (mut from, mut said, mut before) = (first, 0.0, first);
        for row in &self.rows[1..] {
            said += 0.5 * (before.1 + row.1) * (row.0 - before.0);
            before = row;
            if row.0 - from.0 >= part_s {
                increments.push([displacement(&from.2, &row.2)[axis], said]);
                (from, said) = (row, 0.0);
            }
        }
        increments
    }

    /// How the way along an axis follows the column, as a velocity in m/s; `None`: neither moves.
    pub(super) fn follows(&self, axis: usize) -> Option<Follows> {
        let increments = self.increments(axis);
        let duration_s = self.duration_s();
        let follows = Follows::new(&increments)?;
        let rms =
            (increments.iter().map(|[flown, _]| flown * flown).sum::<f64>() / increments.len() as f64).sqrt();
        (rms * increments.len() as f64 > STILL_M_S * duration_s).then_some(follows)
    }

    pub(super) fn component(&self, axis: usize) -> Said {
        let Some(Follows { correlation, ratio }) = self.follows(axis) else { return Said::Nothing };
        let correlation = correlation * self.column.sign;
        let name = ["east", "north", "up"][axis];
        if correlation.abs() < FOLLOWS {
            return Said::Unlike;
        }
        if correlation < 0.0 {
            return Said::Contradicts(format!("the velocity {name} that flies has the opposite sign"));
        }
        match self.near(ratio, Dimension::Speed, NEAR_UNIT) {
            Some(unit) => Said::Agrees(format!("{name} in {unit}")),
            // A variometer lags, and so its swings are smaller.
            None if correlation < FOLLOWS_WELL => Said::Unlike,
            None => {
                let stated = unit_of(Dimension::Speed, self.column.unit).map_or(1.0, |(_, size)| size);
                let what = format!("the velocity {name} that flies");
                contradicts_by_unit(times(&what, ratio / stated, self.column, Dimension::Speed))
            }
        }
    }

    /// The unit of the column by a ratio of sizes in SI.
    pub(super) fn near(&self, ratio: f64, dimension: Dimension, tolerance: f64) -> Option<&'static str> {
        let misfit = |size: f64| ln(ratio / size).abs();
        let sizes = self.sizes(dimension).into_iter().filter(|(_, size)| misfit(*size) < tolerance);
        sizes.min_by(|(_, one), (_, other)| misfit(*one).total_cmp(&misfit(*other))).map(|(unit, _)| unit)
    }

    /// How the height that flies follows the column, and the spreads of both in the units of the table \[m\].
    pub(super) fn heights(&self) -> (Option<Follows>, [f64; 2]) {
        let series: Vec<[f64; 2]> =
            self.rows.iter().map(|(_, value, there)| [there.height_m, *value]).collect();
        let mean = |of: usize| series.iter().map(|two| two[of]).sum::<f64>() / series.len() as f64;
        let means = [mean(0), mean(1)];
        let changes: Vec<[f64; 2]> = series.iter().map(|[a, b]| [a - means[0], b - means[1]]).collect();
        let spread = |of: usize| {
            (changes.iter().map(|two| two[of] * two[of]).sum::<f64>() / changes.len() as f64).sqrt()
        };
        (Follows::new(&changes), [spread(0), spread(1)])
    }

    pub(super) fn height(&self) -> Said {
        let sizes = self.sizes(Dimension::Length);
        let usual = median(self.rows.iter().map(|(.., there)| there.height_m.abs())).unwrap_or(0.0);
        let is_near = |size: f64| {
            let off = self.rows.iter().map(|(_, value, there)| (value * size - there.height_m).abs());
            median(off).is_some_and(|off| off <= OFFSET_M + OFFSET_SHARE * usual)
        };
        let agrees = |unit: &str| Said::Agrees(format!("height in {unit}"));
        let (follows, spreads) = self.heights();
        let stated = unit_of(Dimension::Length, self.column.unit).map_or(1.0, |(_, size)| size);
        if spreads[0] < LOW_M && spreads[1] * stated < LOW_M {
            let near = sizes.iter().find(|(_, size)| is_near(*size));
            return near.map_or(Said::Unlike, |_| Said::Agrees("height".to_owned()));
        }
        // So are one of the ground, and an elevation that is an angle.
        let Some(Follows { correlation, ratio }) = follows.filter(|follows| follows.correlation > FOLLOWS)
        else {
            return Said::Unlike;
        };
        match self.near(ratio, Dimension::Length, NEAR_UNIT) {
            Some(unit) if unit_of(Dimension::Length, unit).is_some_and(|(_, size)| is_near(size)) => {
                agrees(unit)
            }
            // So a height counts that is one above the ground or the take-off.
            Some(_) => Said::Unlike,
            None if correlation < FOLLOWS_WELL => Said::Unlike,
            None => {
                let what = "the change of the height that flies";
                contradicts_by_unit(times(what, ratio / stated, self.column, Dimension::Length))
            }
        }
    }
}

impl Follows {
    /// Of pairs; `None`: the first are all 0, or the second.
    fn new(pairs: &[[f64; 2]]) -> Option<Self> {
        let sum = |of: fn(&[f64; 2]) -> f64| pairs.iter().map(of).sum::<f64>();
        let [first, second] = [sum(|[a, _]| a * a), sum(|[_, b]| b * b)];
        let size = (first * second).sqrt();
        let ratio = (first / second).sqrt();
        (size > 0.0).then(|| Self { correlation: sum(|[a, b]| a * b) / size, ratio })
    }
}

/// A displacement east, north, up \[m\].
pub fn displacement(from: &There, to: &There) -> [f64; 3] {
    let (way_m, track) = way([from.latitude, from.longitude], [to.latitude, to.longitude]);
    let (sine, cosine) = sin_cos(track);
    [way_m * sine, way_m * cosine, to.height_m - from.height_m]
}

/// Only what another unit explains is a contradiction: a part of a quantity follows it too.
fn contradicts_by_unit((sentence, is_explained): (String, bool)) -> Said {
    if is_explained { Said::Contradicts(sentence) } else { Said::Unlike }
}

/// What flies is so many times that of a column in a unit, and whether another unit explains this.
pub fn times(what: &str, ratio: f64, column: &Unread, dimension: Dimension) -> (String, bool) {
    let unit = column.unit;
    let of = unit_of(dimension, unit).map_or(1.0, |(_, size)| size);
    let find = |size_of: f64, is: &str| {
        let near = |(other, size): &(&str, f64)| *other != unit && ln(size_of / size).abs() < AT_UNIT;
        let found = units_of(dimension).filter_map(|other| unit_of(dimension, other)).find(near);
        found.map(|(other, _)| format!(" (is {is} in {other}?)"))
    };
    // The units of a record's positions are defined.
    let in_levels =
        || (ln(of / ratio / LEVEL).abs() < AT_UNIT).then(|| " (is what flies in flight levels?)".to_owned());
    let of_flown = || find(of / ratio, "what flies").or_else(in_levels).filter(|_| !column.of_record);
    let explained = find(ratio * of, "it").or_else(of_flown);
    let is_explained = explained.is_some();
    (format!("{what} is {} times that of it{}", short(ratio), explained.unwrap_or_default()), is_explained)
}

/// A number with three digits.
pub fn short(value: f64) -> String {
    let decimals = if value >= 100.0 {
        0
    } else if value >= 10.0 {
        1
    } else if value >= 1.0 {
        2
    } else {
        4
    };
    format!("{value:.decimals$}")
}
