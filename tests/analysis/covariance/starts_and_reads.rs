//! The effect of starts, reads, slews and resets on the covariance.

use nalgebra::Vector3;
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::signal::mounting::MountingParameters;
use sins::{Options, Simulator};

use crate::support;

fn drawn() -> (TriadParameters, InitialErrorParameters) {
    let gyro = TriadParameters {
        bias_sigma: Vector3::repeat(1e-7),
        rate_random_walk: Vector3::repeat(1e-9),
        ..Default::default()
    };
    let initial = InitialErrorParameters {
        position_sigma_n: Vector3::new(3.0, 4.0, 5.0),
        velocity_sigma_n: Vector3::new(0.1, 0.2, 0.3),
        misalignment_sigma_n: Vector3::new(1e-4, 2e-4, 3e-4),
        ..Default::default()
    };
    (gyro, initial)
}

fn patrolling(options: &Options) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    let (gyro, initial) = drawn();
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_initial_errors(&initial).unwrap();
    simulator
}

fn sigma(simulator: &mut Simulator) -> [f64; 9] {
    simulator.covariance().unwrap().unwrap().1.sigma()
}

/// Before the first step the covariance is that of the start. A read changes nothing. Other outputs have the same bits without it.
#[test]
fn it_begins_as_the_start_and_changes_nothing() {
    let flight = support::patrol(60.0);
    let sample = |k: u32| flight.sample_at(0.01 * f64::from(k)).unwrap();
    let options = Options { error_model: true, ..Options::default() };
    let mut without = patrolling(&options);
    assert_eq!(without.covariance().unwrap_err().kind, sins::ErrorKind::BadState);
    let mut with = patrolling(&Options { covariance: true, ..options });
    let mut unread = patrolling(&Options { covariance: true, ..options });
    assert_eq!(with.covariance().unwrap(), None);
    for k in 0..=1234 {
        for simulator in [&mut with, &mut without, &mut unread] {
            simulator.push_sample(&sample(k)).unwrap();
        }
        if k == 0 {
            let expected = [3.0, 4.0, 5.0, 0.1, 0.2, 0.3, 1e-4, 2e-4, 3e-4];
            for (found, expected) in sigma(&mut with).into_iter().zip(expected) {
                // Rotations to and from Earth-fixed axes, of 1e2 m/s by the lean of 1e-6 rad.
                assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
            }
        }
        for simulator in [&mut with, &mut without, &mut unread] {
            simulator.step().unwrap();
        }
        sigma(&mut with);
    }
    assert_eq!(support::bits(&with), support::bits(&without));
    assert_eq!(with.covariance(), unread.covariance());
    // All nine errors are random here: each sigma is above zero.
    assert!(sigma(&mut with).iter().all(|sigma| *sigma > 0.0));
}

/// A slew keeps the standard deviations. A reposition starts anew, with walks that continue. A reset restarts the walks too.
#[test]
fn slews_keep_it_and_starts_begin_it_anew() {
    let flight = support::patrol(60.0);
    let options = Options { covariance: true, ..Options::default() };
    let mut simulator = patrolling(&options);
    for k in 0..=2050 {
        simulator.push_sample(&flight.sample_at(0.01 * f64::from(k)).unwrap()).unwrap();
        simulator.step().unwrap();
    }
    let before = sigma(&mut simulator);
    let mut elsewhere = flight.sample_at(20.5).unwrap();
    (elsewhere.place.latitude_rad, elsewhere.place.longitude_rad) = (-0.3, 2.0);
    simulator.move_truth(&elsewhere).unwrap();
    for (before, after) in before.into_iter().zip(sigma(&mut simulator)) {
        assert!((after / before - 1.0).abs() < 1e-9, "{before} {after}");
    }
    simulator.reposition(&elsewhere).unwrap();
    assert!((sigma(&mut simulator)[0] / 3.0 - 1.0).abs() < 1e-12);
    simulator.reset();
    for k in 0..=2050 {
        simulator.push_sample(&flight.sample_at(0.01 * f64::from(k)).unwrap()).unwrap();
        simulator.step().unwrap();
    }
    assert_eq!(sigma(&mut simulator), before);
}

/// The velocity of the reference point contains the gyros' errors times the lever arm from the first step on. Before it the INS has
/// no rate.
#[test]
fn a_lever_arm_counts_from_the_first_step_on() {
    let lever_arm_m = Vector3::new(0.0, 10.0, 0.0);
    let mut simulator = patrolling(&Options { covariance: true, ..Options::default() });
    simulator.set_mounting(&MountingParameters { lever_arm_m, ..Default::default() }).unwrap();
    let bias_sigma = Vector3::new(0.0, 0.0, 0.1);
    simulator.set_gyro(&TriadParameters { bias_sigma, ..Default::default() }).unwrap();
    let at_rest = |simulator: &mut Simulator, time_s| {
        simulator.push_sample(&support::resting_sample(time_s)).unwrap();
        simulator.step().unwrap();
        sigma(simulator)[3]
    };
    // The body axes are east, north, up. A rotation of 0.1 rad/s over 0.01 s changes what else is in the velocity by less than 1e-3.
    let (start, stepped) = (at_rest(&mut simulator, 0.0), at_rest(&mut simulator, 0.01));
    let [before, after] = [start / 0.1 - 1.0, stepped / 0.1f64.hypot(1.0) - 1.0].map(f64::abs);
    assert!(before < 1e-12, "{start}");
    assert!(after < 1e-3, "{stepped}");
    println!("figure: {before:.1e} before it (limit 1e-12), {after:.1e} after it (limit 1e-3)");
}
