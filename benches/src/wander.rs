//! The exact scheme in wander-azimuth axes, the other singularity-free mechanization: position as quaternion
//! and height, axes with z up that do not turn about z against the Earth (rho_z = 0).
//!
//! Notation as in the crate: `q_ew` rotates wander axes w to Earth-fixed axes e, `v_w` is resolved in w. Body
//! part, gravity, compensated sums and order of the Earth terms are as in the crate's Earth-fixed axes.

use nalgebra::{Quaternion, Vector3};
use sins::earth::state::EarthFixedState;
use sins::earth::{Earth, navigation_axes};
use sins::math::{
    Compensated, hypot, rotate, rotate_inverse, rotated_z, rotation_increment, rotation_matrix,
};
use sins::mechanization::{BodyMotion, VerticalLoop};
use sins::signal::Increment;

/// The navigator.
#[derive(Debug, Clone, Copy)]
pub struct Wander {
    earth: Earth,
    /// Rotation from wander axes to Earth-fixed axes, components i, j, k, w.
    q_ew: Compensated<4>,
    /// Height above the ellipsoid [m].
    height_m: Compensated<1>,
    /// Velocity against the Earth, in w [m/s].
    v_w: Compensated<3>,
    /// Rotation from body axes to wander axes, components i, j, k, w.
    q_wb: Compensated<4>,
    /// Curvature at the mean position of the last update.
    curvature: Curvature,
    gravity_w: Vector3<f64>,
    vertical: VerticalLoop,
}

/// Curvature of the surface at the height of the vehicle, in a form without latitude and longitude.
#[derive(Debug, Clone, Copy)]
struct Curvature {
    /// 1/(RN + h) [1/m]
    inverse_n: f64,
    /// (1/(RM + h) - 1/(RN + h)) / cos²L [1/m]
    meridian_excess: f64,
}

impl Curvature {
    /// Transport rate for the velocity `v`, or turn of the axes for a displacement. `axis` is the Earth's axis; its horizontal part
    /// points north and has the length cos L.
    #[inline]
    fn transport(&self, axis: &Vector3<f64>, v: &Vector3<f64>) -> Vector3<f64> {
        let north = self.meridian_excess * (axis.x * v.x + axis.y * v.y);
        Vector3::new(-(v.y * self.inverse_n + axis.y * north), v.x * self.inverse_n + axis.x * north, 0.0)
    }
}

/// Curvature and gravity [m/s², w] at the place where the Earth's axis in wander axes is `axis`.
#[inline]
fn surroundings(earth: &Earth, axis: &Vector3<f64>, height_m: f64) -> (Curvature, Vector3<f64>) {
    let (sin, cos) = (axis.z, hypot(axis.x, axis.y));
    let e2 = earth.eccentricity2;
    let inverse_w = 1.0 / (1.0 - e2 * sin * sin).sqrt();
    let transverse = earth.equatorial_radius_m * inverse_w;
    let flattening = transverse * inverse_w * inverse_w;
    let (m, n) = (flattening * (1.0 - e2) + height_m, transverse + height_m);
    let inverse = 1.0 / (m * n);
    let curvature = Curvature { inverse_n: m * inverse, meridian_excess: flattening * e2 * inverse };

    // Gravity in the meridian plane; the direction away from the axis is (up - axis sin L) / cos L.
    let g = earth.gravity(&Vector3::new(n * cos, 0.0, (n - transverse * e2) * sin));
    let away = if cos > 0.0 { g.x / cos } else { 0.0 };
    let mut gravity_w = axis * (g.z - away * sin);
    gravity_w.z += away;
    (curvature, gravity_w)
}

/// `rotation_increment` for the turn of the axes in an update, n < 1e-3 rad, with an error of n⁴/480 of the angle.
#[inline]
fn small_rotation_increment(phi: &Vector3<f64>) -> Quaternion<f64> {
    let n2 = phi.norm_squared();
    Quaternion::from_parts(-0.125 * n2, phi * (0.5 - n2 * (1.0 / 48.0)))
}

impl Wander {
    /// Starts from `state` with the azimuth of east-north-up.
    pub fn new(earth: Earth, state: &EarthFixedState) -> Self {
        let place = earth.to_geodetic(&state.r_e);
        let q_ew = navigation_axes(place.latitude_rad, place.longitude_rad);
        let (curvature, gravity_w) = surroundings(&earth, &rotated_z(&q_ew.conjugate()), place.height_m);
        Self {
            earth,
            q_ew: Compensated::new(q_ew.coords),
            height_m: Compensated::new([place.height_m].into()),
            v_w: Compensated::new(rotate_inverse(&q_ew, &state.v_e)),
            q_wb: Compensated::new((q_ew.conjugate() * state.q_eb).coords),
            curvature,
            gravity_w,
            vertical: VerticalLoop::new(),
        }
    }

