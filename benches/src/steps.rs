//! Flies a number of steps through `sins_run`, for an instruction counter: the difference between two numbers of steps is
//! the cost of a step. `steps WHAT COUNT`, WHAT = simulation2 | ideal | free.

mod scene;

use std::ptr::null_mut;

use sins::abi::*;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let (Some(what), Some(Ok(count))) =
        (arguments.get(1), arguments.get(2).map(|count| count.parse::<usize>()))
    else {
        eprintln!("usage: steps simulation2|ideal|free COUNT");
        std::process::exit(2);
    };
    // The same samples whatever the count: they are made outside of what is counted.
    let samples = scene::c_samples(&scene::patrol(20_001));
    let mut options = scene::c_options();
    if what != "simulation2" {
        options.error_model = SINS_ERROR_MODEL_OFF;
    }
    if what == "free" {
        options.vertical = SINS_VERTICAL_FREE;
    }
    // SAFETY: structs of their own size, as many samples as are stated.
    unsafe {
        let mut sim = null_mut();
        assert_eq!(sins_create(&options, &mut sim), SINS_OK);
        if what == "simulation2" {
            let mut gyro: sins_gyro_params = core::mem::zeroed();
            gyro.struct_size = size_of::<sins_gyro_params>() as u32;
            let mut accel: sins_accel_params = core::mem::zeroed();
            accel.struct_size = size_of::<sins_accel_params>() as u32;
            assert_eq!(sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, &mut gyro), SINS_OK);
            assert_eq!(sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, &mut accel), SINS_OK);
            assert_eq!(sins_set_gyro(sim, &gyro), SINS_OK);
            assert_eq!(sins_set_accel(sim, &accel), SINS_OK);
        }
        let count = count.min(samples.len() - 1);
        assert_eq!(sins_run(sim, samples.as_ptr(), count + 1, 0, null_mut(), 0, null_mut()), SINS_OK);
        assert_eq!(sins_destroy(sim), SINS_OK);
    }
}
