//! Increments of the five noises, each made from its definition and none by the library.

use rand_distr::{Distribution, StandardNormal};
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;

/// Coefficients Q [u s], N [u √s], B [u], K [u/√s], R [u/s] of a rate in u.
#[derive(Debug, Clone, Copy, Default)]
pub struct Coefficients {
    pub q: f64,
    pub n: f64,
    pub b: f64,
    pub k: f64,
    pub r: f64,
}

impl Coefficients {
    pub fn squares(&self) -> [f64; 5] {
        [self.q, self.n, self.b, self.k, self.r].map(|c| c * c)
    }
}

/// Normal numbers of a seed.
pub struct Normal(Xoshiro256PlusPlus);

impl Normal {
    pub fn new(seed: u64) -> Self {
        Self(Xoshiro256PlusPlus::seed_from_u64(seed))
    }

    fn draw(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }
}

/// `count` increments over `dt` [s] of all noises together.
pub fn increments(c: &Coefficients, count: usize, dt: f64, normal: &mut Normal) -> Vec<f64> {
    let mut sum = vec![0.0; count];
    let mut add = |noise: Vec<f64>| sum.iter_mut().zip(noise).for_each(|(sum, value)| *sum += value);
    if c.q > 0.0 {
        add(quantization(c.q, count, normal));
    }
    if c.n > 0.0 {
        add((0..count).map(|_| c.n * dt.sqrt() * normal.draw()).collect());
    }
    if c.b > 0.0 {
        add(flicker(c.b, count, dt, normal));
    }
    if c.k > 0.0 {
        add(rate_random_walk(c.k, count, dt, normal));
    }
    if c.r > 0.0 {
        add((0..count).map(|k| c.r * dt * dt * (k as f64 + 0.5)).collect());
    }
    sum
}

/// Rounding errors of a random walk of ten quantization steps at a time, as increments: Q is step / √12.
fn quantization(q: f64, count: usize, normal: &mut Normal) -> Vec<f64> {
    let (mut angle, mut last) = (0.0, 0.0);
    let mut next = || {
        angle += 10.0 * normal.draw();
        let error = f64::round(angle) - angle;
        let increment = error - last;
        last = error;
        increment
    };
    next();
    (0..count).map(|_| q * 12f64.sqrt() * next()).collect()
}

/// Rate r' = K w: the integral over a step is r dt + K √(dt³) (n1 / 2 + n2 / √12), where r grows by K √dt n1.
fn rate_random_walk(k: f64, count: usize, dt: f64, normal: &mut Normal) -> Vec<f64> {
    let mut rate = 0.0;
    let mut next = || {
        let (n1, n2) = (normal.draw(), normal.draw());
        let increment = rate * dt + k * dt * dt.sqrt() * (0.5 * n1 + n2 / 12f64.sqrt());
        rate += k * dt.sqrt() * n1;
        increment
    };
    (0..count).map(|_| next()).collect()
}

/// The spectrum B² / 2πf as a sum of Gauss-Markov processes. Their correlation times T differ by factors of 2, from a
/// fiftieth of a step to fifty records; shorter ones are together white, with the density 2 σ² (T/2 + T/4 + ...).
///
/// Each has the spectrum 2 σ² T / (1 + (2πfT)²) = σ² sech(ln 2πfT) / 2πf. Hyperbolic secants at distances of ln 2 add up to
/// π / ln 2, within 2 sech(π² / ln 2) = 3e-6 of that (Poisson's sum): σ² = B² ln 2 / π.
fn flicker(b: f64, count: usize, dt: f64, normal: &mut Normal) -> Vec<f64> {
    let sigma = b * (std::f64::consts::LN_2 / std::f64::consts::PI).sqrt();
    let mut time = 0.02 * dt;
    let white = sigma * (2.0 * time * dt).sqrt();
    let mut sum: Vec<f64> = (0..count).map(|_| white * normal.draw()).collect();
    while time < 50.0 * count as f64 * dt {
        let a = dt / time;
        let decay = (-a).exp();
        let mut x = sigma * normal.draw();
        // End value and integral over a step, given the value at its start, are normal with these covariances.
        let e = -(-a).exp_m1();
        let end = sigma * (e * (2.0 - e)).sqrt();
        let shared = sigma * sigma * time * e * e / end;
        let variance = sigma * sigma * time * time * integral_variance(a);
        let own = (variance - shared * shared).max(0.0).sqrt();
        for value in &mut sum {
            let (n1, n2) = (normal.draw(), normal.draw());
            *value += time * e * x + shared * n1 + own * n2;
            x = decay * x + end * n1;
        }
        time *= 2.0;
    }
    sum
}

/// 2a - 3 + 4e^-a - e^-2a; where it cancels, its series 2a³/3 - a⁴/2 + 7a⁵/30, true to 1e-4 of itself at a hundredth.
fn integral_variance(a: f64) -> f64 {
    if a < 0.01 {
        return a.powi(3) * (2.0 / 3.0 - a * (0.5 - a * 7.0 / 30.0));
    }
    2.0 * a - 3.0 + 4.0 * (-a).exp() - (-2.0 * a).exp()
}
