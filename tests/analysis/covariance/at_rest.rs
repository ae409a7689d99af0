//! The covariance at rest over a day.

use nalgebra::{SMatrix, Vector3};
use sins::earth::Earth;
use sins::mechanization::VerticalMode;
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::truth::IntakeLimits;
use sins::{Options, Simulator};

use super::{MICRO_G, MODEL};
use crate::support::{DEG, DEG_PER_HOUR, resting_sample};

const LATITUDE: f64 = 39.9 * DEG;

/// φ east, north, up; δv east, north; δr east, north; then the six inputs, which are constant: eps east, north, up, nabla east,
/// north, and one spare.
type System = SMatrix<f64, 13, 13>;

/// The error equations alone, at rest at height 0, level and heading north (Titterton and Weston 2004, §12.3).
fn at_rest() -> System {
    let earth = Earth::new(Default::default(), Default::default());
    let (sin, cos) = LATITUDE.sin_cos();
    let radii = earth.radii(sin);
    let (m, n) = (radii.meridian_m, radii.transverse_m);
    let (wn, wu) = (earth.rate_rad_s * cos, earth.rate_rad_s * sin);
    let place = sins::earth::Geodetic { latitude_rad: LATITUDE, longitude_rad: 0.0, height_m: 0.0 };
    let g = earth.gravity(&earth.to_earth_fixed(&place)).norm();
    let mut f = System::zeros();
    let mut set = |row, column, value| f[(row, column)] = value;
    set(0, 1, wu);
    set(0, 2, -wn);
    set(0, 4, -1.0 / m);
    set(1, 0, -wu);
    set(1, 3, 1.0 / n);
    set(1, 6, -wu / m);
    set(2, 0, wn);
    set(2, 3, sin / cos / n);
    set(2, 6, wn / m);
    set(3, 1, -g);
    set(3, 4, 2.0 * wu);
    set(4, 0, g);
    set(4, 3, -2.0 * wu);
    set(5, 3, 1.0);
    set(6, 4, 1.0);
    for axis in 0..3 {
        set(axis, 7 + axis, -1.0);
    }
    set(3, 10, 1.0);
    set(4, 11, 1.0);
    f
}

/// exp(f t), by its series over steps of a minute.
fn exponential(f: &System, t: f64) -> System {
    let (mut term, mut sum) = (System::identity(), System::identity());
    for k in 1..20 {
        term = term * f * (60.0 / f64::from(k));
        sum += term;
    }
    (0..(t / 60.0).round() as usize).fold(System::identity(), |power, _| power * sum)
}

fn options() -> Options {
    Options {
        covariance: true,
        vertical: VerticalMode::FollowTruth,
        intake: IntakeLimits { period_s: Some(0.5), ..IntakeLimits::default() },
        ..Options::default()
    }
}

/// Flies at rest and returns the sigmas of φ, horizontal δv and horizontal δr at each hour.
fn hours_at_rest(simulator: &mut Simulator, hours: usize) -> Vec<[f64; 7]> {
    let mut found = Vec::new();
    for k in 0..=2 * 3600 * hours {
        simulator.push_sample(&resting_sample(0.5 * k as f64)).unwrap();
        simulator.step().unwrap();
        if k > 0 && k % 7200 == 0 {
            let (_, covariance, _) = simulator.covariance().unwrap().unwrap();
            let [pe, pn, _, ve, vn, _, fe, fn_, fu] = covariance.sigma();
            found.push([fe, fn_, fu, ve, vn, pe, pn]);
        }
    }
    found
}

/// Compares the sigmas with the roots of `variance` at each hour. The result is the largest relative difference.
fn agree(found: &[[f64; 7]], variance: impl Fn(f64) -> [f64; 7]) -> f64 {
    // The scale of each quantity is its largest value on the way: a sigma that swings through 0 has no relative error there.
    let expected: Vec<_> =
        (1..=found.len()).map(|hour| variance(3600.0 * hour as f64).map(f64::sqrt)).collect();
    let mut worst = 0.0f64;
    for k in 0..7 {
        let largest = expected.iter().map(|sigmas| sigmas[k]).fold(0.0, f64::max);
        let apart = found.iter().zip(&expected).map(|(f, e)| (f[k] - e[k]).abs()).fold(0.0, f64::max);
        println!("{k}: {:.2e} of {largest:.4e}", apart / largest);
        assert!(apart <= MODEL * largest, "{k}: {apart:e} of {largest:e}");
        worst = worst.max(apart / largest);
    }
    worst
}

