//! A sensor block off the reference point.

mod errors;
mod placement;
mod truth;

use nalgebra::Vector3;
use sins::math::Euler;
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorKind, Options, Simulator};

use crate::support::{DEG, resting_sample, step};

fn flight(manoeuvres: &[Manoeuvre]) -> Flight {
    let start = FlightStart {
        latitude_rad: 45.0 * DEG,
        longitude_rad: 0.3,
        height_m: 4000.0,
        speed_m_s: 180.0,
        heading_rad: 1.0,
        ..Default::default()
    };
    Flight::new(&start, manoeuvres).unwrap()
}

/// Rolls of up to 160 °/s, a loop and a turn of 4 to 5 g.
fn aerobatics() -> Flight {
    flight(&[
        Manoeuvre::STurn { duration_s: 30.0, heading_change_rad: 0.6, turns: 2.0, ramp_s: 6.0 },
        Manoeuvre::Roll { duration_s: 5.0, turns: 1.0 },
        Manoeuvre::Loop { duration_s: 35.0, turns: 1.0, ramp_s: 5.0 },
        Manoeuvre::Turn { heading_change_rad: 3.6, bank_rad: 1.35, ramp_s: 3.0 },
        Manoeuvre::Roll { duration_s: 10.0, turns: -2.0 },
    ])
}

fn samples(flight: &Flight, rate_hz: f64) -> Vec<FlightSample> {
    let count = (flight.duration_s() * rate_hz).floor() as usize;
    (0..=count).map(|k| flight.sample_at(k as f64 / rate_hz).unwrap()).collect()
}

/// 5.5 m off, and turned about every axis.
fn off_centre() -> MountingParameters {
    MountingParameters {
        lever_arm_m: Vector3::new(1.0, 5.0, -2.0),
        boresight: Euler { roll: 0.7, pitch: -0.3, heading: 2.0 },
        ..Default::default()
    }
}

/// Errors of a careless installation: 7 cm and some arc minutes.
fn wrongly_believed() -> MountingParameters {
    MountingParameters {
        lever_arm_error_m: Vector3::new(0.03, -0.05, 0.04),
        boresight_error: Euler { roll: 2e-4, pitch: -4e-4, heading: 6e-4 },
        ..off_centre()
    }
}

fn mounted(options: &Options, mounting: &MountingParameters) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    simulator.set_mounting(mounting).unwrap();
    simulator
}

/// A mounting of zero changes nothing, to the bit. A reset and a reposition keep the mounting.
#[test]
fn zero_is_off_and_the_mounting_stays() {
    let samples = samples(&flight(&[Manoeuvre::Roll { duration_s: 5.0, turns: 1.0 }]), 50.0);
    let flown = |simulator: &mut Simulator| {
        for sample in &samples {
            step(simulator, sample);
        }
        (simulator.navigation().unwrap().unwrap(), simulator.imu().unwrap())
    };
    let plain = flown(&mut Simulator::new(&Options::default()).unwrap());
    let mut simulator = mounted(&Options::default(), &MountingParameters::default());
    assert_eq!(flown(&mut simulator), plain);

    let mut simulator = mounted(&Options::default(), &wrongly_believed());
    let first = flown(&mut simulator);
    assert_ne!(first.0, plain.0);
    simulator.reset();
    assert_eq!(flown(&mut simulator), first);
    simulator.reposition(&samples[0]).unwrap();
    for sample in &samples[1..] {
        step(&mut simulator, sample);
    }
    assert_eq!((simulator.navigation().unwrap().unwrap(), simulator.imu().unwrap()), first);
    simulator.reset();
    simulator.set_mounting(&MountingParameters::default()).unwrap();
    assert_eq!(flown(&mut simulator), plain);
}

#[test]
fn what_cannot_be_is_refused() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    let far = MountingParameters { lever_arm_m: Vector3::new(0.0, 101.0, 0.0), ..Default::default() };
    assert_eq!(
        simulator.set_mounting(&far).unwrap_err().to_string(),
        "mounting.lever_arm_m[1] = 101: must be from -100 to 100"
    );
    step(&mut simulator, &resting_sample(0.0));
    simulator.set_mounting(&off_centre()).unwrap();
    step(&mut simulator, &resting_sample(1.0));
    let before = simulator.navigation().unwrap();
    assert_eq!(simulator.set_mounting(&wrongly_believed()).unwrap_err().kind, ErrorKind::BadState);
    assert_eq!(simulator.navigation().unwrap(), before);
}

/// A block on a long arm in a wild spin is thrown out of its range: the step is refused and nothing has changed.
#[test]
fn an_arm_that_throws_the_block_away_is_an_error() {
    let mounting = MountingParameters { lever_arm_m: Vector3::new(0.0, 100.0, 0.0), ..Default::default() };
    let mut simulator = mounted(&Options::default(), &mounting);
    let spin = |time_s: f64, rate: f64| FlightSample {
        omega_ib_b: Some(Vector3::new(rate, 0.0, 0.0)),
        ..resting_sample(time_s)
    };
    step(&mut simulator, &spin(0.0, 0.0));
    step(&mut simulator, &spin(0.01, 0.0));
    let before = simulator.navigation().unwrap();
    simulator.push_sample(&spin(2.5, 1000.0)).unwrap();
    assert_eq!(simulator.step().unwrap_err().kind, ErrorKind::Diverged);
    assert_eq!(simulator.navigation().unwrap(), before);
}
