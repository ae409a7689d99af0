//! What the sensor block feels in inertial axes: those that the block had when the unit was switched on.

use nalgebra::{Quaternion, Vector3};

use super::UnitParameters;
use crate::base::math::{rotate, rotation_quaternion};
use crate::base::snapshot::{CLOCK_S, SIGNALS, stored};
use crate::mechanization::BodyMotion;
use crate::signal::Increment;

/// Time over which the force at rest is averaged, and after which a change of velocity is forgotten \[s\]. In it the Earth turns gravity
/// so little that the velocity stays below 0.05 m/s at rest.
const MEMORY_S: f64 = 8.0;

/// The attitude of the block in inertial axes, from the gyros alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Inertial {
    /// Rotates block axes to inertial axes.
    pub q_is: Quaternion<f64>,
    /// Time for which the gyros have kept these axes \[s\].
    pub kept_s: f64,
}

stored!(Inertial { q_is: ANY_UNIT, kept_s: CLOCK_S } then |inertial, from| {
    let size = inertial.q_is.norm_squared();
    from.require((size - 1.0).abs() < 1e-9, size, "is not the square of a unit quaternion")?;
    from.require(inertial.kept_s >= 0.0, inertial.kept_s, "is a time before the start")
});

/// Limit of the components of a unit quaternion.
const ANY_UNIT: f64 = 1.0 + 1e-9;

impl Default for Inertial {
    fn default() -> Self {
        Self { q_is: Quaternion::identity(), kept_s: 0.0 }
    }
}

impl Inertial {
    /// Turns on by the increments of an update over `dt` \[s\], as the mechanization does. Returns the integral of the specific force over
    /// them, inertial axes \[m/s\].
    pub fn turn(&mut self, increments: &[Increment], dt: f64) -> Vector3<f64> {
        self.kept_s += dt;
        let body = BodyMotion::exact(increments);
        let velocity_i = rotate(&self.q_is, &body.s1);
        self.q_is *= rotation_quaternion(&body.rotation);
        self.q_is /= self.q_is.norm_squared().sqrt();
        velocity_i
    }
}

/// The test for motion: the velocity that the unit feels against its mean force, which it forgets after some seconds; and the distance
/// of the aircraft from its place. Departure: a real unit cannot see that place. It finds a slow start late, and a constant velocity
/// never, and shows wrong outputs as valid.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Motion {
    /// Mean specific force \[m/s²\].
    force_i: Vector3<f64>,
    /// Velocity against the mean force, and the same filtered \[m/s\].
    velocity_i: Vector3<f64>,
    filtered_i: Vector3<f64>,
    elapsed_s: f64,
    /// Time since the last motion \[s\].
    pub still_s: f64,
    /// Where the aircraft stood then, Earth-fixed axes \[m\].
    place_e: Option<Vector3<f64>>,
}

stored!(Motion {
    force_i: SIGNALS,
    velocity_i: SIGNALS,
    filtered_i: SIGNALS,
    elapsed_s: SIGNALS,
    still_s: SIGNALS,
    place_e: SIGNALS
});

impl Motion {
    /// Takes the integral of the specific force over `dt` \[s\], and the place of the aircraft, if it is known. Returns whether the unit
    /// moves.
    pub fn feel(
        &mut self,
        velocity_i: &Vector3<f64>,
        place_e: Option<Vector3<f64>>,
        dt: f64,
        parameters: &UnitParameters,
    ) -> bool {
        self.elapsed_s += dt;
        let force_i = velocity_i / dt;
        self.force_i += (force_i - self.force_i) * (dt / MEMORY_S.min(self.elapsed_s)).min(1.0);
        let excess = (force_i - self.force_i) * dt;
        self.velocity_i += excess - self.velocity_i * (dt / MEMORY_S).min(1.0);
        self.filtered_i += (self.velocity_i - self.filtered_i) * (dt / parameters.motion_filter_s).min(1.0);
        let threshold = parameters.motion_threshold_m_s;
        let farthest = parameters.motion_distance_m;
        let has_left = place_e
            .zip(self.place_e)
            .is_some_and(|(now, then)| (now - then).norm_squared() > farthest * farthest);
        if has_left || self.place_e.is_none() {
            self.place_e = place_e;
        }
        let is_moving = has_left || self.filtered_i.norm_squared() > threshold * threshold;
        self.still_s = if is_moving { 0.0 } else { self.still_s + dt };
        is_moving
    }
}
