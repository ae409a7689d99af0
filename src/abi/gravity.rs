//! `sins_gravity_params`.

use super::choice::check_reserved;
use super::failure::{Failure, sins_status};
use super::memory::interface_struct;
use super::parameters::Parameters;
use super::settings::{get, set};
use super::simulator::sins_sim;
use crate::sensors::{GravityDisturbanceParameters, GravityField};
use crate::simulator::Simulator;

/// Gravity disturbance: true gravity less the normal gravity that the INS computes, at the same point. The horizontal part is
/// the deflection of the vertical. The vertical part is called anomaly here. Each has a constant part and a random part. The
/// random part is a first-order Gauss-Markov field along the track: correlation sigma^2 exp(-d/D) over the distance d flown
/// over ground. At rest it does not change. All zero is normal gravity.
///
/// Perfect accelerometers measure the disturbance, so it is in the ideal signals of sins_imu. In the INS it acts like an
/// accelerometer error. At rest, without a levelled start, a deflection xi makes the position error oscillate between 0 and 2
/// R xi, where R is the Earth's radius. A levelled start (SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS) is tilted by the deflection.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_gravity_params {
    /// sizeof(sins_gravity_params)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Deflection in the meridian (xi): astronomic less geodetic latitude, -0.01 to 0.01 [rad]. If positive, the true
    /// zenith lies north of the ellipsoid's normal, and the accelerometers at rest measure g times this to the north.
    pub deflection_north_rad: f64,
    /// Standard deviation of the random part of the deflection in the meridian, 0 to 0.01 [rad].
    pub deflection_north_sigma_rad: f64,
    /// Correlation distance D of that random part, 1 to 1e9 [m]; needed where its standard deviation is not 0.
    pub deflection_north_distance_m: f64,
    /// Deflection in the prime vertical (eta): astronomic less geodetic longitude, times the cosine of latitude, -0.01 to
    /// 0.01 [rad]. If positive, the true zenith lies east of the ellipsoid's normal.
    pub deflection_east_rad: f64,
    /// Standard deviation of the random part of the deflection in the prime vertical, 0 to 0.01 [rad].
    pub deflection_east_sigma_rad: f64,
    /// Correlation distance of that random part, 1 to 1e9 [m]; needed where its standard deviation is not 0.
    pub deflection_east_distance_m: f64,
    /// Anomaly, excess of gravity, -0.1 to 0.1 [m/s2]. A milligal is 1e-5 m/s2.
    pub anomaly_m_s2: f64,
    /// Standard deviation of the random part of the anomaly, 0 to 0.1 [m/s2].
    pub anomaly_sigma_m_s2: f64,
    /// Correlation distance of that random part, 1 to 1e9 [m]; needed where its standard deviation is not 0.
    pub anomaly_distance_m: f64,
}

interface_struct!(sins_gravity_params, "gravity", 80);

/// Sets the gravity disturbance, true gravity less normal gravity. Allowed before the first step, and after a reset or a
/// reposition until the next step. A reset brings the same field back; after a reposition the field continues from its
/// current values. The disturbance does not affect a navigator on increments, because the host's increments already contain
/// its effect.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: steps have been made.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_gravity_disturbance(
    sim: *mut sins_sim,
    params: *const sins_gravity_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, params, "params", Simulator::set_gravity_disturbance) }
}

impl Parameters for sins_gravity_params {
    type Own = GravityDisturbanceParameters;

    fn from_parameters(parameters: &GravityDisturbanceParameters) -> Self {
        let GravityDisturbanceParameters { deflection_north, deflection_east, anomaly } = parameters;
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            deflection_north_rad: deflection_north.mean,
            deflection_north_sigma_rad: deflection_north.sigma,
            deflection_north_distance_m: deflection_north.distance_m,
            deflection_east_rad: deflection_east.mean,
            deflection_east_sigma_rad: deflection_east.sigma,
            deflection_east_distance_m: deflection_east.distance_m,
            anomaly_m_s2: anomaly.mean,
            anomaly_sigma_m_s2: anomaly.sigma,
            anomaly_distance_m: anomaly.distance_m,
        }
    }

    fn to_parameters(self) -> Result<GravityDisturbanceParameters, Failure> {
        check_reserved("gravity.reserved", self.reserved)?;
        let field = |mean, sigma, distance_m| GravityField { mean, sigma, distance_m };
        Ok(GravityDisturbanceParameters {
            deflection_north: field(
                self.deflection_north_rad,
                self.deflection_north_sigma_rad,
                self.deflection_north_distance_m,
            ),
            deflection_east: field(
                self.deflection_east_rad,
                self.deflection_east_sigma_rad,
                self.deflection_east_distance_m,
            ),
            anomaly: field(self.anomaly_m_s2, self.anomaly_sigma_m_s2, self.anomaly_distance_m),
        })
    }
}

/// Reads the parameters of the gravity disturbance that are set. May be called at any moment. After sins_snapshot_load() they
/// are those of the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_gravity_disturbance(
    sim: *mut sins_sim,
    params: *mut sins_gravity_params,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, params, "params", Simulator::gravity_disturbance) }
}
