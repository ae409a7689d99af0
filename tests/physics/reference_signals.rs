//! The generator against exact integrals, and the mechanization on exact increments against exact truth.
//!
//! The references are analytic trajectories, differentiated and integrated in 50-digit arithmetic; see tests/data.

use nalgebra::Vector3;
use sins::earth::state::{BodyAxes, EarthFixedState};
use sins::earth::{Earth, Ellipsoid, GravityModel};
use sins::math::rotation_vector;
use sins::mechanization::{Frame, Mechanization, Scheme, VerticalAid, VerticalMode};
use sins::signal::Increment;
use sins::truth::{FlightSample, IntakeLimits};
use sins::{Options, Simulator};

use crate::support::{self, DEG_PER_HOUR, Reference, Table, state_of};

fn earth() -> Earth {
    Earth::new(Ellipsoid::Wgs84, GravityModel::Somigliana)
}

fn options(period_s: f64) -> Options {
    let intake = IntakeLimits { period_s: Some(period_s), ..Default::default() };
    Options { gravity: GravityModel::Somigliana, vertical: VerticalMode::Free, intake, ..Default::default() }
}

/// Mean angular rate error [°/h] and rms of the specific force error [m/s²] of the generator over half intervals, after
/// the four intervals in which its stencil grows.
fn generator_error(name: &str, host_signals: bool) -> (f64, f64) {
    let reference = Reference::load(name);
    let mut simulator = Simulator::new(&options(reference.period_s)).unwrap();
    let (mut angle, mut force2, mut count) = (Vector3::zeros(), 0.0, 0.0);
    let half = 0.5 * reference.period_s;
    for (k, sample) in reference.truth.samples(host_signals).iter().enumerate() {
        simulator.push_sample(sample).unwrap();
        simulator.step().unwrap();
        if k > 4 {
            let exact = &reference.increments[2 * (k - 1)..2 * k];
            for (made, exact) in simulator.ideal_increments().iter().zip(exact) {
                angle += made.angle - exact.angle;
                force2 += (made.velocity - exact.velocity).norm_squared() / (half * half);
                count += 1.0;
            }
        }
    }
    (angle.norm() / (count * half) / DEG_PER_HOUR, (force2 / count).sqrt())
}

#[test]
fn generator_makes_the_exact_signals_of_the_figure_eight() {
    let (rate, force) = generator_error("fig8", false);
    assert!(rate < 1e-8 && force < 1e-8, "{rate:e} °/h, {force:e} m/s²");
    let (rate, force) = generator_error("fig8", true);
    assert!(rate < 1e-8 && force < 1e-9, "{rate:e} °/h, {force:e} m/s²");
}

/// At the middle of an interval a cubic misses T⁴/384 of the fourth derivative of velocity. As a force over half an interval
/// this is the fourth difference over 192 T.
fn force_error_in_theory(reference: &Reference) -> f64 {
    let v = reference.truth.vectors(["velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"]);
    let fourth = v.windows(5).map(|w| (w[0] + w[4] - (w[1] + w[3]) * 4.0 + w[2] * 6.0).norm_squared());
    (fourth.sum::<f64>() / (v.len() - 4) as f64).sqrt() / (192.0 * reference.period_s)
}

/// Loops and weaves are hard on the velocity alone: the error is that of the theory, to a few percent.
#[test]
fn generator_leaves_what_a_cubic_leaves_on_loops_and_weaves() {
    for name in ["loop", "scurve"] {
        let (rate, force) = generator_error(name, false);
        let theory = force_error_in_theory(&Reference::load(name));
        assert!((force / theory - 1.0).abs() < 0.05, "{name}: {force:e} m/s² of {theory:e}");
        assert!(rate < 1e-8, "{name}: {rate:e} °/h");
    }
}

#[test]
fn generator_passes_the_pole_like_anywhere_else() {
    let (rate, force) = generator_error("polar", false);
    assert!(rate < 1e-8 && force < 1e-9, "{rate:e} °/h, {force:e} m/s²");
    // At rest: the difference between the reference's rounded constants of gravity and the exact ones, 6e-11 m/s².
    let (rate, force) = generator_error("pole_static", false);
    assert!(rate < 1e-9 && force < 1e-10, "{rate:e} °/h, {force:e} m/s²");
}

