//! Closure of the navigated solution on the truth, and the host's share of it.

use nalgebra::Vector3;

use crate::base::math::Compensated;
use crate::base::snapshot::{COUNT, NO_SQUARE, stored};
use crate::earth::{Earth, Geodetic};
use crate::errors::NavigationErrors;
use crate::truth::{INTERVALS_S, TruthPoint};

/// Displacement [m], and share of the displacement by velocity, by which a sample may contradict its velocity before it is flagged.
/// The two are added as squares. They are larger than the error of any integrator, and smaller than the effect of a wrong unit.
const FLAG_FLOOR_M: f64 = 0.01;
const FLAG_SHARE: f64 = 0.01;

/// Closure of the navigated solution on the truth.
///
/// A host's positions are never exactly the integral of its velocities. The INS integrates the velocities and senses gravity at the
/// positions, so this inconsistency of the host appears in the closure, Schuler-tuned. The rest of the closure comes from the
/// simulator itself and from the sensors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosureFigures {
    /// Navigation minus truth now: position [m].
    pub position_n: Vector3<f64>,
    /// Navigation minus truth now: velocity [m/s].
    pub velocity_n: Vector3<f64>,
    /// Part of the horizontal position difference that the host's inconsistency explains [m].
    pub host_position_n: Vector3<f64>,
    /// Part of the horizontal velocity difference that the host's inconsistency explains [m/s].
    pub host_velocity_n: Vector3<f64>,
    /// Displacement by the host's velocities less displacement by its positions, summed over the flight [m].
    pub inconsistency_n: Vector3<f64>,
    /// Largest inconsistency in one interval [m].
    pub inconsistency_max_m: f64,
    /// Number of samples that are flagged as inconsistent.
    pub inconsistent_samples: u64,
}

/// The INS's answer is integrated in steps of this length [s]: a five-thousandth of its period.
const ANSWER_STEP_S: f64 = 1.0;

/// Longest step of the answer [s]. Longer intervals are divided into equal steps, because the explicit Coriolis term adds a share
/// of 2 (W t)² a step: one percent in one step of 1000 s.
const LONGEST_ANSWER_STEP_S: f64 = 2.5;

/// The sums behind the figures, Earth-fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Closure {
    inconsistency_e: Compensated<3>,
    /// Square of the largest inconsistency in one interval [m²].
    max2_m2: f64,
    flagged: u64,
    last_flagged: bool,
    answer: Answer,
    /// Inconsistency [m] and time [s] since the last step of the answer.
    pending_e: Vector3<f64>,
    pending_s: f64,
}

/// The INS's answer to the inconsistency: horizontal position [m] and velocity [m/s].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Answer {
    r_e: Vector3<f64>,
    v_e: Vector3<f64>,
}

stored!(Closure {
    inconsistency_e: SUMS_M,
    max2_m2: SUMS_M,
    flagged: COUNT,
    last_flagged,
    answer,
    pending_e: SUMS_M,
    pending_s: ANSWER_STEP_S + INTERVALS_S.1,
} then |closure, from| {
    from.require(closure.max2_m2 >= 0.0, closure.max2_m2, NO_SQUARE)?;
    from.require(closure.pending_s >= 0.0, closure.pending_s, "must not be negative")
});
stored!(Answer { r_e: SUMS_M, v_e: SUMS_M });

/// Limit that no sum over a run reaches [m, m/s, m²].
const SUMS_M: f64 = 1e60;

impl Answer {
    /// The answer after further `t` [s] with the inconsistency `inconsistency_e` [m].
    fn after(mut self, earth: &Earth, truth: &TruthPoint, inconsistency_e: &Vector3<f64>, t: f64) -> Self {
        if t <= LONGEST_ANSWER_STEP_S {
            return self.after_step(earth, truth, inconsistency_e, t);
        }
        let steps = (t / LONGEST_ANSWER_STEP_S).ceil();
        for _ in 0..steps as u32 {
            self = self.after_step(earth, truth, &(inconsistency_e / steps), t / steps);
        }
        self
    }

    /// δv' = -g/r δr - 2 W×δv, δr' = δv + inconsistency over `t` [s], semi-implicit. The vertical part is removed.
    fn after_step(
        mut self,
        earth: &Earth,
        truth: &TruthPoint,
        inconsistency_e: &Vector3<f64>,
        t: f64,
    ) -> Self {
        let r_e = &truth.state.r_e;
        let inverse_r2 = 1.0 / r_e.norm_squared();
        let schuler2 = -truth.gravity_e.dot(r_e) * inverse_r2;
        let w2 = 2.0 * earth.rate_rad_s;
        let (r, v) = (&mut self.r_e, &mut self.v_e);
        *v += (Vector3::new(w2 * v.y, -w2 * v.x, 0.0) - *r * schuler2) * t;
        *r += *v * t + inconsistency_e;
        *v -= r_e * (v.dot(r_e) * inverse_r2);
        *r -= r_e * (r.dot(r_e) * inverse_r2);
        self
    }
}

