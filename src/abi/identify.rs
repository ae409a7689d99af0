//! `sins_identify`: the errors of real sensors, from a record and the true path of the same motion.

mod check;
mod fields;
mod request;

pub use check::*;

use core::ffi::c_char;

use nalgebra::Vector3;

use fields::in_fields;

use super::boundary::handle::{hand_out, with_object};
use super::boundary::tables::IDENTIFIES;
use super::boundary::{enter, enter_without_simulator};
use super::choice::{check_reserved, flag};
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{Array, Output, interface_struct, read};
use super::options::sins_options;
use super::parameters::Parameters;
use super::sample::sins_flight_sample;
use super::simulator::pushed;
use super::text::{chars, put_text};
use crate::analysis::identify::text::scene;
use crate::analysis::identify::{Feed, Identified, LISTED, Listed, RecordedIncrement, Request, listed};
use crate::base::error::check_integer;
use crate::base::memory::{only, probe, room};
use crate::signal::Increment;
use crate::simulator::Options;

/// The errors of real sensors: a path and a record of the same motion, and what was found in them. A handle is a checked key, like
/// that of a sins_sim, and is never confused with one. sins_last_error(NULL, ...) on the same thread gives the failures of its functions.
#[repr(C)]
pub struct sins_identify {
    _opaque: [u8; 0],
}

/// Flags of a sins_identify_request.
pub type sins_identify_flags = u32;

/// The field shift_s holds the shift of the clock.
pub const SINS_IDENTIFY_SHIFT: sins_identify_flags = 1;
/// The states of the path are kept too, which sins_identify_check() needs: 336 bytes a sample.
pub const SINS_IDENTIFY_STATES: sins_identify_flags = 2;
/// Also finds the lever arm from the point of the path to the accelerometers. Not for sins_identify_check().
pub const SINS_IDENTIFY_LEVER_ARM: sins_identify_flags = 4;
/// Also finds the g-sensitivity of the gyros, each to the forces along all axes.
pub const SINS_IDENTIFY_G_SENSITIVITY: sins_identify_flags = 8;
/// Also finds the scale factor asymmetry of each sensor.
pub const SINS_IDENTIFY_ASYMMETRY: sins_identify_flags = 16;
/// Also finds the change of each bias with temperature. The samples of the path have the temperature, linear between those that carry
/// temperature_c; a path without any is SINS_ERROR_INVALID_ARGUMENT.
pub const SINS_IDENTIFY_TEMPERATURE: sins_identify_flags = 32;

/// What is known of sensors before their record. All zero is nothing: the widest prior, clock and axes are found.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub struct sins_identify_request {
    /// sizeof(sins_identify_request)
    pub struct_size: u32,
    /// Flags of enum sins_identify_flags, or'ed.
    pub flags: u32,
    /// Grade of the sensors, of enum sins_grade; 0: SINS_GRADE_CONSUMER, the widest. A grade that is too good moves the estimates.
    pub prior: i32,
    /// Axes of the vehicle along x, y and z of the record: 1, 2 or 3 for x, y or z, negative if reversed; all 0: they are found.
    pub axes: [i32; 3],
    /// With SINS_IDENTIFY_SHIFT: time of the path less time of the record, known to 10 s, -1e12 to 1e12 [s].
    pub shift_s: f64,
    /// Frequency above which the path lacks motion, 0.001 to 1e6 [Hz], as a smoothed path does: path and record are then compared by their
    /// means over a period of it. 0: by means over 0.2 s or more.
    pub cutoff_hz: f64,
}

interface_struct!(sins_identify_request, "request", 40);

/// An increment that real sensors measured.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_recorded_increment {
    /// sizeof(sins_recorded_increment)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// End of the interval on the clock of the record, later than that of the increment before, -1e12 to 1e12 [s].
    pub time_s: f64,
    /// Length of the interval, 1e-6 to 60 [s].
    pub interval_s: f64,
    /// Integral of the measured angular rate over the interval, along x, y, z of the record [rad].
    pub angle_rad: [f64; 3],
    /// Integral of the measured specific force over the interval, likewise [m/s].
    pub velocity_m_s: [f64; 3],
}

interface_struct!(sins_recorded_increment, "increments", 72);

/// Flags of a sins_identified and of a sins_identified_parameter.
pub type sins_identified_flags = u32;

/// The record shows it. Of the axes: the motion excludes all others. Of a parameter: the record narrows its prior to less than a half.
pub const SINS_IDENTIFIED_SEEN: sins_identified_flags = 1;

