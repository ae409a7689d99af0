//! The covariance of the navigation errors: at rest against a matrix exponential of the textbook's equations, and against single
//! runs where one draw is all that is random.

use nalgebra::{SMatrix, Vector3};
use sins::earth::Earth;
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorParameters, ErrorSource, Options, Simulator};

use crate::support::{self, DEG, DEG_PER_HOUR, G, resting_sample};

const MICRO_G: f64 = 1e-6 * G;
const LATITUDE: f64 = 39.9 * DEG;

/// φ east, north, up; δv east, north; δr east, north; then the six inputs, which are constant: eps east, north, up, nabla east,
/// north, and one spare.
type System = SMatrix<f64, 13, 13>;

/// The error equations at rest at height 0, level and heading north (Titterton and Weston 2004, §12.3), by themselves.
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

/// Flies at rest and gives sigmas of φ, δv and δr, horizontal, at each hour.
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

/// A stretch of the propagation is a second, in which the Earth turns by 7.3e-5 rad: what one may lose.
const MODEL: f64 = 7.3e-5;

fn agree(found: &[[f64; 7]], variance: impl Fn(f64) -> [f64; 7]) {
    // Of each quantity the largest on the way: a sigma that swings through 0 has no relative error there.
    let expected: Vec<_> =
        (1..=found.len()).map(|hour| variance(3600.0 * hour as f64).map(f64::sqrt)).collect();
    for k in 0..7 {
        let largest = expected.iter().map(|sigmas| sigmas[k]).fold(0.0, f64::max);
        let apart = found.iter().zip(&expected).map(|(f, e)| (f[k] - e[k]).abs()).fold(0.0, f64::max);
        println!("{k}: {:.2e} of {largest:.4e}", apart / largest);
        assert!(apart <= MODEL * largest, "{k}: {apart:e} of {largest:e}");
    }
}

