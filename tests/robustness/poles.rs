//! Poles: passages at every distance, rest, spin and take-off there, and the limit of the geographic axes.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{UnitQuaternion, Vector3};
use sins::earth::Earth;
use sins::earth::state::EarthFixedState;
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::InitialErrorParameters;
use sins::truth::IntakeLimits;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use crate::support::orbits::{Apart, Circle, about, apart_on_the_way, navigated, sample_at, sample_of};
use crate::support::{self, options_at};

fn poles() -> [(&'static str, UnitQuaternion<f64>); 2] {
    [("north pole", UnitQuaternion::identity()), ("south pole", about(Vector3::x(), PI))]
}

/// 200 km of a circle at 20 Hz, with the recommended options: the worst on the way, and the velocity errors' root mean square.
fn passage(circle: &Circle) -> (Apart, f64) {
    let options = Options { vertical: VerticalMode::Damped, ..options_at(20.0) };
    let mut simulator = Simulator::new(&options).unwrap();
    let mut worst = Apart::default();
    for k in -8000..=8000 {
        let time_s = f64::from(k) / 20.0;
        let exact = circle.state(time_s);
        simulator.push_sample(&circle.sample(time_s)).unwrap();
        simulator.step().unwrap();
        let found = Apart::new(&navigated(&simulator), &exact);
        worst = worst.worst(found);
        let (_, errors) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
        // 2 nm each: rounding of the coordinates in the sample and in the solution.
        assert!((errors.position_n.norm() - found.position_m).abs() < 4e-9, "{}", errors.position_n);
        assert!(errors.velocity_n.norm().is_finite() && errors.misalignment_n.norm() <= PI);
        let near = exact.r_e.xy().norm() < 20e3;
        let solutions = [simulator.truth(), simulator.navigation()].map(|read| read.unwrap().unwrap());
        assert!(solutions.iter().all(|solution| solution.near_pole == near), "{time_s}");
    }
    (worst, simulator.accuracy().unwrap().unwrap().1.velocity_rms_n.norm())
}

/// Position, velocity and attitude in Earth-fixed axes are as good at each distance from either pole as at 45° north. The attitude
/// is composed of the quaternion and the longitude as read, so these two still belong together at the pole itself.
#[test]
fn a_pole_is_passed_at_any_distance_as_45_degrees_are() {
    let (elsewhere, rms) = passage(&Circle::past(about(Vector3::y(), 0.8), 0.0));
    println!("45 degrees: {elsewhere}; root mean square {rms:.1e} m/s");
    let (mut largest, mut largest_rms) = (Apart::default(), 0.0_f64);
    for (name, place) in poles() {
        for offset_m in [100e3, 1e3, 100.0, 10.0, 1.0, 1e-3, 0.0] {
            let (worst, rms) = passage(&Circle::past(place, offset_m));
            println!("{name} by {offset_m} m: {worst}; root mean square {rms:.1e} m/s");
            assert!(worst.position_m < 1.5 * elsewhere.position_m, "{name} {offset_m} {worst}");
            assert!(worst.velocity_m_s < 1.5 * elsewhere.velocity_m_s, "{name} {offset_m} {worst}");
            assert!(worst.attitude_rad < 16.0 * f64::EPSILON, "{name} {offset_m} {worst}");
            // Outside of 20 km from the pole, east turns by no more than the position error over this distance.
            assert!(rms < 1.5 * elsewhere.velocity_m_s, "{name} {offset_m} {rms}");
            largest = largest.worst(worst);
            largest_rms = largest_rms.max(rms);
        }
    }
    println!(
        "figure: {largest} at each distance; {:.1e} m at 45° north; {largest_rms:.1e} m/s",
        elsewhere.position_m
    );
}

/// Exactly on the pole, at rest and spinning at 30 °/s. The host's longitude differs in each sample.
#[test]
fn rest_and_spin_at_a_pole() {
    let earth = Earth::default();
    let mut largest = Apart::default();
    for sign in [1.0, -1.0] {
        for spin in [0.0, 30f64.to_radians()] {
            let state = |time_s: f64| EarthFixedState {
                r_e: Vector3::new(0.0, 0.0, sign * (earth.polar_radius_m + 2800.0)),
                v_e: Vector3::zeros(),
                q_eb: (about(Vector3::z(), spin * time_s) * about(Vector3::new(1.0, 0.3, 0.0), 0.2))
                    .into_inner(),
            };
            let sample = |time_s: f64, exact: &EarthFixedState| {
                sample_at(time_s, exact, sign * FRAC_PI_2, (time_s * 300.0).sin() * 3.0)
            };
            let mut simulator = Simulator::new(&options_at(20.0)).unwrap();
            let worst = apart_on_the_way(&mut simulator, (0.0, 12_000, 20.0), state, sample);
            println!("pole {sign}, spin {spin:.2} rad/s, 10 min: {worst}");
            // An ulp of angles up to 3 rad a sample, different each time: √12000 of them. Gravity turns by this error, half
            // of g t².
            assert!(worst.attitude_rad < 2.0 * 12_000f64.sqrt() * f64::EPSILON, "{worst}");
            assert!(worst.position_m < 0.5 * 9.83 * 600.0 * 600.0 * 16.0 * f64::EPSILON, "{worst}");
            assert!(simulator.navigation().unwrap().unwrap().near_pole);
            largest = largest.worst(worst);
        }
    }
    println!("figure: {:.1e} m, {:.1e} rad", largest.position_m, largest.attitude_rad);
}

/// From rest on the pole into the air, and on.
#[test]
fn take_off_from_a_pole() {
    let mut largest_m: f64 = 0.0;
    for latitude_rad in [FRAC_PI_2, -FRAC_PI_2] {
        let start = FlightStart {
            latitude_rad,
            longitude_rad: 1.0,
            heading_rad: 0.5,
            pitch_rad: 0.05,
            ..Default::default()
        };
        let manoeuvres = [
            Manoeuvre::Rest { duration_s: 60.0 },
            Manoeuvre::Accelerate { duration_s: 40.0, speed_change_m_s: 90.0 },
            Manoeuvre::Climb { duration_s: 120.0, height_change_m: 1500.0, ramp_s: 10.0 },
            Manoeuvre::Straight { duration_s: 380.0 },
        ];
        let flight = Flight::new(&start, &manoeuvres).unwrap();
        let mut simulator = Simulator::new(&options_at(50.0)).unwrap();
        let worst = support::fly(
            &mut simulator,
            (0..=30_000).map(|k| flight.sample_at(f64::from(k) / 50.0).unwrap()),
            1,
        );
        println!("take-off at {latitude_rad:.2}: {:.1e} m", worst.position_m);
        // The climb's ramp at 10 s and 1.5 m/s² is a thousandth of what a cubic can do at 50 Hz; a cubic's own is below 1e-8 m/s.
        assert!(worst.position_m < 1e-6, "{worst:?}");
        assert!(!simulator.truth().unwrap().unwrap().near_pole);
        largest_m = largest_m.max(worst.position_m);
    }
    println!("figure: {largest_m:.1e} m");
}

/// An INS with an error of a kilometre flies over the pole: both error data stay finite in metres, pass without a jump, and
/// agree except for second order. The differential equations are flagged where second order is no longer small.
#[test]
fn errors_in_metres_pass_over_the_pole() {
    let circle = Circle::past(UnitQuaternion::identity(), 0.0);
    let options = Options { error_model: true, ..options_at(20.0) };
    let mut simulator = Simulator::new(&options).unwrap();
    let initial = InitialErrorParameters {
        position_n: Vector3::new(700.0, -800.0, 0.0),
        velocity_n: Vector3::new(0.3, 0.4, 0.0),
        misalignment_n: Vector3::new(1e-5, -2e-5, 1e-4),
        ..Default::default()
    };
    simulator.set_initial_errors(&initial).unwrap();
    let (mut apart, mut jump, mut flagged): (f64, f64, u32) = (0.0, 0.0, 0);
    let mut before = None;
    for k in -8000..=8000 {
        let time_s = f64::from(k) / 20.0;
        simulator.push_sample(&circle.sample(time_s)).unwrap();
        simulator.step().unwrap();
        let read = |source| simulator.errors(source).unwrap().unwrap().1;
        let (navigation, model) = (read(ErrorSource::Navigation), read(ErrorSource::Model));
        let lengths = [navigation.position_n.norm(), model.position_n.norm()];
        apart = apart.max((navigation.position_n - model.position_n).norm());
        for (length, before) in lengths.iter().zip(before.unwrap_or(lengths)) {
            jump = jump.max((length - before).abs());
        }
        before = Some(lengths);
        let distance_m = circle.state(time_s).r_e.xy().norm();
        let turn = model.position_n.norm() / distance_m;
        assert!(turn < 0.0351 || model.outside_validity, "{time_s} {turn}");
        assert!(turn > 0.025 || !model.outside_validity, "{time_s} {turn}");
        flagged += u32::from(model.outside_validity);
        let others =
            [navigation.longitude_rad, model.longitude_rad, navigation.heading_rad, model.heading_rad];
        assert!(others.iter().all(|angle| angle.abs() <= PI));
        assert!(model.velocity_n.norm().is_finite() && model.misalignment_n.norm().is_finite());
    }
    println!("figure: {apart:.1} m apart, largest step {jump:.2} m");
    // Second order: the axes turn by 1.1 km over the 100 km to the pole at the start; half of its square at 250 m/s for 800 s.
    assert!(apart < 0.5 * (1.1e3 / 100e3_f64).powi(2) * 250.0 * 800.0, "{apart}");
    // The error grows by 2 m/s over an interval.
    assert!(jump < 2.0 / 20.0, "{jump}");
    assert!(flagged > 0);
}

/// The geographic axes are right to 2e-6 of the distance at which they pass a pole. They are refused where an update moves by 1 %
/// of the distance to the pole, or within 6.4 km.
#[test]
fn geographic_axes_give_up_before_they_lose_accuracy() {
    let mut figures = Vec::new();
    for (speed_m_s, rate_hz, updates) in [
        (250.0, 100.0, 1),
        (250.0, 20.0, 1),
        (250.0, 1.0, 1),
        (250.0, 1.0, 5),
        (8000.0, 20.0, 1),
        (8000.0, 1.0, 1),
    ] {
        let step_m = speed_m_s / rate_hz / f64::from(updates);
        let reach_m = f64::max(6.4e3, 100.0 * step_m);
        let mut largest_m: f64 = 0.0;
        for offset_m in [0.0, 0.9 * reach_m, 1.02 * reach_m, 2.0 * reach_m] {
            let circle = Circle { speed_m_s, ..Circle::past(UnitQuaternion::identity(), offset_m) };
            let options = Options {
                frame: Frame::Geographic,
                updates_per_sample: updates as usize,
                vertical: VerticalMode::FollowTruth,
                intake: IntakeLimits { period_s: Some(1.0 / rate_hz), ..Default::default() },
                ..Default::default()
            };
            let mut simulator = Simulator::new(&options).unwrap();
            let count = (3.0 * reach_m.max(40e3) / speed_m_s * rate_hz) as i32;
            let (mut worst, mut refused) = (Apart::default(), None);
            for k in -count..=count {
                let exact = circle.state(f64::from(k) / rate_hz);
                simulator.push_sample(&sample_of(f64::from(k) / rate_hz, &exact)).unwrap();
                if let Err(error) = simulator.step() {
                    assert_eq!(error.kind, ErrorKind::Singular, "{error}");
                    refused = Some(exact.r_e.xy().norm());
                    break;
                }
                worst = worst.worst(Apart::new(&navigated(&simulator), &exact));
            }
            println!(
                "{speed_m_s} m/s, {rate_hz} Hz, {updates} updates, past by {offset_m:.0} m: {worst}; refused at {refused:?} m"
            );
            assert!(worst.position_m < 2e-6 * offset_m.max(reach_m), "{worst}");
            largest_m = largest_m.max(worst.position_m);
            match refused {
                Some(at_m) => assert!(
                    offset_m < reach_m && (at_m - reach_m).abs() < 0.02 * reach_m + speed_m_s / rate_hz
                ),
                None => assert!(offset_m > reach_m),
            }
        }
        if updates == 1 {
            let reach_km = reach_m / 1e3;
            figures.push(format!("{largest_m:.1e} m at {speed_m_s} m/s, {rate_hz} Hz ({reach_km} km)"));
        }
    }
    println!("figure: {}", figures.join("; "));
}
