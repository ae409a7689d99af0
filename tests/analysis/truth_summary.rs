//! The motion of the truth in figures: the figures of a good host, and the figures in which a host's wrong units stand out.

use nalgebra::Vector3;
use sins::earth::state::BodyAxes;
use sins::sensors::paper_simulation2;
use sins::truth::{FlightSample, TruthSummary};
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use crate::support::{patrol, resting_sample};

const RATE_HZ: f64 = 50.0;

/// Six minutes of the patrol with a turn, at 50 Hz.
fn samples() -> Vec<FlightSample> {
    let flight = patrol(1200.0);
    (0..18_000).map(|k| flight.sample_at(200.0 + f64::from(k) / RATE_HZ).unwrap()).collect()
}

/// Summary of the samples after the host's `change`.
fn summary(samples: &[FlightSample], change: impl Fn(&mut FlightSample)) -> TruthSummary {
    summary_with(&Options::default(), samples, change)
}

fn summary_with(
    options: &Options,
    samples: &[FlightSample],
    change: impl Fn(&mut FlightSample),
) -> TruthSummary {
    let mut simulator = Simulator::new(&Options { truth_summary: true, ..*options }).unwrap();
    for sample in samples {
        let mut sample = *sample;
        change(&mut sample);
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
    }
    simulator.truth_summary().unwrap().unwrap()
}

/// All figures of a coordinated turn are known: rate by course, force by bank, neither sideslip nor angle of attack.
#[test]
fn a_good_flight_shows_its_own_figures() {
    let samples = samples();
    let good = summary(&samples, |_| ());
    println!("{good:#?}");
    assert_eq!((good.intervals, good.gaps, good.fast_samples), (17_999, 0, 18_000));
    assert!((good.flown_s - 17_999.0 / RATE_HZ).abs() < 1e-6);
    assert_eq!((good.first_s, good.last_s), (samples[0].time_s, samples[17_999].time_s));
    let speed = |sample: &FlightSample| sample.v_n.unwrap().norm();
    let fastest = samples.iter().map(speed).fold(0.0, f64::max);
    // Rounding of the turn to Earth-fixed axes.
    assert!((good.speed_max.value - fastest).abs() < 1e-12 * fastest);
    let heights =
        |pick: fn(f64, f64) -> f64, start| samples.iter().map(|s| s.place.height_m).fold(start, pick);
    assert_eq!(good.height_max.value, heights(f64::max, f64::MIN));
    assert_eq!(good.height_min.value, heights(f64::min, f64::MAX));
    // g / cos(bank) in the turn; the rest is curvature, Coriolis and the ramps of the bank.
    let bank = samples.iter().map(|s| s.euler.roll.abs()).fold(0.0, f64::max);
    assert!((good.force_max.value - 9.8 / bank.cos()).abs() < 0.2, "{}", good.force_max.value);
    // The patrol's nose is on its path, except for 0.15° of the waves in course and climb that its angles omit.
    assert!(good.sideslip_max.value.abs() < 3e-3 && good.attack_max.value.abs() < 3e-3);
    assert!(good.inconsistency_max.value < 1e-3 && good.rate_max.value < 0.5);
    assert!((good.rate_max.value - good.turn_max.value * RATE_HZ).abs() < 1e-9);

    let forward_right_down = Options { axes: BodyAxes::ForwardRightDown, ..Options::default() };
    let other = summary_with(&forward_right_down, &samples, |_| ());
    assert!((other.force_max.value - good.force_max.value).abs() < 1e-9);
    let apart = (other.sideslip_max.value - good.sideslip_max.value)
        .abs()
        .max((other.attack_max.value - good.attack_max.value).abs());
    assert!(apart < 1e-12, "{apart}");
}