/// Vibration: 1° of coning at 2 Hz, sampled at 100 Hz. The generator reproduces the given motion; the host's own rate and
/// force improve the result.
#[test]
fn generator_follows_coning_at_a_fiftieth_of_the_sample_rate() {
    let (rate, force) = generator_error("cone1", false);
    assert!(rate < 5e-4 && force < 5e-5, "{rate:e} °/h, {force:e} m/s²");
    let (_, with_host) = generator_error("cone1", true);
    assert!(with_host < 0.7 * force);
}

/// Position, velocity and attitude errors at the end, in east-north-up of the truth.
fn differences(
    computed: &EarthFixedState,
    truth: &FlightSample,
) -> (Vector3<f64>, Vector3<f64>, Vector3<f64>) {
    let exact = state_of(&earth(), truth);
    let (east, north, up) = earth().east_north_up(&truth.place);
    let local = |v: Vector3<f64>| Vector3::new(v.dot(&east), v.dot(&north), v.dot(&up));
    // Earth-fixed attitude error ψ with computed C = (I - [ψ×]) C.
    let psi = -rotation_vector(&(computed.q_eb * exact.q_eb.conjugate()));
    (local(computed.r_e - exact.r_e), local(computed.v_e - exact.v_e), local(psi))
}

/// Errors of horizontal position [m], horizontal velocity [m/s] and attitude [rad] after the whole file of exact increments,
/// with a free vertical channel; `n` subsamples an update, each of `merge` half intervals.
fn navigation_error(name: &str, frame: Frame, scheme: Scheme, n: usize, merge: usize) -> [f64; 3] {
    let reference = Reference::load(name);
    let samples = reference.truth.samples(false);
    let mut simulator = Simulator::new(&Options { frame, scheme, ..options(reference.period_s) }).unwrap();
    let mut intake = sins::truth::Intake::new(earth(), BodyAxes::default(), IntakeLimits::default()).unwrap();
    intake.push(&samples[0]).unwrap();
    let start = intake.front().unwrap().navigation(&earth(), BodyAxes::default());
    simulator.start_navigation(0.0, &start).unwrap();
    let update = n * merge;
    assert_eq!(reference.increments.len() % update, 0);
    for part in reference.increments.chunks_exact(update) {
        let subsamples: Vec<Increment> = part.chunks_exact(merge).map(Increment::sum).collect();
        simulator.push_imu(&subsamples, 0.5 * update as f64 * reference.period_s).unwrap();
    }
    let solution = simulator.navigation().unwrap().unwrap();
    assert!((solution.time_s - samples.last().unwrap().time_s).abs() < 1e-9);
    let computed = solution.navigation.earth_fixed(&earth());
    let (position, velocity, psi) = differences(&computed, samples.last().unwrap());
    [position.xy().norm(), velocity.xy().norm(), psi.norm()]
}

/// Errors of rounding: three roundings of Earth-fixed coordinates, and their Schuler swing; in the file's increments half a
/// unit of 1e-17 rad, which at rest is always the same.
fn rounding(duration_s: f64) -> [f64; 3] {
    let position_m = 3.0 * 6.4e6 * f64::EPSILON;
    [position_m, 1.24e-3 * position_m, 1e-15 * duration_s]
}

/// Bound of a scheme of order `order`: twice the error of updates `merge` times as long, reduced by that order; rounding; and
/// the lean of gravity within an update where the change of force f is not known yet, g/R f T³/12, which is of third order.
fn left_by_order(
    name: &str,
    frame: Frame,
    scheme: Scheme,
    n: usize,
    (merge, order): (usize, i32),
) -> [f64; 3] {
    let reference = Reference::load(name);
    let duration_s = 0.5 * reference.period_s * reference.increments.len() as f64;
    let length_s = 0.5 * n as f64 * reference.period_s;
    let force = reference.increments.iter().map(|i| i.velocity.norm()).fold(0.0, f64::max)
        / (0.5 * reference.period_s);
    let lean_m_s = 1.24e-3_f64.powi(2) * force * length_s.powi(3) / 12.0;
    let coarse = navigation_error(name, frame, scheme, n, merge);
    let rounding = rounding(duration_s);
    let third = [lean_m_s * duration_s, lean_m_s, 0.0];
    [0, 1, 2].map(|i| 2.0 * coarse[i] / (merge as f64).powi(order) + rounding[i] + third[i])
}

