//! `sins_fault`.

use core::ffi::c_char;

use crate::abi::last_error::{SINS_ERROR_INFO_MAXIMUM, SINS_ERROR_INFO_MINIMUM, SINS_ERROR_INFO_VALUE};
use crate::abi::memory::interface_struct;
use crate::abi::text::chars;
use crate::scene::{About, Fault};

/// A fault of the text of a scene or of a flight log.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_fault {
    /// sizeof(sins_fault)
    pub struct_size: u32,
    /// Flags of enum sins_error_info_flags, or'ed: which of value, minimum and maximum there are.
    pub flags: u32,
    /// Number of faults that are reported: at most the first 200 of the text.
    pub count: u64,
    /// Line of this fault in the text of the call, from 1; 0: the fault is in a value that the scene had before the call, or in a flight
    /// record as a whole.
    pub line: u64,
    /// Column, in characters from 1. For a flight log: number of the column of the table, from 1; 1 for a flight record. 0: the same
    /// meaning as 0 in line.
    pub column: u64,
    /// The value at fault, in the unit of the key that path names.
    pub value: f64,
    /// Least allowed value, in that unit; if the sentence says "more than", the limit itself is not allowed.
    pub minimum: f64,
    /// Greatest allowed value, in that unit; if the sentence says "less than", the limit itself is not allowed.
    pub maximum: f64,
    /// Path of the value at fault, for sins_scene_get_value(). It can also be the name of a section, such as "gyro", or of an
    /// item, such as "failure[0]". Terminated. Empty for a flight log, and if the text itself is at fault.
    pub path: [c_char; 96],
    /// Sentence that names key, value and limit, and the key that was probably meant; UTF-8, terminated, cut if it is
    /// longer.
    pub sentence: [c_char; 256],
}

interface_struct!(sins_fault, "fault", 408);

impl sins_fault {
    pub(in crate::abi) fn new(fault: &Fault, count: usize) -> Self {
        let About { path, value, minimum, maximum, .. } = &fault.about;
        let flag = |number: &Option<f64>, flag| if number.is_some() { flag } else { 0 };
        Self {
            struct_size: size_of::<Self>() as u32,
            flags: flag(value, SINS_ERROR_INFO_VALUE)
                | flag(minimum, SINS_ERROR_INFO_MINIMUM)
                | flag(maximum, SINS_ERROR_INFO_MAXIMUM),
            count: count as u64,
            line: fault.line as u64,
            column: fault.column as u64,
            value: value.unwrap_or(0.0),
            minimum: minimum.unwrap_or(0.0),
            maximum: maximum.unwrap_or(0.0),
            path: chars(path),
            sentence: chars(&fault.sentence),
        }
    }
}
