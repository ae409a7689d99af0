//! The runs of an ensemble equal single simulators, with the instructions of each width. The settings are 60 random choices of all
//! effects, every frame, gravity, scheme, vertical channel and number of subsamples, with and without the error model, a mounting,
//! a gravity disturbance, a closed loop, and failures that begin and end. The cases include irregular intervals, rotations beyond
//! the short series, a start without velocity, a run that diverges among good ones, and numbers of runs that are not a multiple of
//! a block.

use nalgebra::Vector3;
use sins::earth::GravityModel;
use sins::ensemble::Ensemble;
use sins::math::Euler;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::{
    Failure, GravityDisturbanceParameters, GravityField, SensorOutput, StreamKey, TriadParameters,
};
use sins::signal::mounting::MountingParameters;
use sins::truth::{FlightSample, Pushed};
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use crate::support;
use crate::support::draws::Draws;
use crate::support::moments::{altimeter, every_effect, initial};

const FIRST_RUN: u64 = 40;
/// More than one block; the second block is not full.
const RUNS: u64 = 21;
/// A full block, and runs behind it that are few enough to be flown one by one.
const BLOCK_AND_FEW: usize = 18;
const STEPS: usize = 60;
/// Numbers per instruction. A width beyond that of the processor is reduced to it; with a width of 1 runs are flown one by one. Machines
/// other than x86-64 have one instruction set.
const WIDTHS: &[usize] = if cfg!(target_arch = "x86_64") { &[1, 2, 4, 8] } else { &[1, 2] };
/// Number of random settings. Machines other than x86-64 may be emulated, which is 30 times slower.
const SETTINGS: u64 = if cfg!(target_arch = "x86_64") { 60 } else { ELSEWHERE };
const ELSEWHERE: u64 = 20;

/// Everything that the host sets in a simulator.
#[derive(Clone)]
struct Setting {
    options: Options,
    triads: (TriadParameters, TriadParameters),
    with_altimeter: bool,
    with_initial_errors: bool,
    mounting: Option<MountingParameters>,
    gravity: Option<GravityDisturbanceParameters>,
    /// Each failure has the number of the sample before which it is set.
    failures: Vec<(usize, SensorOutput, Option<Failure>)>,
}

impl Setting {
    fn simulator(&self, run: u64) -> Simulator {
        let key = StreamKey { run, ..self.options.key };
        let mut simulator = Simulator::new(&Options { key, ..self.options }).unwrap();
        simulator.set_gyro(&self.triads.0).unwrap();
        simulator.set_accel(&self.triads.1).unwrap();
        if self.with_altimeter {
            simulator.set_altimeter(&altimeter()).unwrap();
        }
        if self.with_initial_errors {
            simulator.set_initial_errors(&initial()).unwrap();
        }
        if let Some(mounting) = &self.mounting {
            simulator.set_mounting(mounting).unwrap();
        }
        if let Some(gravity) = &self.gravity {
            simulator.set_gravity_disturbance(gravity).unwrap();
        }
        simulator
    }
}

fn mounting() -> MountingParameters {
    MountingParameters {
        lever_arm_m: Vector3::new(1.0, -4.0, 0.7),
        lever_arm_error_m: Vector3::new(0.1, 0.05, -0.2),
        boresight: Euler { roll: 0.1, pitch: -0.2, heading: 3.0 },
        boresight_error: Euler { roll: 1e-3, pitch: -2e-3, heading: 1e-3 },
    }
}

fn gravity() -> GravityDisturbanceParameters {
    let field = GravityField { mean: 2e-5, sigma: 5e-5, distance_m: 300.0 };
    GravityDisturbanceParameters { deflection_north: field, deflection_east: field, anomaly: field }
}

