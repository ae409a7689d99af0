//! At rest for hours and weeks: closure, norm of the quaternion, time base.
//!
//! 6 h at 100 Hz and 30 days at 1 Hz here; 48 h at 100 Hz and 30 days at 10 Hz with
//! `cargo test -p tests --release --features long-tests --test robustness rest:: -- --nocapture`.

use sins::math::Euler;
use sins::mechanization::Frame;
use sins::truth::FlightSample;
use sins::{ErrorSource, Options, Simulator};

use crate::support::{self, options_at, resting_sample};

const LONG: bool = cfg!(feature = "long-tests");

/// Tilted, because at simple attitudes rounding errors vanish that add up elsewhere.
fn tilted(time_s: f64) -> FlightSample {
    let euler = Euler { roll: 0.03, pitch: -0.05, heading: 0.7 };
    FlightSample { euler, ..resting_sample(time_s) }
}

/// Errors of position [m], velocity [m/s] and misalignment [rad] after each of `hours`. Norm and clock are checked on the way.
fn closure(options: &Options, rate_hz: f64, first_s: f64, hours: &[u32]) -> Vec<[f64; 3]> {
    let mut simulator = Simulator::new(options).unwrap();
    let mut figures = Vec::new();
    let intervals = |hour: u32| (f64::from(hour) * 3600.0 * rate_hz) as u64;
    for k in 0..=intervals(hours[hours.len() - 1]) {
        // Time of the host's clock, whose stamps are rounded where it counts from 1970.
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

/// Only rounding remains: the scheme's own swing is below 1e-10 m.
#[test]
fn closure_after_1_6_24_and_48_hours() {
    let hours: &[u32] = if LONG { &[1, 6, 24, 48] } else { &[1, 6] };
    let frames: &[Frame] = if LONG { &[Frame::EarthFixed, Frame::Geographic] } else { &[Frame::EarthFixed] };
    let mut cell = Vec::new();
    for &frame in frames {
        let axes = if frame == Frame::Geographic { "geographic " } else { "" };
        let figures = closure(&Options { frame, ..options_at(100.0) }, 100.0, 0.0, hours);
        for (hour, [position, velocity, misalignment]) in hours.iter().zip(figures) {
            println!("{frame:?}, {hour} h: {position:.1e} m, {velocity:.1e} m/s, {misalignment:.1e} rad");
            assert_rounding([position, velocity, misalignment], *hour);
            cell.push(format!("{axes}{hour} h {position:.1e} m, {velocity:.1e} m/s"));
        }
    }
    println!("figure: {}", cell.join("; "));
}

fn assert_rounding([position_m, velocity_m_s, misalignment_rad]: [f64; 3], hour: u32) {
    let rounding = support::rounding_at_rest(f64::from(hour) * 3600.0);
    assert!(position_m < rounding.position_m, "{position_m:e} {rounding:?}");
    assert!(velocity_m_s < rounding.velocity_m_s, "{velocity_m_s:e} {rounding:?}");
    assert!(misalignment_rad < rounding.misalignment_rad, "{misalignment_rad:e} {rounding:?}");
}

/// A clock that counts from 1970 is known to 2.4e-7 s: the intervals are differences of the stamps, so their sum telescopes.
#[test]
fn stamps_since_1970_cost_nothing() {
    let mut figures = Vec::new();
    for (label, options) in [
        ("own stamps", Options { intake: Default::default(), ..options_at(100.0) }),
        ("stated period", options_at(100.0)),
    ] {
        let [position, velocity, misalignment] = closure(&options, 100.0, 1.7e9, &[1])[0];
        println!("since 1970, {label}, 1 h: {position:.1e} m, {velocity:.1e} m/s, {misalignment:.1e} rad");
        assert_rounding([position, velocity, misalignment], 1);
        figures.push(format!("{position:.1e} m"));
    }
    println!("figure: {}", figures.join("; "));
}

/// Error of the exact scheme itself at rest [m], at an interval of `t` [s]. The scheme takes gravity where the force of the start
/// alone would carry the INS, W g cos L T³/12 to the east. The INS leans by this distance over the radius: a Schuler swing of up
/// to twice the distance, for any radius. The Earth's turn in ∫ v dt lacks 5/24 (W T)² g T cos L in the second order: its share to
/// the north is another swing, its Coriolis acceleration another lean. None of these errors grows.
fn swing_at_rest_m(t: f64) -> f64 {
    let (w, g, schuler) = (7.292_115e-5_f64, 9.802, (9.802 / 6.37e6_f64).sqrt());
    let (sin, cos) = (39.9 * support::DEG).sin_cos();
    let missing_m_s = 5.0 / 24.0 * (w * t).powi(2) * g * t * cos;
    w * g * cos * t.powi(3) / 6.0
        + missing_m_s * sin / schuler
        + 2.0 * 2.0 * w * missing_m_s / schuler.powi(2)
}

/// 30 days: each day stays within the swing of the algorithm's own error.
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
        "30 days at {rate_hz} Hz: misalignment {misalignment:.1e} rad, norm off by {:.1e}",
        solution.q_nb.norm() - 1.0
    );
    let bound_m = |day: usize| {
        // The sensed rate is the Earth's to two ulps, 2.7e-20 rad/s: in 30 days 7e-14 rad, 4.5e-7 m of the Earth's radius.
        let drift = 4.5e-7 * (day + 1) as f64 / 30.0;
        // Three roundings of Earth-fixed coordinates.
        let rounding = 3.0 * 6.4e6 * f64::EPSILON;
        // Gravity over the radius is known to 0.3 %, and the next order in W T is below that.
        1.01 * swing_at_rest_m(1.0 / rate_hz) + drift + rounding
    };
    println!(
        "figure: {:.1e} m on day 1, {:.1e} m on day {} (limit {:.1e} m)",
        worst[0],
        worst[29],
        worst.len(),
        bound_m(29)
    );
    for (day, worst) in worst.into_iter().enumerate() {
        let bound = bound_m(day);
        assert!(worst < bound, "day {}: {worst:e} m of {bound:e}", day + 1);
    }
    assert!((solution.q_nb.norm() - 1.0).abs() < 1e-15);
}

/// The clock of a navigator alone adds intervals of 0.01 s, and its last bit is right after each of a million.
#[test]
fn the_navigators_clock_does_not_drift() {
    let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
    for time_s in [0.0, 0.01] {
        simulator.push_sample(&resting_sample(time_s)).unwrap();
        simulator.step().unwrap();
    }
    let start = simulator.truth().unwrap().unwrap().navigation;
    let part = simulator.imu().unwrap().ideal;
    simulator.reset();
    simulator.start_navigation(1000.0, &start).unwrap();
    // The double 0.01 is not a hundredth but a whole number of 2^-59; k times this number is whole too, rounded once.
    let scale = (1_u64 << 59) as f64;
    let part_of_scale = (0.01 * scale) as u64;
    assert_eq!(part_of_scale as f64 / scale, 0.01);
    let mut plain_s = 1000.0;
    for k in 1..=1_000_000_u64 {
        simulator.push_imu(&[part], 0.01).unwrap();
        plain_s += 0.01;
        let time_s = simulator.navigation().unwrap().unwrap().time_s;
        let exact_s = ((1000_u128 << 59) + u128::from(k) * u128::from(part_of_scale)) as f64 / scale;
        assert_eq!(time_s, exact_s, "after {k}");
    }
    assert!((plain_s - 11_000.0_f64).abs() > 1e-9, "a plain sum drifts");
}
