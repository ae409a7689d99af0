//! Whether the clock of the record jumps against that of the path.

use nalgebra::{SMatrix, SVector};

use super::blocks::Block;
use super::clock::KNOWN_S;
use super::noise::{COEFFICIENTS, Coefficients, Evidence, Information};
use super::parameter::{PARAMETERS, Place};
use super::path::IdealPath;
use super::rows::{Rows, coefficients};
use super::solve::{Fitted, InMemory, Matrix, Vector, in_memory, invert};
use super::whiten::{COLUMNS, Columns, Shape, Steps};
use crate::base::error::{Error, Rule};
use crate::base::memory::{filled, room};

/// A jump is certain at this number of standard deviations, with some for the choice of its time, and large at this part of an interval.
const CERTAIN: f64 = 8.0;
const LARGE: f64 = 0.5;
/// The residual of a fit shows too small a jump, because a part of the motion counts as slow noise there. This part of a large one is worth
/// a fit without it.
const SHOWN: f64 = 0.5;
/// Column of the change by a shift.
const CHANGE: usize = 5;
/// Parameters and a jump.
const WIDE: usize = PARAMETERS + 1;

/// A jump of the clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Jump {
    /// Number of the first block behind the jump.
    pub behind: usize,
    /// Change of path time less record time [s].
    pub change_s: f64,
}

impl Jump {
    /// The blocks on the clock that the record has before the jump.
    pub fn undone(&self, blocks: &[Block]) -> Result<Vec<Block>, Error> {
        moved(blocks, |place| if place < self.behind { 0.0 } else { self.change_s })
    }

    /// The jump by a fit of the blocks without it, about which all is linear. Of the times between two blocks, the most likely one has the
    /// least sum of squares, with the parameters and the size of the jump solved for that time:
    /// ```text
    /// Σ before |e(clock before) - X δ|² + Σ behind |e(clock behind) - X δ - d δ_jump|² + |δ|²/prior²
    /// ```
    /// The noise counts as white: a filter of slow noise would remember the wrong clock behind the jump.
    #[inline(never)]
    pub fn better(&self, path: &IdealPath, blocks: &[Block], fitted: &Fitted) -> Result<Self, Error> {
        let on_clock = |change_s: f64| {
            let rows = Rows::new(path, &moved(blocks, |_| change_s)?, &fitted.about)?;
            let mut whites = filled(blocks.len(), None)?;
            whitened(
                fitted,
                &rows,
                |_| Shape::default(),
                |place, sensor, rest, columns| {
                    let of_sensor = &mut whites[place].get_or_insert([[0.0; COLUMNS]; 6])[sensor];
                    *of_sensor = *columns;
                    of_sensor[0] = rest;
                },
            )?;
            Ok::<_, Error>(whites)
        };
        let (before, after) = (on_clock(0.0)?, on_clock(self.change_s)?);
        // Of a block that one of the clocks brings outside the path, nothing is said.
        let both = || before.iter().zip(&after).map(|(a, b)| Some((a.as_ref()?, b.as_ref()?)));
        let mut system = System::new(&fitted.prior);
        both().flatten().for_each(|(of_before, _)| system.add(of_before, 1.0, 0.0));
        let mut best = (f64::INFINITY, *self);
        for (behind, pair) in both().enumerate().rev() {
            let Some((of_before, of_behind)) = pair else { continue };
            system.add(of_before, -1.0, 0.0);
            system.add(of_behind, 1.0, 1.0);
            if let Some((squares, left_s)) = system.solved().filter(|solved| solved.0 < best.0) {
                best = (squares, Self { behind, change_s: self.change_s + left_s.clamp(-1.0, 1.0) });
            }
        }
        Ok(best.1)
    }

    /// Whether it is more than the scatter of good stamps.
    pub fn is_large(&self, interval_s: f64) -> bool {
        self.change_s.abs() > LARGE * interval_s
    }

    /// What is wrong with the record.
    pub fn error(&self, blocks: &[Block]) -> Error {
        let at_s = blocks.get(self.behind).or(blocks.last()).map_or(0.0, |block| block.start_s);
        let rule =
            Rule::SentenceWith("jump of the clock of the record [s], about at its time [s]", at_s.into());
        // What the path time less the record time loses, the clock has gained.
        Error::invalid("record.time_s", -self.change_s, rule)
    }
}

fn moved(blocks: &[Block], by_s: impl Fn(usize) -> f64) -> Result<Vec<Block>, Error> {
    let mut moved = room(blocks.len())?;
    moved.extend(blocks.iter().enumerate().map(|(place, block)| {
        let by_s = by_s(place);
        Block { start_s: block.start_s + by_s, end_s: block.end_s + by_s, ..*block }
    }));
    Ok(moved)
}

/// A jump that the residual of a fit shows: the most certain one.
#[inline(never)]
pub(super) fn small(fitted: &Fitted, count: usize, interval_s: f64) -> Result<Option<Jump>, Error> {
    let parts = Parts::new(fitted, count)?;
    let mut behind = Part::default();
    let mut best: Option<(f64, Jump)> = None;
    for (place, part) in parts.of_block.iter().enumerate().skip(1).rev() {
        behind.add(part);
        let Some((change_s, sigma_s)) = parts.jump(&behind) else { continue };
        let deviations = change_s.abs() / sigma_s;
        let is_jump = deviations > CERTAIN && change_s.abs() > SHOWN * LARGE * interval_s;
        if is_jump && best.is_none_or(|best| deviations > best.0) {
            best = Some((deviations, Jump { behind: place, change_s }));
        }
    }
    Ok(best.map(|best| best.1))
}

/// Sums over blocks, in units of the noise: whitened changes d by a shift of the clock times the columns X of all parameters, and times
/// themselves and the residual e.
#[derive(Debug, Clone, Copy)]
struct Part {
    along: Vector,
    square: f64,
    rest: f64,
}

