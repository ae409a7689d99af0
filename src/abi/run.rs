//! `sins_run`: a whole array of samples in one call.

use super::answer::fill_or_need;
use super::failure::{CallError, SINS_NEED_SAMPLE, SINS_OK, sins_status};
use super::memory::{Array, put_if_wanted};
use super::record::{RecordView, sins_record};
use super::sample::sins_flight_sample;
use super::simulator::{push, sins_sim, step, with_simulator};
use crate::simulator::Simulator;

/// Pushes and steps an array of count samples. Writes a record after each `every` intervals, counted as in
/// sins_accuracy.intervals. There is no record for the first sample. Any split of a flight into calls gives the same bits and
/// the same records as pushing and stepping sample by sample.
///
/// samples[0].struct_size is the size in bytes of each element of samples, records[0].struct_size that of each element of
/// records. struct_size of the other samples may be 0, that of the other records anything. every 0: no records. written (may
/// be NULL) gets the number of records that were written, also on an error.
///
/// SINS_GAP: all samples were flown and all records written, and at least one of the samples pushed here ended a gap;
/// if sins_options.truth_summary is on, sins_truth_summary.gaps is their number.
/// SINS_ERROR_BUFFER_TOO_SMALL: capacity does not hold the records that the call would make. Nothing is flown, and written
/// gets 0.
/// SINS_ERROR_BAD_STATE: navigating on increments.
///
/// An error of sins_push_sample() or sins_step() ends the call at the sample that caused the error; sins_last_error() names
/// this sample. The samples before it were flown, this sample and the rest were not. sins_accuracy.intervals counts the flown
/// intervals. A sample that could be pushed but not flown waits in the queue, as after sins_step(); sins_reposition() and
/// sins_reset() empty the queue.
///
/// ```c
/// sins_flight_sample minute[61];
/// sins_record records[6];
/// sins_sim *still = NULL;
/// size_t k, written = 0;
/// SINS_INIT(records[0]);
/// for (k = 0; k <= 60; k++) {
///     SINS_INIT(minute[k]);
///     minute[k].time_s = (double)k;
/// }
/// sins_create(NULL, &still);
/// sins_run(still, minute, 61, 10, records, 6, &written);
/// printf("%d records\n", (int)written);  // 6 records
/// sins_destroy(still);
/// ```
#[unsafe(no_mangle)]
pub unsafe extern "C-unwind" fn sins_run(
    sim: *mut sins_sim,
    samples: *const sins_flight_sample,
    count: usize,
    every: usize,
    records: *mut sins_record,
    capacity: usize,
    written: *mut usize,
) -> sins_status {
    with_simulator(sim, |simulator| {
        let mut done = 0;
        // SAFETY: the host's promise; samples are only read.
        let result = unsafe { Array::new(samples.cast_mut(), count, "samples") }.and_then(|samples| {
            simulator.refuse_while_navigating()?;
            let wanted = records_of(simulator, count, every);
            if wanted > capacity {
                return Err(CallError::buffer("capacity", capacity, wanted));
            }
            // SAFETY: the host's promise.
            let records = unsafe { Array::new(records, wanted, "records")? };
            run(simulator, &samples, every, &records, &mut done)
        });
        // SAFETY: the host's promise.
        unsafe { put_if_wanted(written, done) };
        result
    })
}

/// Records that a run of `count` more samples makes.
fn records_of(simulator: &Simulator, count: usize, every: usize) -> usize {
    if every == 0 {
        return 0;
    }
    let flown = simulator.intervals();
    // The first sample of a flight begins an interval, it does not end one.
    let waiting = simulator.waiting_samples().saturating_add(count);
    let to_fly = if simulator.has_started() { waiting } else { waiting.saturating_sub(1) };
    (flown.saturating_add(to_fly as u64) / every as u64 - flown / every as u64) as usize
}

fn run(
    simulator: &mut Simulator,
    samples: &Array<sins_flight_sample>,
    every: usize,
    records: &Array<sins_record>,
    done: &mut usize,
) -> Result<sins_status, CallError> {
    // What waited in the queue before the call goes first.
    while fly(simulator, every, records, done)? == SINS_OK {}
    let mut answer = SINS_OK;
    for index in 0..samples.count() {
        let pushed = push(simulator, &samples.sample(index)?)
            .map_err(|error| CallError::from(error).of_sample(index))?;
        if pushed != SINS_OK {
            answer = pushed;
        }
        while fly(simulator, every, records, done).map_err(|f| f.of_sample(index))? != SINS_NEED_SAMPLE {}
    }
    Ok(answer)
}

/// One step and its record.
fn fly(
    simulator: &mut Simulator,
    every: usize,
    records: &Array<sins_record>,
    done: &mut usize,
) -> Result<sins_status, CallError> {
    let status = step(simulator)?;
    if status == SINS_OK && every > 0 && simulator.intervals().is_multiple_of(every as u64) {
        write_record(simulator, records, done)?;
    }
    Ok(status)
}

#[inline(never)]
fn write_record(
    simulator: &mut Simulator,
    records: &Array<sins_record>,
    done: &mut usize,
) -> Result<(), CallError> {
    if fill_or_need::<RecordView>(simulator, &records.output(*done)?)? == SINS_OK {
        *done += 1;
    }
    Ok(())
}
