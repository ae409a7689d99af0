//! `sins_error_budget`: which effects matter.

use super::boundary::enter_without_simulator;
use super::budget_answer::{sins_budget, sins_budget_row};
use super::failure::{CallError, SINS_OK, sins_status};
use super::memory::{Array, Output, interface_struct, put_if_wanted, read};
use super::sample::sins_flight_sample;
use super::simulator::{look_at, sins_sim};
use crate::analysis::budget::{
    BudgetEffect, BudgetRequest, ComputedSamples, Costs, MAX_SAMPLES, MIN_SAMPLES, error_budget,
    step_costs_ns,
};
use crate::analysis::recommend::SolutionError;
use crate::base::error::{Error, check_integer};
use crate::simulator::{ErrorParameters, Simulator};

/// Request for an error budget. All zero is 16 runs and no limits.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_budget_request {
    /// sizeof(sins_budget_request)
    pub struct_size: u32,
    /// 1: measure the figures ns_per_step; 0: they are 0.
    pub time_steps: u32,
    /// Number of runs with all effects together, if any effect is random, 8 to 1000; 0: 16.
    pub runs: u64,
    /// Limit of the change of the position error, at any time of the flight, by all effects that are left out together [m];
    /// 0: none.
    pub position_m: f64,
    /// Limit of the change of the velocity error, likewise [m/s]; 0: none.
    pub velocity_m_s: f64,
    /// Limit of the change of the misalignment, likewise [rad]; 0: none.
    pub attitude_rad: f64,
}

interface_struct!(sins_budget_request, "request", 40);

/// Computes the contribution of each effect to the errors of a flight of 2 to 1e9 samples: which effects matter, and which
/// can be left out. samples[0].struct_size is the size in bytes of each element of samples, rows[0].struct_size that of each
/// element of rows. struct_size of the other samples may be 0, that of the other rows anything. docs/effects.md, "Which effects
/// matter", defines the contributions, their remainder, and what is left out.
///
/// configured is a simulator as the host flies it, at any moment. The call uses its options and all its errors: those of
/// gyros, accelerometers and altimeter, the initial errors, and those of mounting and gravity, but not its failures. The call
/// reads them at the start, and neither steps nor changes the simulator. NULL is the recommended simulator without errors.
/// NULL for request is 16 runs and no limits. written and budget may be NULL.
///
/// rows[0] is the mechanization's own error. A row for each field that sets an error and is not 0 follows, ordered by position,
/// then velocity, then misalignment, the largest first; with limits, by their share of a limit.
///
/// Not for a real-time frame: it allocates, and flies the samples many times, each time in 0.8 to 1.8 us a sample with the
/// recommended options, in 11 us with SINS_SCHEME_POLYNOMIAL, 5 subsamples and 16 updates. time_steps adds 0.05 to 0.6 s with
/// three effects. The same samples give the same answer on every machine, except for the figures ns_per_step.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: capacity is less than the number of rows; written gets that number, and nothing is flown.
/// (To ask for the number, give NULL for rows and a capacity of 0.)
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
/// SINS_ERROR_TIME_ORDER, SINS_ERROR_DISCONTINUITY: as sins_push_sample().
/// SINS_ERROR_SINGULAR: too close to a pole, in geographic axes or for gyrocompassing.
/// SINS_ERROR_DIVERGED: a solution diverged.
/// SINS_ERROR_BAD_STATE: a sample became invalid during the call. To end the call, another thread may set struct_size of samples to 1,
/// and nothing else.
/// SINS_ERROR_OUT_OF_MEMORY: no memory.
///
/// sins_last_error(NULL, ...) on this thread gives the reason and the sample.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_error_budget(
    configured: *const sins_sim,
    samples: *const sins_flight_sample,
    count: usize,
    request: *const sins_budget_request,
    rows: *mut sins_budget_row,
    capacity: usize,
    written: *mut usize,
    budget: *mut sins_budget,
) -> sins_status {
    enter_without_simulator(|| {
        let of = |simulator: &Simulator| (*simulator.options(), ErrorParameters::of(simulator));
        let (options, parameters) = match configured.is_null() {
            true => Default::default(),
            false => look_at(configured, "configured", of)?,
        };
        let (request, time_steps) = if request.is_null() {
            (BudgetRequest::default(), false)
        } else {
            // SAFETY: the host's promise.
            unsafe { read(request, "request")? }.to_request()?
        };
        request.validate()?;
        // SAFETY: the host's promise; written at the end alone.
        let summary = unsafe { Output::if_wanted(budget, "budget")? };
        check_integer("count", count, MIN_SAMPLES as u64, MAX_SAMPLES as u64)?;
        // SAFETY: the host's promise; samples are only read.
        let samples = unsafe { Array::new(samples.cast_mut(), count, "samples")? };
        let needed = 1 + BudgetEffect::set_in(&parameters).count();
        // SAFETY: the host's promise.
        let tell = |number: usize| unsafe { put_if_wanted(written, number) };
        if needed > capacity {
            tell(needed);
            return Err(CallError::buffer("capacity", capacity, needed));
        }
        // SAFETY: the host's promise.
        let rows = unsafe { Array::new(rows, needed, "rows")? };

        for index in 0..count {
            samples.sample(index)?;
        }
        let changed = |_| Error::bad_state("samples: they changed during the call");
        let scene = ComputedSamples { count, sample: &|index| samples.sample(index).map_err(changed) };
        let answer = error_budget(&options, &scene, &parameters, &request)?;
        let effects = answer.rows.iter().map(|row| row.effect);
        let costs = match time_steps {
            true => step_costs_ns(&options, &scene, &parameters, effects)?,
            false => Costs { own_ns: 0.0, total_ns: 0.0, saved_ns: Vec::new() },
        };

        rows.write(0, &sins_budget_row::own(&answer, &request, &costs))?;
        for (index, row) in answer.rows.iter().enumerate() {
            let saved_ns = costs.saved_ns.get(index).copied().unwrap_or_default();
            rows.write(index + 1, &sins_budget_row::new(row, saved_ns))?;
        }
        if let Some(summary) = summary {
            summary.write(&sins_budget::new(&answer, &costs));
        }
        tell(needed);
        Ok(SINS_OK)
    })
}

impl sins_budget_request {
    /// The request, and whether steps are timed.
    fn to_request(self) -> Result<(BudgetRequest, bool), CallError> {
        check_integer("request.time_steps", self.time_steps as usize, 0, 1)?;
        let Self { runs, position_m, velocity_m_s, attitude_rad, .. } = self;
        let request = BudgetRequest {
            runs: if runs == 0 { BudgetRequest::default().runs } else { runs },
            limits: SolutionError { position_m, velocity_m_s, attitude_rad },
        };
        Ok((request, self.time_steps == 1))
    }
}
