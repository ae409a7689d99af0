//! Gravity beyond the normal field: perfect accelerometers sense it, the INS does not know it, both error data report it.

use nalgebra::Vector3;
use sins::earth::{Earth, Geodetic};
use sins::math::{Euler, rotate};
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::{
    Alignment, GravityDisturbanceParameters, GravityField, InitialErrorParameters, StreamKey, TriadParameters,
};
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use crate::support::{ARCSEC, DEG, MILLIGAL, options_at, patrol, resting_sample, step};

fn constant(xi: f64, eta: f64, anomaly: f64) -> GravityDisturbanceParameters {
    let field = |mean| GravityField { mean, ..Default::default() };
    GravityDisturbanceParameters {
        deflection_north: field(xi),
        deflection_east: field(eta),
        anomaly: field(anomaly),
    }
}

/// Fields of different correlation distances, without constant parts.
fn random() -> GravityDisturbanceParameters {
    let field = |sigma, distance_m| GravityField { mean: 0.0, sigma, distance_m };
    GravityDisturbanceParameters {
        deflection_north: field(8.0 * ARCSEC, 4e3),
        deflection_east: field(5.0 * ARCSEC, 2e3),
        anomaly: field(30.0 * MILLIGAL, 3e3),
    }
}

fn disturbed(options: &Options, parameters: &GravityDisturbanceParameters) -> Simulator {
    let mut simulator = Simulator::new(options).unwrap();
    simulator.set_gravity_disturbance(parameters).unwrap();
    simulator
}

/// Straight and level to the north along the meridian at height 0.
fn northward(speed_m_s: f64, interval_s: f64, count: u32) -> impl Iterator<Item = FlightSample> {
    let earth = Earth::default();
    let mut latitude_rad = 0.0f64;
    (0..count).map(move |k| {
        let place = Geodetic { latitude_rad, longitude_rad: 0.1, height_m: 0.0 };
        latitude_rad += speed_m_s * interval_s / earth.radii(latitude_rad.sin()).meridian_m;
        FlightSample {
            v_n: Some(Vector3::new(0.0, speed_m_s, 0.0)),
            ..FlightSample::at_rest(f64::from(k) * interval_s, place, Euler::default())
        }
    })
}

/// ξ, η, Δg that the ideal accelerometers sense on average in each interval: force with the disturbance less force without.
fn sensed(
    parameters: &GravityDisturbanceParameters,
    key: StreamKey,
    samples: impl Iterator<Item = FlightSample>,
) -> Vec<Vector3<f64>> {
    let options = Options { key, ..Options::default() };
    let (mut with, mut without) = (disturbed(&options, parameters), Simulator::new(&options).unwrap());
    let mut series = Vec::new();
    for sample in samples {
        step(&mut with, &sample);
        step(&mut without, &sample);
        if let (Some(with), Some(without)) = (with.imu(), without.imu()) {
            let force = (with.ideal.velocity - without.ideal.velocity) / with.interval_s;
            let g = Earth::default().gravity(&Earth::default().to_earth_fixed(&sample.place)).norm();
            series.push(Vector3::new(force.y / g, force.x / g, force.z));
        }
    }
    series
}

/// A resting INS that was not levelled takes the deflection for horizontal force g ξ: it swings about R ξ,
/// δr = R ξ (1 - cos ws t) on a sphere that does not turn. The Earth's rate (Foucault) turns the plane of the swing by
/// W sin L t. The ellipsoid's radius differs by 0.5 % from the sphere's, ws by half as much.
#[test]
fn a_deflection_at_rest_makes_a_schuler_oscillation() {
    let xi = 10.0 * ARCSEC;
    let place = Geodetic { latitude_rad: 0.0, longitude_rad: 2.0, height_m: 0.0 };
    let earth = Earth::default();
    let g = earth.gravity(&earth.to_earth_fixed(&place)).norm();
    let radius = earth.radii(0.0).meridian_m;
    let ws = (g / radius).sqrt();
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        let options = Options { frame, error_model: true, ..options_at(1.0) };
        let mut simulator = disturbed(&options, &constant(xi, 0.0, 0.0));
        for k in 0..=5064 {
            step(&mut simulator, &FlightSample::at_rest(f64::from(k), place, Euler::default()));
            if k == 0 || k % 100 != 0 {
                continue;
            }
            let (sin, cos) = (ws * f64::from(k)).sin_cos();
            for source in [ErrorSource::Navigation, ErrorSource::Model] {
                let (_, errors) = simulator.errors(source).unwrap().unwrap();
                // At the equator the north channel swings with the meridian's radius, without Foucault's turn. The 24 h
                // coupling of the tilt into azimuth and back is (W/ws)² = 0.35 % of the swing.
                let position = radius * xi * (1.0 - cos);
                let velocity = radius * xi * ws * sin;
                assert!(
                    (errors.position_n.y - position).abs() < 0.01 * radius * xi,
                    "{frame:?} {k} {errors:?}"
                );
                assert!((errors.velocity_n.y - velocity).abs() < 0.01 * radius * xi * ws, "{k} {errors:?}");
            }
        }
    }
}

