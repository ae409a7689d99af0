//! Judges samples: finds what is wrong with a flight before an INS flies it.
//!
//! The samples are pushed one after the other, and pass once, through memory of fixed size. Each statistic has a threshold that
//! noise, steps and manoeuvres of the flight itself set, so that no good flight is found doubtful. Displacements are Earth-fixed: no
//! statistic is singular at a pole or at the date line. Medians are those of `histogram`s.

mod above_air;
mod attitude;
mod blocks;
mod conclude;
mod crab;
mod delay;
mod direction;
mod finding;
mod held;
mod histogram;
mod induced_error;
mod late;
mod noise;
mod positions;
mod regression;
mod resolution;
mod row;
mod sentence;
mod stamps;
mod straight;
mod velocity;
mod wrap;
mod zeros;

pub use finding::{At, Finding, Kind, Level};

use nalgebra::Vector3;

use crate::base::error::Error;
use crate::base::math::{Euler, sin_cos, wrap_angle};
use crate::earth::Earth;
use crate::truth::FlightSample;
use above_air::AboveAir;
use blocks::{Blocks, Coarseness};
use induced_error::InducedError;
use late::Lateness;
use noise::Noise;
use positions::Positions;
use resolution::{AttitudeSteps, Resolution};
use row::Row;
use stamps::Stamps;
use wrap::Wrap;
use zeros::Zeros;

/// Largest number of findings of a flight.
pub const MAX_FINDINGS: usize = 32;

/// Cosine of the pitch below which the angles of the attitude say nothing about its noise.
const NEAR_ZENITH: f64 = 0.2;

/// Samples until doubts are given in flight: statistics of fewer are those of a few rows.
const DOUBTS_FROM: u64 = 200;

/// Differences until the noise of the positions is known.
const KNOWN_NOISE: u64 = 8;

/// Judges the samples of a flight. It has 50 KB, and allocates nothing more.
#[derive(Debug, Clone)]
pub struct Judge {
    earth: Earth,
    max_acceleration_m_s2: f64,
    has_attitude: bool,
    /// Whether the samples are a smoothed path.
    is_path: bool,
    /// Samples pushed.
    rows: u64,
    first_s: f64,
    last: Option<FlightSample>,
    /// Stamps that are not later than the one before, and the first of them.
    late: u64,
    first_late: At,
    stamps: Stamps,
    resolution: Resolution,
    noise: Noise,
    velocity_noise: Noise,
    attitude_noise: Noise,
    angle_steps: AttitudeSteps,
    lateness: Lateness,
    positions: Positions,
    above_air: AboveAir,
    blocks: Blocks,
    wraps: [Wrap; 2],
    zeros: Zeros,
    effect: InducedError,
    /// What was found in the rows of a smoothed path.
    of_rows: [Option<Finding>; MAX_FINDINGS],
    /// A bit for each kind of finding that [`Self::new_doubts`] has given.
    given: u32,
}

impl Judge {
    /// A judge of a flight on `earth`, in which a mean acceleration above `max_acceleration_m_s2` [m/s²] between two samples is unusable
    /// ([`IntakeLimits::max_acceleration_m_s2`](super::IntakeLimits)).
    pub fn new(earth: Earth, max_acceleration_m_s2: f64) -> Result<Self, Error> {
        Ok(Self {
            earth,
            max_acceleration_m_s2,
            has_attitude: true,
            is_path: false,
            rows: 0,
            first_s: 0.0,
            last: None,
            late: 0,
            first_late: At::default(),
            stamps: Stamps::new(),
            resolution: Resolution::new(),
            noise: Noise::new()?,
            velocity_noise: Noise::new()?,
            attitude_noise: Noise::new()?,
            angle_steps: AttitudeSteps::new(),
            lateness: Lateness::new(),
            positions: Positions::new(),
            above_air: AboveAir::new(),
            blocks: Blocks::new()?,
            wraps: [const { Wrap::new() }; 2],
            zeros: Zeros::new(),
            effect: InducedError::new(),
            of_rows: [None; MAX_FINDINGS],
            given: 0,
        })
    }

    /// Passes over the attitudes of the samples: they are not those of the vehicle.
    pub fn ignore_attitude(&mut self) {
        self.has_attitude = false;
    }

    /// Takes the samples as those of a smoothed path.
    #[cfg(feature = "scenes")]
    pub(crate) fn expect_path(&mut self) {
        self.is_path = true;
    }

    /// Adds what was found in the rows that the samples are a smoothed path of.
    #[cfg(feature = "scenes")]
    pub(crate) fn add_of_rows(&mut self, findings: impl Iterator<Item = Finding>) {
        for (place, finding) in self.of_rows.iter_mut().zip(findings) {
            *place = Some(finding);
        }
    }

