//! Why the last call failed: a sentence for people, a struct for programs.

use core::ffi::c_char;

use super::boundary::tables::SIMULATORS;
use super::boundary::{enter, last_failure};
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{Output, interface_struct};
use super::sentence::Sentence;
use super::simulator::sins_sim;
use super::text::{chars, put_text};
use crate::base::error::Value;

/// Flags of a sins_error_info.
pub type sins_error_info_flags = u32;

/// The field value holds the value at fault.
pub const SINS_ERROR_INFO_VALUE: sins_error_info_flags = 1;
/// The field minimum holds the least allowed value.
pub const SINS_ERROR_INFO_MINIMUM: sins_error_info_flags = 2;
/// The field maximum holds the greatest allowed value.
pub const SINS_ERROR_INFO_MAXIMUM: sins_error_info_flags = 4;
/// The field is an integer.
pub const SINS_ERROR_INFO_INTEGER: sins_error_info_flags = 8;

/// Why a call failed: the data of which the sentence of sins_last_error() is made.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_error_info {
    /// sizeof(sins_error_info)
    pub struct_size: u32,
    /// Flags of enum sins_error_info_flags, or'ed.
    pub flags: u32,
    /// Status that the failed call returned, of enum sins_status_code; SINS_OK if no call failed.
    pub status: sins_status,
    /// 0
    pub reserved: u32,
    /// Name of the field or argument at fault, such as "gyro.markov_time_s", or of a computed quantity at fault, such as
    /// "navigated position error [m]"; terminated. Empty if the call itself is at fault.
    pub field: [c_char; 96],
    /// Element of the field, from 0; -1: the field is not an array, or the whole field is at fault.
    pub index: i64,
    /// Index of the sample or of the recorded increment in the array of the call, from 0; -1: none is at fault.
    pub sample: i64,
    /// With SINS_ERROR_INFO_VALUE: the value at fault, which may be NaN or infinite; for an integer, the nearest double.
    pub value: f64,
    /// With SINS_ERROR_INFO_MINIMUM: the least value. If the sentence of sins_last_error() says "more than", the limit itself
    /// is not allowed.
    pub minimum: f64,
    /// With SINS_ERROR_INFO_MAXIMUM: the greatest value. If the sentence of sins_last_error() says "less than", the limit
    /// itself is not allowed.
    pub maximum: f64,
}

interface_struct!(sins_error_info, "info", 152);

/// Copies the sentence of the last failed call on this handle. The sentence names field, value and limit; it is UTF-8 and
/// always terminated; it is "no error" if no call failed. With a NULL handle the function gives the last failed call of this
/// thread that was made without a simulator (create, presets, flights, ensembles, statistics, scenes, logs, recommend,
/// budget). A call whose handle was rejected (SINS_ERROR_BAD_HANDLE, or SINS_ERROR_BAD_STATE: see Threads) keeps no sentence, as its
/// status says why. A failure of this call or of sins_last_error_info() is not kept.
///
/// needed (may be NULL) gets the size of the whole sentence with its terminator; buffer NULL and capacity 0 ask for the
/// size only. SINS_ERROR_BUFFER_TOO_SMALL: the sentence was cut.
///
/// ```c
/// gyro.markov_sigma_rad_s[1] = 0.01 * SINS_DEG_PER_HOUR;
/// if (sins_set_gyro(sim, &gyro) < 0) {
///     sins_last_error(sim, reason, sizeof reason, NULL);
///     printf("%s\n", reason);  // gyro.markov_time_s[1] = 0: must be from 1e-9 to 1e15 where gyro.markov_sigma_rad_s is not 0
/// }
/// gyro.markov_sigma_rad_s[1] = 0.0;
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_last_error(
    sim: *const sins_sim,
    buffer: *mut c_char,
    capacity: usize,
    needed: *mut usize,
) -> sins_status {
    read_failure(sim, |_, sentence| {
        // SAFETY: the host's promise.
        unsafe { put_text(sentence.as_bytes(), buffer, capacity, needed) }
    })
}

/// Gives the same failure as sins_last_error(), as a struct.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_last_error_info(
    sim: *const sins_sim,
    info: *mut sins_error_info,
) -> sins_status {
    read_failure(sim, |failure, _| {
        // SAFETY: the host's promise.
        Ok(unsafe { Output::new(info, "info")? }.write(&sins_error_info::of(failure)))
    })
}

/// Runs `body` on the last failure of a simulator, or of this thread, and its sentence; the failure of `body` is not kept.
fn read_failure(
    sim: *const sins_sim,
    body: impl FnOnce(Option<&CallError>, &Sentence) -> Result<sins_status, CallError>,
) -> sins_status {
    enter(|| {
        let failure = match sim.is_null() {
            true => Ok(last_failure()),
            false => {
                SIMULATORS.last_failure(sim.addr()).map(|failure| (failure, Sentence::of(failure.as_ref())))
            }
        };
        match failure {
            Ok((failure, sentence)) => {
                body(failure.as_ref(), &sentence).unwrap_or_else(|failure| failure.status)
            }
            Err(status) => status,
        }
    })
}

impl sins_error_info {
    fn of(failure: Option<&CallError>) -> Self {
        let mut info = Self {
            struct_size: size_of::<Self>() as u32,
            flags: 0,
            status: SINS_OK,
            reserved: 0,
            field: [0; 96],
            index: -1,
            sample: -1,
            value: 0.0,
            minimum: 0.0,
            maximum: 0.0,
        };
        let Some(failure) = failure else { return info };
        let error = &failure.error;
        let place = |index: Option<usize>| index.map_or(-1, |index| index as i64);
        info.status = failure.status;
        info.field = chars(error.field);
        info.index = place(error.index);
        info.sample = place(failure.sample);
        if error.value.is_some_and(Value::is_integer) {
            info.flags |= SINS_ERROR_INFO_INTEGER;
        }
        let (minimum, maximum) = error.rule.limits();
        for (flag, number, field) in [
            (SINS_ERROR_INFO_VALUE, error.value.map(Value::as_f64), &mut info.value),
            (SINS_ERROR_INFO_MINIMUM, minimum, &mut info.minimum),
            (SINS_ERROR_INFO_MAXIMUM, maximum, &mut info.maximum),
        ] {
            if let Some(number) = number {
                info.flags |= flag;
                *field = number;
            }
        }
        info
    }
}
