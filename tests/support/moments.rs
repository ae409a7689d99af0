//! The calls of a host as a list, and everything that it can read after each call.

use nalgebra::{Matrix3, Vector3};
use sins::earth::state::Navigation;
use sins::errors::correction::Correction;
use sins::sensors::{
    Alignment, AltimeterParameters, Failure, GravityDisturbanceParameters, InitialErrorParameters, Sensor,
    SensorOutput, TriadParameters,
};
use sins::signal::Increment;
use sins::signal::mounting::MountingParameters;
use sins::truth::FlightSample;
use sins::{ErrorSource, Simulator};

use super::{Table, one_unit_of_each, patrol};

/// One call of a host.
#[derive(Clone)]
pub enum Call {
    Push(FlightSample),
    Step,
    Gyro(TriadParameters),
    Accel(TriadParameters),
    Altimeter(AltimeterParameters),
    Initial(InitialErrorParameters),
    Mounting(MountingParameters),
    Gravity(GravityDisturbanceParameters),
    Failure(SensorOutput, Option<Failure>),
    Reposition(FlightSample),
    MoveTruth(FlightSample),
    MoveTime(f64),
    Reset,
    Start(f64, Box<Navigation>),
    Imu(Vec<Increment>, f64),
    Correct(Box<Correction>),
}

impl Call {
    /// Makes the call and returns its answer as text.
    pub fn make(&self, simulator: &mut Simulator) -> String {
        match self {
            Self::Push(sample) => format!("{:?}", simulator.push_sample(sample)),
            Self::Step => format!("{:?}", simulator.step()),
            Self::Gyro(parameters) => format!("{:?}", simulator.set_gyro(parameters)),
            Self::Accel(parameters) => format!("{:?}", simulator.set_accel(parameters)),
            Self::Altimeter(parameters) => format!("{:?}", simulator.set_altimeter(parameters)),
            Self::Initial(parameters) => format!("{:?}", simulator.set_initial_errors(parameters)),
            Self::Mounting(parameters) => format!("{:?}", simulator.set_mounting(parameters)),
            Self::Gravity(parameters) => format!("{:?}", simulator.set_gravity_disturbance(parameters)),
            Self::Failure(output, failure) => format!("{:?}", simulator.set_failure(*output, *failure)),
            Self::Reposition(sample) => format!("{:?}", simulator.reposition(sample)),
            Self::MoveTruth(sample) => format!("{:?}", simulator.move_truth(sample)),
            Self::MoveTime(time_s) => format!("{:?}", simulator.move_time(*time_s)),
            Self::Reset => {
                simulator.reset();
                "reset".to_owned()
            }
            Self::Start(time_s, navigation) => {
                format!("{:?}", simulator.start_navigation(*time_s, navigation))
            }
            Self::Correct(correction) => format!("{:?}", simulator.correct(correction)),
            Self::Imu(increments, interval_s) => format!("{:?}", simulator.push_imu(increments, *interval_s)),
        }
    }
}

/// Everything that can be read, as text that shows every bit of a finite number.
pub fn reads(simulator: &Simulator) -> String {
    format!(
        "{:?}",
        (
            simulator.options(),
            (simulator.intervals(), simulator.has_started(), simulator.waiting_samples()),
            (simulator.truth(), simulator.navigation(), simulator.imu()),
            (simulator.errors(ErrorSource::Navigation), simulator.errors(ErrorSource::Model)),
            (simulator.accuracy(), simulator.trim(), simulator.truth_summary(), simulator.compensation()),
            simulator.clone().covariance(),
        )
    )
}

pub fn snapshot(simulator: &Simulator) -> Vec<u8> {
    let mut bytes = vec![0; simulator.snapshot_size()];
    assert_eq!(simulator.save_snapshot(&mut bytes), Ok(bytes.len()));
    bytes
}

/// Gyros and accelerometers with every parameter different from 0, except for those of temperature.
pub fn every_effect() -> (TriadParameters, TriadParameters) {
    let three = |scale: f64| Vector3::new(1.0, -0.7, 0.4) * scale;
    let sizes = |scale: f64| three(scale).abs();
    let matrix = |scale: f64| Matrix3::new(1.0, 2.0, -3.0, 0.5, -1.0, 2.0, 3.0, 1.0, 0.2) * scale;
    let mut misalignment = matrix(1e-5);
    misalignment.set_diagonal(&Vector3::zeros());
    let of_scale = |u: f64, sensor: Sensor| TriadParameters {
        bias: three(u),
        bias_sigma: sizes(u),
        markov_sigma: sizes(u),
        markov_time_s: Vector3::new(100.0, 1.0, 0.01),
        random_walk: sizes(0.1 * u),
        rate_random_walk: sizes(1e-3 * u),
        ramp: three(1e-4 * u),
        flicker: sizes(0.3 * u),
        quantization: sizes(0.1 * u),
        scale_factor: three(1e-4),
        scale_factor_asymmetry: three(1e-5),
        scale_factor_nonlinearity: three(1e-6),
        misalignment,
        range: sizes(1e6 * u),
        bandwidth_hz: Vector3::new(20.0, 40.0, 90.0),
        dead_zone: sizes(0.01 * u),
        scale_factor_sigma: sizes(1e-4),
        misalignment_sigma: misalignment.abs(),
        ..one_unit_of_each(sensor, 1.0)
    };
    let gyro = TriadParameters { g_sensitivity: matrix(1e-9), ..of_scale(1e-5, Sensor::Gyro) };
    let accel = TriadParameters {
        lever_arm_m: matrix(0.02),
        vibration_rectification_s2_m: three(1e-6),
        ..of_scale(1e-3, Sensor::Accelerometer)
    };
    (gyro, accel)
}

pub fn altimeter() -> AltimeterParameters {
    AltimeterParameters {
        bias_m: 5.0,
        markov_sigma_m: 3.0,
        markov_time_s: 60.0,
        noise_m: 1.0,
        scale_factor: 1e-3,
        lag_s: 0.5,
    }
}

pub fn initial() -> InitialErrorParameters {
    let three = Vector3::new(1.0, -2.0, 0.5);
    InitialErrorParameters {
        position_n: three * 10.0,
        velocity_n: three * 0.1,
        misalignment_n: three * 1e-4,
        position_sigma_n: three.abs(),
        velocity_sigma_n: three.abs() * 0.01,
        misalignment_sigma_n: three.abs() * 1e-5,
        alignment: Alignment::LevelAndGyrocompass,
        alignment_s: 600.0,
    }
}

/// The calls that set every effect.
pub fn setting() -> Vec<Call> {
    let (gyro, accel) = every_effect();
    vec![Call::Gyro(gyro), Call::Accel(accel), Call::Altimeter(altimeter()), Call::Initial(initial())]
}

/// The calls that push and fly each sample.
pub fn flown(samples: impl IntoIterator<Item = FlightSample>) -> Vec<Call> {
    samples.into_iter().flat_map(|sample| [Call::Push(sample), Call::Step]).collect()
}

pub fn samples(count: usize, interval_s: f64) -> impl Iterator<Item = FlightSample> {
    let flight = patrol(1200.0);
    (0..count).map(move |k| flight.sample_at(300.0 + k as f64 * interval_s).unwrap())
}

pub fn loops(count: usize, host_signals: bool) -> impl Iterator<Item = FlightSample> {
    Table::packed("loop_truth.packed").samples(host_signals).into_iter().skip(1000).take(count)
}
