//! The covariance against runs: the spread of many simulators with other draws is what it says, by chi-square; and one of other
//! densities by 10 % is found out.
//!
//! The ordinary test flies 200 runs, and an hour of the patrol; `--features long-tests` 2000 runs, and all 48 hours.

use nalgebra::{SMatrix, SVector, Vector3};
use sins::flight::{Flight, FlightStart, Manoeuvre};
use sins::sensors::{
    Alignment, AltimeterParameters, GravityDisturbanceParameters, GravityField, InitialErrorParameters,
    StreamKey, TriadParameters,
};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorSource, Options, Simulator};

use crate::support::{self, DEG, DEG_PER_HOUR, G};

const MICRO_G: f64 = 1e-6 * G;
const INSTANTS: usize = 20;
type Nine = SVector<f64, 9>;

/// What a simulator is set to.
#[derive(Clone, Copy)]
struct Setting {
    gyro: TriadParameters,
    accel: TriadParameters,
    altimeter: AltimeterParameters,
    initial: InitialErrorParameters,
    gravity: GravityDisturbanceParameters,
}

impl Setting {
    fn simulator(&self, options: &Options) -> Simulator {
        let mut simulator = Simulator::new(options).unwrap();
        simulator.set_gyro(&self.gyro).unwrap();
        simulator.set_accel(&self.accel).unwrap();
        simulator.set_altimeter(&self.altimeter).unwrap();
        simulator.set_initial_errors(&self.initial).unwrap();
        simulator.set_gravity_disturbance(&self.gravity).unwrap();
        simulator
    }

    /// Everything that is random, of navigation grade.
    fn of_everything() -> Self {
        let off_diagonal = |size| SMatrix::from_fn(|row, column| if row == column { 0.0 } else { size });
        let triad = |unit: f64, walk: f64| TriadParameters {
            bias_sigma: Vector3::new(1.0, 0.7, 1.3) * unit,
            markov_sigma: Vector3::new(0.5, 0.8, 0.3) * unit,
            markov_time_s: Vector3::new(300.0, 1000.0, 40.0),
            flicker: Vector3::new(0.6, 0.4, 0.5) * unit,
            rate_random_walk: Vector3::repeat(0.5 * unit / 60.0),
            random_walk: Vector3::repeat(walk),
            scale_factor_sigma: Vector3::new(10e-6, 5e-6, 8e-6),
            misalignment_sigma: off_diagonal(1e-5),
            ..Default::default()
        };
        let field = |sigma| GravityField { mean: 0.0, sigma, distance_m: 20e3 };
        Self {
            gyro: triad(0.01 * DEG_PER_HOUR, 0.002 * DEG / 60.0),
            accel: triad(20.0 * MICRO_G, 10.0 * MICRO_G),
            altimeter: AltimeterParameters {
                markov_sigma_m: 10.0,
                markov_time_s: 600.0,
                noise_m: 1.0,
                ..Default::default()
            },
            initial: InitialErrorParameters {
                position_sigma_n: Vector3::new(5.0, 8.0, 10.0),
                velocity_sigma_n: Vector3::new(0.02, 0.03, 0.01),
                misalignment_sigma_n: Vector3::new(2e-5, 3e-5, 2e-4),
                ..Default::default()
            },
            gravity: GravityDisturbanceParameters {
                deflection_north: field(3e-5),
                deflection_east: field(2e-5),
                anomaly: field(3e-4),
            },
        }
    }
}

/// A flight with what is looked at.
struct Scene {
    name: &'static str,
    samples: Vec<FlightSample>,
    setting: Setting,
    /// What the covariance is told, which is `setting` unless it is to be wrong.
    believed: Setting,
}

/// Number of the standard normal distribution that is exceeded with the probability `p` on one side.
fn quantile(p: f64) -> f64 {
    // Bisection of the complementary error function's continued fraction.
    let tail = |x: f64| {
        let mut fraction = 0.0;
        for k in (1..200).rev() {
            fraction = f64::from(k) / (x + fraction);
        }
        (-0.5 * x * x).exp() / ((x + fraction) * (2.0 * std::f64::consts::PI).sqrt())
    };
    let (mut low, mut high) = (1.0, 12.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if tail(middle) > p { low = middle } else { high = middle }
    }
    low
}

/// Bounds of chi-square of `n` over n at `z` standard deviations of the normal one (Wilson and Hilferty 1931).
fn chi_square_bounds(n: f64, z: f64) -> (f64, f64) {
    let spread = (2.0 / (9.0 * n)).sqrt();
    let at = |z: f64| (1.0 - 2.0 / (9.0 * n) + z * spread).powi(3);
    (at(-z), at(z))
}

/// Where the sums of squares of a scene's runs lie: each over its expectation.
struct Found {
    /// Of each error at each instant.
    sigmas: Vec<[f64; 9]>,
    /// The normalized square of the nine, over nine.
    nees: Vec<f64>,
}

