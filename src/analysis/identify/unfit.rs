//! What speaks against a record before its fit and against the fit itself.

use super::Identified;
use super::axes::SAME;
use super::blocks::{Block, FEWEST_INCREMENTS};
use super::clock::Search;
use super::parameter::{Estimate, Place};
use super::path::IdealPath;
use super::rows::Rows;
use super::solve::Fitted;
use super::whiten::Columns;
use crate::base::error::{Error, Rule};
use crate::base::memory::room;
use crate::base::records::rounded;

/// Fewest blocks of a fit.
const FEWEST: usize = FEWEST_INCREMENTS / 2;
/// The sensors in messages.
pub(super) const SENSORS: [&str; 6] = [
    "record.angle.x",
    "record.angle.y",
    "record.angle.z",
    "record.velocity.x",
    "record.velocity.y",
    "record.velocity.z",
];
/// Change of a sensor that stands still, as a part of its value.
const STILL: f64 = 1e-12;
/// Change of a path that moves along all axes, as a part of its largest motion, and root of its sum of squares \[rad/s\] or \[m/s²\]: less
/// is rounding.
const MOVES: f64 = 1e-2;
const LEAST: f64 = 1e-6;
/// Largest parameter, in standard deviations of its prior.
const OF_PRIOR: f64 = 8.0;
/// A block is a spike beyond this number of times the residual that the usual part of the blocks has, and beyond this part of the largest
/// signal of the path: residuals of sensors without noise are large where the path is interpolated.
const SPIKE: f64 = 30.0;
const USUAL: f64 = 0.98;
const OF_MOTION: f64 = 0.5;
/// Least part of the possible correlation of a force that the path has, and least change of a force that shows it [m/s²].
const OF_FORCES: f64 = 0.8;
const LEAST_FORCE: f64 = 0.1;

/// Rejects a record of which too little lies on the path at a shift of the clock.
pub(super) fn check_number(on_path: usize, blocks: &[Block]) -> Result<(), Error> {
    if on_path >= FEWEST {
        return Ok(());
    }
    let length_s = blocks.iter().map(Block::length_s).sum::<f64>() / blocks.len() as f64;
    let rule = Rule::SentenceWith(
        "blocks of the record lie on the path at the best shift of the clock; fewest 50. Length of a block [s]:",
        length_s.into(),
    );
    Err(Error::invalid("record.motion", on_path, rule))
}

/// Rejects a record with a gap that no path has: its rows before and behind the gap cannot both be of the path.
pub(super) fn check_gaps(path: &IdealPath, blocks: &[Block]) -> Result<(), Error> {
    let (begin_s, end_s) = path.ends_s()?;
    let Some(behind) = blocks.iter().find(|block| block.gap_s > end_s - begin_s) else { return Ok(()) };
    let rule = Rule::SentenceWith(
        "seconds without a record, longer than the path: the clock of the record jumps, or it holds several flights. The gap ends at [s]",
        behind.start_s.into(),
    );
    Err(Error::invalid("record.time_s", behind.gap_s, rule))
}

/// Rejects a sensor whose value never changes, while other sensors do and the path moves along all axes.
pub(super) fn check_stuck(search: &Search, blocks: &[Block]) -> Result<(), Error> {
    let is_still = |sensor: usize| {
        let values = || blocks.iter().map(|block| block.mean[sensor]);
        let (low, high) = values()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (value.min(low), value.max(high)));
        high - low <= STILL * high.abs().max(low.abs())
    };
    if (0..6).all(is_still) {
        return Ok(());
    }
    for sensor in (0..6).filter(|sensor| is_still(*sensor)) {
        let part = sensor / 3;
        let motion = |axis: usize| {
            search.ideal.iter().map(|cell| cell.1[3 * part + axis]).map(|u| u * u).sum::<f64>().sqrt()
        };
        let motions = [motion(0), motion(1), motion(2)];
        let least = (MOVES * motions.into_iter().fold(0.0, f64::max)).max(LEAST);
        if motions.iter().all(|one| *one > least) {
            let rule =
                Rule::Sentence("value of this sensor in the whole record, while the path moves: it is stuck");
            return Err(Error::invalid(SENSORS[sensor], blocks[0].mean[sensor], rule));
        }
    }
    Ok(())
}

/// Rejects a block in which a sensor has a value that neither the path nor its usual noise explains.
pub(super) fn check_spikes(fitted: &Fitted) -> Result<(), Error> {
    for (sensor, rows) in fitted.rows.of_sensor.iter().enumerate() {
        let solved = Place::coefficients(sensor, &fitted.solution[0].0);
        let mut rests: Vec<(f64, usize)> = room(rows.len())?;
        rests.extend(rows.iter().enumerate().map(|(row, columns)| {
            let explained: f64 = solved.iter().zip(&columns[1..]).map(|(c, column)| c * column).sum();
            ((columns[0] - explained).abs(), row)
        }));
        rests.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let usual = rests[(USUAL * (rests.len() - 1) as f64) as usize].0;
        let (largest, row) = rests[rests.len() - 1];
        let motion =
            rows.iter().flat_map(|columns| &columns[2..5]).fold(0.0, |most: f64, u| most.max(u.abs()));
        if largest > SPIKE * usual && largest > OF_MOTION * motion {
            let rule = Rule::SentenceWith(
                "mean of a block of this sensor, less what the path explains, over 30 times that of 98 % of the blocks: a spike. It is at [s]",
                fitted.rows.blocks[row].start_s.into(),
            );
            return Err(Error::invalid(SENSORS[sensor], largest, rule));
        }
    }
    Ok(())
}

