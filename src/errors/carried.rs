//! Errors that stay with a navigator where its truth jumps.

use nalgebra::{Quaternion, Vector3};

use crate::earth::{Earth, navigation_axes};
use crate::math::{rotate, rotate_inverse, rotated_z};
use crate::state::{EarthFixedState, NEAR_POLE_M, Navigation};

/// Cosine of the angle between two verticals below which a height is not to be found along the other one: 84°.
const LEAST_SLOPE: f64 = 0.1;

/// Errors of a solution: what [`navigation_minus_truth`](super::navigation_minus_truth) tells, at any size and everywhere.
///
/// Velocity and attitude are compared in the solution's own axes east-north-up with those of the truth. Near a pole, where these
/// differ by any angle, the solution's axes are the truth's, turned to the solution's vertical by the shortest way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CarriedErrors {
    /// Straight displacement along the truth's east, north, up [m].
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

    /// The solution with these errors at another `truth`; `None` where the displacement has no such height there.
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

    /// The place of the same displacement along east and north whose height has the same error: by Newton's rule along up.
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
        // Heights are exact to a nanometre, and to the last place of far ones.
        (miss_m.abs() < 1e-7).then_some(r_e)
    }
}

/// Axes east-north-up of a solution at `r_e` with the truth at `true_place`, whose axes are `true_axes`; and its height [m].
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
    // Verticals that are opposite have no shortest way.
    let axes = if norm2 > 1e-6 { lean / norm2.sqrt() * true_axes } else { own };
    (axes, place.height_m)
}
