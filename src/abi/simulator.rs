//! `sins_sim`: the simulator's life, and its steps.

use std::panic::resume_unwind;

use super::boundary::handle::hand_out;
use super::boundary::tables::SIMULATORS;
use super::boundary::{enter, enter_without_simulator};
use super::failure::{CallError, SINS_GAP, SINS_NEED_SAMPLE, SINS_OK, sins_status};
use super::memory::{Output, read};
use super::options::sins_options;
use super::parameters::Parameters;
use super::sample::sins_flight_sample;
use crate::base::error::Error;
use crate::simulator::{Options, Simulator, Step, heap_simulator};
use crate::truth::{FlightSample, Pushed};

/// A simulator. A handle is a checked key, never an address: a null, made-up or destroyed one is answered
/// SINS_ERROR_BAD_HANDLE. Any function may be called from any thread; calls on one handle wait for each other, calls on
/// different handles never do.
#[repr(C)]
pub struct sins_sim {
    _opaque: [u8; 0],
}

/// Runs `body` on the simulator of a handle, as the inside of an exported function.
#[inline(always)]
pub(super) fn with_simulator(
    sim: *const sins_sim,
    body: impl FnOnce(&mut Simulator) -> Result<sins_status, CallError>,
) -> sins_status {
    enter(|| on_simulator(sim, body))
}

/// [`with_simulator`] where the host's state is set aside already.
#[inline(always)]
pub(super) fn on_simulator(
    sim: *const sins_sim,
    body: impl FnOnce(&mut Simulator) -> Result<sins_status, CallError>,
) -> sins_status {
    SIMULATORS.with(sim.addr(), |memory| body(&mut memory[0]))
}

/// Moves a simulator to a sample.
///
/// # Safety
/// As the exported functions: `sample` is null or points to a struct.
unsafe fn at_sample(
    sim: *mut sins_sim,
    sample: *const sins_flight_sample,
    go: fn(&mut Simulator, &FlightSample) -> Result<(), Error>,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: as this function.
        go(simulator, &unsafe { read(sample, "sample")? }.to_sample()?)?;
        Ok(SINS_OK)
    })
}

/// What `view` makes of a simulator that is an argument under `name` of a function of its own; its sentence stays.
pub(super) fn look_at<T>(
    sim: *const sins_sim,
    name: &'static str,
    view: impl FnOnce(&Simulator) -> T,
) -> Result<T, CallError> {
    SIMULATORS
        .look_at(sim.addr(), |memory| view(&memory[0]))
        .map_err(|status| CallError::of_handle(status, name))
}

/// What `work` makes of a simulator that it may change, as [`look_at`]. A defect of `work` goes on to the caller, whose own object is
/// half changed too.
pub(super) fn work_with<T>(
    sim: *const sins_sim,
    name: &'static str,
    work: impl FnOnce(&mut Simulator) -> T,
) -> Result<T, CallError> {
    let (mut has_begun, mut made) = (false, None);
    let status = SIMULATORS.with(sim.addr(), |memory| {
        has_begun = true;
        made = Some(work(&mut memory[0]));
        Ok(SINS_OK)
    });
    if has_begun && made.is_none() {
        resume_unwind(Box::new("a defect in the work on an argument"));
    }
    made.ok_or_else(|| CallError::of_handle(status, name))
}

/// Creates a simulator with ideal sensors. If options is NULL, it has the recommended options.
///
/// On an error *sim is unchanged, and sins_last_error(NULL, ...) on this thread gives the reason. Not for a real-time
/// frame: it allocates.
///
/// SINS_ERROR_OUT_OF_MEMORY: no memory, or 4096 simulators exist.
///
/// ```c
/// sins_options options;
/// sins_sim *detailed = NULL;
/// SINS_INIT(options);
/// options.error_model = SINS_ERROR_MODEL_RK4;
/// sins_create(&options, &detailed);
/// sins_get_options(detailed, &options);
/// printf("%d subsamples\n", (int)options.subsamples);  // 2 subsamples
/// sins_destroy(detailed);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_create(
    options: *const sins_options,
    sim: *mut *mut sins_sim,
) -> sins_status {
    enter_without_simulator(|| {
        // SAFETY: the host's promise.
        unsafe {
            hand_out(&SIMULATORS, sim, "sim", || {
                let options = match options.is_null() {
                    true => Options::default(),
                    false => read(options, "options")?.to_parameters()?,
                };
                Ok(heap_simulator(&options)?)
            })
        }
    })
}

/// Waits until the calls of other threads on this handle have returned, and destroys the simulator. The handle is never used
/// again.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
///
/// ```c
/// sins_sim *other = NULL;
/// sins_create(NULL, &other);
/// printf("%s\n", sins_status_string(sins_destroy(other)));  // SINS_OK
/// printf("%s\n", sins_status_string(sins_destroy(other)));  // SINS_ERROR_BAD_HANDLE
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_destroy(sim: *mut sins_sim) -> sins_status {
    enter(|| SIMULATORS.remove(sim.addr()))
}

