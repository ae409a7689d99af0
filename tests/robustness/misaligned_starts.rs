//! Starts with large misalignments: headings by 10° to 180°, levels by 30°.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use sins::earth::Earth;
use sins::earth::state::{BodyAxes, EarthFixedState, Navigation};
use sins::math::rotation_quaternion;
use sins::mechanization::{Frame, Scheme, VerticalMode};
use sins::sensors::InitialErrorParameters;
use sins::{ErrorSource, Options, Simulator};

use crate::support::orbits::{Apart, navigated};
use crate::support::{DEG, options_at, resting_sample};

/// The exact solution of an INS at rest that starts with another attitude. Its sensors sense constants, so the attitude is
/// exp(-W t) q0 exp(w t) in closed form. r'' = C f + g(r) - 2 W×r' is integrated by classical Runge-Kutta in steps of 0.1 s,
/// with an error of (1e-3 1/s · 0.1 s)⁴ of the acceleration.
fn exact(start: &EarthFixedState, started_off: Quaternion<f64>, seconds: u32) -> EarthFixedState {
    let earth = Earth::default();
    let w_e = Vector3::new(0.0, 0.0, earth.rate_rad_s);
    let unit = UnitQuaternion::new_unchecked;
    let f_b = unit(start.q_eb).inverse() * -earth.gravity(&start.r_e);
    let w_b = unit(start.q_eb).inverse() * w_e;
    let attitude = |t: f64| UnitQuaternion::new(-w_e * t) * unit(started_off) * UnitQuaternion::new(w_b * t);
    let acceleration = |t: f64, r: &Vector3<f64>, v: &Vector3<f64>| {
        attitude(t) * f_b + earth.gravity(r) - 2.0 * w_e.cross(v)
    };
    let (mut r, mut v, h) = (start.r_e, start.v_e, 0.1);
    for k in 0..seconds * 10 {
        let t = f64::from(k) * h;
        let a1 = acceleration(t, &r, &v);
        let v2 = v + a1 * (0.5 * h);
        let a2 = acceleration(t + 0.5 * h, &(r + v * (0.5 * h)), &v2);
        let v3 = v + a2 * (0.5 * h);
        let a3 = acceleration(t + 0.5 * h, &(r + v2 * (0.5 * h)), &v3);
        let v4 = v + a3 * h;
        let a4 = acceleration(t + h, &(r + v3 * h), &v4);
        r += (v + 2.0 * v2 + 2.0 * v3 + v4) * (h / 6.0);
        v += (a1 + 2.0 * a2 + 2.0 * a3 + a4) * (h / 6.0);
    }
    EarthFixedState { r_e: r, v_e: v, q_eb: attitude(f64::from(seconds) * h * 10.0).into_inner() }
}

/// Flies at rest from a start misaligned by `misalignment_n`: difference of the solution from the exact one, its position error
/// [m], and whether the error model is flagged.
fn off_exact(
    frame: Frame,
    scheme: Scheme,
    misalignment_n: Vector3<f64>,
    seconds: u32,
    rate_hz: f64,
) -> (Apart, f64, bool) {
    let options =
        Options { frame, scheme, vertical: VerticalMode::Free, error_model: true, ..options_at(rate_hz) };
    let mut simulator = Simulator::new(&options).unwrap();
    simulator.set_initial_errors(&InitialErrorParameters { misalignment_n, ..Default::default() }).unwrap();
    for k in 0..=seconds * rate_hz as u32 {
        simulator.push_sample(&resting_sample(f64::from(k) / rate_hz)).unwrap();
        simulator.step().unwrap();
    }
    let earth = Earth::default();
    let truth = simulator.truth().unwrap().unwrap().navigation;
    let off_nb = rotation_quaternion(&-misalignment_n) * truth.q_nb;
    let off = Navigation::new(truth.place, truth.v_n, off_nb, BodyAxes::default());
    let expected = exact(&truth.earth_fixed(&earth), off.earth_fixed(&earth).q_eb, seconds);
    let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
    let (_, model) = simulator.errors(ErrorSource::Model).unwrap().unwrap();
    (Apart::new(&navigated(&simulator), &expected), errors.position_n.norm(), model.outside_validity)
}

/// The navigation errs exactly as the laws of motion require, over tens of kilometres. The error model, which is linear,
/// reports whether it is outside its validity.
#[test]
fn large_misalignments_are_navigated_right_and_flagged() {
    let degrees = |east: f64, north: f64, up: f64| Vector3::new(east, north, up) * DEG;
    let mut figures = Vec::new();
    for (what, misalignment_n, seconds) in [
        ("heading off by 10°", degrees(0.0, 0.0, 10.0), 1200),
        ("heading off by 90°", degrees(0.0, 0.0, 90.0), 1200),
        ("heading off by 180°", degrees(0.0, 0.0, 180.0), 1200),
        ("level off by 30°", degrees(30.0, 0.0, 0.0), 300),
        ("level off by -30°, heading by 120°", degrees(0.0, -30.0, 120.0), 300),
        ("level off by 0.1°", degrees(0.1, 0.0, 0.0), 300),
    ] {
        let (mut worst_m, mut way_m) = (0.0_f64, 0.0_f64);
        for (frame, scheme) in [
            (Frame::EarthFixed, Scheme::Exact),
            (Frame::Geographic, Scheme::Exact),
            (Frame::EarthFixed, Scheme::Polynomial),
        ] {
            let fly = |rate_hz: f64| off_exact(frame, scheme, misalignment_n, seconds, rate_hz);
            let ((coarse, ..), (apart, off_truth_m, is_flagged)) = (fly(5.0), fly(10.0));
            println!(
                "{what}, {frame:?}, {scheme:?}, {seconds} s: {:.3} km off truth, {apart} off the exact solution",
                off_truth_m / 1e3
            );
            // Second order: gravity at the mean position of an update exceeds its mean by 1.5 g (v T)²/12 R². The coordinates
            // add 2 nm of rounding; both errors grow by e in 569 s.
            let growth = (f64::from(seconds) / 569.0).cosh();
            assert!(
                apart.position_m < coarse.position_m / 3.5 + 1e-8 * growth,
                "{apart}, at half the rate {coarse}"
            );
            let speed = 2.0 * off_truth_m / f64::from(seconds);
            let extra = 1.5 * 9.8 * (speed / 10.0 / 6.37e6).powi(2) / 12.0;
            let bound = extra * f64::from(seconds).powi(2) * growth + 1e-8 * growth;
            assert!(apart.position_m < bound, "{apart} of {bound:e}");
            assert!(apart.attitude_rad < 1e-12, "{apart}");
            assert_eq!(is_flagged, misalignment_n.norm() > 0.035, "{what}");
            (worst_m, way_m) = (worst_m.max(apart.position_m), way_m.max(off_truth_m));
        }
        figures.push(format!("{worst_m:.1e} m in {:.0} km", way_m / 1e3));
    }
    // The starts with one large angle.
    println!("figure: {}", figures[..4].join(", "));
}
