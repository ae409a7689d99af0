//! The start of the runs of an ensemble, and the conversion of runs from and to simulators.

use core::cell::RefCell;

use super::batch::Batch;
use super::shared::LastGood;
use super::single::Single;
use super::workspace::Workspace;
use super::{Chain, Found, SideBySide};
use crate::base::error::Error;
use crate::base::instruction_set::InstructionSet;
use crate::base::memory::room;
use crate::base::snapshot::Writer;
use crate::errors::correction::Compensation;
use crate::sensors::SharedInput;
use crate::signal::RUNS;
use crate::simulator::signals::Signals;
use crate::simulator::snapshot::save_flight;
use crate::simulator::start::is_of_truth;
use crate::simulator::{Imperfections, Mode, Options, Simulator};
use crate::truth::{Intake, Recent, TruthPoint};

impl SideBySide {
    /// Runs from `first_run` on with the settings of `template`, with instructions for up to `width` numbers at a time; with a width of
    /// 1 all runs are flown without lanes.
    pub fn new(template: &Simulator, first_run: u64, runs: usize, width: usize) -> Result<Self, Error> {
        let options = template.options().of_run();
        let mut imperfections = Imperfections::on_heap(&options)?;
        imperfections[0].become_run(&template.imperfections, &options);
        let mut chain = room(1)?;
        chain.push(None);
        let workspace = Workspace::new(&options, &mut imperfections[0])?;
        let set = InstructionSet::up_to(width);
        let singles = if width == 1 { runs } else { Single::of(runs, set, &options, &imperfections[0]) };
        let in_lanes = runs - singles;
        let mut batches = room(in_lanes.div_ceil(RUNS))?;
        for first in (0..in_lanes).step_by(RUNS) {
            batches.push(Batch::new(&options, &mut imperfections[0], RUNS.min(in_lanes - first))?);
        }
        let mut runs = Self {
            set,
            options,
            earth: options.earth(),
            first_run,
            imperfections,
            heights_are_shared: false,
            of_one: RefCell::new(Imperfections::on_heap(&options)?),
            signals: Signals::new()?,
            inputs: [SharedInput::new()?, SharedInput::new()?],
            chain: chain.into_boxed_slice(),
            batches,
            singles: Single::room(&options, singles)?,
            workspace,
        };
        runs.restart_sensors();
        Ok(runs)
    }

    /// Sets all processes and streams back to their start.
    fn restart_sensors(&mut self) {
        for place in 0..self.runs() {
            let (options, mut of_one) = (self.options_of(place), self.of_one.take());
            of_one[0].become_run(&self.imperfections[0], &options);
            self.at_mut(place).put_imperfections(&mut of_one[0]);
            self.of_one.replace(of_one);
        }
    }

    /// Back to before the first sample.
    pub fn reset(&mut self) {
        self.imperfections[0] = self.imperfections[0].restarted(&self.options);
        self.reposition();
        self.restart_sensors();
    }

    /// Options of a run.
    fn options_of(&self, place: usize) -> Options {
        let mut options = self.options;
        options.key.run = self.first_run + place as u64;
        options
    }

    /// Calls `act` with the sensors of one run.
    fn with_imperfections_of<T>(&self, place: usize, act: impl FnOnce(&mut Imperfections) -> T) -> T {
        let imperfections = &mut self.of_one.borrow_mut()[0];
        let (batch, lane) = match self.at(place) {
            Found::Lane(batch, lane) => (batch, lane),
            Found::Single(single) => {
                imperfections.copy_from(&single.imperfections);
                return act(imperfections);
            }
        };
        imperfections.become_run(&self.imperfections[0], &self.options_of(place));
        imperfections.follow_as(&self.imperfections[0]);
        batch.take_imperfections(lane, imperfections);
        if self.heights_are_shared {
            imperfections.altimeter.follow_as(&self.imperfections[0].altimeter);
        }
        act(imperfections)
    }

    /// The chain with which a run starts at the sample `first`.
    pub(super) fn start_of(
        &self,
        place: usize,
        first: &TruthPoint,
        interval: Option<&Recent<'_>>,
    ) -> Result<Chain, Error> {
        self.with_imperfections_of(place, |imperfections| {
            Chain::start(&self.options_of(place), self.earth, first, interval, imperfections)
        })
    }

