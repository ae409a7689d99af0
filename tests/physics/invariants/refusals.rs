//! Refused calls leave no trace.

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::truth::FlightSample;
use sins::{ErrorKind, ErrorSource, Options, Simulator, Step};

use super::resting;
use crate::support::{fly_through, options_at, resting_sample};

#[test]
fn navigation_alone_and_flight_do_not_mix() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    assert_eq!(simulator.step().unwrap(), Step::NeedSample);
    simulator.push_sample(&resting_sample(0.0)).unwrap();
    let start = simulator.truth().unwrap().unwrap().navigation;
    assert_eq!(simulator.start_navigation(0.0, &start).unwrap_err().kind, ErrorKind::BadState);
    simulator.reset();
    simulator.start_navigation(0.0, &start).unwrap();
    assert_eq!(simulator.push_sample(&resting_sample(0.0)).unwrap_err().kind, ErrorKind::BadState);
    assert_eq!(simulator.errors(ErrorSource::Navigation).unwrap_err().kind, ErrorKind::BadState);
    assert!(simulator.navigation().unwrap().unwrap().vertical_unaided);
}

/// A step beyond the limits is refused before the solution or the draws of its noise have changed.
#[test]
fn a_step_out_of_range_is_not_made() {
    let wild = TriadParameters {
        bias: Vector3::new(0.0, 0.0, 1e4),
        random_walk: Vector3::repeat(1.0),
        ..Default::default()
    };
    let mut simulator =
        Simulator::new(&Options { vertical: VerticalMode::Free, ..Default::default() }).unwrap();
    simulator.set_accel(&wild).unwrap();
    let mut samples = resting(1.0, 1000.0);
    let error = loop {
        simulator.push_sample(&samples.next().unwrap()).unwrap();
        if let Err(error) = simulator.step() {
            break error;
        }
    };
    assert_eq!(error.kind, ErrorKind::Diverged, "{error}");
    let before = (simulator.navigation().unwrap(), simulator.imu(), simulator.accuracy().unwrap());
    assert!(before.0.unwrap().navigation.v_n.norm() < 100e3);
    assert_eq!(simulator.step(), Err(error), "and again");
    assert_eq!((simulator.navigation().unwrap(), simulator.imu(), simulator.accuracy().unwrap()), before);

    // The refused steps drew nothing: another simulator that never tried has the same noise from here on.
    let mut other = Simulator::new(simulator.options()).unwrap();
    other.set_accel(&wild).unwrap();
    fly_through(&mut other, resting(1.0, simulator.intervals() as f64));
    assert_eq!(other.intervals(), simulator.intervals());
    for simulator in [&mut simulator, &mut other] {
        simulator.reposition(&resting(1.0, 1.0).next().unwrap()).unwrap();
        fly_through(simulator, resting(1.0, 3.0).skip(1));
    }
    assert_eq!(simulator.imu(), other.imu());
}

/// A first step that cannot be made leaves the simulator before its first step.
#[test]
fn a_refused_first_step_leaves_the_start_open() {
    let options = Options { frame: Frame::Geographic, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    let near_pole = |time_s: f64, latitude_rad: f64| FlightSample {
        place: Geodetic { latitude_rad, longitude_rad: 0.0, height_m: 0.0 },
        ..resting(1.0, 1.0).next().map(|sample| FlightSample { time_s, ..sample }).unwrap()
    };
    let limit = core::f64::consts::FRAC_PI_2 - 1e-3;
    simulator.push_sample(&near_pole(0.0, limit - 1e-6)).unwrap();
    simulator.push_sample(&near_pole(1.0, limit + 1e-6)).unwrap();
    assert_eq!(simulator.step().unwrap_err().kind, ErrorKind::Singular);
    assert!(!simulator.has_started());
    simulator.set_initial_errors(&InitialErrorParameters::default()).unwrap();
}
