//! Simulators on the heap.

use super::read::READ_WIDTH;
use super::signals::Signals;
use super::{Options, Simulator};
use crate::covariance::Propagation;
use crate::error::Error;
use crate::instruction_set::InstructionSet;
use crate::memory::{only, room};

/// A simulator on the heap, because two simulators and a step need more stack than a call may take.
#[inline(never)]
pub(crate) fn heap_simulator(options: &Options) -> Result<Box<[Simulator; 1]>, Error> {
    // The instruction set of the processor is queried now, not by the first read.
    InstructionSet::up_to(READ_WIDTH);
    let mut memory = room(1)?;
    let (intake, signals) = (Simulator::intake(options)?, Signals::new()?);
    let covariance = Propagation::new(options.covariance, options.earth(), options.vertical)?;
    memory.push(Simulator::with(options, intake, signals, covariance));
    only(memory)
}
