//! The validators of P. G. Savage (*Strapdown Analytics*, 2nd ed.; "Strapdown System Performance Analysis", NATO RTO-EN-SET-116) by
//! their names: motions whose attitude, velocity and position are known in closed form, against the two schemes. SPIN-CONE, SPIN-ACCEL and
//! SPIN-ROCK-SIZE test the body part of an update in inertial space, without gravity; GEN NAV tests the whole chain around the Earth.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::{Complex, Quaternion, UnitQuaternion, Vector3};
use sins::Simulator;
use sins::earth::state::EarthFixedState;
use sins::math::{rotate, rotation_quaternion, rotation_vector};
use sins::mechanization::{BodyMotion, Scheme};
use sins::signal::Increment;

use crate::support::options_at;
use crate::support::orbits::{Apart, Circle, about, apart_on_the_way, sample_of};

/// Attitude, velocity [m/s] and position [m] in inertial space.
struct Motion {
    q: UnitQuaternion<f64>,
    v: Vector3<f64>,
    r: Vector3<f64>,
}

/// Errors of attitude [rad], velocity [m/s] and position [m] after `duration_s` with `n` subsamples of length `h`. `motion` is the
/// closed form, `increment` its integrals from one time to another.
fn errors(
    (scheme, n, h): (Scheme, usize, f64),
    duration_s: f64,
    motion: impl Fn(f64) -> Motion,
    increment: impl Fn(f64, f64) -> Increment,
) -> [f64; 3] {
    let period = n as f64 * h;
    let updates = (duration_s / period).round() as usize;
    let Motion { q, mut v, mut r } = motion(0.0);
    let mut q: Quaternion<f64> = q.into_inner();
    for update in 0..updates {
        let time = |i: usize| (update * n + i) as f64 * h;
        let parts: Vec<Increment> = (0..n).map(|i| increment(time(i), time(i + 1))).collect();
        let body = BodyMotion::of(scheme, &parts);
        r += v * period + rotate(&q, &body.s2) * period;
        v += rotate(&q, &body.s1);
        q *= rotation_quaternion(&body.rotation);
        q /= q.norm();
    }
    let end = motion(updates as f64 * period);
    [rotation_vector(&(q.conjugate() * end.q.into_inner())).norm(), (v - end.v).norm(), (r - end.r).norm()]
}

/// Orders of the schemes with 1 to 5 subsamples, as in `convergence`.
const ORDERS: [(Scheme, [f64; 5]); 2] =
    [(Scheme::Exact, [2.0, 4.0, 4.0, 4.0, 4.0]), (Scheme::Polynomial, [2.0, 4.0, 4.0, 6.0, 6.0])];

/// Halves the update from `h`: the error falls by the order of the scheme, and is printed for `h`.
fn assert_orders(
    name: &str,
    h: f64,
    (first, what): (usize, &[&str]),
    errors: impl Fn(Scheme, usize, f64) -> [f64; 3],
) {
    for (scheme, orders) in ORDERS {
        for (n, order) in (1..).zip(orders) {
            // The same length of an update for every n, so that it divides the duration.
            let [coarse, fine] = [1.0, 2.0].map(|parts| errors(scheme, n, h / parts / n as f64));
            for (k, what) in (first..).zip(what) {
                let slope = (coarse[k] / fine[k]).log2();
                println!(
                    "{name}, {scheme:?} {n}: {what} {:.1e}, order {slope:.1} (theory {order})",
                    coarse[k]
                );
                assert!(
                    slope > order - 0.2,
                    "{name} {scheme:?} {n}: {what} {:.1e}, slope {slope}",
                    coarse[k]
                );
            }
        }
    }
}

/// SPIN-CONE: the body spins at s about its x axis, which is inclined by θ and precesses at w about z: roll s t, pitch θ, heading w t.
/// The rate is (s - w sin θ, w cos θ sin st, w cos θ cos st).
const SPIN: f64 = 1.1;
const PRECESSION: f64 = 0.7;
const INCLINATION: f64 = 0.6;

fn spin_cone(t: f64) -> Motion {
    let q = about(Vector3::z(), PRECESSION * t)
        * about(Vector3::y(), INCLINATION)
        * about(Vector3::x(), SPIN * t);
    Motion { q, v: Vector3::zeros(), r: Vector3::zeros() }
}

fn spin_cone_increment(from: f64, to: f64) -> Increment {
    let (sin, cos) = INCLINATION.sin_cos();
    let across = PRECESSION * cos / SPIN;
    let angle = Vector3::new(
        (SPIN - PRECESSION * sin) * (to - from),
        across * ((SPIN * from).cos() - (SPIN * to).cos()),
        across * ((SPIN * to).sin() - (SPIN * from).sin()),
    );
    Increment { angle, velocity: Vector3::zeros() }
}

