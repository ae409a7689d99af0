//! Navigation alone, on increments of the host.

use nalgebra::{Quaternion, Vector3};

use super::answer::write_or_need;
use super::choice::check_reserved;
use super::failure::{SINS_OK, sins_status};
use super::memory::{Output, interface_struct, read};
use super::simulator::{sins_sim, with_simulator};
use super::solution::sins_navigation;
use crate::base::error::{Error, Rule, check_integer, check_range, check_ranges};
use crate::earth::Geodetic;
use crate::earth::state::Navigation;
use crate::mechanization::MAX_SUBSAMPLES;
use crate::signal::Increment;
use crate::truth::{FlightSample, check_height};

/// Increments of an inertial measurement unit over an interval. The interval is divided into parts of equal length; the
/// field count is their number.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub struct sins_imu_increment {
    /// sizeof(sins_imu_increment)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Length of the whole interval, 5e-5 to 10 [s].
    pub interval_s: f64,
    /// Number of parts, 1 to 5.
    pub count: i32,
    /// Must be 0.
    pub reserved2: u32,
    /// Integral of the angular rate against inertial space over each part: x, y, z of the first part, x, y, z of the second
    /// part, and so on [rad]. The rotation in each part, and in the interval, must be less than half a turn.
    pub angle_rad: [f64; 15],
    /// Integral of the specific force over each part, up to 1e4 m/s, likewise [m/s].
    pub velocity_m_s: [f64; 15],
}

interface_struct!(sins_imu_increment, "imu", 264);

impl sins_imu_increment {
    /// `increments`, at most five, over `interval_s` [s].
    fn new(increments: &[Increment], interval_s: f64) -> Self {
        let mut imu = Self {
            struct_size: size_of::<Self>() as u32,
            interval_s,
            count: increments.len() as i32,
            ..Self::default()
        };
        for (index, (to_angle, to_velocity)) in
            imu.angle_rad.chunks_exact_mut(3).zip(imu.velocity_m_s.chunks_exact_mut(3)).enumerate()
        {
            let increment = increments.get(index).unwrap_or(&Increment::ZERO);
            to_angle.copy_from_slice(increment.angle.as_slice());
            to_velocity.copy_from_slice(increment.velocity.as_slice());
        }
        imu
    }
}

/// Reads the increments on which the INS navigated in one update of the last interval: those of the modelled sensors, after the
/// compensation of sins_correct().
/// The argument update counts the updates of the interval from 0. Their number is sins_options.updates_per_sample, or more in an
/// interval of several periods. Each update has sins_options.subsamples parts; its interval_s is the interval divided by the
/// number of updates. A navigator of the host that gets all updates of each interval by sins_push_imu() has the solution of the INS
/// to the last bit, if the INS had no errors at the start, no mounting, SINS_VERTICAL_FREE, SINS_SIGNAL_PHYSICAL and no gravity
/// disturbance, and the navigator started from sins_get_truth() before the first step. With errors at the start it starts from
/// sins_get_navigation(), whose angles are rounded. With a mounting the parts are the signals of the sensor block. The parts do
/// not contain the aid of the vertical channel. sins_push_imu() rejects updates shorter than 5e-5 s.
///
/// SINS_NEED_SAMPLE: the last interval has no such update, or there is none: before the first step, and while the simulator navigates on
/// increments.
/// SINS_ERROR_INVALID_ARGUMENT: update is negative.
///
/// ```c
/// int update;
/// sins_imu_increment increment;
/// SINS_INIT(increment);
/// for (update = 0; sins_get_imu_update(sim, update, &increment) == SINS_OK; ++update) {
///     printf("%d parts of %g s\n", increment.count, increment.interval_s);  // 2 parts of 1 s
/// }
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_imu_update(
    sim: *mut sins_sim,
    update: i32,
    increment: *mut sins_imu_increment,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(increment, "increment")? };
        let index = check_integer("update", update, 0, i32::MAX as u64).map(|()| update as usize)?;
        let increments = simulator.measured_update(index);
        Ok(write_or_need(&output, increments.map(|(parts, t)| sins_imu_increment::new(parts, t))))
    })
}

