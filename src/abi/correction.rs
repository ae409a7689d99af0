//! `sins_correction`: errors that a host estimated and wants removed.

use nalgebra::Vector3;

use super::choice::check_reserved;
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{Output, interface_struct, read};
use super::simulator::{sins_sim, with_simulator};
use crate::earth::state::StateErrors;
use crate::errors::correction::{Compensation, Correction};

/// Errors that the host estimated, for example with a Kalman filter or by a fix, and that the INS removes. All zero, the default,
/// changes nothing.
///
/// The first three fields are errors of the solution, in the definitions of sins_errors: a sins_errors that is copied into them
/// leaves no error but rounding. They may have any size within their limits. The other fields are errors of the sensors, along the
/// sensor axes. They are added to the compensation in force, which sins_get_compensation() reads. From the next interval on the
/// INS navigates on compensated increments: (measured - bias * time) / (1 + scale factor), axis by axis. The sums must stay within
/// 100 rad/s, 1e4 m/s2, and 0.5 for scale factors.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_correction {
    /// sizeof(sins_correction)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Position error: displacement along true east and north, and difference of heights, -1e6 to 1e6 [m]. The true place is
    /// the corrected one. Near a pole two places can have this displacement; that which turns the attitude less is taken.
    pub position_enu_m: [f64; 3],
    /// Velocity error, -1e4 to 1e4 [m/s].
    pub velocity_enu_m_s: [f64; 3],
    /// Misalignment phi, a rotation vector, each -pi to pi [rad].
    pub misalignment_enu_rad: [f64; 3],
    /// Gyro bias, added to the compensation in force [rad/s].
    pub gyro_bias_rad_s: [f64; 3],
    /// Scale factor error of the gyros, added to the compensation in force [1].
    pub gyro_scale_factor: [f64; 3],
    /// Accelerometer bias, added to the compensation in force [m/s2].
    pub accel_bias_m_s2: [f64; 3],
    /// Scale factor error of the accelerometers, added to the compensation in force [1].
    pub accel_scale_factor: [f64; 3],
}

interface_struct!(sins_correction, "correction", 176);

impl sins_correction {
    pub(super) fn to_correction(self) -> Result<Correction, CallError> {
        check_reserved("correction.reserved", self.reserved)?;
        Ok(Correction {
            errors: StateErrors {
                position_n: Vector3::from(self.position_enu_m),
                velocity_n: Vector3::from(self.velocity_enu_m_s),
                misalignment_n: Vector3::from(self.misalignment_enu_rad),
            },
            sensors: Compensation {
                gyro_bias: Vector3::from(self.gyro_bias_rad_s),
                gyro_scale_factor: Vector3::from(self.gyro_scale_factor),
                accel_bias: Vector3::from(self.accel_bias_m_s2),
                accel_scale_factor: Vector3::from(self.accel_scale_factor),
            },
        })
    }
}

/// Compensation of the measured increments in force: the sum of all corrections since the start.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_compensation {
    /// sizeof(sins_compensation)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Gyro bias [rad/s].
    pub gyro_bias_rad_s: [f64; 3],
    /// Scale factor error of the gyros [1].
    pub gyro_scale_factor: [f64; 3],
    /// Accelerometer bias [m/s2].
    pub accel_bias_m_s2: [f64; 3],
    /// Scale factor error of the accelerometers [1].
    pub accel_scale_factor: [f64; 3],
}

interface_struct!(sins_compensation, "compensation", 104);

impl From<&Compensation> for sins_compensation {
    fn from(compensation: &Compensation) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            gyro_bias_rad_s: compensation.gyro_bias.into(),
            gyro_scale_factor: compensation.gyro_scale_factor.into(),
            accel_bias_m_s2: compensation.accel_bias.into(),
            accel_scale_factor: compensation.accel_scale_factor.into(),
        }
    }
}

/// Removes errors that the host estimated. May be called between any two steps, and between the calls of sins_push_imu(). The
/// solution, its errors and error data 1 are corrected at once. The truth, the modelled sensors and their random numbers do not
/// change, and the loop of the vertical channel keeps its state. With a mounting the errors are those of the reference point, as
/// in sins_errors. A reposition, a reset and sins_start_navigation() begin without a compensation. No allocation, no system call.
///
/// The covariance of sins_get_covariance() remains that of an INS without corrections: SINS_ERRORS_WITHOUT_CORRECTIONS.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value or a sum out of its range; or, within the position error of a pole, no place has this
/// displacement.
/// SINS_ERROR_BAD_STATE: no step was made yet.
/// SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: the corrected solution would be beyond the limits of sins_step(). After any error
/// nothing has changed.
///
/// ```c
/// sins_correction correction;
/// int axis;
/// SINS_INIT(correction);
/// for (axis = 0; axis < 3; ++axis) correction.position_enu_m[axis] = errors.position_enu_m[axis];
/// sins_correct(sim, &correction);
/// sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors);
/// printf("%.2f nmi north\n", errors.position_enu_m[1] / SINS_NMI);  // 0.00 nmi north
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_correct(
    sim: *mut sins_sim,
    correction: *const sins_correction,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        simulator.correct(&unsafe { read(correction, "correction")? }.to_correction()?)?;
        Ok(SINS_OK)
    })
}

/// Reads the compensation in force. It is zero before the first step. After sins_snapshot_load() it is that of the snapshot.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_compensation(
    sim: *mut sins_sim,
    compensation: *mut sins_compensation,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        Ok(unsafe { Output::new(compensation, "compensation")? }.write(&(&simulator.compensation()).into()))
    })
}
