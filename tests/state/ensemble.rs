//! Run k of an ensemble is the single simulator of that number: to the bit, whatever a host does that keeps the rules.
//!
//! 300 hosts of 120 calls here; 5000 with `cargo test --release --features long-tests --test ensemble -- --nocapture`.

use crate::support::any_use::{Draws, Host};
use crate::support::moments::{
    Call, Run, every_effect, everything_at_once, flown, runs, samples, setting, unusual_options,
};
use crate::support::resting_sample;
use nalgebra::Vector3;
use sins::earth::{Geodetic, GravityModel};
use sins::ensemble::Ensemble;
use sins::math::Euler;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{
    Alignment, Axis, Failure, InitialErrorParameters, PARAMETERS, SensorOutput, StreamKey, TriadParameters,
};
use sins::snapshot::{SnapshotOf, seal};
use sins::truth::{FlightSample, Pushed};
use sins::{Error, ErrorKind, ErrorSource, Options, Simulator, Step};

const HOSTS: u64 = if cfg!(feature = "long-tests") { 5000 } else { 300 };
const CALLS: usize = 120;

/// An ensemble beside the single simulators that its runs have to be.
struct Pair {
    ensemble: Ensemble,
    singles: Vec<Simulator>,
    diverged: Vec<bool>,
}

impl Pair {
    fn new(template: &Simulator, setting: &[Call], first_run: u64, count: usize) -> Self {
        let ensemble = Ensemble::new(template, first_run, count).unwrap();
        let singles = (0..count as u64).map(|k| {
            let key = StreamKey { run: first_run + k, ..template.options().key };
            let mut single = Simulator::new(&Options { key, ..*template.options() }).unwrap();
            for call in setting {
                call.make(&mut single);
            }
            single
        });
        Self { singles: singles.collect(), ensemble, diverged: vec![false; count] }
    }

    /// Makes a call on both and compares the answers; `false`: a call that an ensemble does not have.
    fn call(&mut self, call: &Call, who: &str) -> bool {
        let ensemble = &mut self.ensemble;
        let answer = match call {
            Call::Push(sample) => format!("{:?}", ensemble.push_sample(sample)),
            Call::Step => format!("{:?}", ensemble.step()),
            Call::Reposition(sample) => format!("{:?}", ensemble.reposition(sample)),
            Call::Reset => {
                ensemble.reset();
                "reset".to_owned()
            }
            Call::Failure(output, failure) => format!("{:?}", ensemble.set_failure(*output, *failure)),
            _ => return false,
        };
        let starts_again = matches!(call, Call::Reposition(_) | Call::Reset) && !answer.starts_with("Err");
        for (single, diverged) in self.singles.iter_mut().zip(&mut self.diverged) {
            *diverged &= !starts_again;
            if *diverged && matches!(call, Call::Push(_) | Call::Step) {
                continue;
            }
            let alone = call.make(single);
            // Of a first step two things may be wrong.
            let both_failed = answer.contains("sample.latitude_rad") && alone.starts_with("Err");
            if answer == "Ok(Done)" && alone.starts_with("Err") {
                assert!(alone.contains("Diverged") || alone.contains("Singular"), "{who}: {alone}");
                *diverged = true;
            } else if !both_failed {
                assert_eq!(alone, answer, "{who}");
            }
        }
        true
    }

    /// Whatever can be read of each run.
    fn compare(&self, who: &str) {
        let ensemble = &self.ensemble;
        let mut diverged = ensemble.diverged();
        for (k, single) in self.singles.iter().enumerate() {
            let run = ensemble.first_run() + k as u64;
            let imu = ensemble.imu(run);
            if self.diverged[k] {
                assert_eq!(diverged.next(), Some(run), "{who}");
                let kind = |error: Error| (error.kind, error.field);
                assert_eq!(imu.map_err(kind), Err((ErrorKind::Diverged, "run")), "{who}");
                continue;
            }
            assert_eq!(ensemble.truth(), single.truth().unwrap(), "{who}, run {run}");
            let intervals = (ensemble.intervals(), single.intervals());
            assert_eq!(intervals.0, intervals.1, "{who}, run {run}");
            let (of_ensemble, of_single) = (ensemble.navigation(run), single.navigation());
            assert_eq!(format!("{of_ensemble:?}"), format!("{of_single:?}"), "{who}, run {run}");
            assert_eq!(format!("{imu:?}"), format!("{:?}", Ok::<_, Error>(single.imu())), "{who}, run {run}");
            for source in [ErrorSource::Navigation, ErrorSource::Model] {
                let (of_ensemble, of_single) = (ensemble.errors(run, source), single.errors(source));
                assert_eq!(format!("{of_ensemble:?}"), format!("{of_single:?}"), "{who}, run {run}");
            }
        }
        assert_eq!(diverged.next(), None, "{who}");
    }
}

