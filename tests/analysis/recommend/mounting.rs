//! The place of the sensor block decides what its algorithm has to integrate.

use nalgebra::Vector3;
use sins::abi::SINS_OK;
use sins::analysis::recommend::{Requirement, Rung, Setup, ladder, recommend};
use sins::math::Euler;
use sins::mechanization::{Scheme, VerticalMode};
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorSource, Options, Simulator, Step};

use super::{CRUISE, asked_through_the_interface, samples};
use crate::support::options_at;

const RATE_HZ: f64 = 25.0;
/// A limit of 2 cm, with a margin of 2.
const REQUIREMENT: Requirement =
    Requirement { duration_s: 0.0, position_m: 0.02, velocity_m_s: 0.0, attitude_rad: 0.0, margin: 2.0 };

/// A light twin's take-off. At 1.3 s a jolt of the undercarriage pitches it by exp(-x²/2) of 0.2 rad, x in 0.05 s: at up to
/// 2.4 rad/s about the reference point, which senses nothing of it.
fn take_off() -> Vec<FlightSample> {
    let start = FlightStart { speed_m_s: 0.0, height_m: 300.0, pitch_rad: 0.03, ..CRUISE };
    let manoeuvres = [
        Manoeuvre::Accelerate { duration_s: 25.0, speed_change_m_s: 45.0 },
        Manoeuvre::Climb { duration_s: 35.0, height_change_m: 200.0, ramp_s: 4.0 },
    ];
    let flight = Flight::new(&start, &manoeuvres).unwrap();
    let mut samples = samples(&flight, RATE_HZ, flight.duration_s());
    let width_s = 0.05;
    for sample in &mut samples {
        let x = (sample.time_s - 1.3) / width_s;
        sample.euler.pitch += 2.4 * width_s * (0.5 - 0.5 * x * x).exp();
    }
    samples
}

fn off_centre() -> Setup {
    let options = Options { vertical: VerticalMode::Damped, ..options_at(RATE_HZ) };
    let lever_arm_m = Vector3::new(1.5, 3.0, -0.8);
    Setup { options, mounting: MountingParameters { lever_arm_m, ..Default::default() } }
}

fn mounted(setup: &Setup) -> Simulator {
    let mut simulator = Simulator::new(&setup.options).unwrap();
    simulator.set_mounting(&setup.mounting).unwrap();
    simulator
}

/// Largest distance from the truth to the navigation of an INS with ideal sensors [m].
fn flown(setup: &Setup, samples: &[FlightSample]) -> f64 {
    let mut simulator = mounted(setup);
    let mut worst = 0.0;
    for sample in samples {
        simulator.push_sample(sample).unwrap();
        if simulator.step().unwrap() == Step::Done {
            let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
            worst = f64::max(worst, errors.position_n.norm());
        }
    }
    worst
}

/// With the mounting the error of the answer is the predicted one, by the triangle inequality up to the reference's own error and
/// uncertainty; everything cheaper errs by more than is allowed. Without the mounting the answer errs by 30 times the limit.
#[test]
fn the_answer_for_a_block_off_the_reference_point_holds_there() {
    let (samples, setup) = (take_off(), off_centre());
    let finest = Rung { scheme: Scheme::Polynomial, subsamples: 5, updates_per_sample: 16 };
    let reference_m = flown(&setup.with(&finest), &samples);
    let answer = recommend(&setup, &samples, &REQUIREMENT).unwrap();
    let left_m = flown(&setup.with(&answer.rung), &samples);
    let predicted_m = answer.predicted.position_m;
    assert!(answer.met && left_m <= REQUIREMENT.position_m, "{answer:?}: {left_m} m");
    // Metres along the ellipsoid and across it differ by a millionth.
    let apart_m = reference_m + answer.uncertainty.position_m + 1e-6 * left_m;
    assert!((left_m - predicted_m).abs() <= apart_m, "{left_m} m, predicted {predicted_m} m, {apart_m}");
    let mut next_cheaper_m = 0.0;
    for rung in ladder(setup.options.frame).iter().take_while(|rung| **rung != answer.rung) {
        next_cheaper_m = flown(&setup.with(rung), &samples);
        assert!(REQUIREMENT.margin * next_cheaper_m > REQUIREMENT.position_m, "{rung:?}: {next_cheaper_m} m");
    }
    println!(
        "take-off, block 3.4 m off: {:?}: {left_m:e} m, {predicted_m:e} m predicted; next cheaper: {next_cheaper_m:.1e} m; {} tried",
        answer.rung, answer.tried,
    );

    let alone = recommend(&setup.options.into(), &samples, &REQUIREMENT).unwrap();
    let left_m = flown(&setup.with(&alone.rung), &samples);
    println!("the answer without the mounting: {:?}, {left_m} m left", alone.rung);
    assert!(alone.met && left_m > 20.0 * REQUIREMENT.position_m, "{alone:?}: {left_m} m");

    let (status, [scheme, subsamples, updates], cost) =
        asked_through_the_interface(&samples, &setup, &REQUIREMENT);
    assert_eq!((status, cost.position_m), (SINS_OK, predicted_m));
    let Rung { scheme: best, subsamples: of, updates_per_sample } = answer.rung;
    assert_eq!([scheme, subsamples, updates], [best as i32, of as i32, updates_per_sample as i32]);
}

/// A simulator with errors in everything, before a flight and in one, gives the same answer as one without errors.
#[test]
fn what_errs_in_a_configured_simulator_takes_no_part() {
    let (samples, setup) = (take_off(), off_centre());
    let piece = &samples[..100];
    let expected = recommend(&setup, piece, &REQUIREMENT).unwrap();
    let mut mounting = setup.mounting;
    mounting.lever_arm_error_m = Vector3::new(1.0, -2.0, 3.0);
    mounting.boresight_error = Euler { roll: 0.1, pitch: -0.2, heading: 0.3 };
    let mut simulator = mounted(&Setup { mounting, ..setup });
    let bias = Vector3::repeat(1e-3);
    simulator.set_gyro(&TriadParameters { bias, ..Default::default() }).unwrap();
    simulator
        .set_accel(&TriadParameters {
            bias,
            lever_arm_m: nalgebra::Matrix3::identity(),
            ..Default::default()
        })
        .unwrap();
    let misalignment_n = Vector3::new(0.1, 0.2, 0.3);
    simulator.set_initial_errors(&InitialErrorParameters { misalignment_n, ..Default::default() }).unwrap();
    assert_eq!(recommend(&Setup::of(&simulator), piece, &REQUIREMENT), Ok(expected));
    for sample in &samples[..10] {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
    }
    assert_eq!(recommend(&Setup::of(&simulator), piece, &REQUIREMENT), Ok(expected));
}
