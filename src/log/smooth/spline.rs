//! Quintic splines with uniform knots, fitted to weighted samples.
//!
//! A fit minimises Σ w |y - s(t)|² + ∫ |s'''|² / q dt. It is the smoother of a motion whose jerk is white with the density q: of even
//! samples T apart with weights 1/σ², its response is 1 / (1 + (f/f_c)⁶) with q = (2π f_c)⁶ σ² T. The normal matrix has five diagonals
//! on each side, so that time and memory are linear in samples and knots.

use crate::base::error::Error;
use crate::base::math::GAUSS_3;
use crate::base::memory::room;

/// Pieces of the uniform B-spline of degree 5: piece j on the unit interval is Σ PIECES[j][i] uⁱ / 120.
const PIECES: [[f64; 6]; 6] = [
    [1.0, -5.0, 10.0, -10.0, 5.0, -1.0],
    [26.0, -50.0, 20.0, 20.0, -20.0, 5.0],
    [66.0, 0.0, -60.0, 0.0, 30.0, -10.0],
    [26.0, 50.0, 20.0, -20.0, -20.0, 10.0],
    [1.0, 5.0, 10.0, 10.0, 5.0, -5.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
];

/// Share of the largest diagonal element that is added to each: knots without samples stay regular. It draws a fit towards 0 by that share
/// of the penalty over the weights, which grows as 1 / (2π f_c h)⁶ of knots h apart: below 1e-8 for h = 1 / (16 f_c) where q is a
/// hundredth.
const REGULAR: f64 = 1e-15;

/// Uniform knots.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knots {
    start_s: f64,
    /// Distance of two knots [s].
    pub step_s: f64,
    /// Number of intervals.
    pub count: usize,
}

impl Knots {
    /// Knots over a span, at most `step_s` apart.
    pub fn new(start_s: f64, end_s: f64, step_s: f64) -> Self {
        let count = ((end_s - start_s) / step_s).ceil().max(1.0) as usize;
        Self { start_s, step_s: (end_s - start_s) / count as f64, count }
    }

    /// Middle of an interval [s].
    pub fn middle_s(&self, interval: usize) -> f64 {
        self.start_s + (interval as f64 + 0.5) * self.step_s
    }

    /// The interval of a time, and the derivative of order `order` of the six pieces there.
    fn pieces(&self, time_s: f64, order: usize) -> (usize, [f64; 6]) {
        let x = (time_s - self.start_s) / self.step_s;
        let interval = (x.max(0.0) as usize).min(self.count - 1);
        let u = x - interval as f64;
        let mut pieces = [0.0; 6];
        for (value, piece) in pieces.iter_mut().zip(PIECES) {
            for power in (order..6).rev() {
                let factor: usize = (power - order + 1..=power).product();
                *value = *value * u + piece[power] * factor as f64;
            }
            *value /= 120.0;
            (0..order).for_each(|_| *value /= self.step_s);
        }
        (interval, pieces)
    }
}

/// A spline of `N` components.
#[derive(Debug, Clone)]
pub(super) struct Spline<const N: usize> {
    pub knots: Knots,
    coefficients: Vec<[f64; N]>,
}

impl<const N: usize> Spline<N> {
    /// The spline that is 0.
    pub fn at_rest(knots: Knots) -> Result<Self, Error> {
        let mut coefficients = room(knots.count + 5)?;
        coefficients.resize(knots.count + 5, [0.0; N]);
        Ok(Self { knots, coefficients })
    }

    /// The derivative of order `order` at a time.
    pub fn at(&self, time_s: f64, order: usize) -> [f64; N] {
        let (interval, pieces) = self.knots.pieces(time_s, order);
        let mut value = [0.0; N];
        for (piece, coefficient) in pieces.iter().zip(&self.coefficients[interval..]) {
            (0..N).for_each(|k| value[k] += piece * coefficient[k]);
        }
        value
    }
}

/// Normal equations: the lower half of the matrix by rows, from the diagonal to the left, and the right side.
pub(super) struct Normal<const N: usize> {
    knots: Knots,
    rows: Vec<[f64; 6]>,
    right: Vec<[f64; N]>,
}

impl<const N: usize> Normal<N> {
    pub fn new(knots: Knots) -> Result<Self, Error> {
        let count = knots.count + 5;
        let (mut rows, mut right) = (room(count)?, room(count)?);
        rows.resize(count, [0.0; 6]);
        right.resize(count, [0.0; N]);
        Ok(Self { knots, rows, right })
    }

