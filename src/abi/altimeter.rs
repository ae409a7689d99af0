//! `sins_altimeter_params`.

use super::choice::check_reserved;
use super::failure::{Failure, sins_status};
use super::memory::interface_struct;
use super::parameters::Parameters;
use super::settings::{get, set};
use super::simulator::sins_sim;
use crate::sensors::AltimeterParameters;
use crate::simulator::Simulator;

/// Errors of the barometric altimeter, whose height damps the vertical channel. All zero is an ideal altimeter.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_altimeter_params {
    /// sizeof(sins_altimeter_params)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Constant bias, -1e5 to 1e5 [m].
    pub bias_m: f64,
    /// Standard deviation of the first-order Gauss-Markov error, stationary from the first sample on, 0 to 1e5 [m].
    pub markov_sigma_m: f64,
    /// Correlation time of the Gauss-Markov error, 1e-9 to 1e15 [s]; needed where markov_sigma_m is not 0.
    pub markov_time_s: f64,
    /// Standard deviation of the independent error of each sample, 0 to 1e5 [m].
    pub noise_m: f64,
    /// Scale factor error of the height [1], -1 to 1.
    pub scale_factor: f64,
    /// Time constant of the first-order lag of the static pressure, 0 to 1e6 [s].
    pub lag_s: f64,
}

interface_struct!(sins_altimeter_params, "altimeter", 56);

impl Parameters for sins_altimeter_params {
    type Own = AltimeterParameters;

    fn from_parameters(parameters: &AltimeterParameters) -> Self {
        let AltimeterParameters { bias_m, markov_sigma_m, markov_time_s, noise_m, scale_factor, lag_s } =
            *parameters;
        let struct_size = size_of::<Self>() as u32;
        Self { struct_size, reserved: 0, bias_m, markov_sigma_m, markov_time_s, noise_m, scale_factor, lag_s }
    }

    fn to_parameters(self) -> Result<AltimeterParameters, Failure> {
        check_reserved("altimeter.reserved", self.reserved)?;
        Ok(AltimeterParameters {
            bias_m: self.bias_m,
            markov_sigma_m: self.markov_sigma_m,
            markov_time_s: self.markov_time_s,
            noise_m: self.noise_m,
            scale_factor: self.scale_factor,
            lag_s: self.lag_s,
        })
    }
}

/// Sets the errors of the barometric altimeter, whose height damps the vertical channel (SINS_VERTICAL_DAMPED), from the next
/// interval on.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_altimeter(
    sim: *mut sins_sim,
    params: *const sins_altimeter_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, params, "params", Simulator::set_altimeter) }
}

/// Reads the errors of the altimeter that are set. May be called at any moment. After sins_snapshot_load() they are those of
/// the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_altimeter(
    sim: *mut sins_sim,
    params: *mut sins_altimeter_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, params, "params", Simulator::altimeter) }
}