impl Closure {
    pub fn new() -> Self {
        Self {
            inconsistency_e: Compensated::new(Vector3::zeros()),
            max2_m2: 0.0,
            flagged: 0,
            last_flagged: false,
            answer: Answer { r_e: Vector3::zeros(), v_e: Vector3::zeros() },
            pending_e: Vector3::zeros(),
            pending_s: 0.0,
        }
    }

    /// Adds the interval to `next`. Its displacement by velocity less its displacement by position is `inconsistency_e` [m].
    pub fn advance(&mut self, earth: &Earth, next: &TruthPoint, inconsistency_e: &Vector3<f64>) {
        let t = next.interval_s;
        self.inconsistency_e.add(inconsistency_e);
        let size2 = inconsistency_e.norm_squared();
        self.max2_m2 = self.max2_m2.max(size2);
        let share = FLAG_SHARE * t;
        self.last_flagged =
            size2 > FLAG_FLOOR_M * FLAG_FLOOR_M + share * share * next.state.v_e.norm_squared();
        self.flagged += u64::from(self.last_flagged);
        self.pending_e += inconsistency_e;
        self.pending_s += t;
        if self.pending_s >= ANSWER_STEP_S {
            self.answer = self.answer.after(earth, next, &self.pending_e, self.pending_s);
            self.pending_e = Vector3::zeros();
            self.pending_s = 0.0;
        }
    }

    /// Follows a jump of the truth from one place to another. The sums so far keep their components east, north and up.
    pub fn turn(&mut self, earth: &Earth, from: &Geodetic, to: &Geodetic) {
        let (from, to) = (earth.east_north_up(from), earth.east_north_up(to));
        let turned = |v: &Vector3<f64>| to.0 * v.dot(&from.0) + to.1 * v.dot(&from.1) + to.2 * v.dot(&from.2);
        let Answer { r_e, v_e } = &self.answer;
        self.answer = Answer { r_e: turned(r_e), v_e: turned(v_e) };
        self.pending_e = turned(&self.pending_e);
        self.inconsistency_e = Compensated::new(turned(&self.inconsistency_e.value));
        self.last_flagged = false;
    }

    /// Whether the last sample contradicts its velocity.
    pub fn last_flagged(&self) -> bool {
        self.last_flagged
    }

    /// The figures while the truth is at `truth` and the solution has the errors `errors`.
    pub fn figures(&self, earth: &Earth, truth: &TruthPoint, errors: &NavigationErrors) -> ClosureFigures {
        let answer = self.answer.after(earth, truth, &self.pending_e, self.pending_s);
        let (east, north, up) = earth.east_north_up(truth.place());
        let local = |v: &Vector3<f64>| Vector3::new(v.dot(&east), v.dot(&north), v.dot(&up));
        let horizontal = |v: &Vector3<f64>| Vector3::new(v.dot(&east), v.dot(&north), 0.0);
        ClosureFigures {
            position_n: errors.position_n,
            velocity_n: errors.velocity_n,
            host_position_n: horizontal(&answer.r_e),
            host_velocity_n: horizontal(&answer.v_e),
            inconsistency_n: local(&self.inconsistency_e.value),
            inconsistency_max_m: self.max2_m2.sqrt(),
            inconsistent_samples: self.flagged,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::Euler;
    use crate::earth::state::BodyAxes;
    use crate::truth::{FlightSample, Intake, IntakeLimits};

    /// The energy of the swing after one inconsistency of 1 m, over 2000 intervals of 1000 s: 800 000 steps of t = 2.5 s. With
    /// c = 2 W t, a step multiplies the energy by at most 1 + c² + c ω t. c² comes from |c v|². c ω t comes from c v along the
    /// other change of the velocity, ω² t r. Within a swing the energy varies by the share ω t, because the steps are of
    /// first order.
    #[test]
    fn the_answer_does_not_grow_in_long_intervals() {
        let earth = Earth::default();
        let place =
            crate::earth::Geodetic { latitude_rad: 0.5 * core::f64::consts::PI, ..Default::default() };
        let mut intake = Intake::new(earth, BodyAxes::default(), IntakeLimits::default()).unwrap();
        intake.push(&FlightSample::at_rest(0.0, place, Euler::default())).unwrap();
        let point = intake.front().unwrap();
        let omega2 = -point.gravity_e.dot(&point.state.r_e) / point.state.r_e.norm_squared();
        let mut answer = Closure::new().answer.after(&earth, point, &Vector3::x(), 1.0);
        let energy = |answer: &Answer| answer.v_e.norm_squared() + omega2 * answer.r_e.norm_squared();
        let start = energy(&answer);
        let mut largest: f64 = 0.0;
        for _ in 0..2000 {
            answer = answer.after(&earth, point, &Vector3::zeros(), 1000.0);
            largest = largest.max(energy(&answer));
        }
        let (c, omega_t) =
            (2.0 * earth.rate_rad_s * LONGEST_ANSWER_STEP_S, omega2.sqrt() * LONGEST_ANSWER_STEP_S);
        let grown = crate::base::math::exp(800e3 * c * (c + omega_t));
        assert!(largest < start * grown * (1.0 + omega_t), "{}", largest / start);
    }
}
