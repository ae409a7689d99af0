//! Some runs side by side.

use core::ops::Range;

use super::disturbed::Disturbed;
use super::shared::LastGood;
use crate::base::error::Error;
use crate::base::memory::{filled, room};
use crate::earth::Earth;
use crate::errors::correction::Compensation;
use crate::errors::{ErrorModel, ModelBatch};
use crate::mechanization::{Mechanization, NavigatorBatch, VerticalMode};
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

/// What an interval changes in each run, and what it reports.
#[derive(Debug)]
pub(super) struct State {
    pub gyro: StateRows,
    pub accel: StateRows,
    /// One element. Navigators and models are on the heap, so that they can be swapped with their copies from before an interval.
    pub navigators: Box<[NavigatorBatch]>,
    /// Error models: no element or one.
    pub models: Box<[ModelBatch]>,
    /// Failures of gyros and accelerometers.
    pub failures: [Box<[FailingTriad]>; 2],
    /// Sum of the measured increments of the last interval.
    pub measured: IncrementRows,
    pub reports: [Report; RUNS],
}

impl State {
    /// Room for `count` runs.
    pub fn new(options: &Options, imperfections: &mut Imperfections, count: usize) -> Result<Self, Error> {
        let failures = |triad: &Triad| filled(count, triad.failures().clone());
        let (mut navigators, mut models) = (room(1)?, room(1)?);
        navigators.push(NavigatorBatch::new(options.frame));
        models.extend(options.error_model.then(|| ModelBatch::new(options.frame)));
        Ok(Self {
            gyro: imperfections.gyro.rows()?,
            accel: imperfections.accel.rows()?,
            navigators: navigators.into_boxed_slice(),
            models: models.into_boxed_slice(),
            failures: [failures(&imperfections.gyro)?, failures(&imperfections.accel)?],
            measured: [[0.0; RUNS]; 6],
            reports: [Report::default(); RUNS],
        })
    }

    /// Sets the navigator, the error model and the reports of the run at `lane` back to `before`.
    pub fn go_back(&mut self, lane: usize, before: &Self) {
        for (navigators, before) in self.navigators.iter_mut().zip(&before.navigators) {
            navigators.go_back(lane, before);
        }
        for (models, before) in self.models.iter_mut().zip(&before.models) {
            models.go_back(lane, before);
        }
        self.measured.iter_mut().zip(&before.measured).for_each(|(row, before)| row[lane] = before[lane]);
        self.reports[lane] = before.reports[lane];
    }

    /// Sets the sensors of the run at `lane` back to `before`. Only the triads of `have_failed` have failures that changed.
    pub fn sensors_go_back(&mut self, lane: usize, before: &Self, have_failed: [bool; 2]) {
        self.gyro.go_back(lane, &before.gyro);
        self.accel.go_back(lane, &before.accel);
        for triad in [0, 1].into_iter().filter(|&triad| have_failed[triad]) {
            self.failures[triad][lane].clone_from(&before.failures[triad][lane]);
        }
    }
}

/// Up to [`RUNS`] runs. All lanes are computed, so that each loop has the same length. Lanes beyond the last run are copies of it.
#[derive(Debug)]
pub(super) struct Batch {
    pub count: usize,
    pub state: State,
    pub north_unknown: [bool; RUNS],
    /// Last good solutions of runs that have diverged.
    pub diverged: [Option<LastGood>; RUNS],
    /// Altimeters, if they damp the vertical channel. They are up to date only if they have errors.
    pub altimeters: Box<[Altimeter]>,
    /// Compensation of the sensors of each lane; empty until a run has one.
    pub compensated: Vec<Compensated>,
    /// If gravity is not normal: all sensors of each run, in place of the sensors above.
    pub disturbed: Box<[Disturbed]>,
}

impl Batch {
    /// Room for `count` runs.
    pub fn new(options: &Options, imperfections: &mut Imperfections, count: usize) -> Result<Self, Error> {
        let has_altimeters = options.vertical == VerticalMode::Damped && !imperfections.gravity.is_on();
        Ok(Self {
            count,
            state: State::new(options, imperfections, count)?,
            north_unknown: [false; RUNS],
            diverged: [None; RUNS],
            altimeters: filled(if has_altimeters { count } else { 0 }, imperfections.altimeter.clone())?,
            compensated: Vec::new(),
            disturbed: Disturbed::room(imperfections, count)?,
        })
    }