    fn add_products(&mut self, interval: usize, pieces: &[f64; 6], weight: f64) {
        for (row, a) in pieces.iter().enumerate() {
            for (back, b) in pieces[..=row].iter().rev().enumerate() {
                self.rows[interval + row][back] += weight * a * b;
            }
        }
    }

    /// Adds a sample of the derivative of order `order`.
    pub fn add(&mut self, time_s: f64, order: usize, value: &[f64; N], weight: f64) {
        let (interval, pieces) = self.knots.pieces(time_s, order);
        self.add_products(interval, &pieces, weight);
        for (piece, right) in pieces.iter().zip(&mut self.right[interval..]) {
            (0..N).for_each(|k| right[k] += weight * piece * value[k]);
        }
    }

    /// Adds ∫ |s'''|² / q dt, where `q` has the density of a time. Three points an interval are exact.
    pub fn add_penalty(&mut self, q: impl Fn(f64) -> f64) {
        let knots = self.knots;
        for interval in 0..knots.count {
            for (at, weight) in GAUSS_3 {
                let time_s = knots.start_s + (interval as f64 + at) * knots.step_s;
                let (_, pieces) = knots.pieces(time_s, 3);
                self.add_products(interval, &pieces, weight * knots.step_s / q(time_s));
            }
        }
    }

    /// The solution, by the factors of Cholesky.
    pub fn solve(mut self) -> Spline<N> {
        let largest = self.rows.iter().map(|row| row[0]).fold(0.0, f64::max);
        let count = self.rows.len();
        for i in 0..count {
            self.rows[i][0] += REGULAR * largest;
            for j in i.saturating_sub(5)..=i {
                let mut sum = self.rows[i][i - j];
                for k in i.saturating_sub(5)..j {
                    sum -= self.rows[i][i - k] * self.rows[j][j - k];
                }
                self.rows[i][i - j] = if i == j { sum.sqrt() } else { sum / self.rows[j][0] };
            }
            for back in 1..=i.min(5) {
                let factor = self.rows[i][back];
                let earlier = self.right[i - back];
                (0..N).for_each(|k| self.right[i][k] -= factor * earlier[k]);
            }
            (0..N).for_each(|k| self.right[i][k] /= self.rows[i][0]);
        }
        for i in (0..count).rev() {
            for ahead in 1..=(count - 1 - i).min(5) {
                let factor = self.rows[i + ahead][ahead];
                let later = self.right[i + ahead];
                (0..N).for_each(|k| self.right[i][k] -= factor * later[k]);
            }
            (0..N).for_each(|k| self.right[i][k] /= self.rows[i][0]);
        }
        Spline { knots: self.knots, coefficients: self.right }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Polynomials of degree 2 are in the null space of the penalty: they pass, also where a fit is stiffest, which is with sixteen knots
    /// in the period of its cut-off and a hundredth of its q.
    #[test]
    fn parabolas_pass_and_the_response_at_the_cutoff_is_a_half() {
        let knots = Knots::new(0.0, 50.0, 0.1);
        let fitted = |f: &dyn Fn(f64) -> f64, q: f64| {
            let mut normal = Normal::<1>::new(knots).unwrap();
            for k in 0..=500 {
                let t = 0.1 * f64::from(k);
                normal.add(t, 0, &[f(t)], 1.0);
            }
            normal.add_penalty(|_| q);
            normal.solve()
        };
        let stiffest = 0.01 * (2.0 * core::f64::consts::PI / (16.0 * 0.1)).powi(6) * 0.1;
        let parabola = fitted(&|t| 3.0 - 0.4 * t + 0.02 * t * t, stiffest);
        for (order, expected) in [(0, 3.0 - 8.0 + 8.0), (1, -0.4 + 0.8), (2, 0.04), (3, 0.0)] {
            let error = (parabola.at(20.0, order)[0] - expected).abs();
            println!("{order}: {error:e}");
            assert!(error < 1e-8, "{order}: {error:e}");
        }
        let omega = 2.0 * core::f64::consts::PI * 0.4;
        let q = omega * omega * omega * omega * omega * omega * 0.1;
        let wave = fitted(&|t| crate::base::math::sin_cos(omega * t).0, q);
        let t = 25.3;
        assert!((wave.at(t, 0)[0] - 0.5 * crate::base::math::sin_cos(omega * t).0).abs() < 2e-3);
    }
}