/// A random selection of the effects in `all`.
fn some_effects(draw: &mut Draws, all: &TriadParameters) -> TriadParameters {
    let mut some = TriadParameters { markov_time_s: all.markov_time_s, ..TriadParameters::default() };
    macro_rules! choose {
        ($($effect:ident),*) => { $(if draw.one_in(2) { some.$effect = all.$effect; })* };
    }
    choose!(
        bias,
        bias_sigma,
        markov_sigma,
        random_walk,
        rate_random_walk,
        ramp,
        flicker,
        scale_factor,
        scale_factor_sigma,
        scale_factor_asymmetry,
        scale_factor_nonlinearity,
        misalignment,
        misalignment_sigma,
        g_sensitivity,
        g2_sensitivity,
        vibration_rectification_s2_m,
        lever_arm_m,
        bias_temperature,
        bias_temperature2,
        scale_factor_temperature,
        scale_factor_temperature2,
        bandwidth_hz,
        dead_zone,
        range,
        quantization
    );
    if some.markov_sigma == Vector3::zeros() {
        some.markov_time_s = Vector3::zeros();
    }
    some
}

/// Samples at slightly irregular times, with gaps.
fn samples(draw: &mut Draws, count: usize) -> Vec<FlightSample> {
    let flight = support::patrol(2000.0);
    let mut time_s = 700.0;
    (0..count)
        .map(|k| {
            time_s += match k % 25 {
                24 => 0.06,
                10..15 => draw.within(0.005, 0.015),
                _ => 0.01,
            };
            let temperature_c = Some(20.0 + 0.01 * k as f64);
            FlightSample { temperature_c, ..flight.sample_at(time_s).unwrap() }
        })
        .collect()
}

/// Flies the setting in every width and in single simulators and compares them. Returns the number of runs that diverged.
fn compare(setting: &Setting, samples: &[FlightSample], who: &str) -> usize {
    let template = setting.simulator(0);
    let of_width = |width: &usize| Ensemble::of_width(&template, FIRST_RUN, RUNS as usize, *width).unwrap();
    let mut ensembles: Vec<_> = WIDTHS.iter().map(of_width).collect();
    ensembles.push(Ensemble::new(&template, FIRST_RUN, BLOCK_AND_FEW).unwrap());
    let mut singles: Vec<_> =
        (FIRST_RUN..FIRST_RUN + RUNS).map(|run| (setting.simulator(run), false)).collect();
    for (k, sample) in samples.iter().enumerate() {
        for (_, output, failure) in setting.failures.iter().filter(|(at, ..)| *at == k) {
            for ensemble in &mut ensembles {
                ensemble.set_failure(*output, *failure).unwrap();
            }
            for (single, _) in &mut singles {
                single.set_failure(*output, *failure).unwrap();
            }
        }
        for ensemble in &mut ensembles {
            ensemble.push_sample(sample).unwrap();
            ensemble.step().unwrap();
        }
        for (single, has_diverged) in singles.iter_mut().filter(|(_, has_diverged)| !has_diverged) {
            single.push_sample(sample).unwrap();
            *has_diverged = single.step().is_err();
        }
        if k % 10 != 9 && k + 1 < samples.len() {
            continue;
        }
        for (width, ensemble) in WIDTHS.iter().chain([&usize::MAX]).zip(&ensembles) {
            for (run, (single, has_diverged)) in (FIRST_RUN..).zip(&singles).take(ensemble.runs()) {
                let reported = ensemble.navigation(run);
                if *has_diverged {
                    assert_eq!(
                        reported.unwrap_err().kind,
                        ErrorKind::Diverged,
                        "{who}, width {width}, run {run}"
                    );
                    continue;
                }
                let of_ensemble = (
                    reported.unwrap(),
                    ensemble.errors(run, ErrorSource::Navigation),
                    ensemble.errors(run, ErrorSource::Model),
                    ensemble.imu(run).unwrap(),
                );
                let of_single = (
                    single.navigation().unwrap(),
                    single.errors(ErrorSource::Navigation),
                    single.errors(ErrorSource::Model),
                    single.imu(),
                );
                // Each number with all its digits.
                let [of_ensemble, of_single] = [of_ensemble, of_single].map(|read| format!("{read:?}"));
                assert_eq!(of_ensemble, of_single, "{who}, width {width}, run {run}, sample {k}");
            }
        }
    }
    singles.iter().filter(|(_, has_diverged)| *has_diverged).count()
}

