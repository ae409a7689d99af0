//! What is set of the sensors comes out of the Allan deviation of what they measure: a simulator at rest, all six axes, by
//! the estimator of the report program.

#[path = "support/allan.rs"]
mod allan;

use allan::Records;
use allan::estimate::covariance::of_differences;
use allan::estimate::interval::of_variance;
use allan::estimate::lags::Pair;
use allan::estimate::terms::{TERMS, Term};
use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::math::Euler;
use sins::sensors::TriadParameters;
use sins::truth::FlightSample;
use sins::{Options, Simulator};

const DT: f64 = 0.01;
const COUNT: usize = if cfg!(feature = "long-tests") { 24 * 360_000 } else { 360_000 };

/// Chance leaves an interval of this confidence once in ten thousand times.
const CERTAIN: f64 = 0.9999;

const AXES: [&str; 6] =
    ["gyro x", "gyro y", "gyro z", "accelerometer x", "accelerometer y", "accelerometer z"];

/// Angles and velocities over the intervals that sensors with these parameters measure at rest, gyros before accelerometers.
fn measured(parameters: &TriadParameters) -> [Vec<f64>; 6] {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    simulator.set_gyro(parameters).unwrap();
    simulator.set_accel(parameters).unwrap();
    let place = Geodetic { latitude_rad: 0.7, longitude_rad: 2.0, height_m: 50.0 };
    let mut axes = [const { Vec::new() }; 6];
    for k in 0..=COUNT {
        simulator.push_sample(&FlightSample::at_rest(k as f64 * DT, place, Euler::default())).unwrap();
        simulator.step().unwrap();
        let Some(imu) = simulator.imu() else { continue };
        let both = imu.measured.angle.iter().chain(imu.measured.velocity.iter());
        axes.iter_mut().zip(both).for_each(|(axis, value)| axis.push(*value));
    }
    assert_eq!(axes[0].len(), COUNT);
    axes
}

/// A coefficient, how it is set, and its value [u, s].
type Setting = (Term, fn(&mut TriadParameters, f64), f64);

const N: Setting = (Term::RandomWalk, |p, n| p.random_walk = Vector3::repeat(n), 1.5e-6);

/// What is set together: a line for each.
const CASES: &[&[Setting]] = &[&[N]];

#[test]
fn what_is_set_is_recovered_and_nothing_else() {
    let records = Records::new(COUNT, DT);
    for settings in CASES {
        let mut parameters = TriadParameters::default();
        let mut squares = [0.0; TERMS];
        for (term, set, value) in *settings {
            set(&mut parameters, *value);
            squares[*term as usize] = value * value;
        }
        for (axis, increments) in AXES.iter().zip(&measured(&parameters)) {
            let found = records.analyse(increments);
            for (term, square) in squares.into_iter().enumerate() {
                let (letter, usual) = (Term::ALL[term].letter(), found.interval(term, 0.95));
                let [put_in, recovered, low, high] =
                    [square, found.fit.squares[term], usual.low, usual.high].map(f64::sqrt);
                println!(
                    "{axis}: {letter} {put_in:.4e} set, {recovered:.4e} ({low:.4e} to {high:.4e}) recovered"
                );
                assert!(found.interval(term, CERTAIN).contains(square), "{axis} {letter}");
                assert!(square == 0.0 || usual.low > 0.0, "{axis} {letter} is not resolved");
            }
        }
    }
}

/// A Gauss-Markov bias is none of the five terms: its deviations are compared with their closed form, on white noise.
#[test]
fn a_gauss_markov_bias_has_its_curve() {
    let (n, sigma, time_s) = (1.5e-6, 1e-6, 20.0);
    let parameters = TriadParameters {
        random_walk: Vector3::repeat(n),
        markov_sigma: Vector3::repeat(sigma),
        markov_time_s: Vector3::repeat(time_s),
        ..Default::default()
    };
    // IEEE Std 952-1997, C.17, with the density q_c² = 2 σ² / T.
    let variance = |tau_s: f64| {
        let a = tau_s / time_s;
        let markov =
            2.0 * sigma * sigma / a * (1.0 - (3.0 - 4.0 * (-a).exp() + (-2.0 * a).exp()) / (2.0 * a));
        n * n / tau_s + markov
    };
    // Covariance of the integrals: minus half the variance of what they change.
    let covariance = |t_s: f64| {
        let a = t_s.abs() / time_s;
        Term::RandomWalk.covariance(t_s) * n * n - (sigma * time_s).powi(2) * (a + (-a).exp_m1())
    };
    let records = Records::new(COUNT, DT);
    let degrees = |factor: usize| {
        let pair = Pair { count: COUNT, a: factor, b: factor };
        let c = |samples: f64| of_differences(&pair, DT, samples, covariance);
        let sum: f64 = pair.lags().iter().map(|lag| lag.weight * c(lag.samples).powi(2)).sum();
        let starts = pair.starts().0 as f64;
        2.0 * variance(factor as f64 * DT).powi(2) / (sum / (2.0 * starts * starts))
    };
    let degrees: Vec<f64> = records.factors.iter().map(|factor| degrees(*factor)).collect();
    // The bias makes most of the deviation where it is highest.
    assert!(variance(2.0 * time_s) > 4.0 * n * n / (2.0 * time_s));
    for (axis, increments) in AXES.iter().zip(&measured(&parameters)) {
        for ((tau_s, found), degrees) in
            records.taus_s.iter().zip(records.variances(increments)).zip(&degrees)
        {
            let interval = of_variance(found, *degrees, CERTAIN);
            let ratio = (found / variance(*tau_s)).sqrt();
            println!("{axis}: {tau_s:.2} s, {ratio:.4} of the closed form, {degrees:.0} degrees of freedom");
            assert!(interval.contains(variance(*tau_s)), "{axis} at {tau_s} s: {ratio}");
        }
    }
}
