//! `sins_unit`: the unit, its panel, and its update.

use core::ffi::c_void;

use super::boundary::handle::{hand_out, with_object};
use super::boundary::tables::UNITS;
use super::boundary::{enter, enter_without_simulator};
use super::choice::{Choice, check_reserved, choices};
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{Output, interface_struct, read};
use super::parameters::Parameters;
use super::settings::sins_unit_params;
use super::simulator::{sins_sim, work_with};
use super::text::{bytes_of, put_saved};
use crate::earth::Geodetic;
use crate::unit::{AlignmentKind, Mode, Power, StoredAlignment, Unit, UnitParameters};

/// A unit. A handle is a checked key, like that of a sins_sim, and is never confused with one. sins_last_error(NULL, ...) on the same
/// thread gives the failures of its functions.
#[repr(C)]
pub struct sins_unit {
    _opaque: [u8; 0],
}

/// Positions of the mode selector.
pub type sins_unit_mode = i32;

/// Off.
pub const SINS_UNIT_OFF: sins_unit_mode = 0;
/// Alignment. An aligned unit is ready and waits for SINS_UNIT_NAV. In navigation, at a ground speed below
/// realignment_speed_m_s, it is a fast realignment; at a higher speed the navigation is lost.
pub const SINS_UNIT_ALIGN: sins_unit_mode = 1;
/// Navigation, after an alignment if the unit is not aligned.
pub const SINS_UNIT_NAV: sins_unit_mode = 2;
/// Attitude, and a heading that was entered. Navigation is lost.
pub const SINS_UNIT_ATT: sins_unit_mode = 3;

choices!(sins_unit_mode: Mode {
    Off = SINS_UNIT_OFF, Align = SINS_UNIT_ALIGN, Navigate = SINS_UNIT_NAV, Attitude = SINS_UNIT_ATT,
});

include!(concat!(env!("OUT_DIR"), "/sins_unit_power.rs"));
include!(concat!(env!("OUT_DIR"), "/sins_unit_alignment.rs"));

/// A buffer of this size holds every snapshot of a unit that this release saves.
pub const SINS_UNIT_SNAPSHOT_MAX_SIZE: usize = 2048;
const _: () = assert!(SINS_UNIT_SNAPSHOT_MAX_SIZE == Unit::SNAPSHOT_MAX_SIZE);

/// Runs `body` on the unit of a handle, as the inside of an exported function.
pub(super) fn with_unit(
    unit: *const sins_unit,
    body: impl FnOnce(&mut Unit) -> Result<sins_status, CallError>,
) -> sins_status {
    with_object(&UNITS, unit, body)
}

/// Creates a unit. If params is NULL, all are 0, the defaults. mode is SINS_UNIT_OFF; or SINS_UNIT_NAV for a unit that navigates
/// already, with the start of its simulator.
///
/// A unit works with one simulator, which the host creates and sets as without a unit. In each frame the host pushes a sample, makes a
/// step, and calls sins_unit_update().
///
/// After an error *unit is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason. Not for a real-time frame: it
/// allocates.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_STATE: mode is SINS_UNIT_ALIGN or SINS_UNIT_ATT.
/// SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 units exist.
///
/// ```c
/// sins_sim *inertial = NULL;
/// sins_unit *unit = NULL;
/// sins_unit_status unit_status;
/// SINS_INIT(unit_status);
/// SINS_INIT(sample);
/// sample.latitude_rad = 40.0 * SINS_DEG;
/// sins_create(NULL, &inertial);
/// sins_unit_create(NULL, SINS_UNIT_OFF, &unit);
/// sins_unit_select(unit, SINS_UNIT_NAV);
/// for (sample.time_s = 0.0; sample.time_s <= 600.0; sample.time_s += 1.0) {
///     sins_push_sample(inertial, &sample);
///     if (sins_step(inertial) == SINS_OK) sins_unit_update(unit, inertial);
///     if (sample.time_s == 60.0) sins_unit_enter_position(unit, 40.0 * SINS_DEG, 0.0);
/// }
/// sins_unit_get_status(unit, &unit_status);
/// printf("navigates: %d\n", unit_status.state == SINS_UNIT_STATE_NAVIGATION);  // navigates: 1
/// sins_unit_destroy(unit);
/// sins_destroy(inertial);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_create(
    params: *const sins_unit_params,
    mode: i32,
    unit: *mut *mut sins_unit,
) -> sins_status {
    enter_without_simulator(|| {
        let make = || {
            let parameters = if params.is_null() {
                UnitParameters::default()
            } else {
                // SAFETY: the host's promise.
                unsafe { read(params, "params")? }.to_parameters()?
            };
            Ok(Unit::new(&parameters, Mode::of("mode", mode)?)?)
        };
        // SAFETY: the host's promise.
        unsafe { hand_out(&UNITS, unit, "unit", make) }
    })
}

