//! The parameters of both triads, of the mounting and of the clock together, by generalised least squares.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use super::axes::{Axes, find};
use super::beyond::check_beyond;
use super::blocks::{Block, Blocks};
use super::clock::{KNOWN_S, MUCH, Search};
use super::jump::{self, Jump};
use super::noise::{Coefficients, Evidence, Shapes, TOO_EXACT, evidences};
use super::parameter::{PARAMETERS, Place, common_rotation, to_block_axes, turning_sign};
use super::path::IdealPath;
use super::rows::{About, Rows, coefficients};
use super::unfit::{check_gaps, check_number, check_priors, check_spikes, check_stuck, other_forces};
use super::walk::walks;
use super::whiten::Steps;
use super::{Identified, Request, pieces};
use crate::base::error::{Error, Rule};
use crate::base::math::{rotation_matrix, rotation_quaternion, rotation_vector};
use crate::base::memory::{only, room};

/// Rounds of the fit, each about the last solution.
const ROUNDS: usize = 16;
/// Changes of clock [s] and mounting [rad] that end the rounds.
const CLOCK_DONE_S: f64 = 1e-7;
const MOUNTING_DONE: f64 = 1e-8;
/// Largest step of the last round, in standard deviations of the solution: a larger one shows that the fit does not converge.
const LAST_STEP: f64 = 0.1;
/// Prior deviations of the shift of the clock about the one that was found [s], and of its drift [1].
pub(super) const CLOCK_S: f64 = KNOWN_S;
pub(super) const DRIFT: f64 = 1e-4;
/// Least time in common of a shift that is not stated, as a part of the shorter one of path and record.
const LEAST_COMMON: f64 = 0.5;
/// Rounds in which the path gets the lever arm that was found.
const LEVER_ROUNDS: usize = 2;
/// Rounds in which size and time of a jump of the clock are found.
const JUMP_ROUNDS: usize = 8;
/// Change of the size of a jump that ends these rounds [s].
const JUMP_DONE_S: f64 = 1e-4;
/// The priors of the noise of one sensor are wider than those of the parameters.
const WIDER: f64 = 30.0;

pub(super) type Vector = SVector<f64, PARAMETERS>;
pub(super) type Matrix = SMatrix<f64, PARAMETERS, PARAMETERS>;

/// Finds clock, axes and parameters of a record along a path.
pub(super) fn identify(
    path: &IdealPath,
    record: &[super::RecordedIncrement],
    request: &Request,
) -> Result<Identified, Error> {
    request.validate()?;
    if request.also.temperature && path.temperature_c(0.0).is_none() {
        let rule = Rule::Sentence("needs samples of the path with a temperature");
        return Err(Error { value: None, ..Error::invalid("request.also.temperature", 1.0, rule) });
    }
    let Blocks { blocks, interval_s } = Blocks::new(record, request.cutoff_hz)?;
    check_gaps(path, &blocks)?;
    let search = Search::new(path, &blocks, request.shift_s)?;
    check_stuck(&search, &blocks)?;
    if let Some(jump) = pieces::large(&search, path, &blocks)? {
        // Two shifts also fit better than one if the clock drifts: the fit tells.
        let jump = refined(path, &blocks, request, jump);
        if jump.is_large(interval_s) {
            return Err(jump.error(&blocks));
        }
    }
    let mut start = begin(path, &blocks, &search, request)?;
    let mut fitted = fit(path, &blocks, request, start)?;
    // The rows are linear in the lever arm but for what changes within a block; the path has all of it.
    let mut moved = None;
    for _ in 0..if request.also.lever_arm { LEVER_ROUNDS } else { 0 } {
        start.0.lever_b = fitted.lever_b();
        let moved = moved.insert(path.clone().with_lever_arm(&start.0.lever_b)?);
        fitted = fit(moved, &blocks, request, start)?;
    }
    let (path, fitted) = (moved.as_ref().unwrap_or(path), &fitted);
    // Where the path lacks the forces, a jump and a parameter beyond its prior are its traces in the fit.
    let cause = |error: Error| other_forces(&fitted.rows).unwrap_or(error);
    if let Some(jump) = jump::small(fitted, blocks.len(), interval_s)? {
        let jump = refined(path, &blocks, request, jump);
        if jump.is_large(interval_s) {
            return Err(cause(jump.error(&blocks)));
        }
    }
    check_spikes(fitted)?;
    let left_g_sensitivity = check_beyond(fitted, request.also, cause)?;
    let found = Identified { left_g_sensitivity, ..concluded(fitted, request, start.1)? };
    check_priors(&found).map_err(cause)?;
    Ok(found)
}

