//! The parameters of both triads, of the mounting and of the clock together, by generalised least squares.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use super::axes::{Axes, find};
use super::blocks::{Block, Blocks};
use super::clock::search;
use super::noise::{COEFFICIENTS, Coefficients, Evidence, evidence};
use super::parameter::{PARAMETERS, Place, to_block_axes, turning_sign};
use super::path::{IdealPath, Six};
use super::whiten::{Columns, Steps};
use super::{Identified, Request, jump};
use crate::base::error::{Error, Rule};
use crate::base::math::{rotation_matrix, rotation_quaternion, rotation_vector};
use crate::base::memory::room;

/// Rounds of the fit, each about the last solution.
const ROUNDS: usize = 8;
/// Changes of clock [s] and mounting [rad] that end the rounds.
const CLOCK_DONE_S: f64 = 1e-7;
const MOUNTING_DONE: f64 = 1e-8;
/// Prior deviations of the shift of the clock about the one that was found [s], and of its drift [1].
pub(super) const CLOCK_S: f64 = 10.0;
pub(super) const DRIFT: f64 = 1e-4;
/// The priors of the noise of one sensor are wider than those of the parameters.
const WIDER: f64 = 30.0;

pub(super) type Vector = SVector<f64, PARAMETERS>;
pub(super) type Matrix = SMatrix<f64, PARAMETERS, PARAMETERS>;

/// About what the fit is linear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct About {
    /// Axes of the record = `axes` times those of the path.
    pub axes: Matrix3<f64>,
    /// Path time less record time at `middle_s` of the record [s], and its change [s/s].
    pub offset_s: f64,
    pub drift: f64,
    pub middle_s: f64,
    /// Angles of the mounting that `axes` has beside the exchange [rad], and those that the misalignments of both triads have in common.
    pub turned: Vector3<f64>,
    pub common: Vector3<f64>,
    /// The rotation of both [rad].
    pub mounting: Vector3<f64>,
}

impl About {
    fn path_time_s(&self, time_s: f64) -> f64 {
        time_s + self.offset_s + self.drift * (time_s - self.middle_s)
    }
}

/// The rows of the six sensors: record less path, and the columns of the coefficients.
pub(super) struct Rows {
    pub blocks: Vec<Block>,
    pub of_sensor: [Vec<Columns>; 6],
}

impl Rows {
    fn new(path: &IdealPath, blocks: &[Block], about: &About) -> Result<Self, Error> {
        let mut rows = Self { blocks: room(blocks.len())?, of_sensor: Default::default() };
        for sensor in &mut rows.of_sensor {
            *sensor = room(blocks.len())?;
        }
        let mut last: Option<f64> = None;
        for block in blocks {
            let ends = [block.start_s, block.end_s].map(|time| about.path_time_s(time));
            let Some((mean, change)) = path.mean(ends[0], ends[1]) else { continue };
            let turned = |signal: &Six, part: usize| about.axes * signal.fixed_rows::<3>(3 * part);
            // A block that the path does not have makes a gap too.
            let gap_s = last.map_or(0.0, |end_s| block.start_s - end_s);
            rows.blocks
                .push(Block { gap_s: if gap_s > 1e-3 * block.length_s() { gap_s } else { 0.0 }, ..*block });
            last = Some(block.end_s);
            let since_s = block.middle_s() - about.middle_s;
            for part in 0..2 {
                let (ideal, change) = (turned(&mean, part), turned(&change, part));
                for axis in 0..3 {
                    let rest = block.mean[3 * part + axis] - ideal[axis];
                    rows.of_sensor[3 * part + axis].push([
                        rest,
                        1.0,
                        ideal.x,
                        ideal.y,
                        ideal.z,
                        change[axis],
                        since_s * change[axis],
                    ]);
                }
            }
        }
        Ok(rows)
    }
}

