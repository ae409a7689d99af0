//! `sins_error_budget`: which effects matter.

use super::boundary::enter_without_simulator;
use super::budget_answer::{sins_budget, sins_budget_row};
use super::failure::{Failure, SINS_OK, sins_status};
use super::memory::{Array, Output, interface_struct, put, read};
use super::options::check_reserved;
use super::sample::sins_flight_sample;
use super::simulator::{look_at, sins_sim};
use crate::budget::{
    BudgetRequest, Effect, ErrorParameters, MAX_SAMPLES, MIN_SAMPLES, Scene, error_budget, step_costs_ns,
};
use crate::error::{Error, check_integer};
use crate::recommend::SolutionError;
use crate::simulator::Simulator;

/// What a budget is asked for. A limit of 0 is none.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_budget_request {
    /// sizeof(sins_budget_request)
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Runs of all together, if anything is random, 8 to 1000; 0: 16.
    pub runs: u64,
    /// What the effects that are left out may change together at any time of the scene: position [m].
    pub position_m: f64,
    /// Velocity [m/s].
    pub velocity_m_s: f64,
    /// Misalignment [rad].
    pub attitude_rad: f64,
}

interface_struct!(sins_budget_request, "request", 40);

/// Tells what each effect contributes to the errors of a scene of 2 to 1e9 samples: which ones matter, and which can be left
/// out. samples[0].struct_size tells how far apart the samples are, rows[0].struct_size the rows; the others' may be 0, those
/// of the rows anything.
///
/// configured is a simulator as the host flies it, at any moment of its life: its options and all that errs in it, of the gyros, the
/// accelerometers, the altimeter, the start, the mounting and gravity; failures do not count. It is read at the start of the call
/// and neither stepped nor changed. NULL is the recommended simulator, in which nothing errs. NULL for request is 16 runs and no
/// limits; written and budget may be NULL.
///
/// An effect is what one field sets; it is active, and has a row, if that is not 0. (SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS is
/// none: each effect brings the misalignment along that it causes; nor are lever_arm_m and boresight_rad of the mounting: all
/// runs fly with them.) Its contribution is the error, navigation less truth, of a run with this effect alone less that of a
/// run with nothing set: the length of the vector in position, in velocity and in misalignment, the largest of up to 1000
/// instants, equally spaced, and that of the last sample. Of an effect that is drawn it is one standard deviation by the
/// covariance of a flight with this effect alone, exact to first order (SINS_BUDGET_RANDOM; see sins_covariance). All together
/// is flown with the draws of the runs sins_options.run, run + 1 and so on.
///
/// rows[0] is the mechanization's own error, with what the samples contradict themselves by. The effects follow, the largest
/// position first, then velocity, then misalignment; with limits the largest share of a limit first. What is not the sum of
/// the rows is in the remainder, draw by draw: what is not linear, of second order in the sizes of the effects.
///
/// With limits the effects are marked that can be left out together (SINS_BUDGET_CAN_BE_LEFT_OUT): from the smallest share on
/// while the sum of the deterministic contributions and the root of the sum of squares of the random ones are together, root of the sum of squares, within each limit. Then all is flown again without them, in every run; while
/// what that changes, left_out, is beyond a limit, the largest of them comes back.
///
/// But for the ns_per_step the same samples have the same answer on every machine. Not for a real-time frame: it allocates,
/// and flies 1 + each effect + runs times all together, and as many times what is random, with limits again runs times and
/// more where effects do not add up; each flight takes 0.6 to 1.5 us a sample.
///
/// SINS_ERROR_BUFFER_TOO_SMALL: capacity does not hold the rows; written gets how many there are, nothing is flown (rows
/// may be NULL with a capacity of 0, to ask). SINS_ERROR_INVALID_ARGUMENT: a value out of its range. SINS_ERROR_TIME_ORDER,
/// SINS_ERROR_DISCONTINUITY: as sins_push_sample(). SINS_ERROR_SINGULAR: geographic axes, or gyrocompassing, within reach of a
/// pole. SINS_ERROR_DIVERGED: a solution left its range. SINS_ERROR_OUT_OF_MEMORY. sins_last_error(NULL, ...) on this thread
/// tells why, and at which sample.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_error_budget(
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
        let request = if request.is_null() {
            BudgetRequest::default()
        } else {
            // SAFETY: the host's promise.
            unsafe { read(request, "request")? }.to_request()?
        };
        request.validate()?;
        // SAFETY: the host's promise; written at the end alone.
        let summary = if budget.is_null() { None } else { Some(unsafe { Output::new(budget, "budget")? }) };
        check_integer("count", count, MIN_SAMPLES as i64, MAX_SAMPLES as i64)?;
        // SAFETY: the host's promise; samples are only read.
        let samples = unsafe { Array::new(samples.cast_mut(), count, "samples")? };
        let needed = 1 + Effect::set_in(&parameters).count();
        let tell = |number: usize| match written.is_null() {
            true => Ok(()),
            // SAFETY: the host's promise.
            false => unsafe { put(written, number, "written") },
        };
        if needed > capacity {
            tell(needed)?;
            return Err(Failure::buffer("capacity", capacity, needed));
        }
        // SAFETY: the host's promise.
        let rows = unsafe { Array::new(rows, needed, "rows")? };

        let sample = |index| samples.read(index).and_then(sins_flight_sample::to_sample);
        for index in 0..count {
            sample(index).map_err(|failure| failure.of_sample(index))?;
        }
        let changed = |_| Error::bad_state("samples: changed while they were flown");
        let scene = Scene { count, sample: &|index| sample(index).map_err(changed) };
        let answer = error_budget(&options, &scene, &parameters, &request)?;
        let costs = step_costs_ns(&options, &scene, &parameters, answer.rows.iter().map(|row| row.effect))?;

        rows.write(0, &sins_budget_row::own(&answer, &request, &costs))?;
        for (index, (row, saved_ns)) in answer.rows.iter().zip(&costs.saved_ns).enumerate() {
            rows.write(index + 1, &sins_budget_row::new(row, *saved_ns))?;
        }
        if let Some(summary) = summary {
            summary.write(&sins_budget::new(&answer, &costs));
        }
        tell(needed)?;
        Ok(SINS_OK)
    })
}

impl sins_budget_request {
    fn to_request(self) -> Result<BudgetRequest, Failure> {
        check_reserved("request.reserved", self.reserved)?;
        let Self { runs, position_m, velocity_m_s, attitude_rad, .. } = self;
        Ok(BudgetRequest {
            runs: if runs == 0 { BudgetRequest::default().runs } else { runs },
            limits: SolutionError { position_m, velocity_m_s, attitude_rad },
        })
    }
}