/// A constant drawn once a run, by the response to 1 sigma.
#[test]
fn turn_on_biases_and_initial_tilt_at_rest_over_a_day() {
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
        agree(&hours_at_rest(&mut simulator, 24), |t| {
            let end = exponential(&f, t) * start;
            core::array::from_fn(|row| end[row] * end[row])
        });
    }
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
    agree(&hours_at_rest(&mut simulator, 24), |t| {
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
}

/// What each of the effects that are drawn once a run does: the error of a run (error data 1, which is linear) over its draw is
/// the sigma. The draw is not asked for: it is one number for all errors at all times. Stretches of a second are told from
/// intervals by (1 s/t)² of what came in the first t = 20 s: 2e-3.
#[test]
fn a_single_draw_is_the_error_of_a_run_over_its_sigma() {
    let mut count = 0;
    let triads: [(bool, TriadParameters); 8] = {
        let mut element = nalgebra::Matrix3::zeros();
        element[(1, 0)] = 2e-5;
        let of = |triad| triad;
        [
            (true, of(TriadParameters { bias_sigma: Vector3::new(0.0, 1e-7, 0.0), ..Default::default() })),
            (false, of(TriadParameters { bias_sigma: Vector3::new(0.0, 0.0, 1e-4), ..Default::default() })),
            (false, of(TriadParameters { bias_sigma: Vector3::new(1e-4, 0.0, 0.0), ..Default::default() })),
            (
                true,
                of(TriadParameters {
                    scale_factor_sigma: Vector3::new(0.0, 0.0, 1e-5),
                    ..Default::default()
                }),
            ),
            (true, of(TriadParameters { misalignment_sigma: element, ..Default::default() })),
            (false, of(TriadParameters { misalignment_sigma: element, ..Default::default() })),
            (
                false,
                of(TriadParameters {
                    scale_factor_sigma: Vector3::new(0.0, 0.0, 1e-5),
                    ..Default::default()
                }),
            ),
            // Very long: as good as constant.
            (
                true,
                of(TriadParameters {
                    markov_sigma: Vector3::new(1e-7, 0.0, 0.0),
                    markov_time_s: Vector3::repeat(1e12),
                    ..Default::default()
                }),
            ),
        ]
    };
    for (name, samples) in &flights() {
        for (is_gyro, triad) in &triads {
            for (vertical, frame) in [
                (VerticalMode::Damped, Frame::EarthFixed),
                (VerticalMode::Free, Frame::Geographic),
                (VerticalMode::FollowTruth, Frame::Geographic),
            ] {
                let period_s = samples[1].time_s;
                let intake = IntakeLimits { period_s: Some(period_s), ..IntakeLimits::default() };
                let options = Options {
                    covariance: true,
                    error_model: true,
                    vertical,
                    frame,
                    intake,
                    ..Options::default()
                };
                let mut simulator = Simulator::new(&options).unwrap();
                if *is_gyro { simulator.set_gyro(triad) } else { simulator.set_accel(triad) }.unwrap();
                let (mut errors, mut sigmas) = (Vec::new(), Vec::new());
                for (k, sample) in samples.iter().enumerate() {
                    simulator.push_sample(sample).unwrap();
                    simulator.step().unwrap();
                    // At moments that are no ends of stretches too.
                    if k > 1000 && k % 997 == 0 {
                        errors.push(nine(&simulator, ErrorSource::Model));
                        sigmas.push(simulator.covariance().unwrap().unwrap().1.sigma());
                    }
                }
                for group in 0..3 {
                    let size =
                        |of: &[f64; 9]| of[3 * group..3 * group + 3].iter().map(|x| x * x).sum::<f64>();
                    let ratios: Vec<f64> =
                        errors.iter().zip(&sigmas).map(|(e, s)| (size(e) / size(s)).sqrt()).collect();
                    let (least, most) =
                        ratios.iter().fold((f64::MAX, 0.0f64), |(l, m), r| (l.min(*r), m.max(*r)));
                    println!("{name} {is_gyro} {vertical:?} {group}: {least:.6} {most:.6}");
                    assert!(most / least - 1.0 < 2e-3, "{name} {vertical:?} {group}: {least} to {most}");
                    count += 1;
                }
            }
        }
    }
    assert_eq!(count, 2 * 8 * 3 * 3);
}

fn flights() -> [(&'static str, Vec<FlightSample>); 2] {
    [
        ("patrol", {
            let flight = support::patrol(2400.0);
            (0..=24_000).map(|k| flight.sample_at(0.1 * f64::from(k)).unwrap()).collect()
        }),
        ("aerobatics", {
            let scene = sins::scene::builtin("aerobatics").unwrap();
            let flight = scene.flight().unwrap();
            let count = (flight.duration_s() * 50.0) as u32;
            (0..=count).map(|k| flight.sample_at(0.02 * f64::from(k)).unwrap()).collect()
        }),
    ]
}

/// An effect by its constant, by its standard deviation, and how large.
struct Effect {
    name: &'static str,
    constant: fn(&mut ErrorParameters) -> &mut f64,
    sigma: fn(&mut ErrorParameters) -> &mut f64,
    size: f64,
}

const EFFECTS: [Effect; 11] = {
    macro_rules! effect {
        ($part:ident . $constant:ident, $sigma:ident $at:tt, $size:expr) => {
            Effect {
                name: concat!(stringify!($part), ".", stringify!($constant), stringify!($at)),
                constant: |errors| &mut errors.$part.$constant$at,
                sigma: |errors| &mut errors.$part.$sigma$at,
                size: $size,
            }
        };
    }
    [
        effect!(gyro.bias, bias_sigma[1], 0.01 * DEG_PER_HOUR),
        effect!(gyro.bias, bias_sigma[2], 0.01 * DEG_PER_HOUR),
        effect!(gyro.scale_factor, scale_factor_sigma[2], 1e-5),
        effect!(gyro.misalignment, misalignment_sigma[(1, 0)], 1e-5),
        effect!(accel.bias, bias_sigma[0], 10.0 * MICRO_G),
        effect!(accel.bias, bias_sigma[2], 10.0 * MICRO_G),
        effect!(accel.scale_factor, scale_factor_sigma[2], 1e-5),
        effect!(accel.misalignment, misalignment_sigma[(1, 2)], 1e-5),
        effect!(initial.position_n, position_sigma_n[1], 10.0),
        effect!(initial.velocity_n, velocity_sigma_n[0], 0.1),
        effect!(initial.misalignment_n, misalignment_sigma_n[2], 1e-4),
    ]
};

/// A draw of one sigma is a given error of this size: half the difference of the navigation of two runs, with it and with its
/// opposite, is the sigma of each of the nine errors. So the covariance is held to the navigation itself, and in absolute size.
#[test]
fn a_sigma_is_half_the_difference_of_two_runs() {
    for (name, samples) in &flights() {
        for Effect { name: effect, constant, sigma, size } in &EFFECTS {
            let set = |of: fn(&mut ErrorParameters) -> &mut f64, size: f64, covariance| {
                let intake = IntakeLimits { period_s: Some(samples[1].time_s), ..IntakeLimits::default() };
                let options = Options { covariance, intake, ..Options::default() };
                let mut simulator = Simulator::new(&options).unwrap();
                let mut errors = ErrorParameters::default();
                *of(&mut errors) = size;
                errors.set_to(&mut simulator).unwrap();
                simulator
            };
            let mut with = set(*constant, *size, false);
            let mut opposite = set(*constant, -size, false);
            let mut random = set(*sigma, *size, true);
            let (mut largest, mut worst) = ([0.0f64; 3], [0.0f64; 3]);
            for (k, sample) in samples.iter().enumerate() {
                for simulator in [&mut with, &mut opposite, &mut random] {
                    simulator.push_sample(sample).unwrap();
                    simulator.step().unwrap();
                }
                if k == 0 || k % 997 != 0 {
                    continue;
                }
                let [a, b] = [&with, &opposite].map(|simulator| nine(simulator, ErrorSource::Navigation));
                let sigmas = random.covariance().unwrap().unwrap().1.sigma();
                for state in 0..9 {
                    let found = 0.5 * (a[state] - b[state]).abs();
                    largest[state / 3] = largest[state / 3].max(found);
                    worst[state / 3] = worst[state / 3].max((found - sigmas[state]).abs());
                }
            }
            let apart: [f64; 3] = core::array::from_fn(|group| worst[group] / largest[group]);
            let [position, velocity, attitude] = apart;
            println!(
                "{name}, {effect}: position {position:.1e}, velocity {velocity:.1e}, attitude {attitude:.1e}"
            );
            assert!(apart.iter().all(|apart| *apart < MODEL), "{name}, {effect}: {apart:?}");
        }
    }
}

fn nine(simulator: &Simulator, source: ErrorSource) -> [f64; 9] {
    let (_, errors) = simulator.errors(source).unwrap().unwrap();
    let mut nine = [0.0; 9];
    nine[..3].copy_from_slice(errors.position_n.as_slice());
    nine[3..6].copy_from_slice(errors.velocity_n.as_slice());
    nine[6..].copy_from_slice(errors.misalignment_n.as_slice());
    nine
}

fn drawn() -> (TriadParameters, InitialErrorParameters) {
    let gyro = TriadParameters {
        bias_sigma: Vector3::repeat(1e-7),
        rate_random_walk: Vector3::repeat(1e-9),
        ..Default::default()
    };
    let initial = InitialErrorParameters {
        position_sigma_n: Vector3::new(3.0, 4.0, 5.0),
        velocity_sigma_n: Vector3::new(0.1, 0.2, 0.3),
        misalignment_sigma_n: Vector3::new(1e-4, 2e-4, 3e-4),
        ..Default::default()
    };
    (gyro, initial)
}

fn patrolling(options: &Options) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    let (gyro, initial) = drawn();
    simulator.set_gyro(&gyro).unwrap();
    simulator.set_initial_errors(&initial).unwrap();
    simulator
}

fn sigma(simulator: &mut Simulator) -> [f64; 9] {
    simulator.covariance().unwrap().unwrap().1.sigma()
}

/// Before the first step it is that of the start; a read changes nothing; other outputs have the same bits with and without it.
#[test]
fn it_begins_as_the_start_and_changes_nothing() {
    let flight = support::patrol(60.0);
    let sample = |k: u32| flight.sample_at(0.01 * f64::from(k)).unwrap();
    let options = Options { error_model: true, ..Options::default() };
    let mut without = patrolling(&options);
    assert_eq!(without.covariance().unwrap_err().kind, sins::ErrorKind::BadState);
    let mut with = patrolling(&Options { covariance: true, ..options });
    let mut unread = patrolling(&Options { covariance: true, ..options });
    assert_eq!(with.covariance().unwrap(), None);
    for k in 0..=1234 {
        for simulator in [&mut with, &mut without, &mut unread] {
            simulator.push_sample(&sample(k)).unwrap();
        }
        if k == 0 {
            let expected = [3.0, 4.0, 5.0, 0.1, 0.2, 0.3, 1e-4, 2e-4, 3e-4];
            for (found, expected) in sigma(&mut with).into_iter().zip(expected) {
                // Rotations to and from Earth-fixed axes, of 1e2 m/s by the lean of 1e-6 rad.
                assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
            }
        }
        for simulator in [&mut with, &mut without, &mut unread] {
            simulator.step().unwrap();
        }
        sigma(&mut with);
    }
    assert_eq!(support::bits(&with), support::bits(&without));
    assert_eq!(with.covariance(), unread.covariance());
    // What is random has a variance, and nothing is negative.
    assert!(sigma(&mut with).iter().all(|sigma| *sigma > 0.0));
}

/// A slew keeps the standard deviations; a reposition starts anew, with walks that go on; a reset takes them back.
#[test]
fn slews_keep_it_and_starts_begin_it_anew() {
    let flight = support::patrol(60.0);
    let options = Options { covariance: true, ..Options::default() };
    let mut simulator = patrolling(&options);
    for k in 0..=2050 {
        simulator.push_sample(&flight.sample_at(0.01 * f64::from(k)).unwrap()).unwrap();
        simulator.step().unwrap();
    }
    let before = sigma(&mut simulator);
    let mut elsewhere = flight.sample_at(20.5).unwrap();
    (elsewhere.place.latitude_rad, elsewhere.place.longitude_rad) = (-0.3, 2.0);
    simulator.move_truth(&elsewhere).unwrap();
    for (before, after) in before.into_iter().zip(sigma(&mut simulator)) {
        assert!((after / before - 1.0).abs() < 1e-9, "{before} {after}");
    }
    simulator.reposition(&elsewhere).unwrap();
    assert!((sigma(&mut simulator)[0] / 3.0 - 1.0).abs() < 1e-12);
    simulator.reset();
    for k in 0..=2050 {
        simulator.push_sample(&flight.sample_at(0.01 * f64::from(k)).unwrap()).unwrap();
        simulator.step().unwrap();
    }
    assert_eq!(sigma(&mut simulator), before);
}
