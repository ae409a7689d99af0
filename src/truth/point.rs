//! A checked sample, with the values that later blocks need.

use core::f64::consts::FRAC_PI_2;

use nalgebra::{Matrix3, Quaternion, Vector3};

use super::FlightSample;
use crate::base::math::{Euler, attitude_from_half_angles, rotate, rotated_z, rotation_matrix, sin_cos_each};
use crate::earth::state::{BodyAxes, EarthFixedState, NEAR_POLE_M, Navigation};
use crate::earth::{Earth, Geodetic, Vertical, navigation_axes_from_half_angles};

/// An interval is a gap if it is more than this many times the interval before it. One lost sample is not a gap.
const GAP: f64 = 2.5;

/// Truth at a sample, in Earth-fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TruthPoint {
    /// Time on the time base [s].
    pub time_s: f64,
    /// Time since the point before [s]; 0 at the first.
    pub interval_s: f64,
    /// Position, velocity, attitude.
    pub state: EarthFixedState,
    /// Attitude against east-north-up.
    pub q_nb: Quaternion<f64>,
    /// Matrix of the attitude: sensor axes to Earth-fixed axes.
    pub to_earth: Matrix3<f64>,
    /// Unit vector up.
    pub up_e: Vector3<f64>,
    /// Gravity there [m/s²].
    pub gravity_e: Vector3<f64>,
    /// Acceleration against the Earth [m/s²], if the host gave the specific force.
    pub a_e: Option<Vector3<f64>>,
    /// The sample itself, which other blocks do not see.
    pub(super) sample: FlightSample,
}

impl TruthPoint {
    /// The point of `sample` at `time_s`, `interval_s` after the one before.
    pub(super) fn new(
        earth: &Earth,
        axes: BodyAxes,
        sample: &FlightSample,
        time_s: f64,
        interval_s: f64,
    ) -> Self {
        // The check accepts latitudes that rounding put beyond a pole: they count as the pole.
        let latitude_rad = sample.place.latitude_rad.clamp(-FRAC_PI_2, FRAC_PI_2);
        let sample = FlightSample { place: Geodetic { latitude_rad, ..sample.place }, ..*sample };
        let Euler { roll, pitch, heading } = sample.euler;
        // Sines and cosines are computed in pairs, so six take no longer than five.
        let angles = [latitude_rad, sample.place.longitude_rad, roll, pitch, heading, 0.0];
        let (sines, cosines) = sin_cos_each(&angles.map(|angle| 0.5 * angle));
        let ([sl, so, sr, sp, sh, _], [cl, co, cr, cp, ch, _]) = (sines, cosines);
        let q_en = navigation_axes_from_half_angles(&[sl, so], &[cl, co]);
        let q_nb = axes.exchange(&attitude_from_half_angles(&[sr, sp, sh], &[cr, cp, ch]));
        let up_e = rotated_z(&q_en);
        let transverse_m = earth.radii(up_e.z).transverse_m;
        let mut r_e = up_e * (transverse_m + sample.place.height_m);
        r_e.z -= earth.eccentricity2 * transverse_m * up_e.z;
        let state =
            EarthFixedState { r_e, v_e: rotate(&q_en, &sample.v_n.unwrap_or_default()), q_eb: q_en * q_nb };
        let gravity_e = earth.gravity(&r_e);
        let to_earth = rotation_matrix(&state.q_eb);
        let mut point =
            Self { time_s, interval_s, state, q_nb, to_earth, up_e, gravity_e, a_e: None, sample };
        point.use_specific_force(earth);
        point
    }

    /// Gives the point a velocity [m/s] that its sample does not have.
    pub(super) fn set_velocity(&mut self, earth: &Earth, v_e: Vector3<f64>) {
        self.state.v_e = v_e;
        self.use_specific_force(earth);
    }

    /// a = C f + g - 2 W×v
    fn use_specific_force(&mut self, earth: &Earth) {
        let v_e = &self.state.v_e;
        let coriolis = Vector3::new(v_e.y, -v_e.x, 0.0) * (2.0 * earth.rate_rad_s);
        self.a_e = self.sample.f_b.map(|f_b| self.to_earth * f_b + self.gravity_e + coriolis);
    }

    /// Whether samples were lost since `last`: the interval is much longer than the one before it.
    #[inline]
    pub(crate) fn ends_gap(&self, last: &Self) -> bool {
        self.interval_s > GAP * last.interval_s
    }

    /// If the interval to this point is a gap: its length, divided by that of the longer of the two intervals before it. `last` and
    /// `before` are the points before this one.
    #[inline]
    pub(crate) fn gap_ratio(&self, last: &Self, before: Option<&Self>) -> Option<f64> {
        if self.ends_gap(last) { self.ratio_to_usual(last, before) } else { None }
    }

    #[cold]
    #[inline(never)]
    fn ratio_to_usual(&self, last: &Self, before: Option<&Self>) -> Option<f64> {
        // Of the two intervals that lie between the points that are kept.
        let usual_s = last.interval_s.max(before.map_or(0.0, |point| point.interval_s));
        let ratio = self.interval_s / usual_s;
        // At the start there is no usual length.
        (usual_s > 0.0 && ratio > GAP).then_some(ratio)
    }

    /// The sample's own time stamp [s].
    pub fn stamp_s(&self) -> f64 {
        self.sample.time_s
    }

    /// Geodetic position.
    pub fn place(&self) -> &Geodetic {
        &self.sample.place
    }

    /// Height above the ellipsoid [m].
    pub fn height_m(&self) -> f64 {
        self.sample.place.height_m
    }

    /// Whether the host gave the velocity; else it follows from positions.
    pub fn has_velocity(&self) -> bool {
        self.sample.v_n.is_some()
    }

    /// Velocity up [m/s].
    pub fn velocity_up_m_s(&self) -> f64 {
        match &self.sample.v_n {
            Some(v_n) => v_n.z,
            None => self.up_e.dot(&self.state.v_e),
        }
    }

    /// Angular rate against inertial space in sensor axes [rad/s], if the host gave it.
    pub fn omega_ib_b(&self) -> Option<Vector3<f64>> {
        self.sample.omega_ib_b
    }

    /// Attitude of the vehicle if it is banked or pitched in flight, see [`FlightSample::is_tilted_in_motion`].
    pub fn tilted_in_motion(&self) -> Option<Euler> {
        self.sample.is_tilted_in_motion().then_some(self.sample.euler)
    }

    /// Temperature of the gyros and accelerometers [°C], if the host gave it.
    pub fn temperature_c(&self) -> Option<f64> {
        self.sample.temperature_c
    }

    /// The vertical there.
    pub fn vertical(&self) -> Vertical {
        Vertical { up_e: self.up_e, height_m: self.sample.place.height_m }
    }

    /// Whether it is within [`NEAR_POLE_M`] of the Earth's axis.
    pub fn is_near_pole(&self) -> bool {
        self.state.r_e.xy().norm_squared() < NEAR_POLE_M * NEAR_POLE_M
    }

    /// The point in geographic terms: the host's own place and velocity, to the bit.
    pub fn navigation(&self, earth: &Earth, axes: BodyAxes) -> Navigation {
        self.given(axes).unwrap_or_else(|| self.state.navigation(earth, axes))
    }

    /// The same, if the host gave the velocity.
    #[inline(always)]
    pub(crate) fn given(&self, axes: BodyAxes) -> Option<Navigation> {
        self.sample.v_n.map(|v_n| Navigation::new(self.sample.place, v_n, self.q_nb, axes))
    }
}
