//! `sins_gyro_params`.

use nalgebra::{Matrix3, Vector3};

use super::failure::{Failure, SINS_OK, sins_status};
use super::memory::{Output, interface_struct, read};
use super::options::check_reserved;
use super::simulator::{sins_sim, with_simulator};
use crate::sensors::TriadParameters;

/// Errors of the gyros; each array is x, y, z of the sensor axes (sins_options.axes). All zero is an ideal triad.
/// Biases, standard deviations, random walks, ramps, flicker, dead zones and temperature biases up to 100 in their units.
/// Densities do not depend on the sample rate.
///
/// Effects act along the path of the signal: bandwidth; then scale factor, misalignment, asymmetry and nonlinearity, of the
/// signal so far, g-sensitivity, of the true specific force, and temperature; then biases and noise are added; then dead zone,
/// range, quantization. A range, a bandwidth or a quantization of 0 is none.
///
/// Asymmetry, nonlinearity, dead zone and range, and the accelerometers' vibration rectification, act on the mean signal of a
/// sub-increment of the length dt = interval / (updates_per_sample * subsamples). With x = pi f dt, a vibration of frequency f loses by
/// that 1 - (sin x / x)^2 of its mean square (nonlinearity, rectification) and, where it changes sign, up to 1 - cos x of its mean size
/// (asymmetry): at a tenth of the sample rate 0.8 % and 1.2 % with two sub-increments an interval, 3.3 % and 4.9 % with one.
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
    /// Rate random walk K, from 0 at the start of a run [(rad/s)/sqrt(s)].
    pub rate_random_walk_rad_s_sqrt_s: [f64; 3],
    /// Rate ramp R, from 0 when it is set [rad/s2].
    pub rate_ramp_rad_s2: [f64; 3],
    /// Flicker noise, bias instability B [rad/s], stationary from the first sample on: the Allan
    /// deviation is flat at 0.664 B from 2 s to 50 h.
    pub flicker_rad_s: [f64; 3],
    /// Pulse of the angle increments, 1e-15 to 1 [rad]; the rest is carried. The quantization noise Q is pulse/sqrt(12).
    pub quantization_rad: [f64; 3],
    /// Scale factor error, -1 to 1.
    pub scale_factor: [f64; 3],
    /// Scale factor error of positive less that of negative rates, -1 to 1.
    pub scale_factor_asymmetry: [f64; 3],
    /// Scale factor error that grows with the size of the rate, -1 to 1 [s/rad].
    pub scale_factor_nonlinearity_s_rad: [f64; 3],
    /// Misalignment, -1 to 1 [rad]: row-major, row = sensor, column = axis it should not feel; the diagonal is 0.
    pub misalignment_rad: [f64; 9],
    /// g-sensitivity, -1 to 1 [(rad/s)/(m/s2)]: row-major, row = gyro, column = axis of the specific force.
    pub g_sensitivity_rad_s_per_m_s2: [f64; 9],
    /// Range, where the rate saturates, 1e-9 to 1e6 [rad/s]; flagged in sins_imu.
    pub range_rad_s: [f64; 3],
    /// Bandwidth, -3 dB of a second-order Butterworth filter, 1e-3 to 1e6 [Hz]; settled at the first interval.
    pub bandwidth_hz: [f64; 3],
    /// Half the dead zone: rates up to this size give 0 [rad/s].
    pub dead_zone_rad_s: [f64; 3],
    /// Temperature at which the next four terms are 0, -273.15 to 1000 [deg C]; T below is sins_flight_sample.temperature_c less
    /// this. Where one of the four is not 0, every sample needs a temperature, and sins_push_imu() is not available.
    pub reference_temperature_c: f64,
    /// Bias of this times T [(rad/s)/K].
    pub bias_temperature_rad_s_per_k: [f64; 3],
    /// Bias of this times T2 [(rad/s)/K2].
    pub bias_temperature2_rad_s_per_k2: [f64; 3],
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

interface_struct!(sins_gyro_params, "gyro", 512);