#[test]
fn spin_cone_is_followed_with_the_order_of_each_scheme() {
    assert_orders("SPIN-CONE", 0.2, (0, &["attitude"]), |scheme, n, h| {
        errors((scheme, n, h), 60.0, spin_cone, spin_cone_increment)
    });
}

/// Without a coning term an update of length T misses T²/12 ω×ω' in a second. In the precessing axes both vectors are constant; their
/// mean in space is along z: T²/12 w s² cos² θ.
#[test]
fn spin_cone_without_a_coning_term_drifts_as_in_theory() {
    let (h, duration_s) = (0.01, TAU / PRECESSION * 10.0);
    let [attitude, ..] = errors((Scheme::Exact, 1, h), duration_s, spin_cone, spin_cone_increment);
    let theory = h * h / 12.0 * PRECESSION * SPIN * SPIN * INCLINATION.cos().powi(2) * duration_s;
    println!("SPIN-CONE, exact 1: drift {attitude:.3e} rad, theory {theory:.3e} rad");
    // The next order is (ωT)² of it; the ends of the precession leave T² of the amplitude.
    assert!((attitude / theory - 1.0).abs() < 0.01, "{attitude:e} {theory:e}");
}

/// SPIN-ACCEL: the body spins at w about the axis u, and senses f0 + f1 sin Wt. With i = u×, the parts across u turn as e^(iwt).
const AXIS: Vector3<f64> = Vector3::new(2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0);
const STEADY: Vector3<f64> = Vector3::new(30.0, 5.0, -12.0);
const SWINGING: Vector3<f64> = Vector3::new(-4.0, 20.0, 7.0);
const SWING: f64 = 1.7;

/// First and second integral of e^(iwt) from 0 to t.
fn turning(w: f64, t: f64) -> [Complex<f64>; 2] {
    let iw = Complex::new(0.0, w);
    let once = (Complex::new((w * t).cos(), (w * t).sin()) - 1.0) / iw;
    [once, (once - t) / iw]
}

fn spin_accel(swinging: Vector3<f64>) -> impl Fn(f64) -> Motion {
    move |t| {
        let parts = |force: &Vector3<f64>| {
            let along = AXIS * AXIS.dot(force);
            (along, force - along, AXIS.cross(force))
        };
        let of = |(along, across, turned): (Vector3<f64>, Vector3<f64>, Vector3<f64>),
                  straight: f64,
                  z: Complex<f64>| { along * straight + across * z.re + turned * z.im };
        let (steady, swung) = (parts(&STEADY), parts(&swinging));
        let (sum, difference) = (turning(SPIN + SWING, t), turning(SPIN - SWING, t));
        let plain = turning(SPIN, t);
        // sin Wt e^(iwt) = (e^(i(w + W)t) - e^(i(w - W)t))/2i
        let sine = |k: usize| (sum[k] - difference[k]) / Complex::new(0.0, 2.0);
        let (sin, cos) = (SWING * t).sin_cos();
        Motion {
            q: about(AXIS, SPIN * t),
            v: of(steady, t, plain[0]) + of(swung, (1.0 - cos) / SWING, sine(0)),
            r: of(steady, 0.5 * t * t, plain[1]) + of(swung, (t - sin / SWING) / SWING, sine(1)),
        }
    }
}

fn spin_accel_increment(swinging: Vector3<f64>) -> impl Fn(f64, f64) -> Increment {
    move |from, to| Increment {
        angle: AXIS * SPIN * (to - from),
        velocity: STEADY * (to - from) + swinging * (((SWING * from).cos() - (SWING * to).cos()) / SWING),
    }
}

#[test]
fn spin_accel_is_followed_with_the_order_of_each_scheme() {
    assert_orders("SPIN-ACCEL", 0.4, (1, &["velocity", "position"]), |scheme, n, h| {
        errors((scheme, n, h), 60.0, spin_accel(SWINGING), spin_accel_increment(SWINGING))
    });
}

/// A constant rate and force: the exact scheme leaves rounding alone in attitude and velocity, with updates of half a radian. Each
/// update rounds a velocity of 2 km/s, and an attitude that turns the force.
#[test]
fn spin_accel_of_constant_rate_and_force_is_exact() {
    for n in 1..=5 {
        let (h, duration_s) = (0.5 / SPIN / n as f64, 60.0);
        let none = Vector3::zeros();
        let of = (Scheme::Exact, n, h);
        let [attitude, velocity, _] = errors(of, duration_s, spin_accel(none), spin_accel_increment(none));
        println!("SPIN-ACCEL, constant, exact {n}: {attitude:.1e} rad, {velocity:.1e} m/s");
        let bound = duration_s / (n as f64 * h) * 4.0 * f64::EPSILON;
        assert!(
            attitude < bound && velocity < bound * STEADY.norm() * duration_s,
            "{attitude:e} {velocity:e}"
        );
    }
}

