//! `sins_imu`: ideal and measured signals.

use super::answer::write_or_need;
use super::choice::flag;
use super::failure::sins_status;
use super::memory::{Output, interface_struct};
use super::simulator::{sins_sim, with_simulator};
use crate::simulator::ImuInterval;

/// Flags of a sins_imu.
pub type sins_imu_flags = u32;

/// The mean rate of a subsample was beyond the range of a gyro.
pub const SINS_IMU_GYRO_SATURATED: sins_imu_flags = 1;
/// The mean force of a subsample was beyond the range of an accelerometer.
pub const SINS_IMU_ACCEL_SATURATED: sins_imu_flags = 2;
/// A gyro had no signal in the interval: dead, or dropped out. The mechanization continues with the output 0 of this gyro.
pub const SINS_IMU_GYRO_INVALID: sins_imu_flags = 4;
/// An accelerometer had no signal in the interval: dead, or dropped out. The mechanization continues with the output 0 of
/// this accelerometer.
pub const SINS_IMU_ACCEL_INVALID: sins_imu_flags = 8;

/// Ideal and measured signals of the last interval, sensor axes.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_imu {
    /// sizeof(sins_imu)
    pub struct_size: u32,
    /// Flags of enum sins_imu_flags, or'ed.
    pub flags: u32,
    /// Time of the end of the interval [s].
    pub time_s: f64,
    /// Length of the interval [s].
    pub interval_s: f64,
    /// Integral of the angular rate against inertial space, as perfect gyros measure it [rad].
    pub ideal_angle_rad: [f64; 3],
    /// Integral of the specific force, as perfect accelerometers measure it [m/s].
    pub ideal_velocity_m_s: [f64; 3],
    /// Integral of the angular rate that the modelled gyros measure [rad].
    pub measured_angle_rad: [f64; 3],
    /// Integral of the specific force that the modelled accelerometers measure [m/s].
    pub measured_velocity_m_s: [f64; 3],
    /// measured_angle_rad after the compensation of sins_correct() [rad]. The INS navigates on the compensated increments.
    pub compensated_angle_rad: [f64; 3],
    /// measured_velocity_m_s after the compensation of sins_correct() [m/s].
    pub compensated_velocity_m_s: [f64; 3],
    /// Mean angular rate of perfect gyros: ideal_angle_rad divided by interval_s [rad/s].
    pub ideal_rate_rad_s: [f64; 3],
    /// Mean specific force of perfect accelerometers: ideal_velocity_m_s divided by interval_s [m/s2].
    pub ideal_force_m_s2: [f64; 3],
    /// Mean angular rate of the modelled gyros: measured_angle_rad divided by interval_s [rad/s].
    pub measured_rate_rad_s: [f64; 3],
    /// Mean specific force of the modelled accelerometers: measured_velocity_m_s divided by interval_s [m/s2].
    pub measured_force_m_s2: [f64; 3],
}

interface_struct!(sins_imu, "imu", 264);

impl From<&ImuInterval> for sins_imu {
    fn from(imu: &ImuInterval) -> Self {
        let t = imu.interval_s;
        Self {
            struct_size: size_of::<Self>() as u32,
            flags: flag(imu.flags.gyro_saturated, SINS_IMU_GYRO_SATURATED)
                | flag(imu.flags.accel_saturated, SINS_IMU_ACCEL_SATURATED)
                | flag(imu.flags.gyro_invalid, SINS_IMU_GYRO_INVALID)
                | flag(imu.flags.accel_invalid, SINS_IMU_ACCEL_INVALID),
            time_s: imu.time_s,
            interval_s: t,
            ideal_angle_rad: imu.ideal.angle.into(),
            ideal_velocity_m_s: imu.ideal.velocity.into(),
            measured_angle_rad: imu.measured.angle.into(),
            measured_velocity_m_s: imu.measured.velocity.into(),
            compensated_angle_rad: imu.compensated.angle.into(),
            compensated_velocity_m_s: imu.compensated.velocity.into(),
            ideal_rate_rad_s: (imu.ideal.angle / t).into(),
            ideal_force_m_s2: (imu.ideal.velocity / t).into(),
            measured_rate_rad_s: (imu.measured.angle / t).into(),
            measured_force_m_s2: (imu.measured.velocity / t).into(),
        }
    }
}

/// Reads ideal and measured signals of the last interval. They are sums: for own navigation, sins_get_imu_update() reads the
/// parts on which the INS navigates.
///
/// SINS_NEED_SAMPLE: no interval yet.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_imu(sim: *mut sins_sim, imu: *mut sins_imu) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(imu, "imu")? };
        Ok(write_or_need(&output, simulator.imu().map(|imu| sins_imu::from(&imu))))
    })
}