fn assert_order(name: &str, frame: Frame, scheme: Scheme, n: usize, merge_and_order: (usize, i32)) {
    let left = left_by_order(name, frame, scheme, n, merge_and_order);
    let errors = navigation_error(name, frame, scheme, n, 1);
    println!("{name} {frame:?} {scheme:?} {n}: {errors:?} of {left:?}");
    assert!(errors.iter().zip(&left).all(|(error, left)| error < left), "{name}: {errors:?} of {left:?}");
}

/// Coning of half angle a about a level axis drifts by a² (wh)⁵/(30 · 2h) with two subsamples of length h (see
/// `convergence.rs`). The platform tilts by the drift ε, and gravity with it: g ε t²/2, g ε t³/6.
fn assert_coning_of_two_subsamples(frame: Frame, scheme: Scheme) {
    let (a, w, h, t_s) = (support::DEG, std::f64::consts::TAU * 2.0, 0.005, 30.0_f64);
    let drift = a * a * (w * h).powi(5) / (30.0 * 2.0 * h);
    let expected =
        [support::G * drift * t_s.powi(3) / 6.0, support::G * drift * t_s.powi(2) / 2.0, drift * t_s];
    let errors = navigation_error("cone1", frame, scheme, 2, 1);
    println!("cone1 {frame:?} {scheme:?} 2: {errors:?} of {expected:?}");
    for (error, expected) in errors.iter().zip(expected) {
        // The vibration, of the same frequency and a tenth of g, has its own share.
        assert!((0.8..1.1).contains(&(error / expected)), "{errors:?} {expected:?}");
    }
}

/// At rest only rounding is left.
fn assert_rest(scheme: Scheme) {
    let errors = navigation_error("pole_static", Frame::EarthFixed, scheme, 2, 1);
    assert!(errors.iter().zip(rounding(10.0)).all(|(&error, rounding)| error < rounding), "{errors:?}");
}

#[test]
fn exact_scheme_navigates_exact_increments_back_to_the_truth() {
    for name in ["fig8", "loop", "scurve", "polar"] {
        assert_order(name, Frame::EarthFixed, Scheme::Exact, 2, (8, 4));
    }
    assert_coning_of_two_subsamples(Frame::EarthFixed, Scheme::Exact);
    assert_rest(Scheme::Exact);
}

#[test]
fn polynomial_scheme_navigates_exact_increments_back_to_the_truth() {
    for name in ["fig8", "loop", "scurve", "polar"] {
        assert_order(name, Frame::EarthFixed, Scheme::Polynomial, 2, (8, 4));
    }
    assert_coning_of_two_subsamples(Frame::EarthFixed, Scheme::Polynomial);
    assert_order("cone1", Frame::EarthFixed, Scheme::Polynomial, 4, (5, 6));
    assert_rest(Scheme::Polynomial);
}

#[test]
fn geographic_axes_do_as_well_away_from_the_pole() {
    for name in ["fig8", "loop", "scurve"] {
        assert_order(name, Frame::Geographic, Scheme::Exact, 2, (8, 4));
    }
    assert_coning_of_two_subsamples(Frame::Geographic, Scheme::Exact);
}

