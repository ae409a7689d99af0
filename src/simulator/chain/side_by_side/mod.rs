//! The runs of an ensemble side by side, in batches of [`RUNS`](crate::signal::RUNS); the runs behind the last full batch, if they are
//! few, without lanes ([`single`]).
//!
//! A step has four parts. The generator gives the ideal signals, which are the same for all runs, and a chain without navigators flies
//! their mounting and their closed loop. The part of sensors, altimeter and error models that is the same in all runs is computed.
//! Each batch flies with what the runs share. The chain concludes the interval.

mod batch;
mod disturbed;
mod fly;
mod shared;
mod single;
mod start;
mod workspace;

use core::cell::RefCell;

use super::Chain;
use crate::base::error::Error;
use crate::base::instruction_set::InstructionSet;
use crate::earth::Earth;
use crate::errors::NavigationErrors;
use crate::errors::correction::{Compensation, Correction};
use crate::sensors::{Failure, SensorOutput, SharedInput};
use crate::signal::{RUNS, increment_of};
use crate::simulator::chain::view::Views;
use crate::simulator::imu::LastInterval;
use crate::simulator::moment::Moment;
use crate::simulator::signals::Signals;
use crate::simulator::{
    ErrorSource, Imperfections, ImuFlags, ImuInterval, Options, Solution, nothing_to_correct,
};
use crate::truth::{FlightSample, Intake, Recent, TruthPoint};
use batch::{Batch, Report};
use shared::{LastGood, Shared};
use single::Single;
use workspace::Workspace;

/// Runs over one truth, and what they share.
#[derive(Debug)]
pub(crate) struct SideBySide {
    set: InstructionSet,
    options: Options,
    earth: Earth,
    first_run: u64,
    /// Settings of the host, and states that depend only on the signals.
    imperfections: Box<[Imperfections]>,
    /// Whether one altimeter without errors serves all runs.
    heights_are_shared: bool,
    /// Scratch: the sensors of one run, which are assembled when they are read.
    of_one: RefCell<Box<[Imperfections]>>,
    signals: Signals,
    inputs: [SharedInput; 2],
    /// One element: in flight the chain without the navigators. It is on the heap, because it is large for a stack.
    chain: Box<[Option<Chain>]>,
    /// The runs in lanes, and those behind them, which are flown without lanes.
    batches: Vec<Batch>,
    singles: Box<[Single]>,
    workspace: Box<[Workspace]>,
}

/// Where a run is.
enum Found<B, S> {
    /// In a batch, at this lane.
    Lane(B, usize),
    Single(S),
}

impl SideBySide {
    /// Flies the interval that `recent` ends. An error concerns the truth; then nothing has changed.
    pub fn step(&mut self, recent: &Recent<'_>) -> Result<(), Error> {
        self.options.check_truth(recent.next)?;
        if self.chain[0].is_none() {
            self.start(recent)?;
        }
        let Self {
            set,
            imperfections,
            heights_are_shared,
            signals,
            inputs,
            chain,
            batches,
            singles,
            workspace,
            ..
        } = self;
        let ([Some(chain)], [workspace], [imperfections]) =
            (&mut **chain, &mut **workspace, &mut **imperfections)
        else {
            return Ok(());
        };
        let motion = chain.generator.advance(recent);
        let count = chain.options.subsamples * chain.options.updates_over(recent);
        motion.integrate(&mut signals.ideal[..count]);
        singles.iter_mut().for_each(|single| single.fly((chain, recent), &motion, count, signals));
        let ideal = &mut signals.ideal[..count];
        if batches.is_empty() {
            // Each run has its own mounting and closed loop.
            chain.generator.take_revised();
            chain.conclude_shared(&motion, recent, ideal);
            return Ok(());
        }
        let flown = chain.fly_shared(&motion, recent, !imperfections.are_none(), ideal);

        let shared = Shared::new(chain, (imperfections, inputs), (recent, &motion, ideal), flown);
        *heights_are_shared = !shared.has_altimeters;

        batches.iter_mut().for_each(|batch| batch.fly(*set, &shared, workspace));

        chain.conclude_shared(&motion, recent, ideal);
        Ok(())
    }

    /// Time of the last good solution of a run that has diverged [s].
    pub fn diverged_s(&self, place: usize) -> Option<f64> {
        let last_good = match self.at(place) {
            Found::Lane(batch, lane) => batch.diverged[lane],
            Found::Single(single) => single.diverged,
        };
        last_good.map(|last_good| last_good.time_s)
    }

