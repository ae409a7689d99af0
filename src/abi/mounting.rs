//! `sins_mounting`.

use nalgebra::Vector3;

use super::choice::check_reserved;
use super::failure::{Failure, sins_status};
use super::memory::interface_struct;
use super::parameters::Parameters;
use super::settings::{get, set};
use super::simulator::sins_sim;
use crate::math::Euler;
use crate::mounting::MountingParameters;
use crate::simulator::Simulator;

/// Position and attitude of the sensor block relative to the reference point of the flight samples, and the errors of what
/// the INS believes about them: believed = true + error, component by component. All zero is a block at the reference
/// point, along the body axes.
///
/// The ideal sensors measure the motion of the block, and sensor errors act in the axes of the block: sins_imu describes
/// the block. The INS navigates the block, and converts its solution to the reference point with the mounting that it
/// believes: sins_navigation and sins_errors describe the reference point. Initial errors apply to the solution for the
/// block, so at the start sins_errors can differ from them. Angular rate and specific force of a sample are those of the
/// reference point, along body axes. The barometric height is that of the reference point too.
///
/// Start in motion: at the start of a moving flight, and after a reposition, samples without an angular rate do not show
/// the angular acceleration of the first interval. The specific force of a block away from the reference point then lacks
/// the term angular acceleration times lever arm. In the second interval this term is correct to first order in the
/// interval's length, in the third to second order, later to third order. The navigation is not affected, because the INS
/// starts with the velocity that the block has at the mean angular rate of the first interval. With SINS_SAMPLE_ANGULAR_RATE
/// no term is missing.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_mounting {
    /// sizeof(sins_mounting)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Lever arm from the reference point to the block, body axes (sins_options.axes), -100 to 100 [m].
    pub lever_arm_m: [f64; 3],
    /// Boresight: roll, pitch and heading of the block's axes relative to the body axes [rad]. They are defined like the
    /// attitude angles of the body: positive roll right side down, positive pitch nose up, positive heading nose to the
    /// right. Each is -1e4 to 1e4; whole turns do not matter.
    pub boresight_rad: [f64; 3],
    /// Believed less true lever arm, -100 to 100 [m].
    pub lever_arm_error_m: [f64; 3],
    /// Believed less true boresight angles, -pi to pi [rad]. If the believed heading is too large, the heading that the INS
    /// reports is too small by the same amount.
    pub boresight_error_rad: [f64; 3],
}

interface_struct!(sins_mounting, "mounting", 104);

/// Sets the mounting of the sensor block. Allowed before the first step, and after a reset or a reposition until the next
/// step. A reset and a reposition keep the mounting. The mounting does not affect a navigator on increments: its solution is
/// that of the block.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: steps have been made.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_set_mounting(
    sim: *mut sins_sim,
    mounting: *const sins_mounting,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { set(sim, mounting, "mounting", Simulator::set_mounting) }
}

impl Parameters for sins_mounting {
    type Own = MountingParameters;

    fn from_parameters(parameters: &MountingParameters) -> Self {
        let angles = |euler: &Euler| [euler.roll, euler.pitch, euler.heading];
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            lever_arm_m: parameters.lever_arm_m.into(),
            boresight_rad: angles(&parameters.boresight),
            lever_arm_error_m: parameters.lever_arm_error_m.into(),
            boresight_error_rad: angles(&parameters.boresight_error),
        }
    }

    fn to_parameters(self) -> Result<MountingParameters, Failure> {
        check_reserved("mounting.reserved", self.reserved)?;
        let angles = |[roll, pitch, heading]: [f64; 3]| Euler { roll, pitch, heading };
        Ok(MountingParameters {
            lever_arm_m: Vector3::from(self.lever_arm_m),
            boresight: angles(self.boresight_rad),
            lever_arm_error_m: Vector3::from(self.lever_arm_error_m),
            boresight_error: angles(self.boresight_error_rad),
        })
    }
}

/// Reads the mounting of the sensor block that is set. May be called at any moment. After sins_snapshot_load() it is that of
/// the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_mounting(
    sim: *mut sins_sim,
    mounting: *mut sins_mounting,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { get(sim, mounting, "mounting", Simulator::mounting) }
}
