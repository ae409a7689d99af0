//! Identification: the errors of real sensors, from a record of their increments and the true path of the same motion.
//!
//! ```text
//!  path (truth -> signal)     record
//!       |                        |
//!   path::IdealPath          blocks     means over 0.2 s or more
//!       |        \               |
//!       |         clock          |      shift at which both have the same motion, in any axes
//!       |         axes           |      which axis is which: 24 signed exchanges
//!       |              \         |
//!       +-------------- solve ---+      all parameters together, about the last solution, in rounds
//!                      /     \
//!                 noise       jump      does the clock of the record jump, when and by how much? (large jumps: pieces)
//!                   |
//!                whiten                 blocks -> independent numbers
//! ```
//!
//! With u the true signal of a triad (rate or specific force) in the axes of the path, R the exchange of axes, φ the small rotation of the
//! mounting, E scale factor errors and misalignments, b the bias, τ the shift of the clock at the middle time t0 of the record, and δ its
//! drift, the record is
//!
//! ```text
//! m(t) = (I + E + [φ×]) R u(t + τ + δ (t - t0)) + b + n(t)
//! ```
//!
//! If they are asked for ([`Also`]), gyros have G f and accelerometers (α× + ω×ω×) r more, with the g-sensitivity G, the specific force f
//! and the lever arm r, and each sensor a/2 |u| with the asymmetry a, and k (T - T0) with the temperature T of the samples of the path.
//!
//! - **Signals.** u is the library's inverse navigation. Its integrals are interpolated by cubics, so the record may have another rate,
//!   and the shift is not bound to a sample.
//! - **Noise.** n is white noise N, flicker noise B (the processes with which this library makes it) and a random walk K, of each sensor.
//!   A Kalman filter turns blocks into independent numbers. B/N and K/N are not fitted: the distribution of the parameters is the mean over
//!   a grid of both, weighted by the restricted likelihood. So the intervals contain that a record tells little of its slow noise. The
//!   estimator of `sins allan` is not used: the residual of a fit has less slow noise than the sensor, because the fit has taken a
//!   part of it. n contains the noise of the path.
//! - **Priors.** Each parameter has one ([`Prior`]). It is *seen* in the motion if the record narrows its prior to less than a half.
//!   The rotation that the misalignments of both triads have in common is counted as one of the mounting: the axes of the block are those
//!   from which the gyros and the accelerometers are turned by opposite angles.
//! - **Rejected** are a record of another motion, of other units, with reversed forces or left-handed axes, one whose clock jumps, one
//!   with a sensor that is stuck or has a spike, one whose parameters contradict the priors, and one whose axes or shift the motion leaves
//!   open.
//!
//! All memory is that of the path and the record, and at most `MOST_BLOCKS` blocks and some; all loops end after a fixed
//! number of rounds.

mod axes;
mod beyond;
mod blocks;
pub mod check;
mod clock;
mod feed;
mod jump;
mod listed;
mod noise;
mod parameter;
mod path;
mod pieces;
mod prior;
mod rows;
pub mod sheet;
mod solve;
pub mod text;
mod unfit;
mod walk;
mod whiten;

pub use axes::Axes;
pub use blocks::{FEWEST_INCREMENTS, RecordedIncrement};
pub use feed::{Feed, MOST_ROWS};
pub use listed::{LISTED, Listed, listed};
pub use noise::{NoiseEstimate, SensorNoise};
pub use parameter::{Estimate, PARAMETERS, TriadEstimate};
pub use path::IdealPath;
pub use prior::Prior;

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use crate::base::error::{Error, Rule, check_range};
use crate::base::math::{Euler, euler_from_attitude, hypot, rotation_matrix, rotation_quaternion};
use crate::earth::state::BodyAxes;
use crate::signal::Increment;
use parameter::Place;
use path::Six;
use solve::{Fitted, InMemory, Matrix, Solution, Vector};
use walk::Walk;

/// Parameters that a fit has only if they are asked for: a record without the motion that tells them apart from others tells all of them
/// less well.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Also {
    /// The lever arm from the point of the path to the accelerometers.
    pub lever_arm: bool,
    /// The g-sensitivity of the gyros, each to the forces along all axes.
    pub g_sensitivity: bool,
    /// The scale factor asymmetry of each sensor, by the mean signals of fifths of a block.
    pub asymmetry: bool,
    /// The change of each bias with the temperature that the samples of the path have.
    pub temperature: bool,
}

