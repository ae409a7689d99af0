//! Two flights from a flight dynamics simulator: ideal sensors navigate back to the truth.

use sins::mechanization::{Frame, VerticalMode};
use sins::{ClosureFigures, Options, Simulator};

use crate::support::Table;

/// Closure, and the largest horizontal velocity error on the way [m/s], flown on each `every`th sample.
fn fly(path: &str, options: &Options, every: usize) -> (ClosureFigures, f64) {
    let mut simulator = Simulator::new(options).unwrap();
    let mut worst: f64 = 0.0;
    for sample in Table::csv(path).samples(false).iter().step_by(every) {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        let (_, errors) = simulator.errors(sins::ErrorSource::Navigation).unwrap().unwrap();
        worst = worst.max(errors.velocity_n.xy().norm());
    }
    (simulator.accuracy().unwrap().unwrap().2, worst)
}

/// The figures are split into the host's share (its displacement against its velocity, Schuler-tuned) and the library's own rest.
/// The rest is of the fourth order of the interval: every fourth sample leaves 256 times as much. The bound is twice the 256th
/// part. The log's velocities are rounded to 1 nm/s, along three axes at both ends.
#[test]
fn both_flights_close_on_their_truth() {
    for path in ["c_examples/flights/airliner_cruise.csv", "c_examples/flights/fighter_aerobatics.csv"] {
        for (vertical, frame) in [
            (VerticalMode::FollowTruth, Frame::EarthFixed),
            (VerticalMode::Damped, Frame::EarthFixed),
            (VerticalMode::FollowTruth, Frame::Geographic),
        ] {
            let own = |every: usize| {
                let options = Options { vertical, frame, ..Default::default() };
                let (closure, worst) = fly(path, &options, every);
                assert_eq!(closure.inconsistent_samples, 0);
                let position_m = (closure.position_n - closure.host_position_n).xy().norm();
                let velocity_m_s = (closure.velocity_n - closure.host_velocity_n).xy().norm();
                (position_m, velocity_m_s.max(worst))
            };
            let (coarse, fine) = (own(4), own(1));
            println!("{path} {vertical:?} {frame:?}: {fine:?}, of every fourth sample {coarse:?}");
            let rounding_m_s = 2.0 * 3f64.sqrt() * 0.5e-9;
            assert!(fine.0 < 2.0 * coarse.0 / 256.0, "{path} {vertical:?} {frame:?}: {fine:?} {coarse:?}");
            assert!(
                fine.1 < 2.0 * coarse.1 / 256.0 + rounding_m_s,
                "{path} {vertical:?} {frame:?}: {fine:?} {coarse:?}"
            );
        }
    }
}

/// A host whose positions run 0.1 % faster than its velocities: the closure is the host's, and is reported so.
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
    // The rest is of second order: the axes turn with the place, by 20 m over the Earth's radius.
    let rest = (closure.position_n - closure.host_position_n).xy().norm();
    assert!(rest < 2e-3 * closure.position_n.norm(), "{rest} of {}", closure.position_n);
}