/// What was found, as a whole.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_identified {
    /// sizeof(sins_identified)
    pub struct_size: u32,
    /// Of the axes: flags of enum sins_identified_flags, or'ed.
    pub flags: u32,
    /// Number of increments of the record.
    pub increments: u64,
    /// Time of the record that was compared with the path [s].
    pub used_s: f64,
    /// Time on the clock of the record at which the parameter "clock shift" holds [s].
    pub middle_s: f64,
    /// Signals of the record are this matrix times the signals of the vehicle, row by row.
    pub rotation: [f64; 9],
    /// Attitude of the sensor block in the vehicle, as sins_mounting_params.boresight_rad [rad].
    pub boresight_rad: [f64; 3],
    /// With SINS_IDENTIFY_TEMPERATURE: the temperature at which the biases hold, the mean of the record [deg C]; otherwise 0.
    pub reference_temperature_c: f64,
}

interface_struct!(sins_identified, "identified", 136);

/// Number of parameters.
pub const SINS_IDENTIFIED_PARAMETERS: usize = 71;
const _: () = assert!(SINS_IDENTIFIED_PARAMETERS == LISTED);

/// A parameter that a record may show.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_identified_parameter {
    /// sizeof(sins_identified_parameter)
    pub struct_size: u32,
    /// Flags of enum sins_identified_flags, or'ed.
    pub flags: u32,
    /// Its name, such as "gyro bias x", terminated.
    pub name: [c_char; 48],
    /// SI unit of its figures, such as "rad/s", "1" for a ratio, terminated.
    pub unit: [c_char; 16],
    /// Mean [unit].
    pub value: f64,
    /// Lower end of its 95 % interval [unit].
    pub low: f64,
    /// Upper end of its 95 % interval [unit].
    pub high: f64,
    /// Standard deviation [unit]; 0 of noise, whose distribution is not normal.
    pub sigma: f64,
    /// Standard deviation before the record [unit]; 0 of noise.
    pub prior: f64,
    /// Without SINS_IDENTIFIED_SEEN: why the record does not show it, and what motion would, UTF-8, terminated. Otherwise empty.
    pub reason: [c_char; 192],
}

interface_struct!(sins_identified_parameter, "parameter", 304);

impl sins_recorded_increment {
    fn to_row(self) -> Result<RecordedIncrement, CallError> {
        check_reserved("increments.reserved", self.reserved)?;
        let increment =
            Increment { angle: Vector3::from(self.angle_rad), velocity: Vector3::from(self.velocity_m_s) };
        Ok(RecordedIncrement { time_s: self.time_s, interval_s: self.interval_s, increment })
    }
}

impl sins_identified {
    fn new(found: &Identified, increments: usize, options: &Options) -> Self {
        let boresight = found.boresight(options.axes);
        Self {
            struct_size: size_of::<Self>() as u32,
            flags: flag(found.axes.is_seen, SINS_IDENTIFIED_SEEN),
            increments: increments as u64,
            used_s: found.blocks as f64 * found.block_s,
            middle_s: found.middle_s,
            rotation: core::array::from_fn(|k| found.rotation[(k / 3, k % 3)]),
            boresight_rad: [boresight.roll, boresight.pitch, boresight.heading],
            reference_temperature_c: found.reference_c.unwrap_or_default(),
        }
    }
}

impl sins_identified_parameter {
    fn new(one: &Listed) -> Self {
        let Listed { name, unit, value, interval: (low, high), sigmas: (sigma, prior), reason } = one;
        Self {
            struct_size: size_of::<Self>() as u32,
            flags: flag(reason.is_none(), SINS_IDENTIFIED_SEEN),
            name: chars(name),
            unit: chars(unit),
            value: *value,
            low: *low,
            high: *high,
            sigma: *sigma,
            prior: *prior,
            reason: chars(reason.as_deref().unwrap_or_default()),
        }
    }
}

/// Runs `body` on the path and the record of a handle, as the inside of an exported function.
fn with_identify(
    identify: *const sins_identify,
    body: impl FnOnce(&mut Feed) -> Result<sins_status, CallError>,
) -> sins_status {
    with_object(&IDENTIFIES, identify, |feed| body(&mut feed[0]))
}

