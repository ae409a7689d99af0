//! Two flights from a flight dynamics simulator: ideal sensors navigate back to the truth.

mod support;

use sins::mechanization::{Frame, VerticalMode};
use sins::{ClosureFigures, Options, Simulator};
use support::Table;

/// Closure, and the largest velocity error on the way [m/s].
fn fly(path: &str, options: &Options) -> (ClosureFigures, f64) {
    let mut simulator = Simulator::new(options).unwrap();
    let mut worst: f64 = 0.0;
    for (k, sample) in Table::csv(path).samples(false).iter().enumerate() {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        if k % 50 == 0 {
            let (_, errors) = simulator.errors(sins::ErrorSource::Navigation).unwrap().unwrap();
            worst = worst.max(errors.velocity_n.norm());
        }
    }
    (simulator.accuracy().unwrap().unwrap().2, worst)
}

/// The figures are split into the host's share (its displacement against its velocity, Schuler-tuned) and the rest, which
/// is ours. The bar for ours was 0.05 m/s.
#[test]
fn both_flights_close_on_their_truth() {
    for (path, own_m, own_m_s) in [
        // 50 Hz cruise and one turn: the rounding of the log and the cubic between its samples.
        ("c_examples/flights/airliner_cruise.csv", 2e-5, 1e-6),
        // 100 Hz, rolls and 5 g: what two subsamples leave of rotations of 2° an interval.
        ("c_examples/flights/fighter_aerobatics.csv", 1e-2, 1e-4),
    ] {
        for (vertical, frame) in [
            (VerticalMode::FollowTruth, Frame::EarthFixed),
            (VerticalMode::Damped, Frame::EarthFixed),
            (VerticalMode::FollowTruth, Frame::Geographic),
        ] {
            let (closure, worst) = fly(path, &Options { vertical, frame, ..Default::default() });
            let own_position = (closure.position_n - closure.host_position_n).xy().norm();
            let own_velocity = (closure.velocity_n - closure.host_velocity_n).xy().norm();
            assert!(own_position < own_m, "{path} {vertical:?} {frame:?}: {own_position:e} m");
            assert!(own_velocity < own_m_s, "{path} {vertical:?} {frame:?}: {own_velocity:e} m/s");
            assert!(worst < 2.0 * own_m_s, "{path}: {worst:e} m/s on the way");
            assert_eq!(closure.inconsistent_samples, 0);
        }
    }
}

/// A host whose positions run 1 % faster than its velocities say: the closure is the host's, and is told so.
#[test]
fn a_host_that_contradicts_itself_is_told_its_share() {
    let table = Table::csv("c_examples/flights/airliner_cruise.csv");
    let samples = table.samples(false);
    let origin = samples[0].place.longitude_rad;
    let options = Options { vertical: VerticalMode::FollowTruth, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    for sample in &samples[..5000] {
        let mut sample = *sample;
        sample.place.longitude_rad = origin + 1.001 * (sample.place.longitude_rad - origin);
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
    }
    let (_, _, closure) = simulator.accuracy().unwrap().unwrap();
    // 0.1 % of 214 m/s east over 100 s.
    assert!(closure.position_n.x.abs() > 15.0, "{}", closure.position_n);
    // What the share leaves is second order: the axes turn with the place, by 20 m of the Earth's radius.
    let rest = (closure.position_n - closure.host_position_n).xy().norm();
    assert!(rest < 2e-3 * closure.position_n.norm(), "{rest} of {}", closure.position_n);
}
