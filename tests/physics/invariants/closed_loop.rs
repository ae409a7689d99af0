//! The closed loop, which trims the signals by an error-free navigator.

use sins::mechanization::Frame;
use sins::truth::IntakeLimits;
use sins::{ErrorKind, Options, Simulator};

use super::errors;
use crate::support::{options_at, patrol};

/// The trim is that of an error-free navigator: neither the sensor errors nor their time changes it, to the bit. It adds
/// nothing to the errors of the sensors.
#[test]
fn the_closed_loop_does_not_see_the_sensors() {
    let flight = patrol(600.0);
    let samples = || (0..=60_000).map(|k| flight.sample_at(f64::from(k) * 0.01).unwrap());
    let (gyro, accel) = sins::sensors::paper_simulation2();
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        let physical = Options { frame, ..options_at(100.0) };
        let closed = Options { closed_loop_time_s: Some(30.0), ..physical };
        let fly_with_errors_from = |options: &Options, from: Option<usize>| {
            let mut simulator = Simulator::new(options).unwrap();
            for (k, sample) in samples().enumerate() {
                if from == Some(k) {
                    simulator.set_gyro(&gyro).unwrap();
                    simulator.set_accel(&accel).unwrap();
                }
                simulator.push_sample(&sample).unwrap();
                simulator.step().unwrap();
            }
            (simulator.trim().unwrap().unwrap(), errors(&simulator))
        };
        let (ideal, _) = fly_with_errors_from(&closed, None);
        assert!(ideal.force_m_s2 > 0.0 && ideal.rate_rad_s < 1e-12, "{frame:?} {ideal:?}");
        for from in [0, 30_000] {
            let (trim, closed) = fly_with_errors_from(&closed, Some(from));
            let (none, physical) = fly_with_errors_from(&physical, Some(from));
            assert_eq!((trim, none), (ideal, sins::TrimFigures::default()), "{frame:?} {from}");
            let difference = (closed.position_n - physical.position_n).norm();
            assert!(difference < 1e-5, "{frame:?} {from}: {difference} m of {}", physical.position_n.norm());
        }
    }
}

#[test]
fn the_time_constant_of_the_closed_loop_is_checked() {
    for (closed_loop_time_s, max_gap_s) in [(0.5, 0.1), (2e4, 0.1), (9.9, 2.5), (f64::NAN, 0.1)] {
        let intake = IntakeLimits { max_gap_s, ..Default::default() };
        let closed_loop_time_s = Some(closed_loop_time_s);
        let error =
            Simulator::new(&Options { closed_loop_time_s, intake, ..Default::default() }).unwrap_err();
        assert_eq!((error.kind, error.field), (ErrorKind::InvalidArgument, "options.closed_loop_time_s"));
    }
}
