//! Statistics of each random term: mean, variance, autocorrelation, independence. Each is within five standard deviations of
//! its sample statistic.

use nalgebra::{Matrix3, Vector3};
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

/// Asserts that a mean of `n` independent numbers of standard deviation `sigma` is 0.
fn assert_zero(label: &str, value: f64, sigma: f64, n: usize) {
    let bound = SIGMAS * sigma / (n as f64).sqrt();
    assert!(value.abs() < bound, "{label}: {value:e}, bound {bound:e}");
}

/// Asserts that a mean square of `n` independent normal numbers is `variance`; its standard deviation is variance √(2/n).
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
            at_start.push(triad.steady_error(&Vector3::zeros(), &Vector3::zeros(), None).x);
            integrals.push(increments(&mut triad, steps, dt)[0].iter().sum::<f64>());
            at_end.push(triad.steady_error(&Vector3::zeros(), &Vector3::zeros(), None).x);
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

/// Scale factors and misalignments of gyros and accelerometers, with the turn-on biases of both: each element has its variance, and
/// all elements are independent.
#[test]
fn scatter_is_drawn_once_a_run_and_each_element_for_itself() {
    let runs = 4000_usize;
    let sigmas = Matrix3::new(1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3, 7e-3, 8e-3, 9e-3);
    let mut misalignment_sigma = sigmas;
    misalignment_sigma.fill_diagonal(0.0);
    let scatter =
        TriadParameters { scale_factor_sigma: sigmas.diagonal(), misalignment_sigma, ..Default::default() };
    let biases = TriadParameters { bias_sigma: Vector3::repeat(1.0), ..Default::default() };
    let mut draws = vec![Vec::new(); 24];
    for run in 0..runs {
        let mut element = draws.iter_mut();
        for sensor in [Sensor::Gyro, Sensor::Accelerometer] {
            let mut drawn = triad(6, run as u64, sensor, &scatter);
            for column in 0..3 {
                let unit = Vector3::from_fn(|axis, _| if axis == column { 1.0 } else { 0.0 });
                let error = drawn.steady_error(&unit, &unit, None);
                for (value, sigma) in error.iter().zip(&sigmas.column(column)) {
                    element.next().unwrap().push(value / sigma);
                }
                // The error in flight is the same, all through the run.
                let increment = Increment { angle: unit, velocity: unit };
                for _ in 0..3 {
                    let sensed = drawn.sense(&increment, 1.0) - unit;
                    assert!((sensed - error).amax() < 2.0 * f64::EPSILON, "{sensed} {error}");
                }
            }
            let bias = triad(6, run as u64, sensor, &biases).steady_error(
                &Vector3::zeros(),
                &Vector3::zeros(),
                None,
            );
            bias.iter().for_each(|value| element.next().unwrap().push(*value));
        }
    }
    for (index, values) in draws.iter().enumerate() {
        assert_zero("mean", mean(values), 1.0, runs);
        assert_variance("variance", covariance(values, values), 1.0, runs);
        for other in &draws[..index] {
            assert_zero("two elements", covariance(values, other), 1.0, runs);
        }
    }
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
    let heights: Vec<f64> = (0..n).map(|_| altimeter.sense(0.0, 2.0).unwrap()).collect();
    let decay = (-2f64).exp();
    // The effective number of independent squares of an autoregressive series is n (1 - d²)/(1 + d²).
    let effective = (n as f64 * (1.0 - decay * decay) / (1.0 + decay * decay)) as usize;
    assert_variance("sum", covariance(&heights, &heights), 100.25, effective);
    let lagged = covariance(&heights, &heights[1..]) - 100.0 * decay;
    assert_zero("correlation of neighbours", lagged, 100.25 * 1.1, effective);
}

/// Lengths of increments that fill `seconds`: even ones at several rates, and jittering ones.
fn splittings(seconds: f64) -> Vec<Vec<f64>> {
    let even = [1, 4, 50].map(|n| vec![seconds / f64::from(n); n as usize]);
    let jittering = (0..20).map(|k| seconds / 20.0 * if k % 2 == 0 { 0.4 } else { 1.6 }).collect();
    [&even[..], &[jittering]].concat()
}

fn value(triad: &Triad) -> f64 {
    triad.steady_error(&Vector3::zeros(), &Vector3::zeros(), None).x
}

fn integral(triad: &mut Triad, dts: &[f64]) -> f64 {
    dts.iter().map(|&dt| triad.sense(&Increment::ZERO, dt).x).sum()
}

