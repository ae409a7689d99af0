//! `sins_recommend`: the cheapest options that meet a required accuracy.

use super::boundary::enter_without_simulator;
use super::failure::{CallError, SINS_OK, SINS_REQUIREMENT_NOT_MET, sins_status};
use super::memory::{Array, Output, interface_struct, read};
use super::options::sins_options;
use super::parameters::Parameters;
use super::sample::sins_flight_sample;
use super::simulator::{look_at, sins_sim};
use crate::analysis::recommend::{
    MAX_SAMPLES, MIN_SAMPLES, Recommendation, Refusal, Requirement, Setup, recommend, step_time_ns,
};
use crate::base::error::check_integer;
use crate::base::memory::room;
use crate::truth::FlightSample;

/// Largest error that the algorithm itself may cause, in addition to those of the sensors, at any time within a duration.
/// At least one limit is needed.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_requirement {
    /// sizeof(sins_requirement)
    pub struct_size: u32,
    /// 1: measure ns_per_step, in 9 rounds of about 1000 steps; 0: it is 0.
    pub time_steps: u32,
    /// Duration for which the limits hold, 0 to 1e6 [s]. If it is shorter than the piece of flight that is given to
    /// sins_recommend(), it is the length of that piece.
    pub duration_s: f64,
    /// Limit of the position error of the algorithm: distance from the reference (see sins_recommend()) [m]; 0: none.
    pub position_m: f64,
    /// Limit of the velocity error of the algorithm: length of the difference from the reference [m/s]; 0: none.
    pub velocity_m_s: f64,
    /// Limit of the attitude error of the algorithm: angle between its attitude relative to the Earth and that of the
    /// reference [rad]; 0: none.
    pub attitude_rad: f64,
    /// Margin: each limit must be at least this many times the predicted error, 1 to 1e6; 0: 2.
    pub margin: f64,
}

interface_struct!(sins_requirement, "requirement", 48);

/// Accuracy and cost of the recommended options.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_cost {
    /// sizeof(sins_cost)
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Duration for which the errors are predicted [s].
    pub duration_s: f64,
    /// Predicted position error, the largest within the duration [m].
    pub position_m: f64,
    /// Predicted velocity error, the largest within the duration [m/s].
    pub velocity_m_s: f64,
    /// Predicted attitude error against the Earth, the largest within the duration [rad].
    pub attitude_rad: f64,
    /// Part of position_m that is the uncertainty of the reference [m].
    pub reference_position_m: f64,
    /// Part of velocity_m_s that is the uncertainty of the reference [m/s].
    pub reference_velocity_m_s: f64,
    /// Part of attitude_rad that is the uncertainty of the reference [rad].
    pub reference_attitude_rad: f64,
    /// Predicted error times margin divided by its limit, the largest of the three. The requirement is met if this is at most
    /// 1. A limit below 1e-100 counts as 1e-100.
    pub share: f64,
    /// Processor instructions of the part of a step that depends on the algorithm: a figure that is the same on every
    /// machine. The algorithms are ordered by this figure.
    pub instructions_per_step: f64,
    /// Time of push and step of one sample, measured in this call on this machine if time_steps is 1, else 0, with the
    /// recommended options, the mounting, and ideal sensors; 0 in WebAssembly, which has no clock [ns].
    pub ns_per_step: f64,
    /// Number of algorithms that were tried, including the recommended one.
    pub tried: u64,
    /// Largest angular rate of the samples, as in sins_truth_summary [rad/s].
    pub rate_max_rad_s: f64,
    /// Time stamp of rate_max_rad_s [s].
    pub rate_max_at_s: f64,
    /// Largest specific force of the samples, as in sins_truth_summary [m/s2].
    pub force_max_m_s2: f64,
    /// Time stamp of force_max_m_s2 [s].
    pub force_max_at_s: f64,
    /// Largest vibration of the samples: change of the mean angular rate from an interval to the next, divided by the time
    /// between their middles [rad/s2]; 0 for two samples.
    pub vibration_max_rad_s2: f64,
    /// Time stamp of vibration_max_rad_s2: that of the last sample of the two intervals [s].
    pub vibration_max_at_s: f64,
}

