//! The error equations, term by term, against a finite-difference linearisation of the mechanization.

use nalgebra::{SVector, Vector3};
use sins::earth::GravityModel;
use sins::errors::NavigationErrors;
use sins::mechanization::{Frame, VerticalMode};
use sins::sensors::{InitialErrorParameters, TriadParameters};
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::{ErrorSource, Options, Simulator};

use crate::support::{DEG, options_at};

/// φ [rad], δv [m/s], δr [m].
type States = SVector<f64, 9>;

fn states(errors: &NavigationErrors) -> States {
    let mut x = States::zeros();
    x.fixed_rows_mut::<3>(0).copy_from(&errors.misalignment_n);
    x.fixed_rows_mut::<3>(3).copy_from(&errors.velocity_n);
    x.fixed_rows_mut::<3>(6).copy_from(&errors.position_n);
    x
}

/// A climb at 53° N: every velocity component, every force and every rate contributes.
fn flight() -> Flight {
    let start = FlightStart {
        latitude_rad: 53.0 * DEG,
        longitude_rad: -0.7,
        height_m: 3000.0,
        speed_m_s: 250.0,
        heading_rad: 0.4,
        pitch_rad: 0.05,
        ..Default::default()
    };
    let climb = Manoeuvre::Climb { duration_s: 40.0, height_change_m: 2000.0, ramp_s: 10.0 };
    Flight::new(&start, &[climb]).unwrap()
}

/// Data 2 and data 1 after `seconds` in the middle of the climb, from the start errors `start` (as [`States`]) with sensor
/// biases.
fn after(
    options: &Options,
    seconds: f64,
    start: &States,
    gyro: Vector3<f64>,
    accel: Vector3<f64>,
) -> (States, States) {
    let mut simulator = Simulator::new(options).unwrap();
    simulator.set_gyro(&TriadParameters { bias: gyro, ..Default::default() }).unwrap();
    simulator.set_accel(&TriadParameters { bias: accel, ..Default::default() }).unwrap();
    let parameters = InitialErrorParameters {
        misalignment_n: start.fixed_rows::<3>(0).into(),
        velocity_n: start.fixed_rows::<3>(3).into(),
        position_n: start.fixed_rows::<3>(6).into(),
        ..Default::default()
    };
    simulator.set_initial_errors(&parameters).unwrap();
    let flight = flight();
    for k in 0..=(seconds * 100.0) as u64 {
        simulator.push_sample(&flight.sample_at(10.0 + k as f64 / 100.0).unwrap()).unwrap();
        simulator.step().unwrap();
    }
    let read = |source| states(&simulator.errors(source).unwrap().unwrap().1);
    (read(ErrorSource::Navigation), read(ErrorSource::Model))
}

/// Resolution of each state in a central difference of two runs: rounding of attitude, of 250 m/s, of Earth-fixed metres.
const RESOLUTION: [f64; 3] = [4e-16, 2e-13, 2e-9];

/// Compares a column of the linearised mechanization with that of the error model. The bound is 1e-6 of the term and the
/// resolution of the difference. With `per_metre` it includes the effect over the time of a gravity gradient that is true to
/// 1e-6, and the cube of the displacement.
fn assert_column(label: &str, linearised: &States, model: &States, size: f64, per_metre: bool, seconds: f64) {
    for row in 0..9 {
        let gradient = 1e-6 * 1.6e-6 * seconds.powi(1 + row as i32 / 6) + (size / 6.4e6).powi(2);
        let gradient = if per_metre && row >= 3 { gradient } else { 0.0 };
        let bound = 1e-6 * model[row].abs() + 2.0 * RESOLUTION[row / 3] / size + gradient;
        let difference = (linearised[row] - model[row]).abs();
        assert!(
            difference <= bound,
            "{label}, row {row}: {} linearised {}, bound {bound:e}",
            model[row],
            linearised[row]
        );
    }
}

