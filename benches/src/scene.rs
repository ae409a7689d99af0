//! The scene of the benchmarks: the patrol of the paper's simulations at 100 Hz.

#[path = "../../tests/support/patrol.rs"]
mod patrol;

use sins::truth::FlightSample;
use sins::truth::flight::FlightStart;

pub const PERIOD_S: f64 = 0.01;

/// `count` samples of the patrol, in the middle of its swings.
pub fn patrol(count: usize) -> Vec<FlightSample> {
    let start = FlightStart {
        latitude_rad: 40f64.to_radians(),
        longitude_rad: 2.0,
        height_m: 8000.0,
        speed_m_s: 200.0,
        ..Default::default()
    };
    let flight = patrol::patrol_from(&start, count as f64 * PERIOD_S + 2000.0).unwrap();
    (0..count).map(|k| flight.sample_at(700.0 + k as f64 * PERIOD_S).unwrap()).collect()
}
