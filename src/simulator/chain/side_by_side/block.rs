//! Some runs side by side.

use core::ops::Range;

use super::disturbed::Disturbed;
use super::interval::LastGood;
use crate::correction::Compensation;
use crate::earth::Earth;
use crate::error::Error;
use crate::errors::{ErrorModel, ModelBlock};
use crate::mechanization::{Mechanization, NavigatorBlock, VerticalMode};
use crate::memory::room;
use crate::sensors::{Altimeter, FailingTriad, Failure, SensorOutput, StateRows, Triad};
use crate::signal::{Increment, IncrementRows, RUNS, increment_of, put_increment};
use crate::simulator::chain::Chain;
use crate::simulator::{Imperfections, ImuFlags, ImuInterval, Options};

/// What is reported of the last interval of a run, in addition to its signals.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Report {
    pub flags: ImuFlags,
    /// Nothing aided the vertical channel.
    pub is_unaided: bool,
}

/// Compensation of the sensors of a run.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Compensated {
    pub compensation: Option<Compensation>,
    /// Sum of the compensated increments of the last interval, and of the interval before it.
    pub sum: Increment,
    pub sum_before: Increment,
}

/// Up to [`RUNS`] runs. All lanes are computed, so that each loop has the same length. Lanes beyond the last run are copies of it.
#[derive(Debug)]
pub(super) struct Block {
    pub(super) count: usize,
    pub(super) gyro: StateRows,
    pub(super) accel: StateRows,
    /// One element. Navigators and models are on the heap, so that they can be swapped with their copies from before an interval.
    pub(super) navigators: Box<[NavigatorBlock]>,
    /// Error models: no element or one.
    pub(super) models: Box<[ModelBlock]>,
    /// Sum of the measured increments of the last interval.
    pub(super) measured: IncrementRows,
    pub(super) reports: [Report; RUNS],
    pub(super) north_unknown: [bool; RUNS],
    /// Last good solutions of runs that have diverged.
    pub(super) diverged: [Option<LastGood>; RUNS],
    /// Failures of gyros and accelerometers.
    pub(super) failures: [Box<[FailingTriad]>; 2],
    /// Altimeters, if they damp the vertical channel. They are up to date only if they have errors.
    pub(super) altimeters: Box<[Altimeter]>,
    /// Compensation of the sensors of each lane; empty until a run has one.
    pub(super) compensated: Vec<Compensated>,
    /// If gravity is not normal: all sensors of each run, in place of the sensors above.
    pub(super) disturbed: Box<[Disturbed]>,
}

/// Room for the failures of `count` runs.
pub(super) fn failures(
    imperfections: &Imperfections,
    count: usize,
) -> Result<[Box<[FailingTriad]>; 2], Error> {
    let of = |triad: &Triad| {
        let mut failures = room(count)?;
        failures.resize(count, triad.failures().clone());
        Ok(failures.into_boxed_slice())
    };
    Ok([of(&imperfections.gyro)?, of(&imperfections.accel)?])
}

/// Room for the navigators of a block.
pub(super) fn navigators(options: &Options) -> Result<Box<[NavigatorBlock]>, Error> {
    let mut navigators = room(1)?;
    navigators.push(NavigatorBlock::new(options.frame));
    Ok(navigators.into_boxed_slice())
}

/// Room for the error models of a block, if they are on.
pub(super) fn models(options: &Options) -> Result<Box<[ModelBlock]>, Error> {
    let mut models = room(1)?;
    models.extend(options.error_model.then(|| ModelBlock::new(options.frame)));
    Ok(models.into_boxed_slice())
}

