//! Effects of the host's own clock: pauses, stamps that continued during a pause, intervals ten times as long. A run has the time
//! of its stamps.

use sins::truth::FlightSample;
use sins::{ErrorKind, ErrorSource, Options, Simulator, Step};

use crate::support::{fly_through, options_at, patrol, resting_sample};

/// During a pause a host steps without samples, pushes the last sample again, and pushes a stamp one hour later. Then the flight
/// continues as without a pause.
#[test]
fn an_hour_of_pause_is_nothing() {
    let flight = patrol(1200.0);
    let samples: Vec<_> = (0..400).map(|k| flight.sample_at(300.0 + f64::from(k) / 100.0).unwrap()).collect();
    let (before, after) = samples.split_at(200);
    let noise = sins::sensors::paper_simulation2();
    let start = || {
        let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
        simulator.set_gyro(&noise.0).unwrap();
        simulator.set_accel(&noise.1).unwrap();
        simulator
    };
    let (mut straight, mut paused) = (start(), start());
    fly_through(&mut straight, &samples);
    fly_through(&mut paused, before);
    for _ in 0..1000 {
        assert_eq!(paused.step(), Ok(Step::NeedSample));
        let again = paused.push_sample(&before[199]).unwrap_err();
        assert_eq!(again.kind, ErrorKind::TimeOrder);
    }
    let later = FlightSample { time_s: after[0].time_s + 3600.0, ..after[0] };
    let error = paused.push_sample(&later).unwrap_err();
    assert_eq!((error.kind, error.field), (ErrorKind::Discontinuity, "sample.time_s"));
    fly_through(&mut paused, after);
    assert_eq!(paused.navigation(), straight.navigation());
    assert_eq!(paused.imu(), straight.imu());
}

/// After a jump of the clock a host may reposition: time continues from the new stamp and the errors start again (a moved time
/// keeps them, see `moved`).
#[test]
fn stamps_that_ran_on_are_a_reposition() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    let at = |k: i32, time_s: f64| resting_sample(f64::from(k) * 0.02 + time_s);
    fly_through(&mut simulator, [at(0, 0.0), at(1, 0.0), at(2, 0.0)]);
    simulator.reposition(&at(3, 3600.0)).unwrap();
    fly_through(&mut simulator, [at(4, 3600.0), at(5, 3600.0)]);
    let navigation = simulator.navigation().unwrap().unwrap();
    assert_eq!(navigation.time_s, at(5, 3600.0).time_s);
    assert_eq!(simulator.intervals(), 2);
    // Time may also go back: a flight that is loaded again begins at an earlier time.
    simulator.reposition(&at(1, 0.0)).unwrap();
    fly_through(&mut simulator, [at(2, 0.0)]);
    assert_eq!(simulator.navigation().unwrap().unwrap().time_s, at(2, 0.0).time_s);
}

/// Largest position error [m] in each third of a flight. Samples are 0.02 s apart; only those that `is_sampled` selects are pushed.
fn largest_errors_m(sample: &dyn Fn(i32) -> FlightSample, is_sampled: &dyn Fn(i32) -> bool) -> [f64; 3] {
    let mut simulator = Simulator::new(&options_at(50.0)).unwrap();
    let mut largest = [0.0_f64; 3];
    for step in (0..=45_000).filter(|&step| is_sampled(step)) {
        simulator.push_sample(&sample(step)).unwrap();
        if simulator.step().unwrap() == Step::Done {
            let third = &mut largest[((step - 1) / 15_000) as usize];
            let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
            *third = third.max(errors.position_n.norm());
        }
    }
    largest
}

/// The middle third of 15 minutes runs at ten or a hundred times the pace, in flight and at rest. In and after it, the error is
/// at most that of a whole flight at that pace plus that of one at full rate: each interval adds its own error, and longer
/// intervals add more.
#[test]
fn a_faster_pace_costs_what_the_slower_rate_costs() {
    let flight = patrol(1500.0);
    let flown = |step: i32| flight.sample_at(300.0 + 0.02 * f64::from(step)).unwrap();
    let at_rest = |step: i32| resting_sample(0.02 * f64::from(step));
    let scenes: [(&dyn Fn(i32) -> FlightSample, i32); 3] = [(&flown, 10), (&at_rest, 10), (&at_rest, 100)];
    for (sample, pace) in scenes {
        let full = largest_errors_m(sample, &|_| true);
        let slow = largest_errors_m(sample, &|step| step % pace == 0);
        let mixed = largest_errors_m(sample, &|step| step % pace == 0 || !(15_000..30_000).contains(&step));
        println!(
            "largest errors [m] at full rate {full:?}, {pace} times the pace {slow:?}, in between {mixed:?}"
        );
        assert_eq!(mixed[0], full[0]);
        assert!(mixed[1] <= slow[1] + full[1] && mixed[2] <= slow[2] + full[2]);
    }
}
