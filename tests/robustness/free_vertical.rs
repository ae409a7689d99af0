//! The free vertical channel: its time constant, its end, and the way back.

use nalgebra::Vector3;
use sins::earth::{Earth, Geodetic};
use sins::math::Euler;
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::truth::FlightSample;
use sins::{Error, ErrorKind, ErrorSource, Options, Simulator};

use crate::support::{self, options_at, resting_sample};

fn free(frame: Frame, rate_hz: f64) -> Options {
    Options { frame, vertical: VerticalMode::Free, ..options_at(rate_hz) }
}

/// On the pole, where Coriolis has no effect, a height error of 1 mm grows as cosh(t/τ), 1/τ² = upᵀ G up of the gravity
/// gradient G. The gradient is true to 1e-6 of itself; half of this error counts t/τ times.
#[test]
fn the_e_folding_time_is_that_of_the_gravity_gradient() {
    let earth = Earth::default();
    let place = Geodetic { latitude_rad: std::f64::consts::FRAC_PI_2, longitude_rad: 0.0, height_m: 0.0 };
    let gradient = earth.gravity_gradient(&earth.to_earth_fixed(&place))[(2, 2)];
    let tau_s = 1.0 / gradient.sqrt();
    let mut simulator = Simulator::new(&free(Frame::EarthFixed, 10.0)).unwrap();
    let position_n = Vector3::new(0.0, 0.0, 1e-3);
    let (mut apart, mut error_m) = (0.0, 0.0);
    simulator.set_initial_errors(&InitialErrorParameters { position_n, ..Default::default() }).unwrap();
    for k in 0..=72_000 {
        let time_s = f64::from(k) / 10.0;
        simulator.push_sample(&FlightSample::at_rest(time_s, place, Euler::default())).unwrap();
        simulator.step().unwrap();
        if k % 18_000 == 0 && k > 0 {
            let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
            let ratio = errors.position_n.z / (1e-3 * (time_s / tau_s).cosh());
            println!(
                "τ = {tau_s:.2} s, {time_s} s: {:.4e} m, {:.1e} from theory",
                errors.position_n.z,
                ratio - 1.0
            );
            // Rounding of 2 nm at the start is 2e-6 of 1 mm; height over radius, 150 m of 6.4e6, is the field's next order.
            let second_order = 1.5 * errors.position_n.z / 6.36e6;
            assert!((ratio - 1.0).abs() < 0.5e-6 * time_s / tau_s + 2e-6 + second_order, "{ratio}");
            (apart, error_m) = ((ratio - 1.0).abs(), errors.position_n.z);
        }
    }
    println!("figure: a fraction of {apart:.1e} in {error_m:.0} m, the next order of the field");
    assert!((tau_s - 569.3).abs() < 1.0, "{tau_s}");
}

/// Flies at rest from sample `from` on until a step is refused.
fn until_refused(simulator: &mut Simulator, from: u32) -> (u32, Error) {
    for k in from.. {
        simulator.push_sample(&resting_sample(f64::from(k))).unwrap();
        if let Err(error) = simulator.step() {
            return (k, error);
        }
        let solution = simulator.navigation().unwrap().unwrap().navigation;
        assert!(solution.place.height_m.is_finite() && solution.v_n.norm().is_finite());
        assert!(k < 100_000, "it has to end");
    }
    unreachable!()
}

/// Time at which a free channel reaches `height_m`, of either sign, after a `bias` [m/s²] from rest [s]. Where gravity falls with
/// the square of the distance, h'² = 2 g h²/(R + h) beyond the first metres, which are b τ² (cosh(t/τ) - 1) with τ² = R/(2g). With
/// x = h/R, s² = 1 + x this gives t = τ (ln(2h/(b τ²)) + 2 (s - 1) + ln(4 (s - 1)/((s + 1) x))).
fn time_to(height_m: f64, bias: f64, tau_s: f64, radius_m: f64) -> f64 {
    let x = height_m / radius_m;
    let s = (1.0 + x).sqrt();
    let of_cosh = (2.0 * height_m / (bias * tau_s * tau_s)).ln();
    tau_s * (of_cosh + 2.0 * (s - 1.0) + (4.0 * (s - 1.0) / ((s + 1.0) * x)).ln())
}