#[test]
fn every_term_is_that_of_the_linearised_mechanization() {
    let seconds = 2.0;
    let zero = Vector3::zeros();
    for gravity in [GravityModel::Normal, GravityModel::Somigliana] {
        for frame in [Frame::EarthFixed, Frame::Geographic] {
            let options = Options {
                vertical: VerticalMode::Free,
                error_model: true,
                frame,
                gravity,
                ..options_at(100.0)
            };
            let label = |column: usize| format!("{gravity:?} {frame:?} column {column}");
            // Start errors, so large that rounding is small and so small that their cubes are small.
            for column in 0..9 {
                let size = [1e-5, 0.1, 100.0][column / 3];
                let mut start = States::zeros();
                start[column] = size;
                let (plus, model) = after(&options, seconds, &start, zero, zero);
                let (minus, _) = after(&options, seconds, &-start, zero, zero);
                let mut linearised = (plus - minus) / (2.0 * size);
                let mut model = model / size;
                linearised[column] -= 1.0;
                model[column] -= 1.0;
                assert_column(&label(column), &linearised, &model, size, column >= 6, seconds);
            }
            // Sensor errors: x, y, z of gyros and accelerometers.
            for column in 0..6 {
                let size = [1e-5, 1e-2][column / 3];
                let mut bias = [zero; 2];
                bias[column / 3][column % 3] = size;
                let (plus, model) = after(&options, seconds, &States::zeros(), bias[0], bias[1]);
                let (minus, _) = after(&options, seconds, &States::zeros(), -bias[0], -bias[1]);
                assert_column(
                    &label(9 + column),
                    &((plus - minus) / (2.0 * size)),
                    &(model / size),
                    size,
                    false,
                    seconds,
                );
            }
        }
    }
}

/// Both forms are the same equations: with start errors and sensor errors at once they give the same states.
#[test]
fn earth_fixed_and_geographic_form_agree() {
    let start = States::from_row_slice(&[1e-4, -2e-4, 5e-4, 0.3, -0.2, 0.1, 50.0, -80.0, 10.0]);
    let (gyro, accel) = (Vector3::new(1e-6, 2e-6, -1e-6), Vector3::new(1e-3, -1e-3, 2e-3));
    for vertical in [VerticalMode::Free, VerticalMode::Damped, VerticalMode::FollowTruth] {
        let run = |frame| {
            let options = Options { vertical, error_model: true, frame, ..options_at(100.0) };
            after(&options, 20.0, &start, gyro, accel).1
        };
        let (earth_fixed, geographic) = (run(Frame::EarthFixed), run(Frame::Geographic));
        for row in 0..9 {
            // Runge-Kutta errs by (rate · T)⁴ of each state; the rates reach 0.02 rad/s.
            let scale = [1e-3, 1.0, 100.0][row / 3];
            let difference = (earth_fixed[row] - geographic[row]).abs();
            assert!(
                difference < 1e-9 * scale,
                "{vertical:?} row {row}: {} {}",
                earth_fixed[row],
                geographic[row]
            );
        }
    }
}

/// The error model follows the mode of the vertical channel: with height errors it agrees with error data 2.
#[test]
fn vertical_modes_are_one_system_in_both_error_data() {
    let start = States::from_row_slice(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 30.0]);
    let accel = Vector3::new(0.0, 0.0, 1e-3);
    for vertical in [VerticalMode::Free, VerticalMode::Damped, VerticalMode::FollowTruth] {
        for frame in [Frame::EarthFixed, Frame::Geographic] {
            let options = Options { vertical, error_model: true, frame, ..options_at(100.0) };
            let (navigation, model) = after(&options, 25.0, &start, Vector3::zeros(), accel);
            let difference = (navigation[8] - model[8]).abs();
            // Second order: δh²/R, and a thousandth of the quarter of a metre that 1e-3 m/s² make.
            assert!(
                difference < 30.0 * 60.0 / 6.4e6 + 1e-6,
                "{vertical:?} {frame:?}: {} {}",
                navigation[8],
                model[8]
            );
            if vertical == VerticalMode::FollowTruth {
                assert!(navigation[8].abs() < 1e-8 && model[8].abs() < 1e-8);
            }
        }
    }
}
