//! A saved ensemble continues to the same bits; a damaged snapshot is rejected.

use nalgebra::Vector3;
use sins::ensemble::Ensemble;
use sins::errors::correction::{Compensation, Correction};
use sins::sensors::InitialErrorParameters;
use sins::snapshot::{SnapshotOf, seal};
use sins::truth::FlightSample;
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use super::{doomed, fly, template, template_with};
use crate::support::moments::{Call, flown, samples, setting};
use crate::support::resting_sample;
use crate::support::runs::{everything_at_once, unusual_options};

fn saved(ensemble: &Ensemble) -> Vec<u8> {
    let mut bytes = vec![0; ensemble.snapshot_size()];
    assert_eq!(ensemble.save_snapshot(&mut bytes), Ok(bytes.len()));
    bytes
}

/// Forty samples with every effect of the sensors.
fn with_every_effect() -> Vec<Call> {
    let mut calls = setting();
    calls.extend(flown(samples(40, 0.01)));
    calls
}

/// At every moment, a snapshot is loaded into an ensemble of another kind, which then continues to
/// the same bits.
#[test]
fn a_saved_ensemble_goes_on_to_the_same_bits() {
    for (runs, options, calls) in [
        (11, unusual_options(), everything_at_once().calls),
        (2, unusual_options(), everything_at_once().calls),
        (18, Options { error_model: true, ..Options::default() }, with_every_effect()),
        (11, Options::default(), with_every_effect()),
    ] {
        let mut pair = fly(&options, &calls[..12], 1, runs, "to be saved");
        let mut other = Ensemble::new(&Simulator::new(&Options::default()).unwrap(), 9, 1).unwrap();
        for (k, call) in calls.iter().enumerate().skip(12) {
            let bytes = saved(&pair.ensemble);
            other.load_snapshot(&bytes).unwrap();
            assert_eq!(saved(&other), bytes, "call {k}");
            if k % 2 == 0 {
                core::mem::swap(&mut pair.ensemble, &mut other);
            }
            pair.call(call, &format!("call {k}"));
            pair.compare(&format!("call {k}"));
        }
        assert!(pair.ensemble.intervals() > 10);
    }

    // Snapshots with some or all runs diverged.
    diverged_runs_are_saved(6);
    diverged_runs_are_saved(2);
}

fn diverged_runs_are_saved(runs: usize) {
    let mut ensemble = doomed(100, runs);
    let mut loaded = doomed(100, 1);
    for k in 0..90 {
        for ensemble in [&mut ensemble, &mut loaded] {
            ensemble.push_sample(&resting_sample(f64::from(k))).unwrap();
            ensemble.step().unwrap();
        }
        loaded.load_snapshot(&saved(&ensemble)).unwrap();
        assert!(loaded.diverged().eq(ensemble.diverged()) && loaded.truth() == ensemble.truth());
        assert_eq!(saved(&loaded), saved(&ensemble), "after {k} s");
    }
    assert_eq!(ensemble.diverged().count(), runs);
    for ensemble in [&mut ensemble, &mut loaded] {
        ensemble.reposition(&resting_sample(300.0)).unwrap();
        ensemble.push_sample(&resting_sample(301.0)).unwrap();
        ensemble.step().unwrap();
    }
    assert_eq!(saved(&loaded), saved(&ensemble));
}

/// The signals of the last interval are saved as they were navigated on, also if their compensation has been cancelled since.
#[test]
fn a_cancelled_compensation_is_in_the_last_signals() {
    let gyro_bias = Vector3::new(1e-3, 0.0, -2e-3);
    let correction = |gyro_bias| Correction {
        sensors: Compensation { gyro_bias, ..Default::default() },
        ..Default::default()
    };
    let new = || Ensemble::new(&Simulator::new(&Options::default()).unwrap(), 0, 2).unwrap();
    let (mut ensemble, mut loaded) = (new(), new());
    let step = |ensemble: &mut Ensemble, k: i32| {
        ensemble.push_sample(&resting_sample(f64::from(k))).unwrap();
        ensemble.step().unwrap();
    };
    (0..2).for_each(|k| step(&mut ensemble, k));
    ensemble.correct(1, &correction(gyro_bias)).unwrap();
    step(&mut ensemble, 2);
    ensemble.correct(1, &correction(-gyro_bias)).unwrap();
    assert_eq!(ensemble.compensation(1), Ok(Compensation::default()));

    let imu = ensemble.imu(1).unwrap().unwrap();
    assert!(imu.compensated.angle != imu.measured.angle);
    loaded.load_snapshot(&saved(&ensemble)).unwrap();
    assert_eq!(loaded.imu(1).unwrap(), Some(imu));
    for k in 3..6 {
        assert_eq!(saved(&loaded), saved(&ensemble), "before {k} s");
        step(&mut ensemble, k);
        step(&mut loaded, k);
    }
}