fn setting(draw: &mut Draws) -> Setting {
    let (gyro, accel) = every_effect();
    let options = Options {
        scheme: draw.of(&[Scheme::Exact, Scheme::Exact, Scheme::Polynomial, Scheme::Paper]),
        subsamples: draw.of(&[1, 2, 3, 4, 5]),
        updates_per_sample: draw.of(&[1, 1, 2]),
        vertical: draw.of(&[VerticalMode::Damped, VerticalMode::FollowTruth, VerticalMode::Free]),
        error_model: draw.one_in(2),
        frame: draw.of(&[Frame::EarthFixed, Frame::EarthFixed, Frame::EarthFixed, Frame::Geographic]),
        closed_loop_time_s: draw.of(&[None, None, Some(30.0)]),
        gravity: draw.of(&[GravityModel::Normal, GravityModel::Normal, GravityModel::Somigliana]),
        ..Options::default()
    };
    Setting {
        options,
        triads: (some_effects(draw, &gyro), some_effects(draw, &accel)),
        with_altimeter: draw.one_in(2),
        with_initial_errors: draw.one_in(2),
        mounting: draw.one_in(4).then(mounting),
        gravity: draw.one_in(4).then(gravity),
        failures: Vec::new(),
    }
}

/// Failures of any kind, set in flight and cleared, two at a time.
fn failures(draw: &mut Draws) -> Vec<(usize, SensorOutput, Option<Failure>)> {
    let of_triads = [
        Failure::Stuck,
        Failure::Dead,
        Failure::BiasStep { size: 1e-4 },
        Failure::Spikes { size: 1e-3, interval_s: 0.05, duration_s: 0.012 },
        Failure::Noise { density: 1e-5 },
        Failure::DropOuts { interval_s: 0.0, probability: 0.3 },
        Failure::DropOuts { interval_s: 0.045, probability: 0.0 },
    ];
    let mut failures = Vec::new();
    for at in [0, 3, 14, 25, 36, 47] {
        let output = SensorOutput::ALL[draw.below(7)];
        failures.push((at, output, Some(draw.of(&of_triads))));
        failures.push((at + 10, output, None));
    }
    failures
}

#[test]
fn runs_are_the_single_simulators_in_every_width() {
    for seed in 0..SETTINGS {
        let mut draw = Draws::new(seed);
        let mut setting = setting(&mut draw);
        let samples = samples(&mut draw, STEPS);
        if seed % 2 == 1 {
            setting.failures = failures(&mut draw);
        }
        compare(&setting, &samples, &format!("setting {seed}: {:?}", setting.options));
    }
    let elsewhere = format!("{ELSEWHERE} of them on NEON (emulated) and 32-bit x86");
    println!("figure: {SETTINGS} random choices, to the bit; {elsewhere}");
}

/// The gyro noise is so large that some runs sometimes turn by more than the range of the short series.
#[test]
fn so_they_are_where_a_branch_is_rare() {
    let mut draw = Draws::new(1);
    let samples = samples(&mut draw, STEPS);
    for scheme in [Scheme::Exact, Scheme::Polynomial, Scheme::Paper] {
        for density in [0.1, 0.3, 3.0, 30.0] {
            let gyro = TriadParameters { random_walk: Vector3::repeat(density), ..Default::default() };
            let options = Options { scheme, error_model: density == 30.0, ..Options::default() };
            let triads = (gyro, TriadParameters::default());
            let setting = Setting {
                options,
                triads,
                with_altimeter: false,
                with_initial_errors: false,
                mounting: None,
                gravity: None,
                failures: Vec::new(),
            };
            compare(&setting, &samples, &format!("{scheme:?}, {density} rad/√s"));
        }
    }
}

