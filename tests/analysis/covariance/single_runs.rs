//! The covariance against single runs in flight with one random draw.

use nalgebra::Vector3;
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::TriadParameters;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorParameters, ErrorSource, Options, Simulator};

use super::{MICRO_G, MODEL};
use crate::support::{self, DEG_PER_HOUR};

/// For each effect that is drawn once a run, the error of a run (error data 1, which is linear) over its draw is the sigma. The
/// draw itself is not needed: it is one number for all errors at all times. Stretches of a second differ from intervals by
/// (1 s/t)² of the error of the first t = 20 s: 2e-3.
#[test]
fn a_single_draw_is_the_error_of_a_run_over_its_sigma() {
    const LIMIT: f64 = 2e-3;
    let (mut count, mut figures) = (0, Vec::new());
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
            // A very long correlation time: practically constant.
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
        let (mut worst, mut first_s) = (0.0f64, f64::MAX);
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
                    // Also at moments that are not ends of stretches.
                    if k > 1000 && k % 997 == 0 {
                        first_s = first_s.min(sample.time_s);
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
                    assert!(most / least - 1.0 < LIMIT, "{name} {vertical:?} {group}: {least} to {most}");
                    worst = worst.max(most / least - 1.0);
                    count += 1;
                }
            }
        }
        figures.push(format!("{worst:.0e} from {first_s:.0} s of the {name} on"));
    }
    assert_eq!(count, 2 * 8 * 3 * 3);
    println!("figure: {} (limit {LIMIT:.0e})", figures.join(", "));
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

/// An effect with its constant, its standard deviation and its size.
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

/// A draw of one sigma is a given error of this size: half the difference of the navigation of two runs, one with this error, one
/// with its opposite, is the sigma of each of the nine errors. This compares the covariance with the navigation in absolute size.
#[test]
fn a_sigma_is_half_the_difference_of_two_runs() {
    let mut most = 0.0f64;
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
            most = apart.into_iter().fold(most, f64::max);
        }
    }
    println!("figure: fractions up to {most:.1e} (limit {MODEL:.1e})");
}

fn nine(simulator: &Simulator, source: ErrorSource) -> [f64; 9] {
    let (_, errors) = simulator.errors(source).unwrap().unwrap();
    let mut nine = [0.0; 9];
    nine[..3].copy_from_slice(errors.position_n.as_slice());
    nine[3..6].copy_from_slice(errors.velocity_n.as_slice());
    nine[6..].copy_from_slice(errors.misalignment_n.as_slice());
    nine
}