/// Wrong units of a host in its own flight, each in the figure that shows it.
#[test]
fn wrong_units_stand_out() {
    let samples = samples();
    let good = summary(&samples, |_| ());

    // Attitudes in degrees: each turns 57 times as fast, and the nose is anywhere.
    let degrees = |sample: &mut FlightSample| {
        let euler = &mut sample.euler;
        (euler.roll, euler.pitch, euler.heading) =
            (euler.roll.to_degrees(), euler.pitch.to_degrees(), euler.heading.to_degrees());
    };
    let of_degrees = summary(&samples, degrees);
    assert!(of_degrees.rate_max.value > 20.0 * good.rate_max.value, "{of_degrees:#?}");
    let of_rate = of_degrees.rate_max.value / good.rate_max.value;
    let nose = of_degrees.sideslip_max.value.abs().max(of_degrees.attack_max.value.abs());
    assert!(nose > 1.0, "{of_degrees:#?}");
    let least_nose = nose;

    // Feet for metres: 3.28 times the height, and climbs that the velocity contradicts.
    let of_feet = summary(&samples, |sample| sample.place.height_m /= 0.3048);
    let limit = 1e-12;
    let of_heights = (of_feet.height_max.value / good.height_max.value - 1.0 / 0.3048).abs();
    assert!(of_heights < limit);

    // Knots for m/s: 1.94 times the speed, and each interval's displacement is half of what it ought to be.
    let knot = 1852.0 / 3600.0;
    let of_knots = summary(&samples, |sample| sample.v_n = sample.v_n.map(|v_n| v_n / knot));
    let of_speeds = (of_knots.speed_max.value / good.speed_max.value - 1.0 / knot).abs();
    assert!(of_speeds < limit);
    let lost = good.speed_max.value * (1.0 / knot - 1.0) / RATE_HZ;
    assert!((of_knots.inconsistency_max.value - lost).abs() < 0.02 * lost);

    // East and north exchanged: the nose points elsewhere, and the way leads elsewhere.
    let exchanged = |sample: &mut FlightSample| {
        sample.v_n = sample.v_n.map(|v_n| Vector3::new(v_n.y, v_n.x, v_n.z));
    };
    let of_exchanged = summary(&samples, exchanged);
    let nose = of_exchanged.sideslip_max.value.abs().max(of_exchanged.attack_max.value.abs());
    assert!(nose > 1.0 && of_exchanged.inconsistency_max.value > 1.0, "{of_exchanged:#?}");
    let nose_deg = least_nose.min(nose).to_degrees();
    let factor = of_heights.max(of_speeds).max(f64::EPSILON);
    let factors = format!("heights and speeds by their factors to {factor:.0e} (limit {limit:e})");
    println!("figure: rates {of_rate:.0} times as large, nose {nose_deg:.0}° off, {factors}");
}

/// The summary is an option, off by default. Repositions, moves and snapshots keep the figures, a reset clears them, and the
/// rest of the simulator is independent of them.
#[test]
fn the_summary_goes_along_and_changes_nothing() {
    let samples = samples();
    let noise = paper_simulation2();
    let new = |truth_summary: bool| {
        let mut simulator =
            Simulator::new(&Options { truth_summary, error_model: true, ..Options::default() }).unwrap();
        simulator.set_gyro(&noise.0).unwrap();
        simulator.set_accel(&noise.1).unwrap();
        simulator
    };
    let (mut with, mut without) = (new(true), new(false));
    assert_eq!(without.truth_summary().unwrap_err().kind, ErrorKind::BadState);
    assert_eq!(with.truth_summary(), Ok(None));
    for sample in &samples[..500] {
        for simulator in [&mut with, &mut without] {
            simulator.push_sample(sample).unwrap();
            simulator.step().unwrap();
        }
        let read = |simulator: &Simulator| {
            let errors = |source| simulator.errors(source).unwrap();
            (
                simulator.navigation(),
                simulator.imu(),
                errors(ErrorSource::Navigation),
                errors(ErrorSource::Model),
            )
        };
        assert_eq!(read(&with), read(&without));
    }
    let before = with.truth_summary().unwrap().unwrap();
    assert_eq!(before.intervals, 499);
    with.move_truth(&resting_sample(1e4)).unwrap();
    with.move_time(5.0).unwrap();
    with.reposition(&resting_sample(1e6)).unwrap();
    assert_eq!(with.truth_summary(), Ok(Some(before)));
    let mut bytes = vec![0; with.snapshot_size()];
    with.save_snapshot(&mut bytes).unwrap();
    let mut loaded = Simulator::new(&Options::default()).unwrap();
    loaded.load_snapshot(&bytes).unwrap();
    assert_eq!(loaded.truth_summary(), Ok(Some(before)));
    for time_s in [1e6 + 1.0, 1e6 + 2.0] {
        loaded.push_sample(&resting_sample(time_s)).unwrap();
        loaded.step().unwrap();
    }
    let after = loaded.truth_summary().unwrap().unwrap();
    assert_eq!((after.intervals, after.speed_max, after.interval_max.value), (501, before.speed_max, 1.0));
    assert_eq!((after.first_s, after.last_s), (before.first_s, 1e6 + 2.0));
    loaded.reset();
    assert_eq!(loaded.truth_summary(), Ok(None));
}
