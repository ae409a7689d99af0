//! `sins_recommend`: the cheapest options that meet a required accuracy.

use super::boundary::enter_without_simulator;
use super::failure::{Failure, SINS_OK, SINS_REQUIREMENT_NOT_MET, sins_status};
use super::memory::{Array, Output, interface_struct, read};
use super::options::{check_reserved, sins_options};
use super::sample::sins_flight_sample;
use super::simulator::{look_at, sins_sim};
use crate::error::check_integer;
use crate::memory::room;
use crate::recommend::{
    MAX_SAMPLES, MIN_SAMPLES, Recommendation, Refusal, Requirement, Setup, recommend, step_time_ns,
};
use crate::truth::FlightSample;

/// Largest error that the algorithm itself may make, apart from those of the sensors, at any time within a duration. A limit
/// of 0 is none; at least one is needed.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_requirement {
    /// sizeof(sins_requirement)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// For how long, up to 1e6 [s]; 0, or less than the piece's length: for the piece.
    pub duration_s: f64,
    /// Distance from where the exact solution on the same signals is [m].
    pub position_m: f64,
    /// Speed of the difference in velocity [m/s].
    pub velocity_m_s: f64,
    /// Angle between the attitudes, against the Earth [rad].
    pub attitude_rad: f64,
    /// How many times the predicted error has to fit into each limit, 1 to 1e6; 0: 2.
    pub margin: f64,
}

interface_struct!(sins_requirement, "requirement", 48);

/// What recommended options give, and what they cost.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_cost {
    /// sizeof(sins_cost)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// For how long the errors are predicted [s].
    pub duration_s: f64,
    /// Predicted error, the worst within the duration: position [m].
    pub position_m: f64,
    /// Velocity [m/s].
    pub velocity_m_s: f64,
    /// Attitude against the Earth [rad].
    pub attitude_rad: f64,
    /// The part of it that is the uncertainty of the reference: position [m].
    pub reference_position_m: f64,
    /// Velocity [m/s].
    pub reference_velocity_m_s: f64,
    /// Attitude [rad].
    pub reference_attitude_rad: f64,
    /// Predicted error times margin over its limit, the largest of the three: met up to 1. A limit below 1e-100 counts as 1e-100.
    pub share: f64,
    /// Instructions of a step that the algorithm has a part in, the same on every machine: what the algorithms are ordered by.
    pub instructions_per_step: f64,
    /// Measured here and now, in the options that were written, in the mounting and with ideal sensors: push and step of one sample [ns].
    pub ns_per_step: f64,
    /// Algorithms that were tried, the recommended one among them.
    pub tried: u64,
}

interface_struct!(sins_cost, "cost", 96);

impl sins_requirement {
    fn to_requirement(self) -> Result<Requirement, Failure> {
        check_reserved("requirement.reserved", self.reserved)?;
        let requirement = Requirement {
            duration_s: self.duration_s,
            position_m: self.position_m,
            velocity_m_s: self.velocity_m_s,
            attitude_rad: self.attitude_rad,
            margin: if self.margin == 0.0 { Requirement::default().margin } else { self.margin },
        };
        requirement.validate()?;
        Ok(requirement)
    }
}

impl From<Refusal> for Failure {
    fn from(refusal: Refusal) -> Self {
        let failure = Self::from(refusal.error);
        match refusal.sample {
            Some(index) => failure.of_sample(index),
            None => failure,
        }
    }
}