/// Makes the settings of `calls` that come before the first sample, then an ensemble, then the rest.
fn fly(options: &Options, calls: &[Call], every: usize, count: usize, who: &str) -> Pair {
    let mut template = Simulator::new(options).unwrap();
    let is_sample =
        |call: &Call| matches!(call, Call::Push(_) | Call::Step | Call::Reposition(_) | Call::MoveTruth(_));
    let setting: Vec<Call> = calls.iter().take_while(|call| !is_sample(call)).cloned().collect();
    setting.iter().for_each(|call| drop(call.make(&mut template)));
    let mut pair = Pair::new(&template, &setting, options.key.run + 5, count);
    for (k, call) in calls.iter().enumerate().skip(setting.len()) {
        let who = format!("{who}, call {k}");
        if pair.call(call, &who) && k % every == 0 {
            pair.compare(&who);
        }
    }
    pair
}

#[test]
fn runs_of_an_ensemble_are_the_single_simulators() {
    for Run { name, options, calls, every } in runs().into_iter().chain([everything_at_once()]) {
        if !calls.iter().any(|call| matches!(call, Call::Start(..))) {
            let pair = fly(&options, &calls, every, 3, name);
            assert!(pair.ensemble.intervals() > 5, "{name}");
        }
    }
}

#[test]
fn whatever_a_host_does_they_are() {
    let (mut diverged, mut intervals) = (0, 0);
    for seed in 0..HOSTS {
        let mut host = Host::new(seed);
        let calls: Vec<Call> = (0..CALLS).map(|_| host.call()).collect();
        if !calls.iter().any(|call| matches!(call, Call::Start(..) | Call::Imu(..))) {
            let pair = fly(&host.options, &calls, 7, 3, &format!("host {seed}"));
            diverged += pair.diverged.iter().filter(|diverged| **diverged).count();
            intervals += pair.ensemble.intervals();
        }
    }
    println!("{HOSTS} hosts: {intervals} intervals, {diverged} runs diverged");
    assert!(diverged > 10 && intervals > 5 * HOSTS);
}

/// A random half of all effects of the sensors.
fn half(triad: TriadParameters, draws: &mut Draws) -> TriadParameters {
    let mut halved = triad;
    for (parameter, numbers) in PARAMETERS.iter().zip(halved.numbers_mut()) {
        // A process that is on needs its time constant.
        if !parameter.name.contains("time") && draws.one_in(2) {
            numbers.fill(0.0);
        }
    }
    halved
}

/// Every frame, scheme, vertical channel and signal, with and without the error model, each with another half of the effects, and
/// every other one with failures. More runs than any block or vector has.
#[test]
fn in_every_scheme_frame_channel_and_signal_with_half_of_all_effects() {
    let mut modes = Vec::new();
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for scheme in [Scheme::Exact, Scheme::Paper, Scheme::Polynomial] {
            for vertical in [VerticalMode::Damped, VerticalMode::FollowTruth, VerticalMode::Free] {
                for closed_loop_time_s in [None, Some(30.0)] {
                    for error_model in [false, true] {
                        let mode = Options {
                            frame,
                            scheme,
                            vertical,
                            closed_loop_time_s,
                            error_model,
                            ..Default::default()
                        };
                        modes.push(mode);
                    }
                }
            }
        }
    }
    assert_eq!(modes.len(), 72);
    let mut draws = Draws::new(3);
    let samples: Vec<FlightSample> = samples(120, 0.01).collect();
    for (number, mode) in modes.into_iter().enumerate() {
        let options = Options {
            subsamples: 1 + draws.below(5),
            updates_per_sample: 1 + draws.below(2),
            gravity: draws.of(&[GravityModel::default(), GravityModel::Somigliana]),
            key: StreamKey { seed: 17, run: number as u64 },
            ..mode
        };
        let (gyro, accel) = every_effect();
        let mut calls = setting();
        calls.extend([Call::Gyro(half(gyro, &mut draws)), Call::Accel(half(accel, &mut draws))]);
        let before = calls.len();
        calls.extend(flown(samples.iter().copied()));
        if draws.one_in(2) {
            let gyro = SensorOutput::Gyro(draws.of(&[Axis::X, Axis::Y, Axis::Z]));
            let noise = Failure::Noise { density: 1e-5 };
            let failure = draws.of(&[Failure::Stuck, noise, Failure::RandomDropOuts { probability: 0.3 }]);
            calls.insert(before + 60, Call::Failure(gyro, Some(failure)));
            calls.insert(before + 150, Call::Failure(gyro, None));
            calls.insert(before + 100, Call::Failure(SensorOutput::Altimeter, Some(noise)));
        }
        let pair = fly(&options, &calls, 40, 19, &format!("{options:?}"));
        assert!(pair.ensemble.intervals() == 119 && pair.ensemble.diverged().next().is_none());
    }
}

