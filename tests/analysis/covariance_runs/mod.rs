//! The covariance against ensembles: the spread of many runs with other draws equals the covariance, by chi-square, and a
//! covariance of densities that are wrong by 10 % is detected.
//!
//! The ordinary test flies 200 runs and an hour of the patrol; `--features long-tests` flies 2000 runs and all of its 48 hours.

mod failures;
mod scenes;

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

use nalgebra::SMatrix;
use scenes::{Scene, aligned_scenes, built_in, everything, scenes};
use sins::ensemble::Ensemble;
use sins::ensemble::statistics::Statistics;
use sins::sensors::TriadParameters;
use sins::{ErrorParameters, ErrorSource};

const INSTANTS: usize = 20;
/// Runs of an ensemble.
const BLOCK: u64 = 64;
type Matrix = SMatrix<f64, 9, 9>;

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

/// Least and greatest of some figures, and the interval in which they should be.
#[derive(Clone, Copy)]
struct Range {
    least: f64,
    most: f64,
    low: f64,
    high: f64,
    /// Number of figures that are outside of the interval.
    outside: usize,
}

impl Range {
    /// Of no figure yet, with the interval of chi-square of `n` over n at `z` standard deviations of the normal one.
    fn new(n: f64, z: f64) -> Self {
        let (low, high) = chi_square_bounds(n, z);
        Self { least: f64::MAX, most: f64::MIN, low, high, outside: 0 }
    }

    fn add(&mut self, figure: f64) {
        (self.least, self.most) = (self.least.min(figure), self.most.max(figure));
        self.outside += usize::from(!(self.low..=self.high).contains(&figure));
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { least, most, low, high, .. } = self;
        write!(f, "{least:.3} to {most:.3} (limits {low:.3} and {high:.3})")
    }
}

/// Mean squares of a scene's runs, each over its expectation.
struct Found {
    /// Mean square of each error at each instant.
    sigmas: Vec<[f64; 9]>,
    /// The normalized square of the nine errors, over nine.
    nees: Vec<f64>,
}

impl Scene {
    /// Whether sample `k` is one of the instants that are evaluated.
    fn is_looked_at(&self, k: usize) -> bool {
        let every = (self.samples.len() - 1) / INSTANTS;
        k > 0 && k.is_multiple_of(every) && k / every <= INSTANTS
    }

    /// The covariance at each instant.
    fn covariances(&self) -> Vec<Matrix> {
        let mut simulator = self.simulator(&self.believed, true);
        let mut covariances = Vec::new();
        for (k, sample) in self.samples.iter().enumerate() {
            simulator.push_sample(sample).unwrap();
            simulator.step().unwrap();
            if self.is_looked_at(k) {
                covariances.push(simulator.covariance().unwrap().unwrap().1.matrix);
            }
        }
        covariances
    }

    /// Statistics of `runs` runs from `first` on, at each instant.
    fn statistics(&self, first: u64, runs: usize) -> Vec<Statistics> {
        let template = self.simulator(&self.setting, false);
        let mut ensemble = Ensemble::new(&template, first, runs).unwrap();
        let mut statistics = Vec::new();
        for (k, sample) in self.samples.iter().enumerate() {
            ensemble.push_sample(sample).unwrap();
            ensemble.step().unwrap();
            if self.is_looked_at(k) {
                // At a pole east and north of the navigation differ from those of the truth. The error equations of the same
                // draws are used there.
                let is_near_pole = ensemble.truth().unwrap().near_pole;
                let source = if is_near_pole { ErrorSource::Model } else { ErrorSource::Navigation };
                statistics.push(ensemble.statistics(source).unwrap());
            }
        }
        statistics
    }

    /// Statistics of the runs 0 to `runs` - 1 at each instant, block by block on all cores.
    fn statistics_of_blocks(&self, runs: u64) -> Vec<Statistics> {
        let next = AtomicU64::new(0);
        let of_thread = || {
            let mut sums = vec![Statistics::EMPTY; INSTANTS];
            loop {
                let first = next.fetch_add(BLOCK, Ordering::Relaxed);
                if first >= runs {
                    return sums;
                }
                let block = self.statistics(first, BLOCK.min(runs - first) as usize);
                merge(&mut sums, &block);
            }
        };
        let threads = std::thread::available_parallelism().map_or(1, |count| count.get());
        let mut sums = vec![Statistics::EMPTY; INSTANTS];
        std::thread::scope(|scope| {
            let handles: Vec<_> = (0..threads).map(|_| scope.spawn(of_thread)).collect();
            handles.into_iter().for_each(|handle| merge(&mut sums, &handle.join().unwrap()));
        });
        sums
    }

