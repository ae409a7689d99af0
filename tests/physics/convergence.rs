//! Orders of convergence, by halving the step: slopes within 0.2 of theory.
//!
//! The exact integrals of the references are added up to longer subsamples, so every step has exact increments.

use nalgebra::{Quaternion, Vector3};
use sins::earth::state::BodyAxes;
use sins::earth::{Earth, Ellipsoid, GravityModel};
use sins::math::{rotate, rotation_quaternion, rotation_vector};
use sins::mechanization::{BodyMotion, Frame, Mechanization, Scheme};
use sins::signal::Increment;

use crate::support::{Reference, state_of};

/// Errors at the end: position [m], velocity [m/s], attitude [rad].
struct Errors {
    position: f64,
    velocity: f64,
    attitude: f64,
}

/// Navigates with `n` subsamples an update, each of `merge` half intervals of the reference.
fn navigate(reference: &Reference, frame: Frame, scheme: Scheme, n: usize, merge: usize) -> Errors {
    let earth = Earth::new(Ellipsoid::Wgs84, GravityModel::Somigliana);
    let samples = reference.truth.samples(false);
    let mut mechanization = Mechanization::new(earth, frame, scheme, &state_of(&earth, &samples[0]));
    let update = n * merge;
    // Whole updates of every length that the tests use.
    let total = reference.increments.len() / 240 * 240;
    for part in reference.increments[..total].chunks_exact(update) {
        let subsamples: Vec<Increment> = part.chunks_exact(merge).map(Increment::sum).collect();
        mechanization.update(&subsamples, update as f64 * 0.5 * reference.period_s);
    }
    let computed = mechanization.navigation(BodyAxes::default()).earth_fixed(&earth);
    let exact = state_of(&earth, &samples[total / 2]);
    Errors {
        position: (computed.r_e - exact.r_e).norm(),
        velocity: (computed.v_e - exact.v_e).norm(),
        attitude: rotation_vector(&(computed.q_eb.conjugate() * exact.q_eb)).norm(),
    }
}

fn assert_slopes(label: &str, errors: &[f64], order: f64) {
    for pair in errors.windows(2) {
        let slope = (pair[1] / pair[0]).log2();
        assert!((slope - order).abs() < 0.2, "{label}: slope {slope:.2}, theory {order}; {errors:?}");
    }
}

fn slopes(name: &str, frame: Frame, scheme: Scheme, n: usize, what: impl Fn(&Errors) -> f64, order: f64) {
    let reference = Reference::load(name);
    let errors: Vec<f64> =
        [2, 4, 8].iter().map(|&merge| what(&navigate(&reference, frame, scheme, n, merge))).collect();
    assert_slopes(&format!("{name} {frame:?} {scheme:?} n = {n}"), &errors, order);
}

/// One subsample: rate and force are constant over the update, local errors are of third order.
#[test]
fn exact_scheme_with_one_subsample_is_of_order_2() {
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for name in ["fig8", "loop", "scurve"] {
            slopes(name, frame, Scheme::Exact, 1, |e| e.position, 2.0);
            slopes(name, frame, Scheme::Exact, 1, |e| e.velocity, 2.0);
            slopes(name, frame, Scheme::Exact, 1, |e| e.attitude, 2.0);
        }
    }
}

/// Two and more subsamples: rate and force may change evenly, in direction too; local errors are of fifth order.
#[test]
fn exact_scheme_with_more_subsamples_is_of_order_4() {
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for n in 2..=5 {
            slopes("scurve", frame, Scheme::Exact, n, |e| e.velocity, 4.0);
            slopes("scurve", frame, Scheme::Exact, n, |e| e.position, 4.0);
        }
        // Rate and force turn in all directions.
        slopes("cone1", frame, Scheme::Exact, 2, |e| e.velocity, 4.0);
        slopes("cone1", frame, Scheme::Exact, 2, |e| e.position, 4.0);
    }
    // With two subsamples the errors over a whole loop cancel to more than order 4.
    for n in 3..=5 {
        slopes("loop", Frame::EarthFixed, Scheme::Exact, n, |e| e.velocity, 4.0);
        slopes("loop", Frame::EarthFixed, Scheme::Exact, n, |e| e.position, 4.0);
    }
}

/// Attitude: two subsamples fit any linear rate, and the symmetric coefficients of more leave no even order either. The order
/// is 4; with four and five subsamples it comes from the triple products that the rotation vector's series lacks.
#[test]
fn exact_scheme_in_attitude_is_of_order_4() {
    for n in 2..=5 {
        for name in ["fig8", "scurve"] {
            slopes(name, Frame::EarthFixed, Scheme::Exact, n, |e| e.attitude, 4.0);
        }
    }
}

