//! The same inputs give the same bits: on every platform (pinned digests), with any call pattern, after a reset, and from a
//! snapshot.

use nalgebra::Vector3;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{
    AltimeterParameters, InitialErrorParameters, StreamKey, TriadParameters, paper_simulation2,
};
use sins::truth::FlightSample;
use sins::{ErrorSource, Options, Simulator, Step};

use crate::support::fnv::Fnv;
use crate::support::{options_at, patrol, project_file};

/// Hash of the bits of numbers.
#[derive(Clone, Copy)]
struct Digest(Fnv);

impl Digest {
    fn new() -> Self {
        Self(Fnv::NONE)
    }

    fn add(&mut self, values: &[f64]) {
        values.iter().for_each(|value| self.0.add(&value.to_bits().to_le_bytes()));
    }

    fn add_state(&mut self, simulator: &Simulator) {
        let solution = simulator.navigation().unwrap().unwrap();
        let navigation = &solution.navigation;
        let place = &navigation.place;
        self.add(&[solution.time_s, place.latitude_rad, place.longitude_rad, place.height_m]);
        self.add(navigation.v_n.as_slice());
        self.add(navigation.q_nb.coords.as_slice());
        self.add(&[navigation.euler.roll, navigation.euler.pitch, navigation.euler.heading]);
        let errors = simulator.errors(ErrorSource::Model).unwrap().unwrap().1;
        self.add(errors.position_n.as_slice());
        self.add(errors.misalignment_n.as_slice());
    }
}

fn every_effect() -> (TriadParameters, TriadParameters) {
    let (mut gyro, mut accel) = paper_simulation2();
    for (parameters, scale) in [(&mut gyro, 1e-7), (&mut accel, 1e-4)] {
        parameters.bias_sigma = Vector3::repeat(scale);
        parameters.markov_sigma = Vector3::new(scale, 2.0 * scale, 0.5 * scale);
        parameters.markov_time_s = Vector3::new(100.0, 1.0, 0.01);
        parameters.scale_factor = Vector3::new(1e-4, -1e-4, 2e-4);
        parameters.misalignment[(0, 1)] = 1e-5;
        parameters.misalignment[(2, 0)] = -2e-5;
    }
    (gyro, accel)
}

fn simulator(options: &Options) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    let (gyro, accel) = every_effect();
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_accel(&accel).unwrap();
    simulator
        .set_altimeter(&AltimeterParameters {
            noise_m: 1.0,
            lag_s: 0.5,
            markov_sigma_m: 3.0,
            markov_time_s: 60.0,
            ..Default::default()
        })
        .unwrap();
    let initial =
        InitialErrorParameters { misalignment_sigma_n: Vector3::repeat(1e-4), ..Default::default() };
    simulator.set_initial_errors(&initial).unwrap();
    simulator
}

fn options(frame: Frame, scheme: Scheme) -> Options {
    let key = StreamKey { seed: 20140601, run: 7 };
    Options { frame, scheme, error_model: true, vertical: VerticalMode::Damped, key, ..options_at(100.0) }
}

fn samples() -> Vec<FlightSample> {
    let flight = patrol(1200.0);
    (0..6000).map(|k| flight.sample_at(300.0 + k as f64 / 100.0).unwrap()).collect()
}

fn digest(simulator: &mut Simulator, samples: &[FlightSample]) -> u64 {
    let mut digest = Digest::new();
    for (k, sample) in samples.iter().enumerate() {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        if k % 100 == 99 {
            digest.add_state(simulator);
        }
    }
    digest.0.value()
}

const PINNED: [&str; 5] =
    ["a8c55475a3a212ff", "0e4477f84d5e8ffe", "fad34391c5b42475", "48e88aa7261f308f", "68ebe36745a7964e"];

/// The digests of one minute of patrol with every effect on. A change of the algorithms may change them, and its commit says so.
/// The machine must not change them.
#[test]
fn digests_are_the_pinned_ones() {
    let samples = samples();
    let found = [
        (Frame::EarthFixed, Scheme::Exact),
        (Frame::Geographic, Scheme::Exact),
        (Frame::EarthFixed, Scheme::Paper),
        (Frame::Geographic, Scheme::Paper),
        (Frame::EarthFixed, Scheme::Polynomial),
    ]
    .map(|(frame, scheme)| format!("{:016x}", digest(&mut simulator(&options(frame, scheme)), &samples)));
    assert_eq!(found, PINNED);
}

const PINNED_REPLAY: &str = "92fee1521e36ac23";

