//! The covariance in the first seconds at rest, against closed forms.

use nalgebra::Vector3;
use sins::mechanization::VerticalMode;
use sins::sensors::TriadParameters;
use sins::truth::IntakeLimits;
use sins::{Options, Simulator};

use super::MICRO_G;
use crate::support::resting_sample;

const PERIOD_S: f64 = 0.1;

/// The largest relative difference of the east velocity's and position's sigma from `expected` over 3 s.
fn apart(accel: &TriadParameters, expected: impl Fn(f64) -> [f64; 2]) -> f64 {
    let options = Options {
        covariance: true,
        vertical: VerticalMode::FollowTruth,
        intake: IntakeLimits { period_s: Some(PERIOD_S), ..IntakeLimits::default() },
        ..Options::default()
    };
    let mut simulator = Simulator::new(&options).unwrap();
    simulator.set_accel(accel).unwrap();
    let mut apart = 0.0f64;
    for k in 0..=30 {
        let t = PERIOD_S * f64::from(k);
        simulator.push_sample(&resting_sample(t)).unwrap();
        simulator.step().unwrap();
        if k > 0 {
            let (_, covariance, _) = simulator.covariance().unwrap().unwrap();
            let sigma = covariance.sigma();
            for (found, variance) in [sigma[3], sigma[0]].into_iter().zip(expected(t)) {
                apart = apart.max((found / variance.sqrt() - 1.0).abs());
            }
        }
    }
    apart
}

/// Errors oscillate with the angular frequency w of the Schuler period, 5,064 s. The velocity that white noise causes has the variance
/// t/2 + sin(2wt)/4w: its sigma is smaller by (wt)²/6, 2.3e-6 after 3 s. For slower noise, and for the position, it is less.
const GRAVITY: f64 = 2.4e-6;

#[test]
fn a_random_walk_has_its_closed_form_from_the_first_sample_on() {
    let density = 1.0 * MICRO_G;
    let accel = TriadParameters { rate_random_walk: Vector3::repeat(density), ..Default::default() };
    let apart =
        apart(&accel, |t| [density * density * t.powi(3) / 3.0, density * density * t.powi(5) / 20.0]);
    assert!(apart < GRAVITY, "{apart:e}");
    println!("figure: random walk {apart:.1e}");
}

/// Stationary, of x = t/τ: the variance of ∫b is 2 (x - 1 + e^-x) σ² τ², and that of ∫∫b is 2 (x³/3 - x²/2 + 1 - (1 + x) e^-x) σ² τ⁴.
#[test]
fn a_gauss_markov_process_has_its_closed_form_from_the_first_sample_on() {
    let sigma = 10.0 * MICRO_G;
    let mut worst = 0.0f64;
    for time_s in [0.01, 0.05, 0.2, 1.0, 5.0] {
        let accel = TriadParameters {
            markov_sigma: Vector3::repeat(sigma),
            markov_time_s: Vector3::repeat(time_s),
            ..Default::default()
        };
        let apart = apart(&accel, |t| {
            let x = t / time_s;
            let decay = (-x).exp();
            let single = 2.0 * (x - 1.0 + decay);
            let double = 2.0 * (x.powi(3) / 3.0 - x * x / 2.0 + 1.0 - (1.0 + x) * decay);
            [sigma * sigma * time_s.powi(2) * single, sigma * sigma * time_s.powi(4) * double]
        });
        println!("{time_s} s: {apart:.1e}");
        assert!(apart < GRAVITY, "{time_s} s: {apart:e}");
        worst = worst.max(apart);
    }
    println!("figure: Gauss-Markov {worst:.1e} (limit {GRAVITY:.1e}, the share of gravity)");
}
