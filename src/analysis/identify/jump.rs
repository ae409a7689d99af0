//! Whether the clock of the record jumps against that of the path.

use nalgebra::{Matrix2, Vector2};

use super::noise::Evidence;
use super::parameter::Place;
use super::solve::{Rows, Vector};
use super::whiten::Steps;
use crate::base::error::{Error, Rule};
use crate::base::memory::filled;

/// A jump is certain at this number of standard deviations, with some for the choice of its time, and large at this part of an interval.
const CERTAIN: f64 = 8.0;
const LARGE: f64 = 0.5;

/// Rejects a record whose clock jumps. Let e be the whitened rest of a sensor and d its whitened change by a shift of the clock, t the time
/// and H = 1 behind the time of a jump, else 0. The jump is the coefficient of H d beside those of d and t d, which the fit has found:
/// ```text
/// S = Σ (d, t d) (d, t d)ᵀ,   h = Σ H d (d, t d),   jump = (Σ H d e - hᵀ S⁻¹ Σ (d, t d) e) / (Σ H d² - hᵀ S⁻¹ h)
/// ```
/// with the variance of one over the denominator, if all are in units of the noise.
pub(super) fn check(
    rows: &Rows,
    evidences: &[Evidence; 6],
    x: &Vector,
    interval_s: f64,
) -> Result<(), Error> {
    let steps = Steps::new(rows.blocks.iter());
    let mut sums = filled(rows.blocks.len(), Sums::default())?;
    for (sensor, one) in evidences.iter().enumerate() {
        let solved = Place::coefficients(sensor, x);
        steps.whiten(one.shape, &rows.of_sensor[sensor], |place, white| {
            let rest = white[0] - solved.iter().zip(&white[1..]).map(|(c, column)| c * column).sum::<f64>();
            let change = Vector2::new(white[5], white[6]);
            sums[place].add(&Sums {
                squares: change * change.transpose() / one.square,
                rest: change * (rest / one.square),
            });
        });
    }
    let mut total = Sums::default();
    sums.iter().for_each(|part| total.add(part));
    let Some(inverse) = total.squares.try_inverse() else { return Ok(()) };
    let mut behind = total;
    let mut worst: Option<(f64, f64, usize)> = None;
    for (place, part) in sums.iter().enumerate() {
        behind.squares -= part.squares;
        behind.rest -= part.rest;
        let along = behind.squares.column(0).into_owned();
        let left = along.x - along.dot(&(inverse * along));
        if left <= 1e-6 * total.squares.m11 {
            continue;
        }
        let jump_s = (behind.rest.x - along.dot(&(inverse * total.rest))) / left;
        let deviations = jump_s.abs() * left.sqrt();
        if deviations > CERTAIN
            && jump_s.abs() > LARGE * interval_s
            && worst.is_none_or(|worst| deviations > worst.0)
        {
            worst = Some((deviations, jump_s, place));
        }
    }
    match worst {
        None => Ok(()),
        Some((_, jump_s, place)) => {
            let rule = Rule::SentenceWith(
                "jump of the clock of the record [s], about at its time [s]",
                rows.blocks[place].end_s.into(),
            );
            // What the path time less the record time loses, the clock has gained.
            Err(Error::invalid("record.time_s", -jump_s, rule))
        }
    }
}

/// Sums over blocks of the changes by shift and drift, in units of the noise.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    squares: Matrix2<f64>,
    rest: Vector2<f64>,
}

impl Sums {
    fn add(&mut self, other: &Self) {
        self.squares += other.squares;
        self.rest += other.rest;
    }
}
