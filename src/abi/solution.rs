//! `sins_navigation`: the truth or the navigated solution.

use nalgebra::Quaternion;

use super::answer::{fill_or_need, write_or_need};
use super::choice::flag;
use super::failure::sins_status;
use super::memory::{Output, interface_struct};
use super::simulator::{sins_sim, with_simulator};
use crate::base::math::Euler;
use crate::earth::Geodetic;
use crate::earth::state::Navigation;
use crate::simulator::{Moment, Solution, View};

/// Flags of a sins_navigation.
pub type sins_navigation_flags = i32;

/// Within 20 km of the Earth's axis: longitude and heading change fast there, and at the pole they are undefined.
/// Quaternion, height and the errors in metres stay correct.
pub const SINS_NAVIGATION_NEAR_POLE: sins_navigation_flags = 1;
/// Nothing aids the vertical channel, because of the options or because the altimeter has no signal: any error grows e-fold
/// every 569 s.
pub const SINS_NAVIGATION_VERTICAL_UNAIDED: sins_navigation_flags = 2;
/// The positions and the velocities of the samples contradict each other. Let d be the displacement computed from the velocities.
/// The flag is set if the displacement of the positions since the previous sample differs from d by more than
/// sqrt((0.01 d)^2 + (1 cm)^2). The truth and the navigation have it.
pub const SINS_NAVIGATION_INCONSISTENT: sins_navigation_flags = 4;
/// The alignment at the start could not find north, so any heading error is possible. Either the accelerometers show no
/// force, or the error of the horizontal gyro rates is at least as large as the north component of the Earth rate. (If it is
/// smaller, the heading error is below 90 degrees.) The flag stays until the INS starts again, or a sins_unit corrects the
/// solution. Note: a real INS does not know this error. It can be sure that it has not found north only if its horizontal
/// gyro rate is more than twice the north component of the Earth rate.
pub const SINS_NAVIGATION_NORTH_UNKNOWN: sins_navigation_flags = 8;

/// A solution within a sins_record; never grows. Fields as in sins_navigation.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_record_solution {
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
    /// Attitude quaternion, scalar first: rotates from body axes to east-north-up; from sensor axes while navigating on
    /// increments.
    pub quaternion_nb: [f64; 4],
    /// Flags of enum sins_navigation_flags, or'ed.
    pub flags: i32,
    /// 0
    pub reserved2: u32,
}

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
    /// Flat in C.
    pub solution: sins_record_solution,
}

interface_struct!(sins_navigation, "navigation", 128);

impl sins_record_solution {
    #[inline(always)]
    pub(super) fn of(solution: &Solution) -> Self {
        let navigation = &solution.navigation;
        let q = &navigation.q_nb;
        Self {
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

impl From<sins_record_solution> for Navigation {
    fn from(solution: sins_record_solution) -> Self {
        let [w, i, j, k] = solution.quaternion_nb;
        Self {
            place: Geodetic {
                latitude_rad: solution.latitude_rad,
                longitude_rad: solution.longitude_rad,
                height_m: solution.height_m,
            },
            v_n: solution.velocity_enu_m_s.into(),
            q_nb: Quaternion::new(w, i, j, k),
            euler: Euler {
                roll: solution.roll_rad,
                pitch: solution.pitch_rad,
                heading: solution.heading_rad,
            },
        }
    }
}

impl sins_navigation {
    #[inline(always)]
    pub(super) fn of(solution: &Solution) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            time_s: solution.time_s,
            solution: sins_record_solution::of(solution),
        }
    }
}

struct NavigationView;

impl View for NavigationView {
    type Struct = sins_navigation;
    const OF_TRUTH: bool = false;
    const OF_NAVIGATION: bool = true;

    #[inline(always)]
    fn fill(navigation: &mut sins_navigation, moment: Moment<'_>) {
        *navigation = sins_navigation::of(&moment.navigation());
    }
}

/// Reads the truth at the end of the last interval; before the first step, that of the first sample. If the samples have no
/// velocity, the velocity at the first one is 0 until the second one is pushed.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_BAD_STATE: navigating on increments, without a truth.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_truth(
    sim: *mut sins_sim,
    truth: *mut sins_navigation,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(truth, "truth")? };
        let solution = simulator.truth()?;
        Ok(write_or_need(&output, solution.map(|solution| sins_navigation::of(&solution))))
    })
}

/// Reads the navigated solution for the same instant as sins_get_truth().
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: before the first step, no INS can start at the first sample with these options
/// and initial errors.
///
/// ```c
/// sins_get_navigation(sim, &navigation);
/// printf("%.1f deg north\n", navigation.latitude_rad / SINS_DEG);  // 39.9 deg north
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_navigation(
    sim: *mut sins_sim,
    navigation: *mut sins_navigation,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(navigation, "navigation")? };
        if let Some(alone) = simulator.navigated_alone() {
            return Ok(write_or_need(&output, Some(sins_navigation::of(&alone))));
        }
        fill_or_need::<NavigationView>(simulator, &output)
    })
}