/// The paper's scheme takes Earth terms and the velocity for the position from the start of an update: order 1.
#[test]
fn papers_scheme_is_of_order_1() {
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for name in ["fig8", "loop"] {
            slopes(name, frame, Scheme::Paper, 2, |e| e.attitude, 1.0);
            slopes(name, frame, Scheme::Paper, 2, |e| e.position, 1.0);
        }
    }
}

/// Increment of classical coning of half angle `a` [rad] and rate `w` [rad/s] from `from` to `to` [s]: the attitude is
/// (cos a/2, sin a/2 cos wt, sin a/2 sin wt, 0), its rate (-w sin a sin wt, w sin a cos wt, -2 w sin² a/2).
fn coning(a: f64, w: f64, from: f64, to: f64) -> Increment {
    let angle = Vector3::new(
        a.sin() * ((w * to).cos() - (w * from).cos()),
        a.sin() * ((w * to).sin() - (w * from).sin()),
        -2.0 * w * (0.5 * a).sin().powi(2) * (to - from),
    );
    Increment { angle, velocity: Vector3::zeros() }
}

fn coning_attitude(a: f64, w: f64, t: f64) -> Quaternion<f64> {
    let (sin, cos) = (0.5 * a).sin_cos();
    Quaternion::new(cos, sin * (w * t).cos(), sin * (w * t).sin(), 0.0)
}

/// Attitude drift [rad/s] about the cone's axis with `n` subsamples of length `h`.
fn coning_drift(n: usize, a: f64, w: f64, h: f64) -> f64 {
    let updates = 2000;
    let mut q = coning_attitude(a, w, 0.0);
    for update in 0..updates {
        let start = (update * n) as f64 * h;
        let subsamples: Vec<Increment> =
            (0..n).map(|i| coning(a, w, start + i as f64 * h, start + (i + 1) as f64 * h)).collect();
        q *= rotation_quaternion(&BodyMotion::exact(&subsamples).rotation);
        q /= q.norm();
    }
    let time = (updates * n) as f64 * h;
    let error = rotation_vector(&(q * coning_attitude(a, w, time).conjugate()));
    error.dot(&rotate(&Quaternion::identity(), &Vector3::z())).abs() / time
}

/// For small coning the drift falls with the order 2n and has the size of the theory:
/// a² (wh)^(2n+1) n n! / (2^(n+1) Π_{k=1}^{n+1} (2k-1)) / (n h).
#[test]
fn coning_drift_is_of_order_2n_and_of_the_size_of_theory() {
    let w = std::f64::consts::TAU * 10.0;
    // Steps are small enough for the leading term and large enough to exceed the rounding of 2000 updates. Cones are so small
    // that the terms of fourth order in the angle, which these formulas omit, stay below the leading term.
    for (n, a, wh) in [(1, 1e-3, 0.02_f64), (2, 1e-3, 0.05), (3, 1e-3, 0.1), (4, 3e-4, 0.2), (5, 1e-4, 0.3)] {
        let drifts: Vec<f64> =
            [1.0, 2.0].iter().map(|&scale| coning_drift(n, a, w, scale * wh / w)).collect();
        assert_slopes(&format!("coning n = {n}"), &drifts, 2.0 * n as f64);
        let factorial: f64 = (1..=n).map(|k| k as f64).product();
        let odd: f64 = (1..=n + 1).map(|k| (2 * k - 1) as f64).product();
        let theory = a * a * wh.powi(2 * n as i32 + 1) * n as f64 * factorial
            / (2f64.powi(n as i32 + 1) * odd)
            / (n as f64 * wh / w);
        println!("coning, {n} subsamples: drift {:.2e} rad/s, theory {theory:.2e} rad/s", drifts[0]);
        assert!((drifts[0] / theory - 1.0).abs() < 0.1, "n = {n}: {:e} of {theory:e}", drifts[0]);
    }
}

/// The polynomial of degree n - 1 has the increments as its integrals, so its errors enter through products alone: for even n
/// the next order cancels by symmetry. Attitude, velocity and position under coning.
#[test]
fn polynomial_scheme_is_of_order_2_4_4_6_6() {
    let reference = Reference::load("cone1");
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for (n, order) in [(1, 2.0), (2, 4.0), (3, 4.0), (4, 6.0), (5, 6.0)] {
            let errors = [1, 2, 4].map(|merge| navigate(&reference, frame, Scheme::Polynomial, n, merge));
            for (what, errors) in [
                ("attitude", errors.each_ref().map(|e| e.attitude)),
                ("velocity", errors.each_ref().map(|e| e.velocity)),
                ("position", errors.each_ref().map(|e| e.position)),
            ] {
                assert_slopes(&format!("{what} {frame:?} n = {n}"), &errors, order);
            }
        }
    }
}