/// Runs that cannot start, because their initial errors are beyond the limits.
#[test]
fn runs_that_could_not_start_are_saved_too() {
    let mut template = Simulator::new(&Options::default()).unwrap();
    let (position_n, position_sigma_n) = (Vector3::new(0.0, 0.0, -450e3), Vector3::new(0.0, 0.0, 1e5));
    let initial = InitialErrorParameters { position_n, position_sigma_n, ..Default::default() };
    template.set_initial_errors(&initial).unwrap();
    for runs in [2, 18, 19] {
        let (mut ensemble, mut loaded) =
            (Ensemble::new(&template, 1, runs).unwrap(), Ensemble::new(&template, 7, 2).unwrap());
        for k in 0..5 {
            ensemble.push_sample(&resting_sample(f64::from(k))).unwrap();
            ensemble.step().unwrap();
            let bytes = saved(&ensemble);
            loaded.load_snapshot(&bytes).unwrap();
            assert!(
                saved(&loaded) == bytes && loaded.diverged().eq(ensemble.diverged()),
                "{runs} runs after {k} s"
            );
            core::mem::swap(&mut loaded, &mut ensemble);
        }
        let count = ensemble.diverged().count();
        assert!(count > 0 && count < runs, "{count} of {runs}");
    }
}

#[test]
fn a_damaged_snapshot_is_refused_and_changes_nothing() {
    let [without, with] = [false, true].map(damage);
    println!("figure: {} of {} altered ones were ensembles", without.0 + with.0, without.1 + with.1);
}

/// Returns how many forged snapshots were ensembles, and of how many.
fn damage(error_model: bool) -> (usize, usize) {
    let flying = |runs| {
        let mut ensemble = Ensemble::new(&template_with(error_model), 3, runs).unwrap();
        for sample in samples(5, 0.01) {
            ensemble.push_sample(&sample).unwrap();
            ensemble.step().unwrap();
        }
        ensemble
    };
    let (ensemble, mut other) = (flying(2), flying(1));
    let (good, before) = (saved(&ensemble), saved(&other));
    let mut small = vec![0; good.len() - 1];
    assert_eq!(ensemble.save_snapshot(&mut small).unwrap_err().kind, ErrorKind::BufferTooSmall);

    let mut refused = |bytes: &[u8], what: &str| {
        let error = other.load_snapshot(bytes).unwrap_err();
        assert_eq!(error.kind, ErrorKind::Snapshot, "{what}: {error}");
        assert_eq!(saved(&other), before, "{what}");
        error.to_string()
    };
    // Every byte of the header, and every seventh byte of the rest.
    for at in (0..24).chain((24..good.len()).step_by(7)) {
        let mut altered = good.clone();
        altered[at] ^= 0x10;
        refused(&altered, "an altered byte");
        refused(&good[..at], "cut off");
    }
    let single = {
        let simulator = template();
        let mut bytes = vec![0; simulator.snapshot_size()];
        simulator.save_snapshot(&mut bytes).unwrap();
        bytes
    };
    assert!(refused(&single, "of a simulator").ends_with("it is one of a simulator"));
    let error = template().load_snapshot(&good).unwrap_err();
    assert!(error.to_string().ends_with("it is one of an ensemble"));

    // A forged snapshot with the right checksum is rejected, or it is an ensemble that can be flown
    // and read.
    let mut taken = 0;
    for at in (24..good.len()).step_by(5) {
        let mut forged = good.clone();
        forged[at] ^= 1;
        seal(&mut forged, SnapshotOf::Ensemble);
        let mut ensemble = flying(1);
        if ensemble.load_snapshot(&forged).is_ok() {
            taken += 1;
            let first = ensemble.first_run();
            let Some(truth) = ensemble.truth() else { continue };
            let next = FlightSample { time_s: truth.time_s + 0.01, ..samples(1, 0.01).next().unwrap() };
            let _ = ensemble.push_sample(&next).and_then(|_| ensemble.step());
            let _ = ensemble.navigation(first);
            if let Ok(statistics) = ensemble.statistics(ErrorSource::Navigation) {
                statistics.figures().unwrap();
            }
            assert_eq!(saved(&ensemble).len(), ensemble.snapshot_size());
        } else {
            assert_eq!(saved(&ensemble), saved(&flying(1)));
        }
    }
    (taken, (good.len() - 24).div_ceil(5))
}