fn template() -> Simulator {
    template_with(true)
}

fn template_with(error_model: bool) -> Simulator {
    let mut template = Simulator::new(&Options { error_model, ..Options::default() }).unwrap();
    for call in setting() {
        assert!(call.make(&mut template).starts_with("Ok"));
    }
    template
}

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

    // One that waits, that flies, that starts again at a place, that navigates; and after a reset it is one again.
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

/// Free vertical channels with errors so large that some runs are thrown out of the limits soon, at last all of them.
fn doomed(first_run: u64, runs: usize) -> Ensemble {
    let options = Options { vertical: VerticalMode::Free, ..Options::default() };
    let mut template = Simulator::new(&options).unwrap();
    let up = |size: f64| Vector3::new(0.0, 0.0, size);
    let accel = TriadParameters { bias: up(4000.0), bias_sigma: up(1000.0), ..Default::default() };
    template.set_accel(&accel).unwrap();
    Ensemble::new(&template, first_run, runs).unwrap()
}

/// The truth and all others go on, to the same bits as without it; a restart brings it back.
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

    // Split in two, whose halves lose the same runs.
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

/// What no run could follow is an error of the call: nothing has changed.
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

/// At every moment: into an ensemble of another kind, which then goes on to the same bits.
#[test]
fn a_saved_ensemble_goes_on_to_the_same_bits() {
    for (options, calls) in [
        (unusual_options(), everything_at_once().calls),
        (Options { error_model: true, ..Options::default() }, with_every_effect()),
        (Options::default(), with_every_effect()),
    ] {
        let mut pair = fly(&options, &calls[..12], 1, 11, "to be saved");
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

    // With runs that have diverged, some or all.
    let mut ensemble = doomed(100, 6);
    let mut loaded = doomed(100, 1);
    for k in 0..90 {
        for ensemble in [&mut ensemble, &mut loaded] {
            ensemble.push_sample(&resting_sample(f64::from(k))).unwrap();
            ensemble.step().unwrap();
        }
        loaded.load_snapshot(&saved(&ensemble)).unwrap();
        assert!(loaded.diverged().eq(ensemble.diverged()) && loaded.truth() == ensemble.truth());
    }
    assert_eq!(ensemble.diverged().count(), 6);
    for ensemble in [&mut ensemble, &mut loaded] {
        ensemble.reposition(&resting_sample(300.0)).unwrap();
        ensemble.push_sample(&resting_sample(301.0)).unwrap();
        ensemble.step().unwrap();
    }
    assert_eq!(saved(&loaded), saved(&ensemble));
}

#[test]
fn a_damaged_snapshot_is_refused_and_changes_nothing() {
    for error_model in [false, true] {
        damage(error_model);
    }
}

fn damage(error_model: bool) {
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
    // Every byte of the header, each seventh of the rest.
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
    assert!(refused(&single, "of a simulator").ends_with("it is one of a simulator, not of an ensemble"));
    let error = template().load_snapshot(&good).unwrap_err();
    assert!(error.to_string().ends_with("it is one of an ensemble, not of a simulator"));

    // Forged, with the right checksum: refused, or an ensemble that can be flown and read.
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
    println!("{taken} of {} forged snapshots were ensembles", (good.len() - 24).div_ceil(5));
}