/// Levelled on the true vertical, the INS leans by the deflection, φ = (-ξ, η), and its heading, found from the Earth rate, by
/// η tan L. The tilted accelerometers sense what the INS expects: no oscillation. The lean turns with W: it changes by |W φ| t
/// at the most, velocity and position by the integrals of g times this change.
#[test]
fn levelling_leans_with_the_plumb_line() {
    let (xi, eta) = (8.0 * ARCSEC, -5.0 * ARCSEC);
    let mut simulator =
        disturbed(&Options { error_model: true, ..options_at(1.0) }, &constant(xi, eta, 30.0 * MILLIGAL));
    simulator
        .set_initial_errors(&InitialErrorParameters {
            alignment: Alignment::LevelAndGyrocompass,
            ..Default::default()
        })
        .unwrap();
    let expected = Vector3::new(-xi, eta, eta * (39.9 * DEG).tan());
    for k in 0..=60 {
        step(&mut simulator, &resting_sample(f64::from(k)));
        let t = f64::from(k);
        // Rounding of attitude and position; 1e-3 for the plumb line's own curvature and the second order.
        let turn = 1.001 * 7.292_115e-5 * expected.norm() * t + 1e-12;
        for source in [ErrorSource::Navigation, ErrorSource::Model] {
            let (_, errors) = simulator.errors(source).unwrap().unwrap();
            assert!(
                (errors.misalignment_n - expected).norm() < turn + 2e-4 * xi,
                "{k} {errors:?} {expected:?}"
            );
            assert!(errors.velocity_n.norm() < 9.81 * (turn * t / 2.0) + 1e-7, "{k} {errors:?}");
            assert!(errors.position_n.norm() < 9.81 * turn * t * t / 6.0 + 1e-7, "{k} {errors:?}");
        }
    }
}

/// The ideal accelerometers sense (g η, g ξ, Δg) in local axes, in any attitude and mounting.
#[test]
fn the_ideal_force_contains_it() {
    let (xi, eta, anomaly) = (20.0 * ARCSEC, -12.0 * ARCSEC, 40.0 * MILLIGAL);
    let euler = Euler { roll: 0.4, pitch: -0.2, heading: 2.0 };
    let boresight = MountingParameters {
        boresight: Euler { roll: 0.3, pitch: 0.5, heading: 1.0 },
        ..MountingParameters::default()
    };
    for mounting in [MountingParameters::default(), boresight] {
        let (mut with, mut without) = (
            disturbed(&options_at(10.0), &constant(xi, eta, anomaly)),
            Simulator::new(&options_at(10.0)).unwrap(),
        );
        with.set_mounting(&mounting).unwrap();
        without.set_mounting(&mounting).unwrap();
        for k in 0..3 {
            let sample = FlightSample { euler, ..resting_sample(f64::from(k) * 0.1) };
            step(&mut with, &sample);
            step(&mut without, &sample);
        }
        let (imu, plain) = (with.imu().unwrap(), without.imu().unwrap());
        let force_s = (imu.ideal.velocity - plain.ideal.velocity) / imu.interval_s;
        let q_bs = sins::math::attitude_from_euler(&mounting.boresight);
        let q_nb = with.truth().unwrap().unwrap().navigation.q_nb;
        let force_n = rotate(&q_nb, &rotate(&q_bs, &force_s));
        let g = plain.ideal.velocity.norm() / plain.interval_s;
        // Rounding of g over an interval of 0.1 s.
        assert!((force_n - Vector3::new(g * eta, g * xi, anomaly)).norm() < 64.0 * f64::EPSILON * g / 0.1);
    }
}

