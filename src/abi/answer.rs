//! Answers of the reads: a struct, or that there is none yet.

use super::failure::{SINS_NEED_SAMPLE, SINS_OK, sins_status};
use super::memory::{Output, Struct};

/// Writes `value`, or answers that there is none yet.
pub(super) fn write_or_need<T: Struct>(output: &Output<T>, value: Option<T>) -> sins_status {
    written_or_need(value.map(|value| output.write(&value)))
}

/// The answer of a read: whether there was something to write.
pub(super) fn written_or_need(written: Option<()>) -> sins_status {
    if written.is_some() { SINS_OK } else { SINS_NEED_SAMPLE }
}
