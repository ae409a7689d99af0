//! The alignment on measured increments.

use sins::sensors::TriadParameters;
use sins::unit::{Mode, State};

use crate::aircraft::{Aircraft, Motion, papers_sensors};
use crate::support::{DEG, EARTH_RATE};

/// Standard deviation and mean of the heading error over `runs` alignments of `minutes` \[rad\].
fn heading(
    latitude_deg: f64,
    minutes: f64,
    motion: Motion,
    runs: u64,
    sensors: &(TriadParameters, TriadParameters),
) -> (f64, f64) {
    let errors: Vec<f64> = (0..runs)
        .map(|run| {
            let rate = if motion == Motion::Rest { 5.0 } else { 20.0 };
            let mut aircraft = Aircraft::new(latitude_deg, run, rate, sensors);
            let parameters = sins::unit::UnitParameters { alignment_s: 60.0 * minutes, ..Default::default() };
            aircraft.unit.set_parameters(&parameters).unwrap();
            aircraft.unit.select(Mode::Navigate);
            aircraft.go(motion, 10.0);
            aircraft.enter_true_position();
            aircraft.until(motion, State::Navigation, 60.0 * minutes + 10.0);
            aircraft.errors().misalignment_n.z
        })
        .collect();
    let mean = errors.iter().sum::<f64>() / runs as f64;
    let variance =
        errors.iter().map(|error| (error - mean) * (error - mean)).sum::<f64>() / (runs - 1) as f64;
    (variance.sqrt(), mean)
}

#[test]
fn the_heading_error_is_that_of_theory() {
    let (gyro, accel) = papers_sensors();
    for (latitude_deg, minutes) in [(0.0f64, 10.0), (40.0, 10.0), (75.0, 16.0)] {
        let horizontal = EARTH_RATE * (latitude_deg * DEG).cos();
        let (sigma, mean) = heading(latitude_deg, minutes, Motion::Rest, 400, &(gyro, accel));
        let least = gyro.random_walk.x / (horizontal * (60.0 * minutes as f64).sqrt());
        println!("{latitude_deg} deg: {} of {least} rad; mean {mean}", sigma / least);
        println!("   bias alone {}", gyro.bias.x / horizontal);
    }
}

#[test]
fn sway_does_not_spoil_it() {
    let sensors = papers_sensors();
    let (sigma, mean) = heading(40.0, 10.0, Motion::Sway, 20, &sensors);
    println!("sway: sigma {sigma}, mean {mean}");
    let (sigma, mean) = heading(40.0, 10.0, Motion::Sway, 2, &Default::default());
    println!("sway, ideal: sigma {sigma}, mean {mean}");
}
