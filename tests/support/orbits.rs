//! Flights in closed form in Earth-fixed axes: circles about the Earth's centre. Poles and the date line are not special
//! in these axes.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use sins::earth::state::EarthFixedState;
use sins::earth::{Earth, navigation_axes};
use sins::math::{euler_from_attitude, rotate_inverse, rotation_vector};
use sins::truth::FlightSample;

/// A circle about the Earth's centre, flown at a constant speed with a constant tilt of the body.
#[derive(Clone, Copy)]
pub struct Circle {
    /// Distance from the Earth's centre [m].
    pub radius_m: f64,
    pub speed_m_s: f64,
    /// Distance of the circle's plane from the Earth's centre [m]. The circle misses the point by this distance, sideways.
    pub offset_m: f64,
    /// Rotation of the circle. Without rotation, the circle passes the north pole at time 0 along longitude 0.
    pub place: UnitQuaternion<f64>,
    /// Attitude of the body axes relative to right, forward, up along the path.
    pub tilt: UnitQuaternion<f64>,
}

impl Circle {
    /// A circle past the point to which `place` turns the north pole, 10 km above it, at 250 m/s, banked, pitched and crabbing.
    pub fn past(place: UnitQuaternion<f64>, offset_m: f64) -> Self {
        let tilt = UnitQuaternion::new(Vector3::new(0.03, 0.2, -0.1));
        Self { radius_m: 6_366_752.0, speed_m_s: 250.0, offset_m, place, tilt }
    }

    /// The state at `time_s`.
    pub fn state(&self, time_s: f64) -> EarthFixedState {
        let own = (self.radius_m * self.radius_m - self.offset_m * self.offset_m).sqrt();
        let angle = self.speed_m_s / own * time_s;
        let (sin, cos) = angle.sin_cos();
        // Right, forward and up are -y, x and z at time 0.
        let start = about(Vector3::z(), -std::f64::consts::FRAC_PI_2);
        let q_eb: Quaternion<f64> =
            (self.place * about(Vector3::y(), angle) * start * self.tilt).into_inner();
        EarthFixedState {
            r_e: self.place * Vector3::new(own * sin, self.offset_m, own * cos),
            v_e: self.place * (Vector3::new(cos, 0.0, -sin) * self.speed_m_s),
            q_eb,
        }
    }

    /// The sample of a host at `time_s`.
    pub fn sample(&self, time_s: f64) -> FlightSample {
        sample_of(time_s, &self.state(time_s))
    }
}

/// Rotation by `angle` [rad] about `axis`.
pub fn about(axis: Vector3<f64>, angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&nalgebra::Unit::new_normalize(axis), angle)
}

/// The sample of a host at `state`.
pub fn sample_of(time_s: f64, state: &EarthFixedState) -> FlightSample {
    let place = Earth::default().to_geodetic(&state.r_e);
    sample_at(time_s, state, place.latitude_rad, place.longitude_rad)
}

/// The sample of a host at `state` whose angles refer to the given latitude and longitude: next to a pole, any longitude
/// is valid.
pub fn sample_at(
    time_s: f64,
    state: &EarthFixedState,
    latitude_rad: f64,
    longitude_rad: f64,
) -> FlightSample {
    let q_en = navigation_axes(latitude_rad, longitude_rad);
    let mut place = Earth::default().to_geodetic(&state.r_e);
    (place.latitude_rad, place.longitude_rad) = (latitude_rad, longitude_rad);
    FlightSample {
        v_n: Some(rotate_inverse(&q_en, &state.v_e)),
        ..FlightSample::at_rest(time_s, place, euler_from_attitude(&(q_en.conjugate() * state.q_eb)))
    }
}

/// Differences in Earth-fixed axes, which have the same meaning at every place.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Apart {
    pub position_m: f64,
    pub velocity_m_s: f64,
    pub attitude_rad: f64,
}

impl Apart {
    /// The differences of `found` and `expected`.
    pub fn new(found: &EarthFixedState, expected: &EarthFixedState) -> Self {
        Self {
            position_m: (found.r_e - expected.r_e).norm(),
            velocity_m_s: (found.v_e - expected.v_e).norm(),
            attitude_rad: rotation_vector(&(expected.q_eb.conjugate() * found.q_eb)).norm(),
        }
    }

    /// The larger one of each difference.
    pub fn worst(self, other: Self) -> Self {
        Self {
            position_m: self.position_m.max(other.position_m),
            velocity_m_s: self.velocity_m_s.max(other.velocity_m_s),
            attitude_rad: self.attitude_rad.max(other.attitude_rad),
        }
    }
}

impl std::fmt::Display for Apart {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.1e} m, {:.1e} m/s, {:.1e} rad", self.position_m, self.velocity_m_s, self.attitude_rad)
    }
}

/// The navigated state of `simulator` in Earth-fixed axes.
pub fn navigated(simulator: &sins::Simulator) -> EarthFixedState {
    simulator.navigation().unwrap().unwrap().navigation.earth_fixed(&Earth::default())
}

/// Flies the motion `state`, a function of time, from `start_s` over `count` intervals at `rate_hz`, with the samples
/// that `sample` makes. Returns the largest differences of the navigated state from the motion.
pub fn apart_on_the_way(
    simulator: &mut sins::Simulator,
    (start_s, count, rate_hz): (f64, u32, f64),
    state: impl Fn(f64) -> EarthFixedState,
    mut sample: impl FnMut(f64, &EarthFixedState) -> FlightSample,
) -> Apart {
    let mut worst = Apart::default();
    for k in 0..=count {
        let time_s = start_s + f64::from(k) / rate_hz;
        let exact = state(time_s);
        simulator.push_sample(&sample(time_s, &exact)).unwrap();
        simulator.step().unwrap();
        worst = worst.worst(Apart::new(&navigated(simulator), &exact));
    }
    worst
}
