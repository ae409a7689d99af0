//! `sins_accel_params`.

use nalgebra::{Matrix3, Vector3};

use super::failure::{Failure, SINS_OK, sins_status};
use super::gyro::row_major;
use super::memory::{Output, interface_struct, read};
use super::options::check_reserved;
use super::simulator::{sins_sim, with_simulator};
use crate::sensors::TriadParameters;

/// Errors of the accelerometers; each array is x, y, z of the sensor axes (sins_options.axes). All zero is an ideal triad.
/// Biases, standard deviations, random walks, ramps, flicker, dead zones and temperature biases up to 1e4 in their units.
/// Densities do not depend on the sample rate.
///
/// Effects act along the path of the signal: size effect, bandwidth; then scale factor, misalignment, asymmetry,
/// nonlinearity, vibration rectification, of the signal so far, and temperature; then biases and noise are added; then dead
/// zone, range, quantization. A range, a bandwidth or a quantization of 0 is none. What acts on the mean of a sub-increment:
/// see sins_gyro_params.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_accel_params {
    /// sizeof(sins_accel_params)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Constant bias [m/s2], measured less true; up to 10000 m/s2.
    pub bias_m_s2: [f64; 3],
    /// Standard deviation of the turn-on bias, drawn once a run [m/s2].
    pub bias_sigma_m_s2: [f64; 3],
    /// Standard deviation of the first-order Gauss-Markov bias, stationary from the first sample on [m/s2].
    pub markov_sigma_m_s2: [f64; 3],
    /// Its correlation time, 1e-9 to 1e15 [s]; needed where markov_sigma_m_s2 is not 0.
    pub markov_time_s: [f64; 3],
    /// Velocity random walk N, white noise of force [(m/s)/sqrt(s)] = [(m/s2)/sqrt(Hz)].
    pub velocity_random_walk_m_s_sqrt_s: [f64; 3],
    /// Acceleration random walk K, from 0 at the start of a run [(m/s2)/sqrt(s)].
    pub acceleration_random_walk_m_s2_sqrt_s: [f64; 3],
    /// Ramp R, from 0 when it is set [m/s3].
    pub ramp_m_s3: [f64; 3],
    /// Flicker noise, bias instability B [m/s2], stationary from the first sample on: the Allan
    /// deviation is flat at 0.664 B from 2 s to 50 h.
    pub flicker_m_s2: [f64; 3],
    /// Pulse of the velocity increments, 1e-15 to 1 [m/s]; the rest is carried. The quantization noise Q is pulse/sqrt(12).
    pub quantization_m_s: [f64; 3],
    /// Scale factor error, -1 to 1.
    pub scale_factor: [f64; 3],
    /// Scale factor error of positive less that of negative forces, -1 to 1.
    pub scale_factor_asymmetry: [f64; 3],
    /// Scale factor error that grows with the size of the force, -1 to 1 [s2/m].
    pub scale_factor_nonlinearity_s2_m: [f64; 3],
    /// Misalignment, -1 to 1 [rad]: row-major, row = sensor, column = axis it should not feel; the diagonal is 0.
    pub misalignment_rad: [f64; 9],
    /// Range, where the force saturates, 1e-9 to 1e6 [m/s2]; flagged in sins_imu.
    pub range_m_s2: [f64; 3],
    /// Bandwidth, -3 dB of a second-order Butterworth filter, 1e-3 to 1e6 [Hz]; settled at the first interval.
    pub bandwidth_hz: [f64; 3],
    /// Half the dead zone: forces up to this size give 0 [m/s2].
    pub dead_zone_m_s2: [f64; 3],
    /// Place of each sensor against the point that the block's lever arm leads to, sensor axes, -100 to 100 [m]: row-major,
    /// row = sensor (size effect). At the start of a flight in motion see sins_mounting; the velocity lacks the change of rate in the
    /// first interval for good. With sins_push_imu() the angular acceleration follows from the increments before.
    pub lever_arm_m: [f64; 9],
    /// Vibration rectification, the g2 term, -1 to 1 [s2/m]: a vibration of RMS r makes a bias of this times r2.
    pub vibration_rectification_s2_m: [f64; 3],
    /// Temperature at which the next four terms are 0, -273.15 to 1000 [deg C]; T below is sins_flight_sample.temperature_c less
    /// this. Where one of the four is not 0, every sample needs a temperature, and sins_push_imu() is not available.
    pub reference_temperature_c: f64,
    /// Bias of this times T [(m/s2)/K].
    pub bias_temperature_m_s2_per_k: [f64; 3],
    /// Bias of this times T2 [(m/s2)/K2].
    pub bias_temperature2_m_s2_per_k2: [f64; 3],
    /// Scale factor error of this times T, -1 to 1 [1/K].
    pub scale_factor_temperature_per_k: [f64; 3],
    /// Scale factor error of this times T2, -1 to 1 [1/K2].
    pub scale_factor_temperature2_per_k2: [f64; 3],
    /// Standard deviation of the scale factor error, drawn once a run and added to scale_factor, 0 to 1.
    pub scale_factor_sigma: [f64; 3],
    /// Standard deviation of each misalignment, drawn once a run and added to misalignment_rad, 0 to 1 [rad]: row-major, the
    /// diagonal is 0.
    pub misalignment_sigma_rad: [f64; 9],
}