/// Along the track the variance is σ² and the correlation exp(-d/D), over some 600 independent pieces. The mean square of n
/// independent values is within 4.4 standard deviations √(2/n) (1e-5), a mean product of two within 4.4 times √((1 + ρ²)/n).
#[test]
fn the_fields_are_gauss_markov_over_the_distance_flown() {
    const RUNS: u64 = 40;
    // Pieces that are 10 correlation distances apart, 4e4 m = 200 s, are independent to e^-10.
    const SPACING: usize = 200;
    let lags = [0usize, 2, 5, 10, 20];
    let parameters = random();
    let fields = [&parameters.deflection_north, &parameters.deflection_east, &parameters.anomaly];
    let mut sums = [[0.0; 5]; 3];
    let mut cross = [0.0; 3];
    let mut count = 0.0;
    for run in 0..RUNS {
        let series = sensed(&parameters, StreamKey { seed: 7, run }, northward(200.0, 1.0, 3200));
        for start in (0..3100).step_by(SPACING) {
            for (field, sums) in sums.iter_mut().enumerate() {
                for (sum, lag) in sums.iter_mut().zip(lags) {
                    *sum += series[start][field] * series[start + lag][field] / fields[field].sigma.powi(2);
                }
            }
            let x = Vector3::from_fn(|i, _| series[start][i] / fields[i].sigma);
            for (sum, product) in cross.iter_mut().zip([x.x * x.y, x.x * x.z, x.y * x.z]) {
                *sum += product;
            }
            count += 1.0;
        }
    }
    for (field, sums) in fields.iter().zip(sums) {
        for (lag, sum) in lags.iter().zip(sums) {
            // The sensed value is the mean of an interval's two ends: variance and correlation are those of this mean.
            let step = 200.0 / field.distance_m;
            let correlation = |intervals: f64| (-intervals.abs() * step).exp();
            let lag = *lag as f64;
            let expected = 0.5 * correlation(lag) + 0.25 * (correlation(lag - 1.0) + correlation(lag + 1.0));
            let variance = 0.5 + 0.5 * correlation(1.0);
            let bound = 4.4 * ((variance.powi(2) + expected.powi(2)) / count).sqrt();
            assert!((sum / count - expected).abs() < bound, "{lag}: {} {expected} {bound}", sum / count);
        }
    }
    for product in cross {
        assert!((product / count).abs() < 4.4 / count.sqrt(), "the fields are independent: {cross:?}");
    }
}

/// At rest the field does not change; at half the speed the same field takes twice the time.
#[test]
fn the_field_belongs_to_the_track() {
    // Rounding of a force of g, over an interval of a second.
    let rounding = 16.0 * f64::EPSILON * 9.8;
    let key = StreamKey::default();
    let at_rest = sensed(&random(), key, (0..50).map(|k| resting_sample(f64::from(k))));
    assert!(at_rest.iter().all(|sensed| (sensed - at_rest[0]).norm() < rounding));
    assert!(at_rest[0].norm() > 1e-6, "the field at rest is drawn");
    let fast = sensed(&random(), key, northward(200.0, 1.0, 200));
    let slow = sensed(&random(), key, northward(100.0, 2.0, 200));
    assert!(fast.iter().zip(&slow).all(|(fast, slow)| (fast - slow).norm() < rounding));
    assert!((fast[100] - fast[0]).norm() > 1e-6, "and it changes");
}

/// Over manoeuvres, also with a mounting, error data 1 includes the disturbance: both error data differ in second order.
#[test]
fn both_error_data_hear_of_it() {
    let flight = patrol(2400.0);
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        let options = Options { frame, error_model: true, ..options_at(50.0) };
        let mut simulator = disturbed(&options, &random());
        simulator
            .set_mounting(&MountingParameters {
                lever_arm_m: Vector3::new(0.0, 5.0, 1.0),
                boresight: Euler { heading: 1.0, ..Euler::default() },
                ..Default::default()
            })
            .unwrap();
        for k in 0..=30_000 {
            step(&mut simulator, &flight.sample_at(1000.0 + f64::from(k) / 50.0).unwrap());
        }
        let (_, data2) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
        let (_, data1) = simulator.errors(ErrorSource::Model).unwrap().unwrap();
        assert!(data2.position_n.norm() > 1.0, "{data2:?}");
        // Products of errors: 1e-4 rad of misalignment; and 1e-3 of the step's own noise.
        assert!(
            (data1.position_n - data2.position_n).norm() < 2e-3 * data2.position_n.norm(),
            "{data1:?} {data2:?}"
        );
        assert!(
            (data1.velocity_n - data2.velocity_n).norm() < 2e-3 * data2.velocity_n.norm(),
            "{data1:?} {data2:?}"
        );
    }
}