/// A constant is drawn once a run: the sigma is the response to 1 sigma of it.
#[test]
fn turn_on_biases_and_initial_tilt_at_rest_over_a_day() {
    let mut worst = 0.0f64;
    for input in 0..6 {
        let mut simulator = Simulator::new(&options()).unwrap();
        let mut start = SMatrix::<f64, 13, 1>::zeros();
        let along = |axis: usize, size: f64| {
            let mut vector = Vector3::zeros();
            vector[axis] = size;
            vector
        };
        if input < 3 {
            start[7 + input] = 0.01 * DEG_PER_HOUR;
            let bias_sigma = along(input, 0.01 * DEG_PER_HOUR);
            simulator.set_gyro(&TriadParameters { bias_sigma, ..Default::default() }).unwrap();
        } else if input < 5 {
            start[7 + input] = 10.0 * MICRO_G;
            let bias_sigma = along(input - 3, 10.0 * MICRO_G);
            simulator.set_accel(&TriadParameters { bias_sigma, ..Default::default() }).unwrap();
        } else {
            start[0] = 1e-4;
            let misalignment_sigma_n = along(0, 1e-4);
            simulator
                .set_initial_errors(&InitialErrorParameters { misalignment_sigma_n, ..Default::default() })
                .unwrap();
        }
        println!("input {input}");
        let f = at_rest();
        let apart = agree(&hours_at_rest(&mut simulator, 24), |t| {
            let end = exponential(&f, t) * start;
            core::array::from_fn(|row| end[row] * end[row])
        });
        worst = worst.max(apart);
    }
    println!("figure: biases and tilt {worst:.0e} (limit {MODEL:.1e})");
}

/// White noise and random walks: the covariance by Van Loan's matrix exponential.
#[test]
fn noise_and_random_walks_at_rest_over_a_day() {
    let (arw, vrw) = (0.002 * DEG / 60.0, 10.0 * MICRO_G);
    let (rrw, acc) = (0.001 * DEG_PER_HOUR / 60.0, 1.0 * MICRO_G / 60.0);
    let mut simulator = Simulator::new(&options()).unwrap();
    let triad = |random_walk, rate_random_walk| TriadParameters {
        random_walk: Vector3::repeat(random_walk),
        rate_random_walk: Vector3::repeat(rate_random_walk),
        ..Default::default()
    };
    simulator.set_gyro(&triad(arw, rrw)).unwrap();
    simulator.set_accel(&triad(vrw, acc)).unwrap();
    let f = at_rest();
    let mut q = System::zeros();
    for axis in 0..3 {
        (q[(axis, axis)], q[(7 + axis, 7 + axis)]) = (arw * arw, rrw * rrw);
    }
    for axis in 0..2 {
        (q[(3 + axis, 3 + axis)], q[(10 + axis, 10 + axis)]) = (vrw * vrw, acc * acc);
    }
    let worst = agree(&hours_at_rest(&mut simulator, 24), |t| {
        // P' = F P + P Fᵀ + Q in steps of a minute, each by the series of the integral.
        let mut p = System::zeros();
        let step = 60.0;
        let phi = exponential(&f, step);
        let mut term = q * step;
        let mut noise = term;
        for k in 2..20 {
            term = (f * term + term * f.transpose()) * (step / f64::from(k));
            noise += term;
        }
        for _ in 0..(t / step).round() as usize {
            p = phi * p * phi.transpose() + noise;
        }
        core::array::from_fn(|row| p[(row, row)])
    });
    println!("figure: noise and walks {worst:.0e} (limit {MODEL:.1e})");
}
