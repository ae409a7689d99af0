//! The C function gives the same answer.

use nalgebra::Vector3;
use sins::abi::{
    SINS_BUDGET_CAN_BE_LEFT_OUT, SINS_BUDGET_RANDOM, SINS_ERROR_BUFFER_TOO_SMALL, SINS_OK, sins_budget,
    sins_budget_request, sins_budget_row, sins_create, sins_destroy, sins_error_budget, sins_flight_sample,
    sins_gyro_params, sins_options, sins_set_gyro, sins_status,
};
use sins::analysis::budget::ErrorParameters;
use sins::truth::FlightSample;

use super::{limits, triad, turning};
use crate::support::budget::budget_of;
use crate::support::options_at;

/// Rows and summary of the C function with `capacity` rows of room.
fn through_the_interface(
    samples: &[FlightSample],
    gyro: &sins_gyro_params,
    request: &sins_budget_request,
    capacity: usize,
) -> (sins_status, usize, Vec<sins_budget_row>, sins_budget) {
    let samples: Vec<sins_flight_sample> = samples.iter().map(Into::into).collect();
    // SAFETY: structs of numbers; the pointers are those of locals.
    unsafe {
        let (mut options, mut budget): (sins_options, sins_budget) = std::mem::zeroed();
        options.struct_size = size_of::<sins_options>() as u32;
        options.sample_period_s = 0.02;
        options.vertical = sins::abi::SINS_VERTICAL_FOLLOW_TRUTH;
        budget.struct_size = size_of::<sins_budget>() as u32;
        let mut rows = vec![std::mem::zeroed::<sins_budget_row>(); capacity];
        if let Some(first) = rows.first_mut() {
            first.struct_size = size_of::<sins_budget_row>() as u32;
        }
        let mut written = 77;
        let mut sim = std::ptr::null_mut();
        assert_eq!(sins_create(&options, &mut sim), SINS_OK);
        assert_eq!(sins_set_gyro(sim, gyro), SINS_OK);
        let status = sins_error_budget(
            sim,
            samples.as_ptr(),
            samples.len(),
            request,
            if capacity == 0 { std::ptr::null_mut() } else { rows.as_mut_ptr() },
            capacity,
            &mut written,
            &mut budget,
        );
        assert_eq!(sins_destroy(sim), SINS_OK);
        (status, written, rows, budget)
    }
}

fn text(bytes: &[std::ffi::c_char]) -> String {
    let bytes: Vec<u8> = bytes.iter().take_while(|byte| **byte != 0).map(|byte| *byte as u8).collect();
    String::from_utf8(bytes).unwrap()
}

#[test]
fn the_interface_has_the_same_answer() {
    let samples = &turning()[..300];
    let parameters = ErrorParameters {
        gyro: triad(|gyro| {
            gyro.bias.x = 1e-5;
            gyro.ramp.x = 1e-9;
            gyro.random_walk = Vector3::repeat(1e-4);
        }),
        ..Default::default()
    };
    // SAFETY: a struct of numbers.
    let mut gyro: sins_gyro_params = unsafe { std::mem::zeroed() };
    gyro.struct_size = size_of::<sins_gyro_params>() as u32;
    gyro.bias_rad_s[0] = 1e-5;
    gyro.rate_ramp_rad_s2[0] = 1e-9;
    gyro.random_walk_rad_sqrt_s = [1e-4; 3];
    let request = sins_budget_request {
        struct_size: size_of::<sins_budget_request>() as u32,
        time_steps: 1,
        runs: 0,
        position_m: 0.0,
        velocity_m_s: 0.0,
        attitude_rad: 1e-5,
    };
    for capacity in [0, 3] {
        let (status, written, rows, budget) = through_the_interface(samples, &gyro, &request, capacity);
        assert_eq!((status, written, budget.runs), (SINS_ERROR_BUFFER_TOO_SMALL, 4, 0));
        assert!(rows.iter().all(|row| row.position_m == 0.0));
    }
    let (status, written, rows, budget) = through_the_interface(samples, &gyro, &request, 6);
    assert_eq!((status, written, budget.runs), (SINS_OK, 4, 16));
    let expected = budget_of(&options_at(50.0), samples, &parameters, &limits(0.0, 0.0, 1e-5));
    assert_eq!((text(&rows[0].effect), text(&rows[0].field)), ("mechanization".into(), String::new()));
    assert_eq!(rows[0].position_m, expected.own.0.position_m);
    for (found, row) in rows[1..4].iter().zip(&expected.rows) {
        assert_eq!(
            (text(&found.effect), text(&found.field)),
            (row.effect.name.into(), row.effect.field.into())
        );
        assert_eq!((found.position_m, found.end_velocity_m_s), (row.worst.position_m, row.end.velocity_m_s));
        assert_eq!((found.attitude_rad, found.share), (row.worst.attitude_rad, row.share));
        assert_eq!(found.flags & SINS_BUDGET_RANDOM != 0, row.effect.is_random);
        assert_eq!(found.flags & SINS_BUDGET_CAN_BE_LEFT_OUT != 0, row.can_be_left_out);
        assert_eq!(found.struct_size as usize, size_of::<sins_budget_row>());
    }
    assert!(rows[1..4].iter().any(|row| row.flags & SINS_BUDGET_CAN_BE_LEFT_OUT != 0));
    assert_eq!(rows[4].struct_size, 0, "nothing behind what was told");
    assert_eq!((budget.position_m, budget.flights), (expected.total.position_m, expected.flights));
    assert_eq!(budget.remainder_attitude_rad, expected.remainder.attitude_rad);
    assert_eq!(budget.left_out_attitude_rad, expected.left_out.attitude_rad);
    assert!(budget.ns_per_step > 0.0 && rows[0].ns_per_step > 0.0);

    let untimed = sins_budget_request { time_steps: 0, ..request };
    let (status, _, rows, budget) = through_the_interface(samples, &gyro, &untimed, 6);
    assert_eq!((status, budget.ns_per_step, budget.flights), (SINS_OK, 0.0, expected.flights));
    assert!(rows[..4].iter().all(|row| row.ns_per_step == 0.0));
}
