//! Status codes with their names, and what a handle remembers of a failed call.

use core::ffi::{CStr, c_char};
use core::fmt;

use crate::base::error::{Error, ErrorKind, Rule};

/// Result of a call: SINS_OK is 0, a negative status is an error, a positive status is neither. After an error nothing has
/// changed, with the exceptions under Statuses.
pub type sins_status = i32;

/// Values of a sins_status: 0 is success, a negative status is an error, a positive status is neither.
pub type sins_status_code = i32;

/// The call did what it says.
pub const SINS_OK: sins_status_code = 0;
/// There is no sample yet, or no complete interval: push the next sample.
pub const SINS_NEED_SAMPLE: sins_status_code = 1;
/// sins_recommend(): no options meet the requirement. The outputs hold the options that come closest.
pub const SINS_REQUIREMENT_NOT_MET: sins_status_code = 2;
/// The text of a scene has faults. The handle was made, but only sins_scene_get_fault() and sins_scene_destroy() accept it.
pub const SINS_SCENE_HAS_FAULTS: sins_status_code = 3;
/// The sample was accepted, or all samples of the run were flown, but there is a gap: an interval of more than 2.5 times
/// each of the two before it. The library assumes that the vehicle moved during the gap: 213 m in 1 s at 213 m/s. If the
/// vehicle stood still while the host's clock ran on, this is wrong: see sins_move_time().
pub const SINS_GAP: sins_status_code = 4;
/// sins_play_next(), sins_play_run(): the scene has no further sample. Nothing was flown, or all of it.
pub const SINS_PLAY_END: sins_status_code = 5;
/// A pointer is null where null is not allowed.
pub const SINS_ERROR_NULL_POINTER: sins_status_code = -1;
/// The handle is null, made up, destroyed, or of another kind.
pub const SINS_ERROR_BAD_HANDLE: sins_status_code = -2;
/// A struct_size that no release knows, or a struct of a newer release that sets a field which this release lacks.
pub const SINS_ERROR_STRUCT_SIZE: sins_status_code = -3;
/// A value out of its range; sins_last_error() names field, value and limit.
pub const SINS_ERROR_INVALID_ARGUMENT: sins_status_code = -4;
/// A call at the wrong moment, a nested call, or a call on a handle that an abandoned call holds (see Threads).
pub const SINS_ERROR_BAD_STATE: sins_status_code = -5;
/// A sample that is not later than the one before, or off the stated sample period.
pub const SINS_ERROR_TIME_ORDER: sins_status_code = -6;
/// The truth jumped: a gap of more than max_gap_s, a jump of position, velocity or attitude, or a turn of 170 degrees or more
/// between two samples. See sins_move_truth().
pub const SINS_ERROR_DISCONTINUITY: sins_status_code = -7;
/// The queue of samples is full: step first.
pub const SINS_ERROR_QUEUE_FULL: sins_status_code = -8;
/// The solution diverged: it left its limits. The last good solution of a simulator stays readable; that of a run of an
/// ensemble does not.
pub const SINS_ERROR_DIVERGED: sins_status_code = -9;
/// Too close to a pole: the mechanization in geographic axes, or within 64 km an alignment by gyrocompassing.
pub const SINS_ERROR_SINGULAR: sins_status_code = -10;
/// A buffer is too small for the result.
pub const SINS_ERROR_BUFFER_TOO_SMALL: sins_status_code = -11;
/// No memory, or no free handle; on Windows too few TLS indexes (see Unloading).
pub const SINS_ERROR_OUT_OF_MEMORY: sins_status_code = -12;
/// The bytes are not a snapshot, or are one that is damaged or of a newer release.
pub const SINS_ERROR_SNAPSHOT: sins_status_code = -13;
/// A defect inside the library was caught. Each handle that the call could have changed returns this status from now on. Other handles
/// still work, also a simulator that the call only reads, such as the template of sins_ensemble_create().
pub const SINS_ERROR_INTERNAL: sins_status_code = -99;

/// Returns the name of a status code, such as "SINS_OK", or "unknown status" for any other number. The text lives as long
/// as the library is loaded.
#[unsafe(no_mangle)]
pub extern "C-unwind" fn sins_status_string(status: sins_status) -> *const c_char {
    name(status).as_ptr()
}

include!(concat!(env!("OUT_DIR"), "/status_names.rs"));

/// A status with its sentence, as plain data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CallError {
    pub status: sins_status,
    pub error: Error,
    /// Index of the sample or of the increment in an array that it concerns.
    pub sample: Option<usize>,
}