/// What is known before the record, and what is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Request {
    /// Standard deviations of the parameters.
    pub prior: Prior,
    /// Exchange of axes, one of [`Axes::exchanges`], if it is known.
    pub axes: Option<Matrix3<f64>>,
    /// Path time less record time \[s\], -1e12 to 1e12, if it is known to 10 s: the nearest shift that fits is taken.
    pub shift_s: Option<f64>,
    /// Frequency above which the path lacks motion \[Hz\], 0.001 to 1e6, as a path that was smoothed does: record and path are compared
    /// by means over a period of it. Without it, by means over 0.2 s or more.
    pub cutoff_hz: Option<f64>,
    /// What is wanted beside the parameters that each fit has.
    pub also: Also,
}

/// Standard deviation of a lever arm beside that of the noise, as a part of its length: a path with samples lacks changes of the turns.
const OF_LEVER: f64 = 1e-3;
/// Standard deviation of a parameter that is not asked for.
const OFF: f64 = 1e-60;

impl Request {
    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        self.prior.validate()?;
        if let Some(shift_s) = self.shift_s {
            check_range("request.shift_s", shift_s, -1e12, 1e12)?;
        }
        if let Some(cutoff_hz) = self.cutoff_hz {
            check_range("request.cutoff_hz", cutoff_hz, 1e-3, 1e6)?;
        }
        match &self.axes {
            Some(axes) if !Axes::exchanges().any(|exchange| exchange == *axes) => {
                let rule = Rule::Sentence("must be a signed exchange of axes without reflection");
                Err(Error { value: None, ..Error::invalid("request.axes", 0.0, rule) })
            }
            _ => Ok(()),
        }
    }

    /// Standard deviations of all parameters.
    fn prior_sigmas(&self) -> Vector {
        let Prior { gyro_bias, gyro_scale_factor, gyro_misalignment, .. } = self.prior;
        let Prior { accel_bias, accel_scale_factor, accel_misalignment, mounting, .. } = self.prior;
        let triads = [
            (gyro_bias, gyro_scale_factor, gyro_misalignment),
            (accel_bias, accel_scale_factor, accel_misalignment),
        ];
        let mut sigmas = Vector::zeros();
        (sigmas[Place::CLOCK], sigmas[Place::DRIFT]) = (solve::CLOCK_S, solve::DRIFT);
        for (part, (bias, scale_factor, misalignment)) in triads.into_iter().enumerate() {
            for row in 0..3 {
                sigmas[Place::mounting(row)] = mounting;
                sigmas[Place::bias(part, row)] = bias;
                for column in 0..3 {
                    let element = if row == column { scale_factor } else { misalignment };
                    sigmas[Place::element(part, row, column)] = element;
                }
            }
        }
        let Prior { lever_arm_m, g_sensitivity, gyro_asymmetry, accel_asymmetry, .. } = self.prior;
        let of = |is_asked: bool, sigma: f64| if is_asked { sigma } else { OFF };
        let warming = [self.prior.gyro_bias_temperature, self.prior.accel_bias_temperature];
        for row in 0..3 {
            sigmas[Place::lever_arm(row)] = of(self.also.lever_arm, lever_arm_m);
            for (part, sigma) in [gyro_asymmetry, accel_asymmetry].into_iter().enumerate() {
                sigmas[Place::asymmetry(part, row)] = of(self.also.asymmetry, sigma);
                sigmas[Place::bias_temperature(part, row)] = of(self.also.temperature, warming[part]);
            }
            for column in 0..3 {
                sigmas[Place::g_sensitivity(row, column)] = of(self.also.g_sensitivity, g_sensitivity);
            }
        }
        sigmas
    }
}

