//! Run k of an ensemble equals the single simulator of run k to the bit, with any calls of a host that keeps the rules.
//!
//! 300 hosts make 120 calls each by default; 5000 hosts with
//! `cargo test -p tests --release --features long-tests --test state ensemble:: -- --nocapture`.

mod limits;
mod saved;

use nalgebra::Vector3;
use sins::earth::GravityModel;
use sins::ensemble::Ensemble;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{
    Axis, Failure, InitialErrorParameters, PARAMETERS, Sensor, SensorOutput, StreamKey, TriadParameters,
};
use sins::truth::FlightSample;
use sins::{Error, ErrorKind, ErrorSource, ImuFlags, Options, Simulator};

use crate::support::any_use::Host;
use crate::support::draws::Draws;
use crate::support::moments::{Call, every_effect, flown, samples, setting};
use crate::support::runs::{Run, everything_at_once, runs};

const HOSTS: u64 = if cfg!(feature = "long-tests") { 5000 } else { 300 };
const CALLS: usize = 120;

/// An ensemble and the single simulators that its runs must equal.
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

    /// Makes a call on both and compares the answers. `false`: an ensemble does not have this call.
    fn call(&mut self, call: &Call, who: &str) -> bool {
        let ensemble = &mut self.ensemble;
        if let Call::Correct(correction) = call {
            for (k, single) in self.singles.iter_mut().enumerate().filter(|(k, _)| !self.diverged[*k]) {
                let run = ensemble.first_run() + k as u64;
                let answer = format!("{:?}", ensemble.correct(run, correction));
                assert_eq!(call.make(single), answer, "{who}, run {run}");
                assert_eq!(ensemble.compensation(run), Ok(single.compensation()), "{who}, run {run}");
            }
            return true;
        }
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
            // A first step may have two faults, and each side reports one of them.
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

    /// Compares everything that can be read of each run.
    fn compare(&self, who: &str) {
        let ensemble = &self.ensemble;
        let mut diverged = ensemble.diverged();
        let all_flags: Vec<ImuFlags> = ensemble.imu_flags().collect();
        assert_eq!(all_flags.len(), ensemble.runs(), "{who}");
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
            let flags = single.imu().unwrap_or_default().flags;
            assert_eq!(all_flags[k], flags, "{who}, run {run}");
            for source in [ErrorSource::Navigation, ErrorSource::Model] {
                let (of_ensemble, of_single) = (ensemble.errors(run, source), single.errors(source));
                assert_eq!(format!("{of_ensemble:?}"), format!("{of_single:?}"), "{who}, run {run}");
            }
        }
        assert_eq!(diverged.next(), None, "{who}");
    }
}

/// Makes the calls before the first sample on a template, creates an ensemble from it, then makes the other calls on both.
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
            // Side by side, and one by one.
            for count in [3, 2] {
                let pair = fly(&options, &calls, every, count, name);
                assert!(pair.ensemble.intervals() > 5, "{name}");
            }
        }
    }
}

#[test]
fn whatever_a_host_does_they_are() {
    let (mut hosts, mut diverged, mut intervals) = (0, 0, 0);
    for seed in 0..HOSTS {
        let mut host = Host::new(seed);
        let calls: Vec<Call> = (0..CALLS).map(|_| host.call()).collect();
        if !calls.iter().any(|call| matches!(call, Call::Start(..) | Call::Imu(..))) {
            hosts += 1;
            let count = 1 + seed as usize % 4;
            let pair = fly(&host.options, &calls, 7, count, &format!("host {seed}"));
            diverged += pair.diverged.iter().filter(|diverged| **diverged).count();
            intervals += pair.ensemble.intervals();
        }
    }
    println!("figure: {hosts} hosts, {intervals} intervals, {diverged} runs diverged");
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

/// Every frame, scheme, vertical channel and signal, with and without the error model. Each has another half of the effects, and
/// about half of them have failures. There are more runs than in any block or vector; those behind the block are few, or fewer.
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
    let count = modes.len();
    assert_eq!(count, 72);
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
            let failure =
                draws.of(&[Failure::Stuck, noise, Failure::DropOuts { interval_s: 0.0, probability: 0.3 }]);
            calls.insert(before + 60, Call::Failure(gyro, Some(failure)));
            calls.insert(before + 150, Call::Failure(gyro, None));
            calls.insert(before + 100, Call::Failure(SensorOutput::Altimeter, Some(noise)));
        }
        let pair = fly(&options, &calls, 40, draws.of(&[18, 19]), &format!("{options:?}"));
        assert!(pair.ensemble.intervals() == 119 && pair.ensemble.diverged().next().is_none());
    }
    println!("figure: {count} modes: to the bit");
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

/// Free vertical channels with errors so large that some runs diverge soon, and finally all of them.
fn doomed(first_run: u64, runs: usize) -> Ensemble {
    let options = Options { vertical: VerticalMode::Free, ..Options::default() };
    let mut template = Simulator::new(&options).unwrap();
    let up = |size: f64| Vector3::new(0.0, 0.0, size);
    let accel = TriadParameters {
        bias: up(4000.0),
        bias_sigma: up(1000.0),
        markov_sigma: up(1e-3),
        markov_time_s: up(60.0),
        ..Default::default()
    };
    template.set_accel(&accel).unwrap();
    Ensemble::new(&template, first_run, runs).unwrap()
}

/// The runs of an ensemble share the ideal signals, so these must not depend on whether a run starts with errors. The shadow of a run
/// with errors began at another rounding of the truth.
#[test]
fn the_trim_of_the_closed_loop_does_not_depend_on_the_errors_of_the_start() {
    let flight = crate::support::patrol(10.0);
    let options = Options { closed_loop_time_s: Some(30.0), ..Options::default() };
    let fly = |initial: &InitialErrorParameters| {
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.set_gyro(&crate::support::one_unit_of_each(Sensor::Gyro, 1.0)).unwrap();
        simulator.set_initial_errors(initial).unwrap();
        let mut signals = Vec::new();
        for k in 0..1000 {
            simulator.push_sample(&flight.sample_at(0.01 * f64::from(k)).unwrap()).unwrap();
            simulator.step().unwrap();
            signals.extend(simulator.imu().map(|imu| imu.ideal));
        }
        signals
    };
    let without = fly(&InitialErrorParameters::default());
    let with = InitialErrorParameters { misalignment_n: Vector3::repeat(1e-3), ..Default::default() };
    assert!(fly(&with) == without && without.len() == 999);
}