    /// Flies `runs` runs and compares them with the covariance.
    fn fly(&self, runs: u64) -> Found {
        let mut found = Found { sigmas: Vec::new(), nees: Vec::new() };
        for (covariance, statistics) in self.covariances().iter().zip(self.statistics_of_blocks(runs)) {
            let figures = statistics.figures().unwrap();
            assert_eq!((figures.runs, figures.diverged, figures.out_of_range), (runs, 0, 0));
            let n = runs as f64;
            let squares = figures.covariance * ((n - 1.0) / n) + figures.mean * figures.mean.transpose();
            // In units of sigma: the nine errors are of very different size.
            let scale = Matrix::from_diagonal(&covariance.diagonal().map(|variance| 1.0 / variance.sqrt()));
            let inverse = (scale * covariance * scale).cholesky().expect("positive").inverse();
            let squares = scale * squares * scale;
            found.sigmas.push(core::array::from_fn(|row| squares[(row, row)]));
            found.nees.push((inverse * squares).trace() / 9.0);
        }
        found
    }
}

fn merge(sums: &mut [Statistics], more: &[Statistics]) {
    sums.iter_mut().zip(more).for_each(|(sum, more)| sum.merge(more).unwrap());
}

/// The variances of the scenes over those of the covariance, and the normalized squares over nine, against their intervals of 99.9 %,
/// corrected for their number (Bonferroni).
fn compare(scenes: &[Scene], runs: u64) -> [Range; 2] {
    let tests = scenes.len() * INSTANTS * 10;
    let z = quantile(0.001 / 2.0 / tests as f64);
    let none = [Range::new(runs as f64, z), Range::new(9.0 * runs as f64, z)];
    let mut all = none;
    for scene in scenes {
        let started = std::time::Instant::now();
        let found = scene.fly(runs);
        let mut of_scene = none;
        for [variances, nees] in [&mut of_scene, &mut all] {
            found.sigmas.iter().flatten().for_each(|share| variances.add(*share));
            found.nees.iter().for_each(|share| nees.add(*share));
        }
        let [variances, nees] = of_scene;
        println!(
            "{}: {runs} runs, {} samples: variances over the covariance's {variances}, NEES/9 {nees}, {:.1} s",
            scene.name,
            scene.samples.len(),
            started.elapsed().as_secs_f64()
        );
        if std::env::var_os("SHOW").is_some() {
            for (k, (sigmas, nees)) in found.sigmas.iter().zip(&found.nees).enumerate() {
                println!("{k:3} {:.3?} {nees:.3}", sigmas);
            }
        }
    }
    all
}

/// 200 runs, the patrol of an hour; `--features long-tests`: 2000 runs, the patrol of 48 hours.
#[test]
fn the_spread_of_many_runs_is_the_covariance() {
    let is_long = cfg!(feature = "long-tests");
    let [variances, nees] = compare(&scenes(is_long), if is_long { 2000 } else { 200 });
    assert_eq!(variances.outside + nees.outside, 0);
    println!("figure: variances {variances}; NEES/9 {nees}");
}

/// After alignments that take time, whose errors are correlated with the states of the sensors: 200 runs of 20 minutes;
/// `--features long-tests`: 2000 runs of 2 hours. A covariance with an endless alignment is found to be wrong.
#[test]
fn the_spread_after_an_alignment_is_the_covariance() {
    let is_long = cfg!(feature = "long-tests");
    let runs = if is_long { 2000 } else { 200 };
    let mut scenes = aligned_scenes(is_long);
    let [variances, nees] = compare(&scenes, runs);
    assert_eq!(variances.outside + nees.outside, 0);
    scenes.truncate(2);
    scenes.iter_mut().for_each(|scene| scene.believed.initial.alignment_s = 0.0);
    let [variances, endless] = compare(&scenes, runs);
    assert!(variances.outside + endless.outside > INSTANTS);
    println!("figure: NEES/9 {nees}, with an endless alignment {:.3} to {:.3}", endless.least, endless.most);
}

/// White noise alone, with a covariance from a spectral density that is 10 % larger: the same test fails.
#[test]
fn a_density_that_is_wrong_by_a_tenth_is_found() {
    let everything = everything();
    let of_noise =
        |triad: TriadParameters| TriadParameters { random_walk: triad.random_walk, ..Default::default() };
    let noise = ErrorParameters {
        gyro: of_noise(everything.gyro),
        accel: of_noise(everything.accel),
        ..Default::default()
    };
    let mut more = noise;
    for triad in [&mut more.gyro, &mut more.accel] {
        triad.random_walk *= 1.1f64.sqrt();
    }
    let samples = built_in("patrol", 300.0, 0.5);
    let scene = Scene::new("white noise", samples.clone(), noise);
    let [variances, right] = compare(&[scene], 1500);
    assert_eq!(variances.outside + right.outside, 0);
    let scene = Scene { believed: more, ..Scene::new("white noise, told wrong", samples, noise) };
    let [variances, wrong] = compare(&[scene], 1500);
    let outside = variances.outside + wrong.outside;
    assert!(outside >= INSTANTS, "the normalized squares of all instants are 9 % low");
    println!("figure: NEES/9 {wrong}; with the right density {:.3} to {:.3}", right.least, right.most);
}