interface_struct!(sins_cost, "cost", 144);

impl sins_requirement {
    fn to_requirement(self) -> Result<Requirement, CallError> {
        check_integer("requirement.time_steps", self.time_steps as usize, 0, 1)?;
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

impl From<Refusal> for CallError {
    fn from(refusal: Refusal) -> Self {
        let failure = Self::from(refusal.error);
        match refusal.sample {
            Some(index) => failure.of_sample(index),
            None => failure,
        }
    }
}

/// Finds the cheapest algorithm that meets a requirement on a piece of the host's own flight, of 2 to 360000 samples.
/// samples[0].struct_size is the size in bytes of each element of samples. docs/accuracy.md, "Which options", says which piece to
/// give, which error is judged, and how it is predicted beyond the piece.
///
/// configured is a simulator as the host flies it, at any moment. The call uses only its options and its mounting, reads them at
/// the start, and neither steps nor changes the simulator. NULL is the recommended simulator with its sensor block at the
/// reference point. The output `options` gets the options of configured, ready for sins_create(). Only scheme, subsamples and
/// updates_per_sample are replaced by the recommended values. The values of these three in configured do not matter.
///
/// Not for a real-time frame: it allocates, and takes about 18 to 70 us a sample, 0.1 to 0.4 ms if nothing meets the requirement.
/// time_steps adds 5 to 100 ms. The same samples give the same answer on every machine; only ns_per_step differs.
///
/// SINS_REQUIREMENT_NOT_MET: no algorithm meets the requirement; options and cost are those of the algorithm that comes
/// closest.
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_TIME_ORDER, SINS_ERROR_DISCONTINUITY: as sins_push_sample().
/// SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
/// SINS_ERROR_DIVERGED: the solution of every algorithm diverged.
/// SINS_ERROR_OUT_OF_MEMORY: no memory.
///
/// sins_last_error(NULL, ...) on this thread gives the reason and the sample.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_recommend(
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
            (read(requirement, "requirement")?, Output::new(options, "options")?, Output::new(cost, "cost")?)
        };
        let time_steps = requirement.time_steps == 1;
        let requirement = requirement.to_requirement()?;
        check_integer("count", count, MIN_SAMPLES as u64, MAX_SAMPLES as u64)?;
        // SAFETY: the host's promise; samples are only read.
        let samples = read_samples(&unsafe { Array::new(samples.cast_mut(), count, "samples")? })?;
        let answer = recommend(&setup, &samples, &requirement)?;
        let chosen = setup.with(&answer.rung);
        let ns_per_step = if time_steps { step_time_ns(&chosen, &samples)? } else { 0.0 };
        options.write(&sins_options::from_parameters(&chosen.options));
        let instructions_per_step = answer.rung.instructions(setup.options.frame);
        cost.write(&sins_cost::new(&answer, instructions_per_step, ns_per_step));
        Ok(if answer.met { SINS_OK } else { SINS_REQUIREMENT_NOT_MET })
    })
}

fn read_samples(samples: &Array<sins_flight_sample>) -> Result<Vec<FlightSample>, CallError> {
    let mut list = room(samples.count())?;
    for index in 0..samples.count() {
        list.push(samples.sample(index)?);
    }
    Ok(list)
}

impl sins_cost {
    fn new(answer: &Recommendation, instructions_per_step: f64, ns_per_step: f64) -> Self {
        let Recommendation { share, duration_s, predicted, uncertainty, motion, tried, .. } = *answer;
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
            rate_max_rad_s: motion.rate_max.value,
            rate_max_at_s: motion.rate_max.time_s,
            force_max_m_s2: motion.force_max.value,
            force_max_at_s: motion.force_max.time_s,
            vibration_max_rad_s2: motion.vibration_max.value,
            vibration_max_at_s: motion.vibration_max.time_s,
        }
    }
}
