//! The runs of an ensemble side by side: what they share is made once an interval, what differs goes in blocks of
//! [`RUNS`](crate::signal::RUNS).

mod block;
mod start;

use core::cell::RefCell;

use super::Chain;
use super::beside::conditions;
use crate::earth::Earth;
use crate::error::Error;
use crate::errors::NavigationErrors;
use crate::instruction_set::InstructionSet;
use crate::mechanization::{VerticalMode, is_for_lanes};
use crate::sensors::SharedInput;
use crate::signal::{Increment, RUNS};
use crate::simulator::aid::vertical_aid;
use crate::simulator::interval::LastInterval;
use crate::simulator::moment::Moment;
use crate::simulator::signals::Signals;
use crate::simulator::views::Views;
use crate::simulator::{ErrorSource, ImuInterval, Options, SensorSuite, Simulator, Solution};
use crate::truth::{FlightSample, Intake, Recent, TruthPoint};
use block::{Block, Interval, Workspace};

/// Runs over one truth, and what they share.
#[derive(Debug)]
pub(crate) struct SideBySide {
    set: InstructionSet,
    options: Options,
    earth: Earth,
    first_run: u64,
    /// What the host set, and what follows the signals.
    sensors: Box<[SensorSuite]>,
    /// Those of one run while they are needed.
    of_one: RefCell<Box<[SensorSuite]>>,
    signals: Signals,
    shared: [SharedInput; 2],
    /// One; in flight the chain without the navigators. On the heap, as it is much of a stack.
    chain: Box<[Option<Chain>]>,
    blocks: Vec<Block>,
    workspace: Box<[Workspace]>,
}

impl SideBySide {
    /// Whether so many runs of `template` can and should go side by side. Others have more that differs from run to run, and go one
    /// after the other; a run alone is faster so.
    pub fn is_for(template: &Simulator, runs: usize) -> bool {
        let (options, sensors) = (template.options(), &template.sensors);
        runs > 1
            && is_for_lanes(options.frame, options.gravity)
            && options.closed_loop_time_s.is_none()
            && !options.error_model
            && sensors.mounting().is_none()
            && !sensors.gravity.is_on()
            && sensors.gyro.goes_side_by_side()
            && sensors.accel.goes_side_by_side()
            && !sensors.altimeter.has_failed()
    }

    /// Flies the interval that `recent` ends. An error is one of the truth, and then nothing has changed.
    pub fn step(&mut self, recent: &Recent<'_>) -> Result<(), Error> {
        self.options.check_truth(recent.next)?;
        if self.chain[0].is_none() {
            self.start(recent)?;
        }
        let Self { set, options, earth, sensors, signals, shared, chain, blocks, workspace, .. } = self;
        let ([Some(chain)], [workspace], [sensors]) = (&mut **chain, &mut **workspace, &mut **sensors) else {
            return Ok(());
        };
        let (next, t) = (recent.next, recent.next.interval_s);
        let motion = chain.generator.advance(recent);
        let ideal = &mut signals.ideal[..options.subsamples * options.updates_over(recent)];
        motion.integrate(ideal);
        let dt = t / ideal.len() as f64;
        sensors.begin_interval(t, || conditions(recent, &motion, None));
        sensors.gyro.share(ideal, dt, &mut shared[0]);
        sensors.accel.share(ideal, dt, &mut shared[1]);

        let is_altimeter_ideal = sensors.altimeter.is_ideal();
        let aid = vertical_aid(options.vertical, next, |height_m| {
            // Where it is not, each run has its own.
            if is_altimeter_ideal { sensors.altimeter.sense(height_m, t) } else { Some(height_m) }
        });
        let start_s = recent.current.time_s;
        let interval = Interval { earth, options, sensors, shared, start_s, t, dt, count: ideal.len(), aid };
        blocks.iter_mut().for_each(|block| block.fly(*set, &interval, workspace));

        chain.views = Views::default();
        chain.last = LastInterval::Loaded {
            imu: ImuInterval {
                time_s: next.time_s,
                interval_s: t,
                ideal: Increment::sum(ideal),
                ..ImuInterval::default()
            },
            vertical_unaided: options.vertical == VerticalMode::Free,
        };
        chain.conclude(&motion, recent);
        Ok(())
    }

    /// Time of the last good solution of a run that has diverged [s].
    pub fn diverged_s(&self, place: usize) -> Option<f64> {
        self.blocks[place / RUNS].diverged_s(place % RUNS)
    }

    /// Refuses a sample without the temperature that a sensor effect needs.
    pub fn check_temperature(&self, sample: &FlightSample) -> Result<(), Error> {
        self.sensors[0].check_temperature(sample.temperature_c)
    }

    /// How many runs.
    pub fn runs(&self) -> usize {
        self.blocks.iter().map(Block::count).sum()
    }

    /// Bytes that a run takes.
    pub fn bytes_of_run(&self) -> usize {
        self.blocks.first().map_or(0, Block::bytes_of_run)
    }

    /// The navigated solution of a run; `intake` is that of the truth.
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
        let (block, lane) = (&self.blocks[place / RUNS], place % RUNS);
        let mut chain = shared.clone();
        chain.mechanization = block.navigator(lane, &self.earth, self.options.scheme);
        chain.north_unknown = block.north_unknown(lane);
        if let LastInterval::Loaded { imu, .. } = &mut chain.last {
            (imu.measured, imu.flags) = block.measured(lane);
            imu.time_s = block.diverged_s(lane).unwrap_or(imu.time_s);
        }
        chain.views = Views { truth: shared.views.truth.clone(), ..Views::default() };
        Some(chain)
    }

    /// The truth in flight, which is at `truth`.
    pub fn truth(&self, truth: &TruthPoint) -> Option<Solution> {
        self.chain[0].as_ref().map(|chain| Moment { chain, point: truth }.truth())
    }

    /// The velocity of the truth at `point`, 0 so far, is known.
    #[cold]
    #[inline(never)]
    pub fn take_first_velocity(&mut self, point: &TruthPoint) {
        for place in 0..self.runs() {
            if let (Some(mut chain), None) = (self.chain_of(place), self.diverged_s(place)) {
                chain.take_first_velocity(point, &self.sensors[0]);
                self.blocks[place / RUNS].put_navigator(place % RUNS, &chain.mechanization);
            }
        }
        if let Some(chain) = &mut self.chain[0] {
            chain.views = Views::default();
        }
    }

    /// The truth jumps: before the first step.
    pub fn reposition(&mut self) {
        self.chain[0] = None;
        self.blocks.iter_mut().for_each(Block::revive);
    }
}
