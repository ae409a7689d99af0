//! The simulator: the blocks of the paper's figure 1 put together, one interval after the other.

mod aid;
mod chain;
mod closed_loop;
mod closure;
mod disturbance;
mod drift;
mod effect;
mod imperfections;
mod imu;
mod moment;
mod navigator;
mod options;
mod parameters;
mod read;
pub mod record;
mod settings;
mod signals;
mod snapshot;
mod solution;
mod start;

pub(crate) use chain::side_by_side::SideBySide;
pub use closed_loop::TrimFigures;
pub use closure::ClosureFigures;
pub(crate) use drift::Bound;
pub use effect::{BudgetEffect, EFFECTS};
pub use imu::{ImuFlags, ImuInterval};
pub(crate) use moment::{Moment, View};
pub use options::{MAX_UPDATES, Options};
pub use parameters::ErrorParameters;
#[cfg(test)]
pub(crate) use parameters::rows;
pub(crate) use parameters::with_time;
pub use solution::Solution;
pub(crate) use start::is_of_truth;

use nalgebra::Vector3;

use crate::base::error::{Error, ErrorKind, Rule};
use crate::base::instruction_set::InstructionSet;
use crate::base::memory::{only, room};
use crate::earth::Earth;
use crate::earth::state::Navigation;
use crate::errors::NavigationErrors;
use crate::errors::correction::Correction;
use crate::errors::covariance::Propagation;
use crate::sensors::StreamKey;
use crate::signal::Increment;
use crate::truth::{FlightSample, Intake, Pushed, TruthPoint, TruthSummary};
use chain::Chain;
use imperfections::Imperfections;
use navigator::Navigator;
use read::READ_WIDTH;
use signals::Signals;

/// The two sources of errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorSource {
    /// Navigation minus truth: the paper's error data 2.
    Navigation = 0,
    /// The error differential equations: the paper's error data 1 (sins_options.error_model).
    Model = 1,
}

/// Whether a step was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// One interval was flown.
    Done,
    /// There is no complete interval yet.
    NeedSample,
}

/// What the simulator is doing.
#[derive(Debug, Clone)]
#[expect(
    clippy::large_enum_variant,
    reason = "one in a simulator, which lives on the heap; nothing is allocated in flight"
)]
enum Mode {
    /// Before the first step.
    Waiting,
    /// Flying the host's samples.
    Flying(Chain),
    /// Navigating on the host's increments.
    Navigating(Navigator),
}

/// A strapdown inertial navigation system in simulation. It is `Send`, not `Sync`, because a read keeps its result for the next
/// read.
#[derive(Debug, Clone)]
pub struct Simulator {
    options: Options,
    earth: Earth,
    intake: Intake,
    imperfections: Imperfections,
    /// Increments of a flight to come. In flight, the chain has them.
    signals: Signals,
    /// Covariance of a flight to come: no element or one. In flight, the chain has it.
    covariance: Box<[Propagation]>,
    /// Summary of the truth of the flights so far, if it is wanted. In flight, the chain has it.
    summary: Option<TruthSummary>,
    mode: Mode,
}

impl Simulator {
    /// A simulator with ideal sensors.
    pub fn new(options: &Options) -> Result<Self, Error> {
        let covariance = Propagation::new(options.covariance, options.earth(), options.vertical)?;
        Ok(Self::with(options, Self::intake(options)?, Signals::new()?, covariance))
    }

    /// The part of making a simulator that fails if an option is invalid.
    fn intake(options: &Options) -> Result<Intake, Error> {
        options.validate()?;
        Intake::new(options.earth(), options.axes, options.intake)
    }

    /// The rest of making a simulator. It returns no `Result`, which would hold another copy on the stack.
    fn with(options: &Options, intake: Intake, signals: Signals, covariance: Box<[Propagation]>) -> Self {
        Self {
            options: *options,
            earth: options.earth(),
            intake,
            imperfections: Imperfections::new(options),
            signals,
            covariance,
            summary: options.truth_summary.then(TruthSummary::default),
            mode: Mode::Waiting,
        }
    }

    /// The options that the simulator was made with.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// Takes in one flight-control sample.
    pub fn push_sample(&mut self, sample: &FlightSample) -> Result<Pushed, Error> {
        self.refuse_while_navigating()?;
        self.imperfections.check_temperature(sample.temperature_c)?;
        let pushed = self.intake.push(sample)?;
        if pushed == Pushed::FirstVelocity {
            self.take_first_velocity();
        }
        Ok(pushed)
    }

    #[cold]
    #[inline(never)]
    fn take_first_velocity(&mut self) {
        if let (Mode::Flying(chain), Some(current)) = (&mut self.mode, self.intake.current()) {
            chain.take_first_velocity(current, &self.imperfections);
        }
    }

