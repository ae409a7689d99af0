//! Errors that a navigator keeps when its truth jumps.

use nalgebra::{Quaternion, Vector3};

use crate::base::math::{rotate, rotate_inverse, rotated_z};
use crate::earth::state::{EarthFixedState, NEAR_POLE_M, Navigation};
use crate::earth::{Earth, navigation_axes};

/// Smallest cosine of the angle between two verticals at which a height along the other vertical is searched for: 84°.
const LEAST_SLOPE: f64 = 0.1;

/// Errors of a solution, as [`navigation_minus_truth`](super::navigation_minus_truth) returns them, but of any size and everywhere.
///
/// Velocity and attitude are compared between the solution in its own axes east-north-up and the truth in its axes. Near a pole the
/// two sets of axes differ by any angle. There the solution's axes are the truth's axes, turned to the solution's vertical by the
/// shortest rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CarriedErrors {
    /// Straight displacement, components along the truth's east, north, up [m].
    displacement_n: Vector3<f64>,
    /// Difference of the heights [m].
    height_m: f64,
    /// Difference of the components of velocity [m/s].
    velocity_n: Vector3<f64>,
    /// From the true attitude to the computed one: q_nb = rotation q_nb true.
    rotation: Quaternion<f64>,
}

impl CarriedErrors {
    /// Errors of `solution` against `truth`.
    pub fn of(earth: &Earth, solution: &EarthFixedState, truth: &Navigation) -> Self {
        let true_place = earth.to_earth_fixed(&truth.place);
        let true_axes = navigation_axes(truth.place.latitude_rad, truth.place.longitude_rad);
        let (axes, height_m) = axes_and_height(earth, &solution.r_e, &true_place, &true_axes);
        Self {
            displacement_n: rotate_inverse(&true_axes, &(solution.r_e - true_place)),
            height_m: height_m - truth.place.height_m,
            velocity_n: rotate_inverse(&axes, &solution.v_e) - truth.v_n,
            rotation: axes.conjugate() * solution.q_eb * truth.q_nb.conjugate(),
        }
    }

    /// Solution with these errors at another `truth`; `None` if the displacement cannot have this height error there.
    pub fn at(&self, earth: &Earth, truth: &Navigation) -> Option<EarthFixedState> {
        let true_place = earth.to_earth_fixed(&truth.place);
        let true_axes = navigation_axes(truth.place.latitude_rad, truth.place.longitude_rad);
        let r_e = self.place(earth, truth, &true_place, &rotated_z(&true_axes), &true_axes)?;
        let (axes, _) = axes_and_height(earth, &r_e, &true_place, &true_axes);
        let q_eb = axes * (self.rotation * truth.q_nb);
        Some(EarthFixedState {
            r_e,
            v_e: rotate(&axes, &(truth.v_n + self.velocity_n)),
            q_eb: q_eb / q_eb.norm_squared().sqrt(),
        })
    }

    /// Place with the same displacement along east and north and the same height error, by Newton's method along up.
    fn place(
        &self,
        earth: &Earth,
        truth: &Navigation,
        true_place: &Vector3<f64>,
        up_e: &Vector3<f64>,
        true_axes: &Quaternion<f64>,
    ) -> Option<Vector3<f64>> {
        let wanted_m = truth.place.height_m + self.height_m;
        let mut r_e = true_place + rotate(true_axes, &self.displacement_n);
        let mut miss_m = f64::INFINITY;
        for _ in 0..20 {
            let vertical = earth.vertical(&r_e);
            let slope = vertical.up_e.dot(up_e);
            if slope.is_nan() || slope.abs() < LEAST_SLOPE {
                return None;
            }
            let last_m = core::mem::replace(&mut miss_m, wanted_m - vertical.height_m);
            if miss_m == 0.0 || miss_m.abs() >= 0.5 * last_m.abs() {
                break;
            }
            r_e += up_e * (miss_m / slope);
        }
        // Heights are exact to a nanometre, or to their last digit far from the Earth.
        (miss_m.abs() < 1e-7).then_some(r_e)
    }
}

/// Axes east-north-up and height [m] of a solution at `r_e`. The truth is at `true_place` and has the axes `true_axes`.
fn axes_and_height(
    earth: &Earth,
    r_e: &Vector3<f64>,
    true_place: &Vector3<f64>,
    true_axes: &Quaternion<f64>,
) -> (Quaternion<f64>, f64) {
    let place = earth.to_geodetic(r_e);
    let own = navigation_axes(place.latitude_rad, place.longitude_rad);
    let is_near_pole = |r_e: &Vector3<f64>| r_e.xy().norm_squared() < NEAR_POLE_M * NEAR_POLE_M;
    if !is_near_pole(r_e) && !is_near_pole(true_place) {
        return (own, place.height_m);
    }
    let (from, to) = (rotated_z(true_axes), rotated_z(&own));
    let lean = Quaternion::from_parts(1.0 + from.dot(&to), from.cross(&to));
    let norm2 = lean.norm_squared();
    // Between opposite verticals no rotation is the shortest.
    let axes = if norm2 > 1e-6 { lean / norm2.sqrt() * true_axes } else { own };
    (axes, place.height_m)
}