/// Covariance of the bias and its integral over an ensemble of runs, for any split of the time: K² [t, t²/2; t²/2, t³/3].
#[test]
fn rate_random_walk_has_its_joint_covariance_at_any_increments() {
    let (runs, density, t) = (4000_usize, 0.3, 2.0);
    let parameters = TriadParameters { rate_random_walk: Vector3::repeat(density), ..Default::default() };
    for (case, dts) in splittings(t).iter().enumerate() {
        let mut values = Vec::new();
        let mut integrals = Vec::new();
        for run in 0..runs {
            let mut triad = triad(8 + case as u64, run as u64, Sensor::Gyro, &parameters);
            assert_eq!(value(&triad), 0.0);
            integrals.push(integral(&mut triad, dts));
            values.push(value(&triad));
        }
        let k2 = density * density;
        let (values_variance, integrals_variance) = (k2 * t, k2 * t.powi(3) / 3.0);
        assert_variance("value", covariance(&values, &values), values_variance, runs);
        assert_variance("integral", covariance(&integrals, &integrals), integrals_variance, runs);
        // The sample covariance has the variance (σ1² σ2² + c²)/n.
        let shared = k2 * t * t / 2.0;
        let sigma = (values_variance * integrals_variance + shared * shared).sqrt();
        assert_zero("shared", covariance(&values, &integrals) - shared, sigma, runs);
    }
}

/// Flicker of B = 1, for any split of the time: half the mean square of the difference of two consecutive means is 2 ln 2 / π,
/// 0.664², within the -2 % to +4.6 % of the ripple, from 2 s to 1e5 s. The process is stationary with the variance
/// 6.5 ln 10 / π.
#[test]
fn flicker_has_a_flat_allan_deviation_at_any_increments() {
    let runs = 4000_usize;
    let flat = 2.0 * std::f64::consts::LN_2 / std::f64::consts::PI;
    let variance = 6.5 * std::f64::consts::LN_10 / std::f64::consts::PI;
    let parameters = TriadParameters { flicker: Vector3::repeat(1.0), ..Default::default() };
    for (case, average_s) in [2.0, 50.0, 3000.0, 1e5].into_iter().enumerate() {
        for (split, dts) in splittings(average_s).iter().enumerate() {
            let mut squares = 0.0;
            let mut ends = [Vec::new(), Vec::new()];
            for run in 0..runs {
                let seed = 20 + 10 * case as u64 + split as u64;
                let mut triad = triad(seed, run as u64, Sensor::Accelerometer, &parameters);
                ends[0].push(value(&triad));
                let first = integral(&mut triad, dts) / average_s;
                let second = integral(&mut triad, dts) / average_s;
                ends[1].push(value(&triad));
                squares += 0.5 * (second - first).powi(2) / runs as f64;
            }
            let chance = SIGMAS * (2.0 / runs as f64).sqrt();
            let ratio = squares / flat;
            assert!((0.98 - chance..1.046 + chance).contains(&ratio), "{average_s} s, {split}: {ratio}");
            for values in &ends {
                assert_variance("stationary", covariance(values, values), variance, runs);
            }
        }
    }
}

/// Each random effect of each axis has draws of its own.
#[test]
fn axes_and_effects_are_independent() {
    let n = 50_000;
    let ones = Vector3::repeat(1.0);
    let effects = [
        white(1.0),
        TriadParameters { markov_sigma: ones, markov_time_s: ones * 1e-9, ..Default::default() },
        TriadParameters { rate_random_walk: ones, ..Default::default() },
        TriadParameters { flicker: ones, ..Default::default() },
    ];
    let mut series: Vec<Vec<f64>> = Vec::new();
    for (index, parameters) in effects.iter().enumerate() {
        let mut axes = increments(&mut triad(9, 0, Sensor::Gyro, parameters), n, 1e7);
        if index == 2 {
            // Differences of the walk's integrals are stationary.
            for axis in &mut axes {
                *axis = axis.windows(2).map(|w| w[1] - w[0]).collect();
            }
        }
        series.extend(axes);
    }
    for (i, x) in series.iter().enumerate() {
        for y in &series[i + 1..] {
            let scale = (covariance(x, x) * covariance(y, y)).sqrt();
            // Increments of 1e7 s are white, except for the differences, whose neighbours correlate by 1/4: the mean product
            // of two such series has 1 + 2/16 times the variance of white ones.
            assert_zero("cross correlation", covariance(x, y), scale * 1.125_f64.sqrt(), n);
        }
    }
}