/// Waits until the calls of other threads on this handle have returned, and destroys the unit. The handle is never used again.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_destroy(unit: *mut sins_unit) -> sins_status {
    enter(|| UNITS.remove(unit.addr()))
}

/// Sets times and limits. May be called at any moment; they act at once.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_set_params(
    unit: *mut sins_unit,
    params: *const sins_unit_params,
) -> sins_status {
    with_unit(unit, |unit| {
        // SAFETY: the host's promise.
        unit.set_parameters(&unsafe { read(params, "params")? }.to_parameters()?)?;
        Ok(SINS_OK)
    })
}

/// Reads times and limits, as they were set.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_get_params(
    unit: *mut sins_unit,
    params: *mut sins_unit_params,
) -> sins_status {
    with_unit(unit, |unit| {
        // SAFETY: the host's promise.
        Ok(unsafe { Output::new(params, "params")? }.write(&Parameters::from_parameters(unit.parameters())))
    })
}

/// Turns the mode selector, of enum sins_unit_mode. The unit follows with the next sins_unit_update().
///
/// SINS_ERROR_INVALID_ARGUMENT: no such mode.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_select(unit: *mut sins_unit, mode: i32) -> sins_status {
    with_unit(unit, |unit| {
        unit.select(Mode::of("mode", mode)?);
        Ok(SINS_OK)
    })
}

/// Sets the supply of power, of enum sins_unit_power. The unit follows with the next sins_unit_update().
///
/// SINS_ERROR_INVALID_ARGUMENT: no such supply.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_set_power(unit: *mut sins_unit, power: i32) -> sins_status {
    with_unit(unit, |unit| {
        unit.set_power(Power::of("power", power)?);
        Ok(SINS_OK)
    })
}

/// Sets how the unit aligns, of enum sins_unit_alignment. With another kind an alignment in progress begins anew, and a unit that is ready
/// aligns again. A realignment is the same with each kind.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such kind.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_set_alignment(unit: *mut sins_unit, kind: i32) -> sins_status {
    with_unit(unit, |unit| {
        unit.set_alignment(AlignmentKind::of("kind", kind)?);
        Ok(SINS_OK)
    })
}

/// Presses the button of the panel's test: the status has SINS_UNIT_IN_TEST for power_up_test_s. Nothing else changes.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_press_test(unit: *mut sins_unit) -> sins_status {
    with_unit(unit, |unit| {
        unit.press_test();
        Ok(SINS_OK)
    })
}

/// Enters the present position: latitude, -pi/2 to pi/2 [rad], and longitude, -2 pi to 2 pi [rad]. A gyrocompass and an alignment with
/// the stored heading need it. If it is further from the stored position than position_tolerance_rad, it is not taken, and the
/// status has SINS_UNIT_REASON_POSITION_DISAGREES; the same position is taken when it is entered again.
///
/// A position holds as long as the aircraft stands within motion_distance_m, at most 10 m, of where it was entered. Beyond it the unit
/// drops it, and the status has SINS_UNIT_REASON_NO_POSITION until the new one is entered; a realignment then keeps the position of the
/// navigation.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_BAD_STATE: the unit neither aligns nor is ready.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_enter_position(
    unit: *mut sins_unit,
    latitude_rad: f64,
    longitude_rad: f64,
) -> sins_status {
    with_unit(unit, |unit| {
        unit.enter_position(latitude_rad, longitude_rad)?;
        Ok(SINS_OK)
    })
}