/// Finds the cheapest algorithm that meets a requirement on a piece of the host's own flight, of 2 to 360000 samples; all that
/// are cheaper do not meet it. samples[0].struct_size tells how far apart the samples are.
///
/// configured is a simulator as the host flies it, at any moment of its life: its options and its mounting count. It is read at
/// the start of the call and neither stepped nor changed. NULL is the recommended simulator with its sensor block at the
/// reference point. options gets the options of configured with scheme, subsamples and updates_per_sample of the answer, ready
/// for sins_create(); what these three were does not matter.
///
/// Each algorithm flies the piece with ideal sensors in the same mounting, and its solution is compared at every sample with that
/// of a reference, 16 updates of 5 subsamples, whose own uncertainty (what half as many updates change) is added. The error is
/// that of the algorithm alone: errors of sensors, altimeter, start, gravity and of the believed mounting move both solutions
/// alike and are left out, and so is what the host's samples contradict themselves by. SINS_SIGNAL_CLOSED_LOOP would hide the
/// error: the signals are without it. For a duration beyond the piece its errors go on as steady rates, through Schuler's
/// pendulum: more than the flight will show as long as it goes on like the piece. With SINS_VERTICAL_FREE each error counts as
/// one of height, which grows by e every 569 s.
///
/// The order of cost is instructions_per_step, so that the same samples have the same answer on every machine and every day;
/// ns_per_step alone differs. Not for a real-time frame: it allocates, and takes some 25 to 70 us a sample, up to 0.4 ms where
/// nothing meets the requirement.
///
/// SINS_REQUIREMENT_NOT_MET: no algorithm meets the requirement; options and cost are those of the one that comes closest.
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_TIME_ORDER, SINS_ERROR_DISCONTINUITY: as
/// sins_push_sample(). SINS_ERROR_SINGULAR: geographic axes within reach of a pole. SINS_ERROR_DIVERGED: the solution of every
/// algorithm left its range. SINS_ERROR_OUT_OF_MEMORY. sins_last_error(NULL, ...) on this thread tells why, and at which sample.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_recommend(
    configured: *const sins_sim,
    samples: *const sins_flight_sample,
    count: usize,
    requirement: *const sins_requirement,
    options: *mut sins_options,
    cost: *mut sins_cost,
) -> sins_status {
    enter_without_simulator(|| {
        let setup = match configured.is_null() {
            true => Setup::default(),
            false => look_at(configured, "configured", Setup::of)?,
        };
        // SAFETY: the host's promise; options and cost are written at the end alone.
        let (requirement, options, cost) = unsafe {
            (
                read(requirement, "requirement")?.to_requirement()?,
                Output::new(options, "options")?,
                Output::new(cost, "cost")?,
            )
        };
        check_integer("count", count, MIN_SAMPLES as i64, MAX_SAMPLES as i64)?;
        // SAFETY: the host's promise; samples are only read.
        let samples = read_samples(&unsafe { Array::new(samples.cast_mut(), count, "samples")? })?;
        let answer = recommend(&setup, &samples, &requirement)?;
        let chosen = setup.with(&answer.rung);
        let ns_per_step = step_time_ns(&chosen, &samples)?;
        options.write(&sins_options::from_options(&chosen.options));
        let instructions_per_step = answer.rung.instructions(setup.options.frame);
        cost.write(&sins_cost::new(&answer, instructions_per_step, ns_per_step));
        Ok(if answer.met { SINS_OK } else { SINS_REQUIREMENT_NOT_MET })
    })
}

fn read_samples(samples: &Array<sins_flight_sample>) -> Result<Vec<FlightSample>, Failure> {
    let mut list = room(samples.count())?;
    for index in 0..samples.count() {
        let sample = samples.read(index).and_then(sins_flight_sample::to_sample);
        list.push(sample.map_err(|failure| failure.of_sample(index))?);
    }
    Ok(list)
}

impl sins_cost {
    fn new(answer: &Recommendation, instructions_per_step: f64, ns_per_step: f64) -> Self {
        let Recommendation { share, duration_s, predicted, uncertainty, tried, .. } = *answer;
        Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            duration_s,
            position_m: predicted.position_m,
            velocity_m_s: predicted.velocity_m_s,
            attitude_rad: predicted.attitude_rad,
            reference_position_m: uncertainty.position_m,
            reference_velocity_m_s: uncertainty.velocity_m_s,
            reference_attitude_rad: uncertainty.attitude_rad,
            share,
            instructions_per_step,
            ns_per_step,
            tried: tried as u64,
        }
    }
}