/// Reads the options in effect: those of sins_create() or of the snapshot that was loaded, with the defaults in place of 0.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_get_options(
    sim: *mut sins_sim,
    options: *mut sins_options,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let output = unsafe { Output::new(options, "options")? };
        Ok(output.write(&sins_options::from_parameters(simulator.options())))
    })
}

/// Puts one flight sample into the queue (16 samples). Each sample is checked by itself and against the one before.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or no temperature while temperature coefficients are set.
/// SINS_ERROR_TIME_ORDER: the sample is not later than the one before, or later by less than 5e-5 s, or off a stated period
/// by more than 0.4 of the period.
/// SINS_GAP: the sample was accepted, and the interval before it is a gap, more than 2.5 times as long as each of the two
/// before. sins_step() flies the gap as motion: the vehicle moves by its velocity times the length of the gap. After a pause
/// of the host in which its clock ran on, call sins_move_time() before this push; a push cannot be undone.
/// SINS_ERROR_DISCONTINUITY: a gap of more than max_gap_s, a jump, or a turn of 170 degrees or more since the last accepted
/// sample. After a gap each later sample is rejected, until you call sins_move_time(), sins_move_truth() or
/// sins_reposition(). After a jump or a turn each later sample is rejected, until one fits the last accepted sample, or until
/// you call sins_move_truth() or sins_reposition().
/// SINS_ERROR_QUEUE_FULL: step first.
/// SINS_ERROR_BAD_STATE: navigating on increments.
///
/// ```c
/// printf("%s\n", sins_status_string(sins_push_sample(sim, &sample)));  // SINS_OK
/// printf("%s\n", sins_status_string(sins_push_sample(sim, &sample)));  // SINS_ERROR_TIME_ORDER
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_push_sample(
    sim: *mut sins_sim,
    sample: *const sins_flight_sample,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let sample = unsafe { read(sample, "sample")? };
        Ok(push(simulator, &sample.to_sample()?)?)
    })
}

/// Flies one sample interval: truth, ideal signals, sensors, mechanization, errors. The first step needs two samples, each
/// later step one more. No allocation, no system call. An interval in which the host paused and its clock ran on is flown
/// like any other: the vehicle moves by its velocity times the length of the interval. sins_push_sample() returns SINS_GAP if
/// the interval is a gap.
///
/// SINS_NEED_SAMPLE: no complete interval is waiting.
/// SINS_ERROR_DIVERGED: the step would bring the solution below a height of -500 km, above a height of 20000 km, or to a
/// speed of more than 100 km/s. The limits apply to the solution of the sensor block, to that of the reference point, and to
/// the error-free navigator of SINS_SIGNAL_CLOSED_LOOP.
/// SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
/// SINS_ERROR_BAD_STATE: navigating on increments.
///
/// After SINS_ERROR_DIVERGED and SINS_ERROR_SINGULAR the step is not made, and the solution before it stays readable. The
/// samples stay in the queue, so a further sins_step() tries the same interval again. sins_reposition() or sins_reset() start
/// anew.
///
/// ```c
/// while (sins_step(sim) == SINS_OK) {
///     sins_get_navigation(sim, &navigation);
///     printf("%.0f s\n", navigation.time_s);  // 3601 s
/// }
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_step(sim: *mut sins_sim) -> sins_status {
    with_simulator(sim, |simulator| Ok(step(simulator)?))
}

#[inline]
pub(super) fn push(simulator: &mut Simulator, sample: &FlightSample) -> Result<sins_status, Error> {
    simulator.push_sample(sample).map(pushed)
}

pub(super) fn step(simulator: &mut Simulator) -> Result<sins_status, Error> {
    simulator.step().map(stepped)
}

/// The status of a sample that was taken.
#[inline]
pub(super) fn pushed(pushed: Pushed) -> sins_status {
    match pushed {
        Pushed::Regular | Pushed::FirstVelocity => SINS_OK,
        Pushed::BehindGap => SINS_GAP,
    }
}

/// The status of a step that did not fail.
#[inline]
pub(super) fn stepped(step: Step) -> sins_status {
    match step {
        Step::Done => SINS_OK,
        Step::NeedSample => SINS_NEED_SAMPLE,
    }
}

/// Moves the time after a pause in which the host's clock ran on: the newest accepted sample gets the time stamp time_s [s], and
/// later samples must have later stamps. time_s is the time that the clock shows when the vehicle moves again. Everything else
/// stays: errors, noise, waiting samples, sensor processes, failures and running figures. The grid of a stated period moves
/// along. The outputs have the same bits as those of a flight without the jump of time, if the differences between successive
/// time stamps are the same doubles. With a stated period this is always so. (If the samples have no velocities, the
/// differences over three samples must be the same doubles too. Durations in sins_accuracy have the rounding of the time
/// stamps.) The host must also move its flight_start_s of sins_scene_prepare() by the same time.
///
/// SINS_ERROR_INVALID_ARGUMENT: time_s not from -9.99998e9 to 9.99998e9.
/// SINS_ERROR_BAD_STATE: no sample yet, or navigating on increments, which have no time stamps.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_move_time(sim: *mut sins_sim, time_s: f64) -> sins_status {
    with_simulator(sim, |simulator| {
        simulator.move_time(time_s)?;
        Ok(SINS_OK)
    })
}