    /// Memory of a run [bytes].
    pub fn bytes_of_run(&self) -> usize {
        let State { gyro, accel, navigators, models, .. } = &self.state;
        size_of::<Self>() / RUNS
            + gyro.bytes_of_run()
            + accel.bytes_of_run()
            + size_of_val(&*self.altimeters) / self.count
            + 2 * size_of::<FailingTriad>()
            + size_of_val(&*self.disturbed) / self.count
            + size_of_val(&*self.compensated) / RUNS
            + (size_of_val(&**navigators) + size_of_val(&**models)) / RUNS
    }

    /// Makes room for compensations.
    pub fn make_room_for_compensations(&mut self) -> Result<(), Error> {
        if self.compensated.is_empty() {
            self.compensated = filled(RUNS, Compensated::default())?.into_vec();
            for (lane, compensated) in self.compensated.iter_mut().enumerate() {
                compensated.sum = increment_of(&self.state.measured, lane);
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
            None => increment_of(&self.state.measured, lane),
        }
    }

    /// Copies the sensors of a run into the batch.
    pub fn put_imperfections(&mut self, lane: usize, imperfections: &mut Imperfections) {
        for lane in self.copies_of(lane) {
            imperfections.gyro.put_into(&mut self.state.gyro, lane);
            imperfections.accel.put_into(&mut self.state.accel, lane);
        }
        self.state.failures[0][lane].clone_from(imperfections.gyro.failures());
        self.state.failures[1][lane].clone_from(imperfections.accel.failures());
        if let Some(altimeter) = self.altimeters.get_mut(lane) {
            altimeter.clone_from(&imperfections.altimeter);
        }
        if let Some(disturbed) = self.disturbed.get_mut(lane) {
            disturbed.imperfections.copy_from(imperfections);
        }
    }

    /// Lets an output of all runs fail. `interval_s` is the length of the last interval of the runs [s], if there was one.
    pub fn set_failure(&mut self, output: SensorOutput, failure: Option<Failure>, interval_s: Option<f64>) {
        for lane in 0..self.count {
            let interval_s = match self.diverged[lane] {
                Some(LastGood { interval_s, .. }) => Some(interval_s).filter(|interval_s| *interval_s > 0.0),
                None => interval_s,
            };
            let sum = increment_of(&self.state.measured, lane);
            let last = interval_s.map(|t| Increment { angle: sum.angle / t, velocity: sum.velocity / t });
            if let Some(disturbed) = self.disturbed.get_mut(lane) {
                disturbed.imperfections.set_failure(output, failure, last.as_ref());
                continue;
            }
            let last = last.and_then(|mean| output.of(&mean));
            match output {
                SensorOutput::Gyro(axis) => self.state.failures[0][lane].set(axis, failure, last),
                SensorOutput::Accelerometer(axis) => self.state.failures[1][lane].set(axis, failure, last),
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
            return imperfections.copy_from(&disturbed.imperfections);
        }
        let State { gyro, accel, failures, .. } = &self.state;
        imperfections.gyro.take_from(gyro, lane);
        imperfections.accel.take_from(accel, lane);
        imperfections.take_failures(&failures[0][lane], &failures[1][lane]);
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
            disturbed.imperfections.reposition(height_m);
        }
        self.put_run(lane, chain);
    }

    /// Marks all runs as good again, without compensations.
    pub fn revive(&mut self) {
        self.diverged = [None; RUNS];
        self.compensated.clear();
    }

    pub fn navigator(&self, lane: usize, earth: &Earth, options: &Options) -> Mechanization {
        self.state.navigators[0].get(lane, earth, options.scheme)
    }

    /// Error model of a run, if it is on.
    pub fn error_model(&self, lane: usize, earth: &Earth) -> Option<ErrorModel> {
        self.state.models.first().map(|models| models.get(lane, earth))
    }

    /// Copies the navigator and the error model of `chain` into a run.
    pub fn put_solution(&mut self, lane: usize, chain: &Chain) {
        for lane in self.copies_of(lane) {
            self.state.navigators[0].put(lane, &chain.mechanization);
            for (models, model) in self.state.models.iter_mut().zip(&chain.error_model) {
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
            put_increment(&mut self.state.measured, lane, &measured);
            if let Some(of_run) = self.compensated.get_mut(lane) {
                of_run.sum = compensated;
            }
            let is_unaided = chain.last.vertical_unaided().unwrap_or_default();
            self.state.reports[lane] = Report { flags, is_unaided };
        }
    }
}
