//! At rest for hours and weeks: closure, norm of the quaternion, time base.
//!
//! 6 h at 100 Hz and 30 days at 1 Hz here; 48 h at 100 Hz and 30 days at 10 Hz with
//! `cargo test --release --features long-tests --test hard_rest -- --nocapture`.

mod support;

use nalgebra::Vector3;
use sins::math::Euler;
use sins::mechanization::Frame;
use sins::signal::Increment;
use sins::truth::FlightSample;
use sins::{ErrorSource, Options, Simulator};
use support::{options_at, resting_sample};

const LONG: bool = cfg!(feature = "long-tests");

/// Tilted: at simple attitudes rounding errors vanish that elsewhere add up.
fn tilted(time_s: f64) -> FlightSample {
    let euler = Euler { roll: 0.03, pitch: -0.05, heading: 0.7 };
    FlightSample { euler, ..resting_sample(time_s) }
}

/// Position [m], velocity [m/s] and misalignment [rad] after each of `hours`; the norm and the clock on the way.
fn closure(options: &Options, rate_hz: f64, first_s: f64, hours: &[u32]) -> Vec<[f64; 3]> {
    let mut simulator = Simulator::new(options).unwrap();
    let mut figures = Vec::new();
    let intervals = |hour: u32| (f64::from(hour) * 3600.0 * rate_hz) as u64;
    for k in 0..=intervals(hours[hours.len() - 1]) {
        // Of the host's clock, whose stamps are rounded where it counts from 1970.
        simulator.push_sample(&tilted(first_s + k as f64 / rate_hz)).unwrap();
        simulator.step().unwrap();
        if k % 100_000 == 0 || hours.iter().any(|&hour| intervals(hour) == k) {
            let solution = simulator.navigation().unwrap().unwrap();
            let norm = solution.navigation.q_nb.norm();
            assert!((norm - 1.0).abs() < 1e-15, "{norm}");
            let exact_s = match options.intake.period_s {
                Some(period_s) => first_s + k as f64 * period_s,
                None => first_s + k as f64 / rate_hz,
            };
            assert_eq!(solution.time_s, exact_s, "not a bit of drift");
        }
        if hours.iter().any(|&hour| intervals(hour) == k) {
            let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
            figures.push(
                [&errors.position_n, &errors.velocity_n, &errors.misalignment_n].map(|error| error.norm()),
            );
        }
    }
    figures
}

/// The bars are those of the requirement, and a week's worth of rounding stays below a tenth of them.
#[test]
fn closure_after_1_6_24_and_48_hours() {
    let hours: &[u32] = if LONG { &[1, 6, 24, 48] } else { &[1, 6] };
    let frames: &[Frame] = if LONG { &[Frame::EarthFixed, Frame::Geographic] } else { &[Frame::EarthFixed] };
    for &frame in frames {
        let figures = closure(&Options { frame, ..options_at(100.0) }, 100.0, 0.0, hours);
        for (hour, [position, velocity, misalignment]) in hours.iter().zip(figures) {
            println!("{frame:?}, {hour} h: {position:.1e} m, {velocity:.1e} m/s, {misalignment:.1e} rad");
            assert!(
                position < 1e-7 && velocity < 1e-10 && misalignment < 1e-13,
                "{position:e} {velocity:e} {misalignment:e}"
            );
        }
    }
}

/// A clock that counts from 1970 is known to 2.4e-7 s: the intervals are the stamps' own differences, and telescope.
#[test]
fn stamps_since_1970_cost_nothing() {
    for (label, options) in [
        ("own stamps", Options { intake: Default::default(), ..options_at(100.0) }),
        ("stated period", options_at(100.0)),
    ] {
        let [position, velocity, misalignment] = closure(&options, 100.0, 1.7e9, &[1])[0];
        println!("since 1970, {label}, 1 h: {position:.1e} m, {velocity:.1e} m/s, {misalignment:.1e} rad");
        assert!(
            position < 1e-7 && velocity < 1e-10 && misalignment < 1e-13,
            "{position:e} {velocity:e} {misalignment:e}"
        );
    }
}

/// 30 days: the last is as the first. The algorithm's own acceleration, of the third order of the Earth's turn in an interval
/// and so of 3e-11 m/s² at 1 Hz, holds a Schuler oscillation up that does not grow.
#[test]
fn a_month() {
    let rate_hz = if LONG { 10.0 } else { 1.0 };
    let mut simulator = Simulator::new(&options_at(rate_hz)).unwrap();
    let mut worst = [0.0_f64; 30];
    let day = 86_400 * rate_hz as usize;
    for k in 0..30 * day {
        simulator.push_sample(&tilted(k as f64 / rate_hz)).unwrap();
        simulator.step().unwrap();
        if k % 60 == 0 {
            let (time_s, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
            worst[k / day] = worst[k / day].max(errors.position_n.norm());
            assert_eq!(time_s, k as f64 * (1.0 / rate_hz), "not a bit of drift");
        }
    }
    let solution = simulator.navigation().unwrap().unwrap().navigation;
    let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
    let misalignment = errors.misalignment_n.norm();
    println!(
        "30 days at {rate_hz} Hz: day 1 {:.1e} m, day 30 {:.1e} m, misalignment {misalignment:.1e} rad, norm off by {:.1e}",
        worst[0],
        worst[29],
        solution.q_nb.norm() - 1.0
    );
    // The sensed rate is that of the Earth to two ulps, 2.7e-20 rad/s: in 30 days 7e-14 rad, 4.5e-7 m of the Earth's radius.
    assert!(worst[29] < 1.1 * worst[0] + 4.5e-7, "{worst:?}");
    assert!((solution.q_nb.norm() - 1.0).abs() < 1e-15);
}

/// The clock of a navigator alone adds up intervals of 0.01 s, and has the last bit right after each of a million.
#[test]
fn the_navigators_clock_does_not_drift() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    simulator.push_sample(&resting_sample(0.0)).unwrap();
    let start = simulator.truth().unwrap().unwrap().navigation;
    simulator.reset();
    simulator.start_navigation(1000.0, &start).unwrap();
    let part = Increment { angle: Vector3::zeros(), velocity: Vector3::new(0.0, 0.0, 9.801_6 * 0.01) };
    let mut plain_s = 1000.0;
    for k in 1..=200_000_u32 {
        simulator.push_imu(&[part], 0.01).unwrap();
        plain_s += 0.01;
        let time_s = simulator.navigation().unwrap().unwrap().time_s;
        // 0.01 is not a hundredth: k times its rounding, 2e-19 s, and half a unit in the last place.
        let exact_s = 1000.0 + f64::from(k) / 100.0;
        assert!((time_s - exact_s).abs() <= exact_s * f64::EPSILON, "{time_s} {exact_s}");
    }
    assert!((plain_s - 3000.0_f64).abs() > 1e-9, "a plain sum drifts");
}
