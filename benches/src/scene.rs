//! The scene of the benchmarks: the patrol of the paper's simulations at 100 Hz.

use sins::flight::{Channel, Flight, FlightStart, Manoeuvre, Sinusoid};
use sins::truth::FlightSample;

pub const PERIOD_S: f64 = 0.01;

/// `count` samples of the patrol, in the middle of its swings.
pub fn patrol(count: usize) -> Vec<FlightSample> {
    let term = |channel, amplitude, period_s: f64| Sinusoid {
        channel,
        amplitude,
        frequency_hz: 1.0 / period_s,
        phase_rad: 0.0,
    };
    let terms = [
        term(Channel::Course, 2.404_825_557_695_773, 560.0),
        term(Channel::Climb, 0.02, 217.0),
        term(Channel::Speed, 5.0, 143.0),
        term(Channel::Roll, 0.004, 3.1),
        term(Channel::Pitch, 0.002, 2.3),
        term(Channel::Heading, 0.002, 4.7),
    ];
    let start = FlightStart {
        latitude_rad: 40f64.to_radians(),
        longitude_rad: 2.0,
        height_m: 8000.0,
        speed_m_s: 200.0,
        ..Default::default()
    };
    let duration_s = count as f64 * PERIOD_S + 2000.0;
    let patrol = [Manoeuvre::Sinusoids { duration_s, ramp_s: 600.0, terms, count: 6 }];
    let flight = Flight::new(&start, &patrol).unwrap();
    (0..count).map(|k| flight.sample_at(700.0 + k as f64 * PERIOD_S).unwrap()).collect()
}
