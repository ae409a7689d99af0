//! `sins_navigation`, `sins_errors`, `sins_imu`: what is read after a step.

use super::failure::{Failure, SINS_NEED_SAMPLE, SINS_OK, sins_status};
use super::memory::{Output, interface_struct};
use super::options::one_of;
use super::simulator::{sins_sim, with_simulator};
use crate::errors::NavigationErrors;
use crate::simulator::{ErrorSource, ImuInterval, Moment, Solution};

/// Flags of a sins_navigation.
pub type sins_navigation_flags = i32;

/// Within 20 km of the Earth's axis: longitude and heading change fast there, and at the pole they are undefined.
/// Quaternion, height and the errors in metres stay correct.
pub const SINS_NAVIGATION_NEAR_POLE: sins_navigation_flags = 1;
/// Nothing aids the vertical channel, because of the options or because the altimeter has no signal: any error grows e-fold
/// every 569 s.
pub const SINS_NAVIGATION_VERTICAL_UNAIDED: sins_navigation_flags = 2;
/// A flag of the truth: the displacement since the previous sample differs from the one that the velocities give by more than
/// the root sum of squares of 1 % and 1 cm.
pub const SINS_NAVIGATION_INCONSISTENT: sins_navigation_flags = 4;
/// The alignment at the start could not find north, so any heading error is possible. Either the accelerometers show no
/// force, or the horizontal error of the levelled rates is at least as large as the north component of the Earth rate. (If
/// it is smaller, the heading error is below 90 degrees.) The simulator knows this error. A real INS can be sure of this
/// case only if its levelled horizontal rate is more than twice the north component of the Earth rate. The flag stays until
/// the INS starts again.
pub const SINS_NAVIGATION_NORTH_UNKNOWN: sins_navigation_flags = 8;

/// The two sources of errors.
pub type sins_errors_source = i32;

/// Navigation minus truth: the paper's error data 2.
pub const SINS_ERRORS_NAVIGATION: sins_errors_source = 0;
/// The error differential equations: the paper's error data 1 (sins_options.error_model).
pub const SINS_ERRORS_MODEL: sins_errors_source = 1;

/// Flags of a sins_errors.
pub type sins_errors_flags = i32;

/// The truth is within 20 km of the Earth's axis: the errors of longitude and heading, the up misalignment, and the east and
/// north components of the velocity error have no meaning.
pub const SINS_ERRORS_NEAR_POLE: sins_errors_flags = 1;
/// A flag of the error model: the terms that it neglects are no longer small. The misalignment is above 2 degrees, or the
/// displacement is above 100 km, or, at high latitude, above 3.5 % of the distance to the pole.
pub const SINS_ERRORS_OUTSIDE_VALIDITY: sins_errors_flags = 2;
/// In a sins_record: not computed, all zero.
pub const SINS_ERRORS_NOT_COMPUTED: sins_errors_flags = 4;

/// Flags of a sins_imu.
pub type sins_imu_flags = u32;

/// The mean rate of a subsample was beyond the range of a gyro.
pub const SINS_IMU_GYRO_SATURATED: sins_imu_flags = 1;
/// The mean force of a subsample was beyond the range of an accelerometer.
pub const SINS_IMU_ACCEL_SATURATED: sins_imu_flags = 2;
/// A gyro had no signal in the interval: dead, or dropped out. The mechanization continues with its output of 0.
pub const SINS_IMU_GYRO_INVALID: sins_imu_flags = 4;
/// An accelerometer had no signal in the interval: dead, or dropped out.
pub const SINS_IMU_ACCEL_INVALID: sins_imu_flags = 8;

/// A solution: the truth or the navigated one.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_navigation {
    /// sizeof(sins_navigation)
    pub struct_size: u32,
    /// 0 (must be 0 where it is an input).
    pub reserved: u32,
    /// Time [s].
    pub time_s: f64,
    /// Geodetic latitude, -pi/2 to pi/2 [rad].
    pub latitude_rad: f64,
    /// Longitude, east positive, -pi to pi [rad].
    pub longitude_rad: f64,
    /// Height above the ellipsoid [m].
    pub height_m: f64,
    /// Velocity against the Earth, east-north-up [m/s].
    pub velocity_enu_m_s: [f64; 3],
    /// Roll, right wing down positive, -pi to pi [rad].
    pub roll_rad: f64,
    /// Pitch, nose up positive, -pi/2 to pi/2 [rad].
    pub pitch_rad: f64,
    /// Heading, clockwise from true north, 0 to 2 pi [rad].
    pub heading_rad: f64,
    /// Attitude quaternion, scalar first: rotates from sensor axes to east-north-up.
    pub quaternion_nb: [f64; 4],
    /// Flags of enum sins_navigation_flags, or'ed.
    pub flags: i32,
    /// 0
    pub reserved2: u32,
}