/// Creates an empty path and an empty record. Then push the samples of the path and the increments of the record, in any order, and
/// solve. docs/identify.md says what is found, and what a record can show. Of the options, the Earth, gravity, axes and the checks of
/// samples count. In the example a simulator stands for the real sensors. NULL for options: the defaults; NULL for request: nothing is
/// known.
///
/// Not for a real-time frame: it allocates. On an error *identify is unchanged, and sins_last_error(NULL, ...) on this thread gives the
/// reason.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range; or axes of request that are not x, y and z once each, or left-handed.
/// SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 of these handles exist.
///
/// ```c
/// int row, axis;
/// sins_identify *identify = NULL;
/// sins_identified_parameter parameter;
/// sins_recorded_increment increment;
/// sins_imu measured;
/// sins_sim *real = NULL;
/// SINS_INIT(increment);
/// SINS_INIT(measured);
/// SINS_INIT(parameter);
/// SINS_INIT(sample);
/// for (axis = 0; axis < 3; ++axis) {
///     gyro.random_walk_rad_sqrt_s[axis] = 0.001 * SINS_DEG_PER_SQRT_HOUR;
///     accel.velocity_random_walk_m_s_sqrt_s[axis] = 10.0 * SINS_MICRO_G_PER_SQRT_HZ;
/// }
/// gyro.bias_rad_s[0] = 20.0 * SINS_DEG_PER_HOUR;
/// sins_create(NULL, &real);
/// sins_set_gyro(real, &gyro);
/// sins_set_accel(real, &accel);
/// sins_identify_create(NULL, NULL, &identify);
/// for (row = 0; row < 2000; ++row) {
///     sample.time_s = 0.1 * row;
///     sins_identify_push_samples(identify, &sample, 1);
///     sins_push_sample(real, &sample);
///     if (sins_step(real) == SINS_OK && sins_get_imu(real, &measured) == SINS_OK) {
///         increment.time_s = measured.time_s;
///         increment.interval_s = measured.interval_s;
///         memcpy(increment.angle_rad, measured.measured_angle_rad, sizeof increment.angle_rad);
///         memcpy(increment.velocity_m_s, measured.measured_velocity_m_s, sizeof increment.velocity_m_s);
///         sins_identify_push_increments(identify, &increment, 1);
///     }
/// }
/// sins_identify_solve(identify, NULL);
/// sins_identify_get_parameter(identify, 5, &parameter);
/// printf("%s: %.1f deg/h\n", parameter.name, parameter.value / SINS_DEG_PER_HOUR);  // gyro bias x: 20.0 deg/h
/// sins_identify_destroy(identify);
/// sins_destroy(real);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_create(
    options: *const sins_options,
    request: *const sins_identify_request,
    identify: *mut *mut sins_identify,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        unsafe {
            hand_out(&IDENTIFIES, identify, "identify", || {
                let options = match options.is_null() {
                    true => Options::default(),
                    false => read(options, "options")?.to_parameters()?,
                };
                let (request, keeps_states) = match request.is_null() {
                    true => (Request::default(), false),
                    false => {
                        let request = read(request, "request")?;
                        (request.to_request()?, request.flags & SINS_IDENTIFY_STATES != 0)
                    }
                };
                let mut place = room(1)?;
                place.push(Feed::new(&options, &request, keeps_states)?);
                Ok(only(place)?)
            })
        }
    })
}

/// Adds the next samples of the true path, at most 100000000 in all. samples[0].struct_size is the size in bytes of each element of
/// samples; struct_size of the other samples may be 0. What perfect sensors measure along the path takes 56 bytes a sample, with
/// SINS_IDENTIFY_STATES 336 bytes, with a temperature 16 more; while the memory grows, up to twice that. Not for a real-time frame: it
/// allocates.
///
/// SINS_GAP: all samples were taken, and at least one of them ended a gap. An error of sins_push_sample() ends the call at the sample that
/// caused the error; sins_last_error(NULL, ...) names this sample. The samples before it were taken.
/// SINS_ERROR_INVALID_ARGUMENT: also a sample too many. SINS_ERROR_OUT_OF_MEMORY: no memory.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_push_samples(
    identify: *mut sins_identify,
    samples: *const sins_flight_sample,
    count: usize,
) -> sins_status {
    with_identify(identify, |feed| {
        // SAFETY: the host's promise; samples are only read.
        let samples = unsafe { Array::new(samples.cast_mut(), count, "samples")? };
        let mut status = SINS_OK;
        for index in 0..count {
            let sample = samples.read(index).and_then(sins_flight_sample::to_sample);
            let taken = sample.and_then(|sample| Ok(feed.push_sample(&sample)?));
            status = status.max(pushed(taken.map_err(|failure| failure.of_sample(index))?));
        }
        Ok(status)
    })
}

