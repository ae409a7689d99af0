//! `sins_flight_sample`.

use nalgebra::Vector3;

use super::choice::flag;
use super::failure::CallError;
use super::memory::{Array, interface_struct};
use crate::base::error::{Error, Rule};
use crate::base::math::Euler;
use crate::earth::Geodetic;
use crate::truth::FlightSample;

/// Flags of a sins_flight_sample.
pub type sins_sample_flags = u32;

/// The sample carries angular_rate_rad_s.
pub const SINS_SAMPLE_ANGULAR_RATE: sins_sample_flags = 1;
/// The sample carries specific_force_m_s2.
pub const SINS_SAMPLE_SPECIFIC_FORCE: sins_sample_flags = 2;
/// The sample has no velocity. The library derives it from positions. The noise of this velocity is 2 to 4 times the position
/// noise of a sample, divided by the interval.
pub const SINS_SAMPLE_NO_VELOCITY: sins_sample_flags = 4;
/// The sample carries temperature_c.
pub const SINS_SAMPLE_TEMPERATURE: sins_sample_flags = 8;

const KNOWN_FLAGS: u32 =
    SINS_SAMPLE_ANGULAR_RATE | SINS_SAMPLE_SPECIFIC_FORCE | SINS_SAMPLE_NO_VELOCITY | SINS_SAMPLE_TEMPERATURE;

/// True motion of the vehicle at an instant, as a flight simulator gives it. The ideal signals are computed from velocity and
/// attitude, and from angular rate and specific force if the sample carries them. Position enters only through gravity and
/// curvature, unless the samples have no velocity: then the velocity is derived from the positions. Vibration above a tenth
/// of the sample rate cannot be recovered from samples; give angular rate and specific force if you have them.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_flight_sample {
    /// sizeof(sins_flight_sample)
    pub struct_size: u32,
    /// Flags of enum sins_sample_flags, or'ed.
    pub flags: u32,
    /// Time stamp, -1e10 to 1e10 [s], later than the sample before by 5e-5 s to sins_options.max_gap_s. Large stamps are coarse
    /// (1.2e-7 s at 1e9 s): state sins_options.sample_period_s with them.
    pub time_s: f64,
    /// Geodetic latitude, -pi/2 to pi/2 [rad].
    pub latitude_rad: f64,
    /// Longitude, east positive, -100 to 100 [rad]; whole turns do not matter.
    pub longitude_rad: f64,
    /// Height above the ellipsoid, -2e4 to 2e6 [m].
    pub height_m: f64,
    /// Velocity against the Earth, east-north-up, each -2e4 to 2e4 [m/s].
    pub velocity_enu_m_s: [f64; 3],
    /// Roll, right wing down positive, -1e4 to 1e4 [rad]; whole turns do not matter. So angles in degrees are accepted, too:
    /// sins_truth_summary reveals them.
    pub roll_rad: f64,
    /// Pitch, nose up positive, -1e4 to 1e4 [rad]; it may go beyond 90 degrees. From one sample to the next the attitude must
    /// turn by less than 170 degrees. The library predicts this turn from the angular rates of the samples, or, without
    /// rates, from the previous interval. The turn must differ from the prediction by less than 180 degrees. Additional whole
    /// turns between two samples cannot be detected.
    pub pitch_rad: f64,
    /// Heading, clockwise from true north, -1e4 to 1e4 [rad], not degrees (see roll_rad); whole turns do not matter.
    pub heading_rad: f64,
    /// With SINS_SAMPLE_ANGULAR_RATE: angular rate of the vehicle against inertial space along the body axes at this instant,
    /// each -1000 to 1000 [rad/s].
    pub angular_rate_rad_s: [f64; 3],
    /// With SINS_SAMPLE_SPECIFIC_FORCE: specific force at the reference point along the body axes at this instant, each -1e5
    /// to 1e5 [m/s2].
    pub specific_force_m_s2: [f64; 3],
    /// With SINS_SAMPLE_TEMPERATURE: temperature of the gyros and accelerometers at this instant, -273.15 to 1000 [deg C]; linear
    /// from one sample to the next. Needed while temperature coefficients are set: the push of a sample without it then returns
    /// SINS_ERROR_INVALID_ARGUMENT, because a forgotten flag would silently disable the effect.
    pub temperature_c: f64,
}

interface_struct!(sins_flight_sample, "sample", 144);

impl sins_flight_sample {
    pub(super) fn to_sample(self) -> Result<FlightSample, CallError> {
        let unknown = self.flags & !KNOWN_FLAGS;
        if unknown != 0 {
            let rule = Rule::Sentence("must be a combination of SINS_SAMPLE_ flags; it has unknown bits");
            return Err(Error::invalid("sample.flags", self.flags, rule).into());
        }
        let given = |flag: u32, values: [f64; 3]| (self.flags & flag != 0).then_some(Vector3::from(values));
        let has_velocity = self.flags & SINS_SAMPLE_NO_VELOCITY == 0;
        Ok(FlightSample {
            time_s: self.time_s,
            place: Geodetic {
                latitude_rad: self.latitude_rad,
                longitude_rad: self.longitude_rad,
                height_m: self.height_m,
            },
            v_n: has_velocity.then_some(Vector3::from(self.velocity_enu_m_s)),
            euler: Euler { roll: self.roll_rad, pitch: self.pitch_rad, heading: self.heading_rad },
            omega_ib_b: given(SINS_SAMPLE_ANGULAR_RATE, self.angular_rate_rad_s),
            f_b: given(SINS_SAMPLE_SPECIFIC_FORCE, self.specific_force_m_s2),
            temperature_c: (self.flags & SINS_SAMPLE_TEMPERATURE != 0).then_some(self.temperature_c),
        })
    }
}

impl Array<sins_flight_sample> {
    /// Sample `index` of a host; a failure names it.
    pub(super) fn sample(&self, index: usize) -> Result<FlightSample, CallError> {
        let sample = self.read(index).and_then(sins_flight_sample::to_sample);
        sample.map_err(|failure| failure.of_sample(index))
    }
}

impl From<&FlightSample> for sins_flight_sample {
    fn from(sample: &FlightSample) -> Self {
        let flags = flag(sample.omega_ib_b.is_some(), SINS_SAMPLE_ANGULAR_RATE)
            | flag(sample.f_b.is_some(), SINS_SAMPLE_SPECIFIC_FORCE)
            | flag(sample.v_n.is_none(), SINS_SAMPLE_NO_VELOCITY)
            | flag(sample.temperature_c.is_some(), SINS_SAMPLE_TEMPERATURE);
        Self {
            struct_size: size_of::<Self>() as u32,
            flags,
            time_s: sample.time_s,
            latitude_rad: sample.place.latitude_rad,
            longitude_rad: sample.place.longitude_rad,
            height_m: sample.place.height_m,
            velocity_enu_m_s: sample.v_n.unwrap_or_default().into(),
            roll_rad: sample.euler.roll,
            pitch_rad: sample.euler.pitch,
            heading_rad: sample.euler.heading,
            angular_rate_rad_s: sample.omega_ib_b.unwrap_or_default().into(),
            specific_force_m_s2: sample.f_b.unwrap_or_default().into(),
            temperature_c: sample.temperature_c.unwrap_or_default(),
        }
    }
}
