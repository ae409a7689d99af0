//! The INS's answer to a host whose positions contradict its velocities.

use nalgebra::Vector3;

use super::INTERVALS_S;
use crate::base::snapshot::stored;
use crate::earth::Earth;

/// The answer is integrated in steps of this length [s]: a five-thousandth of its period.
const STEP_S: f64 = 1.0;

/// Longest step of the answer [s]. Longer intervals are divided into equal steps, because the explicit Coriolis term adds a share
/// of 2 (W t)² a step: one percent in one step of 1000 s.
const LONGEST_STEP_S: f64 = 2.5;

/// Longest interval of the answer [s]: the longest of an INS, and what waited for a step. It takes at most 401 steps.
const LONGEST_S: f64 = STEP_S + INTERVALS_S.1;

/// Limit that no sum over a run reaches [m, m/s, m²].
pub(crate) const SUMS_M: f64 = 1e60;

/// Horizontal errors of an INS with ideal sensors that integrates the velocities of a host and senses gravity at its positions,
/// Earth-fixed axes. The inconsistency is the displacement by velocities less the displacement by positions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Answer {
    /// Error of the position [m].
    r_e: Vector3<f64>,
    /// Error of the velocity [m/s].
    v_e: Vector3<f64>,
    /// Inconsistency [m] and time [s] since the last step.
    pending_e: Vector3<f64>,
    pending_s: f64,
}

stored!(Answer { r_e: SUMS_M, v_e: SUMS_M, pending_e: SUMS_M, pending_s: LONGEST_S } then |answer, from| {
    from.require(answer.pending_s >= 0.0, answer.pending_s, "must not be negative")
});

impl Answer {
    pub fn new() -> Self {
        let zero = Vector3::zeros();
        Self { r_e: zero, v_e: zero, pending_e: zero, pending_s: 0.0 }
    }

    /// Adds an interval of `t` [s] that ends at `r_e` [m], with gravity `gravity_e` [m/s²] there, and has the inconsistency
    /// `inconsistency_e` [m]. A longer interval than [`LONGEST_S`] changes nothing, because no INS flies it.
    pub fn advance(
        &mut self,
        earth: &Earth,
        r_e: &Vector3<f64>,
        gravity_e: &Vector3<f64>,
        inconsistency_e: &Vector3<f64>,
        t: f64,
    ) {
        if t > LONGEST_S {
            return;
        }
        self.pending_e += inconsistency_e;
        self.pending_s += t;
        if self.pending_s >= STEP_S {
            *self = self.after(earth, r_e, gravity_e);
        }
    }

    /// The errors now, of position [m] and velocity [m/s].
    pub fn now(
        &self,
        earth: &Earth,
        r_e: &Vector3<f64>,
        gravity_e: &Vector3<f64>,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let now = self.after(earth, r_e, gravity_e);
        (now.r_e, now.v_e)
    }

    /// The same in other axes: `turned` turns a vector.
    pub fn turn(&mut self, turned: impl Fn(&Vector3<f64>) -> Vector3<f64>) {
        let Self { r_e, v_e, pending_e, pending_s: _ } = self;
        for vector in [r_e, v_e, pending_e] {
            *vector = turned(vector);
        }
    }

    /// The answer with nothing pending.
    fn after(mut self, earth: &Earth, r_e: &Vector3<f64>, gravity_e: &Vector3<f64>) -> Self {
        let (inconsistency_e, t) = (self.pending_e, self.pending_s);
        (self.pending_e, self.pending_s) = (Vector3::zeros(), 0.0);
        if t <= LONGEST_STEP_S {
            return self.after_step(earth, r_e, gravity_e, &inconsistency_e, t);
        }
        let steps = (t / LONGEST_STEP_S).ceil();
        for _ in 0..steps as u32 {
            self = self.after_step(earth, r_e, gravity_e, &(inconsistency_e / steps), t / steps);
        }
        self
    }

    /// δv' = -g/r δr - 2 W×δv, δr' = δv + inconsistency over `t` [s], semi-implicit. The vertical part is removed.
    fn after_step(
        mut self,
        earth: &Earth,
        r_e: &Vector3<f64>,
        gravity_e: &Vector3<f64>,
        inconsistency_e: &Vector3<f64>,
        t: f64,
    ) -> Self {
        #[cfg(test)]
        STEPS.set(STEPS.get() + 1);
        let inverse_r2 = 1.0 / r_e.norm_squared();
        let schuler2 = -gravity_e.dot(r_e) * inverse_r2;
        let w2 = 2.0 * earth.rate_rad_s;
        let (r, v) = (&mut self.r_e, &mut self.v_e);
        *v += (Vector3::new(w2 * v.y, -w2 * v.x, 0.0) - *r * schuler2) * t;
        *r += *v * t + inconsistency_e;
        *v -= r_e * (v.dot(r_e) * inverse_r2);
        *r -= r_e * (r.dot(r_e) * inverse_r2);
        self
    }
}

#[cfg(test)]
thread_local! {
    /// Steps of all answers of this thread.
    pub(crate) static STEPS: core::cell::Cell<u64> = const { core::cell::Cell::new(0) };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::earth::Geodetic;

    /// The energy of the swing after one inconsistency of 1 m, over 2000 intervals of 1000 s: 800 000 steps of t = 2.5 s. With
    /// c = 2 W t, a step multiplies the energy by at most 1 + c² + c ω t. c² comes from |c v|². c ω t comes from c v along the
    /// other change of the velocity, ω² t r. Within a swing the energy varies by the share ω t, because the steps are of
    /// first order.
    #[test]
    fn the_answer_does_not_grow_in_long_intervals() {
        let earth = Earth::default();
        let pole = Geodetic { latitude_rad: 0.5 * core::f64::consts::PI, ..Geodetic::default() };
        let r_e = earth.to_earth_fixed(&pole);
        let gravity_e = earth.gravity(&r_e);
        let omega2 = -gravity_e.dot(&r_e) / r_e.norm_squared();
        let mut answer = Answer::new();
        answer.advance(&earth, &r_e, &gravity_e, &Vector3::x(), STEP_S);
        let energy = |answer: &Answer| answer.v_e.norm_squared() + omega2 * answer.r_e.norm_squared();
        let start = energy(&answer);
        let mut largest: f64 = 0.0;
        for _ in 0..2000 {
            answer.advance(&earth, &r_e, &gravity_e, &Vector3::zeros(), 1000.0);
            largest = largest.max(energy(&answer));
        }
        let (c, omega_t) = (2.0 * earth.rate_rad_s * LONGEST_STEP_S, omega2.sqrt() * LONGEST_STEP_S);
        let grown = crate::base::math::exp(800e3 * c * (c + omega_t));
        assert!(largest < start * grown * (1.0 + omega_t), "{}", largest / start);
    }
}
