//! The host's time or truth jumps (a pause or a slew), and the INS keeps its errors. The errors right after the jump equal those
//! before it, and the flight continues from there.

mod pause;
mod slew;

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::earth::state::Navigation;
use sins::math::Euler;
use sins::mechanization::Frame;
use sins::sensors::InitialErrorParameters;
use sins::truth::FlightSample;
use sins::{ErrorKind, Options, Simulator};

use crate::support::moments::{altimeter, every_effect, initial, reads, snapshot};
use crate::support::{fly_through, resting_sample};

/// A simulator with every error. The initial errors need no alignment.
fn troubled(options: &Options) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    let (gyro, accel) = every_effect();
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_accel(&accel).unwrap();
    simulator.set_altimeter(&altimeter()).unwrap();
    simulator
        .set_initial_errors(&InitialErrorParameters { alignment: Default::default(), ..initial() })
        .unwrap();
    simulator
}

/// A sample at another place, speed and attitude.
fn elsewhere(time_s: f64, latitude_deg: f64, height_m: f64, speed_m_s: f64) -> FlightSample {
    let place = Geodetic { latitude_rad: latitude_deg.to_radians(), longitude_rad: -2.5, height_m };
    let euler = Euler { roll: -0.4, pitch: 0.2, heading: 5.0 };
    let v_n = Some(Vector3::new(-0.6, 0.8, 0.02) * speed_m_s);
    FlightSample { v_n, ..FlightSample::at_rest(time_s, place, euler) }
}

/// An impossible move is rejected and changes nothing.
#[test]
fn a_move_that_makes_no_sense_is_refused() {
    let refused = |simulator: &mut Simulator,
                   kind: ErrorKind,
                   call: &dyn Fn(&mut Simulator) -> Result<(), sins::Error>| {
        let before = (reads(simulator), snapshot(simulator));
        let error = call(simulator).unwrap_err();
        assert_eq!(error.kind, kind, "{error}");
        assert!((reads(simulator), snapshot(simulator)) == before, "{error}");
    };
    let mut simulator = troubled(&Options { frame: Frame::Geographic, ..Options::default() });
    refused(&mut simulator, ErrorKind::BadState, &|simulator| simulator.move_time(5.0));
    fly_through(&mut simulator, [resting_sample(0.0), resting_sample(0.02)]);
    for time_s in [f64::NAN, f64::INFINITY, 9.99999e9, 1e10, -1e10] {
        refused(&mut simulator, ErrorKind::InvalidArgument, &|simulator| simulator.move_time(time_s));
    }
    let pole = elsewhere(0.0, 89.999, 0.0, 0.0);
    refused(&mut simulator, ErrorKind::Singular, &|simulator| simulator.move_truth(&pole));
    let nowhere = FlightSample { time_s: f64::NAN, ..resting_sample(1.0) };
    refused(&mut simulator, ErrorKind::InvalidArgument, &|simulator| simulator.move_truth(&nowhere));

    let mut navigator = Simulator::new(&Options::default()).unwrap();
    let sample = resting_sample(0.0);
    let q_nb = sins::math::attitude_from_euler(&sample.euler);
    navigator
        .start_navigation(0.0, &Navigation::new(sample.place, Vector3::zeros(), q_nb, Default::default()))
        .unwrap();
    refused(&mut navigator, ErrorKind::BadState, &|navigator| navigator.move_time(5.0));
    refused(&mut navigator, ErrorKind::BadState, &|navigator| navigator.move_truth(&sample));

    // Before the first step a slew is a reposition.
    let (mut slewed, mut repositioned) = (troubled(&Options::default()), troubled(&Options::default()));
    slewed.push_sample(&resting_sample(0.0)).unwrap();
    slewed.move_truth(&sample).unwrap();
    repositioned.reposition(&sample).unwrap();
    assert_eq!(reads(&slewed), reads(&repositioned));
}
