//! The paper's simulation 1: no sensor errors. The paper reached 0.05 m/s in 48 h.
//!
//! 4 h here; 48 h with `cargo test -p tests --release --features long-tests --test physics simulation1:: -- --nocapture`,
//! which shows the figures.

use sins::math::Euler;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::truth::FlightSample;
use sins::{Options, Simulator};

use crate::support::{DEG, Worst, fly, options_at, patrol, resting_sample, rounding_at_rest};

const HOURS: f64 = if cfg!(feature = "long-tests") { 48.0 } else { 4.0 };
const RATE_HZ: f64 = 100.0;

fn resting() -> impl Iterator<Item = FlightSample> {
    // Tilted, because at simple attitudes rounding errors vanish that add up elsewhere.
    let euler = Euler { roll: 0.03, pitch: -0.05, heading: 0.7 };
    let sample = move |time_s| FlightSample { euler, ..resting_sample(time_s) };
    (0..=(HOURS * 3600.0 * RATE_HZ) as u64).map(move |k| sample(k as f64 / RATE_HZ))
}

fn patrolling(rate_hz: f64) -> impl Iterator<Item = FlightSample> {
    let flight = patrol(HOURS * 3600.0);
    (0..=(HOURS * 3600.0 * rate_hz) as u64)
        .map(move |k| flight.sample_at((k as f64 / rate_hz).min(flight.duration_s())).unwrap())
}

/// Checks the errors every ten seconds.
fn worst(options: Options, rate_hz: f64, samples: impl Iterator<Item = FlightSample>) -> Worst {
    let every = (10.0 * rate_hz) as usize;
    let worst = fly(&mut Simulator::new(&options).unwrap(), samples, every);
    println!(
        "{:?} {:?} {:?}, {rate_hz} Hz, {HOURS} h: {worst:?}",
        options.scheme, options.frame, options.vertical
    );
    worst
}

/// Bound of a fourth-order error: twice a 256th of the error at a quarter of the rate, and rounding.
fn of_fourth_order(coarse: f64, rounding: f64) -> f64 {
    2.0 * coarse / 256.0 + rounding
}

#[test]
fn error_free_sensors_stay_at_rest() {
    let worst = worst(options_at(RATE_HZ), RATE_HZ, resting());
    let rounding = rounding_at_rest(HOURS * 3600.0);
    assert!(worst.velocity_m_s < rounding.velocity_m_s, "{worst:?} {rounding:?}");
    assert!(worst.position_m < rounding.position_m, "{worst:?} {rounding:?}");
    assert!(worst.misalignment_rad < rounding.misalignment_rad, "{worst:?} {rounding:?}");
}

/// The recommended vertical channel, damped by an ideal barometer, does as well as one that follows the truth.
#[test]
fn error_free_sensors_navigate_the_patrol_back_to_the_truth() {
    let rounding = rounding_at_rest(HOURS * 3600.0);
    let mut largest_m: f64 = 0.0;
    for vertical in [VerticalMode::FollowTruth, VerticalMode::Damped] {
        let at = |rate_hz| worst(Options { vertical, ..options_at(rate_hz) }, rate_hz, patrolling(rate_hz));
        let (coarse, fine) = (at(0.25 * RATE_HZ), at(RATE_HZ));
        largest_m = largest_m.max(fine.position_m);
        for (coarse, fine, rounding) in [
            (coarse.velocity_m_s, fine.velocity_m_s, rounding.velocity_m_s),
            (coarse.position_m, fine.position_m, rounding.position_m),
            (coarse.misalignment_rad, fine.misalignment_rad, rounding.misalignment_rad),
        ] {
            let bound = of_fourth_order(coarse, rounding);
            assert!(fine < bound, "{vertical:?}: {fine:e} of {bound:e}");
        }
    }
    println!("figure: {largest_m:.1e} m in {HOURS} h");
}

/// The paper's approximations: first-order Earth terms cost metres and millimetres a second, in both axes.
#[test]
fn the_papers_scheme_shows_its_own_error() {
    for frame in [Frame::Geographic, Frame::EarthFixed] {
        let options = Options { scheme: Scheme::Paper, frame, ..options_at(RATE_HZ) };
        let worst = worst(options, RATE_HZ, patrolling(RATE_HZ));
        assert!((1.0..1000.0).contains(&worst.position_m), "{frame:?} {worst:?}");
        assert!((1e-3..0.2).contains(&worst.velocity_m_s), "{frame:?} {worst:?}");
    }
}

#[test]
fn the_patrol_is_the_one_that_is_described() {
    let flight = patrol(7200.0);
    let (mut bank, mut speed, mut distance): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for second in 0..7200 {
        let sample = flight.sample_at(f64::from(second)).unwrap();
        bank = bank.max(sample.euler.roll.abs());
        speed += sample.v_n.unwrap().norm() / 7200.0;
        distance = distance.max((sample.place.latitude_rad - 40.0 * DEG).abs());
    }
    assert!((20.0 * DEG..30.5 * DEG).contains(&bank), "{}", bank / DEG);
    assert!((speed - 200.0).abs() < 1.0, "{speed}");
    // The flight takes ten minutes to begin its pattern on the way north; from then on the figure-eights close.
    assert!(distance < 2.0 * DEG, "{}", distance / DEG);
}

/// The closed loop holds an error-free navigator, whose vertical channel is free and would double its error every 400 s, to the
/// rounding of Earth-fixed coordinates on both sides, eight roundings. The trim answers these by its gains, 1.6/τ of a velocity
/// that follows them in τ and 1/τ² + 4e-6. It also corrects the error of the scheme, of fourth order.
#[test]
fn the_closed_loop_holds_the_free_vertical_channel() {
    let tau_s = 30.0;
    let at = |rate_hz: f64| {
        let options =
            Options { closed_loop_time_s: Some(tau_s), vertical: VerticalMode::Free, ..options_at(rate_hz) };
        let mut simulator = Simulator::new(&options).unwrap();
        let worst = fly(&mut simulator, patrolling(rate_hz), (10.0 * rate_hz) as usize);
        let trim = simulator.trim().unwrap().unwrap();
        println!("closed loop, {rate_hz} Hz, {HOURS} h: {worst:?} {trim:?}");
        (worst, trim)
    };
    let ((coarse, coarse_trim), (fine, trim)) = (at(0.25 * RATE_HZ), at(RATE_HZ));
    let rounding_m = 8.0 * 6.4e6 * f64::EPSILON;
    let rounding_m_s2 = (1.6 + 1.0) * rounding_m / (tau_s * tau_s) + 4e-6 * rounding_m;
    for (name, coarse, fine, rounding) in [
        ("position", coarse.position_m, fine.position_m, rounding_m),
        ("velocity", coarse.velocity_m_s, fine.velocity_m_s, rounding_m / tau_s),
        ("force", coarse_trim.force_m_s2, trim.force_m_s2, rounding_m_s2),
        ("rate", coarse_trim.rate_rad_s, trim.rate_rad_s, 4.0 * f64::EPSILON / tau_s),
    ] {
        let bound = of_fourth_order(coarse, rounding);
        assert!(fine < bound, "{name}: {fine:e} of {bound:e}");
    }
}
