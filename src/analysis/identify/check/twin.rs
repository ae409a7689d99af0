//! A twin: sensors that could be those of the record, as far as the fit knows them.

use nalgebra::{Matrix3, Vector3};
use rand_distr::Distribution;

use super::super::parameter::Place;
use super::super::{Estimate, Identified, NoiseEstimate, OFF, RecordedIncrement, SensorNoise, boresight};
use super::truth::Truth;
use super::{CheckRequest, TruthSigma};
use crate::base::error::Error;
use crate::base::math::{exp, ln, rotation_matrix, rotation_quaternion};
use crate::base::memory::room_for_one_more;
use crate::earth::state::StateErrors;
use crate::errors::correction::Correction;
use crate::sensors::{StandardNormal, StreamKey, TriadParameters, Xoshiro256PlusPlus};
use crate::signal::mounting::MountingParameters;
use crate::simulator::{Options, Simulator, Step};
use crate::truth::FlightSample;

/// Numbers of the streams of a twin.
const PARAMETERS_STREAM: u64 = 0;
const STARTS_STREAM: u64 = 1;
/// Samples before and behind the part that is checked.
const MARGIN: usize = 2;

/// Sensors that were drawn from the distribution of the fit.
pub(super) struct Twin {
    key: StreamKey,
    gyro: TriadParameters,
    accel: TriadParameters,
    rotation: Matrix3<f64>,
    /// Errors of the shift of the clock [s] and of its drift [1] that were found.
    clock_s: f64,
    drift: f64,
    truth: TruthSigma,
}

fn normal(stream: &mut Xoshiro256PlusPlus) -> f64 {
    StandardNormal.sample(stream)
}

impl Twin {
    /// Draws twin `run` for a part that begins at `begin_s` on the clock of the path [s].
    pub fn draw(found: &Identified, request: &CheckRequest, run: u64, begin_s: f64) -> Self {
        let key = StreamKey { seed: request.seed, run };
        let mut stream = key.host_stream(PARAMETERS_STREAM);
        let is_fitted = |k: usize| found.root[0][(k, k)] > 2.0 * OFF;
        let draw = |k: usize, _| if is_fitted(k) { normal(&mut stream) } else { 0.0 };
        let errors = found.root[0] * super::super::solve::Vector::from_fn(draw);
        // The biases walk on from the end of the fit.
        let gap_s = (begin_s - found.last_path_time_s()).max(0.0);
        let mut triad = |part: usize| {
            let estimate = [&found.gyro, &found.accel][part];
            let noise = [0, 1, 2].map(|axis| drawn_noise(&found.noise[3 * part + axis], &mut stream));
            let of = |which: usize| Vector3::from_fn(|axis, _| noise[axis][which]);
            let walked = Vector3::from_fn(|axis, _| {
                let (walk, on) = (&found.walks[3 * part + axis], noise[axis][2] * gap_s.sqrt());
                let sigma = (walk.sigma * walk.sigma + on * on).sqrt();
                walk.with(3 * part + axis, &errors) + sigma * normal(&mut stream)
            });
            let matrix = estimate.error_matrix()
                + Matrix3::from_fn(|row, column| errors[Place::element(part, row, column)]);
            TriadParameters {
                bias: estimate.biases()
                    + Vector3::from_fn(|axis, _| errors[Place::bias(part, axis)])
                    + walked,
                scale_factor: matrix.diagonal(),
                misalignment: matrix - Matrix3::from_diagonal(&matrix.diagonal()),
                scale_factor_asymmetry: Vector3::from_fn(|axis, _| {
                    drawn(&estimate.asymmetry[axis], errors[Place::asymmetry(part, axis)])
                }),
                bias_temperature: Vector3::from_fn(|axis, _| {
                    drawn(&estimate.bias_temperature[axis], errors[Place::bias_temperature(part, axis)])
                }),
                reference_temperature_c: found.reference_c.unwrap_or_default(),
                random_walk: of(0),
                flicker: of(1),
                rate_random_walk: of(2),
                ..Default::default()
            }
        };
        let (mut gyro, accel) = (triad(0), triad(1));
        gyro.g_sensitivity = Matrix3::from_fn(|row, column| {
            drawn(&found.g_sensitivity[row][column], errors[Place::g_sensitivity(row, column)])
        });
        let turn = Vector3::from_fn(|axis, _| errors[Place::mounting(axis)]);
        Self {
            key,
            gyro,
            accel,
            rotation: rotation_matrix(&rotation_quaternion(&turn)) * found.rotation,
            clock_s: errors[Place::CLOCK],
            drift: errors[Place::DRIFT],
            truth: request.truth,
        }
    }

