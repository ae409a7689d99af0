//! The barometric altimeter that damps the vertical channel.

use super::altimeter_table::ALTIMETER;
use super::effects::MarkovStep;
use super::failing::FailingOutput;
use super::failure::{Failure, SensorOutput};
use super::kept::Kept;
use super::stream::{Purpose, Source, Stream, StreamKey};
use crate::base::error::Error;
use crate::base::math::exp_m1;
use crate::base::rows::check;
use crate::base::snapshot::{SIGNALS, WALKS, stored};

// The parameters with their checks and numbers, which build.rs writes from the table.
include!(concat!(env!("OUT_DIR"), "/altimeter.rs"));

/// The altimeter.
#[derive(Debug, Clone, PartialEq)]
pub struct Altimeter {
    parameters: AltimeterParameters,
    is_ideal: bool,
    /// Length of the interval for which `markov_step` and `lag_decay` are computed [s]; 0: not computed yet.
    dt: f64,
    markov_step: MarkovStep,
    lag_decay: f64,
    /// Gauss-Markov process of unit variance.
    x: Kept<f64>,
    markov: Kept<Stream>,
    noise: Kept<Stream>,
    heights: Kept<Heights>,
    failing: Kept<FailingOutput>,
}

/// Heights that the altimeter remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Heights {
    /// True height of the last sample [m].
    true_m: f64,
    /// Height behind the lag [m].
    lagged_m: f64,
    /// Last indication since the start or a jump of the truth, if there is one [m].
    indicated_m: Option<f64>,
}

stored!(Heights { true_m: 1e9, lagged_m: 1e9, indicated_m: SIGNALS });

stored!(Altimeter {
    x: WALKS,
    markov,
    noise,
    heights,
    failing,
} rebuilt {
    parameters, is_ideal, dt, markov_step, lag_decay,
} then |altimeter, _| {
    altimeter.failing.check(SensorOutput::Altimeter)?;
    altimeter.decide();
    Ok(())
});

impl Altimeter {
    /// An ideal altimeter at the true height `height_m`, whose random errors draw from the streams of `key`.
    pub fn new(key: StreamKey, height_m: f64) -> Self {
        let mut markov = Stream::new(key, Source::Altimeter, 0, Purpose::GaussMarkov);
        let noise = Stream::new(key, Source::Altimeter, 0, Purpose::SampleNoise);
        let x = markov.normal();
        Self {
            parameters: AltimeterParameters::default(),
            is_ideal: true,
            dt: 0.0,
            markov_step: MarkovStep::NONE,
            lag_decay: 0.0,
            x: Kept::new(x),
            markov: Kept::new(markov),
            noise: Kept::new(noise),
            heights: Kept::new(Heights { true_m: height_m, lagged_m: height_m, indicated_m: None }),
            failing: Kept::new(FailingOutput::new(key, Source::Altimeter, 0)),
        }
    }

    /// Takes validated parameters.
    pub fn set(&mut self, parameters: &AltimeterParameters) {
        self.parameters = *parameters;
        self.dt = 0.0;
        self.decide();
    }

    /// Updates `is_ideal` after a change, so that the intervals need not compute it.
    fn decide(&mut self) {
        let AltimeterParameters { bias_m, markov_sigma_m, noise_m, scale_factor, lag_s, .. } =
            self.parameters;
        self.is_ideal =
            [bias_m, markov_sigma_m, noise_m, scale_factor, lag_s].iter().all(|size| *size == 0.0)
                && !self.has_failed();
    }

    /// Whether the altimeter shows the true height.
    pub fn is_ideal(&self) -> bool {
        self.is_ideal
    }

    #[cold]
    fn set_interval(&mut self, dt: f64) {
        let p = &self.parameters;
        self.dt = dt;
        if p.lag_s > 0.0 {
            self.lag_decay = 1.0 + exp_m1(-dt / p.lag_s);
        }
        if p.markov_sigma_m > 0.0 {
            self.markov_step = MarkovStep::new(dt, p.markov_time_s);
        }
    }