    /// Starts all runs at the interval `first`. An error concerns the truth; then nothing has changed.
    #[cold]
    #[inline(never)]
    pub(super) fn start(&mut self, first: &Recent<'_>) -> Result<(), Error> {
        let height_m = first.current.height_m();
        let mut shared = None;
        for place in 0..self.runs() {
            let chain = self.start_of(place, first.current, Some(first));
            if place == 0 && matches!(&chain, Err(error) if is_of_truth(error)) {
                return chain.map(|_| ());
            }
            let has_started = chain.is_ok();
            let chain = chain.unwrap_or_else(|_| self.chain_of_truth(first.current));
            if has_started && self.imperfections[0].set().initial.alignment_s != 0.0 {
                // The sensors of the run, whose processes the alignment has moved on.
                let mut of_one = self.of_one.take();
                self.at_mut(place).put_imperfections(&mut of_one[0]);
                self.of_one.replace(of_one);
            }
            let at_start = LastGood { time_s: first.current.time_s, interval_s: 0.0 };
            let diverged = (!has_started).then_some(at_start);
            match self.at_mut(place) {
                Found::Lane(batch, lane) => {
                    batch.start(lane, height_m, &chain);
                    batch.diverged[lane] = diverged;
                }
                Found::Single(single) => {
                    single.imperfections.reposition(height_m);
                    (single.chain, single.diverged) = (Some(chain.clone()), diverged);
                }
            }
            if has_started {
                shared = shared.or(Some(chain));
            }
        }
        // If no run could start, the truth continues alone.
        self.chain[0] = Some(shared.unwrap_or_else(|| self.chain_of_truth(first.current)));
        self.imperfections[0].reposition(height_m);
        Ok(())
    }

    /// A chain with the solution of the truth, for a run that cannot start. Not inlined, to save stack.
    #[inline(never)]
    fn chain_of_truth(&self, first: &TruthPoint) -> Chain {
        Chain::to_load(&self.options, self.earth, first, &self.imperfections[0])
    }

    /// Writes a run as a simulator, with the samples of `intake`.
    pub fn save_run(&self, place: usize, intake: &Intake, to: &mut Writer<'_>) {
        let chain = self.chain_of(place);
        self.with_imperfections_of(place, |imperfections| {
            save_flight(&self.options_of(place), imperfections, intake, chain.as_ref(), to);
        });
    }

    /// Whether a simulator has the sensor settings of these runs, so that its state can be the state of a run.
    pub fn has_sensors_of(&self, simulator: &Simulator) -> bool {
        self.imperfections[0].is_set_as(&simulator.imperfections)
    }

    /// Takes in the state of `simulator` as a run.
    pub fn put_simulator(
        &mut self,
        place: usize,
        simulator: &mut Simulator,
        has_diverged: bool,
    ) -> Result<(), Error> {
        let diverged = has_diverged.then(|| {
            let (time_s, interval_s) = match (simulator.imu(), simulator.intake.front()) {
                (Some(imu), _) => (imu.time_s, imu.interval_s),
                (None, Some(first)) => (first.time_s, 0.0),
                (None, None) => (0.0, 0.0),
            };
            LastGood { time_s, interval_s }
        });
        // The last interval keeps a compensation that has been cancelled since.
        let was_compensated = simulator.imu().is_some_and(|imu| imu.compensated != imu.measured);
        let is_compensated = was_compensated || simulator.compensation() != Compensation::default();
        let chain = match &simulator.mode {
            Mode::Flying(chain) => Some(chain),
            _ => None,
        };
        let mut found = self.at_mut(place);
        match &mut found {
            Found::Lane(batch, lane) => {
                if is_compensated {
                    batch.make_room_for_compensations()?;
                }
                if let Some(chain) = chain {
                    batch.put_run(*lane, chain);
                }
                batch.diverged[*lane] = diverged;
            }
            Found::Single(single) => {
                (single.chain, single.diverged) = (chain.map(Chain::without_increments), diverged);
            }
        }
        found.put_imperfections(&mut simulator.imperfections);
        // What all runs share is that of the runs in lanes. A run that has diverged is used if there is no other.
        let shares = matches!(found, Found::Lane(..)) || self.batches.is_empty();
        if shares && (!has_diverged || self.chain[0].is_none()) {
            self.imperfections[0].follow_as(&simulator.imperfections);
            if let Mode::Flying(chain) = &simulator.mode {
                self.chain[0] = Some(chain.without_increments());
            }
        }
        Ok(())
    }
}

impl Found<&mut Batch, &mut Single> {
    /// Gives the run a copy of the sensors `imperfections`.
    fn put_imperfections(&mut self, imperfections: &mut Imperfections) {
        match self {
            Found::Lane(batch, lane) => batch.put_imperfections(*lane, imperfections),
            Found::Single(single) => single.imperfections.copy_from(imperfections),
        }
    }
}