    /// Flies one sample interval: truth, ideal signals, sensors, mechanization, errors.
    pub fn step(&mut self) -> Result<Step, Error> {
        self.refuse_while_navigating()?;
        let Mode::Flying(chain) = &mut self.mode else { return self.first_step() };
        let Some(recent) = self.intake.recent() else { return Ok(Step::NeedSample) };
        chain.advance(&recent, &mut self.imperfections)?;
        self.intake.take();
        Ok(Step::Done)
    }

    /// The first step of a flight. It is a separate function, because a new chain takes much stack.
    #[cold]
    #[inline(never)]
    fn first_step(&mut self) -> Result<Step, Error> {
        if self.intake.waiting() < 2 {
            return Ok(Step::NeedSample);
        }
        let mut imperfections = self.imperfections.clone();
        let mut chain = self.chain_with(&mut imperfections)?;
        let Some(first) = self.intake.first_interval() else { return Ok(Step::NeedSample) };
        imperfections.reposition(first.current.height_m());
        chain.signals = core::mem::take(&mut self.signals);
        chain.set_summary(self.summary);
        chain.begin_covariance(core::mem::take(&mut self.covariance), first.current, &imperfections);
        if let Err(error) = chain.advance(&first, &mut imperfections) {
            (self.signals, self.covariance) = (chain.signals, chain.covariance);
            self.covariance.iter_mut().for_each(Propagation::undo_start);
            return Err(error);
        }
        self.imperfections = imperfections;
        self.intake.take();
        self.intake.take();
        self.mode = Mode::Flying(chain);
        Ok(Step::Done)
    }

    /// Starts navigation without a truth, from `navigation` at `time_s` [s]. [`Self::push_imu`] then gives the increments.
    pub fn start_navigation(&mut self, time_s: f64, navigation: &Navigation) -> Result<(), Error> {
        if !matches!(self.mode, Mode::Waiting) || self.intake.waiting() > 0 {
            return Err(Error::bad_state(
                "navigation on increments can start only before the first sample or after a reset",
            ));
        }
        if self.imperfections.depend_on_temperature() {
            return Err(Error::bad_state(settings::INCREMENTS_HAVE_NO_TEMPERATURE));
        }
        let navigator = Navigator::new(&self.options, self.earth, time_s, navigation);
        navigator.check()?;
        self.mode = Mode::Navigating(navigator);
        Ok(())
    }

    /// Navigates on `increments` (1 to 5, of equal length) over `interval_s` [s]. The sensor errors that are set are added to the
    /// increments.
    pub fn push_imu(&mut self, increments: &[Increment], interval_s: f64) -> Result<(), Error> {
        let Mode::Navigating(navigator) = &mut self.mode else {
            return Err(Error::bad_state("navigation on increments must be started first"));
        };
        navigator.advance(increments, interval_s, &mut self.imperfections)
    }

    /// Moves the truth to `sample`. The INS starts again there; its noise continues.
    pub fn reposition(&mut self, sample: &FlightSample) -> Result<(), Error> {
        self.refuse_while_navigating()?;
        self.imperfections.check_temperature(sample.temperature_c)?;
        self.intake.restart(sample)?;
        self.wait();
        Ok(())
    }

    /// Moves the truth to `sample`, which may be at another time. The INS continues there with the errors that it has. Samples that
    /// wait are dropped. Before the first step the call is the same as [`Self::reposition`].
    #[inline(never)]
    pub fn move_truth(&mut self, sample: &FlightSample) -> Result<(), Error> {
        self.refuse_while_navigating()?;
        self.imperfections.check_temperature(sample.temperature_c)?;
        match (&mut self.mode, self.intake.current()) {
            (Mode::Flying(chain), Some(current)) => {
                let point = self.intake.first_point(sample)?;
                chain.move_truth(current, &point, &mut self.imperfections)?;
                self.intake.go_on_from(point);
                Ok(())
            }
            _ => self.reposition(sample),
        }
    }

    /// Sets the time of the sample that was pushed last to `time_s` [s]; everything else stays as it was. The flight continues like
    /// a flight whose time stamps never jumped.
    pub fn move_time(&mut self, time_s: f64) -> Result<(), Error> {
        self.refuse_while_navigating()?;
        let shift_s = self.intake.move_time(time_s)?;
        if let (Mode::Flying(chain), Some(current)) = (&mut self.mode, self.intake.current()) {
            chain.move_time(shift_s, current.time_s);
        }
        Ok(())
    }

    /// Removes errors that the host estimated from the solution, and adds those of the sensors to the compensation, which acts from
    /// the next interval on. Truth, sensors and random numbers stay as they are. On an error nothing has changed.
    #[inline(never)]
    pub fn correct(&mut self, correction: &Correction) -> Result<(), Error> {
        correction.validate()?;
        match (&mut self.mode, self.intake.current()) {
            (Mode::Flying(chain), Some(current)) => chain.correct(current, correction),
            (Mode::Navigating(navigator), _) => navigator.correct(correction),
            _ => Err(nothing_to_correct()),
        }
    }

