//! Memory that may be missing.

use super::{Options, Simulator};
use crate::error::{Error, ErrorKind, Rule};

/// A simulator on the heap: two of them and a step are more than the stack that a call may take. A slice of one, which unlike
/// a `Box` can be allocated without aborting.
#[inline(never)]
pub(crate) fn heap_simulator(options: &Options) -> Result<Box<[Simulator]>, Error> {
    let mut memory = room(1)?;
    options.validate()?;
    memory.push(Simulator::with_valid(options));
    Ok(memory.into_boxed_slice())
}

/// Room for `count` elements, or an error.
pub(crate) fn room<T>(count: usize) -> Result<Vec<T>, Error> {
    let mut vector = Vec::new();
    vector.try_reserve_exact(count).map_err(|_| {
        let rule = Rule::Words("no memory for them");
        Error::of(ErrorKind::OutOfMemory, "elements", count as f64, rule)
    })?;
    Ok(vector)
}