    /// One update of length `t` [s] on increments of equal length:
    /// ```text
    /// r̄ - r = T [½ v + ½ C (S2 - S3) + T/6 (g - (2 w_ie + w_en)×v)]
    /// Δr = T [v + C S2 - T w_in×C S3 + T/2 g] - 2 (T w_ie + K (r̄ - r))×(r̄ - r)
    /// Δv = C S1 - ζ×C(S1 - S2) + 1/6 ζ×(ζ×C S1) + T g - (2 T w_ie + K Δr)×Δr/T - T/12 (K Δv)×(Δv - C S1)
    /// q_wb ← q(-ζ) q_wb q(Φ), q_ew ← q_ew q(K Δr), h ← h + Δr_z;  ζ = T w_ie + K Δr
    /// ```
    /// w_ie, gravity g and the curvature in w_en = K v are taken at the mean position r̄. The last term of Δv is the effect of the
    /// change of K v within the update on Coriolis and turn of the axes. Without the term, the error after two minutes of
    /// figure-eights is 2.5e-7 m instead of 9e-9 m.
    pub fn update(&mut self, increments: &[Increment], t: f64) {
        let body = BodyMotion::exact(increments);
        let w = self.earth.rate_rad_s;
        let (q_ew, q_wb) = (Quaternion::from(self.q_ew.value), Quaternion::from(self.q_wb.value));
        let (v, height_m) = (self.v_w.value, self.height_m.value.x);
        let to_wander = rotation_matrix(&q_wb);
        let (s1, s2, s3) = (to_wander * body.s1, to_wander * body.s2, to_wander * body.s3);

        let axis = rotated_z(&q_ew.conjugate());
        let coriolis = (axis * (2.0 * w) + self.curvature.transport(&axis, &v)).cross(&v);
        let unforced = (self.gravity_w - coriolis) * t;
        let mean_offset = (v + s2 - s3) * 0.5 + unforced * (1.0 / 6.0);
        let turn = self.curvature.transport(&axis, &(mean_offset * t));
        let axis = axis - turn.cross(&axis);
        let (curvature, gravity_w) = surroundings(&self.earth, &axis, height_m + mean_offset.z * t);

        let earth_turn = axis * (w * t);
        let mean_velocity = v + s2 - (earth_turn + turn * 2.0).cross(&s3) + gravity_w * (0.5 * t)
            - ((earth_turn + turn) * 2.0).cross(&mean_offset);
        let dr = mean_velocity * t;
        let transport_turn = curvature.transport(&axis, &dr);
        let zeta = earth_turn + transport_turn;
        let rate_change = curvature.transport(&axis, &(s1 + unforced));
        let dv = s1 - zeta.cross(&(s1 - s2)) + zeta.cross(&zeta.cross(&s1)) * (1.0 / 6.0) + gravity_w * t
            - (zeta + earth_turn).cross(&mean_velocity)
            - rate_change.cross(&unforced) * (t / 12.0);

        let turned = q_wb * rotation_increment(&body.rotation);
        let dq_wb = turned + small_rotation_increment(&-zeta) * (q_wb + turned);
        let dq_ew = q_ew * small_rotation_increment(&transport_turn);
        self.v_w.add(&dv);
        self.height_m.add(&[dr.z].into());
        for (q, dq) in [(&mut self.q_wb, dq_wb), (&mut self.q_ew, dq_ew)] {
            q.add(&dq.coords);
            q.carry += q.value * (0.5 * (1.0 - q.value.norm_squared()));
        }
        (self.curvature, self.gravity_w) = (curvature, gravity_w);
    }

    /// Damps the vertical channel by a barometric height [m] at the end of an interval of length `t` [s].
    #[inline]
    pub fn damp_vertical(&mut self, barometer_m: f64, t: f64) {
        let correction = self.vertical.correct(self.height_m.value.x - barometer_m, t);
        self.height_m.add(&[correction.height_m].into());
        self.v_w.add(&Vector3::new(0.0, 0.0, correction.velocity_up_m_s));
    }

    /// The state in Earth-fixed axes.
    pub fn state(&self) -> EarthFixedState {
        let q_ew = Quaternion::from(self.q_ew.value);
        let up_e = rotated_z(&q_ew);
        let transverse = self.earth.radii(up_e.z).transverse_m;
        let mut r_e = up_e * (transverse + self.height_m.value.x);
        r_e.z -= transverse * self.earth.eccentricity2 * up_e.z;
        let q_eb = q_ew * Quaternion::from(self.q_wb.value);
        EarthFixedState { r_e, v_e: rotate(&q_ew, &self.v_w.value), q_eb }
    }
}
