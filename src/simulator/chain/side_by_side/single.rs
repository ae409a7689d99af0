//! A run that is flown without lanes, as a simulator flies it, on the motion that all runs share. Few runs take less time so than in a
//! batch, all of whose lanes are computed.

use super::Chain;
use super::shared::LastGood;
use crate::base::error::Error;
use crate::base::instruction_set::InstructionSet;
use crate::base::memory::room;
use crate::earth::GravityModel;
use crate::mechanization::{Frame, Scheme};
use crate::sensors::{Failure, SensorOutput};
use crate::signal::{IntervalMotion, RUNS};
use crate::simulator::chain::view::Views;
use crate::simulator::signals::Signals;
use crate::simulator::{Imperfections, Options};
use crate::truth::Recent;

#[derive(Debug)]
pub(super) struct Single {
    pub imperfections: Imperfections,
    /// In flight, without its increments.
    pub chain: Option<Chain>,
    /// Last good solution, if the run has diverged.
    pub diverged: Option<LastGood>,
}

impl Single {
    /// Room for `count` runs.
    pub fn room(options: &Options, count: usize) -> Result<Box<[Self]>, Error> {
        let mut memory = room(count)?;
        for _ in 0..count {
            memory.push(Self::new(options));
        }
        Ok(memory.into_boxed_slice())
    }

    /// Not inlined, to save stack.
    #[inline(never)]
    fn new(options: &Options) -> Self {
        Self { imperfections: Imperfections::new(options), chain: None, diverged: None }
    }

    /// Number of `runs` that are flown so: the runs behind the last full batch, if they are few.
    ///
    /// Evidence: instructions that the first run of a batch adds to a step, divided by those of a run alone, for what a batch does lane
    /// by lane: 15 in geographic axes, 11 with a mounting, 7 with the paper's scheme, 6 with Somigliana's gravity.
    pub fn of(runs: usize, set: InstructionSet, options: &Options, imperfections: &Imperfections) -> usize {
        let few = if options.frame == Frame::Geographic {
            RUNS - 1
        } else if imperfections.mounting().is_some() {
            11
        } else if options.scheme == Scheme::Paper || options.gravity != GravityModel::Normal {
            6.max(set.few_runs())
        } else {
            set.few_runs()
        };
        let behind = runs % RUNS;
        if behind <= few { behind } else { 0 }
    }

    /// Flies the interval of `motion`, which `shared` has begun and which has `count` increments; the ideal ones are the first of
    /// `signals`.
    pub fn fly<'r>(
        &mut self,
        (shared, recent): (&Chain, &Recent<'r>),
        motion: &IntervalMotion<'r>,
        count: usize,
        signals: &mut Signals,
    ) {
        let (Some(chain), None) = (&mut self.chain, self.diverged) else { return };
        if chain
            .advance_with(&shared.generator, motion, recent, count, signals, &mut self.imperfections)
            .is_err()
        {
            self.diverged = Some(LastGood::of(shared, recent.current));
        }
    }

    /// Lets an output fail; `None` clears it.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>) {
        let last = self.chain.as_ref().and_then(Chain::imu).map(|imu| imu.mean_measured());
        self.imperfections.set_failure(output, failure, last.as_ref());
    }

    /// The run in flight. A run that has diverged has the truth of the others.
    pub fn chain_over(&self, shared: &Chain) -> Option<Chain> {
        let Chain { generator, closure, intervals, .. } = shared;
        let chain = self.chain.clone()?;
        Some(Chain { generator: generator.clone(), closure: *closure, intervals: *intervals, ..chain })
    }

    /// Marks the run as good again.
    pub fn revive(&mut self) {
        (self.chain, self.diverged) = (None, None);
    }
}

impl Chain {
    /// A copy that is not flown on its own increments.
    pub fn without_increments(&self) -> Self {
        Self { signals: Signals::default(), parts: 0..0, views: Views::default(), ..self.clone() }
    }
}
