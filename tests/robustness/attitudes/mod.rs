//! Attitudes and rates: the zenith, loops, gimbal lock, spins, spin-ups, and turns of nearly half a turn a sample.

mod rocket;

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;
use sins::math::{Euler, attitude_from_euler, rotation_vector};
use sins::signal::Increment;
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorKind, ErrorSource, Options, Simulator, Step};

use crate::support::orbits::about;
use crate::support::{self, DEG, EARTH_RATE, options_at, resting_sample};

/// At rest in the attitude `euler`.
fn posed(time_s: f64, euler: Euler) -> FlightSample {
    FlightSample { euler, ..resting_sample(time_s) }
}

/// Largest misalignment [rad] and position error [m] on the way, and the largest rate that the gyros sensed [rad/s].
fn pose(rate_hz: f64, count: u32, euler: impl Fn(f64) -> Euler) -> (f64, f64, f64) {
    let mut simulator = Simulator::new(&options_at(rate_hz)).unwrap();
    let (mut misalignment, mut position, mut rate): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for k in 0..=count {
        let time_s = f64::from(k) / rate_hz;
        simulator.push_sample(&posed(time_s, euler(time_s))).unwrap();
        simulator.step().unwrap();
        let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
        misalignment = misalignment.max(errors.misalignment_n.norm());
        position = position.max(errors.position_n.norm());
        if let Some(imu) = simulator.imu() {
            rate = rate.max((imu.ideal.angle / imu.interval_s).norm());
        }
    }
    (misalignment, position, rate)
}

/// Through the zenith and the nadir at 0.01 °/s, and at rest there, where roll and heading are one angle that a host may split
/// in any way. The gyros sense the slow turn and the Earth's rate, and the attitude stays right.
#[test]
fn pitch_through_90_degrees_slowly_and_at_rest_there() {
    let (mut largest_rad, mut largest_m) = (0.0_f64, 0.0_f64);
    for sign in [1.0, -1.0] {
        let slowly =
            |time_s: f64| Euler { roll: 0.3, pitch: sign * (89.9 + 0.01 * time_s) * DEG, heading: 1.0 };
        let (misalignment, position, rate) = pose(50.0, 1000, slowly);
        println!("through {}° at 0.01 °/s: {misalignment:.1e} rad, {position:.1e} m", sign * 90.0);
        // Differences of attitudes are rounded: an ulp of the half angles over 0.02 s.
        let rounding = 4.0 * f64::EPSILON * 50.0;
        assert!(rate < 0.01 * DEG + EARTH_RATE + rounding, "{rate}");
        // Each sample's attitude is rounded by an ulp or two. This does not add up; √1000 roundings of the gyros' sums do.
        assert!(
            misalignment < 2.0 * 1000f64.sqrt() * f64::EPSILON && position < 1e-8,
            "{misalignment:e} {position:e}"
        );
        (largest_rad, largest_m) = (largest_rad.max(misalignment), largest_m.max(position));

        let at_rest = |time_s: f64| {
            let split = (time_s * 700.0).sin() * 3.0;
            // At the zenith only heading less roll is defined, at the nadir only their sum.
            Euler { roll: split, pitch: sign * FRAC_PI_2, heading: 2.0 + sign * split }
        };
        let (misalignment, position, rate) = pose(50.0, 5000, at_rest);
        println!("at rest at {}°: {misalignment:.1e} rad, {position:.1e} m", sign * 90.0);
        assert!(rate < EARTH_RATE + 4.0 * rounding, "{rate}");
        assert!(
            misalignment < 2.0 * 5000f64.sqrt() * f64::EPSILON && position < 1e-8,
            "{misalignment:e} {position:e}"
        );
        (largest_rad, largest_m) = (largest_rad.max(misalignment), largest_m.max(position));
    }
    println!("figure: {largest_rad:.1e} rad, {largest_m:.1e} m");
}

