//! Runs in gravity that is not normal. Each run flies through different gravity, so that no two runs have the same sensor inputs.

use nalgebra::Vector3;

use super::shared::Shared;
use crate::base::error::Error;
use crate::base::memory::{filled, room};
use crate::errors::SensorErrors;
use crate::errors::correction::Compensation;
use crate::mechanization::VerticalAid;
use crate::signal::{Increment, MAX_INCREMENTS, RUNS};
use crate::simulator::chain::Chain;
use crate::simulator::disturbance::Disturbance;
use crate::simulator::imperfections::IntervalConditions;
use crate::simulator::imu::LastInterval;
use crate::simulator::{Imperfections, ImuFlags};

/// A run's sensors and its gravity.
#[derive(Debug, Clone)]
pub(super) struct Disturbed {
    pub imperfections: Imperfections,
    flown: Flown,
    before: Flown,
}

#[derive(Debug, Clone, Copy)]
struct Flown {
    disturbance: Disturbance,
    /// Error-free velocity increment over the last interval [m/s].
    velocity: Vector3<f64>,
}

impl Flown {
    const NONE: Self = Self {
        disturbance: Disturbance::new(Vector3::new(0.0, 0.0, 0.0)),
        velocity: Vector3::new(0.0, 0.0, 0.0),
    };
}

/// Memory that a step needs in addition to the runs.
#[derive(Debug)]
pub(super) struct DisturbedWorkspace {
    pub ideal: Box<[Increment]>,
    pub measured: Box<[Increment]>,
    /// Sensor errors of each run of a batch, including the gravity that an INS takes for a sensor error.
    pub errors: [SensorErrors; RUNS],
}

impl DisturbedWorkspace {
    pub fn new(imperfections: &Imperfections) -> Result<Self, Error> {
        let count = if imperfections.gravity.is_on() { MAX_INCREMENTS } else { 0 };
        let increments = || filled(count, Increment::ZERO);
        Ok(Self { ideal: increments()?, measured: increments()?, errors: [SensorErrors::NONE; RUNS] })
    }
}

impl Disturbed {
    /// Room for `count` runs, if gravity is not normal.
    pub fn room(imperfections: &Imperfections, count: usize) -> Result<Box<[Self]>, Error> {
        let count = if imperfections.gravity.is_on() { count } else { 0 };
        let mut memory = room(count)?;
        for _ in 0..count {
            memory.push(Self::of(imperfections));
        }
        Ok(memory.into_boxed_slice())
    }

    /// Not inlined, to save stack.
    #[inline(never)]
    fn of(imperfections: &Imperfections) -> Self {
        Self { imperfections: imperfections.clone(), flown: Flown::NONE, before: Flown::NONE }
    }

    /// The run has flown as `chain` so far.
    pub fn put_run(&mut self, chain: &Chain) {
        if let Some(disturbance) = chain.disturbance {
            let velocity = chain.imu().map(|imu| imu.ideal.velocity).unwrap_or_default();
            self.flown = Flown { disturbance, velocity };
        }
    }

    /// Copies the run's gravity and error-free velocity into `chain`.
    pub fn give(&self, chain: &mut Chain) {
        chain.disturbance = Some(self.flown.disturbance);
        if let LastInterval::Summed { imu, .. } = &mut chain.last {
            imu.ideal.velocity = self.flown.velocity;
        }
    }

    /// Flies an interval. Returns the sum of the measured increments, the increments after the compensation, the flags and the
    /// indicated height, if there is one [m].
    pub fn sense<'a>(
        &mut self,
        shared: &Shared<'_>,
        workspace: &'a mut DisturbedWorkspace,
        lane: usize,
        compensation: Option<&Compensation>,
    ) -> (Increment, &'a [Increment], ImuFlags, Option<f64>) {
        let &Shared { earth, recent, motion, mounting, t, dt, aid, .. } = shared;
        let Self { imperfections, flown, before } = self;
        *before = *flown;
        let DisturbedWorkspace { ideal, measured, errors } = workspace;
        let count = shared.ideal.len();
        let (ideal, measured) = (&mut ideal[..count], &mut measured[..count]);
        ideal.copy_from_slice(shared.ideal);
        flown.disturbance.fly(earth, recent, motion, mounting, &mut imperfections.gravity, ideal);
        flown.velocity = Increment::sum(ideal).velocity;
        let flags = if imperfections.triads_are_ideal() {
            measured.copy_from_slice(ideal);
            ImuFlags::default()
        } else {
            imperfections.begin_interval(t, || IntervalConditions::of(recent, motion, mounting));
            imperfections.sense(ideal, dt, measured)
        };
        let sum = match compensation {
            Some(compensation) => compensation.apply(measured, dt),
            None => Increment::sum(measured),
        };
        errors[lane] = SensorErrors::between(ideal, measured, t).plus(flown.disturbance.apparent_errors());
        let indicated_m = match aid {
            VerticalAid::Barometer { height_m } => imperfections.altimeter.sense(height_m, t),
            _ => None,
        };
        (sum, measured, flags, indicated_m)
    }

    /// Undoes the interval.
    pub fn undo(&mut self, shared: &Shared<'_>) {
        Chain::undo_imperfections(shared.options, true, &mut self.imperfections);
        self.flown = self.before;
    }
}