/// Enters the heading of the mode ATT, -2 pi to 2 pi [rad]. The gyros carry it on. They measure the rotation of the Earth and the motion
/// over it too, so the heading drifts by Omega sin(latitude) + v_east tan(latitude)/R: 13 deg/h at rest at 60 degrees, 27 deg/h with
/// 250 m/s to the east there. A magnetic heading that is entered remains one.
///
/// SINS_ERROR_INVALID_ARGUMENT: out of its range.
/// SINS_ERROR_BAD_STATE: the attitude of ATT is not valid.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_enter_heading(
    unit: *mut sins_unit,
    heading_rad: f64,
) -> sins_status {
    with_unit(unit, |unit| {
        unit.enter_heading(heading_rad)?;
        Ok(SINS_OK)
    })
}

/// Sets what the unit stored when it was last switched off. An alignment with the stored heading takes the heading for that of the aircraft
/// when the unit was switched on: latitude, -pi/2 to pi/2, longitude, -pi to pi, and true heading, 0 to 2 pi
/// [rad]. A new unit has nothing stored. sins_unit_status has what a host may keep from one session to the next.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_set_stored(
    unit: *mut sins_unit,
    latitude_rad: f64,
    longitude_rad: f64,
    heading_rad: f64,
) -> sins_status {
    with_unit(unit, |unit| {
        unit.set_stored(Some(StoredAlignment { latitude_rad, longitude_rad, heading_rad }))?;
        Ok(SINS_OK)
    })
}

/// Takes the last step of the simulator: to be called after each step that was made. The unit reads the measured increments of the
/// step, and corrects the solution of the simulator, as sins_correct() does, in three cases: an alignment ends; a realignment ends;
/// while the unit does not navigate, once a minute, so that the solution stays near the truth. Truth, modelled sensors and random
/// numbers do not change. No allocation, no system call.
///
/// docs/unit.md, "The alignment", has the equations of the alignment, of its heading error, and of the tests of motion and latitude.
/// An alignment that the test of motion stops starts anew after still_s at rest, and asks for the position if the aircraft has left its
/// place. After the first failure of the test of the latitude the position must be entered again; after the second the unit fails. A
/// gyrocompass whose heading has a standard deviation above heading_limit_rad goes on, with SINS_UNIT_REASON_NORTH_UNKNOWN. A
/// realignment of an aircraft that reaches realignment_speed_m_s loses the navigation.
///
/// Signals: an interval in which a gyro or accelerometer has no signal shows no rates, and an alignment begins anew. When the sum of
/// such intervals since the alignment began is more than fault_s, the unit fails. Until then, attitude and heading are wrong by up to the
/// rotation in them, the velocity by up to the force times their length.
///
/// If the truth jumps (sins_reposition(), sins_move_truth(), sins_reset()), an alignment or the erection of ATT starts anew, and the
/// position must be entered again. If the time does not continue from the last update (a pause that is not reported, an interval without
/// an update), it starts anew, too.
///
/// SINS_ERROR_BAD_STATE: the simulator has made no step, or the unit has taken this step already.
/// SINS_ERROR_BAD_HANDLE: sim is not a simulator.
/// The errors of sins_correct(): the simulator rejects a correction. The unit has noted the interval and tries again with the next.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_update(unit: *mut sins_unit, sim: *mut sins_sim) -> sins_status {
    with_unit(unit, |unit| {
        work_with(sim, "sim", |simulator| unit.update(simulator))??;
        Ok(SINS_OK)
    })
}

