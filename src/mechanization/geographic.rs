//! The navigation-frame part in geographic axes east-north-up, as in the paper; singular at the poles.

use core::f64::consts::FRAC_PI_2;

use nalgebra::{Quaternion, Vector3};

use super::norm::renormalize;
use super::scratch::{AxesRows, Sums};
use super::{BodyMotion, Mechanization, VerticalCorrection};
use crate::base::error::{Error, ErrorKind, Rule};
use crate::base::math::{Compensated, rotate, rotate_inverse, rotation_increment, sin_cos};
use crate::base::snapshot::{NO_SQUARE, stored};
use crate::earth::state::{BodyAxes, EarthFixedState, Navigation};
use crate::earth::{Earth, Geodetic, navigation_axes};

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
    /// Square of the largest turn about the vertical that an update may have caused [rad²].
    turn2: f64,
}

/// Largest size of a navigated longitude [rad]: no flight goes round the Earth as often.
const MAX_LONGITUDE_RAD: f64 = 1e9;

stored!(Geographic { place: MAX_LONGITUDE_RAD, v_n: 1e9, q_nb: 2.0, a_n: 1e18, turn2: 1.0 } then |state, from| {
    from.require(state.turn2 >= 0.0, state.turn2, NO_SQUARE)
});

/// Curvature, Earth rate and gravity at a place.
#[derive(Clone, Copy)]
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

/// Rates and accelerations at a place and a velocity.
#[derive(Clone, Copy)]
struct Moving {
    local: Local,
    /// Transport rate [rad/s]
    omega_en: Vector3<f64>,
    /// Gravity and Coriolis acceleration [m/s²]
    steady: Vector3<f64>,
    /// Rates of latitude and longitude [rad/s] and of height [m/s]
    rate_of_place: Vector3<f64>,
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

    /// The rates for the velocity `v` [m/s].
    fn moving(self, v: &Vector3<f64>) -> Moving {
        let omega_en = self.transport(v);
        Moving {
            omega_en,
            steady: self.gravity - (2.0 * self.omega_ie + omega_en).cross(v),
            rate_of_place: self.change_of_place(v),
            local: self,
        }
    }

    /// Square of the turn about the vertical over a displacement [m], as if the displacement were eastward [rad²].
    fn turn2(&self, dr: &Vector3<f64>) -> f64 {
        let tan_over_n = self.sin / self.cos * self.inverse_n;
        dr.xy().norm_squared() * (tan_over_n * tan_over_n)
    }

    /// Changes of latitude, longitude and height for a displacement [m].
    fn change_of_place(&self, dr: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(dr.y * self.inverse_m, dr.x * self.inverse_n / self.cos, dr.z)
    }
}

