//! A defect on demand, for `tests/c/panic.c`: in builds with `--cfg sins_fault_injection` alone, and not in the header.

use super::boundary::enter_without_simulator;
use super::failure::sins_status;
use super::simulator::{sins_sim, step, with_simulator};

/// Steps `sim`, then panics while it is still in use; a null `sim`: panics in a call that has no simulator.
#[unsafe(no_mangle)]
#[allow(clippy::panic, reason = "that is what it is for")]
pub unsafe extern "C-unwind" fn sins_inject_panic(sim: *mut sins_sim) -> sins_status {
    if sim.is_null() {
        return enter_without_simulator(|| panic!("injected"));
    }
    with_simulator(sim, |simulator| {
        step(simulator)?;
        panic!("injected")
    })
}
