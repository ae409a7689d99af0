//! `sins_mounting`.

use nalgebra::Vector3;

use super::failure::{Failure, SINS_OK, sins_status};
use super::memory::{Output, interface_struct, read};
use super::options::check_reserved;
use super::simulator::{sins_sim, with_simulator};
use crate::math::Euler;
use crate::mounting::MountingParameters;

/// Where the sensor block sits against the reference point of the flight samples, and what the INS wrongly believes of that:
/// believed = true + error, component by component. All zero is a block at the reference point, along the body axes.
///
/// The ideal sensors feel the motion of the block, and sensor errors act in its axes: sins_imu is about the block. The INS
/// navigates the block and gives out the reference point with what it believes: sins_navigation and sins_errors are about that.
/// Initial errors are those of the INS's solution of the block. Angular rate and specific force of a sample are of the reference
/// point, along body axes; so is the barometric height.
///
/// Where a flight begins in motion, or is repositioned, samples without an angular rate do not tell the angular acceleration of the
/// first interval: the force of a block off the reference point lacks angular acceleration times arm there. The second interval has
/// it to first order of its length, the third to second, later ones to third. The navigation does not suffer: what the next
/// sample tells of the block's velocity, the INS has known from the start. With SINS_SAMPLE_ANGULAR_RATE nothing is lacking.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_mounting {
    /// sizeof(sins_mounting)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// From the reference point to the block, body axes (sins_options.axes), -100 to 100 [m].
    pub lever_arm_m: [f64; 3],
    /// Roll, pitch and heading of the block's axes against the body axes, as those of the body against the horizon: right side
    /// down, nose up, nose to the right; any number of turns up to 10000 rad, as in a flight sample [rad].
    pub boresight_rad: [f64; 3],
    /// Believed less true lever arm, -100 to 100 [m].
    pub lever_arm_error_m: [f64; 3],
    /// Believed less true boresight angles, -pi to pi [rad]. A heading believed too large makes the heading that the INS gives
    /// out too small by as much.
    pub boresight_error_rad: [f64; 3],
}

interface_struct!(sins_mounting, "mounting", 104);

/// Sets where the sensor block sits: before the first step, after a reset or after a reposition; both keep it. A navigator on
/// increments is not concerned: its solution is that of the block.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: steps have been made.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_set_mounting(
    sim: *mut sins_sim,
    mounting: *const sins_mounting,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let mounting = unsafe { read(mounting, "mounting")? };
        simulator.set_mounting(&mounting.to_parameters()?)?;
        Ok(SINS_OK)
    })
}

impl sins_mounting {
    /// The struct with `parameters`.
    pub(super) fn from_parameters(parameters: &MountingParameters) -> Self {
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

    pub(super) fn to_parameters(self) -> Result<MountingParameters, Failure> {
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

/// Reads place and attitude of the sensor block, as they were set last: at any moment, after sins_snapshot_load() too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_mounting(sim: *mut sins_sim, mounting: *mut sins_mounting) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(mounting, "mounting")? };
        output.write(&sins_mounting::from_parameters(&simulator.mounting()));
        Ok(SINS_OK)
    })
}