/// Mean of a function over an interval, from its start, middle and end.
fn simpson(start: &Vector3<f64>, middle: &Vector3<f64>, end: &Vector3<f64>) -> Vector3<f64> {
    (start + middle * 4.0 + end) * (1.0 / 6.0)
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
            turn2: 0.0,
        }
    }

    /// One update of length `t` [s], predicted and corrected once. With ω_en, k = g - (2 w_ie + w_en)×v and the rates of the
    /// angles at its start, middle and end, Simpson's rule is ∫, and ∫(1 - u) of k is (k0 + 2 k½)/6:
    /// ```text
    /// Δv = C S1 - T w_in×C(S1 - S2) + T²/6 w_in×(w_in×C S1) + ∫k dt + T/12 Δw_in×C S1
    /// Δr = T v + T C S2 - T² w_in×C S3 + T² ∫(1 - u) k du
    /// q  ← q(-ζ) q q(Φ), ζ = ∫ w_in dt
    /// ```
    /// Evidence: near a pole the axes turn by the flown distance over the distance to the pole in each update. With the rate at the
    /// middle alone, a passage at 6.5 km from a pole with 250 m/s at 1 Hz leaves an error of 14 m.
    pub fn update(&mut self, earth: &Earth, body: &BodyMotion, t: f64) {
        let (q, v, place) = (self.q(), self.v_n.value, self.place.value);
        let s1 = rotate(&q, &body.s1);
        let s2 = rotate(&q, &body.s2);
        let s3 = rotate(&q, &body.s3);

        let start = Local::at(earth, place.x, place.z).moving(&v);
        let mut dv = self.a_n * t;
        let mut dr = (v + dv * 0.5) * t;
        let (mut middle, mut end) = (start, start);
        for _ in 0..2 {
            let v_middle = dr * (1.5 / t) - (v * 2.0 + dv) * 0.25;
            let to_middle = (v * 4.0 + v_middle * 8.0 - dv) * (t / 24.0);
            let inverse_m = middle.local.inverse_m;
            middle =
                Local::at(earth, place.x + to_middle.y * inverse_m, place.z + to_middle.z).moving(&v_middle);
            end = Local::at(earth, place.x + dr.y * inverse_m, place.z + dr.z).moving(&(v + dv));
            let omega_in_t =
                (middle.local.omega_ie + simpson(&start.omega_en, &middle.omega_en, &end.omega_en)) * t;
            dv = s1 - omega_in_t.cross(&(s1 - s2))
                + omega_in_t.cross(&omega_in_t.cross(&s1)) / 6.0
                + simpson(&start.steady, &middle.steady, &end.steady) * t;
            dr = (v + s2 - omega_in_t.cross(&s3) + (start.steady + middle.steady * 2.0) * (t / 6.0)) * t;
        }
        let omega_in = [&start, &middle, &end].map(|at| at.local.omega_ie + at.omega_en);
        dv += (omega_in[2] - omega_in[0]).cross(&s1) * (t / 12.0);
        let zeta = simpson(&omega_in[0], &omega_in[1], &omega_in[2]) * t
            + omega_in[0].cross(&omega_in[2]) * (t * t / 12.0);
        let turned = q * rotation_increment(&body.rotation);
        let dq = turned + rotation_increment(&-zeta) * (q + turned);
        let mut d_place = simpson(&start.rate_of_place, &middle.rate_of_place, &end.rate_of_place) * t;
        d_place.z = dr.z;
        self.add(&d_place, &dv, &dq);
        self.turn2 = self.turn2.max(middle.local.turn2(&dr));
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
        self.turn2 = self.turn2.max(local.turn2(&(v * t)));
        self.a_n = dv / t;
    }

    fn add(&mut self, d_place: &Vector3<f64>, dv: &Vector3<f64>, dq: &Quaternion<f64>) {
        self.place.add(d_place);
        self.v_n.add(dv);
        self.q_nb.add(&dq.coords);
        renormalize(&mut self.q_nb);
    }

    /// Attitude: rotates sensor axes to east-north-up.
    pub fn q(&self) -> Quaternion<f64> {
        Quaternion::from(self.q_nb.value)
    }

    /// Checks that the axes are far enough from the poles, and were so during the update.
    pub fn check(&self) -> Result<(), Error> {
        let singular = |field, value: f64, rule| Err(Error::of(ErrorKind::Singular, field, value, rule));
        let latitude = self.place.value.x;
        let (cos, least) = (sin_cos(latitude).1, Mechanization::MIN_COS_LATITUDE);
        if cos < least {
            let words = "the geographic mechanization needs a distance to the pole, as the cosine of latitude, of at least";
            return singular("cosine of the navigated latitude", cos, Rule::AtLeast(words, least.into()));
        }
        let (turn, most) = (self.turn2.sqrt(), Mechanization::MAX_TURN_RAD);
        if turn > most {
            let words =
                "is too large near this pole: use shorter updates or Earth-fixed axes; must be at most";
            return singular(
                "turn of the geographic axes in an update",
                turn,
                Rule::AtMost(words, most.into()),
            );
        }
        // The path of an interval can be longer than the way over the pole.
        if !(latitude.abs() <= FRAC_PI_2 && self.place.value.y.abs() <= MAX_LONGITUDE_RAD) {
            let words = "the geographic mechanization cannot pass a pole; must be at most";
            return singular(
                "size of the navigated latitude_rad",
                latitude.abs(),
                Rule::AtMost(words, FRAC_PI_2.into()),
            );
        }
        Ok(())
    }

    /// Speed squared [m²/s²].
    pub fn speed2(&self) -> f64 {
        self.v_n.value.norm_squared()
    }

    /// The state at `lane` of `rows`.
    pub(super) fn of_rows(rows: &AxesRows, lane: usize) -> Self {
        let Sums { place, velocity, attitude, acceleration } = Sums::of_rows(rows, lane);
        Self { place, v_n: velocity, q_nb: attitude, a_n: acceleration, turn2: rows[23][lane] }
    }

    /// Stores the state at `lane` of `rows`.
    pub(super) fn put_into(&self, rows: &mut AxesRows, lane: usize) {
        let Self { place, v_n: velocity, q_nb: attitude, a_n: acceleration, turn2 } = *self;
        Sums { place, velocity, attitude, acceleration }.put_into(rows, lane);
        rows[23][lane] = turn2;
    }

    /// Height above the ellipsoid [m] and velocity up [m/s].
    pub fn observe_vertical(&self) -> (f64, f64) {
        (self.place.value.z, self.v_n.value.z)
    }

    /// Shifts height [m] and velocity up [m/s]. The velocity correction corresponds to a displacement, whose Coriolis integral is
    /// corrected too.
    pub fn shift_vertical(&mut self, earth: &Earth, correction: &VerticalCorrection) {
        let local = Local::at(earth, self.place.value.x, self.place.value.z);
        let omega = 2.0 * local.omega_ie + local.transport(&self.v_n.value);
        let coriolis = omega.cross(&Vector3::new(0.0, 0.0, correction.displacement_m));
        self.place.add(&Vector3::new(0.0, 0.0, correction.height_m));
        self.v_n.add(&(Vector3::new(0.0, 0.0, correction.velocity_up_m_s) - coriolis));
    }

    /// Adds `dv_e` [m/s], Earth-fixed axes, to the velocity.
    pub fn shift_velocity(&mut self, dv_e: &Vector3<f64>) {
        let place = &self.place.value;
        self.v_n.add(&rotate_inverse(&navigation_axes(place.x, place.y), dv_e));
    }

    /// The state in Earth-fixed axes.
    pub fn state(&self, earth: &Earth) -> EarthFixedState {
        self.navigation(BodyAxes::default()).earth_fixed(earth)
    }

    /// The state in geographic terms, not converted through Earth-fixed axes.
    pub fn navigation(&self, axes: BodyAxes) -> Navigation {
        let place = self.place.value;
        let place = Geodetic { latitude_rad: place.x, longitude_rad: place.y, height_m: place.z };
        Navigation::new(place, self.v_n.value, self.q(), axes)
    }
}