/// What a record that cannot be fitted says instead of the symptom, if the rates of record and path agree, and the forces along an axis do
/// not: then the path has not the forces that the sensors measured.
pub(super) fn other_forces(rows: &Rows) -> Option<Error> {
    let of = |sensor: usize| Follows::new(&rows.of_sensor[sensor], sensor % 3);
    let rates = Follows::sum([of(0), of(1), of(2)]).correlation();
    let forces = [3, 4, 5].map(|sensor| (sensor, of(sensor)));
    let moving =
        forces.into_iter().filter(|(_, of_axis)| of_axis.ideal > of_axis.count * LEAST_FORCE * LEAST_FORCE);
    let qualities = moving.map(|(sensor, of_axis)| (sensor, of_axis.correlation(), of_axis.quality()));
    let (sensor, correlation, quality) = qualities.min_by(|a, b| a.2.total_cmp(&b.2))?;
    if rates < SAME || quality >= OF_FORCES {
        return None;
    }
    let rule = Rule::SentenceWith(
        "correlation of this sensor with the path, at least 0.8 if the path has its forces: the path has few or late fixes or an attitude on \
         another clock, or the sensor is on another clock than the gyros, is another one, or jumps. Correlation of the rates:",
        rounded(rates, 4).into(),
    );
    Some(Error::invalid(SENSORS[sensor], correlation, rule))
}

/// How a sensor follows the path: sums of squares and products over the blocks, each signal less its mean.
#[derive(Debug, Clone, Copy, Default)]
struct Follows {
    recorded: f64,
    ideal: f64,
    cross: f64,
    /// Sum of squares that the second differences of neighbouring blocks show.
    noise: f64,
    count: f64,
}

impl Follows {
    fn new(rows: &[Columns], axis: usize) -> Self {
        let ideal = |row: &Columns| row[2 + axis];
        let recorded = |row: &Columns| row[0] + ideal(row);
        let count = rows.len() as f64;
        let [recorded_mean, ideal_mean] =
            [rows.iter().map(recorded).sum::<f64>() / count, rows.iter().map(ideal).sum::<f64>() / count];
        let mut sums = Self { count, ..Self::default() };
        for row in rows {
            let (m, u) = (recorded(row) - recorded_mean, ideal(row) - ideal_mean);
            sums.recorded += m * m;
            sums.ideal += u * u;
            sums.cross += m * u;
        }
        let second = |w: &[Columns]| w[0][0] - 2.0 * w[1][0] + w[2][0];
        let square = |x: f64| x * x;
        // White noise has second differences of six times its variance.
        sums.noise = rows.windows(3).map(|w| square(second(w))).sum::<f64>() / 6.0;
        sums
    }

    fn sum(of: [Self; 3]) -> Self {
        of.into_iter().fold(Self::default(), |sum, one| Self {
            recorded: sum.recorded + one.recorded,
            ideal: sum.ideal + one.ideal,
            cross: sum.cross + one.cross,
            noise: sum.noise + one.noise,
            count: sum.count + one.count,
        })
    }

    fn correlation(&self) -> f64 {
        let size = (self.recorded * self.ideal).sqrt();
        if size > 0.0 { self.cross / size } else { 0.0 }
    }

    /// The correlation as a part of that which the noise leaves.
    fn quality(&self) -> f64 {
        let size = self.ideal + self.noise;
        let possible = if size > 0.0 { (self.ideal / size).sqrt() } else { 0.0 };
        self.correlation() / possible.max(0.5)
    }
}

/// Rejects parameters that sensors with these priors do not have: of sensors that are worse, or of signals that are others.
pub(super) fn check_priors(found: &Identified) -> Result<(), Error> {
    let check = |field: &'static str, index: Option<usize>, estimate: &Estimate| {
        let limit = OF_PRIOR * estimate.prior;
        if estimate.value.abs() <= limit {
            return Ok(());
        }
        let rule = Rule::SentenceWith(
            "beyond 8 standard deviations of its prior: worse than expected, or a sign, an axis or a unit is wrong. Limit:",
            limit.into(),
        );
        let error = Error::invalid(field, estimate.value, rule);
        Err(index.map_or(error, |index| error.at(index)))
    };
    check("record.drift", None, &found.drift)?;
    for axis in 0..3 {
        check("mounting.lever_arm", Some(axis), &found.lever_arm[axis])?;
        check("gyro.asymmetry", Some(axis), &found.gyro.asymmetry[axis])?;
        check("accelerometer.asymmetry", Some(axis), &found.accel.asymmetry[axis])?;
        check("gyro.bias_temperature", Some(axis), &found.gyro.bias_temperature[axis])?;
        check("accelerometer.bias_temperature", Some(axis), &found.accel.bias_temperature[axis])?;
        for column in 0..3 {
            check("gyro.g_sensitivity", Some(3 * axis + column), &found.g_sensitivity[axis][column])?;
        }
    }
    let triads = [
        (&found.gyro, ["gyro.bias", "gyro.scale_factor", "gyro.misalignment"]),
        (&found.accel, ["accelerometer.bias", "accelerometer.scale_factor", "accelerometer.misalignment"]),
    ];
    for (triad, [bias, scale_factor, misalignment]) in triads {
        for row in 0..3 {
            check(bias, Some(row), &triad.bias[row])?;
            for column in 0..3 {
                let (field, index) =
                    if row == column { (scale_factor, row) } else { (misalignment, 3 * row + column) };
                check(field, Some(index), &triad.elements[row][column])?;
            }
        }
    }
    Ok(())
}
