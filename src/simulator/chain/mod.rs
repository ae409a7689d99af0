//! Truth → signal generator → sensors → mechanization → errors, for the samples of a flight.

mod correct;
mod covariance;
mod extended;
mod fly;
mod moved;
pub(super) mod side_by_side;
mod snapshot;
mod view;

use core::ops::Range;

use super::closed_loop::{ClosedLoop, TrimFigures};
use super::closure::{Closure, ClosureFigures};
use super::disturbance::Disturbance;
use super::imu::LastInterval;
use super::signals::Signals;
use super::start::{Start, block_at_start, with_errors};
use super::{Imperfections, ImuInterval, Options};
use crate::base::error::Error;
use crate::earth::Earth;
use crate::earth::state::{EarthFixedState, StateErrors};
use crate::errors::correction::Compensation;
use crate::errors::covariance::Propagation;
use crate::errors::{Accuracy, AccuracyFigures, ErrorModel};
use crate::mechanization::Mechanization;
use crate::signal::mounting::Block;
use crate::signal::{Increment, SignalGenerator};
use crate::truth::{Recent, TruthPoint, TruthSummary};
use view::Views;

/// The chain in flight.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    pub(super) options: Options,
    pub(super) earth: Earth,
    generator: SignalGenerator,
    /// The increments of the last interval are at the places `parts`. A chain that is only read has no increments.
    pub signals: Signals,
    parts: Range<usize>,
    pub(super) last: LastInterval,
    /// The alignment at the start could not find north, and no unit has found it since.
    pub(super) north_unknown: bool,
    /// The sensor block, if it is not at the reference point.
    pub(super) block: Option<Block>,
    /// True less normal gravity, if they differ.
    disturbance: Option<Disturbance>,
    /// Covariance of the errors along the truth: no element or one.
    pub covariance: Box<[Propagation]>,
    /// Summary of the truth, if it is wanted.
    pub summary: Option<TruthSummary>,
    /// Whether there is no block, no disturbance, no closed loop and no summary. The ideal signals are then the
    /// generator's.
    is_plain: bool,
    pub(super) mechanization: Mechanization,
    pub(super) error_model: Option<ErrorModel>,
    /// Compensation of the sensors, if there is one.
    pub(super) compensation: Option<Compensation>,
    /// Whether there is a covariance, and the host has corrected the solution.
    pub(super) is_corrected: bool,
    accuracy: Accuracy,
    intervals: u64,
    pub(super) closure: Closure,
    closed_loop: Option<ClosedLoop>,
    pub(super) views: Views,
}

/// Parts of a chain for a mounting and for gravity beyond the normal field, and the true state of the sensors.
struct Extension {
    block: Option<Block>,
    disturbance: Option<Disturbance>,
    sensors_state: EarthFixedState,
}

impl Chain {
    /// The INS set up at the truth `first` with its initial errors; `interval` is the first interval, if its end is
    /// known. An alignment that takes time moves the processes of the sensors on.
    pub fn start(
        options: &Options,
        earth: Earth,
        first: &TruthPoint,
        interval: Option<&Recent<'_>>,
        imperfections: &mut Imperfections,
    ) -> Result<Self, Error> {
        let block = imperfections
            .mounting()
            .map(|mounting| block_at_start(mounting, options, &earth, first, interval));
        let (sensors_state, truth) = match &block {
            Some(block) => {
                let state = block.state(first);
                (state, state.navigation(&earth, options.axes))
            }
            None => (first.state, first.navigation(&earth, options.axes)),
        };
        let disturbance =
            imperfections.gravity.is_on().then(|| Disturbance::new(imperfections.gravity.at(&earth, first)));
        let at = (first, &sensors_state);
        let disturbance_e = disturbance.as_ref().map(Disturbance::at_last_e);
        let start = Start::new(options, &earth, at, &truth, disturbance_e, imperfections)?;
        let state = with_errors(&earth, options, &truth, &start.errors).earth_fixed(&earth);
        let mechanization = Mechanization::new(earth, options.frame, options.scheme, &state);
        let extension = Extension { block, disturbance, sensors_state };
        let with_shadow = start.errors != StateErrors::NONE;
        let chain = Self::new(options, earth, first, &start, mechanization, with_shadow, extension);
        chain.check()?;
        Ok(chain)
    }