/// What a fit says of the sensors, in the axes of the block. Not inlined, as all that holds matrices: they are not on the stack at once.
#[inline(never)]
fn concluded(fitted: &Fitted, request: &Request, axes: Axes) -> Result<Identified, Error> {
    let change = to_block_axes();
    let solution = changed(&change, fitted)?;
    let for_twins = (root(&change, fitted)?, walks(fitted)?);
    Ok(Identified::new(request, &change, &solution[0], for_twins, fitted, axes))
}

/// The solution in the axes of the block.
#[inline(never)]
fn changed(change: &Matrix, fitted: &Fitted) -> Result<InMemory<Solution>, Error> {
    let [(x, covariance)] = &*fitted.solution;
    let mut solution = in_memory(no_solution)?;
    let [(changed, of_block)] = &mut *solution;
    changed.gemv(1.0, change, x, 0.0);
    let half = change * covariance;
    of_block.gemm(1.0, &half, &change.transpose(), 0.0);
    Ok(solution)
}

/// A square root of the covariance in the axes of the block, scaled by the priors: times normal numbers, it gives errors of the solution.
#[inline(never)]
fn root(change: &Matrix, fitted: &Fitted) -> Result<InMemory<Matrix>, Error> {
    let ([(_, covariance)], prior) = (&*fitted.solution, &fitted.prior);
    let scaled = Matrix::from_fn(|i, j| covariance[(i, j)] / (prior[i] * prior[j]));
    let mut factor = scaled.cholesky().ok_or_else(|| Error::bad_state(TOO_EXACT))?.unpack();
    factor.row_iter_mut().zip(prior).for_each(|(mut row, sigma)| row *= *sigma);
    let mut root = in_memory(Matrix::zeros)?;
    root[0].gemm(1.0, change, &factor, 0.0);
    Ok(root)
}

/// A value beside the stack.
pub(super) type InMemory<T> = Box<[T; 1]>;

#[inline(never)]
pub(super) fn in_memory<T>(make: fn() -> T) -> Result<InMemory<T>, Error> {
    let mut place = room(1)?;
    place.push(make());
    only(place)
}

fn no_solution() -> Solution {
    (Vector::zeros(), Matrix::zeros())
}

/// Size and time of a jump by fits of the record without it.
#[inline(never)]
fn refined(path: &IdealPath, blocks: &[Block], request: &Request, mut jump: Jump) -> Jump {
    // A round that moves much further than the one before follows the rounding of a record without noise.
    let mut last_step_s = f64::INFINITY;
    for _ in 0..JUMP_ROUNDS {
        let better = || {
            let moved = jump.undone(blocks)?;
            let start = begin(path, &moved, &Search::new(path, &moved, request.shift_s)?, request)?;
            jump.better(path, blocks, &fit(path, &moved, request, start)?)
        };
        let Ok(better) = better() else { break };
        let step_s = (better.change_s - jump.change_s).abs();
        let is_done = step_s <= JUMP_DONE_S && better.behind == jump.behind;
        if is_done || step_s > 2.0 * last_step_s.max(JUMP_DONE_S) {
            break;
        }
        (jump, last_step_s) = (better, step_s);
    }
    jump
}

/// Where the fit begins: shift of the clock and exchange of axes.
fn begin(
    path: &IdealPath,
    blocks: &[Block],
    search: &Search,
    request: &Request,
) -> Result<(About, Axes), Error> {
    let found = search.shift(path, blocks, request.shift_s)?;
    let axes_at = |offset_s: f64| find(path, blocks, offset_s, request);
    let mut offset_s = found.best.offset_s;
    let at_best = axes_at(offset_s);
    let is_still = at_best.as_ref().is_ok_and(|matched| !matched.is_moving);
    if request.shift_s.is_none() && !is_still {
        check_common(path, blocks, offset_s)?;
    }
    let mut matched = at_best?;
    if request.shift_s.is_none() && matched.is_moving && search.explained < MUCH {
        let rule = Rule::Sentence(
            "part of the record that the path explains at the best shift of the clock, at least 0.25: too little motion stands out of the \
             noise to find the shift, which must be stated, or the record is of another motion",
        );
        return Err(Error::invalid("record.motion", 0.5 * search.explained, rule));
    }
    if !matched.is_moving {
        // Without motion a shift is not seen: the clock is taken for that of the path.
        offset_s = request.shift_s.unwrap_or(0.0);
        if request.shift_s.is_none() {
            check_common(path, blocks, offset_s)?;
        }
        matched = axes_at(offset_s)?;
    } else if let Some(other) = found.other {
        let rule = Rule::SentenceWith(
            "shift of the clock that fits, and so does another one; state the shift. The other one [s]:",
            other.offset_s.into(),
        );
        return Err(Error::invalid("request.shift_s", found.best.offset_s, rule));
    }
    if !matched.axes.is_seen && matched.axes.exchange != Matrix3::identity() {
        let rule = Rule::Sentence(
            "the axes of the record are not those of the path, and the motion does not show which they are: state them",
        );
        return Err(Error { field: "request.axes", rule, ..Error::bad_state("") });
    }
    let about = About {
        axes: matched.axes.exchange,
        offset_s,
        drift: 0.0,
        middle_s: 0.5 * (blocks[0].start_s + blocks[blocks.len() - 1].end_s),
        last_s: blocks[blocks.len() - 1].end_s,
        turned: Vector3::zeros(),
        common: Vector3::zeros(),
        mounting: Vector3::zeros(),
        lever_b: Vector3::zeros(),
        reference_c: request.also.temperature.then(|| mean_temperature_c(path, blocks, offset_s)),
        also: request.also,
    };
    Ok((about, matched.axes))
}

