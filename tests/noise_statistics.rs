//! Statistics of each random term: mean, variance, autocorrelation, independence, within five standard deviations of what
//! the sample size leaves.

mod support;

use nalgebra::Vector3;
use sins::sensors::{
    Altimeter, AltimeterParameters, InitialErrorParameters, Sensor, StreamKey, Triad, TriadParameters,
};
use sins::signal::Increment;

const SIGMAS: f64 = 5.0;

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Mean product of two series of known zero mean.
fn covariance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / a.len().min(b.len()) as f64
}

/// A mean of `n` independent numbers of standard deviation `sigma` is 0.
fn assert_zero(label: &str, value: f64, sigma: f64, n: usize) {
    let bound = SIGMAS * sigma / (n as f64).sqrt();
    assert!(value.abs() < bound, "{label}: {value:e}, bound {bound:e}");
}

/// A mean square of `n` independent normal numbers is `variance`; its standard deviation is variance √(2/n).
fn assert_variance(label: &str, value: f64, variance: f64, n: usize) {
    let bound = SIGMAS * variance * (2.0 / n as f64).sqrt();
    assert!((value - variance).abs() < bound, "{label}: {value:e} of {variance:e}, bound {bound:e}");
}

fn triad(seed: u64, run: u64, sensor: Sensor, parameters: &TriadParameters) -> Triad {
    let mut triad = Triad::new(StreamKey { seed, run }, sensor);
    triad.set(parameters);
    triad
}

/// `n` increments of `dt` [s] of the errors of a triad, axis by axis.
fn increments(triad: &mut Triad, n: usize, dt: f64) -> [Vec<f64>; 3] {
    let mut axes = [const { Vec::new() }; 3];
    for _ in 0..n {
        let sensed = triad.sense(&Increment::ZERO, dt);
        for (axis, values) in axes.iter_mut().enumerate() {
            values.push(sensed[axis]);
        }
    }
    axes
}

fn white(density: f64) -> TriadParameters {
    TriadParameters { random_walk: Vector3::repeat(density), ..Default::default() }
}

#[test]
fn white_noise_is_white_and_of_its_density() {
    let (n, dt, density) = (200_000, 0.005, 1.5e-6);
    for sensor in [Sensor::Gyro, Sensor::Accelerometer] {
        let axes = increments(&mut triad(1, 0, sensor, &white(density)), n, dt);
        let variance = density * density * dt;
        for values in &axes {
            assert_zero("mean", mean(values), variance.sqrt(), n);
            assert_variance("variance", covariance(values, values), variance, n);
            for lag in [1, 2, 10, 1000] {
                assert_zero("autocorrelation", covariance(values, &values[lag..]), variance, n);
            }
            // Kurtosis of a normal number is 3, and its sample's standard deviation √(96/n) (fourth moment over σ⁴).
            let fourth = values.iter().map(|v| v.powi(4)).sum::<f64>() / n as f64 / (variance * variance);
            assert!((fourth - 3.0).abs() < SIGMAS * (96.0 / n as f64).sqrt(), "{fourth}");
        }
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            assert_zero("axes", covariance(&axes[a], &axes[b]), variance, n);
        }
    }
}

/// The same density at 50, 100 and 400 Hz and at jittering intervals is the same physical process: the random walk after a
/// second has the variance N².
#[test]
fn densities_do_not_depend_on_the_sample_rate() {
    let seconds = 4000;
    for rate in [50, 100, 400] {
        let mut triad = triad(2, rate, Sensor::Gyro, &white(1.0));
        let walks: Vec<f64> = (0..seconds)
            .map(|_| increments(&mut triad, rate as usize, 1.0 / rate as f64)[0].iter().sum())
            .collect();
        assert_variance("walk of a second", covariance(&walks, &walks), 1.0, seconds);
    }
    let mut triad = triad(2, 1, Sensor::Gyro, &white(1.0));
    let walks: Vec<f64> = (0..seconds)
        .map(|_| {
            let jittering = (0..100).map(|k| if k % 2 == 0 { 0.004 } else { 0.016 });
            jittering.map(|dt| triad.sense(&Increment::ZERO, dt).x).sum()
        })
        .collect();
    assert_variance("walk of a second", covariance(&walks, &walks), 1.0, seconds);
}

