//! `sins_sim`: the simulator's life, and its steps.

use super::boundary::{enter, enter_without_simulator};
use super::failure::{Failure, SINS_GAP, SINS_NEED_SAMPLE, SINS_OK, sins_status};
use super::memory::{put, read};
use super::options::sins_options;
use super::registry::Registry;
use super::sample::sins_flight_sample;
use crate::simulator::{Options, Simulator, Step, heap_simulator};
use crate::truth::{FlightSample, Pushed};

/// A simulator. A handle is a checked key, never an address: a null, made-up or destroyed one is answered
/// SINS_ERROR_BAD_HANDLE. Any function may be called from any thread; calls on one handle wait for each other, calls on
/// different handles never do.
#[repr(C)]
pub struct sins_sim {
    _opaque: [u8; 0],
}

/// Each in a slice of one, which unlike a `Box` can be made without aborting.
pub(super) static SIMULATORS: Registry<Box<[Simulator]>> = Registry::new(1);

/// Runs `body` on the simulator of a handle, as the inside of an exported function.
#[inline(always)]
pub(super) fn with_simulator(
    sim: *const sins_sim,
    body: impl FnOnce(&mut Simulator) -> Result<sins_status, Failure>,
) -> sins_status {
    enter(|| {
        SIMULATORS.with(sim.addr(), |place| match &mut **place {
            [simulator] => body(simulator),
            _ => Err(Failure::internal()),
        })
    })
}

/// The same where the host's state is set aside already.
#[cfg(feature = "scenes")]
pub(super) fn on_simulator(
    sim: *const sins_sim,
    body: impl FnOnce(&mut Simulator) -> Result<sins_status, Failure>,
) -> sins_status {
    SIMULATORS.with(sim.addr(), |place| match &mut **place {
        [simulator] => body(simulator),
        _ => Err(Failure::internal()),
    })
}

/// Gives the host a handle of a simulator.
///
/// # Safety
/// `sim` is not null and writable.
pub(super) unsafe fn hand_out(
    simulator: Box<[Simulator]>,
    sim: *mut *mut sins_sim,
) -> Result<sins_status, Failure> {
    let key = SIMULATORS.insert(simulator)?;
    // SAFETY: as this function.
    unsafe { put(sim, core::ptr::without_provenance_mut(key), "sim")? };
    Ok(SINS_OK)
}

/// What `view` makes of a simulator that is an argument under `name` of a function of its own; its sentence stays.
pub(super) fn look_at<T>(
    sim: *const sins_sim,
    name: &'static str,
    view: impl FnOnce(&Simulator) -> T,
) -> Result<T, Failure> {
    let mut seen = None;
    let status = SIMULATORS.with(sim.addr(), |place| {
        seen = place.first().map(view);
        Ok(SINS_OK)
    });
    seen.ok_or_else(|| Failure::of_handle(status, name))
}

/// Creates a simulator with ideal sensors. options may be NULL: the recommended simulator.
///
/// On an error *sim is untouched, and sins_last_error(NULL, ...) on this thread tells why. SINS_ERROR_OUT_OF_MEMORY: no
/// memory, or 4096 simulators live. Not for a real-time frame: it allocates.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_create(options: *const sins_options, sim: *mut *mut sins_sim) -> sins_status {
    enter_without_simulator(|| {
        if sim.is_null() {
            return Err(Failure::null("sim"));
        }
        let options = if options.is_null() {
            Options::default()
        } else {
            // SAFETY: the host's promise.
            unsafe { read(options, "options")? }.to_options()?
        };
        // SAFETY: the host's promise; not null.
        unsafe { hand_out(heap_simulator(&options)?, sim) }
    })
}

/// Destroys a simulator. A call on it in another thread is waited for; the handle is never used again.
///
/// SINS_ERROR_BAD_HANDLE: null, made up, or destroyed before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_destroy(sim: *mut sins_sim) -> sins_status {
    enter(|| SIMULATORS.remove(sim.addr()))
}

/// Takes one flight-control sample into the queue (16 samples). Each is checked by itself and against the one before.
///
/// SINS_ERROR_INVALID_ARGUMENT: a value out of its range, or no temperature while temperature coefficients are set.
/// SINS_ERROR_TIME_ORDER: not later than the one before, by less than 5e-5 s, or off a stated period by more than 0.4 of it.
/// SINS_GAP: taken, and the interval before it is a gap, of more than 2.5 times each of the two before: its sins_step() flies it as
/// motion, the velocity times its length, up to max_gap_s. After a pause of the host whose clock ran on, call sins_move_time()
/// before this push; the push cannot be taken back.
/// SINS_ERROR_DISCONTINUITY: a gap of more than max_gap_s, a jump or half a turn since the last that was taken: no other is taken
/// until one fits, or until sins_move_time() for a gap, sins_move_truth() or sins_reposition() for a jump.
/// SINS_ERROR_QUEUE_FULL: step first. SINS_ERROR_BAD_STATE: navigating on increments.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_push_sample(
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
/// further one one more. No allocation, no system call. An interval in which the host's clock ran on is flown like any other,
/// the velocity times its length; sins_push_sample() answers SINS_GAP for it.
///
/// SINS_NEED_SAMPLE: no complete interval waits. SINS_ERROR_DIVERGED: the interval would lead the solution of the block, of the
/// reference point or of the closed loop's own error-free navigator beyond -500 km or
/// 20000 km of height or 100 km/s; SINS_ERROR_SINGULAR: within reach of a pole, in geographic axes. The step is not made, the
/// solution before it stays readable, and sins_reposition() or sins_reset() start anew. SINS_ERROR_BAD_STATE: navigating on
/// increments.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_step(sim: *mut sins_sim) -> sins_status {
    with_simulator(sim, |simulator| Ok(step(simulator)?))
}