/// Coefficients of a sensor by the parameters: bias, error matrix and mounting rotation φ, of which the record has φ×u more.
pub(super) fn coefficients(part: usize, axis: usize) -> SMatrix<f64, COEFFICIENTS, PARAMETERS> {
    let mut matrix = SMatrix::zeros();
    matrix[(0, Place::bias(part, axis))] = 1.0;
    for column in 0..3 {
        matrix[(1 + column, Place::element(part, axis, column))] = 1.0;
        // (φ×u) of this axis holds φ of the third axis, with the sign of the order.
        if column != axis {
            let third = 3 - axis - column;
            matrix[(1 + column, Place::mounting(third))] = turning_sign(axis, column);
        }
    }
    matrix[(4, Place::CLOCK)] = 1.0;
    matrix[(5, Place::DRIFT)] = 1.0;
    matrix
}

/// Finds clock, axes and parameters of a record along a path.
pub(super) fn identify(
    path: &IdealPath,
    record: &[super::RecordedIncrement],
    request: &Request,
) -> Result<Identified, Error> {
    request.validate()?;
    let Blocks { blocks, interval_s } = Blocks::new(record)?;
    let found = search(path, &blocks)?;
    let searched = find(path, &blocks, found.best.offset_s, request.axes.as_ref(), &request.prior);
    let (matched, offset_s) = match request.offset_s {
        Some(offset_s) => (find(path, &blocks, offset_s, request.axes.as_ref(), &request.prior)?, offset_s),
        None => {
            let matched = searched?;
            if let (true, Some(other)) = (matched.is_moving, found.other) {
                let rule = Rule::SentenceWith(
                    "shift of the clock that fits, and so does another one; state the shift. The other one [s]:",
                    other.offset_s.into(),
                );
                return Err(Error::invalid("request.offset_s", found.best.offset_s, rule));
            }
            // Without motion a shift is not seen: the clock is taken for that of the path.
            if matched.is_moving {
                (matched, found.best.offset_s)
            } else {
                (find(path, &blocks, 0.0, request.axes.as_ref(), &request.prior)?, 0.0)
            }
        }
    };
    if !matched.axes.is_seen && matched.axes.exchange != Matrix3::identity() {
        let rule = Rule::Sentence(
            "the axes of the record are not those of the path, and the motion does not show which they are: state them",
        );
        return Err(Error { field: "request.axes", rule, ..Error::bad_state("") });
    }
    let middle_s = 0.5 * (blocks[0].start_s + blocks[blocks.len() - 1].end_s);
    let start = About {
        axes: matched.axes.exchange,
        offset_s,
        drift: 0.0,
        middle_s,
        turned: Vector3::zeros(),
        common: Vector3::zeros(),
        mounting: Vector3::zeros(),
    };
    fit(path, &blocks, request, start, matched.axes, interval_s)
}

/// The rounds of the fit.
fn fit(
    path: &IdealPath,
    blocks: &[Block],
    request: &Request,
    start: About,
    axes: Axes,
    interval_s: f64,
) -> Result<Identified, Error> {
    let prior = request.prior_sigmas();
    let mut about = start;
    let mut shapes = [None; 6];
    for round in 0.. {
        let rows = Rows::new(path, blocks, &about)?;
        if rows.blocks.len() < 50 {
            let rule = Rule::Sentence("the path and the record have less than 50 blocks of time in common");
            return Err(Error::invalid("record.blocks", rows.blocks.len(), rule));
        }
        let is_last = round == ROUNDS;
        let (solution, evidences) = joint(&rows, request, &prior, &start, &about, &shapes)?;
        let (x, _) = solution;
        let turn = Vector3::from_fn(|k, _| x[Place::mounting(k)]);
        let changed = to_block_axes() * x;
        let common = Vector3::from_fn(|k, _| changed[Place::mounting(k)]) - turn;
        let clock_s =
            x[Place::CLOCK].abs() + x[Place::DRIFT].abs() * (blocks[blocks.len() - 1].end_s - about.middle_s);
        if is_last || (round > 0 && clock_s < CLOCK_DONE_S && (turn + common).norm() < MOUNTING_DONE) {
            // The last solution has the noise of all shapes.
            let (solution, evidences) = joint(&rows, request, &prior, &start, &about, &[None; 6])?;
            return finish(rows, request, solution, &evidences, about, axes, interval_s);
        }
        // No further than the linear range of the fit in one round.
        let part = 0.5 / (turn + common).norm().max(0.5);
        let step = rotation_quaternion(&((turn + common) * part));
        about.axes = rotation_matrix(&step) * about.axes;
        about.mounting = rotation_vector(&(step * rotation_quaternion(&about.mounting)));
        about.turned += turn * part;
        about.common += common * part;
        about.offset_s += x[Place::CLOCK].clamp(-2.0, 2.0);
        about.drift += x[Place::DRIFT];
        shapes = evidences.map(|evidence| Some(evidence.shape));
    }
    Err(Error::bad_state("the fit has no rounds"))
}

