//! `sins_gyro_params` and `sins_accel_params`, which `build` writes from `src/sensors/table.rs`.

use core::slice::{from_mut, from_ref};

use super::parameters::params;
use crate::sensors::{PARAMETERS, TriadParameters};

const COUNT: usize = PARAMETERS.len();

include!(concat!(env!("OUT_DIR"), "/sensor_params.rs"));

// The first release has all of it.
params!(sins_gyro_params, "gyro", size_of::<sins_gyro_params>(), TriadParameters, copy);
params!(sins_accel_params, "accel", size_of::<sins_accel_params>(), TriadParameters, copy);

/// Copies the numbers of each parameter that both sides have; matrices are row by row on one side, column by column on the other.
fn copy(from: [&[f64]; COUNT], to: [&mut [f64]; COUNT]) {
    for ((parameter, from), to) in PARAMETERS.iter().zip(from).zip(to) {
        if from.len() == to.len() {
            (0..from.len()).for_each(|index| to[parameter.shape.place(index)] = from[index]);
        }
    }
}