/// A snapshot was saved in mid-flight on another machine, with samples in the queue. This machine saves the same bytes, and the
/// rest of the run has the same digest with and without a load. `SINS_WRITE_SNAPSHOT=1 cargo test -p tests --test state determinism::`
/// renews the file.
#[test]
fn a_snapshot_of_another_machine_replays_to_the_pinned_digest() {
    let samples = samples();
    let (before, rest) = samples.split_at(3000);
    let mut straight =
        simulator(&Options { closed_loop_time_s: Some(30.0), ..options(Frame::EarthFixed, Scheme::Exact) });
    digest(&mut straight, before);
    let (waiting, rest) = rest.split_at(3);
    for sample in waiting {
        straight.push_sample(sample).unwrap();
    }
    let mut bytes = vec![0; straight.snapshot_size()];
    straight.save_snapshot(&mut bytes).unwrap();

    let path = project_file("tests/data/replay.snapshot");
    if std::env::var_os("SINS_WRITE_SNAPSHOT").is_some() {
        std::fs::write(&path, &bytes).unwrap();
    }
    let committed = std::fs::read(&path).unwrap();
    assert!(committed == bytes, "tests/data/replay.snapshot is of another format or other algorithms");
    let mut replay = Simulator::new(&Options::default()).unwrap();
    replay.load_snapshot(&committed).unwrap();
    assert_eq!(format!("{:016x}", digest(&mut replay, rest)), PINNED_REPLAY);
    assert_eq!(format!("{:016x}", digest(&mut straight, rest)), PINNED_REPLAY);
}

/// Reads between the calls, and a queue that is filled and then emptied, give the same bits as one sample at a time.
#[test]
fn the_call_pattern_does_not_matter() {
    let samples = samples();
    let options = options(Frame::EarthFixed, Scheme::Exact);
    let mut plain = simulator(&options);
    let expected = digest(&mut plain, &samples);

    let mut bursts = simulator(&options);
    let mut found = Digest::new();
    let mut flown = 0;
    for burst in samples.chunks(13) {
        for sample in burst {
            bursts.push_sample(sample).unwrap();
            let _ = (bursts.truth().unwrap(), bursts.accuracy().unwrap(), bursts.imu());
            let _ = (bursts.navigation().unwrap(), bursts.errors(ErrorSource::Model).unwrap());
        }
        while bursts.step().unwrap() == Step::Done {
            flown += 1;
            if (flown + 1) % 100 == 0 {
                found.add_state(&bursts);
            }
        }
    }
    assert_eq!(flown, samples.len() - 1);
    assert_eq!(found.0.value(), expected);
}

#[test]
fn a_reset_brings_the_same_draws_back() {
    let samples = samples();
    let mut simulator = simulator(&options(Frame::EarthFixed, Scheme::Exact));
    let first = digest(&mut simulator, &samples);
    simulator.reset();
    assert!(simulator.navigation().unwrap().is_none());
    assert_eq!(digest(&mut simulator, &samples), first);
}

#[test]
fn another_run_or_seed_draws_otherwise() {
    let samples = &samples()[..500];
    let base = options(Frame::EarthFixed, Scheme::Exact);
    let mut found: Vec<u64> = [base.key, StreamKey { run: 8, ..base.key }, StreamKey { seed: 1, ..base.key }]
        .into_iter()
        .map(|key| digest(&mut simulator(&Options { key, ..base }), samples))
        .collect();
    found.sort_unstable();
    found.dedup();
    assert_eq!(found.len(), 3);
}

/// A reposition starts the INS again at the current truth. The noise continues; it does not repeat.
#[test]
fn a_reposition_starts_again_and_the_noise_goes_on() {
    let samples = samples();
    let mut simulator = Simulator::new(&options(Frame::EarthFixed, Scheme::Exact)).unwrap();
    let noise = TriadParameters { random_walk: Vector3::repeat(1e-6), ..Default::default() };
    simulator.set_gyro(&noise).unwrap();
    let fly = |simulator: &mut Simulator, samples: &[FlightSample]| -> Vec<Vector3<f64>> {
        let mut errors = Vec::new();
        for sample in samples {
            simulator.push_sample(sample).unwrap();
            if simulator.step().unwrap() == Step::Done {
                let imu = simulator.imu().unwrap();
                errors.push(imu.measured.angle - imu.ideal.angle);
            }
        }
        errors
    };
    let before = fly(&mut simulator, &samples[..100]);
    simulator.reposition(&samples[3000]).unwrap();
    let (time_s, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
    assert_eq!(time_s, samples[3000].time_s);
    assert!(errors.position_n.norm() < 1e-8 && errors.velocity_n.norm() < 1e-12, "{errors:?}");
    let after = fly(&mut simulator, &samples[3001..3101]);
    // No spike: the largest increment error is noise.
    let largest = |errors: &[Vector3<f64>]| errors.iter().map(|e| e.amax()).fold(0.0, f64::max);
    assert!(largest(&after) < 1.5 * largest(&before));
    assert!(before.iter().zip(&after).all(|(a, b)| a != b));
    // The draws are those of intervals 100 to 199, as without a reposition.
    let mut straight = Simulator::new(&options(Frame::EarthFixed, Scheme::Exact)).unwrap();
    straight.set_gyro(&noise).unwrap();
    let through = fly(&mut straight, &samples[..200]);
    for (a, b) in after.iter().zip(&through[99..]) {
        assert!((a - b).amax() < 1e-15, "the ideal signals differ, their errors do not but for rounding");
    }
}
