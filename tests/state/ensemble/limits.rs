//! Impossible ensembles and runs outside of the ensemble are rejected. Runs that diverge are left out and listed.

use sins::earth::Geodetic;
use sins::ensemble::Ensemble;
use sins::math::Euler;
use sins::mechanization::Frame;
use sins::sensors::{Alignment, Axis, Failure, InitialErrorParameters, SensorOutput};
use sins::truth::{FlightSample, Pushed};
use sins::{ErrorKind, ErrorSource, ImuFlags, Options, Simulator, Step};

use super::{doomed, template};
use crate::support::resting_sample;

#[test]
fn what_cannot_be_made_is_refused_by_name() {
    let refused = |template: &Simulator, first_run, runs| {
        let error = Ensemble::new(template, first_run, runs).unwrap_err();
        (error.kind, error.to_string())
    };
    let invalid = |text: &str| (ErrorKind::InvalidArgument, text.to_owned());
    let mut template = template();
    assert_eq!(refused(&template, 0, 0), invalid("runs = 0: must be from 1 to 4294967295"));
    let (kind, text) = refused(&template, u64::MAX, 2);
    assert!(kind == ErrorKind::InvalidArgument && text.starts_with("first_run = 18446744073709551615: "));
    assert_eq!(Ensemble::new(&template, u64::MAX, 1).unwrap().first_run(), u64::MAX);

    // A simulator with a sample in the queue, in flight, or after a reposition is no template. After a reset it is
    // a template again.
    template.push_sample(&resting_sample(0.0)).unwrap();
    assert_eq!(refused(&template, 0, 1).0, ErrorKind::BadState);
    template.push_sample(&resting_sample(0.1)).unwrap();
    template.step().unwrap();
    assert_eq!(refused(&template, 0, 1).0, ErrorKind::BadState);
    template.reposition(&resting_sample(5.0)).unwrap();
    assert_eq!(refused(&template, 0, 1).0, ErrorKind::BadState);
    template.reset();
    Ensemble::new(&template, 0, 1).unwrap();
}

#[test]
fn a_run_that_is_none_is_refused_with_the_limits() {
    let ensemble = Ensemble::new(&template(), 40, 3).unwrap();
    for run in [0, 39, 43, u64::MAX] {
        let expected = format!("run = {run}: must be from 40 to 42");
        for error in [
            ensemble.navigation(run).unwrap_err(),
            ensemble.errors(run, ErrorSource::Navigation).unwrap_err(),
            ensemble.imu(run).unwrap_err(),
        ] {
            assert_eq!((error.kind, error.to_string()), (ErrorKind::InvalidArgument, expected.clone()));
        }
    }
}

#[test]
fn before_the_first_samples_there_is_nothing_and_gaps_are_told() {
    let mut ensemble = Ensemble::new(&template(), 40, 2).unwrap();
    assert_eq!((ensemble.truth(), ensemble.navigation(40), ensemble.imu(41)), (None, Ok(None), Ok(None)));
    assert_eq!(ensemble.step(), Ok(Step::NeedSample));
    for k in 0..4 {
        assert_eq!(ensemble.push_sample(&resting_sample(0.1 * f64::from(k))), Ok(Pushed::Regular));
    }
    assert_eq!(ensemble.push_sample(&resting_sample(1.5)), Ok(Pushed::BehindGap));
    let late = ensemble.push_sample(&resting_sample(9.0)).unwrap_err();
    assert_eq!(late.kind, ErrorKind::Discontinuity);
    assert_eq!(ensemble.push_sample(&resting_sample(1.5)).unwrap_err().kind, ErrorKind::TimeOrder);
    for _ in 0..4 {
        assert_eq!(ensemble.step(), Ok(Step::Done));
    }
    assert_eq!((ensemble.step(), ensemble.intervals()), (Ok(Step::NeedSample), 4));
    for k in 0..16 {
        ensemble.push_sample(&resting_sample(1.6 + 0.1 * f64::from(k))).unwrap();
    }
    assert_eq!(ensemble.push_sample(&resting_sample(3.3)).unwrap_err().kind, ErrorKind::QueueFull);
}