/// What a record shows of its sensors.
#[derive(Debug, Clone, PartialEq)]
pub struct Identified {
    /// Path time less record time at the middle of the record \[s\].
    pub offset_s: Estimate,
    /// Change of the shift \[s/s\].
    pub drift: Estimate,
    /// Middle of the record on its clock \[s\].
    pub middle_s: f64,
    /// End of what was identified, on the clock of the record \[s\].
    pub last_s: f64,
    /// The exchange of axes.
    pub axes: Axes,
    /// Small rotation φ beside the exchange, about the axes of the record \[rad\].
    pub mounting: [Estimate; 3],
    /// Signals of the record = `rotation` times those of the path, with the exchange and φ.
    pub rotation: Matrix3<f64>,
    /// Errors of the gyros, axes of the record.
    pub gyro: TriadEstimate,
    /// Errors of the accelerometers, axes of the record.
    pub accel: TriadEstimate,
    /// Noise of the three gyros, then of the three accelerometers.
    pub noise: [SensorNoise; 6],
    /// Lever arm from the point of the path to the accelerometers, axes of the record \[m\], if the request asks for it; otherwise 0.
    pub lever_arm: [Estimate; 3],
    /// g-sensitivity of each gyro to the forces along x, y and z \[rad/s per m/s²\], if the request asks for it; otherwise 0.
    pub g_sensitivity: [[Estimate; 3]; 3],
    /// Temperature at which the biases hold \[°C\], the mean of the record, if the request asks for their changes with it.
    pub reference_c: Option<f64>,
    /// Mean g-sensitivity of the gyros \[rad/s per m/s²\] that they show and the fit has not: it is taken for misalignments.
    pub left_g_sensitivity: Option<f64>,
    /// Number of blocks of the fit, and their length on average \[s\].
    pub blocks: usize,
    /// Length of a block on average \[s\].
    pub block_s: f64,
    /// A square root of the covariance of all parameters.
    root: InMemory<Matrix>,
    /// What the biases have walked at the end of the record.
    walks: [Walk; 6],
}

impl Identified {
    #[inline(never)]
    fn new(
        request: &Request,
        change: &Matrix,
        (x, covariance): &Solution,
        (root, walks): (InMemory<Matrix>, [Walk; 6]),
        Fitted { rows, about, evidences, .. }: &Fitted,
        axes: Axes,
    ) -> Self {
        let prior = request.prior_sigmas();
        // Standard deviation before the record, in the axes of the block.
        let before = |place: usize| change.row(place).transpose().component_mul(&prior).norm();
        let estimate = |place: usize, from: f64| match prior[place] == OFF {
            true => Estimate::default(),
            false => Estimate {
                value: from + x[place],
                sigma: covariance[(place, place)].max(0.0).sqrt(),
                prior: before(place),
            },
        };
        let triad = |part: usize| TriadEstimate {
            bias: core::array::from_fn(|axis| estimate(Place::bias(part, axis), 0.0)),
            elements: core::array::from_fn(|row| {
                core::array::from_fn(|column| estimate(Place::element(part, row, column), 0.0))
            }),
            asymmetry: core::array::from_fn(|axis| estimate(Place::asymmetry(part, axis), 0.0)),
            bias_temperature: core::array::from_fn(|axis| estimate(Place::bias_temperature(part, axis), 0.0)),
        };
        let blocks = rows.blocks.len();
        let turn = Vector3::from_fn(|axis, _| x[Place::mounting(axis)]);
        let lever = about.axes * about.lever_b;
        Self {
            offset_s: estimate(Place::CLOCK, about.offset_s),
            drift: estimate(Place::DRIFT, about.drift),
            middle_s: about.middle_s,
            last_s: about.last_s,
            axes,
            mounting: core::array::from_fn(|axis| estimate(Place::mounting(axis), about.mounting[axis])),
            rotation: rotation_matrix(&rotation_quaternion(&turn)) * about.axes,
            gyro: triad(0),
            accel: triad(1),
            noise: evidences.map(|one| one.noise),
            lever_arm: core::array::from_fn(|axis| {
                let one = estimate(Place::lever_arm(axis), lever[axis]);
                Estimate { sigma: hypot(one.sigma, OF_LEVER * lever.norm()), ..one }
            }),
            g_sensitivity: core::array::from_fn(|row| {
                core::array::from_fn(|column| estimate(Place::g_sensitivity(row, column), 0.0))
            }),
            reference_c: about.reference_c,
            left_g_sensitivity: None,
            blocks,
            block_s: rows.blocks.iter().map(blocks::Block::length_s).sum::<f64>() / blocks as f64,
            root,
            walks,
        }
    }

    /// Attitude of the block in the vehicle, whose axes are `axes` \[rad\].
    pub fn boresight(&self, axes: BodyAxes) -> Euler {
        boresight(&self.rotation, axes)
    }

