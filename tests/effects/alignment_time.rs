//! An alignment that takes time: tilt and heading have the variance of the mean errors of this time, and the flight begins with the
//! states with which the alignment ended.

use std::f64::consts::PI;
use std::time::Instant;

use nalgebra::{SMatrix, SVector, Vector3};
use sins::earth::{Earth, Geodetic};
use sins::ensemble::Ensemble;
use sins::math::Euler;
use sins::sensors::{
    Alignment, GravityDisturbanceParameters, GravityField, InitialErrorParameters, StreamKey, TriadParameters,
};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorSource, Options, Simulator};

use crate::support::{DEG, DEG_PER_HOUR, EARTH_RATE, G, moments};

/// The standard deviation of this number of runs scatters by 0.8 %.
const RUNS: usize = 8000;
/// Correlation time and standard deviation, at B = 1, of the processes of flicker.
const FLICKER_S: [f64; 6] = [1.0, 10.0, 100.0, 1e3, 1e4, 1e5];

fn aligned(alignment_s: f64) -> InitialErrorParameters {
    InitialErrorParameters { alignment: Alignment::LevelAndGyrocompass, alignment_s, ..Default::default() }
}

fn at_rest(latitude_deg: f64, time_s: f64) -> FlightSample {
    let place = Geodetic { latitude_rad: latitude_deg * DEG, longitude_rad: 0.3, height_m: 0.0 };
    FlightSample::at_rest(time_s, place, Euler::default())
}

