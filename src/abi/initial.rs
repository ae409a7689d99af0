//! `sins_initial_errors`.

use nalgebra::Vector3;

use super::choice::{Choice, check_reserved, choices};
use super::failure::{Failure, sins_status};
use super::memory::interface_struct;
use super::parameters::Parameters;
use super::settings::{get, set};
use super::simulator::sins_sim;
use crate::sensors::{Alignment, InitialErrorParameters};
use crate::simulator::Simulator;

/// How the INS finds its attitude at the start.
pub type sins_alignment = i32;

/// The INS starts with the true attitude, turned by the given and the drawn misalignment.
pub const SINS_ALIGNMENT_GIVEN: sins_alignment = 0;
/// The library computes the attitude that levelling and gyrocompassing at rest would find with the sensor errors at the
/// start. It does so even if the flight starts in motion. The INS starts with this attitude, turned by the given and the
/// drawn misalignment. Levelling comes first: it finds the tilt at which the accelerometers sense the reaction to normal gravity. At
/// height this is not quite along the ellipsoid's normal: its horizontal part is 7.5 micro-g at 9 km and 45 degrees.
/// Gyrocompassing then finds the heading at which the horizontal gyro rates point north. SINS_NAVIGATION_NORTH_UNKNOWN is set
/// if the sensor errors hide north. Within 64 km of a pole the start returns SINS_ERROR_SINGULAR.
pub const SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS: sins_alignment = 1;
/// The library computes the attitude that levelling at rest would find with the sensor errors at the start, with the true heading:
/// the heading of a unit whose gyros cannot find north comes from another sensor. The INS starts with this attitude, turned by the
/// given and the drawn misalignment, whose part about up is the heading error. Any latitude.
pub const SINS_ALIGNMENT_LEVEL: sins_alignment = 2;

/// Errors with which the navigation starts: computed less true, east-north-up. Random errors with the standard deviations
/// (sigma) are drawn once a run and added. A reset and a reposition use the same random numbers again. With
/// SINS_VERTICAL_FOLLOW_TRUTH the errors of height and vertical velocity start at 0. Limits: position errors 1e6 m, velocity
/// errors 1e4 m/s, their standard deviations 1e5 m and 1e3 m/s.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_initial_errors {
    /// sizeof(sins_initial_errors)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Position error [m]. The horizontal part is laid off at the height of the solution, and sins_errors measures it at the height of
    /// the truth: with an error of 100 m in height, 3 km read back 0.046 m larger.
    pub position_enu_m: [f64; 3],
    /// Velocity error [m/s].
    pub velocity_enu_m_s: [f64; 3],
    /// Misalignment phi, a rotation vector [rad], each -pi to pi: computed C = exp(-[phi x]) C0. C turns vectors from sensor
    /// axes to east-north-up. C0 is the true C. With SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS or SINS_ALIGNMENT_LEVEL, C0 is the
    /// C that the alignment finds.
    pub misalignment_enu_rad: [f64; 3],
    /// Standard deviation of the position error [m].
    pub position_sigma_enu_m: [f64; 3],
    /// Standard deviation of the velocity error [m/s].
    pub velocity_sigma_enu_m_s: [f64; 3],
    /// Standard deviation of the misalignment, 0 to 1 [rad].
    pub misalignment_sigma_enu_rad: [f64; 3],
    /// Alignment at the start, of enum sins_alignment.
    pub alignment: i32,
    /// Must be 0.
    pub reserved2: u32,
    /// Length of the alignment before the first sample, 1 to 86400 [s]; 0: without end. The vehicle rests during the
    /// alignment. Tilt is found from the mean specific force, heading from the mean rate: white noise and quantization are
    /// averaged over this time, and Gauss-Markov, flicker, random walk and ramp errors have their mean of this time. Dead
    /// zone and range act on the mean. The temperature is that of the first sample. The flight begins with the states with
    /// which the alignment ended: ramps and random walks begin at 0 when the alignment begins. An alignment without end
    /// leaves out white noise and quantization, and takes the errors at the first sample for their mean. A reposition
    /// aligns again, from the present states of the sensors. SINS_ALIGNMENT_GIVEN does not use it.
    pub alignment_s: f64,
}

interface_struct!(sins_initial_errors, "initial", 168);

choices!(sins_alignment: Alignment {
    Given = SINS_ALIGNMENT_GIVEN,
    LevelAndGyrocompass = SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS,
    Level = SINS_ALIGNMENT_LEVEL,
});

impl Parameters for sins_initial_errors {
    type Own = InitialErrorParameters;

    fn from_parameters(parameters: &InitialErrorParameters) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            position_enu_m: parameters.position_n.into(),
            velocity_enu_m_s: parameters.velocity_n.into(),
            misalignment_enu_rad: parameters.misalignment_n.into(),
            position_sigma_enu_m: parameters.position_sigma_n.into(),
            velocity_sigma_enu_m_s: parameters.velocity_sigma_n.into(),
            misalignment_sigma_enu_rad: parameters.misalignment_sigma_n.into(),
            alignment: parameters.alignment.code(),
            reserved2: 0,
            alignment_s: parameters.alignment_s,
        }
    }

    fn to_parameters(self) -> Result<InitialErrorParameters, Failure> {
        check_reserved("initial.reserved", self.reserved)?;
        check_reserved("initial.reserved2", self.reserved2)?;
        let alignment = Alignment::of("initial.alignment", self.alignment)?;
        Ok(InitialErrorParameters {
            position_n: Vector3::from(self.position_enu_m),
            velocity_n: Vector3::from(self.velocity_enu_m_s),
            misalignment_n: Vector3::from(self.misalignment_enu_rad),
            position_sigma_n: Vector3::from(self.position_sigma_enu_m),
            velocity_sigma_n: Vector3::from(self.velocity_sigma_enu_m_s),
            misalignment_sigma_n: Vector3::from(self.misalignment_sigma_enu_rad),
            alignment,
            alignment_s: self.alignment_s,
        })
    }
}

/// Sets the errors with which the navigation starts. Allowed before the first step, and after a reset or a reposition until
/// the next step. After a reposition they apply to the start at its sample.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: steps have been made.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_initial_errors(
    sim: *mut sins_sim,
    errors: *const sins_initial_errors,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, errors, "errors", Simulator::set_initial_errors) }
}

/// Reads the set errors with which the navigation starts. May be called at any moment. After sins_snapshot_load() they are
/// those of the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_initial_errors(
    sim: *mut sins_sim,
    errors: *mut sins_initial_errors,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, errors, "errors", Simulator::initial_errors) }
}
