//! The scene as the C interface has it.

use sins::abi::{sins_flight_sample, sins_options};
use sins::truth::FlightSample;

use crate::scene::PERIOD_S;

/// Samples as the C interface has them.
pub fn c_samples(samples: &[FlightSample]) -> Vec<sins_flight_sample> {
    samples
        .iter()
        .map(|sample| sins_flight_sample {
            struct_size: size_of::<sins_flight_sample>() as u32,
            flags: 0,
            time_s: sample.time_s,
            latitude_rad: sample.place.latitude_rad,
            longitude_rad: sample.place.longitude_rad,
            height_m: sample.place.height_m,
            velocity_enu_m_s: sample.v_n.unwrap_or_default().into(),
            roll_rad: sample.euler.roll,
            pitch_rad: sample.euler.pitch,
            heading_rad: sample.euler.heading,
            angular_rate_rad_s: [0.0; 3],
            specific_force_m_s2: [0.0; 3],
            temperature_c: 0.0,
        })
        .collect()
}

/// Options of the C interface with the error model and the stated period.
pub fn c_options() -> sins_options {
    // SAFETY: integers and floating-point numbers alone; zero is the recommended simulator.
    let mut options: sins_options = unsafe { core::mem::zeroed() };
    options.struct_size = size_of::<sins_options>() as u32;
    options.error_model = sins::abi::SINS_ERROR_MODEL_RK4;
    options.sample_period_s = PERIOD_S;
    options
}
