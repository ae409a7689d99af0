//! What contradictions between velocities and positions do to an INS with ideal sensors.

use nalgebra::Vector3;

use super::row::Row;
use crate::earth::Earth;
use crate::truth::Answer;

/// Time after which the answer is advanced [s].
const STEP_S: f64 = 1.0;

#[derive(Debug, Clone)]
pub(super) struct InducedError {
    answer: Answer,
    pending_e: Vector3<f64>,
    pending_s: f64,
    v_e: Option<Vector3<f64>>,
    /// Largest horizontal error of the position [m].
    pub largest_m: f64,
}

impl InducedError {
    pub fn new() -> Self {
        Self { answer: Answer::new(), pending_e: Vector3::zeros(), pending_s: 0.0, v_e: None, largest_m: 0.0 }
    }

    /// Adds a row.
    pub fn add(&mut self, earth: &Earth, row: &Row) {
        let v_e = row.v_e();
        if let (Some(now), Some(before)) = (v_e, self.v_e) {
            self.pending_e += (now + before) * (0.5 * row.interval_s) - row.d_e;
            self.pending_s += row.interval_s;
        }
        self.v_e = v_e;
        if self.pending_s < STEP_S {
            return;
        }
        let r_e = earth.to_earth_fixed(&row.place);
        let gravity_e = earth.gravity(&r_e);
        self.answer.advance(earth, &r_e, &gravity_e, &self.pending_e, self.pending_s);
        (self.pending_e, self.pending_s) = (Vector3::zeros(), 0.0);
        let (position_e, _) = self.answer.now(earth, &r_e, &gravity_e);
        self.largest_m = self.largest_m.max(position_e.norm_squared().sqrt());
    }
}