impl CallError {
    fn words(status: sins_status, field: &'static str, words: &'static str) -> Self {
        let error = Error {
            kind: ErrorKind::InvalidArgument,
            field,
            index: None,
            value: None,
            rule: Rule::Sentence(words),
        };
        Self { status, error, sample: None }
    }

    pub fn null(name: &'static str) -> Self {
        Self::words(SINS_ERROR_NULL_POINTER, name, "must not be null")
    }

    pub fn bad_handle(name: &'static str) -> Self {
        Self::words(SINS_ERROR_BAD_HANDLE, name, "is null, made up, destroyed, or of another kind")
    }

    /// The failure of a handle that is the argument `name` and was rejected with `status`.
    pub fn of_handle(status: sins_status, name: &'static str) -> Self {
        match status {
            SINS_ERROR_BAD_HANDLE => Self::bad_handle(name),
            SINS_ERROR_INTERNAL => Self::words(
                status,
                name,
                "a defect inside the library, in this call or an earlier one; destroy the handle if it keeps failing",
            ),
            _ => Self::words(
                status,
                name,
                "is in use in a call of this thread, or held for ever by a call that never returns",
            ),
        }
    }

    pub fn no_handle() -> Self {
        Self::words(SINS_ERROR_OUT_OF_MEMORY, "", "no handle is free: at most 4096 of a kind can exist")
    }

    pub fn no_thread_locals() -> Self {
        Self::words(
            SINS_ERROR_OUT_OF_MEMORY,
            "",
            "no memory, or too few TLS indexes, for the data that the library keeps for a thread",
        )
    }

    pub fn internal() -> Self {
        Self::words(SINS_ERROR_INTERNAL, "", "a defect inside the library; destroy this handle")
    }

    pub fn struct_size(name: &'static str, size: usize, rule: Rule) -> Self {
        let error = Error::invalid(name, size, rule);
        Self { status: SINS_ERROR_STRUCT_SIZE, error, sample: None }
    }

    pub fn buffer(name: &'static str, capacity: usize, needed: usize) -> Self {
        let rule = Rule::AtLeast("is too small; needed:", needed.into());
        Self {
            status: SINS_ERROR_BUFFER_TOO_SMALL,
            error: Error::invalid(name, capacity, rule),
            sample: None,
        }
    }

    /// Adds to the failure that element `index` of the array is at fault.
    pub fn of_element(self, index: usize) -> Self {
        Self { error: self.error.at(index), ..self }
    }

    /// Adds to the failure that it concerns sample or increment `index` of an array.
    pub fn of_sample(self, index: usize) -> Self {
        Self { sample: Some(index), ..self }
    }
}

impl From<Error> for CallError {
    fn from(error: Error) -> Self {
        let status = match error.kind {
            ErrorKind::InvalidArgument => SINS_ERROR_INVALID_ARGUMENT,
            ErrorKind::BadState => SINS_ERROR_BAD_STATE,
            ErrorKind::TimeOrder => SINS_ERROR_TIME_ORDER,
            ErrorKind::Discontinuity => SINS_ERROR_DISCONTINUITY,
            ErrorKind::QueueFull => SINS_ERROR_QUEUE_FULL,
            ErrorKind::Diverged => SINS_ERROR_DIVERGED,
            ErrorKind::Singular => SINS_ERROR_SINGULAR,
            ErrorKind::OutOfMemory => SINS_ERROR_OUT_OF_MEMORY,
            ErrorKind::Snapshot => SINS_ERROR_SNAPSHOT,
            ErrorKind::BufferTooSmall => SINS_ERROR_BUFFER_TOO_SMALL,
        };
        Self { status, error, sample: None }
    }
}

impl fmt::Display for CallError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.error, f)?;
        let Error { field, kind, value, rule, .. } = self.error;
        match (field, kind, value) {
            ("sample.time_s", ErrorKind::Discontinuity, _) => f.write_str(match rule {
                Rule::GapWithJump(..) => "; after a jump call sins_move_truth()",
                _ => "; after a pause call sins_move_time(); samples that were rejected in the gap said why",
            })?,
            ("sample.temperature_c", _, None) => {
                f.write_str("; set SINS_SAMPLE_TEMPERATURE in sample.flags")?
            }
            _ => {}
        }
        match self.sample {
            Some(index) if field.starts_with("increments") => write!(f, " (increments[{index}])"),
            Some(index) => write!(f, " (samples[{index}])"),
            None => Ok(()),
        }
    }
}
