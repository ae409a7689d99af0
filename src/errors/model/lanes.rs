//! Error models of many runs side by side. What depends only on the truth is computed once per interval, the rest in loops over the
//! runs, as for the [navigators](crate::mechanization).

use nalgebra::{Matrix3, Vector3};

use super::earth_fixed::{Coefficients, EarthFixedForm};
use super::geographic::GeographicForm;
use super::sensor_errors::ErrorSums;
use super::{ErrorModel, Form, SensorErrors, is_within};
use crate::earth::Earth;
use crate::mechanization::{AidOfEach, Frame, VerticalCorrection, VerticalRows};
use crate::signal::mounting::Block;
use crate::signal::{
    Increment, IncrementRows, IntervalMotion, MotionNode, RUNS, Row, TurnToEarth, increment_of, put_vectors,
    vectors_of,
};
use crate::truth::TruthPoint;

/// Models of one frame that advance over the same intervals.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(crate) struct ModelBatch {
    frame: Frame,
    /// Errors of attitude, velocity and position, in the terms of the form.
    state: [Row; 9],
    vertical: VerticalRows,
}

/// Interval that ends at `next`, with the quantities that are the same for the models of all runs.
#[derive(Debug)]
pub(crate) struct ModelInterval<'a> {
    earth: &'a Earth,
    motion: &'a IntervalMotion<'a>,
    next: &'a TruthPoint,
    /// Error-free increments.
    ideal: &'a [Increment],
    /// Truth at the start, in the middle and at the end, and the gradient of gravity in the middle [1/s²].
    nodes: [MotionNode; 3],
    gradient: Matrix3<f64>,
    turn: TurnToEarth,
}

impl<'a> ModelInterval<'a> {
    pub fn new(
        earth: &'a Earth,
        motion: &'a IntervalMotion<'a>,
        next: &'a TruthPoint,
        ideal: &'a [Increment],
    ) -> Self {
        let nodes = motion.nodes();
        let gradient = Coefficients::new(earth, motion.interval_s, &nodes).gradient;
        Self { earth, motion, next, ideal, nodes, gradient, turn: motion.turn_to_earth() }
    }
}

impl ModelInterval<'_> {
    /// The sensor errors of the run at `lane`.
    pub fn errors(&self, measured: &[IncrementRows], lane: usize) -> SensorErrors {
        let pairs = self.ideal.iter().zip(measured);
        let errors = pairs.map(|(ideal, measured)| increment_of(measured, lane).minus(ideal));
        SensorErrors::of_increments(errors, self.motion.interval_s)
    }
}

impl ModelBatch {
    /// A batch of models that are not set yet.
    pub fn new(frame: Frame) -> Self {
        Self { frame, state: [[0.0; RUNS]; 9], vertical: VerticalRows::new() }
    }

    /// Sets the model at `lane` to `model`.
    pub fn put(&mut self, lane: usize, model: &ErrorModel) {
        let mut model = *model;
        self.put_state(lane, model.state());
        self.vertical.put(lane, &model.vertical);
    }

    /// The model at `lane`.
    pub fn get(&self, lane: usize, earth: &Earth) -> ErrorModel {
        let [phi, dv, dr] = self.state(lane);
        let form = match self.frame {
            Frame::EarthFixed => Form::EarthFixed(EarthFixedForm { psi: phi, dv, dr }),
            Frame::Geographic => Form::Geographic(GeographicForm { phi, dv, d_place: dr }),
        };
        ErrorModel { earth: *earth, form, vertical: self.vertical.get(lane) }
    }

    /// Sets the model at `lane` back to its state in `before`.
    pub fn go_back(&mut self, lane: usize, before: &Self) {
        self.state.iter_mut().zip(&before.state).for_each(|(row, before)| row[lane] = before[lane]);
        self.vertical.go_back(lane, &before.vertical);
    }

    #[inline(always)]
    fn state(&self, lane: usize) -> [Vector3<f64>; 3] {
        vectors_of(&self.state, lane)
    }

    #[inline(always)]
    fn put_state(&mut self, lane: usize, state: [&mut Vector3<f64>; 3]) {
        put_vectors(&mut self.state, lane, state.map(|vector| &*vector));
    }

    #[inline(always)]
    fn form(&self, lane: usize) -> EarthFixedForm {
        let [psi, dv, dr] = self.state(lane);
        EarthFixedForm { psi, dv, dr }
    }

