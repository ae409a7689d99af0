//! The paper's simulation 2: gyros of 0.01 °/h and 0.005 °/√h, accelerometers of 1e-5 g and 5e-6 g/√Hz, 48 h.

use nalgebra::{Complex, ComplexField, SMatrix, SVector, Vector3};
use sins::earth::Earth;
use sins::errors::NavigationErrors;
use sins::mechanization::Frame;
use sins::sensors::{TriadParameters, paper_simulation2};
use sins::truth::FlightSample;
use sins::{ErrorSource, Options, Simulator};

use crate::support::closed_form::{AtRest, W};
use crate::support::{self, DEG_PER_HOUR, G, options_at, patrol, resting_sample};

const LATITUDE: f64 = 39.9 * support::DEG;
const EPS: f64 = 0.01 * DEG_PER_HOUR;
const NABLA: f64 = 1e-5 * G;

/// Time [s], error data 2 and error data 1.
type Row = (f64, NavigationErrors, NavigationErrors);

fn fly(simulator: &mut Simulator, samples: impl Iterator<Item = FlightSample>, every: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    for (k, sample) in samples.enumerate() {
        simulator.push_sample(&sample).unwrap();
        simulator.step().unwrap();
        if k > 0 && k % every == 0 {
            let (time, navigation) = simulator.errors(ErrorSource::Navigation).unwrap().unwrap();
            rows.push((time, navigation, simulator.errors(ErrorSource::Model).unwrap().unwrap().1));
        }
    }
    rows
}

/// At rest nothing changes from sample to sample, so 10 Hz is enough.
fn at_rest(hours: f64, gyro: &TriadParameters, accel: &TriadParameters) -> Vec<Row> {
    let mut simulator = Simulator::new(&Options { error_model: true, ..options_at(10.0) }).unwrap();
    simulator.set_gyro(gyro).unwrap();
    simulator.set_accel(accel).unwrap();
    let samples = (0..=(hours * 36_000.0) as u64).map(|k| resting_sample(k as f64 / 10.0));
    fly(&mut simulator, samples, 600)
}

/// Constant errors alone. Level, heading north: sensor axes are east-north-up.
fn constant_errors() -> (TriadParameters, TriadParameters) {
    let gyro = TriadParameters { bias: Vector3::repeat(EPS), ..Default::default() };
    let accel = TriadParameters { bias: Vector3::new(NABLA, NABLA, 0.0), ..Default::default() };
    (gyro, accel)
}

/// Closed form on the sphere of the mean radius of curvature, with the gravity there.
fn closed_form() -> AtRest {
    let earth = Earth::default();
    let radii = earth.radii(LATITUDE.sin());
    let g = earth.gravity(&earth.to_earth_fixed(&resting_sample(0.0).place)).norm();
    on_sphere((radii.meridian_m * radii.transverse_m).sqrt(), g)
}

fn on_sphere(r: f64, g: f64) -> AtRest {
    AtRest { latitude_rad: LATITUDE, r, g, eps: Vector3::repeat(EPS), nabla: Vector3::new(NABLA, NABLA, 0.0) }
}

/// The closed form itself against its fixture, made with 50 digits.
#[test]
fn closed_form_gives_its_fixture() {
    let arcsec = support::DEG / 3600.0;
    for (hours, phi, velocity, position) in [
        (1.0, [7.3146, 8.6147, -4.7529], [0.233_981, -0.424_528], (None, -1307.602)),
        (48.0, [-7.0965, 7.9712, 5.7862], [0.593_954, -0.212_285], (Some(57_941.286), 73.850)),
    ] {
        let solution = on_sphere(6_374_390.0, 9.8015).after(hours * 3600.0);
        assert!((solution.phi / arcsec - Vector3::from(phi)).norm() < 2e-4, "{}", solution.phi / arcsec);
        let velocity = Complex::new(velocity[0], velocity[1]) - solution.velocity;
        assert!(velocity.modulus() < 1e-6, "{}", solution.velocity);
        assert!((solution.position.im - position.1).abs() < 1e-3, "{}", solution.position);
        assert!(position.0.is_none_or(|east: f64| (solution.position.re - east).abs() < 1e-3));
    }
}

/// The ellipsoid's radii differ by 0.2 % from the sphere's either way, the Schuler frequencies by 0.1 %, and an hour is
/// 4.5 rad of them: 0.5 % of the oscillation.
#[test]
fn both_error_data_follow_the_closed_form_for_an_hour() {
    let (gyro, accel) = constant_errors();
    let mut fastest: f64 = 0.0;
    for (time, navigation, model) in at_rest(1.0, &gyro, &accel) {
        let exact = closed_form().after(time);
        fastest = fastest.max(exact.velocity.modulus());
        for errors in [&navigation, &model] {
            let position = Complex::new(errors.position_n.x, errors.position_n.y) - exact.position;
            let velocity = Complex::new(errors.velocity_n.x, errors.velocity_n.y) - exact.velocity;
            assert!(position.modulus() < 5e-3 * exact.position.modulus() + 0.5, "{time}: {position}");
            assert!(velocity.modulus() < 5e-3 * fastest, "{time}: {velocity}");
            let misalignment = (errors.misalignment_n - exact.phi).norm();
            assert!(misalignment < 5e-3 * EPS * time, "{time}: {misalignment:e}");
        }
    }
}

