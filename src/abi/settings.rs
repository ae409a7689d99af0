//! The structs of the tables of parameters, and how a simulator takes and gives them: `sins_gyro_params` and so on.

use core::slice::{from_mut, from_ref};

use super::choice::choices;
use super::failure::{SINS_OK, sins_status};
use super::memory::{Output, read};
use super::parameters::{Parameters, params};
use super::simulator::{sins_sim, with_simulator};
use crate::base::error::Error;
use crate::base::rows::copy;
use crate::sensors::{
    Alignment, AltimeterParameters, GravityDisturbanceParameters, InitialErrorParameters, PARAMETERS,
    TriadParameters,
};
use crate::signal::mounting::MountingParameters;
use crate::simulator::Simulator;
use crate::unit::UnitParameters;

/// Sets parameters of a simulator.
///
/// # Safety
/// As the exported functions: `params` is null or points to a struct.
unsafe fn set<P: Parameters>(
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
unsafe fn get<P: Parameters>(
    sim: *mut sins_sim,
    params: *mut P,
    name: &'static str,
    get: fn(&Simulator) -> &P::Own,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: as this function.
        Ok(unsafe { Output::new(params, name)? }.write(&P::from_parameters(get(simulator))))
    })
}

const COUNT: usize = PARAMETERS.len();

// The structs of the tables, with their setters and getters.
include!(concat!(env!("OUT_DIR"), "/sensor_params.rs"));
include!(concat!(env!("OUT_DIR"), "/altimeter_params.rs"));
include!(concat!(env!("OUT_DIR"), "/sins_alignment.rs"));
include!(concat!(env!("OUT_DIR"), "/initial_params.rs"));
include!(concat!(env!("OUT_DIR"), "/mounting_params.rs"));
include!(concat!(env!("OUT_DIR"), "/gravity_params.rs"));
include!(concat!(env!("OUT_DIR"), "/unit_params.rs"));

// The first release has all of the sensors.
params!(sins_gyro_params, "gyro", size_of::<sins_gyro_params>(), TriadParameters, copy_triad);
params!(sins_accel_params, "accel", size_of::<sins_accel_params>(), TriadParameters, copy_triad);
params!(sins_altimeter_params, "altimeter", 56, AltimeterParameters, copy);
params!(sins_initial_errors, "initial", 168, InitialErrorParameters, copy, alignment: alignment);
params!(sins_mounting, "mounting", 104, MountingParameters, copy);
params!(sins_gravity_params, "gravity", 80, GravityDisturbanceParameters, copy);
params!(sins_unit_params, "unit", 200, UnitParameters, copy);

/// Copies the numbers of each parameter that both sides have; matrices are row by row on one side, column by column on the other.
fn copy_triad(from: [&[f64]; COUNT], to: [&mut [f64]; COUNT]) {
    for ((parameter, from), to) in PARAMETERS.iter().zip(from).zip(to) {
        if from.len() == to.len() {
            (0..from.len()).for_each(|index| to[parameter.shape.place(index)] = from[index]);
        }
    }
}
