//! Closure of the navigated solution on the truth, and the host's share of it.

use nalgebra::Vector3;

use crate::base::math::Compensated;
use crate::base::snapshot::{COUNT, NO_SQUARE, stored};
use crate::earth::{Earth, Geodetic};
use crate::errors::NavigationErrors;
use crate::truth::{Answer, SUMS_M, TruthPoint};

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

/// The sums behind the figures, Earth-fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Closure {
    inconsistency_e: Compensated<3>,
    /// Square of the largest inconsistency in one interval [m²].
    max2_m2: f64,
    flagged: u64,
    last_flagged: bool,
    answer: Answer,
}

stored!(Closure { inconsistency_e: SUMS_M, max2_m2: SUMS_M, flagged: COUNT, last_flagged, answer } then |closure, from| {
    from.require(closure.max2_m2 >= 0.0, closure.max2_m2, NO_SQUARE)
});
impl Closure {
    pub fn new() -> Self {
        Self {
            inconsistency_e: Compensated::new(Vector3::zeros()),
            max2_m2: 0.0,
            flagged: 0,
            last_flagged: false,
            answer: Answer::new(),
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
        self.answer.advance(earth, &next.state.r_e, &next.gravity_e, inconsistency_e, t);
    }

    /// Follows a jump of the truth from one place to another. The sums so far keep their components east, north and up.
    pub fn turn(&mut self, earth: &Earth, from: &Geodetic, to: &Geodetic) {
        let (from, to) = (earth.east_north_up(from), earth.east_north_up(to));
        let turned = |v: &Vector3<f64>| to.0 * v.dot(&from.0) + to.1 * v.dot(&from.1) + to.2 * v.dot(&from.2);
        self.answer.turn(turned);
        self.inconsistency_e = Compensated::new(turned(&self.inconsistency_e.value));
        self.last_flagged = false;
    }

    /// Whether the last sample contradicts its velocity.
    pub fn last_flagged(&self) -> bool {
        self.last_flagged
    }

    /// The figures while the truth is at `truth` and the solution has the errors `errors`.
    pub fn figures(&self, earth: &Earth, truth: &TruthPoint, errors: &NavigationErrors) -> ClosureFigures {
        let (answer_r_e, answer_v_e) = self.answer.now(earth, &truth.state.r_e, &truth.gravity_e);
        let (east, north, up) = earth.east_north_up(truth.place());
        let local = |v: &Vector3<f64>| Vector3::new(v.dot(&east), v.dot(&north), v.dot(&up));
        let horizontal = |v: &Vector3<f64>| Vector3::new(v.dot(&east), v.dot(&north), 0.0);
        ClosureFigures {
            position_n: errors.position_n,
            velocity_n: errors.velocity_n,
            host_position_n: horizontal(&answer_r_e),
            host_velocity_n: horizontal(&answer_v_e),
            inconsistency_n: local(&self.inconsistency_e.value),
            inconsistency_max_m: self.max2_m2.sqrt(),
            inconsistent_samples: self.flagged,
        }
    }
}