/// A microgram of bias ends the flight within hours, upward or downward, at the time of the theory. The step is refused before
/// anything overflows, the last good solution stays, to the bit, and both ways back lead to a normal run.
#[test]
fn the_end_is_told_and_both_ways_back_are_open() {
    let earth = Earth::default();
    let r_e = earth.to_earth_fixed(&resting_sample(0.0).place);
    let up_e = earth.east_north_up(&resting_sample(0.0).place).2;
    let tau_s = 1.0 / up_e.dot(&(earth.gravity_gradient(&r_e) * up_e)).sqrt();
    let size: f64 = 1e-5;
    let (mut ends_s, mut later) = ([0; 2], 0.0_f64);
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        for ((bias, limit_m), end_s) in [(size, 20e6), (-size, -500e3)].into_iter().zip(&mut ends_s) {
            let parameters = TriadParameters {
                bias: Vector3::new(0.0, 0.0, bias),
                // Relative to the bias the noise is 1e-7/(1e-5 √(2τ)): it moves the end by 0.2 s.
                random_walk: Vector3::repeat(1e-7),
                ..Default::default()
            };
            let fresh = || {
                let mut simulator = Simulator::new(&free(frame, 1.0)).unwrap();
                simulator.set_accel(&parameters).unwrap();
                simulator
            };
            let mut simulator = fresh();
            let (end, error) = until_refused(&mut simulator, 0);
            let last = simulator.navigation().unwrap().unwrap();
            let height_m = last.navigation.place.height_m;
            let expected_s = time_to(limit_m, bias, tau_s, r_e.norm());
            println!(
                "{frame:?}, bias {bias:e} m/s²: refused after {end} s of {expected_s:.0} s at {:.0} km: {error}",
                height_m / 1e3
            );
            assert_eq!(error.kind, ErrorKind::Diverged, "{error}");
            assert!(
                error.field.contains("height_m") && error.value.unwrap().as_f64().abs() > limit_m.abs(),
                "{error}"
            );
            // Coriolis turns the vertical motion to the west, and the motion to the west acts as weight: (2 W cos L)² of 2 g/R,
            // 0.2 % of the rate.
            assert!((f64::from(end) - expected_s).abs() < 2e-3 * expected_s + 1.0, "{end} {expected_s}");
            assert_eq!(last.time_s, f64::from(end) - 1.0);
            // One more step of 1 s would have exceeded the limit.
            let left_m = (limit_m - height_m) * bias.signum();
            let step_m = last.navigation.v_n.z * bias.signum() + 0.5 * support::G;
            assert!((0.0..step_m).contains(&left_m), "{left_m} of {step_m}");
            assert_eq!(simulator.step(), Err(error));
            assert_eq!(simulator.navigation().unwrap().unwrap(), last);
            assert!(last.vertical_unaided);
            let none = InitialErrorParameters::default();
            assert_eq!(simulator.set_initial_errors(&none).unwrap_err().kind, ErrorKind::BadState);

            let mut repositioned = simulator.clone();
            repositioned.reposition(&resting_sample(0.0)).unwrap();
            repositioned.set_initial_errors(&none).unwrap();
            let after = |simulator: &mut Simulator, from: u32| {
                for k in from..from + 100 {
                    simulator.push_sample(&resting_sample(f64::from(k))).unwrap();
                    simulator.step().unwrap();
                }
                (simulator.navigation().unwrap(), simulator.imu(), simulator.accuracy().unwrap())
            };
            after(&mut repositioned, 1);
            let (_, errors) = repositioned.errors(ErrorSource::Navigation).unwrap().unwrap();
            assert!(errors.position_n.norm() < 1.0, "{}", errors.position_n);

            simulator.reset();
            assert_eq!(after(&mut simulator, 0), after(&mut fresh(), 0));
            *end_s = end.max(*end_s);
            later = later.max(f64::from(end) / expected_s - 1.0);
        }
    }
    let [up_s, down_s] = ends_s;
    println!(
        "figure: reported after {up_s} s and {down_s} s of {size:e} m/s², up to {:.2} % later than theory without the \
         Coriolis term",
        later * 100.0
    );
}