interface_struct!(sins_accel_params, "accel", 536);

impl sins_accel_params {
    pub(super) fn to_parameters(self) -> Result<TriadParameters, Failure> {
        check_reserved("accel.reserved", self.reserved)?;
        Ok(TriadParameters {
            bias: Vector3::from(self.bias_m_s2),
            bias_sigma: Vector3::from(self.bias_sigma_m_s2),
            markov_sigma: Vector3::from(self.markov_sigma_m_s2),
            markov_time_s: Vector3::from(self.markov_time_s),
            random_walk: Vector3::from(self.velocity_random_walk_m_s_sqrt_s),
            rate_random_walk: Vector3::from(self.acceleration_random_walk_m_s2_sqrt_s),
            ramp: Vector3::from(self.ramp_m_s3),
            flicker: Vector3::from(self.flicker_m_s2),
            quantization: Vector3::from(self.quantization_m_s),
            scale_factor: Vector3::from(self.scale_factor),
            scale_factor_asymmetry: Vector3::from(self.scale_factor_asymmetry),
            scale_factor_nonlinearity: Vector3::from(self.scale_factor_nonlinearity_s2_m),
            misalignment: Matrix3::from_row_slice(&self.misalignment_rad),
            range: Vector3::from(self.range_m_s2),
            bandwidth_hz: Vector3::from(self.bandwidth_hz),
            dead_zone: Vector3::from(self.dead_zone_m_s2),
            lever_arm_m: Matrix3::from_row_slice(&self.lever_arm_m),
            vibration_rectification_s2_m: Vector3::from(self.vibration_rectification_s2_m),
            reference_temperature_c: self.reference_temperature_c,
            bias_temperature: Vector3::from(self.bias_temperature_m_s2_per_k),
            bias_temperature2: Vector3::from(self.bias_temperature2_m_s2_per_k2),
            scale_factor_temperature: Vector3::from(self.scale_factor_temperature_per_k),
            scale_factor_temperature2: Vector3::from(self.scale_factor_temperature2_per_k2),
            scale_factor_sigma: Vector3::from(self.scale_factor_sigma),
            misalignment_sigma: Matrix3::from_row_slice(&self.misalignment_sigma_rad),
            ..Default::default()
        })
    }

    /// The struct with `parameters`.
    pub(super) fn from_parameters(parameters: &TriadParameters) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            bias_m_s2: parameters.bias.into(),
            bias_sigma_m_s2: parameters.bias_sigma.into(),
            markov_sigma_m_s2: parameters.markov_sigma.into(),
            markov_time_s: parameters.markov_time_s.into(),
            velocity_random_walk_m_s_sqrt_s: parameters.random_walk.into(),
            acceleration_random_walk_m_s2_sqrt_s: parameters.rate_random_walk.into(),
            ramp_m_s3: parameters.ramp.into(),
            flicker_m_s2: parameters.flicker.into(),
            quantization_m_s: parameters.quantization.into(),
            scale_factor: parameters.scale_factor.into(),
            scale_factor_asymmetry: parameters.scale_factor_asymmetry.into(),
            scale_factor_nonlinearity_s2_m: parameters.scale_factor_nonlinearity.into(),
            misalignment_rad: row_major(&parameters.misalignment),
            range_m_s2: parameters.range.into(),
            bandwidth_hz: parameters.bandwidth_hz.into(),
            dead_zone_m_s2: parameters.dead_zone.into(),
            lever_arm_m: row_major(&parameters.lever_arm_m),
            vibration_rectification_s2_m: parameters.vibration_rectification_s2_m.into(),
            reference_temperature_c: parameters.reference_temperature_c,
            bias_temperature_m_s2_per_k: parameters.bias_temperature.into(),
            bias_temperature2_m_s2_per_k2: parameters.bias_temperature2.into(),
            scale_factor_temperature_per_k: parameters.scale_factor_temperature.into(),
            scale_factor_temperature2_per_k2: parameters.scale_factor_temperature2.into(),
            scale_factor_sigma: parameters.scale_factor_sigma.into(),
            misalignment_sigma_rad: row_major(&parameters.misalignment_sigma),
        }
    }
}

/// Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The draws of other
/// effects do not move; processes that were active go on from where they are.
///
/// SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_set_gyro().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_set_accel(sim: *mut sins_sim, params: *const sins_accel_params) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let params = unsafe { read(params, "params")? };
        simulator.set_accel(&params.to_parameters()?)?;
        Ok(SINS_OK)
    })
}

/// Reads the accelerometer errors, as they were set last: at any moment, after sins_snapshot_load() too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_accel(sim: *mut sins_sim, params: *mut sins_accel_params) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(params, "params")? };
        output.write(&sins_accel_params::from_parameters(simulator.accel()));
        Ok(SINS_OK)
    })
}
