//! Two minutes of a flight predict the errors of an hour.

use sins::analysis::recommend::{Growth, Piece, SolutionError, ladder};
use sins::mechanization::VerticalMode;
use sins::sensors::TriadParameters;
use sins::truth::flight::{Channel, Flight, Manoeuvre};
use sins::{Options, Simulator};

use super::{CRUISE, REST, navigated, navigated_by, reference, samples, sinusoids, told, worst_difference};
use crate::support::{DEG_PER_HOUR, G, options_at};

/// Errors in D = N T that follow from those of a piece of length T as steady rates of the worst signs, without Schuler's
/// restoring effect: attitude N a, velocity N (v + p/T) + g N a D + V' (N - 1) a, position N p + D times this velocity.
/// Schuler's pendulum only reduces them; a free vertical channel multiplies by no more than e^(κD), κ² = 2 g/R.
fn without_schuler(
    piece: &Piece,
    duration_s: f64,
    vertical: VerticalMode,
    error: &SolutionError,
) -> SolutionError {
    let SolutionError { position_m, velocity_m_s, attitude_rad } = *error;
    let pieces = (duration_s / piece.duration_s).round();
    // Gravity and κ are above those of any place.
    let tilted_m_s = 9.84 * pieces * attitude_rad * duration_s;
    let turned_m_s = piece.velocity_change_m_s * (pieces - 1.0) * attitude_rad;
    let velocity = pieces * (velocity_m_s + position_m / piece.duration_s) + tilted_m_s + turned_m_s;
    let growth = match vertical {
        VerticalMode::Free => (duration_s / 567.0).exp(),
        _ => 1.0,
    };
    SolutionError {
        position_m: growth * (pieces * position_m + duration_s * velocity),
        velocity_m_s: growth * velocity,
        attitude_rad: pieces * attitude_rad,
    }
}

/// Whether `error` is within `bound` in every part; false for infinity and for what is not a number.
fn exceeds_nowhere(error: &SolutionError, bound: &SolutionError) -> bool {
    // Sums of a few terms may be rounded in another order.
    let within = |value: f64, bound: f64| value.is_finite() && value <= bound * (1.0 + 8.0 * f64::EPSILON);
    within(error.position_m, bound.position_m)
        && within(error.velocity_m_s, bound.velocity_m_s)
        && within(error.attitude_rad, bound.attitude_rad)
}

/// Predicted position, velocity and attitude errors over the actual ones.
fn factors(predicted: &SolutionError, actual: &SolutionError) -> [f64; 3] {
    [
        predicted.position_m / actual.position_m,
        predicted.velocity_m_s / actual.velocity_m_s,
        predicted.attitude_rad / actual.attitude_rad,
    ]
}

