//! What is known of the sensors before the record.

use crate::base::error::{Error, check_range};
use crate::base::units::{ARCSEC, DEG, DEG_PER_HOUR, PPM, STANDARD_GRAVITY as G};
use crate::sensors::Grade;

/// Standard deviations of what a record may show, before it is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prior {
    /// Bias of a gyro [rad/s], 1e-12 to 100.
    pub gyro_bias: f64,
    /// Scale factor error of a gyro [1], 1e-9 to 1.
    pub gyro_scale_factor: f64,
    /// Misalignment of a gyro [rad], 1e-9 to 1.
    pub gyro_misalignment: f64,
    /// Bias of an accelerometer [m/s²], 1e-9 to 1e3.
    pub accel_bias: f64,
    /// Scale factor error of an accelerometer [1], 1e-9 to 1.
    pub accel_scale_factor: f64,
    /// Misalignment of an accelerometer [rad], 1e-9 to 1.
    pub accel_misalignment: f64,
    /// Each angle of the record's axes from the nearest exchange of the path's axes [rad], 1e-9 to 1.
    pub mounting: f64,
    /// Each component of the lever arm from the point of the path to the accelerometers [m], 1e-6 to 1e3.
    pub lever_arm_m: f64,
    /// Each g-sensitivity of the gyros [rad/s per m/s²], 1e-12 to 1.
    pub g_sensitivity: f64,
    /// Scale factor asymmetry of a gyro [1], 1e-9 to 1.
    pub gyro_asymmetry: f64,
    /// Scale factor asymmetry of an accelerometer [1], 1e-9 to 1.
    pub accel_asymmetry: f64,
    /// Change of the bias of a gyro with temperature [(rad/s)/K], 1e-15 to 1.
    pub gyro_bias_temperature: f64,
    /// Change of the bias of an accelerometer with temperature [(m/s²)/K], 1e-12 to 10.
    pub accel_bias_temperature: f64,
}

/// Change of the temperature by which a bias changes as much as from turn-on to turn-on [K].
const BIAS_KELVINS: f64 = 20.0;

/// The widest: uncalibrated micromechanics with a margin, as of an unknown record.
impl Default for Prior {
    fn default() -> Self {
        Self {
            gyro_bias: 10.0 * DEG,
            gyro_scale_factor: 0.03,
            gyro_misalignment: 0.02,
            accel_bias: 0.1 * G,
            accel_scale_factor: 0.03,
            accel_misalignment: 0.02,
            mounting: 0.2,
            lever_arm_m: 3.0,
            g_sensitivity: 0.1 * DEG / G,
            gyro_asymmetry: 0.03,
            accel_asymmetry: 0.03,
            gyro_bias_temperature: 10.0 * DEG / BIAS_KELVINS,
            accel_bias_temperature: 0.1 * G / BIAS_KELVINS,
        }
    }
}

impl Prior {
    /// Standard deviations of a grade, from turn-on to turn-on and from unit to unit. They are rather wide: a prior that is too narrow
    /// moves the estimates, one that is too wide does not.
    pub fn of(grade: Grade) -> Self {
        let [gyro_bias, gyro_ppm, gyro_arcsec, accel_bias, accel_ppm, accel_arcsec, deg_h_per_g] = match grade
        {
            Grade::Strategic => [0.01 * DEG_PER_HOUR, 50.0, 10.0, 1e-5 * G, 50.0, 10.0, 0.1],
            Grade::Navigation | Grade::PaperSimulation2 => {
                [0.1 * DEG_PER_HOUR, 50.0, 20.0, 2e-4 * G, 300.0, 20.0, 1.0]
            }
            Grade::Tactical => [20.0 * DEG_PER_HOUR, 500.0, 200.0, 5e-3 * G, 1000.0, 200.0, 20.0],
            Grade::Industrial => [0.5 * DEG, 5000.0, 1000.0, 0.02 * G, 5000.0, 1000.0, 100.0],
            Grade::Consumer => return Self::default(),
        };
        Self {
            gyro_bias,
            gyro_scale_factor: gyro_ppm * PPM,
            gyro_misalignment: gyro_arcsec * ARCSEC,
            accel_bias,
            accel_scale_factor: accel_ppm * PPM,
            accel_misalignment: accel_arcsec * ARCSEC,
            g_sensitivity: deg_h_per_g * DEG_PER_HOUR / G,
            gyro_asymmetry: gyro_ppm * PPM,
            accel_asymmetry: accel_ppm * PPM,
            gyro_bias_temperature: gyro_bias / BIAS_KELVINS,
            accel_bias_temperature: accel_bias / BIAS_KELVINS,
            ..Self::default()
        }
    }

    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        check_range("prior.gyro_bias", self.gyro_bias, 1e-12, 100.0)?;
        check_range("prior.gyro_scale_factor", self.gyro_scale_factor, 1e-9, 1.0)?;
        check_range("prior.gyro_misalignment", self.gyro_misalignment, 1e-9, 1.0)?;
        check_range("prior.accel_bias", self.accel_bias, 1e-9, 1e3)?;
        check_range("prior.accel_scale_factor", self.accel_scale_factor, 1e-9, 1.0)?;
        check_range("prior.accel_misalignment", self.accel_misalignment, 1e-9, 1.0)?;
        check_range("prior.mounting", self.mounting, 1e-9, 1.0)?;
        check_range("prior.lever_arm_m", self.lever_arm_m, 1e-6, 1e3)?;
        check_range("prior.g_sensitivity", self.g_sensitivity, 1e-12, 1.0)?;
        check_range("prior.gyro_asymmetry", self.gyro_asymmetry, 1e-9, 1.0)?;
        check_range("prior.accel_asymmetry", self.accel_asymmetry, 1e-9, 1.0)?;
        check_range("prior.gyro_bias_temperature", self.gyro_bias_temperature, 1e-15, 1.0)?;
        check_range("prior.accel_bias_temperature", self.accel_bias_temperature, 1e-12, 10.0)
    }
}