/// The flags are those of an interval, which a truth that was moved does not have.
#[test]
fn without_an_interval_no_flag_is_set() {
    // Eight runs in lanes, and two alone.
    let mut ensemble = Ensemble::new(&template(), 0, 10).unwrap();
    let output = SensorOutput::Accelerometer(Axis::X);
    let silent = ImuFlags { accel_invalid: true, ..ImuFlags::default() };
    for from_s in [0.0, 7.0] {
        ensemble.set_failure(output, Some(Failure::Dead)).unwrap();
        ensemble.push_sample(&resting_sample(from_s)).unwrap();
        ensemble.push_sample(&resting_sample(from_s + 0.1)).unwrap();
        assert_eq!(ensemble.step(), Ok(Step::Done));
        assert!(ensemble.imu_flags().all(|flags| flags == silent));
        if from_s == 0.0 {
            ensemble.reset();
        } else {
            ensemble.reposition(&resting_sample(9.0)).unwrap();
        }
        assert_eq!(ensemble.imu(3), Ok(None));
        assert!(ensemble.imu_flags().eq([ImuFlags::default(); 10]));
    }
}

/// The truth and all other runs continue as without the diverged run; a restart brings it back.
#[test]
fn a_run_that_diverges_is_left_out_and_named() {
    let mut ensemble = doomed(100, 20);
    let mut counts = Vec::new();
    for k in 0..90 {
        ensemble.push_sample(&resting_sample(f64::from(k))).unwrap();
        ensemble.step().unwrap();
        let diverged: Vec<u64> = ensemble.diverged().collect();
        let statistics = ensemble.statistics(ErrorSource::Navigation).unwrap();
        assert_eq!((statistics.runs, statistics.diverged), (20, diverged.len() as u64));
        for &run in &diverged {
            let error = ensemble.navigation(run).unwrap_err();
            assert_eq!((error.kind, error.field), (ErrorKind::Diverged, "run"));
            assert!(error.to_string().contains("has diverged; its last good solution was at time_s = "));
        }
        counts.push(diverged.len());
    }
    assert!(counts[0] == 0 && counts.iter().any(|&count| count > 0 && count < 20), "{counts:?}");
    assert_eq!(counts[89], 20, "all of them at last");
    assert_eq!((ensemble.truth().unwrap().time_s, ensemble.intervals()), (89.0, 89));

    // Two halves of the ensemble lose the same runs.
    let mut halves = [100, 110].map(|first_run| doomed(first_run, 10));
    for (k, &count) in counts.iter().enumerate() {
        let both = halves.iter_mut().map(|half| {
            half.push_sample(&resting_sample(k as f64)).unwrap();
            half.step().unwrap();
            half.diverged().count()
        });
        assert_eq!(both.sum::<usize>(), count);
    }

    ensemble.reposition(&resting_sample(1000.0)).unwrap();
    assert_eq!((ensemble.diverged().count(), ensemble.intervals()), (0, 0));
    ensemble.navigation(100).unwrap().unwrap();
    ensemble.reset();
    assert_eq!(ensemble.truth(), None);
}

/// A truth that no run can follow is an error of the call, which changes nothing.
#[test]
fn a_truth_that_no_run_can_follow_is_refused() {
    let at = |k: u32, latitude_rad: f64| {
        let place = Geodetic { latitude_rad, longitude_rad: 1.0, height_m: 100.0 };
        FlightSample::at_rest(f64::from(k), place, Euler::default())
    };
    let pole = std::f64::consts::FRAC_PI_2;
    let geographic = Options { frame: Frame::Geographic, ..Options::default() };
    let mut gyrocompass = Simulator::new(&Options::default()).unwrap();
    gyrocompass
        .set_initial_errors(&InitialErrorParameters {
            alignment: Alignment::LevelAndGyrocompass,
            ..Default::default()
        })
        .unwrap();
    for template in [Simulator::new(&geographic).unwrap(), gyrocompass] {
        let mut ensemble = Ensemble::new(&template, 0, 2).unwrap();
        ensemble.push_sample(&at(0, pole)).unwrap();
        ensemble.push_sample(&at(1, pole)).unwrap();
        assert_eq!(ensemble.step().unwrap_err().kind, ErrorKind::Singular);
        assert_eq!((ensemble.diverged().count(), ensemble.intervals()), (0, 0));
        ensemble.reset();
        ensemble.push_sample(&at(0, 0.7)).unwrap();
        ensemble.push_sample(&at(1, 0.7)).unwrap();
        assert_eq!(ensemble.step(), Ok(Step::Done));
    }
}