/// Two minutes against the hour that follows from them: the prediction is never less, and no more than without Schuler. An
/// algorithm's errors at rest and straight on are steady, so each is counted at most twice (see `Growth`) where it exceeds the
/// reference's uncertainty; on the move they turn with the vehicle. The largest factors are the README's.
#[test]
fn two_minutes_predict_an_hour() {
    let rocking = [
        (Channel::Roll, 0.01, 0.5, 0.0),
        (Channel::Pitch, 0.01, 0.5, 1.57),
        (Channel::Course, 0.3, 1.0 / 120.0, 0.3),
    ];
    let (rate_hz, hour_s) = (10.0, 3600.0);
    // Largest factors of the rocking flight in position and velocity: bounded and free vertical channel.
    let (mut bounded, mut free) = ([0.0_f64; 2], [0.0_f64; 2]);
    for (name, start, manoeuvre) in [
        ("rest", REST, Manoeuvre::Rest { duration_s: hour_s }),
        ("straight", CRUISE, Manoeuvre::Straight { duration_s: hour_s }),
        ("rocking", CRUISE, sinusoids(hour_s, rocking)),
    ] {
        let flight = Flight::new(&start, &[manoeuvre]).unwrap();
        let hour = samples(&flight, rate_hz, hour_s);
        let piece = &hour[..=1200];
        for vertical in [VerticalMode::FollowTruth, VerticalMode::Damped, VerticalMode::Free] {
            let options = Options { vertical, ..options_at(rate_hz) };
            let reference = reference(&options, &hour);
            let piece = Piece::new(&options, piece).unwrap();
            let growth = Growth::new(&piece, hour_s, vertical);
            for rung in ladder(options.frame).iter().filter(|rung| rung.updates_per_sample == 1) {
                let states = navigated(&rung.applied_to(&options), &hour);
                let measured = worst_difference(&states[..1200], &reference[..1200]);
                let actual = worst_difference(&states, &reference);
                let rounding =
                    SolutionError { position_m: 5.7e-9, velocity_m_s: 7.1e-12, attitude_rad: 8.9e-16 };
                let predicted = growth.of(&measured.plus(&rounding));
                let factors = factors(&predicted, &actual);
                println!("{name} {vertical:?} {rung:?}: factors {factors:.2?}");
                assert!(factors.iter().all(|factor| *factor >= 1.0), "{name} {rung:?}: {factors:?}");
                let bound = without_schuler(&piece, hour_s, vertical, &measured.plus(&rounding));
                assert!(exceeds_nowhere(&predicted, &bound), "{name} {rung:?}: {predicted:?} {bound:?}");
                if name == "rocking" {
                    let largest = if vertical == VerticalMode::Free { &mut free } else { &mut bounded };
                    *largest = [0, 1].map(|k| largest[k].max(factors[k]));
                }
                let steady = name != "rocking" && vertical == VerticalMode::FollowTruth;
                if steady && measured.position_m > 10.0 * rounding.position_m {
                    assert!(factors[0] < 2.0 && factors[1] < 2.0, "{name} {rung:?}: {factors:?}");
                }
            }
        }
    }
    assert_eq!([bounded, free].map(|largest| largest.map(f64::round)), [[160.0, 150.0], [333.0, 610.0]]);
}

/// The same prediction for single causes, which no algorithm has so pure: a sensor's bias along each axis, at rest.
#[test]
fn seconds_and_minutes_of_a_bias_predict_an_hour() {
    let (rate_hz, hour_s) = (10.0, 3600.0);
    let flight = Flight::new(&REST, &[Manoeuvre::Rest { duration_s: hour_s }]).unwrap();
    let hour = samples(&flight, rate_hz, hour_s);
    for vertical in [VerticalMode::FollowTruth, VerticalMode::Damped, VerticalMode::Free] {
        let options = Options { vertical, ..options_at(rate_hz) };
        let ideal = navigated(&options, &hour);
        for axis in 0..6 {
            let mut simulator = Simulator::new(&options).unwrap();
            let mut bias = nalgebra::Vector3::zeros();
            // A thousandth of a degree an hour, or a ten-millionth of g: small enough to be linear.
            bias[axis % 3] = if axis < 3 { 1e-3 * DEG_PER_HOUR } else { 1e-7 * G };
            let parameters = TriadParameters { bias, ..Default::default() };
            if axis < 3 {
                simulator.set_gyro(&parameters).unwrap();
            } else {
                simulator.set_accel(&parameters).unwrap();
            }
            let states = navigated_by(&mut simulator, &hour);
            let actual = worst_difference(&states, &ideal);
            for count in [100, 1200] {
                let piece = Piece::new(&options, &hour[..=count]).unwrap();
                let measured = worst_difference(&states[..count], &ideal[..count]);
                let predicted = Growth::new(&piece, hour_s, vertical).of(&measured);
                let factors = factors(&predicted, &actual);
                println!(
                    "{vertical:?} axis {axis}, {count} samples: {}, factors {factors:.3?}",
                    told(&actual)
                );
                // A millionth covers what is not linear, as the solution moves away.
                let least = if axis < 3 { 3 } else { 2 };
                assert!(
                    factors[..least].iter().all(|factor| *factor >= 1.0 - 1e-6),
                    "{vertical:?} {axis}: {factors:?}"
                );
                // A turn about the vertical does not act on velocity steadily: the Earth's rotation acts more and more.
                if vertical == VerticalMode::FollowTruth && axis != 2 {
                    assert!(factors[0] < 2.0 && factors[1] < 2.0, "axis {axis}: {factors:?}");
                }
                let bound = without_schuler(&piece, hour_s, vertical, &measured);
                assert!(exceeds_nowhere(&predicted, &bound), "{vertical:?} {axis}: {predicted:?} {bound:?}");
            }
        }
    }
}