interface_struct!(sins_navigation, "navigation", 128);

/// Errors of the navigated solution, computed less true.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_errors {
    /// sizeof(sins_errors)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Time [s].
    pub time_s: f64,
    /// Position error: displacement from truth along true east and north, and difference of heights [m].
    pub position_enu_m: [f64; 3],
    /// Error of latitude [rad].
    pub latitude_rad: f64,
    /// Error of longitude, wrapped to -pi to pi [rad].
    pub longitude_rad: f64,
    /// Error of height [m].
    pub height_m: f64,
    /// Velocity error [m/s]: difference of the components, each in the east-north-up axes of its own position.
    pub velocity_enu_m_s: [f64; 3],
    /// Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) true C, where C turns vectors from sensor axes
    /// to east-north-up. In the error model it is of first order: computed C = (I - [phi x]) true C.
    pub misalignment_enu_rad: [f64; 3],
    /// Error of roll, wrapped to -pi to pi [rad].
    pub roll_rad: f64,
    /// Error of pitch [rad].
    pub pitch_rad: f64,
    /// Error of heading, wrapped to -pi to pi [rad].
    pub heading_rad: f64,
    /// Flags of enum sins_errors_flags, or'ed.
    pub flags: i32,
    /// 0
    pub reserved2: u32,
}

interface_struct!(sins_errors, "errors", 144);

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
    /// Mean angular rate of perfect gyros: ideal_angle_rad divided by interval_s [rad/s].
    pub ideal_rate_rad_s: [f64; 3],
    /// Mean specific force of perfect accelerometers: ideal_velocity_m_s divided by interval_s [m/s2].
    pub ideal_force_m_s2: [f64; 3],
    /// Mean angular rate of the modelled gyros: measured_angle_rad divided by interval_s [rad/s].
    pub measured_rate_rad_s: [f64; 3],
    /// Mean specific force of the modelled accelerometers: measured_velocity_m_s divided by interval_s [m/s2].
    pub measured_force_m_s2: [f64; 3],
}

interface_struct!(sins_imu, "imu", 216);

impl sins_navigation {
    #[inline(always)]
    pub(super) fn from_solution(solution: &Solution) -> Self {
        let navigation = &solution.navigation;
        let flag = |set: bool, flag: i32| if set { flag } else { 0 };
        let q = &navigation.q_nb;
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            time_s: solution.time_s,
            latitude_rad: navigation.place.latitude_rad,
            longitude_rad: navigation.place.longitude_rad,
            height_m: navigation.place.height_m,
            velocity_enu_m_s: navigation.v_n.into(),
            roll_rad: navigation.euler.roll,
            pitch_rad: navigation.euler.pitch,
            heading_rad: navigation.euler.heading,
            quaternion_nb: [q.w, q.i, q.j, q.k],
            flags: flag(solution.near_pole, SINS_NAVIGATION_NEAR_POLE)
                | flag(solution.vertical_unaided, SINS_NAVIGATION_VERTICAL_UNAIDED)
                | flag(solution.inconsistent, SINS_NAVIGATION_INCONSISTENT)
                | flag(solution.north_unknown, SINS_NAVIGATION_NORTH_UNKNOWN),
            reserved2: 0,
        }
    }
}

impl sins_errors {
    #[inline(always)]
    pub(super) fn of_navigation(moment: Moment<'_>) -> Self {
        Self::new(moment.time_s(), &moment.navigation_errors(), moment.near_pole())
    }

    #[inline(always)]
    pub(super) fn of_model(moment: Moment<'_>) -> Self {
        match moment.model_errors() {
            Some(errors) => Self::new(moment.time_s(), &errors, moment.near_pole()),
            None => Self::not_computed(moment.time_s()),
        }
    }