/// Constant sensor biases against the exact nonlinear solution, vertical channel held to the truth: errors agree within the bounds
/// of the tests above. A rotation vector exceeds the vector part of its matrix by ψ²/6 of itself; the rest is of third order too.
#[test]
fn biased_sensors_give_the_errors_of_the_exact_equations() {
    for (name, gyro, accel) in
        [("fig8", 0.01 * DEG_PER_HOUR, 1e-5 * support::G), ("loop", DEG_PER_HOUR, 1e-3 * support::G)]
    {
        let reference = Reference::load(name);
        let samples = reference.truth.samples(false);
        let expected = Table::csv(&format!("tests/data/{name}_biased_errors.csv"));
        let position = expected.vectors(["position_east_m", "position_north_m", "position_up_m"]);
        let velocity = expected.vectors(["velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"]);
        let misalignment =
            expected.vectors(["misalignment_east_rad", "misalignment_north_rad", "misalignment_up_rad"]);
        let largest = misalignment.iter().map(Vector3::norm).fold(0.0, f64::max);
        let own = left_by_order(name, Frame::EarthFixed, Scheme::Exact, 2, (8, 4));
        // Both sides are rounded in Earth-fixed coordinates.
        let rounding_m = 2.0 * rounding(0.0)[0];

        let t = reference.period_s;
        let bias = Increment {
            angle: Vector3::new(gyro, -gyro, gyro) * (0.5 * t),
            velocity: Vector3::new(accel, accel, -accel) * (0.5 * t),
        };
        let mut mechanization =
            Mechanization::new(earth(), Frame::EarthFixed, Scheme::Exact, &state_of(&earth(), &samples[0]));
        let mut row = 1;
        for (k, pair) in reference.increments.chunks_exact(2).enumerate() {
            let biased = [pair[0], pair[1]]
                .map(|i| Increment { angle: i.angle + bias.angle, velocity: i.velocity + bias.velocity });
            mechanization.update(&biased, t);
            let sample = &samples[k + 1];
            let velocity_up_m_s = sample.v_n.unwrap().z;
            mechanization
                .aid_vertical(&VerticalAid::Truth { height_m: sample.place.height_m, velocity_up_m_s }, t);
            if row < expected.len() && (sample.time_s - expected.column("time_s")[row]).abs() < 0.5 * t {
                let computed = mechanization.navigation(BodyAxes::default()).earth_fixed(&earth());
                let (dr, dv, psi) = differences(&computed, sample);
                let near = |value: Vector3<f64>, exact: Vector3<f64>, own: f64| {
                    let error = (value - exact).norm();
                    let bound = largest * largest / 6.0 * exact.norm() + own;
                    assert!(error < bound, "{name} row {row}: {error:e} of {:e}, {bound:e}", exact.norm());
                };
                near(dr, position[row], own[0] + rounding_m);
                near(dv, velocity[row], own[1]);
                near(psi, misalignment[row], own[2]);
                row += 1;
            }
        }
        assert_eq!(row, expected.len());
    }
}

/// Generator and mechanization together over the pole, which the flight passes exactly: the error is of the fourth order of the
/// interval, so that every other sample leaves 16 times as much. The bound is twice the 16th part, and rounding.
#[test]
fn the_whole_chain_passes_the_pole_like_anywhere_else() {
    let samples = Reference::load("polar").truth.samples(false);
    let worst = |every: usize| {
        let intake = IntakeLimits { period_s: Some(0.05 * every as f64), ..Default::default() };
        let vertical = VerticalMode::FollowTruth;
        let mut simulator = Simulator::new(&Options {
            gravity: GravityModel::Somigliana,
            vertical,
            intake,
            ..Default::default()
        })
        .unwrap();
        support::fly(&mut simulator, samples.iter().copied().step_by(every), 1)
    };
    let (coarse, fine) = (worst(2), worst(1));
    println!("over the pole: {fine:?}, of every other sample {coarse:?}");
    assert!(fine.position_m < coarse.position_m / 8.0 + rounding(0.0)[0], "{fine:?} {coarse:?}");
}

/// The paper's scheme keeps its approximations: its own error has the size that they predict.
#[test]
fn paper_scheme_shows_its_own_error() {
    let reference = Reference::load("fig8");
    let samples = reference.truth.samples(false);
    let mut mechanization =
        Mechanization::new(earth(), Frame::Geographic, Scheme::Paper, &state_of(&earth(), &samples[0]));
    for (k, pair) in reference.increments.chunks_exact(2).enumerate() {
        mechanization.update(pair, reference.period_s);
        let sample = &samples[k + 1];
        let velocity_up_m_s = sample.v_n.unwrap().z;
        let aid = VerticalAid::Truth { height_m: sample.place.height_m, velocity_up_m_s };
        mechanization.aid_vertical(&aid, reference.period_s);
    }
    let computed = mechanization.navigation(BodyAxes::default()).earth_fixed(&earth());
    let (position, _, _) = differences(&computed, samples.last().unwrap());
    // A position by the velocity at the start of each update lags by T/2 of the change of velocity.
    let (first, last) = (samples[0].v_n.unwrap(), samples.last().unwrap().v_n.unwrap());
    let lag = 0.5 * reference.period_s * (last - first).xy().norm();
    assert!(position.xy().norm() > 0.5 * lag && position.xy().norm() < 2.0 * lag, "{position} {lag}");
}
