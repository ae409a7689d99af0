//! The navigation-frame part in geographic axes east-north-up: the paper's, singular at the poles.

use nalgebra::{Quaternion, Vector3};

use super::{BodyMotion, VerticalCorrection, check_rotation, renormalize};
use crate::earth::{Earth, Geodetic, navigation_axes};
use crate::math::{Compensated, rotate, rotate_inverse, rotation_increment, sin_cos};
use crate::snapshot::stored;
use crate::state::{BodyAxes, EarthFixedState, Navigation};

/// Latitude, longitude, height, velocity and attitude in east-north-up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geographic {
    /// Latitude [rad], longitude [rad], height [m].
    place: Compensated<3>,
    v_n: Compensated<3>,
    /// Components i, j, k, w.
    q_nb: Compensated<4>,
    /// Acceleration against the Earth in the last update [m/s²].
    a_n: Vector3<f64>,
}

stored!(Geographic { place: 1e9, v_n: 1e9, q_nb: 2.0, a_n: 1e9 } then |state, from| check_rotation(&state.q_nb, from));

/// What the navigation axes and the Earth do at a place.
struct Local {
    sin: f64,
    cos: f64,
    /// 1/(RM + h), 1/(RN + h) [1/m]
    inverse_m: f64,
    inverse_n: f64,
    /// Earth rate [rad/s]
    omega_ie: Vector3<f64>,
    /// Gravity [m/s²]
    gravity: Vector3<f64>,
}

impl Local {
    fn at(earth: &Earth, latitude_rad: f64, height_m: f64) -> Self {
        let (sin, cos) = sin_cos(latitude_rad);
        let radii = earth.radii(sin);
        let n = radii.transverse_m + height_m;
        // Gravity in the meridian plane, turned to north and up.
        let meridian = Vector3::new(n * cos, 0.0, (n - radii.transverse_m * earth.eccentricity2) * sin);
        let g = earth.gravity(&meridian);
        Self {
            sin,
            cos,
            inverse_m: 1.0 / (radii.meridian_m + height_m),
            inverse_n: 1.0 / n,
            omega_ie: Vector3::new(0.0, earth.rate_rad_s * cos, earth.rate_rad_s * sin),
            gravity: Vector3::new(0.0, g.z * cos - g.x * sin, g.x * cos + g.z * sin),
        }
    }

    /// Transport rate for the velocity `v`, or rotation of the axes for a displacement.
    fn transport(&self, v: &Vector3<f64>) -> Vector3<f64> {
        let east = v.x * self.inverse_n;
        Vector3::new(-v.y * self.inverse_m, east, east * self.sin / self.cos)
    }

    /// Changes of latitude, longitude and height for a displacement [m].
    fn change_of_place(&self, dr: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(dr.y * self.inverse_m, dr.x * self.inverse_n / self.cos, dr.z)
    }
}

impl Geographic {
    /// Starts from `state`.
    pub fn new(earth: &Earth, state: &EarthFixedState) -> Self {
        let place = earth.to_geodetic(&state.r_e);
        let q_en = navigation_axes(place.latitude_rad, place.longitude_rad);
        Self {
            place: Compensated::new(Vector3::new(place.latitude_rad, place.longitude_rad, place.height_m)),
            v_n: Compensated::new(rotate_inverse(&q_en, &state.v_e)),
            q_nb: Compensated::new((q_en.conjugate() * state.q_eb).coords),
            a_n: Vector3::zeros(),
        }
    }