/// Mean temperature of the blocks, by the samples of the path [°C].
fn mean_temperature_c(path: &IdealPath, blocks: &[Block], offset_s: f64) -> f64 {
    let temperature_c = |block: &Block| path.temperature_c(block.middle_s() + offset_s);
    let of_block = |block: &Block| Some((block.length_s(), temperature_c(block)?));
    let add =
        |sum: (f64, f64), (length_s, temperature_c)| (sum.0 + length_s, sum.1 + length_s * temperature_c);
    let (length_s, sum) = blocks.iter().filter_map(of_block).fold((0.0, 0.0), add);
    sum / length_s
}

/// Rejects a shift at which path and record have little time in common: short motions resemble each other.
fn check_common(path: &IdealPath, blocks: &[Block], offset_s: f64) -> Result<(), Error> {
    let (begin_s, end_s) = path.ends_s()?;
    let (first_s, last_s) = (blocks[0].start_s, blocks[blocks.len() - 1].end_s);
    let common_s = end_s.min(last_s + offset_s) - begin_s.max(first_s + offset_s);
    if common_s < LEAST_COMMON * (end_s - begin_s).min(last_s - first_s) {
        let rule = Rule::Sentence(
            "seconds that the record and the path have in common at the shift of the clock that fits best, or at none if no motion shows it, \
             less than half of the shorter one: the record is of another motion, or its shift must be stated",
        );
        return Err(Error::invalid("record.motion", common_s, rule));
    }
    Ok(())
}

/// What a fit has found.
pub(super) struct Fitted {
    pub rows: Rows,
    /// About `about`.
    pub solution: InMemory<Solution>,
    pub evidences: [Evidence; 6],
    pub about: About,
    /// Standard deviations of the parameters before the record.
    pub prior: Vector,
}

impl Fitted {
    /// The lever arm that was found [m], axes of the path.
    fn lever_b(&self) -> Vector3<f64> {
        let more = Vector3::from_fn(|axis, _| self.solution[0].0[Place::lever_arm(axis)]);
        self.about.lever_b + self.about.axes.transpose() * more
    }
}