fn fly(simulator: &mut Simulator, samples: &[FlightSample], mut look: impl FnMut(&mut Simulator, usize)) {
    for (k, sample) in samples.iter().enumerate() {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        let every = (samples.len() - 1) / INSTANTS;
        if k > 0 && k % every == 0 && k / every <= INSTANTS {
            look(simulator, k / every);
        }
    }
}

fn errors(simulator: &Simulator) -> Nine {
    // At a pole east and north of the navigation are not those of the truth: there the error equations of the same draws.
    let is_near_pole = simulator.truth().unwrap().unwrap().near_pole;
    let source = if is_near_pole { ErrorSource::Model } else { ErrorSource::Navigation };
    let (_, errors) = simulator.errors(source).unwrap().unwrap();
    let mut nine = Nine::zeros();
    for (first, errors) in [(0, errors.position_n), (3, errors.velocity_n), (6, errors.misalignment_n)] {
        nine.fixed_rows_mut::<3>(first).copy_from(&errors);
    }
    nine
}

impl Scene {
    fn new(name: &'static str, samples: Vec<FlightSample>, setting: Setting) -> Self {
        Self { name, samples, setting, believed: setting }
    }

    fn options(&self, run: u64, covariance: bool) -> Options {
        let period_s = self.samples[1].time_s - self.samples[0].time_s;
        let is_polar = self.samples.iter().any(|sample| sample.place.latitude_rad > 89.8 * DEG);
        Options {
            covariance,
            error_model: is_polar,
            intake: IntakeLimits { period_s: Some(period_s), ..IntakeLimits::default() },
            key: StreamKey { seed: 7, run },
            ..Options::default()
        }
    }

    /// Flies `runs` runs, on all cores.
    fn fly(&self, runs: u64) -> Found {
        let mut expected = Vec::new();
        let mut simulator = self.believed.simulator(&self.options(0, true));
        fly(&mut simulator, &self.samples, |simulator, _| {
            expected.push(simulator.covariance().unwrap().unwrap().1.matrix);
        });
        // In units of sigma: the nine errors are of very different size.
        let scales: Vec<Nine> =
            expected.iter().map(|matrix| matrix.diagonal().map(|variance| 1.0 / variance.sqrt())).collect();
        let inverses: Vec<_> = expected
            .iter()
            .zip(&scales)
            .map(|(matrix, scale)| {
                let scale = SMatrix::<f64, 9, 9>::from_diagonal(scale);
                (scale * matrix * scale).cholesky().expect("positive").inverse()
            })
            .collect();
        let threads = std::thread::available_parallelism().map_or(1, |count| count.get() as u64);
        let of_thread = |thread: u64| {
            let mut sums = vec![(Nine::zeros(), 0.0); expected.len()];
            for run in (thread..runs).step_by(threads as usize) {
                let mut simulator = self.setting.simulator(&self.options(run, false));
                fly(&mut simulator, &self.samples, |simulator, k| {
                    let x = errors(simulator).component_mul(&scales[k - 1]);
                    sums[k - 1].0 += x.component_mul(&x);
                    sums[k - 1].1 += (x.transpose() * inverses[k - 1] * x)[0];
                });
            }
            sums
        };
        let parts: Vec<_> = std::thread::scope(|scope| {
            let handles: Vec<_> = (0..threads)
                .map(|thread| {
                    scope.spawn({
                        let of_thread = &of_thread;
                        move || of_thread(thread)
                    })
                })
                .collect();
            handles.into_iter().map(|handle| handle.join().unwrap()).collect()
        });
        let n = runs as f64;
        let sum = |k: usize| {
            parts.iter().map(|part| part[k]).fold((Nine::zeros(), 0.0), |s, p| (s.0 + p.0, s.1 + p.1))
        };
        let sums: Vec<_> = (0..expected.len()).map(sum).collect();
        Found {
            sigmas: sums.iter().map(|sum| core::array::from_fn(|row| sum.0[row] / n)).collect(),
            nees: sums.iter().map(|sum| sum.1 / (9.0 * n)).collect(),
        }
    }
}

/// How many of all figures of the scenes are outside of their intervals of 99.9 %, corrected for their number (Bonferroni).
fn outside(scenes: &[Scene], runs: u64) -> usize {
    let tests = scenes.len() * INSTANTS * 10;
    let z = quantile(0.001 / 2.0 / tests as f64);
    let (low, high) = chi_square_bounds(runs as f64, z);
    let (low9, high9) = chi_square_bounds(9.0 * runs as f64, z);
    let mut outside = 0;
    for scene in scenes {
        let started = std::time::Instant::now();
        let found = scene.fly(runs);
        let range = |values: &mut dyn Iterator<Item = f64>| {
            values.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)))
        };
        let (least, most) = range(&mut found.sigmas.iter().flatten().copied());
        let (least9, most9) = range(&mut found.nees.iter().copied());
        println!(
            "{}: {} runs of {} samples: variances over the covariance's {least:.4} to {most:.4} of {low:.4} to {high:.4}, \
             NEES/9 {least9:.4} to {most9:.4} of {low9:.4} to {high9:.4}; {:.1} s",
            scene.name,
            runs,
            scene.samples.len(),
            started.elapsed().as_secs_f64()
        );
        if std::env::var_os("SHOW").is_some() {
            for (k, (sigmas, nees)) in found.sigmas.iter().zip(&found.nees).enumerate() {
                println!("{k:3} {:.3?} {nees:.3}", sigmas);
            }
        }
        outside += found.sigmas.iter().flatten().filter(|share| !(low..=high).contains(*share)).count();
        outside += found.nees.iter().filter(|share| !(low9..=high9).contains(*share)).count();
    }
    outside
}