pub(super) type Solution = (Vector, Matrix);

/// One linear solution: parameters less those of `about`, and their covariance.
fn joint(
    rows: &Rows,
    request: &Request,
    prior: &Vector,
    start: &About,
    about: &About,
    shapes: &[Option<super::whiten::Shape>; 6],
) -> Result<(Solution, [Evidence; 6]), Error> {
    let steps = Steps::new(rows.blocks.iter());
    let (first, last) = (rows.blocks[0], rows.blocks[rows.blocks.len() - 1]);
    let span_s = last.end_s - first.start_s;
    let block_s = rows.blocks.iter().map(Block::length_s).sum::<f64>() / rows.blocks.len() as f64;
    let mut information = Matrix::from_diagonal(&prior.map(|sigma| 1.0 / (sigma * sigma)));
    // The priors of what `about` has are those of the whole, not of the rest.
    let mut expected = Vector::zeros();
    for k in 0..3 {
        expected[Place::mounting(k)] = -about.turned[k];
        let (row, column) = ((k + 1) % 3, (k + 2) % 3);
        for part in 0..2 {
            for (i, j) in [(row, column), (column, row)] {
                expected[Place::element(part, i, j)] = -about.common[k] * turning_sign(i, j);
            }
        }
    }
    expected[Place::CLOCK] = start.offset_s - about.offset_s;
    expected[Place::DRIFT] = -about.drift;
    let mut vector = information * expected;
    let mut evidences: [Option<Evidence>; 6] = [None; 6];
    for (sensor, found) in evidences.iter_mut().enumerate() {
        let (part, axis) = (sensor / 3, sensor % 3);
        let factor = prior[Place::element(part, axis, (axis + 1) % 3)]
            .max(prior[Place::element(part, axis, axis)])
            .max(request.prior.mounting);
        let scale = Coefficients::from_column_slice(&[
            prior[Place::bias(part, axis)],
            factor,
            factor,
            factor,
            CLOCK_S,
            DRIFT,
        ]) * WIDER;
        let one = evidence(&steps, &rows.of_sensor[sensor], (block_s, span_s), &scale, shapes[sensor])?;
        let by_parameters = coefficients(part, axis);
        information += by_parameters.transpose() * one.information * by_parameters;
        vector += by_parameters.transpose() * one.vector;
        *found = Some(one);
    }
    let evidences = evidences.map(Option::unwrap_or_default);
    // Scaled by the priors: the information has units of many sizes.
    let scaled = Matrix::from_fn(|i, j| prior[i] * information[(i, j)] * prior[j]);
    let unsolved =
        || Error::bad_state("the record and the path do not determine a fit: their signals are too large");
    let inverse = scaled.cholesky().ok_or_else(unsolved)?.inverse();
    let covariance = Matrix::from_fn(|i, j| prior[i] * inverse[(i, j)] * prior[j]);
    Ok(((covariance * vector, covariance), evidences))
}

/// The result, unless the clock of the record jumps.
fn finish(
    rows: Rows,
    request: &Request,
    (x, covariance): Solution,
    evidences: &[Evidence; 6],
    about: About,
    axes: Axes,
    interval_s: f64,
) -> Result<Identified, Error> {
    jump::check(&rows, evidences, &x, interval_s)?;
    let change = to_block_axes();
    let solution = (change * x, change * covariance * change.transpose());
    Ok(Identified::new(request, &solution, evidences.map(|one| one.noise), &about, axes, &rows))
}
