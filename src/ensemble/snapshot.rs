//! The whole ensemble as a snapshot, and back.

use super::Ensemble;
use super::part::{PART_RUNS, Part};
use crate::base::error::Error;
use crate::base::memory::room;
use crate::base::snapshot::{ANY, COUNT, Numbers, Reader, SnapshotOf, Stored, Writer, fitting};
use crate::simulator::{Options, SideBySide, Simulator};
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

    /// Replaces this ensemble by that of a snapshot. The runs continue to the same bits. Allocates.
    ///
    /// [`crate::ErrorKind::Snapshot`]: not a snapshot of an ensemble, not whole, altered, or of a newer release; then nothing
    /// has changed.
    pub fn load_snapshot(&mut self, snapshot: &[u8]) -> Result<(), Error> {
        *self = Reader::read(snapshot, SnapshotOf::Ensemble, Self::read_snapshot)?;
        Ok(())
    }

    /// Writes as much of the snapshot as fits into `buffer`. Returns the length of the whole snapshot.
    fn write_snapshot(&self, buffer: &mut [u8]) -> usize {
        let Self { first_run, options, parts } = self;
        let Part { intake, intervals, .. } = &parts[0];
        let mut to = Writer::new(buffer, SnapshotOf::Ensemble);
        options.save(&mut to);
        intake.save(&mut to);
        Numbers::save(first_run, &mut to);
        Numbers::save(intervals, &mut to);
        to.count(self.runs());
        for place in 0..self.runs() {
            to.flag(self.diverged_s(place).is_some());
            let (part, place) = self.at(place);
            part.runs.save_run(place, intake, &mut to);
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
        // Memory only for the bytes that there are, because the number of runs may be false.
        let fits =
            (1..=from.bytes_left()).contains(&count) && first_run.checked_add(count as u64 - 1).is_some();
        from.require(fits, count as f64, "is not a valid number of runs")?;

        let mut parts: Vec<Part> = room(count.div_ceil(PART_RUNS))?;
        for (place, run) in (first_run..=u64::MAX).take(count).enumerate() {
            from.enter("snapshot: Ensemble.diverged");
            let has_diverged = from.flag()?;
            let mut memory = Simulator::load_from(from)?;
            let [simulator] = &mut *memory;
            from.enter("snapshot: a run of the ensemble");
            let same = same_flight(simulator, &options, run, has_diverged, (&intake, intervals));
            from.require(same, run as f64, "is not one of this ensemble")?;
            if place % PART_RUNS == 0 {
                let runs = SideBySide::new(simulator, run, PART_RUNS.min(count - place), usize::MAX)?;
                parts.push(Part { intake: intake.copy()?, intervals, runs });
            }
            if let Some(part) = parts.last_mut() {
                let fits = part.runs.has_sensors_of(simulator);
                from.require(fits, run as f64, "has other sensors than the runs before")?;
                part.runs.put_simulator(place % PART_RUNS, simulator, has_diverged)?;
            }
        }
        Ok(Self { first_run, options, parts })
    }
}

/// Whether a simulator has the options of run `run`, and, unless it has diverged, flies the samples of the ensemble.
fn same_flight(
    simulator: &Simulator,
    options: &Options,
    run: u64,
    has_diverged: bool,
    (intake, intervals): (&Intake, u64),
) -> bool {
    let mut of_run = options.of_run();
    of_run.key.run = run;
    *simulator.options() == of_run
        && (has_diverged
            || simulator.waiting_samples() == intake.waiting()
                && simulator.intervals() == intervals
                && simulator.last_sample_time_s() == intake.newest().map(|point| point.stamp_s()))
}