impl sins_gyro_params {
    pub(super) fn to_parameters(self) -> Result<TriadParameters, Failure> {
        check_reserved("gyro.reserved", self.reserved)?;
        Ok(TriadParameters {
            bias: Vector3::from(self.bias_rad_s),
            bias_sigma: Vector3::from(self.bias_sigma_rad_s),
            markov_sigma: Vector3::from(self.markov_sigma_rad_s),
            markov_time_s: Vector3::from(self.markov_time_s),
            random_walk: Vector3::from(self.random_walk_rad_sqrt_s),
            rate_random_walk: Vector3::from(self.rate_random_walk_rad_s_sqrt_s),
            ramp: Vector3::from(self.rate_ramp_rad_s2),
            flicker: Vector3::from(self.flicker_rad_s),
            quantization: Vector3::from(self.quantization_rad),
            scale_factor: Vector3::from(self.scale_factor),
            scale_factor_asymmetry: Vector3::from(self.scale_factor_asymmetry),
            scale_factor_nonlinearity: Vector3::from(self.scale_factor_nonlinearity_s_rad),
            misalignment: Matrix3::from_row_slice(&self.misalignment_rad),
            g_sensitivity: Matrix3::from_row_slice(&self.g_sensitivity_rad_s_per_m_s2),
            range: Vector3::from(self.range_rad_s),
            bandwidth_hz: Vector3::from(self.bandwidth_hz),
            dead_zone: Vector3::from(self.dead_zone_rad_s),
            reference_temperature_c: self.reference_temperature_c,
            bias_temperature: Vector3::from(self.bias_temperature_rad_s_per_k),
            bias_temperature2: Vector3::from(self.bias_temperature2_rad_s_per_k2),
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
            bias_rad_s: parameters.bias.into(),
            bias_sigma_rad_s: parameters.bias_sigma.into(),
            markov_sigma_rad_s: parameters.markov_sigma.into(),
            markov_time_s: parameters.markov_time_s.into(),
            random_walk_rad_sqrt_s: parameters.random_walk.into(),
            rate_random_walk_rad_s_sqrt_s: parameters.rate_random_walk.into(),
            rate_ramp_rad_s2: parameters.ramp.into(),
            flicker_rad_s: parameters.flicker.into(),
            quantization_rad: parameters.quantization.into(),
            scale_factor: parameters.scale_factor.into(),
            scale_factor_asymmetry: parameters.scale_factor_asymmetry.into(),
            scale_factor_nonlinearity_s_rad: parameters.scale_factor_nonlinearity.into(),
            misalignment_rad: row_major(&parameters.misalignment),
            g_sensitivity_rad_s_per_m_s2: row_major(&parameters.g_sensitivity),
            range_rad_s: parameters.range.into(),
            bandwidth_hz: parameters.bandwidth_hz.into(),
            dead_zone_rad_s: parameters.dead_zone.into(),
            reference_temperature_c: parameters.reference_temperature_c,
            bias_temperature_rad_s_per_k: parameters.bias_temperature.into(),
            bias_temperature2_rad_s_per_k2: parameters.bias_temperature2.into(),
            scale_factor_temperature_per_k: parameters.scale_factor_temperature.into(),
            scale_factor_temperature2_per_k2: parameters.scale_factor_temperature2.into(),
            scale_factor_sigma: parameters.scale_factor_sigma.into(),
            misalignment_sigma_rad: row_major(&parameters.misalignment_sigma),
        }
    }
}

/// A matrix as the interface has it.
pub(super) fn row_major(matrix: &Matrix3<f64>) -> [f64; 9] {
    core::array::from_fn(|index| matrix[(index / 3, index % 3)])
}

/// Sets the gyro errors: before the first sample or in flight, from the next interval on. The draws of other effects do not
/// move; processes that were active go on from where they are.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: temperature coefficients while samples without
/// a temperature wait, or while navigating on increments.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_set_gyro(sim: *mut sins_sim, params: *const sins_gyro_params) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let params = unsafe { read(params, "params")? };
        simulator.set_gyro(&params.to_parameters()?)?;
        Ok(SINS_OK)
    })
}

/// Reads the gyro errors, as they were set last: at any moment, after sins_snapshot_load() too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_gyro(sim: *mut sins_sim, params: *mut sins_gyro_params) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(params, "params")? };
        output.write(&sins_gyro_params::from_parameters(simulator.gyro()));
        Ok(SINS_OK)
    })
}
