//! `sins_gyro_params` and `sins_accel_params`, which `build` writes from `src/sensors/table.rs`.

use core::slice::{from_mut, from_ref};

use super::choice::check_reserved;
use super::failure::Failure;
use super::memory::interface_struct;
use super::parameters::Parameters;
use crate::sensors::{PARAMETERS, TriadParameters};

const COUNT: usize = PARAMETERS.len();

include!(concat!(env!("OUT_DIR"), "/sensor_params.rs"));

/// Declares a struct with its name in messages, and makes parameters of it and back.
macro_rules! sensor_params {
    ($type:ident, $name:literal) => {
        // The first release has all of it.
        interface_struct!($type, $name, size_of::<$type>());

        impl Parameters for $type {
            type Own = TriadParameters;

            fn to_parameters(self) -> Result<TriadParameters, Failure> {
                check_reserved(concat!($name, ".reserved"), self.reserved)?;
                let mut parameters = TriadParameters::default();
                copy(self.numbers(), parameters.numbers_mut());
                Ok(parameters)
            }

            fn from_parameters(parameters: &TriadParameters) -> Self {
                let mut params = Self { struct_size: size_of::<Self>() as u32, ..Self::default() };
                copy(parameters.numbers(), params.numbers_mut());
                params
            }
        }
    };
}
sensor_params!(sins_gyro_params, "gyro");
sensor_params!(sins_accel_params, "accel");

/// Copies the numbers of each parameter that both sides have; matrices are row by row on one side, column by column on the other.
fn copy(from: [&[f64]; COUNT], to: [&mut [f64]; COUNT]) {
    for ((parameter, from), to) in PARAMETERS.iter().zip(from).zip(to) {
        if from.len() == to.len() {
            (0..from.len()).for_each(|index| to[parameter.shape.place(index)] = from[index]);
        }
    }
}
