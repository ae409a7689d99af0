//! `sins_gyro_params`, `sins_accel_params`, `sins_altimeter_params`.

use nalgebra::{Matrix3, Vector3};

use super::failure::{Failure, sins_status};
use super::memory::{interface_struct, read};
use super::options::{check_reserved, refuse};
use super::simulator::{sins_sim, with_simulator};
use crate::abi::SINS_OK;
use crate::sensors::{AltimeterParameters, TriadParameters};

/// Errors of the gyros; each array is x, y, z of the sensor axes (sins_options.axes). All zero is an ideal triad.
/// Biases, standard deviations and random walks up to 100 in their units. Densities do not depend on the sample rate. Fields marked (later) must be 0 in this release.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_gyro_params {
    /// sizeof(sins_gyro_params)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Constant bias [rad/s], measured less true; up to 100 rad/s.
    pub bias_rad_s: [f64; 3],
    /// Standard deviation of the turn-on bias, drawn once a run [rad/s].
    pub bias_sigma_rad_s: [f64; 3],
    /// Standard deviation of the first-order Gauss-Markov bias, stationary from the first sample on [rad/s].
    pub markov_sigma_rad_s: [f64; 3],
    /// Its correlation time, 1e-9 to 1e15 [s]; needed where markov_sigma_rad_s is not 0.
    pub markov_time_s: [f64; 3],
    /// Angle random walk N, white noise of rate [rad/sqrt(s)] = [(rad/s)/sqrt(Hz)].
    pub random_walk_rad_sqrt_s: [f64; 3],
    /// Rate random walk K [(rad/s)/sqrt(s)] (later).
    pub rate_random_walk_rad_s_sqrt_s: [f64; 3],
    /// Rate ramp R [rad/s2] (later).
    pub rate_ramp_rad_s2: [f64; 3],
    /// Flicker noise, bias instability B [rad/s] (later).
    pub flicker_rad_s: [f64; 3],
    /// Quantization of the angle increments [rad] (later).
    pub quantization_rad: [f64; 3],
    /// Scale factor error, -1 to 1.
    pub scale_factor: [f64; 3],
    /// Scale factor error of positive less that of negative rates (later).
    pub scale_factor_asymmetry: [f64; 3],
    /// Scale factor error that grows with the rate [s/rad] (later).
    pub scale_factor_nonlinearity_s_rad: [f64; 3],
    /// Misalignment, -1 to 1 [rad]: row-major, row = sensor, column = axis it should not feel; the diagonal is 0.
    pub misalignment_rad: [f64; 9],
    /// g-sensitivity [(rad/s)/(m/s2)], row-major (later).
    pub g_sensitivity_rad_s_per_m_s2: [f64; 9],
    /// Range, where the output saturates [rad/s] (later).
    pub range_rad_s: [f64; 3],
    /// Bandwidth [Hz] (later).
    pub bandwidth_hz: [f64; 3],
    /// Dead zone [rad/s] (later).
    pub dead_zone_rad_s: [f64; 3],
}

interface_struct!(sins_gyro_params, "gyro", 512);

/// Errors of the accelerometers; each array is x, y, z of the sensor axes (sins_options.axes). All zero is an ideal triad.
/// Biases, standard deviations and random walks up to 1e4 in their units. Densities do not depend on the sample rate. Fields marked (later) must be 0 in this release.
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
    /// Acceleration random walk K [(m/s2)/sqrt(s)] (later).
    pub acceleration_random_walk_m_s2_sqrt_s: [f64; 3],
    /// Ramp R [m/s3] (later).
    pub ramp_m_s3: [f64; 3],
    /// Flicker noise, bias instability B [m/s2] (later).
    pub flicker_m_s2: [f64; 3],
    /// Quantization of the velocity increments [m/s] (later).
    pub quantization_m_s: [f64; 3],
    /// Scale factor error, -1 to 1.
    pub scale_factor: [f64; 3],
    /// Scale factor error of positive less that of negative forces (later).
    pub scale_factor_asymmetry: [f64; 3],
    /// Scale factor error that grows with the force [s2/m] (later).
    pub scale_factor_nonlinearity_s2_m: [f64; 3],
    /// Misalignment, -1 to 1 [rad]: row-major, row = sensor, column = axis it should not feel; the diagonal is 0.
    pub misalignment_rad: [f64; 9],
    /// Range, where the output saturates [m/s2] (later).
    pub range_m_s2: [f64; 3],
    /// Bandwidth [Hz] (later).
    pub bandwidth_hz: [f64; 3],
    /// Dead zone [m/s2] (later).
    pub dead_zone_m_s2: [f64; 3],
    /// Place of each sensor [m], row = sensor: size effect (later).
    pub lever_arm_m: [f64; 9],
    /// Vibration rectification, the g2 term [s2/m] (later).
    pub vibration_rectification_s2_m: [f64; 3],
}