/// x' = F x + u of the level channels at rest on the ellipsoid: φ, δvE, δvN, δL, δλ, and the constant 1.
fn system_at_rest() -> SMatrix<f64, 8, 8> {
    let earth = Earth::default();
    let (s, c) = LATITUDE.sin_cos();
    let radii = earth.radii(s);
    let (m, n) = (radii.meridian_m, radii.transverse_m);
    let sample = resting_sample(0.0);
    let g = earth.gravity(&earth.to_earth_fixed(&sample.place)).norm();
    let (wn, wu) = (W * c, W * s);
    let mut f = SMatrix::<f64, 8, 8>::zeros();
    let mut set = |row: usize, terms: &[(usize, f64)]| {
        terms.iter().for_each(|&(column, value)| f[(row, column)] = value)
    };
    set(0, &[(1, wu), (2, -wn), (4, -1.0 / m), (7, -EPS)]);
    set(1, &[(0, -wu), (3, 1.0 / n), (5, -wu), (7, -EPS)]);
    set(2, &[(0, wn), (3, s / c / n), (5, wn), (7, -EPS)]);
    set(3, &[(1, -g), (4, 2.0 * wu), (7, NABLA)]);
    set(4, &[(0, g), (3, -2.0 * wu), (7, NABLA)]);
    set(5, &[(4, 1.0 / m)]);
    set(6, &[(3, 1.0 / (n * c))]);
    f
}

/// e^A by scaling and squaring of its Taylor series.
fn exponential(a: &SMatrix<f64, 8, 8>) -> SMatrix<f64, 8, 8> {
    let halvings = 40;
    let small = a / 2f64.powi(halvings);
    // e^x - 1 is squared as (1 + y)² - 1 = 2y + y², which keeps its digits.
    let mut y = small + small * small / 2.0;
    for _ in 0..halvings {
        y = y * 2.0 + y * y;
    }
    SMatrix::identity() + y
}

/// 48 h on the ellipsoid: the error model is the exact solution of its equations, in both forms.
#[test]
fn error_model_is_the_matrix_exponential_for_48_h() {
    let (gyro, accel) = constant_errors();
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        let options = Options { error_model: true, frame, ..options_at(10.0) };
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.set_gyro(&gyro).unwrap();
        simulator.set_accel(&accel).unwrap();
        let samples = (0..=1_728_000_u64).map(|k| resting_sample(k as f64 / 10.0));
        let rows = fly(&mut simulator, samples, 36_000);
        let hour = exponential(&(system_at_rest() * 3600.0));
        let mut x = SVector::<f64, 8>::zeros();
        x[7] = 1.0;
        for (time, _, model) in rows {
            x = hour * x;
            let radii = Earth::default().radii(LATITUDE.sin());
            let phi = Vector3::new(x[0], x[1], x[2]);
            let north = x[5] * radii.meridian_m;
            let east = x[6] * radii.transverse_m * LATITUDE.cos();
            // The gradient of gravity is true to 1e-6, its phase over 217 rad to 1e-4 of the oscillation, 2.6 km.
            assert!(
                (model.misalignment_n - phi).norm() < 2e-8,
                "{time} {}",
                (model.misalignment_n - phi).norm()
            );
            assert!((model.position_n.y - north).abs() < 0.3, "{time}: {} {north}", model.position_n.y);
            assert!((model.position_n.x - east).abs() < 0.3, "{time}: {} {east}", model.position_n.x);
        }
    }
}

/// Products of the errors, which the linear model drops. Position: displacement over the Earth's radius and misalignment,
/// times displacement; velocity likewise with the Schuler rate, and the frames' turn times the speed.
fn second_order(errors: &NavigationErrors, speed_m_s: f64, largest_m: f64) -> (f64, f64) {
    let r = 6.37e6;
    let share = largest_m / r * (1.0 + LATITUDE.tan()) + errors.misalignment_n.norm();
    let schuler = (9.8 / r).sqrt();
    let angle = largest_m / r / LATITUDE.cos();
    (share * largest_m, share * largest_m * schuler + speed_m_s * angle * angle)
}

fn assert_agreement(rows: &[Row], speed_m_s: f64) {
    let mut largest: f64 = 1.0;
    for (time, navigation, model) in rows {
        largest = largest.max(navigation.position_n.norm());
        let (position, velocity) = second_order(navigation, speed_m_s, largest);
        let d_position = (navigation.position_n - model.position_n).norm();
        let d_velocity = (navigation.velocity_n - model.velocity_n).norm();
        assert!(d_position < position + 1e-3, "{time}: {d_position} m, second order {position}");
        assert!(d_velocity < velocity + 1e-5, "{time}: {d_velocity} m/s, second order {velocity}");
    }
}

