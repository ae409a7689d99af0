//! Samples of a host that are accepted or refused: each refusal names field, value and limit, and changes nothing.

use nalgebra::Vector3;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorKind, Options, Simulator};

use crate::support::{DEG, options_at, resting_sample};

fn moving(time_s: f64) -> FlightSample {
    FlightSample { v_n: Some(Vector3::new(0.0, 100.0, 0.0)), ..resting_sample(time_s) }
}

/// 100 m/s north for `time_s` from the start.
fn north(time_s: f64) -> FlightSample {
    let mut sample = moving(time_s);
    sample.place.latitude_rad += 100.0 * time_s / 6_361_800.0;
    sample
}

#[test]
fn every_field_is_checked_and_a_refusal_changes_nothing() {
    type Break = fn(&mut FlightSample, f64);
    let fields: [(&str, Break, f64); 12] = [
        ("sample.time_s", |s, v| s.time_s = v, 2e10),
        ("sample.latitude_rad", |s, v| s.place.latitude_rad = v, 1.6),
        ("sample.longitude_rad", |s, v| s.place.longitude_rad = v, 101.0),
        ("sample.height_m", |s, v| s.place.height_m = v, 2.1e6),
        ("sample.velocity_enu_m_s", |s, v| s.v_n = Some(Vector3::new(v, 0.0, 0.0)), 2.1e4),
        ("sample.velocity_enu_m_s", |s, v| s.v_n = Some(Vector3::new(0.0, v, 0.0)), 2.1e4),
        ("sample.velocity_enu_m_s", |s, v| s.v_n = Some(Vector3::new(0.0, 0.0, v)), 2.1e4),
        ("sample.roll_rad", |s, v| s.euler.roll = v, 1.1e4),
        ("sample.pitch_rad", |s, v| s.euler.pitch = v, 1.1e4),
        ("sample.heading_rad", |s, v| s.euler.heading = v, 1.1e4),
        ("sample.angular_rate_rad_s", |s, v| s.omega_ib_b = Some(Vector3::new(0.0, v, 0.0)), 1.1e3),
        ("sample.specific_force_m_s2", |s, v| s.f_b = Some(Vector3::new(0.0, 0.0, v)), 1.1e5),
    ];
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    for k in 0..5 {
        simulator.push_sample(&north(f64::from(k) / 100.0)).unwrap();
        simulator.step().unwrap();
    }
    let before = simulator.navigation().unwrap();
    for (field, set, beyond) in fields {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, beyond, -beyond] {
            let mut sample = north(0.05);
            set(&mut sample, value);
            let error = simulator.push_sample(&sample).unwrap_err();
            assert_eq!((error.kind, error.field), (ErrorKind::InvalidArgument, field), "{error}");
            assert!(error.value.is_some_and(|v| v.as_f64().to_bits() == value.to_bits()), "{error}");
        }
    }
    assert_eq!(simulator.waiting_samples(), 0);
    assert_eq!(simulator.navigation().unwrap(), before);
    simulator.push_sample(&north(0.05)).unwrap();
    simulator.step().unwrap();
}

fn refusal(options: &Options, samples: &[FlightSample]) -> sins::Error {
    let mut simulator = Simulator::new(options).unwrap();
    let (last, good) = samples.split_last().unwrap();
    for sample in good {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
    }
    let before = simulator.navigation().unwrap();
    let error = simulator.push_sample(last).unwrap_err();
    assert_eq!(simulator.navigation().unwrap(), before);
    error
}

#[test]
fn time_goes_forward() {
    let own_stamps = Options::default();
    for (second, kind) in [
        (0.0, ErrorKind::TimeOrder),
        (-0.01, ErrorKind::TimeOrder),
        (1e-5, ErrorKind::TimeOrder),
        (2.6, ErrorKind::Discontinuity),
        (3600.0, ErrorKind::Discontinuity),
    ] {
        let error = refusal(&own_stamps, &[north(0.0), north(second)]);
        assert_eq!((error.kind, error.field), (kind, "sample.time_s"), "{error}");
    }
    let mut simulator = Simulator::new(&own_stamps).unwrap();
    for time in [0.0, 0.001, 0.1, 1.1, 3.5] {
        simulator.push_sample(&north(time)).unwrap();
        simulator.step().unwrap();
    }
}

/// With a stated period stamps only order and check the samples: the time base is exact for any drift of the stamps, and a
/// lost sample is detected.
#[test]
fn a_stated_period_is_the_time_base() {
    let options = options_at(100.0);
    let mut simulator = Simulator::new(&options).unwrap();
    // The host adds 0.01 in single precision.
    let mut stamp = 0.0_f32;
    for k in 0..2000_u32 {
        if k != 1000 {
            simulator.push_sample(&north(f64::from(stamp))).unwrap();
            simulator.step().unwrap();
        }
        stamp += 0.01;
    }
    assert!((f64::from(stamp) - 20.0).abs() > 1e-4, "the host's own sum is off");
    let imu = simulator.imu().unwrap();
    assert_eq!(imu.interval_s, 0.01);
    assert!((imu.time_s - 19.99).abs() < 4e-15);

    let error = refusal(&options, &[north(0.0), north(0.0145)]);
    assert_eq!(error.kind, ErrorKind::TimeOrder, "{error}");
    let error = refusal(&options, &[north(0.0), north(0.01), north(0.0101)]);
    assert_eq!(error.kind, ErrorKind::TimeOrder, "{error}");
}