    /// Notes that the heading of the solution is known, whatever the alignment at the start found.
    pub(crate) fn find_north(&mut self) {
        if let Mode::Flying(chain) = &mut self.mode {
            chain.north_unknown = false;
        }
    }

    /// Removes what `correction` gives for the key of the random numbers and for the errors of the solution.
    #[cold]
    pub fn correct_each(
        &mut self,
        correction: impl Fn(StreamKey, &NavigationErrors) -> Correction,
    ) -> Result<(), Error> {
        match self.errors(ErrorSource::Navigation)? {
            Some((_, errors)) => self.correct(&correction(self.options.key, &errors)),
            None => Err(nothing_to_correct()),
        }
    }

    /// Goes back to before the first sample, with the same parameters, seed and draws, and without failures.
    #[inline(never)]
    pub fn reset(&mut self) {
        self.intake.clear();
        self.imperfections = self.imperfections.restarted(&self.options);
        self.wait();
        self.summary = self.options.truth_summary.then(TruthSummary::default);
        self.covariance.iter_mut().for_each(Propagation::reset);
    }

    /// Ends the flight: the simulator is before the first step again.
    fn wait(&mut self) {
        if let Mode::Flying(chain) = &mut self.mode {
            self.signals = core::mem::take(&mut chain.signals);
            self.summary = chain.summary;
            self.covariance = core::mem::take(&mut chain.covariance);
        }
        self.mode = Mode::Waiting;
    }

    /// Intervals flown since the start or the last reposition.
    pub fn intervals(&self) -> u64 {
        match &self.mode {
            Mode::Flying(chain) => chain.intervals(),
            _ => 0,
        }
    }

    /// Whether a step has been made since the start or the last reposition, or the navigation was started.
    pub fn has_started(&self) -> bool {
        !matches!(self.mode, Mode::Waiting)
    }

    /// The point of the truth to which the last step has flown; `None` while navigating on increments.
    pub(crate) fn true_point(&self) -> Option<&TruthPoint> {
        match self.mode {
            Mode::Flying(_) => self.intake.current(),
            _ => None,
        }
    }

    /// Mean acceleration of the truth against the Earth in the last interval, Earth-fixed axes \[m/s²\]; `None` without a truth.
    pub(crate) fn true_acceleration_e(&self) -> Option<Vector3<f64>> {
        let [now, before, _] = self.intake.behind();
        let (now, before) = (now?, before?);
        Some((now.state.v_e - before.state.v_e) / now.interval_s)
    }

    /// Whether the last step flew the first interval since the truth began, or jumped.
    pub(crate) fn is_first_interval(&self) -> bool {
        self.intake.behind()[2].is_none()
    }

    /// Samples that wait for a step.
    pub fn waiting_samples(&self) -> usize {
        self.intake.waiting()
    }

    #[inline(never)]
    fn chain_from_first_sample(&self) -> Result<Chain, Error> {
        self.chain_with(&mut self.imperfections.clone())
    }

    /// The chain with which the flight starts with `imperfections`, those of the simulator.
    fn chain_with(&self, imperfections: &mut Imperfections) -> Result<Chain, Error> {
        match self.intake.front() {
            Some(first) => {
                let interval = self.intake.first_interval();
                Chain::start(&self.options, self.earth, first, interval.as_ref(), imperfections)
            }
            None => Err(Error::bad_state("no sample yet")),
        }
    }

    /// Rejects calls that need a truth while the simulator navigates on increments.
    pub(crate) fn refuse_while_navigating(&self) -> Result<(), Error> {
        match self.mode {
            Mode::Navigating(_) => Err(Error::bad_state(
                "navigating on increments: there is no truth; reset before samples are pushed",
            )),
            _ => Ok(()),
        }
    }
}

/// A simulator on the heap, because two simulators and a step need more stack than a call may take.
#[inline(never)]
pub(crate) fn heap_simulator(options: &Options) -> Result<Box<[Simulator; 1]>, Error> {
    // The instruction set of the processor is queried now, not by the first read.
    InstructionSet::up_to(READ_WIDTH);
    let mut memory = room(1)?;
    let (intake, signals) = (Simulator::intake(options)?, Signals::new()?);
    let covariance = Propagation::new(options.covariance, options.earth(), options.vertical)?;
    memory.push(Simulator::with(options, intake, signals, covariance));
    only(memory)
}

/// The error for a correction without a solution.
pub(crate) fn nothing_to_correct() -> Error {
    Error::bad_state("there is nothing to correct before the first step; initial errors can be set")
}

/// The error for a solution that is singular: `value` of `field` breaks `limit`.
fn singular(field: &'static str, value: f64, words: &'static str, limit: f64) -> Error {
    Error::of(ErrorKind::Singular, field, value, Rule::SentenceWith(words, limit.into()))
}
