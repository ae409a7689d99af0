//! Some runs side by side.

use core::ops::Range;

use crate::earth::Earth;
use crate::error::Error;
use crate::instruction_set::{InstructionSet, Work};
use crate::errors::{ErrorModel, ModelBlock, ModelInterval};
use crate::mechanization::{
    AidOfEach, Mechanization, NavigatorBlock, Scratch, VerticalAid, VerticalMode,
};
use crate::memory::room;
use crate::sensors::{Altimeter, FailingTriad, Failure, SensorOutput, SharedInput, StateRows, Triad};
use crate::signal::{Increment, IncrementRows, MAX_INCREMENTS, RUNS, Row, increment_of};
use crate::simulator::chain::Chain;
use crate::simulator::{ImuFlags, ImuInterval, Options, SensorSuite};

/// What an interval brings to all blocks.
pub(super) struct Interval<'a> {
    pub earth: &'a Earth,
    pub options: &'a Options,
    pub sensors: &'a SensorSuite,
    pub shared: &'a [SharedInput; 2],
    /// At its start.
    pub last_good: LastGood,
    /// Length [s], and that of its increments.
    pub t: f64,
    pub dt: f64,
    /// Number of increments.
    pub count: usize,
    /// Of altimeters with errors the true height.
    pub aid: VerticalAid,
    /// Whether each run has an altimeter of its own.
    pub has_altimeters: bool,
    /// Where the error model is on.
    pub model: Option<ModelInterval<'a>>,
}

/// The last good solution of a run that has diverged.
#[derive(Debug, Clone, Copy)]
pub(super) struct LastGood {
    /// Time [s].
    pub time_s: f64,
    /// Length of the interval that led to it [s]; 0: it is the start.
    pub interval_s: f64,
}

/// What is told of the last interval of a run beside its signals.
#[derive(Debug, Clone, Copy, Default)]
struct Report {
    flags: ImuFlags,
    /// Nothing aided the vertical channel.
    is_unaided: bool,
}

/// Numbers in the longest vector of any instruction set.
const LANES: usize = 8;

/// Up to [`RUNS`] runs.
#[derive(Debug)]
pub(super) struct Block {
    count: usize,
    /// Lanes that are computed: whole vectors. Those beyond the runs are copies of the last one.
    lanes: usize,
    gyro: StateRows,
    accel: StateRows,
    navigators: NavigatorBlock,
    /// None or one.
    models: Box<[ModelBlock]>,
    /// Sum of the measured increments of the last interval.
    measured: IncrementRows,
    reports: [Report; RUNS],
    north_unknown: [bool; RUNS],
    /// Of runs that have diverged.
    diverged: [Option<LastGood>; RUNS],
    /// Failures of gyros and accelerometers.
    failures: [Box<[FailingTriad]>; 2],
    /// Where they damp the vertical channel; up to date where they have errors.
    altimeters: Box<[Altimeter]>,
}

/// What a step needs beside a block, and the block as it was before.
#[derive(Debug)]
pub(super) struct Workspace {
    /// Of the longest interval. By itself, or the compiler fears that it lies over the rest.
    measured: Box<[IncrementRows]>,
    scratch: Scratch,
    heights_m: Row,
    is_unaided: [bool; RUNS],
    saturated: [[u64; RUNS]; 2],
    is_good: [u64; RUNS],
    gyro: StateRows,
    accel: StateRows,
    navigators: NavigatorBlock,
    models: Box<[ModelBlock]>,
    failures: [Box<[FailingTriad]>; 2],
    reports: [Report; RUNS],
    sums: IncrementRows,
}

/// Room for the failures of so many runs.
fn failures(sensors: &SensorSuite, count: usize) -> Result<[Box<[FailingTriad]>; 2], Error> {
    let of = |triad: &Triad| {
        let mut failures = room(count)?;
        failures.resize(count, triad.failures().clone());
        Ok(failures.into_boxed_slice())
    };
    Ok([of(&sensors.gyro)?, of(&sensors.accel)?])
}

/// Room for the error models of a block, where they are on.
fn models(options: &Options) -> Result<Box<[ModelBlock]>, Error> {
    let mut models = room(1)?;
    models.extend(options.error_model.then(|| ModelBlock::new(options.frame)));
    Ok(models.into_boxed_slice())
}