interface_struct!(sins_accel_params, "accel", 536);

/// Errors of the barometric height that damps the vertical channel. All zero is an ideal altimeter.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_altimeter_params {
    /// sizeof(sins_altimeter_params)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Constant bias, up to 1e5 m [m].
    pub bias_m: f64,
    /// Standard deviation of the first-order Gauss-Markov error, stationary from the first sample on, up to 1e5 m [m].
    pub markov_sigma_m: f64,
    /// Its correlation time, 1e-9 to 1e15 [s]; needed where markov_sigma_m is not 0.
    pub markov_time_s: f64,
    /// Standard deviation of the independent error of each sample, up to 1e5 m [m].
    pub noise_m: f64,
    /// Scale factor error of the height, -1 to 1.
    pub scale_factor: f64,
    /// Time constant of the first-order lag of the static pressure, up to 1e6 s [s].
    pub lag_s: f64,
}

interface_struct!(sins_altimeter_params, "altimeter", 56);

impl sins_gyro_params {
    fn to_parameters(self) -> Result<TriadParameters, Failure> {
        check_reserved("gyro.reserved", self.reserved)?;
        refuse("gyro.rate_random_walk_rad_s_sqrt_s", &self.rate_random_walk_rad_s_sqrt_s)?;
        refuse("gyro.rate_ramp_rad_s2", &self.rate_ramp_rad_s2)?;
        refuse("gyro.flicker_rad_s", &self.flicker_rad_s)?;
        refuse("gyro.quantization_rad", &self.quantization_rad)?;
        refuse("gyro.scale_factor_asymmetry", &self.scale_factor_asymmetry)?;
        refuse("gyro.scale_factor_nonlinearity_s_rad", &self.scale_factor_nonlinearity_s_rad)?;
        refuse("gyro.g_sensitivity_rad_s_per_m_s2", &self.g_sensitivity_rad_s_per_m_s2)?;
        refuse("gyro.range_rad_s", &self.range_rad_s)?;
        refuse("gyro.bandwidth_hz", &self.bandwidth_hz)?;
        refuse("gyro.dead_zone_rad_s", &self.dead_zone_rad_s)?;
        Ok(TriadParameters {
            bias: Vector3::from(self.bias_rad_s),
            bias_sigma: Vector3::from(self.bias_sigma_rad_s),
            markov_sigma: Vector3::from(self.markov_sigma_rad_s),
            markov_time_s: Vector3::from(self.markov_time_s),
            random_walk: Vector3::from(self.random_walk_rad_sqrt_s),
            scale_factor: Vector3::from(self.scale_factor),
            misalignment: Matrix3::from_row_slice(&self.misalignment_rad),
        })
    }

    /// The struct with `parameters`, the rest zero.
    pub(super) fn from_parameters(parameters: &TriadParameters) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            bias_rad_s: parameters.bias.into(),
            bias_sigma_rad_s: parameters.bias_sigma.into(),
            markov_sigma_rad_s: parameters.markov_sigma.into(),
            markov_time_s: parameters.markov_time_s.into(),
            random_walk_rad_sqrt_s: parameters.random_walk.into(),
            rate_random_walk_rad_s_sqrt_s: [0.0; 3],
            rate_ramp_rad_s2: [0.0; 3],
            flicker_rad_s: [0.0; 3],
            quantization_rad: [0.0; 3],
            scale_factor: parameters.scale_factor.into(),
            scale_factor_asymmetry: [0.0; 3],
            scale_factor_nonlinearity_s_rad: [0.0; 3],
            misalignment_rad: row_major(&parameters.misalignment),
            g_sensitivity_rad_s_per_m_s2: [0.0; 9],
            range_rad_s: [0.0; 3],
            bandwidth_hz: [0.0; 3],
            dead_zone_rad_s: [0.0; 3],
        }
    }
}

