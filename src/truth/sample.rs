//! One flight sample of the host.

use nalgebra::Vector3;

use crate::base::error::{Error, check_range, check_ranges, check_temperature};
use crate::base::math::{Euler, sin_cos};
use crate::base::snapshot::{ANY, Numbers, Reader, Stored, Writer};
use crate::base::units::DEG;
use crate::earth::Geodetic;

/// True position, velocity and attitude at an instant, as a flight simulator gives them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FlightSample {
    /// Time stamp [s].
    pub time_s: f64,
    /// Geodetic position.
    pub place: Geodetic,
    /// Velocity against the Earth, east-north-up [m/s]; `None`: it follows from position.
    pub v_n: Option<Vector3<f64>>,
    /// Attitude angles [rad], any number of turns.
    pub euler: Euler,
    /// Angular rate against inertial space in body axes [rad/s], if the host knows it.
    pub omega_ib_b: Option<Vector3<f64>>,
    /// Specific force at the reference point in body axes [m/s²], if the host knows it.
    pub f_b: Option<Vector3<f64>>,
    /// Temperature of the gyros and accelerometers [°C], if the host knows it.
    pub temperature_c: Option<f64>,
}

/// Checks a height above the ellipsoid [m] of a sample, or of a flight from which samples are made.
pub(crate) fn check_height(field: &'static str, height_m: f64) -> Result<(), Error> {
    let (low, high) = FlightSample::HEIGHT_RANGE_M;
    check_range(field, height_m, low, high)
}

/// Speed above which a vehicle is not at rest [m/s], and tilt that none at rest has [rad].
const MOVES_M_S: f64 = 2.0;
const TILTED_RAD: f64 = 10.0 * DEG;

/// Bits of a stored sample: it has no velocity, has a rate, has a force, has a temperature.
const NO_VELOCITY: usize = 1;
const WITH_RATE: usize = 2;
const WITH_FORCE: usize = 4;
const WITH_TEMPERATURE: usize = 8;

impl Stored for FlightSample {
    fn save(&self, to: &mut Writer<'_>) {
        let Self { time_s, place, v_n, euler, omega_ib_b, f_b, temperature_c } = self;
        let bit = |is_set: bool, bit: usize| if is_set { bit } else { 0 };
        to.count(
            bit(v_n.is_none(), NO_VELOCITY)
                | bit(omega_ib_b.is_some(), WITH_RATE)
                | bit(f_b.is_some(), WITH_FORCE)
                | bit(temperature_c.is_some(), WITH_TEMPERATURE),
        );
        time_s.save(to);
        place.save(to);
        euler.save(to);
        [v_n, omega_ib_b, f_b].into_iter().flatten().for_each(|vector| vector.save(to));
        temperature_c.iter().for_each(|temperature| temperature.save(to));
    }

    fn load(&mut self, from: &mut Reader<'_>) -> Result<(), Error> {
        from.enter("snapshot: FlightSample");
        let kind = from.count(NO_VELOCITY | WITH_RATE | WITH_FORCE | WITH_TEMPERATURE)?;
        let Self { time_s, place, v_n, euler, omega_ib_b, f_b, temperature_c } = self;
        time_s.load(from, ANY)?;
        place.load(from)?;
        euler.load(from)?;
        let parts = [(v_n, NO_VELOCITY, false), (omega_ib_b, WITH_RATE, true), (f_b, WITH_FORCE, true)];
        for (part, bit, is_there) in parts {
            *part = None;
            if (kind & bit != 0) == is_there {
                part.insert(Vector3::zeros()).load(from, ANY)?;
            }
        }
        *temperature_c = None;
        if kind & WITH_TEMPERATURE != 0 {
            temperature_c.insert(0.0).load(from, ANY)?;
        }
        Ok(())
    }
}

impl FlightSample {
    /// Heights above the ellipsoid that a sample may have [m].
    pub const HEIGHT_RANGE_M: (f64, f64) = (-20e3, 2000e3);
    /// Largest component of its velocity [m/s].
    pub const MAX_VELOCITY_M_S: f64 = 20e3;
    /// Largest size of the longitude [rad].
    pub const MAX_LONGITUDE_RAD: f64 = 100.0;
    /// Largest size of an attitude angle [rad]: many turns, with enough digits left for the angle.
    pub const MAX_ANGLE_RAD: f64 = 1e4;
    /// Largest size of a time stamp [s].
    pub const LATEST_S: f64 = 1e10;
    /// Largest component of its angular rate [rad/s].
    pub const MAX_RATE_RAD_S: f64 = 1e3;
    /// Largest component of its specific force [m/s²].
    pub const MAX_FORCE_M_S2: f64 = 1e5;

    /// Checks each field by itself.
    pub fn validate(&self) -> Result<(), Error> {
        check_range("sample.time_s", self.time_s, -Self::LATEST_S, Self::LATEST_S)?;
        // A quarter turn that the host rounded up in degrees is still a pole.
        let quarter = core::f64::consts::FRAC_PI_2 + 1e-9;
        check_range("sample.latitude_rad", self.place.latitude_rad, -quarter, quarter)?;
        let (longitude, velocity, angle) =
            (Self::MAX_LONGITUDE_RAD, Self::MAX_VELOCITY_M_S, Self::MAX_ANGLE_RAD);
        check_range("sample.longitude_rad", self.place.longitude_rad, -longitude, longitude)?;
        check_height("sample.height_m", self.place.height_m)?;
        if let Some(v_n) = &self.v_n {
            check_ranges("sample.velocity_enu_m_s", v_n.as_slice(), -velocity, velocity)?;
        }
        check_range("sample.roll_rad", self.euler.roll, -angle, angle)?;
        check_range("sample.pitch_rad", self.euler.pitch, -angle, angle)?;
        check_range("sample.heading_rad", self.euler.heading, -angle, angle)?;
        if let Some(rate) = &self.omega_ib_b {
            let largest = Self::MAX_RATE_RAD_S;
            check_ranges("sample.angular_rate_rad_s", rate.as_slice(), -largest, largest)?;
        }
        if let Some(force) = &self.f_b {
            let largest = Self::MAX_FORCE_M_S2;
            check_ranges("sample.specific_force_m_s2", force.as_slice(), -largest, largest)?;
        }
        match self.temperature_c {
            Some(temperature_c) => check_temperature("sample.temperature_c", temperature_c),
            None => Ok(()),
        }
    }

    /// Whether the vehicle is in motion, and tilted as none is at rest: faster than 2 m/s, by its own velocity, and more than 10
    /// degrees from level.
    pub fn is_tilted_in_motion(&self) -> bool {
        let cosine = sin_cos(self.euler.roll).1 * sin_cos(self.euler.pitch).1;
        self.v_n.is_some_and(|v_n| v_n.norm_squared() > MOVES_M_S * MOVES_M_S)
            && cosine < sin_cos(TILTED_RAD).1
    }

    /// The sample at rest relative to `earth`, for tests and examples: position and attitude as given, no velocity.
    pub fn at_rest(time_s: f64, place: Geodetic, euler: Euler) -> Self {
        let v_n = Some(Vector3::zeros());
        Self { time_s, place, v_n, euler, omega_ib_b: None, f_b: None, temperature_c: None }
    }
}