    /// Where a run is.
    fn at(&self, place: usize) -> Found<&Batch, &Single> {
        match self.batches.get(place / RUNS) {
            Some(batch) => Found::Lane(batch, place % RUNS),
            None => Found::Single(&self.singles[place - self.batches.len() * RUNS]),
        }
    }

    fn at_mut(&mut self, place: usize) -> Found<&mut Batch, &mut Single> {
        let lanes = self.batches.len() * RUNS;
        match self.batches.get_mut(place / RUNS) {
            Some(batch) => Found::Lane(batch, place % RUNS),
            None => Found::Single(&mut self.singles[place - lanes]),
        }
    }

    /// Rejects a sample without the temperature that a sensor effect needs.
    pub fn check_temperature(&self, sample: &FlightSample) -> Result<(), Error> {
        self.imperfections[0].check_temperature(sample.temperature_c)
    }

    /// Lets an output of every run fail from the next interval on; `None` clears it.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) {
        let Self { imperfections, heights_are_shared, chain, batches, singles, .. } = self;
        let interval_s = chain[0].as_ref().and_then(|chain| chain.imu()).map(|imu| imu.interval_s);
        for batch in batches {
            if *heights_are_shared {
                batch.follow(&imperfections[0].altimeter);
            }
            batch.set_failure(output, failure, interval_s);
        }
        *heights_are_shared = false;
        singles.iter_mut().for_each(|single| single.set_failure(output, failure));
        imperfections[0].set_failure(output, failure, None);
    }

    /// The failure of an output, which all runs share.
    pub fn failure(&self, output: SensorOutput) -> Option<Failure> {
        self.imperfections[0].failure(output)
    }

    /// Number of runs.
    pub fn runs(&self) -> usize {
        self.batches.iter().map(|batch| batch.count).sum::<usize>() + self.singles.len()
    }

    /// Memory of a run [bytes].
    pub fn bytes_of_run(&self) -> usize {
        self.batches.first().map_or(size_of::<Single>(), Batch::bytes_of_run)
    }

    /// The navigated solution of a run; `intake` has the samples of the truth.
    pub fn navigation(&self, place: usize, intake: &Intake) -> Result<Option<Solution>, Error> {
        self.read(place, intake, |moment| moment.navigation())
    }

    /// Time [s] and errors of a run, and whether the truth is near a pole.
    pub fn errors_and_pole(
        &self,
        place: usize,
        intake: &Intake,
        source: ErrorSource,
    ) -> Result<Option<(f64, NavigationErrors, bool)>, Error> {
        self.options.check_source(source)?;
        Ok(self.read(place, intake, |moment| moment.errors_and_pole(source))?.flatten())
    }

    /// Signals of the last interval of a run.
    pub fn imu(&self, place: usize) -> Option<ImuInterval> {
        self.chain_of(place).and_then(|chain| chain.imu())
    }

    /// Flags of the signals of the last interval of each run; none is set before the first.
    pub fn imu_flags(&self) -> impl Iterator<Item = ImuFlags> {
        // A truth that was moved has no interval, and the lanes keep what they had.
        let has_interval = self.chain[0].as_ref().and_then(|chain| chain.imu()).is_some();
        let of = move |report: &Report| if has_interval { report.flags } else { ImuFlags::default() };
        let lanes = self.batches.iter().flat_map(|batch| &batch.state.reports).map(of);
        let singles = self.singles.iter().map(|single| {
            single.chain.as_ref().and_then(Chain::imu).map_or(ImuFlags::default(), |imu| imu.flags)
        });
        lanes.take(self.runs() - self.singles.len()).chain(singles)
    }

    /// Reads the chain of a run as it is, or as it will start from the first sample that waits, with the truth of that moment.
    fn read<T>(
        &self,
        place: usize,
        intake: &Intake,
        view: impl FnOnce(Moment<'_>) -> T,
    ) -> Result<Option<T>, Error> {
        match (self.chain_of(place), intake.current(), intake.front()) {
            (Some(chain), Some(current), _) => Ok(Some(view(Moment { chain: &chain, point: current }))),
            (_, _, Some(first)) => {
                let chain = self.start_of(place, first, intake.first_interval().as_ref())?;
                Ok(Some(view(Moment { chain: &chain, point: first })))
            }
            _ => Ok(None),
        }
    }

    /// The chain of a run in flight, without its increments.
    fn chain_of(&self, place: usize) -> Option<Chain> {
        let shared = self.chain[0].as_ref()?;
        let views = Views { truth: shared.views.truth.clone(), ..Views::default() };
        let (batch, lane) = match self.at(place) {
            Found::Lane(batch, lane) => (batch, lane),
            Found::Single(single) => return Some(Chain { views, ..single.chain_over(shared)? }),
        };
        let mut chain = shared.clone();
        chain.mechanization = batch.navigator(lane, &self.earth, &self.options);
        chain.error_model = batch.error_model(lane, &self.earth);
        chain.north_unknown = batch.north_unknown[lane];
        chain.compensation = batch.compensation(lane);
        if let LastInterval::Summed { imu, vertical_unaided } = &mut chain.last {
            imu.measured = increment_of(&batch.state.measured, lane);
            imu.compensated = batch.navigated(lane);
            Report { flags: imu.flags, is_unaided: *vertical_unaided } = batch.state.reports[lane];
            imu.time_s = self.diverged_s(place).unwrap_or(imu.time_s);
            if let Some(mounting) = &mut chain.block {
                mounting.observe(&imu.ideal, &imu.compensated, imu.interval_s);
            }
        }
        if let Some(disturbed) = batch.disturbed.get(lane) {
            disturbed.give(&mut chain);
        }
        Some(Chain { views, ..chain })
    }

    /// The truth in flight, which is at `truth`.
    pub fn truth(&self, truth: &TruthPoint) -> Option<Solution> {
        self.chain[0].as_ref().map(|chain| Moment { chain, point: truth }.truth())
    }

    /// Takes the velocity of the truth at `point`, which was 0 so far and is now known.
    #[cold]
    #[inline(never)]
    pub fn take_first_velocity(&mut self, point: &TruthPoint) {
        let mut shared = None;
        for place in 0..self.runs() {
            if let (Some(mut chain), None) = (self.chain_of(place), self.diverged_s(place)) {
                chain.take_first_velocity(point, &self.imperfections[0]);
                match self.at_mut(place) {
                    Found::Lane(batch, lane) => {
                        batch.put_solution(lane, &chain);
                        shared = Some((chain.closed_loop, chain.mechanization));
                    }
                    Found::Single(single) => single.chain = Some(chain),
                }
            }
        }
        if let Some(chain) = &mut self.chain[0] {
            chain.views = Views::default();
            if let Some(shared) = shared {
                (chain.closed_loop, chain.mechanization) = shared;
            }
        }
    }

    /// Corrects a run, as [`Simulator::correct`](crate::Simulator::correct) does, while the truth is at `point`.
    #[cold]
    #[inline(never)]
    pub fn correct(
        &mut self,
        place: usize,
        point: &TruthPoint,
        correction: &Correction,
    ) -> Result<(), Error> {
        let Some(mut chain) = self.chain_of(place) else { return Err(nothing_to_correct()) };
        chain.correct(point, correction)?;
        let (batch, lane) = match self.at_mut(place) {
            Found::Lane(batch, lane) => (batch, lane),
            Found::Single(single) => {
                single.chain = Some(chain);
                return Ok(());
            }
        };
        if chain.compensation.is_some() {
            batch.make_room_for_compensations()?;
        }
        batch.put_solution(lane, &chain);
        batch.put_compensation(lane, chain.compensation);
        if let (Some(shared), true) = (&mut self.chain[0], *correction != Correction::default()) {
            let navigator = shared.mechanization;
            shared.part_from_shadow(&navigator);
        }
        Ok(())
    }

    /// Marks a run as diverged, with the solution that it has while the truth is at `point`.
    #[cold]
    pub fn diverge(&mut self, place: usize, point: &TruthPoint) {
        let Some(last_good) = self.chain[0].as_ref().map(|chain| LastGood::of(chain, point)) else { return };
        match self.at_mut(place) {
            Found::Lane(batch, lane) => batch.diverged[lane] = Some(last_good),
            Found::Single(single) => single.diverged = Some(last_good),
        }
    }

    /// Compensation of a run.
    pub fn compensation(&self, place: usize) -> Compensation {
        let compensation = match self.at(place) {
            Found::Lane(batch, lane) => batch.compensation(lane),
            Found::Single(single) => single.chain.as_ref().and_then(|chain| chain.compensation),
        };
        compensation.unwrap_or_default()
    }

    /// Follows a jump of the truth: the runs are before their first step again.
    pub fn reposition(&mut self) {
        self.chain[0] = None;
        self.batches.iter_mut().for_each(Batch::revive);
        self.singles.iter_mut().for_each(Single::revive);
    }
}
