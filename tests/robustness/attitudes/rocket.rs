//! A rocket that spins 36° a sample, against the closed form of what each scheme misses.

use std::f64::consts::PI;

use nalgebra::{Complex, UnitQuaternion, Vector3};
use sins::earth::state::EarthFixedState;
use sins::earth::{Earth, Geodetic, navigation_axes};
use sins::mechanization::{Scheme, VerticalMode};
use sins::{Options, Simulator};

use crate::support::orbits::{Apart, about, navigated, sample_of};
use crate::support::{EARTH_RATE, options_at};

/// A rocket from rest: along a fixed axis in Earth-fixed axes at 50 g, spinning at 20 rev/s about this axis. At the start its
/// attitude is 0.1 rad off the local axes.
fn rocket(time_s: f64) -> EarthFixedState {
    let place = Geodetic { latitude_rad: 0.6, longitude_rad: 1.0, height_m: 100.0 };
    let earth = Earth::default();
    let (east, north, up) = earth.east_north_up(&place);
    let axis = (up + 0.5 * east + 0.2 * north).normalize();
    let acceleration = 50.0 * 9.806_65;
    let q_en = UnitQuaternion::new_normalize(navigation_axes(place.latitude_rad, place.longitude_rad));
    let off = about(Vector3::new(0.3, 1.0, 0.0), 0.1);
    EarthFixedState {
        r_e: earth.to_earth_fixed(&place) + axis * (0.5 * acceleration * time_s * time_s),
        v_e: axis * (acceleration * time_s),
        q_eb: (about(axis, 20.0 * 2.0 * PI * time_s) * q_en * off).into_inner(),
    }
}

/// Error that a scheme of `n` subsamples makes of a vector that is fixed in space while the body spins by `turn` = a [rad] in an
/// update, over the vector's length: of a force, and of a slow rate.
///
/// With x + iy across the spin, the vector in the body is e^(-iau), u = 0..1 over the update. Its integrals over the parts are
/// sensed. The truth is ∫ e^(iau) e^(-iau) du = 1.
fn missed_of_a_steady_vector(scheme: Scheme, n: usize, turn: f64) -> [f64; 2] {
    let turned = |u: f64| Complex::new((turn * u).cos(), (turn * u).sin());
    let ia = Complex::new(0.0, turn);
    // ∫ e^(-iau) du from 0 to u.
    let sensed = |u: f64| (Complex::from(1.0) - turned(-u)) / ia;
    if scheme == Scheme::Exact {
        assert_eq!(n, 2);
        let (sum, change) = (sensed(1.0), sensed(1.0) - sensed(0.5) * 2.0);
        // V + (1 - cos a)/a iV - (1 - sin a/a) V, plus coning and sculling 2/3 · a/2 i(V2 - V1); the force less a²/2 (V2 - V1)/3.
        let coning = change * ia / 3.0;
        let force =
            sum * Complex::new(turn.sin(), 1.0 - turn.cos()) / turn + coning - change * (turn * turn / 6.0);
        // The rotation vector's Jacobian across a turn a: (e^(ia) - 1)/(ia).
        let rate = (sum + coning) * (turned(1.0) - 1.0) / ia;
        return [(force - 1.0).norm_sqr().sqrt(), (rate - 1.0).norm_sqr().sqrt()];
    }
    // Integral of the polynomial through its values after each part (Lagrange), then integration by parts with Simpson's rule.
    let integral = |u: f64| {
        (0..=n).fold(Complex::from(0.0), |sum, k| {
            let others = (0..=n).filter(|&j| j != k);
            let weight: f64 = others.map(|j| (u * n as f64 - j as f64) / (k as f64 - j as f64)).product();
            sum + sensed(k as f64 / n as f64) * weight
        })
    };
    let steps = 1000;
    let mut area = Complex::from(0.0);
    for k in 0..=2 * steps {
        let weight = if k % (2 * steps) == 0 { 1.0 } else { f64::from(2 + k % 2 * 2) };
        let u = f64::from(k) / f64::from(2 * steps);
        area += turned(u) * integral(u) * (weight / f64::from(6 * steps));
    }
    let missed = (turned(1.0) * integral(1.0) - ia * area - 1.0).norm_sqr().sqrt();
    // Magnus' series to the sixth order drops B6/6! a^6 = a^6/30240; its quadrature and the generator each drop as much again.
    [missed, missed + 3.0 * turn.powi(6) / 30_240.0]
}

/// 20 rev/s under 50 g for 20 s, to 98 km and 9.8 km/s, at 200 Hz: 36° a sample. The spin is about the axis of the thrust. A scheme
/// errs in the shares of gravity and Coriolis across this axis, steady for 20 s, and in the Earth's rate, which tilts the 50 g.
#[test]
fn spin_of_20_revolutions_a_second_under_50_g() {
    let (end_s, thrust) = (20.0, 50.0 * 9.806_65);
    let metres = |m: f64| if m < 0.01 { format!("{m:.1e} m") } else { format!("{m:.2} m") };
    let mut figures = Vec::new();
    for (scheme, subsamples) in [(Scheme::Exact, 2), (Scheme::Polynomial, 2), (Scheme::Polynomial, 4)] {
        let options = Options { scheme, subsamples, vertical: VerticalMode::Free, ..options_at(200.0) };
        let mut simulator = Simulator::new(&options).unwrap();
        for k in 0..=4000 {
            let time_s = f64::from(k) / 200.0;
            simulator.push_sample(&sample_of(time_s, &rocket(time_s))).unwrap();
            simulator.step().unwrap();
        }
        let apart = Apart::new(&navigated(&simulator), &rocket(end_s));
        let [of_force, of_rate] = missed_of_a_steady_vector(scheme, subsamples, 20.0 * 2.0 * PI / 200.0);
        // The axis leans by atan |(0.5, 0.2)|. Coriolis grows with the speed: it counts a third in the second integral.
        let gravity = 9.8 * (0.29_f64 / 1.29).sqrt();
        let force = of_force * (gravity + 2.0 * EARTH_RATE * thrust * end_s / 3.0);
        let rate = of_rate * EARTH_RATE;
        let position_m = 0.5 * force * end_s.powi(2) + thrust * rate * end_s.powi(3) / 6.0;
        println!("20 rev/s, 50 g, 20 s: {scheme:?} {subsamples}: {apart} of {position_m:.1e} m");
        assert!(apart.attitude_rad < 1.1 * rate * end_s, "{apart} {:e}", rate * end_s);
        assert!(apart.position_m < 1.1 * position_m, "{apart} {position_m:e}");
        figures.push(format!("{} (theory {})", metres(apart.position_m), metres(position_m)));
    }
    println!("figure: {}", figures.join("; "));
}