/// The rounds of the fit.
#[inline(never)]
fn fit(
    path: &IdealPath,
    blocks: &[Block],
    request: &Request,
    (start, _): (About, Axes),
) -> Result<Fitted, Error> {
    let prior = request.prior_sigmas();
    let mut about = start;
    let mut shapes = Shapes::All;
    for round in 0.. {
        let rows = Rows::new(path, blocks, &about)?;
        check_number(rows.blocks.len(), blocks)?;
        let is_last = round == ROUNDS;
        let (solution, evidences) = joint(&rows, request, &prior, &start, &about, shapes)?;
        let [(x, _)] = &*solution;
        let turn = Vector3::from_fn(|k, _| x[Place::mounting(k)]);
        let common = common_rotation(x);
        let clock_s = x[Place::CLOCK].abs() + x[Place::DRIFT].abs() * (about.last_s - about.middle_s);
        if is_last || (round > 0 && clock_s < CLOCK_DONE_S && (turn + common).norm() < MOUNTING_DONE) {
            if is_last {
                check_converged(&solution[0])?;
            }
            // The last solution has the noise of all shapes.
            let (solution, evidences) = joint(&rows, request, &prior, &start, &about, Shapes::All)?;
            return Ok(Fitted { rows, solution, evidences, about, prior });
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
        shapes = Shapes::Of(evidences.map(|evidence| evidence.shape));
    }
    Err(Error::bad_state("the fit has no rounds"))
}

/// Rejects a fit whose last round still moves the clock or the mounting, about which it is linear.
fn check_converged((x, covariance): &Solution) -> Result<(), Error> {
    let in_sigmas = |place: usize| x[place].abs() / covariance[(place, place)].max(0.0).sqrt();
    let places = [Place::mounting(0), Place::mounting(1), Place::mounting(2), Place::CLOCK, Place::DRIFT];
    let step = places.into_iter().map(in_sigmas).fold(0.0, f64::max);
    if step <= LAST_STEP {
        return Ok(());
    }
    let rule = Rule::SentenceWith(
        "standard deviations by which the last round of the fit still moves the clock or the mounting: the fit does not converge. Limit:",
        LAST_STEP.into(),
    );
    Err(Error::invalid("record.fit", step, rule))
}

pub(super) type Solution = (Vector, Matrix);

/// One linear solution: parameters less those of `about`, and their covariance.
#[inline(never)]
fn joint(
    rows: &Rows,
    request: &Request,
    prior: &Vector,
    start: &About,
    about: &About,
    shapes: Shapes,
) -> Result<(InMemory<Solution>, [Evidence; 6]), Error> {
    let steps = Steps::new(&rows.blocks)?;
    let (first, last) = (rows.blocks[0], rows.blocks[rows.blocks.len() - 1]);
    let span_s = last.end_s - first.start_s;
    let block_s = rows.blocks.iter().map(Block::length_s).sum::<f64>() / rows.blocks.len() as f64;
    let mut solution = in_memory(no_solution)?;
    let [(x, information)] = &mut *solution;
    information.set_diagonal(&prior.map(|sigma| 1.0 / (sigma * sigma)));
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
    let lever = about.axes * about.lever_b;
    (0..3).for_each(|axis| expected[Place::lever_arm(axis)] = -lever[axis]);
    expected[Place::CLOCK] = start.offset_s - about.offset_s;
    expected[Place::DRIFT] = -about.drift;
    let mut vector = *information * expected;
    let scales = core::array::from_fn(|sensor| {
        let (part, axis) = (sensor / 3, sensor % 3);
        let factor = prior[Place::element(part, axis, (axis + 1) % 3)]
            .max(prior[Place::element(part, axis, axis)])
            .max(request.prior.mounting);
        let bias = prior[Place::bias(part, axis)];
        let beside = if part == 0 { Place::g_sensitivity(axis, 0) } else { Place::lever_arm(0) };
        let (beside, asymmetry) = (prior[beside], prior[Place::asymmetry(part, axis)]);
        let warming = prior[Place::bias_temperature(part, axis)];
        let always = [bias, factor, factor, factor, CLOCK_S, DRIFT];
        let all = always.into_iter().chain([beside, beside, beside, asymmetry, warming]);
        Coefficients::from_iterator(all) * WIDER
    });
    let evidences = evidences(&steps, &rows.of_sensor, (block_s, span_s), &scales, shapes)?;
    for (sensor, one) in evidences.iter().enumerate() {
        let by_parameters = coefficients(sensor / 3, sensor % 3);
        let half = by_parameters.transpose() * one.information;
        information.gemm(1.0, &half, &by_parameters, 1.0);
        vector += by_parameters.transpose() * one.vector;
    }
    invert(information, prior).ok_or_else(|| Error::bad_state(TOO_EXACT))?;
    x.gemv(1.0, information, &vector, 0.0);
    Ok((solution, evidences))
}

/// Inverts an information, scaled by the priors: it has units of many sizes.
#[inline(never)]
pub(super) fn invert(information: &mut Matrix, prior: &Vector) -> Option<()> {
    scale(information, prior);
    let factor = information.cholesky()?;
    information.fill_with_identity();
    factor.solve_mut(information);
    scale(information, prior);
    Some(())
}

fn scale(matrix: &mut Matrix, by: &Vector) {
    for (k, factor) in by.iter().enumerate() {
        matrix.row_mut(k).scale_mut(*factor);
        matrix.column_mut(k).scale_mut(*factor);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The last step of a fit may be a tenth of the standard deviation of the clock and of each angle; other parameters are linear.
    #[test]
    fn a_last_step_beyond_a_tenth_of_its_deviation_is_an_error() {
        let covariance = Matrix::identity() * 4e-6;
        let with = |place: usize, step: f64| {
            let mut x = Vector::zeros();
            x[place] = step;
            check_converged(&(x, covariance))
        };
        for place in [Place::mounting(0), Place::mounting(2), Place::CLOCK, Place::DRIFT] {
            assert!(with(place, -1.9e-4).is_ok(), "{place}");
            let error = with(place, -2.1e-4).unwrap_err().to_string();
            assert!(error.starts_with("record.fit = 0.105") && error.ends_with("Limit: 0.1"), "{error}");
        }
        assert!(with(Place::bias(0, 0), 1.0).is_ok());
    }
}