    #[inline(always)]
    pub(super) fn new(time_s: f64, errors: &NavigationErrors, near_pole: bool) -> Self {
        let flag = |set: bool, flag: i32| if set { flag } else { 0 };
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            time_s,
            position_enu_m: errors.position_n.into(),
            latitude_rad: errors.latitude_rad,
            longitude_rad: errors.longitude_rad,
            height_m: errors.position_n.z,
            velocity_enu_m_s: errors.velocity_n.into(),
            misalignment_enu_rad: errors.misalignment_n.into(),
            roll_rad: errors.roll_rad,
            pitch_rad: errors.pitch_rad,
            heading_rad: errors.heading_rad,
            flags: flag(near_pole, SINS_ERRORS_NEAR_POLE)
                | flag(errors.outside_validity, SINS_ERRORS_OUTSIDE_VALIDITY),
            reserved2: 0,
        }
    }

    /// Errors that nobody computes.
    fn not_computed(time_s: f64) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            time_s,
            position_enu_m: [0.0; 3],
            latitude_rad: 0.0,
            longitude_rad: 0.0,
            height_m: 0.0,
            velocity_enu_m_s: [0.0; 3],
            misalignment_enu_rad: [0.0; 3],
            roll_rad: 0.0,
            pitch_rad: 0.0,
            heading_rad: 0.0,
            flags: SINS_ERRORS_NOT_COMPUTED,
            reserved2: 0,
        }
    }
}

impl From<&ImuInterval> for sins_imu {
    fn from(imu: &ImuInterval) -> Self {
        let t = imu.interval_s;
        let flag = |set: bool, flag: u32| if set { flag } else { 0 };
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
            ideal_rate_rad_s: (imu.ideal.angle / t).into(),
            ideal_force_m_s2: (imu.ideal.velocity / t).into(),
            measured_rate_rad_s: (imu.measured.angle / t).into(),
            measured_force_m_s2: (imu.measured.velocity / t).into(),
        }
    }
}

/// The source that a host names.
pub(super) fn source_of(source: i32) -> Result<ErrorSource, Failure> {
    one_of(
        "source",
        source,
        &[(SINS_ERRORS_NAVIGATION, ErrorSource::Navigation), (SINS_ERRORS_MODEL, ErrorSource::Model)],
        "sins_errors_source",
    )
}

/// Writes `value`, or answers that there is none yet.
pub(super) fn write_or_need<T: super::memory::Struct>(output: &Output<T>, value: Option<T>) -> sins_status {
    written_or_need(value.map(|value| output.write(&value)))
}

/// The answer of a read: whether there was something to write.
pub(super) fn written_or_need(written: Option<()>) -> sins_status {
    if written.is_some() { SINS_OK } else { SINS_NEED_SAMPLE }
}

/// Reads the truth at the end of the last interval; before the first step, that of the first sample. If the samples have no
/// velocity, the velocity at the first one is 0 until the second one is pushed.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_truth(sim: *mut sins_sim, truth: *mut sins_navigation) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(truth, "truth")? };
        let solution = simulator.truth()?;
        Ok(write_or_need(&output, solution.map(|solution| sins_navigation::from_solution(&solution))))
    })
}

/// Reads the navigated solution for the same instant as sins_get_truth().
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: before the first step, no INS can start at the first sample with these options
/// and initial errors.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_navigation(
    sim: *mut sins_sim,
    navigation: *mut sins_navigation,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(navigation, "navigation")? };
        if let Some(alone) = simulator.navigated_alone() {
            return Ok(write_or_need(&output, Some(sins_navigation::from_solution(&alone))));
        }
        let written = simulator.see(|moment| {
            output.fill(|place| *place = sins_navigation::from_solution(&moment.navigation()));
        })?;
        Ok(written_or_need(written))
    })
}

/// Reads ideal and measured signals of the last interval.
///
/// SINS_NEED_SAMPLE: no interval yet.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_imu(sim: *mut sins_sim, imu: *mut sins_imu) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(imu, "imu")? };
        Ok(write_or_need(&output, simulator.imu().map(|imu| sins_imu::from(&imu))))
    })
}

/// Reads the errors of the navigated solution; source is of enum sins_errors_source.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_INVALID_ARGUMENT: no such source.
/// SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while the error model is off, as it is by default (create the simulator with
/// sins_options.error_model), or navigating on increments.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_get_errors(
    sim: *mut sins_sim,
    source: i32,
    errors: *mut sins_errors,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(errors, "errors")? };
        let source = source_of(source)?;
        simulator.refuse_without(source)?;
        let written = match source {
            ErrorSource::Navigation => {
                simulator.see(|moment| output.fill(|place| *place = sins_errors::of_navigation(moment)))?
            }
            ErrorSource::Model => {
                simulator.see(|moment| output.fill(|place| *place = sins_errors::of_model(moment)))?
            }
        };
        Ok(written_or_need(written))
    })
}
