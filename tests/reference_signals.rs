//! The generator against exact integrals, and the mechanization on exact increments against exact truth.
//!
//! The references are analytic trajectories, differentiated and integrated in 50-digit arithmetic; see tests/data.

mod support;

use nalgebra::Vector3;
use sins::earth::{Earth, Ellipsoid, GravityModel};
use sins::math::rotation_vector;
use sins::mechanization::{Frame, Mechanization, Scheme, VerticalAid, VerticalMode};
use sins::signal::Increment;
use sins::state::{BodyAxes, EarthFixedState};
use sins::truth::{FlightSample, IntakeLimits, TruthPoint};
use sins::{Options, Simulator};
use support::{DEG_PER_HOUR, Reference, Table};

fn earth() -> Earth {
    Earth::new(Ellipsoid::Wgs84, GravityModel::Somigliana)
}

fn options(period_s: f64) -> Options {
    let intake = IntakeLimits { period_s: Some(period_s), ..Default::default() };
    Options { gravity: GravityModel::Somigliana, vertical: VerticalMode::Free, intake, ..Default::default() }
}

fn state(sample: &FlightSample) -> EarthFixedState {
    let mut intake = sins::truth::Intake::new(earth(), BodyAxes::default(), IntakeLimits::default());
    intake.push(sample).unwrap();
    let point: TruthPoint = *intake.front().unwrap();
    point.navigation(&earth(), BodyAxes::default()).earth_fixed(&earth())
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

/// At the middle of an interval a cubic misses T⁴/384 of the fourth derivative of velocity; as a force over half an
/// interval that is the fourth difference over 192 T.
fn force_error_in_theory(reference: &Reference) -> f64 {
    let v = reference.truth.vectors(["velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"]);
    let fourth = v.windows(5).map(|w| (w[0] + w[4] - (w[1] + w[3]) * 4.0 + w[2] * 6.0).norm_squared());
    (fourth.sum::<f64>() / (v.len() - 4) as f64).sqrt() / (192.0 * reference.period_s)
}

/// Loops and weaves are hard on the velocity alone: there the error is what the theory says, to a few percent.
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
    // At rest: what the reference's rounded constants of gravity differ from the exact ones, 6e-11 m/s².
    let (rate, force) = generator_error("pole_static", false);
    assert!(rate < 1e-9 && force < 1e-10, "{rate:e} °/h, {force:e} m/s²");
}

/// Vibration: 1° of coning at 2 Hz, sampled at 100 Hz. The generator shows the motion it was given; the host's own rate
/// and force help.
#[test]
fn generator_follows_coning_at_a_fiftieth_of_the_sample_rate() {
    let (rate, force) = generator_error("cone1", false);
    assert!(rate < 5e-4 && force < 5e-5, "{rate:e} °/h, {force:e} m/s²");
    let (_, with_host) = generator_error("cone1", true);
    assert!(with_host < 0.7 * force);
}

/// Position and velocity error at the end, east-north-up of the truth.
fn differences(
    computed: &EarthFixedState,
    truth: &FlightSample,
) -> (Vector3<f64>, Vector3<f64>, Vector3<f64>) {
    let exact = state(truth);
    let (east, north, up) = earth().east_north_up(&truth.place);
    let local = |v: Vector3<f64>| Vector3::new(v.dot(&east), v.dot(&north), v.dot(&up));
    // Earth-fixed attitude error ψ with computed C = (I - [ψ×]) C.
    let psi = -rotation_vector(&(computed.q_eb * exact.q_eb.conjugate()));
    (local(computed.r_e - exact.r_e), local(computed.v_e - exact.v_e), local(psi))
}

/// Horizontal position [m] and velocity [m/s] error after the whole file of exact increments, free vertical channel.
fn navigation_error(name: &str, frame: Frame, scheme: Scheme, n: usize) -> (f64, f64) {
    let reference = Reference::load(name);
    let samples = reference.truth.samples(false);
    let mut simulator = Simulator::new(&Options { frame, scheme, ..options(reference.period_s) }).unwrap();
    let mut intake = sins::truth::Intake::new(earth(), BodyAxes::default(), IntakeLimits::default());
    intake.push(&samples[0]).unwrap();
    let start = intake.front().unwrap().navigation(&earth(), BodyAxes::default());
    simulator.start_navigation(0.0, &start).unwrap();
    for update in reference.increments.chunks_exact(n) {
        simulator.push_imu(update, 0.5 * n as f64 * reference.period_s).unwrap();
    }
    let solution = simulator.navigation().unwrap().unwrap();
    assert!((solution.time_s - samples.last().unwrap().time_s).abs() < 1e-9);
    let computed = solution.navigation.earth_fixed(&earth());
    let (position, velocity, _) = differences(&computed, samples.last().unwrap());
    (position.xy().norm(), velocity.xy().norm())
}