impl Workspace {
    /// For blocks with the sensors of `sensors`. On the heap, as it is much of a stack.
    pub fn new(options: &Options, sensors: &mut SensorSuite) -> Result<Box<[Self]>, Error> {
        let (gyro, accel) = (sensors.gyro.rows()?, sensors.accel.rows()?);
        let (mut memory, mut measured) = (room(1)?, room(MAX_INCREMENTS)?);
        measured.resize(MAX_INCREMENTS, [[0.0; RUNS]; 6]);
        memory.push(Self {
            measured: measured.into_boxed_slice(),
            scratch: Scratch::NONE,
            heights_m: [0.0; RUNS],
            is_unaided: [false; RUNS],
            saturated: [[0; RUNS]; 2],
            is_good: [0; RUNS],
            gyro,
            accel,
            navigators: NavigatorBlock::new(options.frame),
            models: models(options)?,
            failures: failures(sensors, RUNS)?,
            reports: [Report::default(); RUNS],
            sums: [[0.0; RUNS]; 6],
        });
        Ok(memory.into_boxed_slice())
    }
}

impl Block {
    /// Room for `count` runs.
    pub fn new(options: &Options, sensors: &mut SensorSuite, count: usize) -> Result<Self, Error> {
        let mut altimeters = Vec::new();
        if options.vertical == VerticalMode::Damped {
            altimeters = room(count)?;
            altimeters.resize(count, sensors.altimeter.clone());
        }
        Ok(Self {
            count,
            lanes: count.next_multiple_of(LANES).min(RUNS),
            gyro: sensors.gyro.rows()?,
            accel: sensors.accel.rows()?,
            navigators: NavigatorBlock::new(options.frame),
            models: models(options)?,
            measured: [[0.0; RUNS]; 6],
            reports: [Report::default(); RUNS],
            north_unknown: [false; RUNS],
            diverged: [None; RUNS],
            failures: failures(sensors, count)?,
            altimeters: altimeters.into_boxed_slice(),
        })
    }

    pub fn count(&self) -> usize {
        self.count
    }

    pub fn bytes_of_run(&self) -> usize {
        size_of::<Self>() / RUNS
            + self.gyro.bytes_of_run()
            + self.accel.bytes_of_run()
            + size_of_val(&*self.altimeters) / self.count
            + 2 * size_of::<FailingTriad>()
            + size_of_val(&*self.models) / RUNS
    }

    /// Lays the sensors of a run in.
    pub fn put_sensors(&mut self, lane: usize, sensors: &mut SensorSuite) {
        for lane in self.copies_of(lane) {
            sensors.gyro.put_into(&mut self.gyro, lane);
            sensors.accel.put_into(&mut self.accel, lane);
        }
        self.failures[0][lane].clone_from(sensors.gyro.failures());
        self.failures[1][lane].clone_from(sensors.accel.failures());
        if let Some(altimeter) = self.altimeters.get_mut(lane) {
            altimeter.clone_from(&sensors.altimeter);
        }
    }

