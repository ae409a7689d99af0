//! Errors in the mounting and the gravity that the INS assumes contribute their closed forms.

use nalgebra::Vector3;
use sins::analysis::budget::{BudgetRequest, ErrorParameters};
use sins::math::Euler;
use sins::mechanization::VerticalMode;
use sins::sensors::{GravityDisturbanceParameters, GravityField};
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorKind, Options};

use crate::support::budget::{HOUR_S, assert_like, at_rest, budget_of, row, sizes, sphere, worst};
use crate::support::{ARCSEC, MILLIGAL, options_at};

const LATITUDE_RAD: f64 = 0.7;
const HEADING_RAD: f64 = 1.0;
const SPEED_M_S: f64 = 180.0;

fn straight(seconds: u32, rate_hz: f64) -> Vec<FlightSample> {
    let start = FlightStart {
        latitude_rad: LATITUDE_RAD,
        speed_m_s: SPEED_M_S,
        heading_rad: HEADING_RAD,
        ..Default::default()
    };
    let flight = Flight::new(&start, &[Manoeuvre::Straight { duration_s: f64::from(seconds) }]).unwrap();
    let count = (f64::from(seconds) * rate_hz) as usize;
    (0..=count).map(|k| flight.sample_at(k as f64 / rate_hz).unwrap()).collect()
}

fn field(mean: f64) -> GravityField {
    GravityField { mean, ..Default::default() }
}

/// An hour at rest with a deflection of 10" in the meridian, and separately of 6" in the prime vertical: they act like
/// accelerometers that err by g ξ north, g η east.
#[test]
fn deflections_contribute_their_closed_forms() {
    let (xi, eta) = (10.0 * ARCSEC, 6.0 * ARCSEC);
    let gravity = GravityDisturbanceParameters {
        deflection_north: field(xi),
        deflection_east: field(eta),
        ..Default::default()
    };
    let parameters = ErrorParameters { gravity, ..Default::default() };
    let budget = budget_of(&options_at(10.0), &at_rest(HOUR_S, 10.0), &parameters, &Default::default());
    let zero = Vector3::zeros();
    let g = sphere(zero, zero).g;
    for (name, nabla) in
        [("north", Vector3::new(0.0, g * xi, 0.0)), ("east", Vector3::new(g * eta, 0.0, 0.0))]
    {
        let row = row(&budget, &format!("gravity.deflection_{name}_rad"));
        let alone = sphere(zero, nabla);
        let expected = worst(&alone);
        assert_like(&row.worst, &expected);
        let end = sizes(&alone, HOUR_S as f64);
        assert!((row.end.position_m - end.position_m).abs() < 5e-3 * expected.position_m, "{row:?}");
        assert!(!row.effect.is_random);
    }
    assert_eq!((budget.rows.len(), budget.runs, budget.flights), (2, 1, 4));
    // They add up, except for the second order: the tilt of one times the way of the other, and the reverse.
    let tilt = row(&budget, "gravity.deflection_north_rad").worst.attitude_rad;
    assert!(budget.remainder.position_m < 2.0 * tilt * budget.total.position_m, "{budget:?}");
}

/// Without an aid the height follows h'' = Δg + 2 g h/R, h = Δg t²/2 (1 + k t²/12 + ...) with k = 2 g/R = 3.1e-6 /s²: 9e-4
/// of it in a minute.
#[test]
fn an_anomaly_contributes_a_height() {
    let anomaly = 30.0 * MILLIGAL;
    let gravity = GravityDisturbanceParameters { anomaly: field(anomaly), ..Default::default() };
    let parameters = ErrorParameters { gravity, ..Default::default() };
    let options = Options { vertical: VerticalMode::Free, ..options_at(10.0) };
    let budget = budget_of(&options, &at_rest(60, 10.0), &parameters, &Default::default());
    let end = row(&budget, "gravity.anomaly_m_s2").end;
    assert!((end.position_m / (anomaly * 60.0 * 60.0 / 2.0) - 1.0).abs() < 1e-3, "{end:?}");
    assert!((end.velocity_m_s / (anomaly * 60.0) - 1.0).abs() < 2.5e-3, "{end:?}");
}