/// The bars are twice what a prototype in wander azimuth axes leaves. The figure-eight is far below: the change of the
/// transport rate within an update, which the prototype drops, does not arise in Earth-fixed axes.
#[test]
fn exact_scheme_navigates_exact_increments_back_to_the_truth() {
    for (name, bar_m) in
        [("fig8", 8e-7), ("loop", 2.4e-5), ("scurve", 5.6e-5), ("polar", 1.64e-5), ("cone1", 1.68e-4)]
    {
        let (position, velocity) = navigation_error(name, Frame::EarthFixed, Scheme::Exact, 2);
        assert!(position < bar_m, "{name}: {position:e} m");
        assert!(name != "fig8" || velocity < 1.2e-8, "{velocity:e} m/s");
    }
    // This form's own figures: without the triple products of changing rate and force the last three are 1e-5 m.
    for (name, bar_m) in [("fig8", 2e-8), ("loop", 5e-9), ("scurve", 5e-8), ("polar", 5e-7)] {
        let (position, _) = navigation_error(name, Frame::EarthFixed, Scheme::Exact, 2);
        assert!(position < bar_m, "{name}: {position:e} m");
    }
    let (position, velocity) = navigation_error("pole_static", Frame::EarthFixed, Scheme::Exact, 2);
    assert!(position < 1e-8 && velocity < 1e-12, "{position:e} m");
}

/// The bars are twice what a prototype of the same scheme leaves; with four subsamples, of 5 ms here against its 2.5 ms, by
/// the sixth order 64 times that.
#[test]
fn polynomial_scheme_navigates_exact_increments_back_to_the_truth() {
    for (name, n, bar_m) in [
        ("fig8", 2, 7.2e-7),
        ("loop", 2, 7.4e-7),
        ("scurve", 2, 2.6e-7),
        ("polar", 2, 2.8e-6),
        ("cone1", 2, 7.2e-5),
        ("cone1", 4, 7.7e-7),
        ("pole_static", 2, 1e-8),
    ] {
        let (position, _) = navigation_error(name, Frame::EarthFixed, Scheme::Polynomial, n);
        assert!(position < bar_m, "{name} n = {n}: {position:e} m");
    }
}

#[test]
fn geographic_axes_do_as_well_away_from_the_pole() {
    for (name, bar_m) in [("fig8", 1e-6), ("loop", 2.4e-5), ("scurve", 5.6e-5), ("cone1", 1.68e-4)] {
        let (position, _) = navigation_error(name, Frame::Geographic, Scheme::Exact, 2);
        assert!(position < bar_m, "{name}: {position:e} m");
    }
}

/// Constant sensor biases against the exact nonlinear solution, vertical channel held to the truth: within 1e-6 of the
/// error, and the algorithm's own of the test above.
#[test]
fn biased_sensors_give_the_errors_of_the_exact_equations() {
    for (name, gyro, accel, own_m, own_m_s) in [
        ("fig8", 0.01 * DEG_PER_HOUR, 1e-5 * support::G, 2e-8, 1e-9),
        ("loop", DEG_PER_HOUR, 1e-3 * support::G, 2.4e-5, 1e-6),
    ] {
        let reference = Reference::load(name);
        let samples = reference.truth.samples(false);
        let expected = Table::csv(&format!("tests/data/{name}_biased_errors.csv"));
        let position = expected.vectors(["position_east_m", "position_north_m", "position_up_m"]);
        let velocity = expected.vectors(["velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"]);
        let misalignment =
            expected.vectors(["misalignment_east_rad", "misalignment_north_rad", "misalignment_up_rad"]);

        let t = reference.period_s;
        let bias = Increment {
            angle: Vector3::new(gyro, -gyro, gyro) * (0.5 * t),
            velocity: Vector3::new(accel, accel, -accel) * (0.5 * t),
        };
        let mut mechanization =
            Mechanization::new(earth(), Frame::EarthFixed, Scheme::Exact, &state(&samples[0]));
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
                    assert!(
                        error < 1e-6 * exact.norm() + own,
                        "{name} row {row}: {error:e} of {:e}",
                        exact.norm()
                    );
                };
                // 2e-9 m is the rounding of Earth-fixed coordinates on both sides.
                near(dr, position[row], own_m + 2e-9);
                near(dv, velocity[row], own_m_s);
                near(psi, misalignment[row], 1e-12);
                row += 1;
            }
        }
        assert_eq!(row, expected.len());
    }
}

/// The paper's scheme keeps its approximations: its own error shows, and it is the size that they predict.
#[test]
fn paper_scheme_shows_its_own_error() {
    let reference = Reference::load("fig8");
    let samples = reference.truth.samples(false);
    let mut mechanization =
        Mechanization::new(earth(), Frame::Geographic, Scheme::Paper, &state(&samples[0]));
    for (k, pair) in reference.increments.chunks_exact(2).enumerate() {
        mechanization.update(pair, reference.period_s);
        let sample = &samples[k + 1];
        let velocity_up_m_s = sample.v_n.unwrap().z;
        let aid = VerticalAid::Truth { height_m: sample.place.height_m, velocity_up_m_s };
        mechanization.aid_vertical(&aid, reference.period_s);
    }
    let computed = mechanization.navigation(BodyAxes::default()).earth_fixed(&earth());
    let (position, _, _) = differences(&computed, samples.last().unwrap());
    // Position by the velocity of the start of each update lags by T/2 of the change of velocity.
    let (first, last) = (samples[0].v_n.unwrap(), samples.last().unwrap().v_n.unwrap());
    let lag = 0.5 * reference.period_s * (last - first).xy().norm();
    assert!(position.xy().norm() > 0.5 * lag && position.xy().norm() < 2.0 * lag, "{position} {lag}");
}
