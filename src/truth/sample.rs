//! One flight-control sample of the host.

use nalgebra::Vector3;

use crate::earth::Geodetic;
use crate::error::{Error, check_range, check_ranges, check_temperature};
use crate::math::Euler;

/// True position, velocity and attitude at an instant, as a flight simulator gives them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlightSample {
    /// Time stamp [s].
    pub time_s: f64,
    /// Geodetic position.
    pub place: Geodetic,
    /// Velocity against the Earth, east-north-up [m/s]; `None`: it follows from position.
    pub v_n: Option<Vector3<f64>>,
    /// Attitude angles [rad], any number of turns.
    pub euler: Euler,
    /// Angular rate against inertial space in sensor axes [rad/s], if the host knows it.
    pub omega_ib_b: Option<Vector3<f64>>,
    /// Specific force in sensor axes [m/s²], if the host knows it.
    pub f_b: Option<Vector3<f64>>,
    /// Temperature of the gyros and accelerometers [°C], if the host knows it.
    pub temperature_c: Option<f64>,
}

impl FlightSample {
    /// Checks each field by itself.
    pub fn validate(&self) -> Result<(), Error> {
        check_range("sample.time_s", self.time_s, -1e10, 1e10)?;
        // A quarter turn that the host rounded up in degrees is still a pole.
        let quarter = core::f64::consts::FRAC_PI_2 + 1e-9;
        check_range("sample.latitude_rad", self.place.latitude_rad, -quarter, quarter)?;
        check_range("sample.longitude_rad", self.place.longitude_rad, -100.0, 100.0)?;
        check_range("sample.height_m", self.place.height_m, -20e3, 2000e3)?;
        if let Some(v_n) = &self.v_n {
            check_ranges("sample.velocity_enu_m_s", v_n.as_slice(), -20e3, 20e3)?;
        }
        check_range("sample.roll_rad", self.euler.roll, -1e4, 1e4)?;
        check_range("sample.pitch_rad", self.euler.pitch, -1e4, 1e4)?;
        check_range("sample.heading_rad", self.euler.heading, -1e4, 1e4)?;
        if let Some(rate) = &self.omega_ib_b {
            check_ranges("sample.angular_rate_rad_s", rate.as_slice(), -1e3, 1e3)?;
        }
        if let Some(force) = &self.f_b {
            check_ranges("sample.specific_force_m_s2", force.as_slice(), -1e5, 1e5)?;
        }
        match self.temperature_c {
            Some(temperature_c) => check_temperature("sample.temperature_c", temperature_c),
            None => Ok(()),
        }
    }

    /// The sample at rest relative to `earth`, for tests and examples: position and attitude as given, no velocity.
    pub fn at_rest(time_s: f64, place: Geodetic, euler: Euler) -> Self {
        let v_n = Some(Vector3::zeros());
        Self { time_s, place, v_n, euler, omega_ib_b: None, f_b: None, temperature_c: None }
    }
}