/// The trim of the closed loop holds the error-free navigator, which uses normal gravity: the trim is the same to the bit, and
/// does not remove the disturbance. It moves the navigator by at most a t²/2.
#[test]
fn the_closed_loop_leaves_it_alone() {
    let seconds = 1200;
    let fly = |options: &Options, xi: f64| {
        let mut simulator = disturbed(options, &constant(xi, 0.0, 0.0));
        for k in 0..=seconds {
            step(&mut simulator, &resting_sample(f64::from(k)));
        }
        let trim = simulator.trim().unwrap().unwrap();
        (simulator.errors(ErrorSource::Navigation).unwrap().unwrap().1.position_n, trim)
    };
    let closed_loop = Options { closed_loop_time_s: Some(30.0), ..options_at(1.0) };
    let (open, _) = fly(&options_at(1.0), 10.0 * ARCSEC);
    let (closed, trim) = fly(&closed_loop, 10.0 * ARCSEC);
    let (_, plain_trim) = fly(&closed_loop, 0.0);
    assert_eq!(trim, plain_trim);
    assert!(open.norm() > 200.0, "R ξ = 310 m, and a quarter of a period");
    assert!((closed - open).norm() < trim.force_m_s2 * f64::from(seconds).powi(2), "{open:?} {closed:?}");
}

/// A disturbance of zero changes nothing, to the bit. No other draw moves. A reset restarts the field, a reposition continues it.
#[test]
fn zero_is_off_and_streams_are_its_own() {
    let flight = Flight::new(
        &FlightStart { speed_m_s: 200.0, height_m: 1000.0, ..Default::default() },
        &[Manoeuvre::Straight { duration_s: 60.0 }],
    )
    .unwrap();
    let samples: Vec<FlightSample> = (0..60).map(|k| flight.sample_at(f64::from(k)).unwrap()).collect();
    let noisy = |parameters: Option<&GravityDisturbanceParameters>| {
        let mut simulator = Simulator::new(&options_at(1.0)).unwrap();
        let noise = TriadParameters { random_walk: Vector3::repeat(1e-4), ..Default::default() };
        simulator.set_accel(&noise).unwrap();
        if let Some(parameters) = parameters {
            simulator.set_gravity_disturbance(parameters).unwrap();
        }
        simulator
    };
    let fly = |simulator: &mut Simulator| {
        for sample in &samples {
            step(simulator, sample);
        }
        (simulator.imu().unwrap(), simulator.navigation().unwrap().unwrap())
    };
    let plain = fly(&mut noisy(None));
    assert_eq!(fly(&mut noisy(Some(&GravityDisturbanceParameters::default()))), plain);
    // A field of size zero is absent, whatever its correlation distance.
    let distance_alone = GravityField { distance_m: 1e4, ..Default::default() };
    let none = GravityDisturbanceParameters { anomaly: distance_alone, ..Default::default() };
    assert_eq!(fly(&mut noisy(Some(&none))), plain);

    let mut simulator = noisy(Some(&random()));
    let first = fly(&mut simulator);
    let error = |imu: &sins::ImuInterval| imu.measured.velocity - imu.ideal.velocity;
    assert!((error(&first.0) - error(&plain.0)).norm() < 8.0 * f64::EPSILON * 9.8, "the noise is the same");
    assert!((first.0.ideal.velocity - plain.0.ideal.velocity).norm() > 1e-6);
    simulator.reset();
    assert_eq!(fly(&mut simulator), first);

    // The field continues from its last value: at rest at this place it is the same, the noise is not.
    let mut simulator = disturbed(&options_at(1.0), &random());
    let there = fly(&mut simulator).0;
    let last = samples[samples.len() - 1];
    simulator.reposition(&last).unwrap();
    step(&mut simulator, &flight.sample_at(60.0).unwrap());
    let here = simulator.imu().unwrap();
    let mean = |imu: &sins::ImuInterval| imu.ideal.velocity / imu.interval_s;
    // 200 m further on, the fields of 2 to 4 km have changed by √(2 · 200/2000) = 0.45 standard deviations of 4e-4 m/s² at most.
    assert!((mean(&here) - mean(&there)).norm() < 4.0 * 0.45 * 6e-4);
}

#[test]
fn what_cannot_be_is_refused() {
    let mut simulator = Simulator::new(&Options::default()).unwrap();
    let refused = |simulator: &mut Simulator, parameters: &GravityDisturbanceParameters| {
        simulator.set_gravity_disturbance(parameters).unwrap_err()
    };
    let mut parameters = random();
    parameters.deflection_east.distance_m = 0.0;
    assert_eq!(
        refused(&mut simulator, &parameters).to_string(),
        "gravity.deflection_east_distance_m = 0: must be from 1 to 1e9"
    );
    assert_eq!(
        refused(&mut simulator, &constant(0.0, 0.0, 1.0)).to_string(),
        "gravity.anomaly_m_s2 = 1: must be from -0.1 to 0.1"
    );
    for k in 0..2 {
        step(&mut simulator, &resting_sample(f64::from(k)));
    }
    assert_eq!(refused(&mut simulator, &random()).kind, ErrorKind::BadState);
    assert!(simulator.options().vertical == VerticalMode::Damped);
}
