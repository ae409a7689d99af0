//! Velocities on another clock than the positions.
//!
//! A velocity that is late by τ is v(t - τ). Over a block, the displacement less the integral of the velocity is then τ times the change of
//! the velocity. White noise of the velocities, wind, and the error of the trapezoids are not correlated with that change.

use nalgebra::Vector3;

use super::row::Row;

/// Length of a block [s], and blocks that a judgement needs.
const BLOCK_S: f64 = 1.0;
const LEAST: f64 = 20.0;

/// Least delay [s], and in usual intervals; in its deviations; and least share of the contradiction that it explains.
const LEAST_S: f64 = 0.08;
const INTERVALS: f64 = 0.15;
const DEVIATIONS: f64 = 6.0;
const EXPLAINED: f64 = 0.25;

#[derive(Debug, Clone)]
pub(super) struct Lateness {
    v_e: Option<Vector3<f64>>,
    /// Of the block now: displacement less integral of the velocity [m], change of the velocity [m/s], length [s].
    apart_e: Vector3<f64>,
    change_e: Vector3<f64>,
    length_s: f64,
    /// Number of blocks; Σ change², Σ change apart, Σ apart².
    sums: [f64; 4],
}

impl Lateness {
    pub const fn new() -> Self {
        const ZERO: Vector3<f64> = Vector3::new(0.0, 0.0, 0.0);
        Self { v_e: None, apart_e: ZERO, change_e: ZERO, length_s: 0.0, sums: [0.0; 4] }
    }

    /// Adds a row.
    pub fn add(&mut self, row: &Row) {
        let v_e = row.v_e();
        if let (Some(now), Some(before)) = (v_e, self.v_e) {
            self.apart_e += row.d_e - (now + before) * (0.5 * row.interval_s);
            self.change_e += now - before;
            self.length_s += row.interval_s;
        }
        self.v_e = v_e;
        // Half an interval of tolerance keeps blocks of rows at whole seconds that long.
        if self.length_s > BLOCK_S - 0.5 * row.interval_s.min(BLOCK_S) {
            let (apart, change) = (self.apart_e, self.change_e);
            let terms = [1.0, change.norm_squared(), change.dot(&apart), apart.norm_squared()];
            self.sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
            *self = Self { v_e, sums: self.sums, ..Self::new() };
        }
    }

    /// How late the velocities are, negative if they are early [s].
    pub fn delay_s(&self, usual_s: f64) -> Option<f64> {
        let [count, change2, mixed, apart2] = self.sums;
        let delay_s = mixed / change2;
        let sigma_s = ((apart2 - delay_s * mixed).max(0.0) / (3.0 * count * change2)).sqrt();
        let is_shown = count >= LEAST
            && delay_s.abs() > LEAST_S.max(INTERVALS * usual_s).max(DEVIATIONS * sigma_s)
            && delay_s * mixed > EXPLAINED * apart2;
        is_shown.then_some(delay_s)
    }
}