    /// Lets an output of all runs fail, whose last interval, if there was one, had the length `interval_s` [s].
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>, interval_s: Option<f64>) {
        for lane in 0..self.count {
            let interval_s = match self.diverged[lane] {
                Some(LastGood { interval_s, .. }) => Some(interval_s).filter(|interval_s| *interval_s > 0.0),
                None => interval_s,
            };
            let sum = increment_of(&self.measured, lane);
            let last = interval_s
                .map(|t| Increment { angle: sum.angle / t, velocity: sum.velocity / t });
            match output {
                SensorOutput::Gyro(axis) => {
                    let last = last.map(|mean| mean.angle[axis as usize]);
                    self.failures[0][lane].set(axis, failure, last);
                }
                SensorOutput::Accelerometer(axis) => {
                    let last = last.map(|mean| mean.velocity[axis as usize]);
                    self.failures[1][lane].set(axis, failure, last);
                }
                SensorOutput::Altimeter => {
                    if let Some(altimeter) = self.altimeters.get_mut(lane) {
                        altimeter.set_failure(failure);
                    }
                }
            }
        }
    }

    /// The altimeters of all runs, which were ideal, have shown what `altimeter` has.
    pub fn follow(&mut self, altimeter: &Altimeter) {
        self.altimeters.iter_mut().for_each(|of_run| of_run.follow_as(altimeter));
    }

    /// Takes what a run keeps out, over `sensors` of the same parameters and key.
    pub fn take_sensors(&self, lane: usize, sensors: &mut SensorSuite) {
        sensors.gyro.take_from(&self.gyro, lane);
        sensors.accel.take_from(&self.accel, lane);
        sensors.take_failures(&self.failures[0][lane], &self.failures[1][lane]);
        if let Some(altimeter) = self.altimeters.get(lane) {
            sensors.altimeter.clone_from(altimeter);
        }
    }

    /// A run starts so, or cannot.
    pub fn start(&mut self, lane: usize, height_m: f64, start: Option<&Chain>, time_s: f64) {
        if let Some(altimeter) = self.altimeters.get_mut(lane) {
            altimeter.reposition(height_m);
        }
        match start {
            Some(chain) => self.put_run(lane, chain),
            None => self.diverged[lane] = Some(LastGood { time_s, interval_s: 0.0 }),
        }
    }

    /// Time of the last good solution of a run that has diverged [s].
    pub fn diverged_s(&self, lane: usize) -> Option<f64> {
        self.diverged[lane].map(|last_good| last_good.time_s)
    }

    /// All are good again.
    pub fn revive(&mut self) {
        self.diverged = [None; RUNS];
    }

    pub fn navigator(&self, lane: usize, earth: &Earth, options: &Options) -> Mechanization {
        self.navigators.get(lane, earth, options.scheme)
    }

    /// Where it is on.
    pub fn error_model(&self, lane: usize, earth: &Earth) -> Option<ErrorModel> {
        self.models.first().map(|models| models.get(lane, earth))
    }

    /// Navigator and error model of a run are those of `chain` from now on.
    pub fn put_solution(&mut self, lane: usize, chain: &Chain) {
        for lane in self.copies_of(lane) {
            self.navigators.put(lane, &chain.mechanization);
            for (models, model) in self.models.iter_mut().zip(&chain.error_model) {
                models.put(lane, model);
            }
        }
    }

    /// The lanes with the run at `lane`.
    fn copies_of(&self, lane: usize) -> Range<usize> {
        if lane + 1 == self.count { lane..self.lanes } else { lane..lane + 1 }
    }

    /// Takes a run in that has flown as `chain` so far.
    pub fn put_run(&mut self, lane: usize, chain: &Chain) {
        self.put_solution(lane, chain);
        self.north_unknown[lane] = chain.north_unknown;
        if let Some(ImuInterval { measured: Increment { angle, velocity }, flags, .. }) = chain.imu() {
            for axis in 0..3 {
                self.measured[axis][lane] = angle[axis];
                self.measured[3 + axis][lane] = velocity[axis];
            }
            let is_unaided = chain.last.vertical_unaided().unwrap_or_default();
            self.reports[lane] = Report { flags, is_unaided };
        }
    }

    /// A run has diverged.
    pub fn put_diverged(&mut self, lane: usize, last_good: LastGood) {
        self.diverged[lane] = Some(last_good);
    }

    pub fn north_unknown(&self, lane: usize) -> bool {
        self.north_unknown[lane]
    }

    /// What the sensors gave in the last interval, and their flags.
    pub fn measured(&self, lane: usize) -> (Increment, ImuFlags) {
        (increment_of(&self.measured, lane), self.reports[lane].flags)
    }

    /// Whether nothing aided the vertical channel in it.
    pub fn is_unaided(&self, lane: usize) -> bool {
        self.reports[lane].is_unaided
    }

    /// Flies an interval.
    pub fn fly(&mut self, set: InstructionSet, interval: &Interval<'_>, workspace: &mut Workspace) {
        workspace.gyro.copy_from(&self.gyro);
        workspace.accel.copy_from(&self.accel);
        workspace.navigators.clone_from(&self.navigators);
        workspace.models.clone_from(&self.models);
        (workspace.sums, workspace.reports) = (self.measured, self.reports);
        self.begin_failures(interval, workspace);
        workspace.is_unaided = [interval.aid == VerticalAid::None; RUNS];
        if let (VerticalAid::Barometer { height_m }, true) = (interval.aid, interval.has_altimeters) {
            for lane in (0..self.count).filter(|lane| self.diverged[*lane].is_none()) {
                let indicated_m = self.altimeters[lane].sense(height_m, interval.t);
                workspace.heights_m[lane] = indicated_m.unwrap_or(height_m);
                workspace.is_unaided[lane] = indicated_m.is_none();
            }
        }
        set.for_tables().run(Sensing { block: self, interval, workspace });
        set.run(Navigating { block: self, interval, workspace });
        for lane in 0..self.count {
            if self.diverged[lane].is_some() || workspace.is_good[lane] == 0 {
                self.look_closely(lane, interval, workspace);
            }
        }
    }

    /// The interval begins for the failures, if there are any.
    #[inline]
    fn begin_failures(&mut self, interval: &Interval<'_>, workspace: &mut Workspace) {
        let have_failed = [interval.sensors.gyro.has_failed(), interval.sensors.accel.has_failed()];
        let of_triads = self.failures.iter_mut().zip(&mut workspace.failures);
        for ((failures, before), _) in of_triads.zip(have_failed).filter(|(_, has_failed)| *has_failed) {
            for (failure, before) in failures.iter_mut().zip(&mut **before) {
                before.clone_from(failure);
                failure.begin_interval(interval.t);
            }
        }
    }

    /// At the run at `lane`: it is still good, or it goes back and stays there.
    #[cold]
    #[inline(never)]
    fn look_closely(
        &mut self,
        lane: usize,
        interval: &Interval<'_>,
        workspace: &Workspace,
    ) {
        if self.diverged[lane].is_none() {
            let options = interval.options;
            if self.navigator(lane, interval.earth, options).check().is_ok() {
                return;
            }
            self.diverged[lane] = Some(interval.last_good);
            if interval.has_altimeters {
                self.altimeters[lane].undo();
            }
        }
        self.navigators.go_back(lane, &workspace.navigators);
        for (models, before) in self.models.iter_mut().zip(&workspace.models) {
            models.go_back(lane, before);
        }
        self.gyro.go_back(lane, &workspace.gyro);
        self.accel.go_back(lane, &workspace.accel);
        self.measured.iter_mut().zip(&workspace.sums).for_each(|(row, before)| row[lane] = before[lane]);
        self.reports[lane] = workspace.reports[lane];
        let sensors = interval.sensors;
        let have_failed = [sensors.gyro.has_failed(), sensors.accel.has_failed()];
        for (triad, _) in have_failed.iter().enumerate().filter(|(_, has_failed)| **has_failed) {
            self.failures[triad][lane].clone_from(&workspace.failures[triad][lane]);
        }
    }
}