/// Starts the simulator as a navigator only: it navigates on the increments of sins_push_imu(). The argument navigation
/// gives the start: time, position, velocity and attitude (quaternion_nb; the angles and the flags are not read). Ranges are
/// those of a flight sample; the norm of the quaternion must be 1 within 1e-3. Initial errors that are set do not apply.
/// There is no truth: the vertical channel is free, and flagged so, and the reads of errors and accuracy return
/// SINS_ERROR_BAD_STATE until sins_reset().
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: samples were pushed, or the navigator was started before (call sins_reset() first); or temperature
/// coefficients are set, but increments have no temperature.
/// SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_start_navigation(
    sim: *mut sins_sim,
    navigation: *const sins_navigation,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let start = unsafe { read(navigation, "navigation")? };
        check_reserved("navigation.reserved", start.reserved)?;
        let solution = &start.solution;
        let quarter = core::f64::consts::FRAC_PI_2;
        check_reserved("navigation.reserved2", solution.reserved2)?;
        check_range("navigation.time_s", start.time_s, -1e10, 1e10)?;
        check_range("navigation.latitude_rad", solution.latitude_rad, -quarter, quarter)?;
        let (longitude, velocity) = (FlightSample::MAX_LONGITUDE_RAD, FlightSample::MAX_VELOCITY_M_S);
        check_range("navigation.longitude_rad", solution.longitude_rad, -longitude, longitude)?;
        check_height("navigation.height_m", solution.height_m)?;
        check_ranges("navigation.velocity_enu_m_s", &solution.velocity_enu_m_s, -velocity, velocity)?;
        check_ranges("navigation.quaternion_nb", &solution.quaternion_nb, -1.001, 1.001)?;
        let [w, x, y, z] = solution.quaternion_nb;
        let q = Quaternion::new(w, x, y, z);
        let norm = q.norm_squared().sqrt();
        if (norm - 1.0).abs() > 1e-3 {
            let rule = Rule::Sentence("must be 1 within 1e-3");
            return Err(Error::invalid("norm of navigation.quaternion_nb", norm, rule).into());
        }
        let place = Geodetic {
            latitude_rad: solution.latitude_rad,
            longitude_rad: solution.longitude_rad,
            height_m: solution.height_m,
        };
        let v_n = Vector3::from(solution.velocity_enu_m_s);
        // A norm of 1 within rounding stays: a solution that was read starts to the bit.
        let unit = if (norm - 1.0).abs() <= 4.0 * f64::EPSILON { q } else { q / norm };
        let navigation = Navigation::new(place, v_n, unit, simulator.options().axes);
        simulator.start_navigation(start.time_s, &navigation)?;
        Ok(SINS_OK)
    })
}

/// Navigates over one interval on the host's increments. Sensor errors that are set are added to the increments. The time
/// advances by interval_s. sins_get_imu() reports the host's increments as the ideal ones. sins_options.subsamples and
/// updates_per_sample do not apply: the parts of the increment are the subsamples of one update.
///
/// SINS_ERROR_BAD_STATE: sins_start_navigation() was not called.
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or a rotation of half a turn or more in a part or in the interval.
/// SINS_ERROR_DIVERGED, SINS_ERROR_SINGULAR: as sins_step(); the interval is not flown, the solution before it stays
/// readable, and sins_reset() and sins_start_navigation() start anew.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_push_imu(
    sim: *mut sins_sim,
    increment: *const sins_imu_increment,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let imu = unsafe { read(increment, "increment")? };
        check_reserved("imu.reserved", imu.reserved)?;
        check_reserved("imu.reserved2", imu.reserved2)?;
        check_integer("imu.count", imu.count, 1, MAX_SUBSAMPLES as u64)?;
        let part = |values: &[f64; 15], index: usize| {
            Vector3::new(values[3 * index], values[3 * index + 1], values[3 * index + 2])
        };
        let increments: [Increment; MAX_SUBSAMPLES] = core::array::from_fn(|index| Increment {
            angle: part(&imu.angle_rad, index),
            velocity: part(&imu.velocity_m_s, index),
        });
        simulator.push_imu(&increments[..imu.count as usize], imu.interval_s)?;
        Ok(SINS_OK)
    })
}
