//! Identification of samples and increments that may not belong together: it is solved, or refused, and nothing else changes.

use std::ptr::{null, null_mut};

use sins::abi::*;

use crate::call;
use crate::host::init;
use crate::texts::written;

/// A record with the rates and the forces of `samples` in the place of those that an IMU has along them.
fn increments(samples: &[sins_flight_sample]) -> Vec<sins_recorded_increment> {
    let row = |pair: &[sins_flight_sample]| {
        let interval_s = pair[1].time_s - pair[0].time_s;
        let angle_rad = pair[1].angular_rate_rad_s.map(|rate| rate * interval_s);
        let velocity_m_s = pair[1].velocity_enu_m_s;
        sins_recorded_increment { time_s: pair[1].time_s, interval_s, angle_rad, velocity_m_s, ..init() }
    };
    samples.windows(2).map(row).collect()
}

/// Identifies a record along `samples`.
pub fn check_identify(samples: &[sins_flight_sample]) {
    let mut identify = null_mut();
    let request = sins_identify_request { flags: SINS_IDENTIFY_STATES, ..init() };
    assert_eq!(call!(sins_identify_create(null(), &request, &mut identify)), SINS_OK);
    let _ = call!(sins_identify_push_samples(identify, samples.as_ptr(), samples.len()));
    let record = increments(samples);
    let _ = call!(sins_identify_push_increments(identify, record.as_ptr(), record.len()));
    let is_solved = call!(sins_identify_solve(identify, null_mut())) == SINS_OK;
    for index in 0..SINS_IDENTIFIED_PARAMETERS {
        let mut parameter = init::<sins_identified_parameter>();
        let status = call!(sins_identify_get_parameter(identify, index, &mut parameter));
        assert_eq!(status, if is_solved { SINS_OK } else { SINS_ERROR_BAD_STATE });
        let numbers = [parameter.value, parameter.low, parameter.high, parameter.sigma, parameter.prior];
        assert!(numbers.iter().all(|number| number.is_finite()), "{parameter:?}");
    }
    let text = written(|buffer, capacity, needed| {
        call!(sins_identify_get_scene(identify, buffer, capacity, needed))
    });
    assert_eq!(text.is_some(), is_solved);
    let of_check = sins_identify_check_request { twins: 40, ..init() };
    let mut checked = init::<sins_identified_check>();
    let is_checked = call!(sins_identify_check(identify, &of_check, &mut checked)) == SINS_OK;
    for index in 0..if is_checked { checked.spans } else { 1 } {
        let mut span = init::<sins_identified_span>();
        let status = call!(sins_identify_get_span(identify, index as usize, &mut span));
        assert_eq!(status, if is_checked { SINS_OK } else { SINS_ERROR_BAD_STATE });
        assert!(span.real_m.is_finite() && span.predicted_m.is_finite(), "{span:?}");
    }
    assert_eq!(call!(sins_identify_destroy(identify)), SINS_OK);
}