    /// The steps of which all horizontal positions, and all heights, are multiples [m]; 0: none.
    #[cfg(feature = "scenes")]
    pub(crate) fn steps_m(&self) -> [f64; 2] {
        [self.resolution.horizontal_m(), self.resolution.steps_m[2]]
    }

    /// Number of samples that were pushed.
    pub fn count(&self) -> u64 {
        self.rows
    }

    /// The findings so far that are doubtful or worse, of the kinds that this function has not given before: for warnings in flight, and
    /// `at_end` of it. In flight there are none among the first 200 samples.
    pub fn new_doubts(&mut self, at_end: bool) -> impl Iterator<Item = Finding> + use<> {
        let mut doubts = [None; MAX_FINDINGS];
        if at_end || self.rows >= DOUBTS_FROM {
            for (place, finding) in doubts.iter_mut().zip(self.findings()) {
                let bit = 1 << finding.kind as u32;
                if finding.level >= Level::Doubtful && self.given & bit == 0 {
                    self.given |= bit;
                    *place = Some(finding);
                }
            }
        }
        doubts.into_iter().flatten()
    }

    /// Adds a sample. An error says which value is out of its range; then the sample is not added.
    pub fn push(&mut self, sample: &FlightSample) -> Result<(), Error> {
        sample.validate()?;
        let number = self.rows;
        self.rows += 1;
        let Some(last) = self.last else {
            self.positions.begin(sample);
            (self.first_s, self.last) = (sample.time_s, Some(*sample));
            return Ok(());
        };
        let at = At { row: number, time_s: sample.time_s };
        let interval_s = sample.time_s - last.time_s;
        if interval_s <= 0.0 {
            if self.late == 0 {
                self.first_late = at;
            }
            self.late += 1;
            return Ok(());
        }
        // A near stamp is never divided by: its row is left out.
        if !self.stamps.take(interval_s, at) {
            self.add(&Row::new(&self.earth, number, sample, &last), sample, &last);
            self.last = Some(*sample);
        }
        Ok(())
    }

    fn add(&mut self, row: &Row, sample: &FlightSample, last: &FlightSample) {
        let usual_s = self.stamps.usual_s();
        self.resolution.add(&self.earth, row);
        let steps_m = self.resolution.steps_m;
        let step_m = self.resolution.horizontal_m();
        // Differences of the rates of change: those of uneven samples are not noise.
        let t = row.interval_s;
        let fourth = self.noise.add(row.d_e / t, |v| row.local(v) * usual_s, &steps_m);
        if let (Some(v_n), Some(before)) = (row.v_n, last.v_n) {
            self.velocity_noise.add((v_n - before) / t, |v| v * usual_s, &[0.0; 3]);
            self.effect.add(&self.earth, row);
        }
        self.lateness.add(row);
        self.above_air.add(&self.earth, row);
        self.add_turn(&sample.euler, &last.euler, t);
        let had_unfixed = self.positions.unfixed() > 0;
        self.positions.add(row, sample, usual_s, fourth);
        if let Some((middle, mean_m)) = self.stamps.add(row) {
            self.positions.add_window(middle, mean_m, usual_s, step_m);
        }
        let coarse = Coarseness {
            horizontal_m: self.noise.recent() + step_m,
            up_m: self.noise.recent_up() + steps_m[2],
            usual_s,
            is_known: self.noise.count() >= KNOWN_NOISE || usual_s >= 1.0,
        };
        self.blocks.add(row, &coarse);
        if !had_unfixed && self.positions.unfixed() > 0 {
            self.blocks.clear();
            (self.effect, self.lateness) = (InducedError::new(), Lateness::new());
        }
        let before = At { row: row.at.row - 1, time_s: last.time_s };
        let (now, then) = (sample.euler, last.euler);
        for (wrap, step) in self.wraps.iter_mut().zip([now.heading - then.heading, now.roll - then.roll]) {
            wrap.add(step, row.interval_s, before);
        }
        self.zeros.add(row.at, &now, &then);
    }

    /// Adds a turn of the attitude for its noise. Near the zenith the angles turn, and the attitude does not.
    fn add_turn(&mut self, now: &Euler, before: &Euler, interval_s: f64) {
        let cosine = sin_cos(now.pitch).1;
        if self.has_attitude && cosine.abs() > NEAR_ZENITH {
            let turn = Vector3::new(
                wrap_angle(now.roll - before.roll),
                wrap_angle(now.pitch - before.pitch),
                cosine * wrap_angle(now.heading - before.heading),
            );
            let usual_s = self.stamps.usual_s();
            self.attitude_noise.add(turn / interval_s, |v| v * usual_s, &[0.0; 3]);
            self.angle_steps.add(now);
        }
    }
}