/// Up to the duration of the piece the errors are those of the piece; a longer duration never has smaller ones.
#[test]
fn errors_are_the_pieces_own_at_first_and_only_grow() {
    let piece =
        Piece { duration_s: 120.0, speed_m_s: 200.0, velocity_change_m_s: 50.0, ..Default::default() };
    let measured = SolutionError { position_m: 3.0, velocity_m_s: 0.2, attitude_rad: 1e-5 };
    for vertical in [VerticalMode::Damped, VerticalMode::FollowTruth, VerticalMode::Free] {
        let at = |duration_s| Growth::new(&piece, duration_s, vertical).of(&measured);
        for duration_s in [1.0, 119.9, 120.0, 120.0 + 1e-9] {
            let first = at(duration_s);
            assert_eq!(first, measured, "{vertical:?} {duration_s}");
        }
        let mut before = measured;
        for step in 1..4000 {
            let after = at(f64::from(step) * 250.0);
            assert!(
                after.position_m >= before.position_m && after.position_m.is_finite(),
                "{step} {after:?}"
            );
            assert!(after.velocity_m_s >= before.velocity_m_s && after.attitude_rad >= before.attitude_rad);
            before = after;
        }
    }
}

/// Responses of Schuler's pendulum (r' = v + u, v' = -ω² r + nabla + g a, a' = eps) to each steady rate alone, the worst
/// until `t`: position, velocity, attitude.
fn steady(source: usize, t: f64) -> SolutionError {
    let (omega, g) = (1.0 / 806.0, 9.8);
    let mut worst = SolutionError::default();
    for step in 0..=1000 {
        let t = t * f64::from(step) / 1000.0;
        let (sin, cos) = (omega * t).sin_cos();
        let (s, c) = (sin / omega, (1.0 - cos) / (omega * omega));
        let (position, velocity, attitude) = match source {
            0 => (s, -omega * omega * c, 0.0),
            1 => (c, s, 0.0),
            _ => (g * (t - s) / (omega * omega), g * c, t),
        };
        worst.position_m = worst.position_m.max(position.abs());
        worst.velocity_m_s = worst.velocity_m_s.max(velocity.abs());
        worst.attitude_rad = worst.attitude_rad.max(attitude);
    }
    worst
}

/// Never less than what follows, and less than twice as much: what is counted twice is a part.
#[test]
fn steady_rates_are_predicted_from_below_twice() {
    for source in 0..3 {
        for duration_s in [60.0, 120.0, 300.0] {
            let piece = Piece { duration_s, ..Piece::default() };
            let measured = steady(source, duration_s);
            for pieces in [1.0, 2.0, 5.0, 12.0, 30.0, 100.0] {
                let growth = Growth::new(&piece, pieces * duration_s, VerticalMode::FollowTruth);
                let (predicted, actual) = (growth.of(&measured), steady(source, pieces * duration_s));
                for (predicted, actual) in [
                    (predicted.position_m, actual.position_m),
                    (predicted.velocity_m_s, actual.velocity_m_s),
                    (predicted.attitude_rad, actual.attitude_rad),
                ] {
                    let bounds = (1.0 - 1e-9) * actual..=2.0 * actual;
                    assert!(
                        bounds.contains(&predicted),
                        "{source} {duration_s} {pieces}: {predicted} {actual}"
                    );
                }
            }
        }
    }
}
