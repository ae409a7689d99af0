//! The covariance with failures of sensors, against the scatter of many runs about their mean.

use sins::ensemble::Ensemble;
use sins::math::Euler;
use sins::sensors::{Axis, Failure, InitialErrorParameters, SensorOutput, StreamKey};
use sins::{ErrorParameters, Options, Simulator};

use super::scenes::{Scene, built_in, everything};
use super::{Range, quantile};
use crate::support::{DEG, G, resting_sample};

const RUNS: usize = 2000;
const PERIOD_S: f64 = 0.5;
/// The failure begins here, and the errors are compared after a minute of it [samples].
const FAILS_AT: usize = 121;
const END: usize = 241;

/// The variances of the nine errors over those of the covariance, in units of the interval of `range`: within -1 to 1. They are added to
/// `range` as they are.
fn compare(output: SensorOutput, failure: Failure, range: &mut Range) -> [f64; 9] {
    // Errors of the start would hide those of the sensors.
    let setting = ErrorParameters { initial: InitialErrorParameters::default(), ..everything() };
    let samples = (0..=END).map(|k| resting_sample(PERIOD_S * k as f64)).collect();
    let scene = Scene::new("failing", samples, setting);
    let mut simulator = scene.simulator(&scene.setting, true);
    let mut ensemble = Ensemble::new(&scene.simulator(&scene.setting, false), 0, RUNS).unwrap();
    for (k, sample) in scene.samples.iter().enumerate() {
        if k == FAILS_AT {
            simulator.set_failure(output, Some(failure)).unwrap();
            ensemble.set_failure(output, Some(failure)).unwrap();
        }
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        ensemble.push_sample(sample).unwrap();
        ensemble.step().unwrap();
    }
    let covariance = simulator.covariance().unwrap().unwrap().1.matrix;
    let scatter = ensemble.statistics(sins::ErrorSource::Navigation).unwrap().figures().unwrap().covariance;
    let Range { low, high, .. } = *range;
    core::array::from_fn(|row| {
        let ratio = scatter[(row, row)] / covariance[(row, row)];
        println!("{output:?} {failure:?} {row}: {ratio:.3} of {low:.3} to {high:.3}");
        range.add(ratio);
        if ratio < 1.0 { -(1.0 - ratio) / (1.0 - low) } else { (ratio - 1.0) / (high - 1.0) }
    })
}

/// After a minute with a dead gyro the tilt is 4e-3 rad, so that the linear equations are right to a percent.
#[test]
fn a_failure_changes_the_scatter_as_the_covariance_says() {
    // The interval of 99.9 % for all.
    let mut range = Range::new((RUNS - 1) as f64, quantile(0.001 / 2.0 / 45.0));
    for (output, failure) in [
        (SensorOutput::Gyro(Axis::Y), Failure::Dead),
        (SensorOutput::Accelerometer(Axis::X), Failure::Dead),
        (SensorOutput::Accelerometer(Axis::Y), Failure::Noise { density: 1e-4 * G }),
        (SensorOutput::Gyro(Axis::X), Failure::Noise { density: 0.05 * DEG / 60.0 }),
        (SensorOutput::Gyro(Axis::Y), Failure::DropOuts { interval_s: 0.0, probability: 0.25 }),
    ] {
        for (row, place) in compare(output, failure, &mut range).into_iter().enumerate() {
            assert!(place.abs() <= 1.0, "{output:?} {failure:?}, error {row}: {place:.2} of the interval");
        }
    }
    println!("figure: variances {range}");
}

/// Rolls at 1 deg/s to and fro about the forward axis, y, of which a quarter is lost. The mean tilt is a quarter of the roll, whatever this
/// run lost. Beyond 2 degrees the equations are not linear, and what they have got wrong by then stays, also when the vehicle has rolled
/// back. The standard deviation of the tilt is far below that.
#[test]
fn a_mean_beyond_the_linear_equations_is_flagged() {
    const PERIOD_S: f64 = 0.1;
    let output = SensorOutput::Gyro(Axis::Y);
    let drop_outs = Failure::DropOuts { interval_s: 0.0, probability: 0.25 };
    let (mut alone, mut compared) = (0, 0);
    let flights = [(0, 400), (1, 400), (2, 60), (3, 120), (4, 120)];
    for (run, back_at) in flights {
        let key = StreamKey { seed: 7, run };
        let mut simulator = Simulator::new(&Options { covariance: true, key, ..Options::default() }).unwrap();
        let mut is_beyond = false;
        for k in 0..=400 {
            let mut sample = resting_sample(PERIOD_S * f64::from(k));
            let steps = if (k / back_at) % 2 == 0 { k % back_at } else { back_at - k % back_at };
            sample.euler = Euler { roll: PERIOD_S * f64::from(steps) * DEG, ..Euler::default() };
            simulator.push_sample(&sample).unwrap();
            if k == 1 {
                simulator.set_failure(output, Some(drop_outs)).unwrap();
            }
            simulator.step().unwrap();
            if k == 0 {
                continue;
            }
            let (_, covariance, _) = simulator.covariance().unwrap().unwrap();
            let tilt =
                simulator.errors(sins::ErrorSource::Navigation).unwrap().unwrap().1.misalignment_n.norm();
            let mean = 0.25 * sample.euler.roll;
            // The mean of the linear equations is within their square of it.
            let is_close = (mean - 0.035).abs() < 0.035 * 0.035;
            is_beyond |= mean >= 0.035;
            if !is_close {
                assert_eq!(
                    covariance.outside_validity,
                    is_beyond || tilt >= 0.035,
                    "{run}, {k}: {mean} {tilt}"
                );
                compared += 1;
            }
            alone += u32::from(is_beyond && tilt < 0.035);
            assert!(covariance.sigma()[6..].iter().all(|sigma| *sigma < 0.02));
        }
    }
    assert!(alone > 100, "{alone}");
    println!("figure: each of {compared} samples of {} runs", flights.len());
}

/// A gyro that loses 2 % of aerobatics: after 200 s the squares of the errors about their mean are thrice those of the covariance, which
/// each run says, also one whose own error is small.
#[test]
fn the_flag_of_drop_outs_in_turns_is_that_of_every_run() {
    let (mut flagged, mut small) = (Vec::new(), 0);
    for run in 0..12 {
        let scene = Scene::new("failing", built_in("aerobatics", 200.0, 0.1), everything());
        let options = *scene.simulator(&scene.setting, true).options();
        let mut simulator = Simulator::new(&Options { key: StreamKey { seed: 7, run }, ..options }).unwrap();
        scene.setting.set_to(&mut simulator).unwrap();
        for (k, sample) in scene.samples.iter().enumerate() {
            if k == 3 {
                let failure = Failure::DropOuts { interval_s: 0.0, probability: 0.02 };
                simulator.set_failure(SensorOutput::Gyro(Axis::Z), Some(failure)).unwrap();
            }
            simulator.push_sample(sample).unwrap();
            simulator.step().unwrap();
        }
        let error = simulator.errors(sins::ErrorSource::Navigation).unwrap().unwrap().1.misalignment_n.norm();
        flagged.push(simulator.covariance().unwrap().unwrap().1.outside_validity);
        small += u32::from(error < 0.035);
    }
    assert!(small > 0 && flagged.iter().all(|flag| *flag), "{small}: {flagged:?}");
    println!("figure: all {}, also the {small} whose own error is small", flagged.len());
}
