//! The estimator recovers the noise parameters of a simulator at rest from the Allan variances of its measured signals, on all
//! six axes.

use nalgebra::Vector3;
use sins::earth::Geodetic;
use sins::math::Euler;
use sins::sensors::{Grade, StreamKey, TriadParameters};
use sins::truth::FlightSample;
use sins::{Options, Simulator};
use sins_allan::{Estimator, Point, TERMS, Term};

const DT: f64 = 0.01;
const COUNT: usize = if cfg!(feature = "long-tests") { 24 * 360_000 } else { 360_000 };

/// Confidence of an interval that the true value leaves by chance once in ten thousand times.
const CERTAIN: f64 = 0.9999;

const AXES: [&str; 6] =
    ["gyro x", "gyro y", "gyro z", "accelerometer x", "accelerometer y", "accelerometer z"];

/// Angles and velocities that sensors with these parameters measure over intervals at rest, gyros before accelerometers.
fn measured(gyro: &TriadParameters, accel: &TriadParameters) -> [Vec<f64>; 6] {
    measured_with(gyro, accel, Options::default())
}

fn measured_with(gyro: &TriadParameters, accel: &TriadParameters, mut options: Options) -> [Vec<f64>; 6] {
    options.intake.period_s = Some(DT);
    let mut simulator = Simulator::new(&options).unwrap();
    simulator.set_gyro(gyro).unwrap();
    simulator.set_accel(accel).unwrap();
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

/// Squares of Q, N, B, K, R of the three axes.
fn squares(triad: &TriadParameters) -> [[f64; TERMS]; 3] {
    std::array::from_fn(|axis| {
        let [q, n, b, k, r] =
            [triad.quantization, triad.random_walk, triad.flicker, triad.rate_random_walk, triad.ramp]
                .map(|coefficients| coefficients[axis]);
        // The error of a rounded integral is uniform over a pulse.
        [q * q / 12.0, n * n, b * b, k * k, r * r]
    })
}

/// Asserts that each coefficient that was set is in its interval, and is significantly above zero if `resolved`.
fn recovers(
    name: &str,
    estimator: &Estimator,
    gyro: &TriadParameters,
    accel: &TriadParameters,
    resolved: bool,
) {
    let put_in = [squares(gyro), squares(accel)].concat();
    for ((axis, increments), put_in) in AXES.iter().zip(&measured(gyro, accel)).zip(&put_in) {
        if *put_in == [0.0; TERMS] {
            // Only rounding: a hundred operations on increments of 9.8 m/s² times the step.
            let deviation = estimator.variances(increments).unwrap()[0].sqrt();
            println!("{name}, {axis}: nothing set, {deviation:.1e}");
            assert!(deviation < 100.0 * f64::EPSILON * 9.8, "{name}, {axis}: {deviation}");
            continue;
        }
        let found = estimator.estimate(increments).unwrap();
        for ((term, square), recovered) in Term::ALL.into_iter().zip(*put_in).zip(found.fit.squares) {
            let (letter, usual) = (term.letter(), found.interval(term, 0.95));
            let [set, recovered, low, high] = [square, recovered, usual.low, usual.high].map(f64::sqrt);
            println!(
                "{name}, {axis}: {letter} {set:.4e} set, {recovered:.4e} ({low:.4e} to {high:.4e}) recovered"
            );
            assert!(found.interval(term, CERTAIN).contains(square), "{name}, {axis}: {letter}");
            assert!(!resolved || square == 0.0 || usual.low > 0.0, "{name}, {axis}: {letter} not resolved");
        }
    }
}

#[test]
fn each_random_effect_is_recovered_and_nothing_else() {
    let estimator = Estimator::new(COUNT, DT).unwrap();
    let each = Vector3::repeat;
    let noise = TriadParameters { random_walk: each(1.5e-6), ..Default::default() };
    // The noise moves the integral by 1.5 pulses in a step: the rounding error is uniform within exp(-2π² 1.5²) and white.
    let quantized = TriadParameters { quantization: each(1e-7), ..noise };
    // Below 1 s, the end of its band, flicker lacks up to 0.44 B² of the variance. With this N it is 0.2 % of the whole at
    // 0.1 s; the estimate there is uncertain by 0.8 % in an hour and 0.2 % in a day.
    let flicker = TriadParameters { random_walk: each(5e-6), flicker: each(1e-6), ..Default::default() };
    let walking = TriadParameters { rate_random_walk: each(1e-7), ..noise };
    let ramping = TriadParameters { ramp: each(4e-9), ..noise };
    let all =
        TriadParameters { quantization: each(1e-7), rate_random_walk: each(3e-7), ramp: each(1e-7), ..noise };
    for (name, triad) in
        [("N", noise), ("Q", quantized), ("B", flicker), ("K", walking), ("R", ramping), ("all but B", all)]
    {
        recovers(name, &estimator, &triad, &triad, true);
    }
}

/// Without white noise that hides it, the upper end of the library's flicker noise is seen, and is no quantization.
#[test]
fn flicker_noise_over_little_white_noise_is_recovered() {
    let estimator = Estimator::new(COUNT, DT).unwrap();
    let each = Vector3::repeat;
    // 0.1 deg/sqrt(h) and 10 deg/h.
    let (n, b) = (2.9e-5, 4.85e-5);
    let gyro = TriadParameters { random_walk: each(n), flicker: each(b), ..Default::default() };
    for seed in 1..=3 {
        let options = Options { key: StreamKey { seed, run: 0 }, ..Options::default() };
        for (axis, increments) in measured_with(&gyro, &gyro, options).iter().enumerate() {
            let found = estimator.estimate(increments).unwrap();
            let wide = |term| found.interval(term, CERTAIN);
            println!("seed {seed}, {}: {:?} from {}", AXES[axis], found.fit.band, found.fit.first);
            assert!(
                found.is_explained && wide(Term::Quantization).contains(0.0),
                "seed {seed}, {}",
                AXES[axis]
            );
            for (term, truth) in [(Term::RandomWalk, n), (Term::Flicker, b)] {
                assert!(wide(term).contains(truth * truth), "seed {seed}, {}: {:?}", AXES[axis], term);
            }
        }
    }
}

#[test]
fn each_preset_is_recovered() {
    let estimator = Estimator::new(COUNT, DT).unwrap();
    for grade in [
        Grade::Strategic,
        Grade::Navigation,
        Grade::Tactical,
        Grade::Industrial,
        Grade::Consumer,
        Grade::PaperSimulation2,
    ] {
        let (gyro, accel) = grade.parameters();
        recovers(&format!("{grade:?}"), &estimator, &gyro, &accel, false);
    }
}

/// A Gauss-Markov bias is not one of the five terms: its deviations are compared with their closed form, on white noise.
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
    // Covariance of the integrals: minus half the variance of their change.
    let covariance = |t_s: f64| {
        let a = t_s.abs() / time_s;
        Term::RandomWalk.covariance(t_s) * n * n - (sigma * time_s).powi(2) * (a + (-a).exp_m1())
    };
    let estimator = Estimator::new(COUNT, DT).unwrap();
    let degrees: Vec<f64> = (estimator.taus_s().iter().enumerate())
        .map(|(i, tau_s)| estimator.degrees_of_freedom(i, variance(*tau_s), covariance))
        .collect();
    // The bias makes most of the deviation where it is highest.
    assert!(variance(2.0 * time_s) > 4.0 * n * n / (2.0 * time_s));
    for (axis, increments) in AXES.iter().zip(&measured(&parameters, &parameters)) {
        let variances = estimator.variances(increments).unwrap();
        for ((&tau_s, found), &degrees) in estimator.taus_s().iter().zip(variances).zip(&degrees) {
            let interval = Point { tau_s, variance: found, degrees }.interval(CERTAIN);
            let ratio = (found / variance(tau_s)).sqrt();
            println!("{axis}: {tau_s:.2} s, {ratio:.4} of the closed form, {degrees:.0} degrees of freedom");
            assert!(interval.contains(variance(tau_s)), "{axis} at {tau_s} s: {ratio}");
        }
    }
}
