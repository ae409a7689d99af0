//! The scenes and their random errors.

use nalgebra::{SMatrix, Vector3};
use sins::sensors::{
    Alignment, AltimeterParameters, GravityDisturbanceParameters, GravityField, InitialErrorParameters,
    StreamKey, TriadParameters,
};
use sins::truth::flight::{Flight, FlightStart, Manoeuvre};
use sins::truth::{FlightSample, IntakeLimits};
use sins::{ErrorParameters, Options, Simulator};

use crate::support::{self, DEG, DEG_PER_HOUR, G};

const MICRO_G: f64 = 1e-6 * G;

/// All random errors, of navigation grade.
pub fn everything() -> ErrorParameters {
    let off_diagonal = |size| SMatrix::from_fn(|row, column| if row == column { 0.0 } else { size });
    let triad = |unit: f64, walk: f64| TriadParameters {
        bias_sigma: Vector3::new(1.0, 0.7, 1.3) * unit,
        markov_sigma: Vector3::new(0.5, 0.8, 0.3) * unit,
        markov_time_s: Vector3::new(300.0, 1000.0, 40.0),
        flicker: Vector3::new(0.6, 0.4, 0.5) * unit,
        rate_random_walk: Vector3::repeat(0.5 * unit / 60.0),
        random_walk: Vector3::repeat(walk),
        scale_factor_sigma: Vector3::new(10e-6, 5e-6, 8e-6),
        misalignment_sigma: off_diagonal(1e-5),
        ..Default::default()
    };
    let field = |sigma| GravityField { mean: 0.0, sigma, distance_m: 20e3 };
    ErrorParameters {
        gyro: triad(0.01 * DEG_PER_HOUR, 0.002 * DEG / 60.0),
        accel: triad(20.0 * MICRO_G, 10.0 * MICRO_G),
        altimeter: AltimeterParameters {
            markov_sigma_m: 10.0,
            markov_time_s: 600.0,
            noise_m: 1.0,
            ..Default::default()
        },
        initial: InitialErrorParameters {
            position_sigma_n: Vector3::new(5.0, 8.0, 10.0),
            velocity_sigma_n: Vector3::new(0.02, 0.03, 0.01),
            misalignment_sigma_n: Vector3::new(2e-5, 3e-5, 2e-4),
            ..Default::default()
        },
        gravity: GravityDisturbanceParameters {
            deflection_north: field(3e-5),
            deflection_east: field(2e-5),
            anomaly: field(3e-4),
        },
        ..Default::default()
    }
}

/// A flight, with the errors of its runs and of its covariance.
pub struct Scene {
    pub name: &'static str,
    pub samples: Vec<FlightSample>,
    pub setting: ErrorParameters,
    /// Errors that the covariance assumes: `setting`, unless the covariance is to be wrong.
    pub believed: ErrorParameters,
}

impl Scene {
    pub fn new(name: &'static str, samples: Vec<FlightSample>, setting: ErrorParameters) -> Self {
        Self { name, samples, setting, believed: setting }
    }

    /// A simulator with these errors.
    pub fn simulator(&self, errors: &ErrorParameters, covariance: bool) -> Simulator {
        let period_s = self.samples[1].time_s - self.samples[0].time_s;
        let is_polar = self.samples.iter().any(|sample| sample.place.latitude_rad > 89.8 * DEG);
        let options = Options {
            covariance,
            error_model: is_polar,
            intake: IntakeLimits { period_s: Some(period_s), ..IntakeLimits::default() },
            key: StreamKey { seed: 7, run: 0 },
            ..Options::default()
        };
        let mut simulator = Simulator::new(&options).unwrap();
        errors.set_to(&mut simulator).unwrap();
        simulator
    }
}

fn sampled(flight: &Flight, length_s: f64, period_s: f64) -> Vec<FlightSample> {
    let count = (length_s.min(flight.duration_s()) / period_s) as usize;
    (0..=count).map(|k| flight.sample_at(k as f64 * period_s).unwrap()).collect()
}

pub fn built_in(name: &str, length_s: f64, period_s: f64) -> Vec<FlightSample> {
    sampled(&sins::scene::builtin(name).unwrap().flight().unwrap(), length_s, period_s)
}

/// Straight legs, turns and climbs of a small aircraft.
fn drone() -> Flight {
    let start = FlightStart { latitude_rad: 0.8, height_m: 100.0, speed_m_s: 15.0, ..Default::default() };
    let turn = |heading_change_rad| Manoeuvre::Turn { heading_change_rad, bank_rad: 0.5, ramp_s: 0.5 };
    let climb = |height_change_m| Manoeuvre::Climb { duration_s: 20.0, height_change_m, ramp_s: 2.0 };
    let straight = Manoeuvre::Straight { duration_s: 10.0 };
    let legs = [straight, turn(3.0), climb(50.0), turn(-5.0), straight, climb(-40.0), turn(9.0), straight];
    Flight::new(&start, &[legs, legs].concat()).unwrap()
}

/// The scenes: patrol, aerobatics, airliner, pole passage, drone.
pub fn scenes(is_long: bool) -> Vec<Scene> {
    let everything = everything();
    let mut aligned = everything;
    aligned.initial.alignment = Alignment::LevelAndGyrocompass;
    aligned.initial.misalignment_sigma_n = Vector3::repeat(1e-6);
    let mut small = everything;
    (small.gyro.bias_sigma, small.gyro.random_walk) =
        (Vector3::repeat(5.0 * DEG_PER_HOUR), Vector3::repeat(0.1 * DEG / 60.0));
    (small.accel.bias_sigma, small.accel.random_walk) =
        (Vector3::repeat(1000.0 * MICRO_G), Vector3::repeat(50.0 * MICRO_G));
    let airliner = support::Table::csv("c_examples/flights/airliner_cruise.csv").samples(false);
    let airliner: Vec<_> = airliner.into_iter().step_by(5).collect();
    let patrol_s = if is_long { 48.0 * 3600.0 } else { 3600.0 };
    vec![
        Scene::new("patrol", built_in("patrol", patrol_s, 0.5), everything),
        Scene::new("patrol, aligned", built_in("patrol", 1200.0, 0.5), aligned),
        Scene::new("aerobatics", built_in("aerobatics", 600.0, 0.05), everything),
        Scene::new("airliner", airliner, everything),
        Scene::new("pole passage", built_in("over_the_pole", 3600.0, 0.5), everything),
        Scene::new("drone", sampled(&drone(), 600.0, 0.05), small),
    ]
}

/// Flights after alignments of a minute to half an hour with all random errors, of 2 hours or of 20 minutes.
pub fn aligned_scenes(is_long: bool) -> Vec<Scene> {
    let length_s = if is_long { 7200.0 } else { 1200.0 };
    [("patrol", 600.0), ("racetrack", 60.0), ("commuter", 1800.0)]
        .map(|(name, alignment_s)| {
            let mut aligned = everything();
            aligned.initial.alignment = Alignment::LevelAndGyrocompass;
            aligned.initial.alignment_s = alignment_s;
            aligned.initial.misalignment_sigma_n = Vector3::zeros();
            Scene::new(name, built_in(name, length_s, 0.5), aligned)
        })
        .into()
}