fn sampled(flight: &Flight, length_s: f64, period_s: f64) -> Vec<FlightSample> {
    let count = (length_s.min(flight.duration_s()) / period_s) as usize;
    (0..=count).map(|k| flight.sample_at(k as f64 * period_s).unwrap()).collect()
}

fn built_in(name: &str, length_s: f64, period_s: f64) -> Vec<FlightSample> {
    sampled(&sins::scene::builtin(name).unwrap().flight().unwrap(), length_s, period_s)
}

/// Turns, climbs and stops of a small aircraft.
fn drone() -> Flight {
    let start = FlightStart { latitude_rad: 0.8, height_m: 100.0, speed_m_s: 15.0, ..Default::default() };
    let turn = |heading_change_rad| Manoeuvre::Turn { heading_change_rad, bank_rad: 0.5, ramp_s: 0.5 };
    let climb = |height_change_m| Manoeuvre::Climb { duration_s: 20.0, height_change_m, ramp_s: 2.0 };
    let straight = Manoeuvre::Straight { duration_s: 10.0 };
    let legs = [straight, turn(3.0), climb(50.0), turn(-5.0), straight, climb(-40.0), turn(9.0), straight];
    Flight::new(&start, &[legs, legs].concat()).unwrap()
}

/// The scenes: patrol, aerobatics, airliner, pole passage, drone. `share` of their length, of the patrol much less.
fn scenes(is_long: bool) -> Vec<Scene> {
    let everything = Setting::of_everything();
    let mut aligned = everything;
    aligned.initial.alignment = Alignment::LevelAndGyrocompass;
    aligned.initial.misalignment_sigma_n = Vector3::repeat(1e-6);
    let mut small = everything;
    (small.gyro.bias_sigma, small.gyro.random_walk) =
        (Vector3::repeat(5.0 * DEG_PER_HOUR), Vector3::repeat(0.1 * DEG / 60.0));
    (small.accel.bias_sigma, small.accel.random_walk) =
        (Vector3::repeat(1000.0 * MICRO_G), Vector3::repeat(50.0 * MICRO_G));
    let airliner = support::Table::csv("c_examples/flights/airliner_cruise.csv").samples(false);
    let airliner: Vec<_> = airliner.into_iter().step_by(5).collect();
    let patrol_s = if is_long { 48.0 * 3600.0 } else { 3600.0 };
    vec![
        Scene::new("patrol", built_in("patrol", patrol_s, 0.5), everything),
        Scene::new("patrol, aligned", built_in("patrol", 1200.0, 0.5), aligned),
        Scene::new("aerobatics", built_in("aerobatics", 600.0, 0.05), everything),
        Scene::new("airliner", airliner, everything),
        Scene::new("pole passage", built_in("over_the_pole", 3600.0, 0.5), everything),
        Scene::new("drone", sampled(&drone(), 600.0, 0.05), small),
    ]
}

/// 200 runs, the patrol of an hour; `--features long-tests`: 2000 runs, the patrol of 48 hours.
#[test]
fn the_spread_of_many_runs_is_the_covariance() {
    let is_long = cfg!(feature = "long-tests");
    assert_eq!(outside(&scenes(is_long), if is_long { 2000 } else { 200 }), 0);
}

/// White noise alone, the covariance told of a spectral density that is 10 % larger: the same test fails.
#[test]
fn a_density_that_is_wrong_by_a_tenth_is_found() {
    let mut noise = Setting::of_everything();
    for triad in [&mut noise.gyro, &mut noise.accel] {
        *triad = TriadParameters { random_walk: triad.random_walk, ..TriadParameters::default() };
    }
    noise.initial = InitialErrorParameters::default();
    noise.gravity = GravityDisturbanceParameters::default();
    noise.altimeter = AltimeterParameters::default();
    let mut more = noise;
    for triad in [&mut more.gyro, &mut more.accel] {
        triad.random_walk *= 1.1f64.sqrt();
    }
    let samples = built_in("patrol", 300.0, 0.5);
    let right = [Scene::new("white noise", samples.clone(), noise)];
    assert_eq!(outside(&right, 1500), 0);
    let wrong = [Scene { believed: more, ..Scene::new("white noise, told wrong", samples, noise) }];
    assert!(outside(&wrong, 1500) >= INSTANTS, "the normalized squares of all instants are 9 % low");
}