/// SPIN-ROCK-SIZE: a block at the arm l from a pivot that stands still spins at s about z, and rocks by b = B sin Wt about its x axis.
/// Its position is C l, its velocity C (ω×l), and it senses ω'×l + ω×(ω×l); ω = (b', s sin b, s cos b).
const ARM: Vector3<f64> = Vector3::new(0.4, -0.7, 0.3);
const ROCK: f64 = 0.5;

fn rocking(t: f64) -> (f64, Vector3<f64>, Vector3<f64>) {
    let (sin, cos) = (SWING * t).sin_cos();
    let (b, b1, b2) = (ROCK * sin, ROCK * SWING * cos, -ROCK * SWING * SWING * sin);
    let rate = Vector3::new(b1, SPIN * b.sin(), SPIN * b.cos());
    (b, rate, Vector3::new(b2, SPIN * b1 * b.cos(), -SPIN * b1 * b.sin()))
}

fn spin_rock_size(t: f64) -> Motion {
    let (b, rate, _) = rocking(t);
    let q = about(Vector3::z(), SPIN * t) * about(Vector3::x(), b);
    Motion { q, v: q * rate.cross(&ARM), r: q * ARM }
}

/// By Gauss' rule of 5 nodes on 4 parts: its error for a tenth of a radian is far below rounding.
fn spin_rock_size_increment(from: f64, to: f64) -> Increment {
    let nodes = [
        (0.0, 128.0 / 225.0),
        (0.538_469_310_105_683, 0.478_628_670_499_366_5),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    let (half, mut sum) = ((to - from) / 8.0, Increment::ZERO);
    for part in 0..4 {
        let middle = from + f64::from(2 * part + 1) * half;
        for (node, weight) in nodes {
            for sign in if node == 0.0 { &[1.0][..] } else { &[1.0, -1.0] } {
                let (_, rate, change) = rocking(middle + sign * node * half);
                sum.angle += rate * (weight * half);
                sum.velocity += (change.cross(&ARM) + rate.cross(&rate.cross(&ARM))) * (weight * half);
            }
        }
    }
    sum
}

#[test]
fn spin_rock_size_is_followed_with_the_order_of_each_scheme() {
    assert_orders("SPIN-ROCK-SIZE", 0.1, (0, &["attitude", "velocity", "position"]), |scheme, n, h| {
        errors((scheme, n, h), 60.0, spin_rock_size, spin_rock_size_increment)
    });
}

/// GEN NAV: once around the Earth on a circle inclined by 60°, 8 km/s, while the body rolls and its nose swings: latitude,
/// longitude, height and all angles change. The host gives samples alone. The default options are of fourth order.
#[test]
fn gen_nav_goes_around_the_earth() {
    let place = about(Vector3::z(), 0.3) * about(Vector3::x(), FRAC_PI_2 / 3.0);
    let circle = Circle { radius_m: 6_400e3, speed_m_s: 8000.0, ..Circle::past(place, 0.0) };
    let state = |t: f64| {
        let swing = about(Vector3::z(), 0.5 * (0.02 * t).sin()) * about(Vector3::y(), 0.05 * t);
        let EarthFixedState { r_e, v_e, q_eb } = circle.state(t);
        EarthFixedState { r_e, v_e, q_eb: q_eb * swing.into_inner() }
    };
    let period_s = TAU * circle.radius_m / circle.speed_m_s;
    let flown = |rate_hz: f64| {
        let mut simulator = Simulator::new(&options_at(rate_hz)).unwrap();
        let count = (period_s * rate_hz).ceil() as u32;
        apart_on_the_way(&mut simulator, (0.0, count, rate_hz), state, sample_of)
    };
    let [coarse, fine] = [1.0, 2.0].map(flown);
    println!("GEN NAV, {period_s:.0} s: {coarse} at 1 Hz, {fine} at 2 Hz; 20 Hz: {}", flown(20.0));
    let slope = |of: fn(&Apart) -> f64| (of(&coarse) / of(&fine)).log2();
    for slope in [slope(|a| a.position_m), slope(|a| a.velocity_m_s), slope(|a| a.attitude_rad)] {
        assert!((slope - 4.0).abs() < 0.2, "{slope}: {coarse}; {fine}");
    }
}