impl Block {
    /// Room for `count` runs.
    pub fn new(options: &Options, imperfections: &mut Imperfections, count: usize) -> Result<Self, Error> {
        let mut altimeters = Vec::new();
        if options.vertical == VerticalMode::Damped && !imperfections.gravity.is_on() {
            altimeters = room(count)?;
            altimeters.resize(count, imperfections.altimeter.clone());
        }
        Ok(Self {
            count,
            gyro: imperfections.gyro.rows()?,
            accel: imperfections.accel.rows()?,
            navigators: navigators(options)?,
            models: models(options)?,
            measured: [[0.0; RUNS]; 6],
            reports: [Report::default(); RUNS],
            north_unknown: [false; RUNS],
            diverged: [None; RUNS],
            failures: failures(imperfections, count)?,
            altimeters: altimeters.into_boxed_slice(),
            compensated: Vec::new(),
            disturbed: Disturbed::room(imperfections, count)?,
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
            + size_of_val(&*self.disturbed) / self.count
            + size_of_val(&*self.compensated) / RUNS
            + (size_of_val(&*self.navigators) + size_of_val(&*self.models)) / RUNS
    }

    /// Makes room for compensations.
    pub fn make_room_for_compensations(&mut self) -> Result<(), Error> {
        if self.compensated.is_empty() {
            self.compensated = room(RUNS)?;
            self.compensated.resize(RUNS, Compensated::default());
            for (lane, compensated) in self.compensated.iter_mut().enumerate() {
                compensated.sum = increment_of(&self.measured, lane);
            }
        }
        Ok(())
    }

    /// Compensation of a run.
    pub fn compensation(&self, lane: usize) -> Option<Compensation> {
        self.compensated.get(lane).and_then(|compensated| compensated.compensation)
    }

    /// Sets the compensation of a run. Without room for it there is none.
    pub fn put_compensation(&mut self, lane: usize, compensation: Option<Compensation>) {
        let lanes = self.copies_of(lane);
        for compensated in self.compensated.get_mut(lanes).into_iter().flatten() {
            compensated.compensation = compensation;
        }
    }

    /// Sum of the increments of the last interval on which a run navigated.
    pub fn navigated(&self, lane: usize) -> Increment {
        match self.compensated.get(lane) {
            Some(Compensated { sum, .. }) => *sum,
            None => increment_of(&self.measured, lane),
        }
    }

    /// Copies the sensors of a run into the block.
    pub fn put_imperfections(&mut self, lane: usize, imperfections: &mut Imperfections) {
        for lane in self.copies_of(lane) {
            imperfections.gyro.put_into(&mut self.gyro, lane);
            imperfections.accel.put_into(&mut self.accel, lane);
        }
        self.failures[0][lane].clone_from(imperfections.gyro.failures());
        self.failures[1][lane].clone_from(imperfections.accel.failures());
        if let Some(altimeter) = self.altimeters.get_mut(lane) {
            altimeter.clone_from(&imperfections.altimeter);
        }
        if let Some(disturbed) = self.disturbed.get_mut(lane) {
            disturbed.put(imperfections);
        }
    }

    /// Lets an output of all runs fail. `interval_s` is the length of the last interval of the runs [s], if there was one.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>, interval_s: Option<f64>) {
        for lane in 0..self.count {
            let interval_s = match self.diverged[lane] {
                Some(LastGood { interval_s, .. }) => Some(interval_s).filter(|interval_s| *interval_s > 0.0),
                None => interval_s,
            };
            let sum = increment_of(&self.measured, lane);
            let last = interval_s.map(|t| Increment { angle: sum.angle / t, velocity: sum.velocity / t });
            if let Some(disturbed) = self.disturbed.get_mut(lane) {
                disturbed.set_failure(output, failure, last.as_ref());
                continue;
            }
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

    /// Updates the altimeters of all runs, which were ideal, to the heights of `altimeter`.
    pub fn follow(&mut self, altimeter: &Altimeter) {
        self.altimeters.iter_mut().for_each(|of_run| of_run.follow_as(altimeter));
    }

    /// Copies the sensors of a run into `imperfections`, which have the same parameters and key.
    pub fn take_imperfections(&self, lane: usize, imperfections: &mut Imperfections) {
        if let Some(disturbed) = self.disturbed.get(lane) {
            return disturbed.take(imperfections);
        }
        imperfections.gyro.take_from(&self.gyro, lane);
        imperfections.accel.take_from(&self.accel, lane);
        imperfections.take_failures(&self.failures[0][lane], &self.failures[1][lane]);
        if let Some(altimeter) = self.altimeters.get(lane) {
            imperfections.altimeter.clone_from(altimeter);
        }
    }

    /// Starts a run with the state of `chain`.
    pub fn start(&mut self, lane: usize, height_m: f64, chain: &Chain) {
        if let Some(altimeter) = self.altimeters.get_mut(lane) {
            altimeter.reposition(height_m);
        }
        if let Some(disturbed) = self.disturbed.get_mut(lane) {
            disturbed.reposition(height_m);
        }
        self.put_run(lane, chain);
    }

    /// Time of the last good solution of a run that has diverged [s].
    pub fn diverged_s(&self, lane: usize) -> Option<f64> {
        self.diverged[lane].map(|last_good| last_good.time_s)
    }

    /// Marks all runs as good again, without compensations.
    pub fn revive(&mut self) {
        self.diverged = [None; RUNS];
        self.compensated.clear();
    }

    pub fn navigator(&self, lane: usize, earth: &Earth, options: &Options) -> Mechanization {
        self.navigators[0].get(lane, earth, options.scheme)
    }

    /// Error model of a run, if it is on.
    pub fn error_model(&self, lane: usize, earth: &Earth) -> Option<ErrorModel> {
        self.models.first().map(|models| models.get(lane, earth))
    }

    /// Copies the navigator and the error model of `chain` into a run.
    pub fn put_solution(&mut self, lane: usize, chain: &Chain) {
        for lane in self.copies_of(lane) {
            self.navigators[0].put(lane, &chain.mechanization);
            for (models, model) in self.models.iter_mut().zip(&chain.error_model) {
                models.put(lane, model);
            }
        }
    }

    /// The lanes that hold the run at `lane` or a copy of it.
    fn copies_of(&self, lane: usize) -> Range<usize> {
        if lane + 1 == self.count { lane..RUNS } else { lane..lane + 1 }
    }

    /// Takes in a run that has flown as `chain` so far.
    pub fn put_run(&mut self, lane: usize, chain: &Chain) {
        self.put_solution(lane, chain);
        if let Some(disturbed) = self.disturbed.get_mut(lane) {
            disturbed.put_run(chain);
        }
        self.north_unknown[lane] = chain.north_unknown;
        self.put_compensation(lane, chain.compensation);
        if let Some(ImuInterval { measured, compensated, flags, .. }) = chain.imu() {
            put_increment(&mut self.measured, lane, &measured);
            if let Some(of_run) = self.compensated.get_mut(lane) {
                of_run.sum = compensated;
            }
            let is_unaided = chain.last.vertical_unaided().unwrap_or_default();
            self.reports[lane] = Report { flags, is_unaided };
        }
    }

    /// Marks a run as diverged.
    pub fn put_diverged(&mut self, lane: usize, last_good: LastGood) {
        self.diverged[lane] = Some(last_good);
    }

    pub fn north_unknown(&self, lane: usize) -> bool {
        self.north_unknown[lane]
    }

    /// Sum of the measured increments of the last interval, and the flags of the sensors.
    pub fn measured(&self, lane: usize) -> (Increment, ImuFlags) {
        (increment_of(&self.measured, lane), self.reports[lane].flags)
    }

    /// Whether nothing aided the vertical channel in the last interval.
    pub fn is_unaided(&self, lane: usize) -> bool {
        self.reports[lane].is_unaided
    }

    /// Sensors and gravity of a run, if gravity is not normal.
    pub fn disturbed(&self, lane: usize) -> Option<&Disturbed> {
        self.disturbed.get(lane)
    }
}