#[inline]
pub(super) fn push(
    simulator: &mut Simulator,
    sample: &FlightSample,
) -> Result<sins_status, crate::error::Error> {
    simulator.push_sample(sample).map(pushed)
}

pub(super) fn step(simulator: &mut Simulator) -> Result<sins_status, crate::error::Error> {
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

/// The newest accepted sample counts as at time_s from now on [s], and the stamps of samples to come follow on it: for a pause in
/// which the host's clock ran on. time_s is where the clock was when the vehicle moved on. All else is as it was: errors, noise,
/// waiting samples, sensor processes, failures, running figures, and the stated period, whose grid moves along. A flight goes on to
/// the same bits as one whose stamps never jumped if the differences between successive stamps are the same doubles; with a stated
/// period they always are. (Without velocities the differences over three samples count too; durations in sins_accuracy are
/// rounded as the time stamps are.) flight_start_s of sins_scene_prepare() is the host's: move it by as much.
///
/// SINS_ERROR_INVALID_ARGUMENT: time_s not from -9.99998e9 to 9.99998e9. SINS_ERROR_BAD_STATE: no sample yet, or navigating on
/// increments, which have no stamps.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_move_time(sim: *mut sins_sim, time_s: f64) -> sins_status {
    with_simulator(sim, |simulator| {
        simulator.move_time(time_s)?;
        Ok(SINS_OK)
    })
}

/// The vehicle was slewed: truth jumps to the sample, and the INS keeps the errors that it has. No interval is flown from the
/// sample before to this one, so the errors do not grow between them. Position error in metres (along
/// the truth's east and north, and in height), velocity error (components) and misalignment that sins_get_errors() tells are those
/// before, from both sources, to 1e-8 m, 1e-11 m/s and 1e-14 rad; what comes of them is up to gravity, the latitude and the velocity
/// there. Noise, sensor processes, failures, the vertical channel, the altimeter's error (but that of its scale
/// factor, which is of the new height) and running figures go on; no draw moves. The sensors follow the new signals at once. Waiting
/// samples are dropped; time may jump too, all clocks with it, as in sins_move_time(). sins_get_imu() still tells the interval
/// before. Where the sample has no velocity, the solution has its velocity error alone until the next is pushed.
///
/// Within 20 km of the Earth's axis, before or after, where the components along east and north of truth and solution have no
/// common meaning, errors of velocity and attitude are those in the truth's axes, turned to the solution's vertical by the shortest
/// way. With a mounting the errors kept are those of the sensor block; those of the reference point are what its arm and boresight,
/// and what is wrong of them, make of that in the new attitude.
///
/// Before the first step there is no INS with errors: it is sins_reposition() then. SINS_ERROR_INVALID_ARGUMENT,
/// SINS_ERROR_BAD_STATE: as sins_reposition(). SINS_ERROR_SINGULAR: within reach of a pole, in geographic axes.
/// SINS_ERROR_DIVERGED: the solution would leave its range, or there is no place with such an error, a quarter of the Earth away.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_move_truth(
    sim: *mut sins_sim,
    sample: *const sins_flight_sample,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let sample = unsafe { read(sample, "sample")? };
        simulator.move_truth(&sample.to_sample()?)?;
        Ok(SINS_OK)
    })
}

/// The flight simulator was reloaded: truth jumps to the sample, the INS starts again there with its initial errors. The errors that
/// it had are lost; to keep them call sins_move_truth() (slew) or sins_move_time() (pause) instead. Noise and failures go on where
/// they were. Waiting samples and the running accuracy figures are dropped. Time may jump
/// too, forward or back: the run, and the count of a stated period, go on from the sample's time stamp. What is read until the
/// next step is that of the sample; an interval to read there is none. It may be the first call of a run: the sample is then the
/// first, and the next push makes an interval.
///
/// SINS_ERROR_INVALID_ARGUMENT: as sins_push_sample(). SINS_ERROR_BAD_STATE: navigating on increments. Where no INS can start
/// (a pole, in geographic axes) it is the reads and the next step that say so.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_reposition(
    sim: *mut sins_sim,
    sample: *const sins_flight_sample,
) -> sins_status {
    with_simulator(sim, |simulator| {
        // SAFETY: the host's promise.
        let sample = unsafe { read(sample, "sample")? };
        simulator.reposition(&sample.to_sample()?)?;
        Ok(SINS_OK)
    })
}

/// Back to before the first sample: same options, the parameters as they were set last, no failures, and the same draws again
/// from their start, so that the same samples and settings give the same bits. For other draws create a simulator with another
/// seed or run; to come back to a moment in flight, see sins_snapshot_save().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn sins_reset(sim: *mut sins_sim) -> sins_status {
    with_simulator(sim, |simulator| {
        simulator.reset();
        Ok(SINS_OK)
    })
}
