//! `sins_initial_errors`.

use nalgebra::Vector3;

use super::choice::{Choice, check_reserved, choices};
use super::failure::{Failure, SINS_OK, sins_status};
use super::memory::{Output, interface_struct, read};
use super::simulator::{sins_sim, with_simulator};
use crate::sensors::{Alignment, InitialErrorParameters};

/// How the INS finds its attitude at the start.
pub type sins_alignment = i32;

/// The INS starts with the true attitude, turned by the given and the drawn misalignment.
pub const SINS_ALIGNMENT_GIVEN: sins_alignment = 0;
/// The INS starts with the attitude that levelling and gyrocompassing at rest find with the sensor errors of the start,
/// turned by the given and the drawn misalignment. Level first: the tilt at which the accelerometers sense no horizontal
/// force. Then the heading at which the levelled rate of the gyros points north. SINS_NAVIGATION_NORTH_UNKNOWN is set if
/// north could not be found.
pub const SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS: sins_alignment = 1;

/// Errors with which the navigation starts: computed less true, east-north-up. The sigmas are drawn once a run and added.
/// Where the vertical channel follows the truth, its errors start at 0. Positions up to 1e6 m, velocities up to 1e4 m/s, their
/// standard deviations up to 1e5 m and 1e3 m/s.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_initial_errors {
    /// sizeof(sins_initial_errors)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Position error [m].
    pub position_enu_m: [f64; 3],
    /// Velocity error [m/s].
    pub velocity_enu_m_s: [f64; 3],
    /// Misalignment phi, a rotation vector [rad], each -pi to pi: computed C = exp(-[phi x]) C, C from sensor axes to
    /// east-north-up, the true one or with SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS the one that the alignment finds.
    pub misalignment_enu_rad: [f64; 3],
    /// Standard deviation of position [m].
    pub position_sigma_enu_m: [f64; 3],
    /// Standard deviation of velocity [m/s].
    pub velocity_sigma_enu_m_s: [f64; 3],
    /// Standard deviation of misalignment, 0 to 1 [rad].
    pub misalignment_sigma_enu_rad: [f64; 3],
    /// Alignment at the start, of enum sins_alignment.
    pub alignment: i32,
    /// Must be 0.
    pub reserved2: u32,
}

interface_struct!(sins_initial_errors, "initial", 160);

choices!(sins_alignment: Alignment {
    Given = SINS_ALIGNMENT_GIVEN,
    LevelAndGyrocompass = SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS,
});

impl sins_initial_errors {
    /// The struct with `parameters`.
    pub(super) fn from_parameters(parameters: &InitialErrorParameters) -> Self {
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
        }
    }

    pub(super) fn to_parameters(self) -> Result<InitialErrorParameters, Failure> {
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
        })
    }
}

/// Sets the errors with which the navigation starts: before the first step, after a reset or after a reposition.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: steps have been made.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_set_initial_errors(
    sim: *mut sins_sim,
    errors: *const sins_initial_errors,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let errors = unsafe { read(errors, "errors")? };
        simulator.set_initial_errors(&errors.to_parameters()?)?;
        Ok(SINS_OK)
    })
}

/// Reads the errors with which the navigation starts, as they were set last: at any moment, also after
/// sins_snapshot_load().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_initial_errors(
    sim: *mut sins_sim,
    errors: *mut sins_initial_errors,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(errors, "errors")? };
        output.write(&sins_initial_errors::from_parameters(simulator.initial_errors()));
        Ok(SINS_OK)
    })
}