impl sins_accel_params {
    fn to_parameters(self) -> Result<TriadParameters, Failure> {
        check_reserved("accel.reserved", self.reserved)?;
        refuse("accel.acceleration_random_walk_m_s2_sqrt_s", &self.acceleration_random_walk_m_s2_sqrt_s)?;
        refuse("accel.ramp_m_s3", &self.ramp_m_s3)?;
        refuse("accel.flicker_m_s2", &self.flicker_m_s2)?;
        refuse("accel.quantization_m_s", &self.quantization_m_s)?;
        refuse("accel.scale_factor_asymmetry", &self.scale_factor_asymmetry)?;
        refuse("accel.scale_factor_nonlinearity_s2_m", &self.scale_factor_nonlinearity_s2_m)?;
        refuse("accel.range_m_s2", &self.range_m_s2)?;
        refuse("accel.bandwidth_hz", &self.bandwidth_hz)?;
        refuse("accel.dead_zone_m_s2", &self.dead_zone_m_s2)?;
        refuse("accel.lever_arm_m", &self.lever_arm_m)?;
        refuse("accel.vibration_rectification_s2_m", &self.vibration_rectification_s2_m)?;
        Ok(TriadParameters {
            bias: Vector3::from(self.bias_m_s2),
            bias_sigma: Vector3::from(self.bias_sigma_m_s2),
            markov_sigma: Vector3::from(self.markov_sigma_m_s2),
            markov_time_s: Vector3::from(self.markov_time_s),
            random_walk: Vector3::from(self.velocity_random_walk_m_s_sqrt_s),
            scale_factor: Vector3::from(self.scale_factor),
            misalignment: Matrix3::from_row_slice(&self.misalignment_rad),
        })
    }

    /// The struct with `parameters`, the rest zero.
    pub(super) fn from_parameters(parameters: &TriadParameters) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            bias_m_s2: parameters.bias.into(),
            bias_sigma_m_s2: parameters.bias_sigma.into(),
            markov_sigma_m_s2: parameters.markov_sigma.into(),
            markov_time_s: parameters.markov_time_s.into(),
            velocity_random_walk_m_s_sqrt_s: parameters.random_walk.into(),
            acceleration_random_walk_m_s2_sqrt_s: [0.0; 3],
            ramp_m_s3: [0.0; 3],
            flicker_m_s2: [0.0; 3],
            quantization_m_s: [0.0; 3],
            scale_factor: parameters.scale_factor.into(),
            scale_factor_asymmetry: [0.0; 3],
            scale_factor_nonlinearity_s2_m: [0.0; 3],
            misalignment_rad: row_major(&parameters.misalignment),
            range_m_s2: [0.0; 3],
            bandwidth_hz: [0.0; 3],
            dead_zone_m_s2: [0.0; 3],
            lever_arm_m: [0.0; 9],
            vibration_rectification_s2_m: [0.0; 3],
        }
    }
}

fn row_major(matrix: &Matrix3<f64>) -> [f64; 9] {
    core::array::from_fn(|index| matrix[(index / 3, index % 3)])
}

/// Sets the gyro errors: before the first sample or in flight, from the next interval on. The draws of other effects do not
/// move; processes that were active go on from where they are.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or one of a later release that is not 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_set_gyro(sim: *mut sins_sim, params: *const sins_gyro_params) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let params = unsafe { read(params, "params")? };
        simulator.set_gyro(&params.to_parameters()?)?;
        Ok(SINS_OK)
    })
}

/// Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The draws of other
/// effects do not move; processes that were active go on from where they are.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or one of a later release that is not 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_set_accel(sim: *mut sins_sim, params: *const sins_accel_params) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let params = unsafe { read(params, "params")? };
        simulator.set_accel(&params.to_parameters()?)?;
        Ok(SINS_OK)
    })
}

/// Sets the errors of the barometric height that damps the vertical channel (SINS_VERTICAL_DAMPED), from the next interval
/// on.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_set_altimeter(
    sim: *mut sins_sim,
    params: *const sins_altimeter_params,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let params = unsafe { read(params, "params")? };
        check_reserved("altimeter.reserved", params.reserved)?;
        simulator.set_altimeter(&AltimeterParameters {
            bias_m: params.bias_m,
            markov_sigma_m: params.markov_sigma_m,
            markov_time_s: params.markov_time_s,
            noise_m: params.noise_m,
            scale_factor: params.scale_factor,
            lag_s: params.lag_s,
        })?;
        Ok(SINS_OK)
    })
}