#[test]
fn error_data_1_and_2_agree_to_second_order_at_rest() {
    let (gyro, accel) = paper_simulation2();
    let rows = at_rest(48.0, &gyro, &accel);
    assert_agreement(&rows, 0.0);
    // The errors are large enough for the comparison.
    assert!(rows.last().unwrap().1.position_n.norm() > 10e3);
}

#[test]
fn error_data_1_and_2_agree_to_second_order_on_the_patrol() {
    let (gyro, accel) = paper_simulation2();
    let hours = if cfg!(feature = "long-tests") { 48.0 } else { 4.0 };
    for frame in [Frame::EarthFixed, Frame::Geographic] {
        let options = Options { error_model: true, frame, ..options_at(100.0) };
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.set_gyro(&gyro).unwrap();
        simulator.set_accel(&accel).unwrap();
        let flight = patrol(hours * 3600.0);
        let samples = (0..(hours * 360_000.0) as u64).map(|k| flight.sample_at(k as f64 / 100.0).unwrap());
        let rows = fly(&mut simulator, samples, 6000);
        assert_agreement(&rows, 200.0);
    }
}

/// Magnitude of the Fourier transform of `values`, sampled each `dt`, at `frequency`, with a Hann window.
fn spectrum(values: &[Complex<f64>], dt: f64, frequency: f64) -> f64 {
    let n = values.len() as f64;
    let sum: Complex<f64> = values
        .iter()
        .enumerate()
        .map(|(k, value)| {
            let angle = -std::f64::consts::TAU * frequency * k as f64 * dt;
            let hann = 0.5 - 0.5 * (std::f64::consts::TAU * k as f64 / n).cos();
            value * hann * Complex::new(angle.cos(), angle.sin())
        })
        .sum();
    sum.modulus() / n
}

/// Frequency of the largest value of the spectrum between `from` and `to`.
fn peak(values: &[Complex<f64>], dt: f64, from: f64, to: f64) -> f64 {
    let step = 0.02 / (values.len() as f64 * dt);
    let count = ((to - from) / step) as usize;
    let at = |k: &usize| spectrum(values, dt, from + *k as f64 * step);
    let best = (0..=count).max_by(|a, b| at(a).total_cmp(&at(b))).unwrap();
    assert!(best > 0 && best < count, "the largest value lies at the edge of the band");
    from + best as f64 * step
}

/// East + i north turns at -W sin L ± wf: the two lines' mean is Schuler's frequency, half their difference Foucault's.
/// Azimuth swings in 24 h. Each within the resolution of the record, one over its length.
#[test]
fn both_error_data_show_the_schuler_foucault_and_24_h_periods() {
    let hours = 96.0;
    let (gyro, accel) = paper_simulation2();
    let rows = at_rest(hours, &gyro, &accel);
    let dt = 60.0;
    let resolution = 1.0 / (hours * 3600.0);
    let tau = std::f64::consts::TAU;
    let schuler = (closed_form().g / closed_form().r + (W * LATITUDE.sin()).powi(2)).sqrt() / tau;
    let foucault = W * LATITUDE.sin() / tau;
    for source in [ErrorSource::Navigation, ErrorSource::Model] {
        let pick = |row: &Row| if source == ErrorSource::Navigation { row.1 } else { row.2 };
        let velocity: Vec<Complex<f64>> =
            rows.iter().map(|row| Complex::new(pick(row).velocity_n.x, pick(row).velocity_n.y)).collect();
        let positive = peak(&velocity, dt, 0.8 * schuler, 1.2 * schuler);
        let negative = -peak(&velocity, dt, -1.2 * schuler, -0.8 * schuler);
        assert!((0.5 * (positive + negative) - schuler).abs() < resolution, "Schuler {positive} {negative}");
        assert!(
            (0.5 * (negative - positive) - foucault).abs() < resolution,
            "Foucault {positive} {negative}"
        );
        assert!((60.0 / (0.5 * (positive + negative)) / 3600.0 - 84.4).abs() < 1.0, "in minutes");

        let azimuth: Vec<Complex<f64>> =
            rows.iter().map(|row| Complex::new(pick(row).misalignment_n.z, 0.0)).collect();
        let mean = azimuth.iter().sum::<Complex<f64>>() / azimuth.len() as f64;
        let azimuth: Vec<Complex<f64>> = azimuth.iter().map(|value| value - mean).collect();
        let day = peak(&azimuth, dt, 0.4 * W / tau, 3.0 * W / tau);
        assert!((day - W / tau).abs() < resolution, "24 h: {}", 1.0 / day / 3600.0);
    }
}