/// A fix of another sensor, such as a receiver of satellite navigation: position and velocity of the reference point of the samples.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub struct sins_unit_fix {
    /// sizeof(sins_unit_fix)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Geodetic latitude, -pi/2 to pi/2 [rad].
    pub latitude_rad: f64,
    /// Longitude, east positive, -2 pi to 2 pi [rad].
    pub longitude_rad: f64,
    /// Height above the ellipsoid, -1e5 to 1e6 [m].
    pub height_m: f64,
    /// Velocity against the Earth, east-north-up, each -1e4 to 1e4 [m/s].
    pub velocity_enu_m_s: [f64; 3],
}

interface_struct!(sins_unit_fix, "fix", 56);

/// Takes a fix at the time of the last sins_unit_update() with the same sim, for an alignment of kind SINS_UNIT_ALIGNMENT_IN_FLIGHT.
/// In every other state, and for other kinds, the call changes nothing, so a host may push each fix, for instance one a second.
/// No allocation, no system call.
///
/// Roll and pitch are shown from the second window of coarse_alignment_s on, when their standard deviation is below 0.5 deg. The
/// alignment ends with the first window behind in_flight_alignment_s at whose end the standard deviation of the heading is at most
/// in_flight_heading_rad: docs/unit.md, "The alignment in flight", has the equations. Then attitude, position, height and velocity
/// become those that the window and its last fix show, and the call corrects the solution of the simulator, as sins_correct() does.
/// Until then, after this time, the status has SINS_UNIT_REASON_TURNS_NEEDED. A unit that waits at SINS_UNIT_ALIGN aligns on. A unit
/// of this kind whose selector is turned from SINS_UNIT_NAV to SINS_UNIT_ALIGN in flight aligns again. The unit does not judge fixes:
/// a wrong one that bounds a window stays in the sum, so that the alignment ends late or never, until it is begun anew.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_BAD_HANDLE: sim is not a simulator.
/// The errors of sins_correct(): the simulator rejects the correction; the unit has not taken the fix.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_push_fix(
    unit: *mut sins_unit,
    sim: *mut sins_sim,
    fix: *const sins_unit_fix,
) -> sins_status {
    with_unit(unit, |unit| {
        // SAFETY: the host's promise.
        let fix = unsafe { read(fix, "fix")? };
        check_reserved("fix.reserved", fix.reserved)?;
        let sins_unit_fix { latitude_rad, longitude_rad, height_m, velocity_enu_m_s, .. } = fix;
        let place = Geodetic { latitude_rad, longitude_rad, height_m };
        work_with(sim, "sim", |simulator| unit.push_fix(simulator, place, velocity_enu_m_s.into()))??;
        Ok(SINS_OK)
    })
}

/// Saves the whole unit; its simulator has a snapshot of its own. written (may be NULL) gets the size. The same state gives the same
/// bytes, on every platform. No allocation, no system call.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: see SINS_UNIT_SNAPSHOT_MAX_SIZE; buffer and written are unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_snapshot_save(
    unit: *mut sins_unit,
    buffer: *mut c_void,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    with_unit(unit, |unit| {
        let save = |bytes: &mut [u8]| unit.save_snapshot(bytes);
        // SAFETY: the host's promise.
        unsafe { put_saved::<SINS_UNIT_SNAPSHOT_MAX_SIZE>(save, buffer.cast(), capacity, written) }
    })
}

/// Replaces the unit by the saved one, including its parameters. It continues to the same bits with the simulator of the same moment.
///
/// SINS_ERROR_SNAPSHOT: the bytes are not a snapshot of a unit, or are cut off, altered, or of a newer release; nothing has changed.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_unit_snapshot_load(
    unit: *mut sins_unit,
    snapshot: *const c_void,
    size: usize,
) -> sins_status {
    with_unit(unit, |unit| {
        // SAFETY: the host's promise.
        let snapshot = unsafe { bytes_of(snapshot.cast(), size, "snapshot")? };
        unit.load_snapshot(snapshot)?;
        Ok(SINS_OK)
    })
}