/// The sensors of a block in an interval.
struct Sensing<'a> {
    block: &'a mut Block,
    interval: &'a Interval<'a>,
    workspace: &'a mut Workspace,
}

impl Work for Sensing<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { block, interval, workspace } = self;
        let Block { lanes, gyro, accel, measured: sums, reports, failures, .. } = block;
        let [gyro_failures, accel_failures] = failures;
        let Workspace { measured, saturated: marks, is_unaided, .. } = workspace;
        let &Interval { sensors, shared, dt, count, .. } = interval;
        let (lanes, measured) = (*lanes, &mut measured[..count]);

        *marks = [[0; RUNS]; 2];
        sensors.gyro.sense_block(&shared[0], dt, gyro, gyro_failures, measured, &mut marks[0], lanes);
        sensors.accel.sense_block(&shared[1], dt, accel, accel_failures, measured, &mut marks[1], lanes);
        for (lane, report) in reports.iter_mut().enumerate() {
            let is_silent = |failures: &[FailingTriad]| {
                failures.get(lane).is_some_and(FailingTriad::are_silent)
            };
            *report = Report {
                flags: ImuFlags {
                    gyro_saturated: marks[0][lane] != 0,
                    accel_saturated: marks[1][lane] != 0,
                    gyro_invalid: sensors.gyro.has_failed() && is_silent(gyro_failures),
                    accel_invalid: sensors.accel.has_failed() && is_silent(accel_failures),
                },
                is_unaided: is_unaided[lane],
            };
        }
        for (i, sum) in sums.iter_mut().enumerate() {
            *sum = [0.0; RUNS];
            for rows in measured.iter() {
                for lane in 0..RUNS {
                    sum[lane] += rows[i][lane];
                }
            }
        }
    }
}

/// Its navigators.
struct Navigating<'a> {
    block: &'a mut Block,
    interval: &'a Interval<'a>,
    workspace: &'a mut Workspace,
}

impl Work for Navigating<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { block, interval, workspace } = self;
        let Workspace { measured, scratch, heights_m, is_unaided, is_good, .. } = workspace;
        let &Interval { earth, options, t, count, aid, has_altimeters, .. } = interval;
        let Block { lanes, navigators, models, .. } = block;
        let (lanes, measured) = (*lanes, &measured[..count]);
        let aid = match has_altimeters {
            false => AidOfEach::Same(aid),
            true if is_unaided[..lanes].contains(&true) => {
                AidOfEach::Some { heights_m, is_none: is_unaided }
            }
            true => AidOfEach::Barometer { heights_m },
        };
        let kind = (earth, options.scheme);
        navigators.navigate(kind, options.subsamples, measured, t, lanes, scratch);
        navigators.aid_vertical(kind, &aid, t, lanes, is_good);
        for (models, interval) in models.iter_mut().zip(&interval.model) {
            models.advance(interval, measured, &aid, lanes);
        }
    }
}