    /// One update of length `t` [s], predicted and corrected once, Earth terms of the middle of the update:
    /// ```text
    /// Δv = C S1 - T w_in×C(S1 - S2) + T²/6 w_in×(w_in×C S1) + T (g - (2 w_ie + w_en)×v̄) - T/12 Δw_en×(Δv - C S1)
    /// Δr = T v + T C S2 - T² w_in×C S3 + T²/2 (g - (2 w_ie + w_en)×v̄)
    /// q  ← q(-ζ) q q(Φ), ζ = ∫ w_in dt
    /// ```
    /// The last term of Δv is what the change Δw_en of the transport rate within the update does to Coriolis and turn of
    /// the axes: without it two minutes of figure-eights leave 5e-9 m/s instead of 4e-10 m/s.
    pub fn update(&mut self, earth: &Earth, body: &BodyMotion, t: f64) {
        let (q, v, place) = (self.q(), self.v_n.value, self.place.value);
        let s1 = rotate(&q, &body.s1);
        let s2 = rotate(&q, &body.s2);
        let s3 = rotate(&q, &body.s3);

        let mut dv = self.a_n * t;
        let mut dr = (v + dv * 0.5) * t;
        let mut local = Local::at(earth, place.x, place.z);
        for _ in 0..2 {
            let to_middle = local.change_of_place(&((v * 0.5 + dv * 0.125) * t));
            local = Local::at(earth, place.x + to_middle.x, place.z + to_middle.z);
            let mean_velocity = dr / t;
            let omega_en = local.transport(&mean_velocity);
            let omega_in_t = (local.omega_ie + omega_en) * t;
            let steady = (local.gravity - (2.0 * local.omega_ie + omega_en).cross(&mean_velocity)) * t;
            dv = s1 - omega_in_t.cross(&(s1 - s2)) + omega_in_t.cross(&omega_in_t.cross(&s1)) / 6.0 + steady;
            dr = (v + s2 - omega_in_t.cross(&s3) + steady * 0.5) * t;
        }
        dv -= local.transport(&dv).cross(&(dv - s1)) * (t / 12.0);
        let zeta = local.omega_ie * t + local.transport(&dr);
        let turned = q * rotation_increment(&body.rotation);
        let dq = turned + rotation_increment(&-zeta) * (q + turned);
        self.add(&local.change_of_place(&dr), &dv, &dq);
        self.a_n = dv / t;
    }

    /// One update of the paper's equations (7)-(24): Φ - Cᵀ w_in T as the rotation vector, factor I - ½ T w_in×, Earth
    /// terms of the start, position by the velocity of the start.
    pub fn update_paper(&mut self, earth: &Earth, body: &BodyMotion, t: f64) {
        let (q, v, place) = (self.q(), self.v_n.value, self.place.value);
        let local = Local::at(earth, place.x, place.z);
        let omega_en = local.transport(&v);
        let omega_in_t = (local.omega_ie + omega_en) * t;
        let s1 = rotate(&q, &body.s1);
        let steady = (local.gravity - (2.0 * local.omega_ie + omega_en).cross(&v)) * t;
        let dv = s1 - 0.5 * omega_in_t.cross(&s1) + steady;
        let dq = q * rotation_increment(&(body.rotation - rotate_inverse(&q, &omega_in_t)));
        self.add(&local.change_of_place(&(v * t)), &dv, &dq);
        self.a_n = dv / t;
    }

    fn add(&mut self, d_place: &Vector3<f64>, dv: &Vector3<f64>, dq: &Quaternion<f64>) {
        self.place.add(d_place);
        self.v_n.add(dv);
        self.q_nb.add(&dq.coords);
        renormalize(&mut self.q_nb);
    }

    fn q(&self) -> Quaternion<f64> {
        Quaternion::from(self.q_nb.value)
    }

    /// Cosine of the latitude; negative beyond a pole.
    pub fn cos_latitude(&self) -> f64 {
        sin_cos(self.place.value.x).1
    }

    /// Speed squared [m²/s²].
    pub fn speed2(&self) -> f64 {
        self.v_n.value.norm_squared()
    }

    /// Height above the ellipsoid [m] and velocity up [m/s].
    pub fn observe_vertical(&self) -> (f64, f64) {
        (self.place.value.z, self.v_n.value.z)
    }

    /// Shifts height [m] and velocity up [m/s], with the Coriolis integral of the displacement that the velocity
    /// correction stands for.
    pub fn shift_vertical(&mut self, earth: &Earth, correction: &VerticalCorrection) {
        let local = Local::at(earth, self.place.value.x, self.place.value.z);
        let omega = 2.0 * local.omega_ie + local.transport(&self.v_n.value);
        let coriolis = omega.cross(&Vector3::new(0.0, 0.0, correction.displacement_m));
        self.place.add(&Vector3::new(0.0, 0.0, correction.height_m));
        self.v_n.add(&(Vector3::new(0.0, 0.0, correction.velocity_up_m_s) - coriolis));
    }

    /// The state in geographic terms, without a detour over Earth-fixed axes.
    pub fn navigation(&self, axes: BodyAxes) -> Navigation {
        let place = self.place.value;
        let place = Geodetic { latitude_rad: place.x, longitude_rad: place.y, height_m: place.z };
        Navigation::new(place, self.v_n.value, self.q(), axes)
    }
}