/// Adds the next increments of the record, at most 100000000 in all, each of 64 bytes. increments[0].struct_size is the size in bytes of
/// each element of increments; struct_size of the other increments may be 0. A gap between increments is permitted. Not for a
/// real-time frame: it allocates.
///
/// An error ends the call at the increment that caused it; sins_last_error(NULL, ...) names its field and its index. The increments before
/// it were taken.
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, a signal above 1e6 rad/s or 1e6 m/s2, or an increment too many.
/// SINS_ERROR_TIME_ORDER: an increment that is not later than the one before. SINS_ERROR_OUT_OF_MEMORY: no memory.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_push_increments(
    identify: *mut sins_identify,
    increments: *const sins_recorded_increment,
    count: usize,
) -> sins_status {
    with_identify(identify, |feed| {
        // SAFETY: the host's promise; increments are only read.
        let increments = unsafe { Array::new(increments.cast_mut(), count, "increments")? };
        for index in 0..count {
            let row = increments.read(index).and_then(sins_recorded_increment::to_row);
            let taken = row.and_then(|row| {
                feed.push_increment(&row).map_err(|error| {
                    let own = in_fields(error);
                    // The library checks rates, the host has their integrals.
                    let is_integral = own.index.is_some();
                    if is_integral { own.in_unit(1.0 / row.interval_s) } else { own }.into()
                })
            });
            taken.map_err(|failure| failure.of_sample(index))?;
        }
        Ok(SINS_OK)
    })
}

/// Finds the errors of the sensors in all samples and increments so far. More may be pushed afterwards, and solved again; what was found
/// stays until then. identified may be NULL. An hour takes about a second. Not for a real-time frame; the call takes up to 256 KB of stack.
///
/// SINS_ERROR_INVALID_ARGUMENT: the record does not fit the path: it is of another motion or in other units, too short, has a sensor that
/// is stuck or a clock that jumps; sins_last_error(NULL, ...) says which, with the field of the increments if it is one, and a figure of
/// its rate or force.
/// SINS_ERROR_BAD_STATE: the path has fewer than four intervals, or the fit fails without a figure. SINS_ERROR_OUT_OF_MEMORY: no memory.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_solve(
    identify: *mut sins_identify,
    identified: *mut sins_identified,
) -> sins_status {
    with_identify(identify, |feed| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::if_wanted(identified, "identified")? };
        feed.solve().map_err(in_fields)?;
        if let Some(output) = output {
            output.write(&sins_identified::new(feed.found()?, feed.increments(), feed.options()));
        }
        Ok(SINS_OK)
    })
}

/// Reads a parameter that sins_identify_solve() found. index is from 0 to SINS_IDENTIFIED_PARAMETERS - 1: shift and drift of the clock;
/// mounting x, y, z; then of the gyros: bias x, y, z, scale factor x, y, z, misalignments xy, xz, yx, yz, zx, zy, white noise x, y, z,
/// flicker x, y, z, random walk x, y, z; then the same of the accelerometers. Misalignment xy is the error of sensor x by a
/// signal along y. Last, those that a request asks for by its flags: g-sensitivities xx, xy, ... zz, asymmetries x, y, z and changes of the
/// biases with temperature x, y, z of the gyros; lever arm x, y, z, asymmetries and changes with temperature of the accelerometers. Not for
/// a real-time frame: it allocates.
///
/// SINS_ERROR_INVALID_ARGUMENT: no such parameter. SINS_ERROR_BAD_STATE: nothing was found yet. SINS_ERROR_OUT_OF_MEMORY: no memory.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_get_parameter(
    identify: *const sins_identify,
    index: usize,
    parameter: *mut sins_identified_parameter,
) -> sins_status {
    with_identify(identify, |feed| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(parameter, "parameter")? };
        check_integer("index", index, 0, LISTED as u64 - 1)?;
        let found = feed.found()?;
        probe(TEXT_BYTES)?;
        let parameters = listed(found);
        let Some(one) = parameters.get(index) else { return Err(CallError::internal()) };
        Ok(output.write(&sins_identified_parameter::new(one)))
    })
}

/// Memory for the texts of what was found.
const TEXT_BYTES: usize = 1 << 16;

/// Writes what was found as a scene, whose sensors have it; sins_scene_parse() reads it. Its vehicle is at rest: set a flight. What the
/// record does not show is a comment. buffer, capacity and needed as in sins_last_error(). Not for a real-time frame: it allocates.
///
/// SINS_ERROR_BAD_STATE: nothing was found yet. SINS_ERROR_BUFFER_TOO_SMALL: the text was cut. SINS_ERROR_OUT_OF_MEMORY: no memory.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_get_scene(
    identify: *const sins_identify,
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    with_identify(identify, |feed| {
        let found = feed.found()?;
        probe(TEXT_BYTES)?;
        let text = scene(found, feed.options().axes);
        // SAFETY: the host's promise.
        unsafe { put_text(text.as_bytes(), buffer, capacity, needed) }
    })
}

/// Destroys a path, its record and what was found.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_identify_destroy(identify: *mut sins_identify) -> sins_status {
    enter(|| IDENTIFIES.remove(identify.addr()))
}