/// An hour of 4 g loops, 180 times through zenith and nadir: the error is the algorithm's, in attitude of the fourth order, in
/// position of the third at least (where gravity is taken within an update). No passage adds to the error.
#[test]
fn loops_for_an_hour() {
    let start = FlightStart {
        latitude_rad: 0.7,
        height_m: 5000.0,
        speed_m_s: 120.0,
        heading_rad: 0.4,
        roll_rad: 0.02,
        pitch_rad: 0.03,
        ..Default::default()
    };
    let flight =
        Flight::new(&start, &[Manoeuvre::Loop { duration_s: 3600.0, turns: 180.0, ramp_s: 5.0 }]).unwrap();
    let worst = [25.0, 50.0, 100.0].map(|rate_hz| {
        let mut simulator = Simulator::new(&options_at(rate_hz)).unwrap();
        let samples = (0..=(3600.0 * rate_hz) as u32)
            .map(|k| flight.sample_at((f64::from(k) / rate_hz).min(flight.duration_s())).unwrap());
        let worst = support::fly(&mut simulator, samples, 1);
        println!("loops for an hour at {rate_hz} Hz: {worst:?}");
        worst
    });
    let rounding = support::rounding_at_rest(3600.0);
    for pair in worst.windows(2) {
        let [coarse, fine] = pair else { unreachable!() };
        assert!(fine.position_m < coarse.position_m / 8.0 + rounding.position_m, "{worst:?}");
        assert!(fine.velocity_m_s < coarse.velocity_m_s / 8.0 + rounding.velocity_m_s, "{worst:?}");
        let misalignment_rad = coarse.misalignment_rad / 12.0 + rounding.misalignment_rad;
        assert!(fine.misalignment_rad < misalignment_rad, "{worst:?}");
    }
    let [_, at_50_hz, at_100_hz] = worst;
    println!("figure: {:.1e} m, {:.1e} m", at_50_hz.position_m, at_100_hz.position_m);
}

/// Roll angle at `time_s` of a spin-up at `alpha` [rad/s²] to 20 rev/s and back.
fn spun(alpha: f64, time_s: f64) -> f64 {
    let (top, hold_s) = (40.0 * PI, 0.5);
    let ramp_s = top / alpha;
    let up = |t: f64| 0.5 * alpha * t.clamp(0.0, ramp_s).powi(2) + top * (t - ramp_s).max(0.0);
    // The way back subtracts the ramp again.
    up(time_s) - up(time_s - ramp_s - hold_s)
}

/// From rest to 20 rev/s and back at up to 1e5 °/s²: the gyros sense every degree of the turn.
#[test]
fn angular_acceleration_of_1e5_degrees_a_second_squared() {
    let mut figures = Vec::new();
    for (alpha_deg, rate_hz) in [(1e5, 50.0), (1e5, 100.0), (1e5, 1000.0), (2e4, 50.0)] {
        let euler = |time_s: f64| Euler { roll: spun(alpha_deg * DEG, time_s), pitch: 0.4, heading: 1.0 };
        let mut simulator = Simulator::new(&options_at(rate_hz)).unwrap();
        let (mut sensed, mut intervals) = (0.0, 0.0);
        let end_s = 0.9 + 2.0 * 7200.0 / alpha_deg;
        for k in 0..=(end_s * rate_hz) as u32 {
            let time_s = f64::from(k) / rate_hz;
            simulator.push_sample(&posed(time_s, euler(time_s))).unwrap();
            if simulator.step().unwrap() == Step::Done && k > 0 {
                sensed += simulator.imu().unwrap().ideal.angle.y;
                intervals += 1.0;
            }
        }
        let time_s = intervals / rate_hz;
        let expected = euler(time_s).roll;
        let attitude = simulator.navigation().unwrap().unwrap().navigation.q_nb;
        let off = rotation_vector(&(attitude_from_euler(&euler(time_s)).conjugate() * attitude)).norm();
        println!(
            "{alpha_deg:e} °/s² at {rate_hz} Hz: {:.1e} of {:.1} turns missed, attitude {off:.1e} rad",
            (sensed - expected) / expected,
            expected / (2.0 * PI)
        );
        // Along its own axis a turn is sensed exactly, except for the Earth's rate.
        assert!(
            (sensed - expected).abs() < EARTH_RATE * time_s + intervals * 4.0 * f64::EPSILON * PI,
            "{sensed} {expected}"
        );
        // The Earth's rate turns about the spinning axes: a cubic misses the third order of the turn in a sample.
        let missed = EARTH_RATE * time_s * (40.0 / rate_hz).powi(3);
        assert!(off < missed + intervals * 8.0 * f64::EPSILON, "{off:e}");
        figures.push(format!("{off:.1e} rad at {alpha_deg:e} °/s², {rate_hz} Hz"));
    }
    println!("figure: {}", figures.join("; "));
}

/// Flies a roll by `angle`: None if flown to the end with every turn sensed, else the sample refused as a discontinuity.
fn roll_through(
    count: u32,
    rate_hz: f64,
    with_rates: Option<fn(f64) -> f64>,
    tolerance: f64,
    angle: impl Fn(f64) -> f64,
) -> Option<u32> {
    let mut simulator = Simulator::new(&options_at(rate_hz)).unwrap();
    for k in 0..=count {
        let time_s = f64::from(k) / rate_hz;
        let mut sample = posed(time_s, Euler { roll: angle(time_s), pitch: 0.2, heading: 0.7 });
        if let Some(rate) = with_rates {
            sample.omega_ib_b = Some(Vector3::new(0.0, rate(time_s), 0.0));
        }
        if let Err(error) = simulator.push_sample(&sample) {
            assert_eq!(error.kind, ErrorKind::Discontinuity, "{error}");
            assert!(error.field.contains("rotation since"), "{error}");
            return Some(k);
        }
        simulator.step().unwrap();
        if k > 0 {
            let expected = angle(time_s) - angle(time_s - 1.0 / rate_hz);
            let sensed = simulator.imu().unwrap().ideal.angle.y;
            assert!((sensed - expected).abs() < tolerance, "{k}: {sensed} of {expected}: aliased");
        }
    }
    None
}

