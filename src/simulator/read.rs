//! What is read of a simulator: the truth, the navigation, its signals and errors.

use super::chain::Chain;
use super::{ClosureFigures, ErrorSource, ImuInterval, Mode, Moment, Simulator, Solution, TrimFigures};
use crate::covariance::NavigationCovariance;
use crate::error::Error;
use crate::errors::{AccuracyFigures, NavigationErrors};
use crate::signal::Increment;
use crate::truth::{TruthPoint, TruthSummary};

/// Views that a read looks at.
#[derive(Clone, Copy)]
pub(crate) struct Looked {
    pub truth: bool,
    pub navigation: bool,
}

impl Simulator {
    /// The truth; `None` before the first sample.
    pub fn truth(&self) -> Result<Option<Solution>, Error> {
        self.refuse_while_navigating()?;
        Ok(match (&self.mode, self.intake.current(), self.intake.front()) {
            (Mode::Flying(chain), Some(point), _) => Some(Moment { chain, point }.truth()),
            (_, _, Some(first)) => Some(Solution::of_truth(&self.options, &self.earth, first)),
            _ => None,
        })
    }

    /// Figures of the true motion since the start or the last reset, repositions and jumps between; `None` before the first
    /// interval.
    pub fn truth_summary(&self) -> Result<Option<TruthSummary>, Error> {
        self.refuse_while_navigating()?;
        let summary = match &self.mode {
            Mode::Flying(chain) => &chain.summary,
            _ => &self.summary,
        };
        match summary {
            None => Err(Error::bad_state("the summary of the truth is off: set options.truth_summary")),
            Some(summary) => Ok((summary.intervals > 0).then_some(*summary)),
        }
    }

    /// The navigated solution; `None` before the first sample.
    pub fn navigation(&self) -> Result<Option<Solution>, Error> {
        match self.navigated_alone() {
            None => self.see(|moment| moment.navigation()),
            alone => Ok(alone),
        }
    }

    /// The solution where there is no truth.
    #[inline]
    pub(crate) fn navigated_alone(&self) -> Option<Solution> {
        match &self.mode {
            Mode::Navigating(navigator) => Some(navigator.solution()),
            _ => None,
        }
    }

    /// Ideal and measured signals of the last interval; `None` before the first.
    pub fn imu(&self) -> Option<ImuInterval> {
        match &self.mode {
            Mode::Waiting => None,
            Mode::Flying(chain) => chain.imu(),
            Mode::Navigating(navigator) => navigator.imu(),
        }
    }

    /// The ideal sub-increments of the last interval; empty before the first and while navigating on increments.
    pub fn ideal_increments(&self) -> &[Increment] {
        match &self.mode {
            Mode::Flying(chain) => chain.ideal_increments(),
            _ => &[],
        }
    }

    /// Time [s] and errors of the navigated solution; `None` before the first sample.
    pub fn errors(&self, source: ErrorSource) -> Result<Option<(f64, NavigationErrors)>, Error> {
        Ok(self.errors_and_pole(source)?.map(|(time_s, errors, _)| (time_s, errors)))
    }

    /// Time [s] and errors, and whether the truth is near a pole.
    pub(crate) fn errors_and_pole(
        &self,
        source: ErrorSource,
    ) -> Result<Option<(f64, NavigationErrors, bool)>, Error> {
        self.refuse_without(source)?;
        Ok(self.see(|moment| moment.errors_and_pole(source))?.flatten())
    }

    /// Checks that there are errors of `source`.
    pub(crate) fn refuse_without(&self, source: ErrorSource) -> Result<(), Error> {
        self.refuse_while_navigating()?;
        self.options.check_source(source)
    }

    /// What `view` makes of this moment; `None` before the first sample.
    #[inline(always)]
    pub(crate) fn see<T>(&self, view: impl FnOnce(Moment<'_>) -> T) -> Result<Option<T>, Error> {
        self.refuse_while_navigating()?;
        self.read(|chain, point| view(Moment { chain, point }))
    }

    /// As [`Self::see`]; the views that `view` looks at are made where they are kept.
    #[inline(always)]
    pub(crate) fn make_and_see<T>(
        &mut self,
        Looked { truth, navigation }: Looked,
        view: impl FnOnce(Moment<'_>) -> T,
    ) -> Result<Option<T>, Error> {
        self.refuse_while_navigating()?;
        let (Mode::Flying(chain), Some(point)) = (&mut self.mode, self.intake.current()) else {
            return self.read(|chain, point| view(Moment { chain, point }));
        };
        if truth && chain.views.truth.get().is_none() {
            chain.make_true_view(point);
        }
        if navigation && chain.views.navigation.get().is_none() {
            chain.make_navigated_view();
        }
        Ok(Some(view(Moment { chain, point })))
    }

    /// Time [s], covariance of the navigation errors and whether the truth is near a pole; `None` before the first sample. It
    /// changes nothing but scratch.
    pub fn covariance(&mut self) -> Result<Option<(f64, NavigationCovariance, bool)>, Error> {
        self.refuse_while_navigating()?;
        if !self.options.covariance {
            return Err(Error::bad_state(
                "the covariance is off, as it is by default: create the simulator with options.covariance",
            ));
        }
        match (&mut self.mode, self.intake.current(), self.intake.front()) {
            (Mode::Flying(chain), Some(current), _) => Ok(chain.covariance(current, &self.imperfections)),
            (_, _, Some(_)) => self.covariance_at_start(),
            _ => Ok(None),
        }
    }

    #[cold]
    #[inline(never)]
    fn covariance_at_start(&mut self) -> Result<Option<(f64, NavigationCovariance, bool)>, Error> {
        let mut chain = self.chain_from_first_sample()?;
        let Some(first) = self.intake.front() else { return Ok(None) };
        chain.begin_covariance(core::mem::take(&mut self.covariance), first, &self.imperfections);
        let covariance = chain.covariance(first, &self.imperfections);
        self.covariance = chain.covariance;
        Ok(covariance)
    }

    /// Accuracy and closure so far; `None` before the first sample.
    pub fn accuracy(&self) -> Result<Option<(f64, AccuracyFigures, ClosureFigures)>, Error> {
        self.refuse_while_navigating()?;
        self.read(|chain, truth| (truth.time_s, chain.accuracy(truth), chain.closure(truth)))
    }

    /// The trim of the closed loop so far, 0 without one; `None` before the first sample.
    pub fn trim(&self) -> Result<Option<TrimFigures>, Error> {
        self.refuse_while_navigating()?;
        self.read(|chain, _| chain.trim())
    }

    /// Reads the chain as it is, or as it will start from the first sample that waits, with the truth of that moment.
    #[inline(always)]
    fn read<T>(&self, view: impl FnOnce(&Chain, &TruthPoint) -> T) -> Result<Option<T>, Error> {
        match (&self.mode, self.intake.current(), self.intake.front()) {
            (Mode::Flying(chain), Some(current), _) => Ok(Some(view(chain, current))),
            (_, _, Some(first)) => self.read_start(view, first).map(Some),
            _ => Ok(None),
        }
    }

    /// Not inlined: no other read needs the stack of a chain. By reference: `?` would take it out of its `Result`, a copy.
    #[cold]
    #[inline(never)]
    fn read_start<T>(
        &self,
        view: impl FnOnce(&Chain, &TruthPoint) -> T,
        first: &TruthPoint,
    ) -> Result<T, Error> {
        match &self.chain_from_first_sample() {
            Ok(chain) => Ok(view(chain, first)),
            Err(error) => Err(*error),
        }
    }
}
