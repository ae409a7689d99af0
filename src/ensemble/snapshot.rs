//! The whole ensemble as a snapshot, and back.

use super::one_by_one::OneByOne;
use super::{Ensemble, Runs};
use crate::error::{Error, ErrorKind};
use crate::instruction_set::InstructionSet;
use crate::memory::room_for_one_more;
use crate::simulator::{Options, SideBySide, Simulator};
use crate::snapshot::{ANY, COUNT, Numbers, Reader, SnapshotOf, Stored, Writer, fitting};
use crate::truth::Intake;

impl Ensemble {
    /// Bytes that a snapshot takes now.
    pub fn snapshot_size(&self) -> usize {
        self.write_snapshot(&mut [])
    }

    /// Writes a snapshot into `buffer` and gives its length; it can be saved at any moment. No allocation.
    pub fn save_snapshot(&self, buffer: &mut [u8]) -> Result<usize, Error> {
        let capacity = buffer.len();
        fitting(self.write_snapshot(buffer), capacity)
    }

    /// Becomes the ensemble of a snapshot, whatever this one was: the runs go on to the same bits. Allocates.
    ///
    /// [`ErrorKind::Snapshot`]: not a snapshot of an ensemble, not whole, altered, or of a newer release; then nothing has
    /// changed.
    pub fn load_snapshot(&mut self, snapshot: &[u8]) -> Result<(), Error> {
        let mut from = Reader::new(snapshot, SnapshotOf::Ensemble)?;
        let loaded = Self::read_snapshot(&mut from).map_err(|error| match error.kind {
            ErrorKind::OutOfMemory => error,
            _ => Error { kind: ErrorKind::Snapshot, ..error },
        })?;
        from.finish()?;
        *self = loaded;
        Ok(())
    }

    /// The length of the snapshot, of which as much is written as `buffer` has room for.
    fn write_snapshot(&self, buffer: &mut [u8]) -> usize {
        let Self { first_run, options, intake, intervals, runs } = self;
        let mut to = Writer::new(buffer, SnapshotOf::Ensemble);
        options.save(&mut to);
        intake.save(&mut to);
        Numbers::save(first_run, &mut to);
        Numbers::save(intervals, &mut to);
        to.count(self.runs());
        for place in 0..self.runs() {
            to.flag(self.diverged_s(place).is_some());
            match runs {
                Runs::SideBySide(runs) => runs.save_run(place, intake, &mut to),
                Runs::OneByOne(runs) => runs.simulators[place].save_to(&mut to),
            }
        }
        to.finish()
    }

    fn read_snapshot(from: &mut Reader<'_>) -> Result<Self, Error> {
        let mut options = Options::default();
        options.load(from)?;
        options.validate()?;
        let mut intake = Intake::new(options.earth(), options.axes, options.intake)?;
        intake.load(from)?;
        let (mut first_run, mut intervals) = (0_u64, 0_u64);
        from.enter("snapshot: Ensemble.first_run");
        Numbers::load(&mut first_run, from, ANY)?;
        from.enter("snapshot: Ensemble.intervals");
        Numbers::load(&mut intervals, from, COUNT)?;
        from.enter("snapshot: Ensemble.runs");
        let count = from.count(super::MAX_RUNS as usize)?;
        let fits = count > 0 && first_run.checked_add(count as u64 - 1).is_some();
        from.require(fits, count as f64, "is no number of runs")?;

        // As much memory as there are bytes for, whatever the number says.
        let mut runs = OneByOne::default();
        for run in (first_run..=u64::MAX).take(count) {
            from.enter("snapshot: Ensemble.diverged");
            let has_diverged = from.flag()?;
            let mut simulator = Simulator::load_from(from)?;
            from.enter("snapshot: a run of the ensemble");
            let same = same_flight(&simulator, &options, run, has_diverged, (&intake, intervals));
            from.require(same, run as f64, "is not one of this ensemble")?;
            room_for_one_more(&mut runs.simulators)?;
            runs.simulators.extend(core::mem::take(&mut simulator));
            room_for_one_more(&mut runs.diverged)?;
            runs.diverged.push(has_diverged);
        }
        let runs = side_by_side(runs, first_run)?;
        Ok(Self { first_run, options, intake, intervals, runs })
    }
}

/// The runs side by side, if they can be.
fn side_by_side(mut runs: OneByOne, first_run: u64) -> Result<Runs, Error> {
    let count = runs.simulators.len();
    if !runs.simulators.iter().all(|simulator| SideBySide::is_for(simulator, count)) {
        return Ok(Runs::OneByOne(runs));
    }
    let Some(first) = runs.first() else { return Ok(Runs::OneByOne(runs)) };
    let mut made = SideBySide::new(first, first_run, count, InstructionSet::up_to(usize::MAX))?;
    for (place, (simulator, diverged)) in runs.simulators.iter_mut().zip(runs.diverged).enumerate() {
        made.put_simulator(place, simulator, diverged);
    }
    Ok(Runs::SideBySide(made))
}

/// Whether a simulator has the options of run `run`, and unless it has diverged flies the ensemble's samples.
fn same_flight(
    simulator: &[Simulator],
    options: &Options,
    run: u64,
    has_diverged: bool,
    (intake, intervals): (&Intake, u64),
) -> bool {
    let [simulator] = simulator else { return false };
    let mut of_run = options.of_run();
    of_run.key.run = run;
    *simulator.options() == of_run
        && (has_diverged
            || simulator.waiting_samples() == intake.waiting()
                && simulator.intervals() == intervals
                && simulator.last_sample_time_s() == intake.newest().map(|point| point.sample.time_s))
}