/// The stated limit: 169° a sample are right, 171° are refused. Beyond it, a spin-up is refused as long as the turn grows by
/// less than 180° a sample. With the host's angular rates larger turns are detected too, from the first interval on.
#[test]
fn whole_turns_are_right_or_refused() {
    let steady = |degrees: f64| move |time_s: f64| degrees * DEG * 100.0 * time_s;
    // Except for the Earth's turn in a sample and an ulp of the last angle.
    let exact = 0.01 * EARTH_RATE + 50.0 * PI * f64::EPSILON;
    assert_eq!(roll_through(50, 100.0, None, exact, steady(169.0)), None);
    assert_eq!(roll_through(50, 100.0, None, exact, steady(-169.0)), None);
    assert_eq!(roll_through(50, 100.0, None, exact, steady(171.0)), Some(1));
    // The cubic's own error, at 170° a sample; lost whole turns would be 6.28.
    let cubic = 1e-2;
    // α T² from 1° to 179°, so that every step from below to beyond half a turn occurs at some time.
    let growths_deg = 1..180;
    let mut refused = 0;
    for growth_deg in growths_deg.clone() {
        let growth = f64::from(growth_deg) * DEG;
        let reported =
            roll_through(400, 100.0, None, cubic, |time_s| 0.5 * growth * (100.0 * time_s).powi(2));
        assert!(reported.is_some(), "{growth_deg}");
        refused += 1;
    }
    // 20 rev/s sampled at 19, 20 and 21 Hz looks like a slow turn; with rates the spin is detected.
    let rates_hz = [19.0, 20.0, 21.0];
    for rate_hz in rates_hz {
        let reported = roll_through(5, rate_hz, Some(|_| 40.0 * PI), cubic, |time_s| 40.0 * PI * time_s);
        assert_eq!(reported, Some(1), "{rate_hz}");
    }
    // Two samples are lost at 72° a sample: 216° are not taken for -144°.
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    let spin =
        |k: i32| posed(f64::from(k) / 100.0, Euler { roll: 0.4 * PI * f64::from(k), ..Default::default() });
    for k in 0..10 {
        simulator.push_sample(&spin(k)).unwrap();
        simulator.step().unwrap();
    }
    let error = simulator.push_sample(&spin(12)).unwrap_err();
    assert_eq!(error.kind, ErrorKind::Discontinuity, "{error}");
    simulator.push_sample(&spin(10)).unwrap();
    println!(
        "figure: rejected: {refused} of {} spin-ups; with rates 20 rev/s at {} to {} Hz",
        growths_deg.len(),
        rates_hz[0],
        rates_hz[2]
    );
}

/// Increments of the host: nearly half a turn is right, half a turn and more is refused.
#[test]
fn increments_of_nearly_half_a_turn() {
    let mut largest_rad: f64 = 0.0;
    for parts in [1, 2] {
        for short_of in [1e-3, 1e-9] {
            let mut simulator = Simulator::new(&options_at(100.0)).unwrap();
            simulator.push_sample(&resting_sample(0.0)).unwrap();
            let start = simulator.truth().unwrap().unwrap().navigation;
            simulator.reset();
            simulator.start_navigation(0.0, &start).unwrap();
            let part = |total: f64| Increment {
                angle: Vector3::new(0.36, -0.48, 0.8) * (total / parts as f64),
                velocity: Vector3::zeros(),
            };
            let refused = simulator.push_imu(&vec![part(PI); parts], 0.01).unwrap_err();
            assert_eq!((refused.kind, refused.field), (ErrorKind::InvalidArgument, "imu.angle_rad"));
            simulator.push_imu(&vec![part(PI - short_of); parts], 0.01).unwrap();
            let q = simulator.navigation().unwrap().unwrap().navigation.q_nb;
            let turned = about(Vector3::new(0.36, -0.48, 0.8), PI - short_of).into_inner();
            let off = rotation_vector(&((start.q_nb * turned).conjugate() * q)).norm();
            println!("an increment of pi - {short_of:e} in {parts}: attitude {off:.1e} rad off");
            assert!(off < 1.1 * EARTH_RATE * 0.01 + 8.0 * f64::EPSILON, "{off:e}");
            largest_rad = largest_rad.max(off);
        }
    }
    println!("figure: {largest_rad:.1e} rad, the Earth's rotation in the interval");
}