    /// A chain at the truth `first` whose navigator is `mechanization`. `start` has its initial errors.
    fn new(
        options: &Options,
        earth: Earth,
        first: &TruthPoint,
        start: &Start,
        mechanization: Mechanization,
        with_shadow: bool,
        Extension { block, disturbance, sensors_state }: Extension,
    ) -> Self {
        let closed_loop = options.closed_loop_time_s.map(|time_constant_s| {
            // To the bit the start of a navigator without errors: runs of an ensemble with errors and without share the trim.
            let at_truth = || {
                let truth = match &block {
                    Some(_) => sensors_state.navigation(&earth, options.axes),
                    None => first.navigation(&earth, options.axes),
                };
                let state = with_errors(&earth, options, &truth, &StateErrors::NONE).earth_fixed(&earth);
                Mechanization::new(earth, options.frame, options.scheme, &state)
            };
            ClosedLoop::new(time_constant_s, first.time_s, with_shadow.then(at_truth))
        });
        let error_model = options.error_model.then(|| {
            ErrorModel::new(earth, options.frame, &first.vertical(), &sensors_state.v_e, &start.errors)
        });
        Self {
            options: *options,
            earth,
            generator: SignalGenerator::new(earth.rate_rad_s),
            signals: Signals::default(),
            parts: 0..0,
            covariance: Box::default(),
            summary: None,
            last: LastInterval::None,
            north_unknown: start.north_unknown,
            is_plain: block.is_none() && disturbance.is_none() && closed_loop.is_none(),
            block,
            disturbance,
            mechanization,
            error_model,
            compensation: None,
            is_corrected: false,
            accuracy: Accuracy::new(first.time_s),
            intervals: 0,
            closure: Closure::new(),
            closed_loop,
            views: Views::default(),
        }
    }

    /// Takes over the summary to which each interval is added.
    pub fn set_summary(&mut self, summary: Option<TruthSummary>) {
        self.summary = summary;
        self.is_plain &= summary.is_none();
    }

    pub fn intervals(&self) -> u64 {
        self.intervals
    }

    pub fn ideal_increments(&self) -> &[Increment] {
        match self.last {
            LastInterval::InParts { .. } => &self.signals.ideal[self.parts.clone()],
            LastInterval::None | LastInterval::Summed { .. } => &[],
        }
    }

    pub fn imu(&self) -> Option<ImuInterval> {
        match self.last {
            LastInterval::None => None,
            LastInterval::Summed { imu, .. } => Some(imu),
            LastInterval::InParts { time_s, interval_s, on_ideal, measured, flags, .. } => {
                let (ideal, navigated) = self.signals.of(&self.parts, on_ideal);
                let (ideal, compensated) = (Increment::sum(ideal), Increment::sum(navigated));
                let measured = measured.unwrap_or(compensated);
                Some(ImuInterval { time_s, interval_s, ideal, measured, compensated, flags })
            }
        }
    }

    /// Increments on which the INS navigated in update `update` of the last interval, and the length of the update [s].
    pub fn measured_update(&self, update: usize) -> Option<(&[Increment], f64)> {
        let interval_s = self.last.length_s()?;
        let mut updates = self.flown_on().chunks_exact(self.options.subsamples);
        let update_s = interval_s / updates.len() as f64;
        updates.nth(update).map(|increments| (increments, update_s))
    }

    /// Increments on which the INS navigated in the last interval, as far as they are known.
    fn flown_on(&self) -> &[Increment] {
        match self.last {
            LastInterval::None => &[],
            LastInterval::InParts { on_ideal, .. } => self.signals.of(&self.parts, on_ideal).1,
            LastInterval::Summed { .. } => self.signals.of(&self.parts, false).1,
        }
    }

    pub fn trim(&self) -> TrimFigures {
        self.closed_loop.as_ref().map_or(TrimFigures::default(), ClosedLoop::largest)
    }

    pub fn accuracy(&self, truth: &TruthPoint) -> AccuracyFigures {
        self.accuracy.figures(truth.time_s)
    }

    pub fn closure(&self, truth: &TruthPoint) -> ClosureFigures {
        self.closure.figures(&self.earth, truth, &self.navigation_errors(truth))
    }
}
