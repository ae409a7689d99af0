//! The runs of an ensemble from one by one to side by side, and back.

use super::block::{Block, Workspace};
use super::{Chain, SideBySide};
use crate::error::Error;
use crate::instruction_set::InstructionSet;
use crate::memory::{OnHeap, room};
use crate::sensors::SharedInput;
use crate::signal::RUNS;
use crate::simulator::signals::Signals;
use crate::simulator::snapshot::save_flight;
use crate::simulator::start::is_of_truth;
use crate::simulator::views::Views;
use crate::simulator::{Mode, Options, SensorSuite, Simulator, push_simulator};
use crate::snapshot::Writer;
use crate::truth::{Intake, Recent, TruthPoint};

impl SideBySide {
    /// Runs from `first_run` on with the settings of `template`, for which [`Self::is_for`] holds.
    #[inline(never)]
    pub fn new(
        template: &Simulator,
        first_run: u64,
        runs: usize,
        set: InstructionSet,
    ) -> Result<OnHeap<Self>, Error> {
        let options = template.options().of_run();
        let mut sensors = template.sensors.of_run(&options);
        let workspace = Workspace::new(&mut sensors)?;
        let mut blocks = room(runs.div_ceil(RUNS))?;
        for first in (0..runs).step_by(RUNS) {
            blocks.push(Block::new(&mut sensors, RUNS.min(runs - first))?);
        }
        let (signals, shared) = (Signals::new()?, [SharedInput::new()?, SharedInput::new()?]);
        let earth = options.earth();
        let mut runs = OnHeap::new(|| Self {
            set,
            options,
            earth,
            first_run,
            sensors,
            signals,
            shared,
            chain: None,
            blocks,
            workspace,
        })?;
        runs.restart_sensors();
        Ok(runs)
    }

    /// All processes and streams are back at their start.
    fn restart_sensors(&mut self) {
        for place in 0..self.runs() {
            let mut sensors = self.sensors.of_run(&self.options_of(place));
            self.blocks[place / RUNS].put_sensors(place % RUNS, &mut sensors);
        }
    }

    /// Back to before the first sample.
    pub fn reset(&mut self) {
        self.sensors = self.sensors.restarted(&self.options);
        self.reposition();
        self.restart_sensors();
    }

    /// Options of a run.
    fn options_of(&self, place: usize) -> Options {
        let mut options = self.options;
        options.key.run = self.first_run + place as u64;
        options
    }

    /// The sensors of a run by itself.
    fn sensors_of(&self, place: usize) -> SensorSuite {
        let mut sensors = self.sensors.of_run(&self.options_of(place));
        sensors.follow_as(&self.sensors);
        self.blocks[place / RUNS].take_sensors(place % RUNS, &mut sensors);
        sensors
    }

    /// The chain with which a run starts at the sample `first`.
    pub(super) fn start_of(
        &self,
        place: usize,
        first: &TruthPoint,
        interval: Option<&Recent<'_>>,
    ) -> Result<Chain, Error> {
        Chain::start(&self.options_of(place), self.earth, first, interval, &self.sensors_of(place))
    }

    /// All runs start at the interval `first`. An error is one of the truth, and then nothing has changed.
    #[cold]
    #[inline(never)]
    pub(super) fn start(&mut self, first: &Recent<'_>) -> Result<(), Error> {
        let height_m = first.current.sample.place.height_m;
        let mut shared = None;
        for place in 0..self.runs() {
            let chain = self.start_of(place, first.current, Some(first));
            if place == 0 && matches!(&chain, Err(error) if is_of_truth(error)) {
                return chain.map(|_| ());
            }
            let start = chain.as_ref().ok().map(|chain| (&chain.mechanization, chain.north_unknown));
            let time_s = first.current.time_s;
            self.blocks[place / RUNS].start(place % RUNS, height_m, start, time_s);
            shared = shared.or(chain.ok());
        }
        self.chain = Some(match shared {
            Some(chain) => chain,
            // All have diverged: the truth goes on.
            None => Chain::to_load(&self.options, self.earth, first.current, &self.sensors),
        });
        self.sensors.reposition(height_m);
        Ok(())
    }

    /// Pushes the simulator of a run, with the samples of `intake`, to `memory`, which has room for it.
    pub fn push_simulator(
        &self,
        place: usize,
        intake: &Intake,
        memory: &mut Vec<Simulator>,
    ) -> Result<(), Error> {
        push_simulator(memory, &self.options_of(place))?;
        if let Some(simulator) = memory.last_mut() {
            simulator.intake = intake.clone();
            simulator.sensors = self.sensors_of(place);
            if let Some(mut chain) = self.chain_of(place) {
                chain.signals = core::mem::take(&mut simulator.signals);
                simulator.mode = Mode::Flying(chain);
            }
        }
        Ok(())
    }

    /// Writes a run as the simulator that it is, with the samples of `intake`.
    pub fn save_run(&self, place: usize, intake: &Intake, to: &mut Writer<'_>) {
        let chain = self.chain_of(place);
        save_flight(&self.options_of(place), &self.sensors_of(place), intake, chain.as_ref(), to);
    }

    /// Takes a run in that `simulator` has been so far.
    pub fn put_simulator(&mut self, place: usize, simulator: &mut Simulator, has_diverged: bool) {
        let (block, lane) = (&mut self.blocks[place / RUNS], place % RUNS);
        block.put_sensors(lane, &mut simulator.sensors);
        if let Mode::Flying(chain) = &simulator.mode {
            block.put_run(lane, chain);
            if self.chain.is_none() || !has_diverged {
                let signals = Signals::default();
                self.chain = Some(Chain { signals, views: Views::default(), ..chain.clone() });
            }
        }
        if has_diverged {
            let time_s = match (simulator.imu(), simulator.intake.front()) {
                (Some(imu), _) => imu.time_s,
                (None, Some(first)) => first.time_s,
                (None, None) => 0.0,
            };
            block.put_diverged(lane, time_s);
        } else {
            self.sensors.follow_as(&simulator.sensors);
        }
    }
}