/// Slews the vehicle: the truth jumps to the sample, and the INS keeps its errors. No interval is flown from the previous
/// sample to this one, so the errors do not change at the slew. For both values of source, sins_get_errors() reports the same
/// errors before and after it: position error in metres (along the truth's east and north, and in height), velocity error
/// (components) and misalignment, to 1e-8 m, 1e-11 m/s and 1e-14 rad. Their further growth depends on gravity, latitude and
/// velocity at the new place. Noise, sensor processes, failures, the vertical channel, the altimeter's error and running
/// figures continue, and no random number changes. (The scale factor error of the altimeter is that of the new height.) The
/// sensors follow the new signals immediately. Waiting samples are dropped. The time may jump too: the running figures and
/// the grid of a stated period then move with it, as in sins_move_time(). sins_get_imu() still reports the previous interval.
/// If the sample has no velocity, the library takes the true velocity as 0 until the next sample is pushed. The navigated
/// velocity is then equal to the velocity error.
///
/// If the vehicle is within 20 km of the Earth's axis before or after the slew, the east and north components of truth and
/// solution are not comparable. The axes of the solution are then those of the truth, turned by the shortest rotation so that
/// up is the vertical of the solution. In these axes the components of the velocity error and of the misalignment are kept.
/// With a mounting, the errors of the sensor block are kept. The errors of the reference point follow from them with the
/// lever arm, the boresight and their errors, in the new attitude.
///
/// Before the first step there are no errors to keep, and the call acts as sins_reposition().
///
/// SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_reposition().
/// SINS_ERROR_SINGULAR: too close to a pole, in geographic axes.
/// SINS_ERROR_DIVERGED: the solution would leave its limits, or the position error is about a quarter of the Earth's
/// circumference or more, so that no place at the sample has this error.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_move_truth(
    sim: *mut sins_sim,
    sample: *const sins_flight_sample,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { at_sample(sim, sample, Simulator::move_truth) }
}

/// Restarts the INS after the flight simulator was reloaded: the truth jumps to the sample, and the INS starts again there
/// with its initial errors. The initial errors have the same random numbers as at the first start. The previous errors of the
/// INS are lost; to keep them, call sins_move_truth() (slew) or sins_move_time() (pause) instead. Noise and failures
/// continue. Waiting samples and the running accuracy figures are dropped. The time may jump too, forward or back: the run,
/// and the grid of a stated period, continue from the sample's time stamp. Until the next step, the reads give the state at
/// this sample, and there is no interval to read. The call may be the first of a run: the sample is then the first one, and
/// the next push completes an interval.
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample().
/// SINS_ERROR_BAD_STATE: navigating on increments.
///
/// This call returns SINS_OK even if no INS can start at the sample. The reads and the next step then return
/// SINS_ERROR_SINGULAR (too close to a pole, in geographic axes or for gyrocompassing) or SINS_ERROR_DIVERGED.
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_reposition(
    sim: *mut sins_sim,
    sample: *const sins_flight_sample,
) -> sins_status {
    // SAFETY: the host's promise.
    unsafe { at_sample(sim, sample, Simulator::reposition) }
}

/// Returns to the state before the first sample: the same options, the parameters as they were set last, no failures, and
/// the random streams at their start. So the same samples and settings give the same bits. For other random numbers, create
/// a simulator with another seed or run. To return to a moment in flight, see sins_snapshot_save().
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_reset(sim: *mut sins_sim) -> sins_status {
    with_simulator(sim, |simulator| {
        simulator.reset();
        Ok(SINS_OK)
    })
}

#[cfg(test)]
mod tests {
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::ptr::{null, null_mut};

    use super::*;
    use crate::abi::failure::SINS_ERROR_INTERNAL;

    #[test]
    fn a_defect_in_the_work_on_an_argument_reaches_the_callers_object() {
        let mut sim = null_mut();
        // SAFETY: null is allowed, and `sim` takes the handle.
        assert_eq!(unsafe { sins_create(null(), &raw mut sim) }, SINS_OK);
        let caught =
            catch_unwind(AssertUnwindSafe(|| work_with(sim, "sim", |_| -> u32 { panic!("a defect") })));
        assert!(caught.is_err());
        // From now on the simulator is broken, and no defect goes on.
        let after = work_with(sim, "sim", |_| 0).map_err(|error| error.status);
        assert_eq!(after, Err(SINS_ERROR_INTERNAL));
        // SAFETY: the handle of above.
        unsafe { sins_destroy(sim) };
    }
}