    /// Time of the path at `time_s` of the record \[s\].
    fn path_time_s(&self, time_s: f64) -> f64 {
        time_s + self.offset_s.value + self.drift.value * (time_s - self.middle_s)
    }

    /// Time of the record at `time_s` of the path \[s\].
    fn record_time_s(&self, time_s: f64) -> f64 {
        let since_s = time_s - self.offset_s.value - self.middle_s;
        self.middle_s + since_s / (1.0 + self.drift.value)
    }

    /// Time of the path at which the record of the fit ends \[s\].
    fn last_path_time_s(&self) -> f64 {
        self.path_time_s(self.last_s)
    }

    /// `path`, at the place of the accelerometers if a lever arm was found.
    pub fn path_of_sensors(&self, path: IdealPath) -> Result<IdealPath, Error> {
        match self.lever_arm[0].prior > 0.0 {
            true => {
                let lever = Vector3::from_fn(|axis, _| self.lever_arm[axis].value);
                path.with_lever_arm(&(self.rotation.transpose() * lever))
            }
            false => Ok(path),
        }
    }

    /// What an increment of the record has beside its path, which is that of the sensors, and the errors that were found, axes of the
    /// record; `None`: the path does not have its interval.
    pub fn residual(&self, path: &IdealPath, row: &RecordedIncrement) -> Option<Increment> {
        let ends_s = [row.time_s - row.interval_s, row.time_s].map(|time_s| self.path_time_s(time_s));
        let (ideal, _) = path.mean(ends_s[0], ends_s[1])?;
        let turned = |signal: &Six, part: usize| self.rotation * signal.fixed_rows::<3>(3 * part);
        let (rate, force) = (turned(&ideal, 0), turned(&ideal, 1));
        let above_k = rows::above_k(path, self.reference_c, ends_s);
        let rest = |part: usize, signal: &Vector3<f64>, measured: &Vector3<f64>| {
            let triad = [&self.gyro, &self.accel][part];
            let asymmetry = 0.5 * triad.asymmetries().component_mul(&signal.abs());
            let bias = triad.biases() + triad.warming(above_k);
            let error = triad.error_matrix() * signal + bias + asymmetry;
            measured - (signal + error) * row.interval_s
        };
        let Increment { angle, velocity } = &row.increment;
        let sensed = self.g_sensitivities() * force * row.interval_s;
        Some(Increment { angle: rest(0, &rate, angle) - sensed, velocity: rest(1, &force, velocity) })
    }

    /// The matrix of g-sensitivities that was found.
    fn g_sensitivities(&self) -> Matrix3<f64> {
        Matrix3::from_fn(|row, column| self.g_sensitivity[row][column].value)
    }

    /// The lever arm that is seen, axes of the path \[m\]; what is not seen is 0.
    pub fn lever_arm_b(&self) -> Vector3<f64> {
        let seen = self.lever_arm.map(|part| if part.is_seen() { part.value } else { 0.0 });
        self.rotation.transpose() * Vector3::from(seen)
    }

    /// Biases of a triad at the end of the record of the fit.
    fn last_biases(&self, part: usize) -> Vector3<f64> {
        [&self.gyro, &self.accel][part].biases()
            + Vector3::from_fn(|axis, _| self.walks[3 * part + axis].mean)
    }

    /// Biases \[rad/s\] and \[m/s²\] of gyros and accelerometers, of those that are seen; the others 0.
    pub fn seen_biases(&self) -> [Vector3<f64>; 2] {
        [&self.gyro, &self.accel].map(|triad| {
            Vector3::from_fn(|axis, _| {
                Some(triad.bias[axis]).filter(Estimate::is_seen).map_or(0.0, |bias| bias.value)
            })
        })
    }
}

/// Attitude \[rad\] of a block whose signals are `rotation` times those of the vehicle.
fn boresight(rotation: &Matrix3<f64>, axes: BodyAxes) -> Euler {
    let from_block = Rotation3::from_matrix_unchecked(rotation.transpose());
    let turn = UnitQuaternion::from_rotation_matrix(&from_block);
    euler_from_attitude(&axes.in_vehicle(turn.quaternion()))
}

/// Finds the errors of the sensors that made `record` along `path`.
///
/// An hour takes about a second, at any rate.
pub fn identify(
    path: &IdealPath,
    record: &[RecordedIncrement],
    request: &Request,
) -> Result<Identified, Error> {
    solve::identify(path, record, request)
}