    /// Sets or clears the failure.
    pub fn set_failure(&mut self, failure: Option<Failure>) {
        self.failing.set(failure, self.heights.indicated_m);
        self.decide();
    }

    /// The failure that is set.
    pub fn failure(&self) -> Option<Failure> {
        self.failing.failure()
    }

    /// Whether it has a failure.
    pub fn has_failed(&self) -> bool {
        self.failing.has_failed()
    }

    /// Takes the heights from `other`, which is ideal and has sensed the same true heights.
    pub(crate) fn follow_as(&mut self, other: &Self) {
        self.heights.clone_from(&other.heights);
    }

    /// Follows a jump of the truth to `height_m`: the lag settles there at once, and there is no last indication.
    pub fn reposition(&mut self, height_m: f64) {
        *self.heights = Heights { true_m: height_m, lagged_m: height_m, indicated_m: None };
    }

    /// Follows a jump of the truth by `change_m` up: the lagged height and the last indication keep their differences from the true
    /// height.
    pub fn shift(&mut self, change_m: f64) {
        let Heights { true_m, lagged_m, indicated_m } = &mut *self.heights;
        *true_m += change_m;
        *lagged_m += change_m;
        if let Some(indicated_m) = indicated_m {
            *indicated_m += change_m;
        }
    }

    /// The indicated height [m] at the true height `height_m`, `dt` [s] after the last indication; `None` without a signal.
    /// [`Self::undo`] undoes the indication.
    #[inline]
    pub fn sense(&mut self, height_m: f64, dt: f64) -> Option<f64> {
        self.heights.keep();
        if !self.is_ideal && !cfg!(sins_bare) {
            return self.indicated(height_m, dt);
        }
        let indicated_m = Some(height_m);
        *self.heights = Heights { true_m: height_m, lagged_m: height_m, indicated_m };
        indicated_m
    }

    /// Undoes the last indication.
    pub fn undo(&mut self) {
        self.heights.undo();
        if !self.is_ideal {
            self.x.undo();
            self.markov.undo();
            self.noise.undo();
            self.failing.undo();
        }
    }

    #[inline(never)]
    fn indicated(&mut self, height_m: f64, dt: f64) -> Option<f64> {
        if dt != self.dt {
            self.set_interval(dt);
        }
        self.x.keep();
        self.markov.keep();
        self.noise.keep();
        self.failing.keep();
        let p = &self.parameters;
        // The lag is exact for a height that changes linearly from the last sample to this one.
        let heights = &mut *self.heights;
        if p.lag_s > 0.0 {
            let behind = (height_m - heights.true_m) / dt * p.lag_s;
            heights.lagged_m =
                height_m - behind + (heights.lagged_m - heights.true_m + behind) * self.lag_decay;
        } else {
            heights.lagged_m = height_m;
        }
        heights.true_m = height_m;

        let mut indicated = heights.lagged_m + p.bias_m + p.scale_factor * heights.lagged_m;
        if p.markov_sigma_m > 0.0 {
            self.markov_step.advance(&mut self.x, &mut self.markov);
            indicated += p.markov_sigma_m * *self.x;
        }
        if p.noise_m > 0.0 {
            indicated += p.noise_m * self.noise.normal();
        }
        if self.failing.has_failed() {
            return self.failed(indicated, dt);
        }
        self.heights.indicated_m = Some(indicated);
        self.heights.indicated_m
    }

    /// The indication with the failure, from `indicated_m` [m], over the last `dt` [s]. Spikes and noise are added as their mean
    /// over `dt`.
    #[cold]
    fn failed(&mut self, indicated_m: f64, dt: f64) -> Option<f64> {
        self.failing.begin_interval(dt);
        let with_added = indicated_m + self.failing.added(dt) / dt;
        let shown = (!self.failing.is_silent()).then(|| self.failing.replaced(1.0, with_added));
        self.heights.indicated_m = shown.or(self.heights.indicated_m);
        shown
    }
}