    /// The record of the twin over the part `within` of the path [s].
    pub fn record(
        &self,
        truth: &Truth,
        found: &Identified,
        within: (f64, f64),
    ) -> Result<Vec<RecordedIncrement>, Error> {
        let options = Options { key: self.key, ..truth.options };
        let mut simulator = Simulator::new(&options)?;
        simulator.set_gyro(&self.gyro)?;
        simulator.set_accel(&self.accel)?;
        let boresight = boresight(&self.rotation, options.axes);
        simulator.set_mounting(&MountingParameters { boresight, ..Default::default() })?;
        let place = |time_s: f64| truth.samples.partition_point(|sample| sample.time_s < time_s);
        let first = place(within.0).saturating_sub(MARGIN + 1);
        let end = (place(within.1) + MARGIN).min(truth.samples.len());
        let mut record = Vec::new();
        for sample in &truth.samples[first..end] {
            let temperature_c = found.reference_c.and_then(|_| truth.path().temperature_c(sample.time_s));
            simulator.push_sample(&FlightSample { temperature_c, ..*sample })?;
            if simulator.step()? != Step::Done {
                continue;
            }
            let Some(imu) = simulator.imu() else { continue };
            let mut end_s = imu.time_s - imu.interval_s;
            let mut update = 0;
            while let Some((increments, update_s)) = simulator.measured_update(update) {
                let interval_s = update_s / increments.len() as f64;
                for increment in increments {
                    end_s += interval_s;
                    let time_s = found.record_time_s(end_s);
                    let time_s = time_s - self.clock_s - self.drift * (time_s - found.middle_s);
                    room_for_one_more(&mut record)?;
                    record.push(RecordedIncrement { time_s, interval_s, increment: *increment });
                }
                update += 1;
            }
        }
        Ok(record)
    }

    /// Errors of the truth at the start of flight number `flight`, as what is to be removed.
    pub fn start(&self, flight: u64) -> Correction {
        let mut stream = self.key.host_stream(STARTS_STREAM + flight);
        let TruthSigma { position_m, velocity_m_s, tilt_rad, heading_rad } = self.truth;
        let mut three = |sigmas: [f64; 3]| Vector3::from_fn(|axis, _| sigmas[axis] * normal(&mut stream));
        let errors = StateErrors {
            position_n: three([position_m; 3]),
            velocity_n: three([velocity_m_s; 3]),
            misalignment_n: three([tilt_rad, tilt_rad, heading_rad]),
        };
        Correction { errors, ..Default::default() }
    }
}

/// A parameter with an error, if it is one of the fit.
fn drawn(estimate: &Estimate, error: f64) -> f64 {
    if estimate.prior > 0.0 { estimate.value + error } else { 0.0 }
}

/// Coefficients of white noise, flicker noise and random walk, drawn as the record leaves them open.
fn drawn_noise(noise: &SensorNoise, stream: &mut Xoshiro256PlusPlus) -> [f64; 3] {
    [noise.random_walk, noise.flicker, noise.rate_random_walk].map(|of: NoiseEstimate| {
        let size = normal(stream);
        match of.is_seen() {
            true => of.value * exp(size * ln(of.high / of.low) / (2.0 * 1.96)),
            false => of.value,
        }
    })
}