#[test]
fn runs_seeds_sensors_and_effects_are_independent() {
    let n = 50_000;
    let parameters = TriadParameters {
        markov_sigma: Vector3::repeat(1.0),
        markov_time_s: Vector3::repeat(1e-9),
        ..Default::default()
    };
    // With a correlation time far below the step the Gauss-Markov increments are white: σ²τ² 2 (a - 2).
    let series = [
        increments(&mut triad(3, 0, Sensor::Gyro, &white(1.0)), n, 1.0),
        increments(&mut triad(3, 1, Sensor::Gyro, &white(1.0)), n, 1.0),
        increments(&mut triad(4, 0, Sensor::Gyro, &white(1.0)), n, 1.0),
        increments(&mut triad(3, 0, Sensor::Accelerometer, &white(1.0)), n, 1.0),
        increments(&mut triad(3, 0, Sensor::Gyro, &parameters), n, 1.0),
    ];
    for (i, a) in series.iter().enumerate() {
        for b in &series[i + 1..] {
            for (x, y) in a.iter().zip(b) {
                let scale = (covariance(x, x) * covariance(y, y)).sqrt();
                assert_zero("cross correlation", covariance(x, y), scale, n);
            }
        }
    }
}

/// Over an ensemble of runs: stationary from the first sample on, the right correlation at every lag, and the integral of
/// the continuous process, for steps of a thousandth to ten correlation times.
#[test]
fn gauss_markov_is_stationary_with_its_correlation_time() {
    let (runs, sigma, time) = (4000_usize, 0.02, 3.0);
    for dt in [0.003, 0.3, 3.0, 30.0] {
        let parameters = TriadParameters {
            markov_sigma: Vector3::repeat(sigma),
            markov_time_s: Vector3::repeat(time),
            ..Default::default()
        };
        let a: f64 = dt / time;
        let steps = 20;
        let mut at_start = Vec::new();
        let mut at_end = Vec::new();
        let mut integrals = Vec::new();
        for run in 0..runs {
            let mut triad = triad(5, run as u64, Sensor::Gyro, &parameters);
            at_start.push(triad.steady_error(&Vector3::zeros(), &Vector3::zeros()).x);
            integrals.push(increments(&mut triad, steps, dt)[0].iter().sum::<f64>());
            at_end.push(triad.steady_error(&Vector3::zeros(), &Vector3::zeros()).x);
        }
        let variance = sigma * sigma;
        assert_variance("at the start", covariance(&at_start, &at_start), variance, runs);
        assert_variance("at the end", covariance(&at_end, &at_end), variance, runs);
        let long = a * steps as f64;
        // The sample covariance of correlated pairs has a variance of σ⁴ (1 + ρ²) at most.
        let lagged = covariance(&at_start, &at_end) - variance * (-long).exp();
        assert_zero("correlation over 20 steps", lagged, variance * 2f64.sqrt(), runs);
        let integral = 2.0 * variance * time * time * (long - 1.0 + (-long).exp());
        assert_variance("integral over 20 steps", covariance(&integrals, &integrals), integral, runs);
    }
}

#[test]
fn drawn_once_a_run_means_once_a_run_and_normal() {
    let runs = 4000_usize;
    let parameters = TriadParameters { bias_sigma: Vector3::repeat(2.0), ..Default::default() };
    let start = InitialErrorParameters { position_sigma_n: Vector3::repeat(3.0), ..Default::default() };
    let mut biases = Vec::new();
    let mut positions = Vec::new();
    for run in 0..runs {
        let mut triad = triad(6, run as u64, Sensor::Accelerometer, &parameters);
        let [x, _, _] = increments(&mut triad, 3, 1.0);
        assert!(x.iter().all(|&value| value == x[0]), "the same all through the run");
        biases.push(x[0]);
        positions.push(start.draw(StreamKey { seed: 6, run: run as u64 }).position_n.y);
    }
    for (values, sigma) in [(&biases, 2.0), (&positions, 3.0)] {
        assert_zero("mean", mean(values), sigma, runs);
        assert_variance("variance", covariance(values, values), sigma * sigma, runs);
    }
    assert_zero("bias and position", covariance(&biases, &positions), 6.0, runs);
}

#[test]
fn altimeter_noise_is_of_its_parameters() {
    let n = 100_000;
    let mut altimeter = Altimeter::new(StreamKey { seed: 7, run: 0 }, 0.0);
    altimeter.set(&AltimeterParameters {
        noise_m: 0.5,
        markov_sigma_m: 10.0,
        markov_time_s: 1.0,
        ..Default::default()
    });
    // A step of two correlation times: e^-2 of the Markov error is left from one sample to the next.
    let heights: Vec<f64> = (0..n).map(|_| altimeter.sense(0.0, 2.0)).collect();
    let decay = (-2f64).exp();
    // The effective number of independent squares of an autoregressive series is n (1 - d²)/(1 + d²).
    let effective = (n as f64 * (1.0 - decay * decay) / (1.0 + decay * decay)) as usize;
    assert_variance("sum", covariance(&heights, &heights), 100.25, effective);
    let lagged = covariance(&heights, &heights[1..]) - 100.0 * decay;
    assert_zero("correlation of neighbours", lagged, 100.25 * 1.1, effective);
}