#[test]
fn a_run_that_diverges_leaves_the_others_alone() {
    let mut draw = Draws::new(2);
    let samples = samples(&mut draw, 600);
    // Some runs reach 100 km/s in about seven seconds, others do not.
    let accel = TriadParameters { bias_sigma: Vector3::repeat(1e4), ..every_effect().1 };
    for (with_altimeter, error_model) in [(false, false), (true, true)] {
        let options = Options { vertical: VerticalMode::Damped, error_model, ..Options::default() };
        let triads = (every_effect().0, TriadParameters { range: Vector3::zeros(), ..accel });
        let failures = if with_altimeter { failures(&mut draw) } else { Vec::new() };
        let setting = Setting {
            options,
            triads,
            with_altimeter,
            with_initial_errors: false,
            mounting: with_altimeter.then(mounting),
            gravity: None,
            failures,
        };
        let diverged = compare(&setting, &samples, "divergence");
        assert!((1..RUNS as usize).contains(&diverged), "{diverged} of {RUNS}");
    }
}

/// An ensemble that flies in several parts equals smaller ensembles, with [`Ensemble::run`] and step by step. The flight has more
/// samples than a part flies at once.
#[test]
fn parts_of_an_ensemble_are_ensembles() {
    const RUNS: usize = 1100;
    let mut draw = Draws::new(4);
    let (setting, samples) = (setting(&mut draw), samples(&mut draw, 70));
    let template = setting.simulator(0);
    let mut all = Ensemble::new(&template, FIRST_RUN, RUNS).unwrap();
    let has_gap = all.run(samples.len(), |k| Ok::<_, sins::Error>(samples[k])).unwrap();
    assert!(all.runs() == RUNS && all.intervals() == 69);
    let mut bytes = vec![0; all.snapshot_size()];
    all.save_snapshot(&mut bytes).unwrap();
    let mut loaded = Ensemble::new(&template, 0, 1).unwrap();
    loaded.load_snapshot(&bytes).unwrap();
    for (first, count) in [(0, 1), (500, 30), (1020, 40), (1099, 1)] {
        let mut some = Ensemble::new(&template, FIRST_RUN + first, count).unwrap();
        let mut some_gap = false;
        for sample in &samples {
            some_gap |= some.push_sample(sample).unwrap() == Pushed::BehindGap;
            some.step().unwrap();
        }
        assert_eq!(some_gap, has_gap);
        for run in (FIRST_RUN + first..).take(count) {
            let read = |ensemble: &Ensemble| format!("{:?}", (ensemble.navigation(run), ensemble.imu(run)));
            assert_eq!(read(&all), read(&some), "run {run}");
            assert_eq!(read(&loaded), read(&some), "run {run}");
        }
    }

    // A fault of a sample is reported once, and all parts have flown the samples before it.
    let mut late = samples.clone();
    late.iter_mut().for_each(|sample| sample.time_s += 100.0);
    late[40].time_s = late[39].time_s;
    late.insert(0, FlightSample { time_s: late[0].time_s - 0.01, ..late[0] });
    all.reposition(&late[0]).unwrap();
    let (index, error) = all.run(70, |k| Ok::<_, sins::Error>(late[k + 1])).unwrap_err();
    assert_eq!((index, error.kind, all.intervals()), (40, ErrorKind::TimeOrder, 40));
    let times = [0, 600, 1099].map(|k| all.navigation(FIRST_RUN + k).unwrap().unwrap().time_s);
    assert_eq!(times, [late[40].time_s; 3]);
}

/// From one run to more than two blocks.
#[test]
fn any_number_of_runs_is_right() {
    let mut draw = Draws::new(3);
    let (setting, samples) = (setting(&mut draw), samples(&mut draw, 12));
    let mut all: Vec<Vec<String>> = Vec::new();
    for runs in [1, 2, 3, 7, 8, 15, 16, 17, 18, 31, 33, 40] {
        for width in WIDTHS {
            let mut ensemble = Ensemble::of_width(&setting.simulator(0), FIRST_RUN, runs, *width).unwrap();
            for sample in &samples {
                ensemble.push_sample(sample).unwrap();
                ensemble.step().unwrap();
            }
            let read = |run| format!("{:?}", ensemble.navigation(run).unwrap());
            all.push((FIRST_RUN..FIRST_RUN + runs as u64).map(read).collect());
        }
    }
    let longest = all.last().unwrap();
    assert!(all.iter().all(|runs| *runs == longest[..runs.len()]));
}
