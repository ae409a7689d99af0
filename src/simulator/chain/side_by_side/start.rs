//! The start of the runs of an ensemble, and the conversion of runs from and to simulators.

use core::cell::RefCell;

use super::batch::Batch;
use super::shared::LastGood;
use super::workspace::Workspace;
use super::{Chain, SideBySide};
use crate::base::error::Error;
use crate::base::instruction_set::InstructionSet;
use crate::base::memory::room;
use crate::base::snapshot::Writer;
use crate::errors::correction::Compensation;
use crate::sensors::SharedInput;
use crate::signal::RUNS;
use crate::simulator::chain::view::Views;
use crate::simulator::signals::Signals;
use crate::simulator::snapshot::save_flight;
use crate::simulator::start::is_of_truth;
use crate::simulator::{Imperfections, Mode, Options, Simulator};
use crate::truth::{Intake, Recent, TruthPoint};

impl SideBySide {
    /// Runs from `first_run` on with the settings of `template`.
    pub fn new(
        template: &Simulator,
        first_run: u64,
        runs: usize,
        set: InstructionSet,
    ) -> Result<Self, Error> {
        let options = template.options().of_run();
        let mut imperfections = Imperfections::on_heap(&options)?;
        imperfections[0].become_run(&template.imperfections, &options);
        let mut chain = room(1)?;
        chain.push(None);
        let workspace = Workspace::new(&options, &mut imperfections[0])?;
        let mut batches = room(runs.div_ceil(RUNS))?;
        for first in (0..runs).step_by(RUNS) {
            batches.push(Batch::new(&options, &mut imperfections[0], RUNS.min(runs - first))?);
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
            workspace,
        };
        runs.restart_sensors();
        Ok(runs)
    }

    /// Sets all processes and streams back to their start.
    fn restart_sensors(&mut self) {
        for place in 0..self.runs() {
            let options = self.options_of(place);
            let imperfections = &mut self.of_one.get_mut()[0];
            imperfections.become_run(&self.imperfections[0], &options);
            self.batches[place / RUNS].put_imperfections(place % RUNS, imperfections);
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
        imperfections.become_run(&self.imperfections[0], &self.options_of(place));
        imperfections.follow_as(&self.imperfections[0]);
        self.batches[place / RUNS].take_imperfections(place % RUNS, imperfections);
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
            let batch = &mut self.batches[place / RUNS];
            if has_started && self.imperfections[0].set().initial.alignment_s != 0.0 {
                // The sensors of the run, whose processes the alignment has moved on.
                batch.put_imperfections(place % RUNS, &mut self.of_one.get_mut()[0]);
            }
            batch.start(place % RUNS, height_m, &chain);
            if has_started {
                shared = shared.or(Some(chain));
            } else {
                let time_s = first.current.time_s;
                batch.diverged[place % RUNS] = Some(LastGood { time_s, interval_s: 0.0 });
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
        let (batch, lane) = (&mut self.batches[place / RUNS], place % RUNS);
        // The last interval keeps a compensation that has been cancelled since.
        let was_compensated = simulator.imu().is_some_and(|imu| imu.compensated != imu.measured);
        if was_compensated || simulator.compensation() != Compensation::default() {
            batch.make_room_for_compensations()?;
        }
        batch.put_imperfections(lane, &mut simulator.imperfections);
        if let Mode::Flying(chain) = &simulator.mode {
            batch.put_run(lane, chain);
            if self.chain[0].is_none() || !has_diverged {
                let signals = Signals::default();
                self.chain[0] = Some(Chain { signals, views: Views::default(), ..chain.clone() });
            }
        }
        if has_diverged {
            let (time_s, interval_s) = match (simulator.imu(), simulator.intake.front()) {
                (Some(imu), _) => (imu.time_s, imu.interval_s),
                (None, Some(first)) => (first.time_s, 0.0),
                (None, None) => (0.0, 0.0),
            };
            batch.diverged[lane] = Some(LastGood { time_s, interval_s });
        }
        // A run that has diverged is used too, because its snapshot holds what all runs share.
        self.imperfections[0].follow_as(&simulator.imperfections);
        Ok(())
    }
}
