//! `sins_fault`.

use core::ffi::c_char;

use super::memory::interface_struct;
use super::text::chars;
use crate::scene::Fault;

/// A fault of the text of a scene or of a flight log.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_fault {
    /// sizeof(sins_fault)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Number of faults of the text, 200 at most.
    pub count: u64,
    /// Line of this fault, from 1.
    pub line: u64,
    /// Column, in characters from 1; for a flight log, the column of the table.
    pub column: u64,
    /// Sentence that names key, value and limit, and the key that was probably meant; UTF-8, terminated, cut if it is
    /// longer.
    pub sentence: [c_char; 256],
}

interface_struct!(sins_fault, "fault", 288);

impl sins_fault {
    pub(super) fn new(fault: &Fault, count: usize) -> Self {
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            count: count as u64,
            line: fault.line as u64,
            column: fault.column as u64,
            sentence: chars(&fault.sentence),
        }
    }
}
