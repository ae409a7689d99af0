//! Answers of the reads: a struct, or that there is none yet.

use core::mem::MaybeUninit;

use super::failure::{CallError, SINS_NEED_SAMPLE, SINS_OK, sins_status};
use super::memory::{Output, Struct};
use crate::simulator::{Simulator, View};

/// Writes `value`, or answers that there is none yet.
pub(super) fn write_or_need<T: Struct>(output: &Output<T>, value: Option<T>) -> sins_status {
    value.map_or(SINS_NEED_SAMPLE, |value| output.write(&value))
}

/// Fills the struct with what `V` reads of this moment, or answers that there is no moment yet.
#[inline(always)]
pub(super) fn fill_or_need<V: View<Struct: Struct>>(
    simulator: &mut Simulator,
    output: &Output<V::Struct>,
) -> Result<sins_status, CallError> {
    let mut own = MaybeUninit::uninit();
    let place = output.place(&mut own);
    if !simulator.fill::<V>(place)? {
        return Ok(SINS_NEED_SAMPLE);
    }
    output.finish(place);
    Ok(SINS_OK)
}