/// At the speed v the field has the correlation time T = D/v, so that var v = 2 (g σ T)² (t/T - 1 + e^{-t/T}) while Schuler's
/// cos 1.24e-3 t is 1 within 0.8 %. With N runs the 1σ is uncertain by 1/√(2N), of which four (6e-5) are allowed.
#[test]
fn a_random_deflection_contributes_its_closed_form() {
    let (sigma, correlation_s, t, runs) = (10.0 * ARCSEC, 20.0, 100.0, 200);
    let distance_m = correlation_s * SPEED_M_S;
    let random = GravityField { mean: 0.0, sigma, distance_m };
    let gravity = GravityDisturbanceParameters { deflection_east: random, ..Default::default() };
    let parameters = ErrorParameters { gravity, ..Default::default() };
    let request = BudgetRequest { runs, ..Default::default() };
    let budget = budget_of(&options_at(1.0), &straight(t as u32, 1.0), &parameters, &request);
    let row = row(&budget, "gravity.deflection_east_sigma_rad");
    let in_times = t / correlation_s;
    let g = sphere(Vector3::zeros(), Vector3::zeros()).g;
    let expected = g * sigma * correlation_s * (2.0 * (in_times - 1.0 + (-in_times).exp())).sqrt();
    let ratio = row.end.velocity_m_s / expected;
    println!("{ratio:.3} of the closed form");
    assert!((ratio - 1.0).abs() < 4.0 / (2.0 * runs as f64).sqrt() + 8e-3, "{ratio}");
    assert!(row.effect.is_random && budget.rows.len() == 1 && budget.runs == runs);
}

/// In straight flight a heading of the block that the INS assumes wrong by b turns the attitude by b. It also turns the place of
/// the reference point about the block, at the end of the true arm; an arm that is wrong by d moves it by d. The true mounting
/// has no row.
#[test]
fn a_mounting_contributes_as_it_is_believed() {
    let (b, arm) = (1e-3, 4.0);
    let wrong = Vector3::new(0.3, 0.4, 0.0);
    let mounting = MountingParameters {
        lever_arm_m: Vector3::new(0.0, arm, 0.0),
        boresight: Euler { roll: 0.0, pitch: 0.0, heading: 2.0 },
        lever_arm_error_m: wrong,
        boresight_error: Euler { heading: b, ..Euler::default() },
    };
    let parameters = ErrorParameters { mounting, ..Default::default() };
    let budget = budget_of(&options_at(50.0), &straight(60, 50.0), &parameters, &Default::default());
    let boresight = row(&budget, "mounting.boresight_error_rad").worst;
    // The vertical at the position that the INS finds leans by 4 m · b over the Earth's radius: 6e-10 rad.
    assert!((boresight.attitude_rad - b).abs() < 1e-9, "{boresight:?}");
    // The chord of b at the arm's end; the Earth's curvature and the mechanization's own error remain.
    assert!((boresight.position_m - 2.0 * arm * (0.5 * b).sin()).abs() < 1e-6, "{boresight:?}");
    let lever_arm = row(&budget, "mounting.lever_arm_error_m").worst;
    assert!((lever_arm.position_m - wrong.norm()).abs() < 1e-6, "{lever_arm:?}");
    // The local axes there are turned by (-n, e, e tan L)/R; the ellipsoid's radii differ by 0.5 % from the sphere's.
    let east = wrong.x * HEADING_RAD.cos() + wrong.y * HEADING_RAD.sin();
    let north = wrong.y * HEADING_RAD.cos() - wrong.x * HEADING_RAD.sin();
    let turned = north.hypot(east / LATITUDE_RAD.cos()) / sphere(Vector3::zeros(), Vector3::zeros()).r;
    assert!((lever_arm.attitude_rad / turned - 1.0).abs() < 5e-3, "{lever_arm:?}");
    assert_eq!((budget.rows.len(), budget.flights), (2, 4));
    // With the true mounting only the mechanization's own error is left.
    assert!(budget.own.0.position_m < 1e-6 && budget.own.0.attitude_rad < 1e-9, "{budget:?}");
    // The effect of both errors on each other: the wrong arm turned by b.
    let turned = 2.0 * wrong.norm() * (0.5 * b).sin();
    assert!((budget.remainder.position_m - turned).abs() < 1e-6, "{budget:?}");
}

#[test]
fn a_bad_field_is_named() {
    let mut parameters = ErrorParameters::default();
    parameters.mounting.lever_arm_error_m.y = 101.0;
    let error = parameters.validate().unwrap_err();
    assert_eq!((error.field, error.kind), ("mounting.lever_arm_error_m", ErrorKind::InvalidArgument));
    let mut parameters = ErrorParameters::default();
    parameters.gravity.anomaly.sigma = 1e-4;
    let error = parameters.validate().unwrap_err();
    assert_eq!((error.field, error.kind), ("gravity.anomaly_distance_m", ErrorKind::InvalidArgument));
}