impl Default for Part {
    fn default() -> Self {
        Self { along: Vector::zeros(), square: 0.0, rest: 0.0 }
    }
}

impl Part {
    fn add(&mut self, other: &Self) {
        self.along += other.along;
        self.square += other.square;
        self.rest += other.rest;
    }
}

/// What the residual of a fit says of a jump. With H = 1 behind the jump, else 0, the jump is the coefficient of H d beside those of all
/// parameters, whose priors have the information Λ:
/// ```text
/// A = Λ + XᵀX,   h = Xᵀ H d,   jump = (dᵀ H e - hᵀ A⁻¹ Xᵀ e) / (dᵀ H d - hᵀ A⁻¹ h)
/// ```
/// with the variance of one over the denominator.
struct Parts {
    of_block: Box<[Part]>,
    inverse: InMemory<Matrix>,
    /// A⁻¹ Xᵀe.
    moved: Vector,
    /// Sum of d² over all blocks.
    square: f64,
}

impl Parts {
    fn new(fitted: &Fitted, count: usize) -> Result<Self, Error> {
        let mut of_block = filled(count, Part::default())?;
        let prior = &fitted.prior;
        let mut inverse = in_memory(Matrix::zeros)?;
        let [information] = &mut *inverse;
        information.set_diagonal(&prior.map(|sigma| 1.0 / (sigma * sigma)));
        let mut side = Vector::zeros();
        let mut by_sensor = room(6)?;
        by_sensor.extend((0..6).map(|sensor| coefficients(sensor / 3, sensor % 3).transpose()));
        let mut squares = [Information::zeros(); 6];
        whitened(
            fitted,
            &fitted.rows,
            |one| one.shape,
            |place, sensor, rest, columns| {
                let columns = Coefficients::from_column_slice(&columns[1..]);
                let change = columns[CHANGE - 1];
                let along = by_sensor[sensor] * columns;
                squares[sensor] += columns * columns.transpose();
                side += along * rest;
                of_block[place].add(&Part {
                    along: along * change,
                    square: change * change,
                    rest: change * rest,
                });
            },
        )?;
        for (by_parameters, square) in by_sensor.iter().zip(&squares) {
            information.gemm(1.0, &(by_parameters * square), &by_parameters.transpose(), 1.0);
        }
        let unsolved = || Error::bad_state("the residual of the fit does not determine a jump of the clock");
        invert(information, prior).ok_or_else(unsolved)?;
        let mut moved = Vector::zeros();
        moved.gemv(1.0, information, &side, 0.0);
        let square = of_block.iter().map(|part: &Part| part.square).sum();
        Ok(Self { of_block, moved, inverse, square })
    }

    /// Size and standard deviation of a jump with these sums behind it [s].
    fn jump(&self, behind: &Part) -> Option<(f64, f64)> {
        let left = behind.square - behind.along.dot(&(self.inverse[0] * behind.along));
        let change_s = (behind.rest - behind.along.dot(&self.moved)) / left;
        (left > 1e-6 * self.square).then(|| (change_s, 1.0 / left.sqrt()))
    }
}

/// Normal equations of the parameters and of a jump, each in units of its standard deviation before the record.
struct System {
    prior: Vector,
    matrix: SMatrix<f64, WIDE, WIDE>,
    side: SVector<f64, WIDE>,
    squares: f64,
}

impl System {
    fn new(prior: &Vector) -> Self {
        Self { prior: *prior, matrix: SMatrix::identity(), side: SVector::zeros(), squares: 0.0 }
    }

    /// Adds the residual and the columns of a block, `weight` times; a block behind the jump has `jump` = 1, else 0.
    fn add(&mut self, white: &[Columns; 6], weight: f64, jump: f64) {
        for (sensor, columns) in white.iter().enumerate() {
            let own = Coefficients::from_column_slice(&columns[1..]);
            let of_parameters = coefficients(sensor / 3, sensor % 3).transpose() * own;
            let mut row = SVector::<f64, WIDE>::zeros();
            row.fixed_rows_mut::<PARAMETERS>(0).copy_from(&of_parameters.component_mul(&self.prior));
            row[PARAMETERS] = jump * KNOWN_S * columns[CHANGE];
            self.matrix.ger(weight, &row, &row, 1.0);
            self.side += row * (columns[0] * weight);
            self.squares += columns[0] * columns[0] * weight;
        }
    }

    /// Sum of squares that is left, and the jump [s].
    fn solved(&self) -> Option<(f64, f64)> {
        let solution = self.matrix.cholesky()?.solve(&self.side);
        Some((self.squares - self.side.dot(&solution), KNOWN_S * solution[PARAMETERS]))
    }
}

/// Gives `take` the place of each block, the sensor, its residual with the solution of `fitted`, and the columns, all whitened for a shape
/// of the noise.
fn whitened(
    fitted: &Fitted,
    rows: &Rows,
    shape: impl Fn(&Evidence) -> Shape,
    mut take: impl FnMut(usize, usize, f64, &Columns),
) -> Result<(), Error> {
    let steps = Steps::new(&rows.blocks)?;
    for (sensor, one) in fitted.evidences.iter().enumerate() {
        let solved: [f64; COEFFICIENTS] = Place::coefficients(sensor, &fitted.solution[0].0);
        let scale = 1.0 / one.square.sqrt();
        steps.filter(shape(one))?.whiten(&rows.of_sensor[sensor], |row, white| {
            let white = white.map(|value| value * scale);
            let rest = white[0] - solved.iter().zip(&white[1..]).map(|(c, column)| c * column).sum::<f64>();
            take(rows.places[row], sensor, rest, &white);
        });
    }
    Ok(())
}
