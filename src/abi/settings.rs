//! How a simulator takes its parameters and gives them back.

use super::failure::{SINS_OK, sins_status};
use super::memory::{Output, read};
use super::parameters::Parameters;
use super::simulator::{sins_sim, with_simulator};
use crate::error::Error;
use crate::simulator::Simulator;

/// Sets parameters of a simulator.
///
/// # Safety
/// As the exported functions: `params` is null or points to a struct.
pub(super) unsafe fn set<P: Parameters>(
    sim: *mut sins_sim,
    params: *const P,
    name: &'static str,
    set: fn(&mut Simulator, &P::Own) -> Result<(), Error>,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: as this function.
        set(simulator, &unsafe { read(params, name)? }.to_parameters()?)?;
        Ok(SINS_OK)
    })
}

/// Reads parameters of a simulator.
///
/// # Safety
/// As the exported functions: `params` is null or points to a struct that may be written.
pub(super) unsafe fn get<P: Parameters>(
    sim: *mut sins_sim,
    params: *mut P,
    name: &'static str,
    get: fn(&Simulator) -> &P::Own,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: as this function.
        unsafe { Output::new(params, name)? }.write(&P::from_parameters(get(simulator)));
        Ok(SINS_OK)
    })
}