#[test]
fn jumps_of_truth_are_refused() {
    let options = Options::default();
    let mut fast = north(0.01);
    fast.v_n = Some(Vector3::new(0.0, 121.0, 0.0));
    let mut teleported = north(0.01);
    teleported.place.latitude_rad += 20.0 / 6.4e6;
    let mut turned = north(0.01);
    turned.euler.roll = 171.0 * DEG;
    for (sample, what) in [(fast, "acceleration"), (teleported, "displacement"), (turned, "rotation")] {
        let error = refusal(&options, &[north(0.0), sample]);
        assert_eq!(error.kind, ErrorKind::Discontinuity, "{error}");
        assert!(error.field.contains(what), "{error}");
    }
    // The host may define what a jump is.
    let mut strict = options;
    strict.intake.max_acceleration_m_s2 = 50.0;
    let mut hard = north(0.01);
    hard.v_n = Some(Vector3::new(0.6, 100.0, 0.0));
    assert_eq!(refusal(&strict, &[north(0.0), hard]).kind, ErrorKind::Discontinuity);
    hard.v_n = Some(Vector3::new(0.4, 100.0, 0.0));
    let mut simulator = Simulator::new(&strict).unwrap();
    simulator.push_sample(&north(0.0)).unwrap();
    simulator.push_sample(&hard).unwrap();
}

#[test]
fn the_queue_is_bounded() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    for k in 0..16 {
        simulator.push_sample(&north(f64::from(k) / 100.0)).unwrap();
    }
    let error = simulator.push_sample(&north(0.16)).unwrap_err();
    assert_eq!(error.kind, ErrorKind::QueueFull, "{error}");
    simulator.step().unwrap();
    simulator.push_sample(&north(0.16)).unwrap();
}

/// A host that states its own period as the longest gap, with time stamps that it multiplies or adds up.
#[test]
fn a_gap_of_exactly_the_limit_passes_whatever_its_rounding() {
    for period_s in [0.1, 1.0 / 60.0, 0.02, 5e-5] {
        let intake = IntakeLimits { max_gap_s: period_s, ..Default::default() };
        let mut simulator = Simulator::new(&Options { intake, ..Default::default() }).unwrap();
        let mut sum_s = 100.0;
        for k in 0..1000 {
            let time_s = if k < 500 { 100.0 + f64::from(k) * period_s } else { sum_s };
            simulator.push_sample(&resting_sample(time_s)).unwrap();
            simulator.step().unwrap();
            sum_s = time_s + period_s;
        }
    }
}

/// A slew that the host did not announce: whatever the time since, and whatever the speed, the sentence speaks of the jump. Where the
/// vehicle may have flown in the gap, it speaks of the gap alone.
#[test]
fn a_gap_with_a_jump_says_jump() {
    let jumped = |metres: f64, time_s: f64, speed: f64| {
        let mut simulator = Simulator::new(&Options::default()).unwrap();
        let mut sample = FlightSample { v_n: Some(Vector3::new(speed, 0.0, 0.0)), ..resting_sample(0.0) };
        simulator.push_sample(&sample).unwrap();
        let start = sample.place.latitude_rad;
        sample.time_s = time_s;
        sample.place.latitude_rad = start + metres / 6_361_800.0;
        let error = simulator.push_sample(&sample).unwrap_err();
        assert_eq!((error.kind, error.field), (ErrorKind::Discontinuity, "sample.time_s"), "{error}");
        error.to_string()
    };
    let gap = "the gap after the last accepted sample must be at most options.max_gap_s = 2.5";
    for time_s in [2.6, 60.0, 3600.0, 1e6] {
        let said = jumped(111e3, time_s, 0.0);
        let (before, after) = said.split_once("; in the gap the position jumped by ").unwrap();
        assert_eq!(before, format!("sample.time_s = {time_s}: {gap}"));
        let metres: f64 = after.strip_suffix(" m").unwrap().parse().unwrap();
        assert!((metres - 111e3).abs() < 1e3, "{said}");
        assert_eq!(jumped(0.0, time_s, 0.0), format!("sample.time_s = {time_s}: {gap}"));
        assert_eq!(jumped(0.0, time_s, 250.0), format!("sample.time_s = {time_s}: {gap}"));
    }
    // A quarter of an hour at 250 m/s is farther than 111 km, five minutes are not.
    assert!(
        jumped(111e3, 300.0, 250.0).contains("jumped") && !jumped(111e3, 900.0, 250.0).contains("jumped")
    );
}
