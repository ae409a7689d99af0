//! `sins_errors`: the errors of the navigated solution.

use super::answer::fill_or_need;
use super::choice::{Choice, choices, flag};
use super::failure::sins_status;
use super::memory::{Output, interface_struct};
use super::simulator::{sins_sim, with_simulator};
use crate::errors::NavigationErrors;
use crate::simulator::{ErrorSource, Moment, View};

include!(concat!(env!("OUT_DIR"), "/sins_errors_source.rs"));

/// Flags of a sins_errors.
pub type sins_errors_flags = i32;

/// The truth is within 20 km of the Earth's axis: the errors of longitude and heading, the up misalignment, and the east and
/// north components of the velocity error have no meaning.
pub const SINS_ERRORS_NEAR_POLE: sins_errors_flags = 1;
/// A flag of the error model: the terms that it neglects are no longer small. The misalignment is above 2 degrees, or the
/// position error is above 100 km, or, at high latitude, above 3.5 % of the distance to the pole.
pub const SINS_ERRORS_OUTSIDE_VALIDITY: sins_errors_flags = 2;
/// Not computed, all zero: in a sins_record; of a run that has diverged or cannot start, in sins_ensemble_get_all_errors().
pub const SINS_ERRORS_NOT_COMPUTED: sins_errors_flags = 4;
/// In a sins_covariance: since the start sins_correct() has corrected the INS. The covariance is that of an INS without
/// corrections.
pub const SINS_ERRORS_WITHOUT_CORRECTIONS: sins_errors_flags = 8;

/// Errors within a sins_record; never grows. Fields as in sins_errors.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_record_errors {
    /// Position error: displacement from truth along true east and north, and difference of heights [m].
    pub position_enu_m: [f64; 3],
    /// Error of latitude [rad].
    pub latitude_rad: f64,
    /// Error of longitude, wrapped to -pi to pi [rad].
    pub longitude_rad: f64,
    /// Error of height [m].
    pub height_m: f64,
    /// Velocity error [m/s]: components of the computed velocity in the east-north-up axes at the computed position, less
    /// components of the true velocity in the axes at the true position.
    pub velocity_enu_m_s: [f64; 3],
    /// Misalignment phi, a rotation vector [rad]: computed C = exp(-[phi x]) true C, where C turns vectors from body axes to
    /// east-north-up. In the error model it is of first order: computed C = (I - [phi x]) true C.
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
    /// Flat in C.
    pub errors: sins_record_errors,
}

interface_struct!(sins_errors, "errors", 144);

impl sins_record_errors {
    /// Errors that nobody computes.
    const NOT_COMPUTED: Self = Self {
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
    };

    #[inline(always)]
    pub(super) fn of_navigation(moment: Moment<'_>) -> Self {
        Self::new(&moment.navigation_errors(), moment.near_pole())
    }

    #[inline(always)]
    pub(super) fn of_model(moment: Moment<'_>) -> Self {
        moment.model_errors().map_or(Self::NOT_COMPUTED, |errors| Self::new(&errors, moment.near_pole()))
    }

    #[inline(always)]
    fn new(errors: &NavigationErrors, near_pole: bool) -> Self {
        Self {
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
}

impl From<sins_record_errors> for NavigationErrors {
    fn from(errors: sins_record_errors) -> Self {
        Self {
            position_n: errors.position_enu_m.into(),
            latitude_rad: errors.latitude_rad,
            longitude_rad: errors.longitude_rad,
            velocity_n: errors.velocity_enu_m_s.into(),
            misalignment_n: errors.misalignment_enu_rad.into(),
            roll_rad: errors.roll_rad,
            pitch_rad: errors.pitch_rad,
            heading_rad: errors.heading_rad,
            outside_validity: errors.flags & SINS_ERRORS_OUTSIDE_VALIDITY != 0,
        }
    }
}

impl sins_errors {
    #[inline(always)]
    fn at(time_s: f64, errors: sins_record_errors) -> Self {
        Self { struct_size: size_of::<Self>() as u32, reserved: 0, time_s, errors }
    }

    pub(super) fn new(time_s: f64, errors: &NavigationErrors, near_pole: bool) -> Self {
        Self::at(time_s, sins_record_errors::new(errors, near_pole))
    }

    /// The errors; `None` if they are not computed.
    pub(super) fn of_run(&self) -> Option<NavigationErrors> {
        let errors = &self.errors;
        (errors.flags & SINS_ERRORS_NOT_COMPUTED == 0).then(|| NavigationErrors {
            position_n: errors.position_enu_m.into(),
            latitude_rad: errors.latitude_rad,
            longitude_rad: errors.longitude_rad,
            velocity_n: errors.velocity_enu_m_s.into(),
            misalignment_n: errors.misalignment_enu_rad.into(),
            roll_rad: errors.roll_rad,
            pitch_rad: errors.pitch_rad,
            heading_rad: errors.heading_rad,
            outside_validity: errors.flags & SINS_ERRORS_OUTSIDE_VALIDITY != 0,
        })
    }

    pub(super) fn not_computed(time_s: f64) -> Self {
        Self::at(time_s, sins_record_errors::NOT_COMPUTED)
    }
}

struct NavigationErrorsView;

impl View for NavigationErrorsView {
    type Struct = sins_errors;
    const OF_TRUTH: bool = true;
    const OF_NAVIGATION: bool = true;

    #[inline(always)]
    fn fill(errors: &mut sins_errors, moment: Moment<'_>) {
        *errors = sins_errors::at(moment.time_s(), sins_record_errors::of_navigation(moment));
    }
}

struct ModelErrorsView;

impl View for ModelErrorsView {
    type Struct = sins_errors;
    const OF_TRUTH: bool = true;
    const OF_NAVIGATION: bool = false;

    #[inline(always)]
    fn fill(errors: &mut sins_errors, moment: Moment<'_>) {
        *errors = sins_errors::at(moment.time_s(), sins_record_errors::of_model(moment));
    }
}

/// Reads the errors of the navigated solution; source is of enum sins_errors_source.
///
/// SINS_NEED_SAMPLE: no sample yet.
/// SINS_ERROR_INVALID_ARGUMENT: no such source.
/// SINS_ERROR_BAD_STATE: SINS_ERRORS_MODEL while the error model is off, as it is by default (create the simulator with
/// sins_options.error_model), or navigating on increments.
/// SINS_ERROR_SINGULAR, SINS_ERROR_DIVERGED: as sins_get_navigation().
///
/// ```c
/// sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors);
/// printf("%.2f nmi north\n", errors.position_enu_m[1] / SINS_NMI);  // -0.72 nmi north
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_errors(
    sim: *mut sins_sim,
    source: i32,
    errors: *mut sins_errors,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(errors, "errors")? };
        let source = ErrorSource::of("source", source)?;
        simulator.refuse_without(source)?;
        match source {
            ErrorSource::Navigation => fill_or_need::<NavigationErrorsView>(simulator, &output),
            ErrorSource::Model => fill_or_need::<ModelErrorsView>(simulator, &output),
        }
    })
}