fn simulator(
    gyro: &TriadParameters,
    accel: &TriadParameters,
    initial: &InitialErrorParameters,
    key: StreamKey,
    period_s: f64,
) -> Simulator {
    let intake = IntakeLimits { period_s: Some(period_s), ..IntakeLimits::default() };
    let options = Options { covariance: true, key, intake, ..Options::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    simulator.set_gyro(gyro).unwrap();
    simulator.set_accel(accel).unwrap();
    simulator.set_initial_errors(initial).unwrap();
    simulator
}

/// Variance of the mean over `t` of a stationary Gauss-Markov process of unit variance and correlation time `tau`.
fn markov_mean(t: f64, tau: f64) -> f64 {
    let a = t / tau;
    2.0 / (a * a) * (a + (-a).exp_m1())
}

/// An effect of unit size, and the variance of its mean over `t`.
type Case = (&'static str, fn(f64) -> TriadParameters, fn(f64) -> f64);

fn each(value: f64) -> Vector3<f64> {
    Vector3::repeat(value)
}

const CASES: [Case; 6] = [
    ("turn-on bias", |u| TriadParameters { bias_sigma: each(u), ..Default::default() }, |_| 1.0),
    ("white noise", |u| TriadParameters { random_walk: each(10.0 * u), ..Default::default() }, |t| 100.0 / t),
    (
        "Gauss-Markov, 100 s",
        |u| TriadParameters { markov_sigma: each(u), markov_time_s: each(100.0), ..Default::default() },
        |t| markov_mean(t, 100.0),
    ),
    (
        "flicker",
        |u| TriadParameters { flicker: each(u), ..Default::default() },
        |t| {
            let variance = |k: usize| if k == 0 || k == 5 { 1.25 } else { 1.0 } * 10f64.ln() / PI;
            (0..6).map(|k| variance(k) * markov_mean(t, FLICKER_S[k])).sum()
        },
    ),
    (
        "rate random walk",
        |u| TriadParameters { rate_random_walk: each(0.1 * u), ..Default::default() },
        |t| 0.01 * t / 3.0,
    ),
    (
        "together",
        |u| TriadParameters {
            bias_sigma: each(u),
            random_walk: each(10.0 * u),
            markov_sigma: each(u),
            markov_time_s: each(100.0),
            rate_random_walk: each(0.1 * u),
            ..Default::default()
        },
        |t| 1.0 + 100.0 / t + markov_mean(t, 100.0) + 0.01 * t / 3.0,
    ),
];

/// Tilt about east and north, and heading, 1 sigma, of many runs and of the covariance, against the closed form
/// φ = (-nabla_n/g, nabla_e/g, tan L nabla_e/g - eps_e/(W cos L)) of the mean errors.
#[test]
fn tilt_and_heading_have_the_sigma_of_the_mean_errors() {
    let earth = Earth::default();
    let mut all = (f64::MAX, 0.0f64, 0.0f64);
    for (name, triad, variance) in CASES {
        let (mut least, mut most, mut off) = (f64::MAX, 0.0f64, 0.0f64);
        for latitude_deg in [0.0, 40.0, 75.0] {
            let sample = at_rest(latitude_deg, 0.0);
            let g = earth.gravity(&earth.to_earth_fixed(&sample.place)).norm();
            let (sin, cos) = sample.place.latitude_rad.sin_cos();
            for t in [60.0, 300.0, 600.0, 1800.0] {
                let (eps, nabla) = (1e-3 * DEG_PER_HOUR, 1e-6 * G);
                let key = StreamKey { seed: 5, run: 0 };
                let mut simulator = simulator(&triad(eps), &triad(nabla), &aligned(t), key, 1.0);
                let mut ensemble = Ensemble::new(&simulator, 0, RUNS).unwrap();
                ensemble.push_sample(&sample).unwrap();
                let mut squares = Vector3::zeros();
                for run in 0..RUNS as u64 {
                    let errors = ensemble.errors(run, ErrorSource::Navigation).unwrap().unwrap().1;
                    squares += errors.misalignment_n.component_mul(&errors.misalignment_n) / RUNS as f64;
                }
                let mean = variance(t).sqrt();
                let tilt = mean * nabla / g;
                let heading = (sin / cos * tilt).hypot(mean * eps / (earth.rate_rad_s * cos));
                let theory = Vector3::new(tilt, tilt, heading);
                simulator.push_sample(&sample).unwrap();
                let covariance = simulator.covariance().unwrap().unwrap().1.sigma();
                for axis in 0..3 {
                    let ratio = squares[axis].sqrt() / theory[axis];
                    (least, most) = (least.min(ratio), most.max(ratio));
                    off = off.max((covariance[6 + axis] / theory[axis] - 1.0).abs());
                }
            }
        }
        println!("{name}: runs {least:.4} to {most:.4} of theory, covariance off by {off:.1e}");
        assert!(least > 0.97 && most < 1.03, "{name}: {least} to {most}");
        // The sigma is that of the linear law; gravity leans by 1e-10 at height 0.
        assert!(off < 1e-6, "{name}: the covariance is off by {off:e}");
        all = (all.0.min(least), all.1.max(most), all.2.max(off));
    }
    println!("figure: {:.3} to {:.3}; {:.1e}", all.0, all.1, all.2);
}

/// The paper's gyro at 40° north for 10 minutes: 1.06 mrad of the random walk, and 0.87 mrad of a bias of that size.
#[test]
fn the_papers_gyro_ends_an_alignment_with_its_random_walk() {
    let (walk, bias) = (0.005 * DEG / 60.0, 0.01 * DEG_PER_HOUR);
    let heading = |gyro: TriadParameters, t: f64| {
        let mut simulator = simulator(&gyro, &Default::default(), &aligned(t), StreamKey::default(), 1.0);
        simulator.push_sample(&at_rest(40.0, 0.0)).unwrap();
        simulator.covariance().unwrap().unwrap().1.sigma()[8]
    };
    let of_walk = TriadParameters { random_walk: each(walk), ..Default::default() };
    let of_bias = TriadParameters { bias_sigma: each(bias), ..Default::default() };
    let found = [heading(of_walk, 600.0), heading(of_bias, 600.0), heading(of_walk, 0.0)];
    println!(
        "random walk {:.3} mrad, bias {:.3} mrad, without end {:.3} mrad",
        found[0] * 1e3,
        found[1] * 1e3,
        found[2]
    );
    assert!((found[0] - 1.06e-3).abs() < 5e-6 && (found[1] - 0.87e-3).abs() < 5e-6 && found[2] == 0.0);
}

/// A ramp has half of its end in the mean, and flies on from its end; quantization leaves at most half a pulse over the time.
#[test]
fn ramps_and_pulses_follow_their_closed_forms() {
    let earth = Earth::default();
    let north = earth.rate_rad_s * (40.0 * DEG).cos();
    let slope = 1e-5 * DEG_PER_HOUR;
    let heading = |gyro: &TriadParameters, t: f64| {
        let key = StreamKey::default();
        let mut simulator = simulator(gyro, &Default::default(), &aligned(t), key, 1.0);
        for k in 0..2 {
            simulator.push_sample(&at_rest(40.0, f64::from(k))).unwrap();
        }
        let start = simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.misalignment_n.z;
        simulator.step().unwrap();
        let imu = simulator.imu().unwrap();
        (start, imu.measured.angle - imu.ideal.angle)
    };
    for t in [1.0, 600.0, 86_400.0] {
        let ramp = TriadParameters { ramp: Vector3::new(slope, 0.0, 0.0), ..Default::default() };
        let (start, flown) = heading(&ramp, t);
        let mean = 0.5 * slope * t;
        let expected = -(mean / north).atan();
        assert!((start - expected).abs() < 4.0 * f64::EPSILON, "{t} s: {start} {expected}");
        let first = slope * (t + 0.5);
        assert!(
            (flown.x - first).abs() < 1e-12 * first + 4.0 * f64::EPSILON * earth.rate_rad_s,
            "{t}: {flown}"
        );

        let pulse = 1e-6;
        let pulses = TriadParameters { quantization: each(pulse), ..Default::default() };
        let (start, flown) = heading(&pulses, t);
        // The mean of east has lost nothing, as there is no rate about east; north has lost the remainder of N pulses.
        assert!(start.abs() < 1e-12, "{start}");
        let sum = earth.rate_rad_s * (40.0 * DEG).cos() * t;
        let rest = sum - (sum / pulse).round() * pulse;
        let next = rest + north - ((rest + north) / pulse).round() * pulse;
        assert!((flown.y - (rest - next)).abs() < 1e-15 + 4.0 * f64::EPSILON * sum, "{t} s: {flown}");
    }
}

/// Correlation of the mean rate error that the alignment absorbed, which its heading error shows, with the mean of the flight's first
/// hour, against theory: τ²(1-e^-T/τ)(1-e^-H/τ)/(T H) over the two standard deviations.
#[test]
fn the_flight_continues_with_the_states_of_the_alignment() {
    let (t, hour, step_s) = (600.0, 3600.0, 100.0);
    let sigma = 1e-3 * DEG_PER_HOUR;
    for tau in [10.0, 100.0, 1e3, 1e4, 36e3] {
        let gyro =
            TriadParameters { markov_sigma: each(sigma), markov_time_s: each(tau), ..Default::default() };
        let options = Options {
            key: StreamKey { seed: 3, run: 0 },
            intake: IntakeLimits { max_gap_s: 200.0, period_s: Some(step_s), ..IntakeLimits::default() },
            ..Options::default()
        };
        let mut template = Simulator::new(&options).unwrap();
        template.set_gyro(&gyro).unwrap();
        template.set_initial_errors(&aligned(t)).unwrap();
        let mut ensemble = Ensemble::new(&template, 0, RUNS).unwrap();
        ensemble.push_sample(&at_rest(0.0, 0.0)).unwrap();
        let absorbed: Vec<f64> = (0..RUNS as u64)
            .map(|run| -ensemble.errors(run, ErrorSource::Navigation).unwrap().unwrap().1.misalignment_n.z)
            .collect();
        let mut flown = vec![0.0; RUNS];
        for k in 1..=(hour / step_s) as u32 {
            ensemble.push_sample(&at_rest(0.0, f64::from(k) * step_s)).unwrap();
            ensemble.step().unwrap();
            for (run, flown) in flown.iter_mut().enumerate() {
                let imu = ensemble.imu(run as u64).unwrap().unwrap();
                *flown += imu.measured.angle.x - imu.ideal.angle.x;
            }
        }
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let found =
            product(&absorbed, &flown) / (product(&absorbed, &absorbed) * product(&flown, &flown)).sqrt();
        let decayed = |t: f64| -(-t / tau).exp_m1() * tau / t;
        let theory = decayed(t) * decayed(hour) / (markov_mean(t, tau) * markov_mean(hour, tau)).sqrt();
        // Five standard deviations of a correlation of this number of pairs.
        let bound = 5.0 * (1.0 - theory * theory) / (RUNS as f64).sqrt();
        println!("{tau} s: correlation {found:.4}, theory {theory:.4}, bound {bound:.4}");
        assert!((found - theory).abs() < bound, "{tau} s: {found} {theory}");
    }
}

/// Every effect: a run of an ensemble has the bits of the single simulator, with disturbed gravity too; a read before the first step
/// and a rejected first interval change nothing; a snapshot of the start goes on to the same bits.
#[test]
fn runs_reads_and_snapshots_have_the_same_bits() {
    let (gyro, accel) = moments::every_effect();
    let samples: Vec<FlightSample> = moments::samples(12, 0.01).collect();
    let template = |run: u64| {
        let key = StreamKey { seed: 9, run };
        simulator(
            &gyro,
            &accel,
            &InitialErrorParameters { alignment_s: 300.0, ..moments::initial() },
            key,
            0.01,
        )
    };
    let ensemble_of = |gravity: bool| {
        let mut template = template(0);
        if gravity {
            template.set_gravity_disturbance(&gravity_disturbance()).unwrap();
        }
        let mut ensemble = Ensemble::new(&template, 0, 19).unwrap();
        for sample in &samples {
            ensemble.push_sample(sample).unwrap();
            ensemble.errors(3, ErrorSource::Navigation).unwrap();
            ensemble.step().unwrap();
        }
        ensemble
    };
    for gravity in [false, true] {
        let ensemble = ensemble_of(gravity);
        for run in [0, 3, 18] {
            let fly = |reads: bool, from_snapshot: bool| {
                let mut simulator = template(run);
                if gravity {
                    simulator.set_gravity_disturbance(&gravity_disturbance()).unwrap();
                }
                simulator.push_sample(&samples[0]).unwrap();
                if reads {
                    simulator.covariance().unwrap();
                    simulator.errors(ErrorSource::Navigation).unwrap();
                }
                for sample in &samples[1..] {
                    simulator.push_sample(sample).unwrap();
                    if from_snapshot {
                        let bytes = moments::snapshot(&simulator);
                        let mut loaded = template(run + 1);
                        loaded.load_snapshot(&bytes).unwrap();
                        simulator = loaded;
                    }
                    simulator.step().unwrap();
                }
                (
                    simulator.errors(ErrorSource::Navigation).unwrap(),
                    simulator.covariance().unwrap().unwrap().1,
                )
            };
            let alone = fly(false, false);
            assert_eq!(alone, fly(true, false));
            assert_eq!(alone, fly(true, true));
            assert_eq!(
                ensemble.errors(run, ErrorSource::Navigation).unwrap(),
                alone.0,
                "run {run}, {gravity}"
            );
        }
    }
}

fn gravity_disturbance() -> GravityDisturbanceParameters {
    let field = GravityField { mean: 2e-5, sigma: 5e-5, distance_m: 300.0 };
    GravityDisturbanceParameters { deflection_north: field, deflection_east: field, anomaly: field }
}

/// Standard deviations of tilt and heading after `t` at 40° of a Kalman filter that observes the velocity of rest: 7 states, the
/// misalignment, the horizontal velocity error and the horizontal gyro biases of `bias` 1 sigma. White noise of `walk` and of
/// `noise`; measurements of 1 µm/s at each step of 1 s; unknown attitude at the start.
fn filtered(walk: f64, noise: f64, bias: f64, t: u32) -> SVector<f64, 3> {
    let (sin, cos) = (40.0 * DEG).sin_cos();
    let (north, up) = (EARTH_RATE * cos, EARTH_RATE * sin);
    // φ' = -W×φ - eps, δv' = f×φ with f = g up (east: -g φ_n, north: g φ_e).
    let mut rate = SMatrix::<f64, 7, 7>::zeros();
    rate.fixed_view_mut::<3, 3>(0, 0).copy_from(&-Vector3::new(0.0, north, up).cross_matrix());
    (rate[(3, 1)], rate[(4, 0)]) = (-G, G);
    (rate[(0, 5)], rate[(1, 6)]) = (-1.0, -1.0);
    let identity = SMatrix::<f64, 7, 7>::identity();
    let transition = identity + rate + rate * rate * 0.5 + rate * rate * rate / 6.0;
    let mut density = SMatrix::<f64, 7, 7>::zeros();
    (0..3).for_each(|k| density[(k, k)] = walk * walk);
    (3..5).for_each(|k| density[(k, k)] = noise * noise);
    // Simpson's rule of the noise over a step.
    let half = identity + rate * 0.5 + rate * rate * 0.125;
    let added =
        (density + half * density * half.transpose() * 4.0 + transition * density * transition.transpose())
            / 6.0;
    let variances = [1.0, 1.0, 1.0, 1e-12, 1e-12, bias * bias, bias * bias];
    let mut p = SMatrix::<f64, 7, 7>::from_diagonal(&SVector::from(variances));
    for _ in 0..t {
        p = transition * p * transition.transpose() + added;
        for row in [3, 4] {
            let gain = p.column(row) / (p[(row, row)] + 1e-12);
            p -= gain * p.row(row);
            p = (p + p.transpose()) * 0.5;
        }
    }
    SVector::from([0, 1, 2].map(|k| p[(k, k)].sqrt()))
}

/// Averages against that filter, which is no better: the angles at both ends of the time are all that white noise of the rate leaves
/// to know of its mean, and a constant bias cannot be told from a heading. Of the time the filter loses 2 s, in which it finds
/// the tilt from velocities; its present heading has the random walk of the gyros about up, N²T/3.
#[test]
fn averages_are_as_good_as_a_kalman_filter() {
    let north = EARTH_RATE * (40.0 * DEG).cos();
    let (walk, noise) = (0.005 * DEG / 60.0, 1e-6 * G);
    let (mut least, mut most) = (f64::MAX, 0.0f64);
    for bias in [0.0, 0.01 * DEG_PER_HOUR] {
        for t in [60, 300, 600, 1800] {
            let averages = (walk / f64::from(t).sqrt()).hypot(bias) / north;
            let filter = filtered(walk, noise, bias, t);
            let ratio = filter[2] / averages;
            println!(
                "{t} s: averages {:.3} mrad, filter {:.3} mrad: {ratio:.4}",
                averages * 1e3,
                filter[2] * 1e3
            );
            let t = f64::from(t);
            let bound = (t / (t - 2.0) * (1.0 + (north * t).powi(2) / 3.0)).sqrt();
            assert!(ratio > 1.0 - 1e-4 && ratio < bound, "{t} s: {ratio}, bound {bound}");
            (least, most) = (least.min(ratio), most.max(ratio));
        }
    }
    println!("figure: {least:.4} to {most:.4} of the averages'");
}

/// The first step with an alignment costs at most 3 ms, and a run of an ensemble at most a fifth of it.
#[test]
fn an_alignment_costs_less_than_a_millisecond() {
    let (gyro, accel) = moments::every_effect();
    let samples: Vec<FlightSample> = moments::samples(2, 0.01).collect();
    let initial = |alignment_s| InitialErrorParameters { alignment_s, ..moments::initial() };
    let least = |make: &dyn Fn() -> f64| (0..20).map(|_| make()).fold(f64::MAX, f64::min);
    let first_step = |alignment_s: f64| {
        least(&|| {
            let mut simulator = simulator(&gyro, &accel, &initial(alignment_s), StreamKey::default(), 0.01);
            for sample in &samples {
                simulator.push_sample(sample).unwrap();
            }
            let before = Instant::now();
            simulator.step().unwrap();
            before.elapsed().as_secs_f64()
        })
    };
    let of_run = |alignment_s: f64| {
        least(&|| {
            let template = simulator(&gyro, &accel, &initial(alignment_s), StreamKey::default(), 0.01);
            let mut ensemble = Ensemble::new(&template, 0, 160).unwrap();
            for sample in &samples {
                ensemble.push_sample(sample).unwrap();
            }
            let before = Instant::now();
            ensemble.step().unwrap();
            before.elapsed().as_secs_f64() / 160.0
        })
    };
    let (alone, run) = (first_step(600.0), of_run(600.0));
    println!(
        "first step {:.1} us, with an endless alignment {:.1} us; a run of an ensemble {:.1} us, {:.1} us",
        alone * 1e6,
        first_step(0.0) * 1e6,
        run * 1e6,
        of_run(0.0) * 1e6
    );
    assert!(alone < 3e-3 && run < 0.6e-3, "{alone} s, {run} s");
}

/// In a second gyros of 0.15 °/√h find a mean rate with 9 °/h, and the horizontal error exceeds the Earth rate's north part as often as
/// Rayleigh's distribution says; in a minute it never does.
#[test]
fn a_time_too_short_for_north_is_flagged() {
    let (walk, runs) = (0.15 * DEG / 60.0, 2000);
    let gyro = TriadParameters { random_walk: each(walk), ..Default::default() };
    for t in [1.0, 60.0] {
        let template = simulator(&gyro, &Default::default(), &aligned(t), StreamKey::default(), 1.0);
        let mut ensemble = Ensemble::new(&template, 0, runs).unwrap();
        ensemble.push_sample(&at_rest(40.0, 0.0)).unwrap();
        let is_unknown = |run: u64| ensemble.navigation(run).unwrap().unwrap().north_unknown;
        let found = (0..runs as u64).filter(|&run| is_unknown(run)).count() as f64 / runs as f64;
        let sigmas = EARTH_RATE * (40.0 * DEG).cos() / (walk / f64::sqrt(t));
        let expected = (-0.5 * sigmas * sigmas).exp();
        let bound = 5.0 * (expected * (1.0 - expected) / runs as f64).sqrt() + 1e-9;
        assert!((found - expected).abs() < bound, "{t} s: {found}, expected {expected}");
    }
}

/// Levelling alone: the tilt is that of the accelerometers, the heading is true whatever the gyros, also at a pole, and a drawn heading
/// error is all that the covariance of the heading has.
#[test]
fn levelling_alone_leaves_the_heading_as_it_is() {
    let gyro = TriadParameters { bias: each(1.0), random_walk: each(1e-3), ..Default::default() };
    let accel = TriadParameters { bias_sigma: each(1e-3 * G), ..Default::default() };
    let heading = 2.0 * DEG;
    let level =
        InitialErrorParameters { alignment: Alignment::Level, alignment_s: 30.0, ..Default::default() };
    let drawn = InitialErrorParameters { misalignment_sigma_n: Vector3::new(0.0, 0.0, heading), ..level };
    for latitude_deg in [-89.0, 0.0, 75.0, 90.0] {
        let sample = at_rest(latitude_deg, 0.0);
        let g = Earth::default().gravity(&Earth::default().to_earth_fixed(&sample.place)).norm();
        let start = |initial: &InitialErrorParameters| {
            let mut simulator = simulator(&gyro, &accel, initial, StreamKey::default(), 1.0);
            simulator.push_sample(&sample).unwrap();
            let errors = simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.misalignment_n;
            (errors, simulator.covariance().unwrap().unwrap().1.sigma(), simulator)
        };
        let (errors, sigma, simulator) = start(&level);
        let tilt = errors.xy().norm();
        assert!(tilt > 1e-5 && errors.z.abs() < tilt * tilt, "{latitude_deg}°: {errors}");
        assert!(!simulator.navigation().unwrap().unwrap().north_unknown);
        // The covariance is linear; gravity leans by 1e-10 at height 0.
        assert!(
            (sigma[6] * g / (1e-3 * G) - 1.0).abs() < 1e-6 && sigma[8] < 1e-9,
            "{latitude_deg}°: {sigma:?}"
        );
        let sigma = start(&drawn).1;
        assert!((sigma[8] / heading - 1.0).abs() < 1e-6, "{latitude_deg}°: {sigma:?}");
    }
}