    /// Overwrites this batch with the models `before`, advanced over an interval with these increments as by
    /// [`ErrorModel::advance`].
    #[inline(always)]
    pub fn advance(
        &mut self,
        before: &Self,
        interval: &ModelInterval<'_>,
        measured: &[IncrementRows],
        aid: &AidOfEach<'_>,
    ) {
        if self.frame == Frame::Geographic {
            return self
                .advance_one_by_one(before, interval, aid, |lane| (interval.errors(measured, lane), None));
        }
        // By value: otherwise the compiler cannot assume that the rows do not overlap it.
        let &ModelInterval { earth, motion, ideal, nodes, gradient, turn, .. } = interval;
        let coefficients =
            Coefficients { t: motion.interval_s, w: earth.rate_rad_s, gradient, nodes: &nodes };
        let mut sums = SumRows([[0.0; RUNS]; 12]);
        let part = 1.0 / ideal.len() as f64;
        for (i, (ideal, measured)) in ideal.iter().zip(measured).enumerate() {
            let (ideal, from_middle) = (*ideal, ErrorSums::from_middle(i, part));
            for lane in 0..RUNS {
                let mut of_run = sums.at(lane);
                of_run.add(&increment_of(measured, lane).minus(&ideal), from_middle);
                sums.put(lane, &of_run);
            }
        }
        let t = motion.interval_s;
        for lane in 0..RUNS {
            let mut form = before.form(lane);
            form.advance_by(&coefficients, &turn.of(&sums.at(lane).errors(t).nodes()));
            self.put_state(lane, form.state());
        }
        self.vertical.clone_from(&before.vertical);
        self.correct_vertical(interval, aid);
        let mut beyond = 0;
        for lane in 0..RUNS {
            beyond |= u64::from(!is_within(&self.form(lane).dr));
        }
        if beyond != 0 {
            self.each(interval.earth, |_, model| model.keep_within());
        }
    }

    /// Overwrites this batch with the models `before`, advanced one by one with the sensor errors and the mounting of each run.
    #[cold]
    #[inline(never)]
    pub fn advance_one_by_one(
        &mut self,
        before: &Self,
        interval: &ModelInterval<'_>,
        aid: &AidOfEach<'_>,
        of_run: impl Fn(usize) -> (SensorErrors, Option<Block>),
    ) {
        let &ModelInterval { earth, motion, next, .. } = interval;
        self.clone_from(before);
        self.each(earth, |lane, model| {
            let (errors, block) = of_run(lane);
            model.advance(motion, next, &errors, &aid.at(lane), block.as_ref());
        });
    }

    fn each(&mut self, earth: &Earth, mut act: impl FnMut(usize, &mut ErrorModel)) {
        for lane in 0..RUNS {
            let mut model = self.get(lane, earth);
            act(lane, &mut model);
            self.put(lane, &model);
        }
    }

    #[inline(always)]
    fn correct_vertical(&mut self, interval: &ModelInterval<'_>, aid: &AidOfEach<'_>) {
        let &ModelInterval { earth, next, motion, .. } = interval;
        // By value: otherwise the compiler cannot assume that the rows do not overlap it.
        let (truth, t) = (*next, motion.interval_s);
        match *aid {
            _ if !self.vertical.are_alike() => self.correct_one_by_one(interval, aid),
            AidOfEach::Some { .. } => self.correct_one_by_one(interval, aid),
            AidOfEach::None => self.vertical.skip(),
            AidOfEach::Truth { .. } => {
                self.shift_vertical(earth, &truth, |_, _, form| {
                    let velocity_up = form.velocity_up_error(earth, &truth);
                    VerticalCorrection::to_truth(-form.height_error(&truth), -velocity_up, t)
                });
            }
            AidOfEach::Barometer { heights_m } => {
                let beginning = self.vertical.begin(t);
                let true_height_m = truth.height_m();
                self.shift_vertical(earth, &truth, |vertical, lane, form| {
                    let altimeter_error = heights_m[lane] - true_height_m;
                    vertical.answer(lane, form.height_error(&truth) - altimeter_error, &beginning)
                });
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn correct_one_by_one(&mut self, interval: &ModelInterval<'_>, aid: &AidOfEach<'_>) {
        let &ModelInterval { earth, next, motion, .. } = interval;
        self.each(earth, |lane, model| {
            model.correct_vertical(motion.interval_s, next, &aid.at(lane), None);
        });
    }

    #[inline(always)]
    fn shift_vertical(
        &mut self,
        earth: &Earth,
        truth: &TruthPoint,
        correct: impl Fn(&mut VerticalRows, usize, &EarthFixedForm) -> VerticalCorrection,
    ) {
        for lane in 0..RUNS {
            let mut form = self.form(lane);
            let correction = correct(&mut self.vertical, lane, &form);
            form.shift_vertical(earth, truth, &correction);
            self.put_state(lane, form.state());
        }
    }
}

/// [`ErrorSums`] of many runs.
struct SumRows([Row; 12]);

impl SumRows {
    #[inline(always)]
    fn at(&self, lane: usize) -> ErrorSums {
        let [angle, velocity, angle_moment, velocity_moment] = vectors_of(&self.0, lane);
        let moment = Increment { angle: angle_moment, velocity: velocity_moment };
        ErrorSums { sum: Increment { angle, velocity }, moment }
    }

    #[inline(always)]
    fn put(&mut self, lane: usize, sums: &ErrorSums) {
        let ErrorSums { sum, moment } = sums;
        put_vectors(&mut self.0, lane, [&sum.angle, &sum.velocity, &moment.angle, &moment.velocity]);
    }
}
