//! Truth → signal generator → sensors → mechanization → errors, for the samples of a flight.

mod beside;
mod snapshot;

use beside::conditions;

use super::aid::vertical_aid;
use super::closed_loop::{ClosedLoop, TrimFigures};
use super::closure::{Closure, ClosureFigures};
use super::disturbance::Disturbance;
use super::interval::LastInterval;
use super::mounted::block_at_start;
use super::start::{start_errors, with_errors};
use super::views::Views;
use super::{ErrorSource, ImuFlags, ImuInterval, Options, SensorSuite, Solution, singular};
use crate::earth::Earth;
use crate::error::Error;
use crate::errors::{
    Accuracy, AccuracyFigures, ErrorModel, NavigationErrors, SensorErrors, navigation_minus_truth,
};
use crate::math::sin_cos;
use crate::mechanization::{Frame, Mechanization, VerticalAid, VerticalMode};
use crate::mounting::Block;
use crate::signal::{Increment, MAX_INCREMENTS, SignalGenerator};
use crate::state::{EarthFixedState, Navigation, StateErrors};
use crate::truth::{Recent, TruthPoint};

/// The chain in flight.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    options: Options,
    earth: Earth,
    generator: SignalGenerator,
    /// Ideal increments of the last interval, and measured ones unless the sensors were ideal.
    ideal: [Increment; MAX_INCREMENTS],
    measured: [Increment; MAX_INCREMENTS],
    /// Updates of the last interval.
    updates: usize,
    last: LastInterval,
    /// The sensors' block, where it does not sit at the reference point.
    block: Option<Block>,
    /// True less normal gravity, where it is other.
    disturbance: Option<Disturbance>,
    /// Neither block nor disturbance nor closed loop: the ideal signals are the generator's.
    is_plain: bool,
    mechanization: Mechanization,
    error_model: Option<ErrorModel>,
    accuracy: Accuracy,
    intervals: u64,
    closure: Closure,
    closed_loop: Option<ClosedLoop>,
    views: Views,
}

/// What a mounting and gravity beyond the normal field make of a chain, and the true state of the sensors.
struct Beside {
    block: Option<Block>,
    disturbance: Option<Disturbance>,
    sensors_state: EarthFixedState,
}

impl Chain {
    /// The INS set up at the truth `first` with its initial errors; `interval` is the first, if its end is known.
    pub fn start(
        options: &Options,
        earth: Earth,
        first: &TruthPoint,
        interval: Option<&Recent<'_>>,
        sensors: &SensorSuite,
    ) -> Result<Self, Error> {
        let block =
            sensors.mounting().map(|mounting| block_at_start(mounting, options, &earth, first, interval));
        let (sensors_state, truth) = match &block {
            Some(block) => {
                let state = block.state(first);
                (state, state.navigation(&earth, options.axes))
            }
            None => (first.state, first.navigation(&earth, options.axes)),
        };
        let disturbance =
            sensors.gravity.is_on().then(|| Disturbance::new(sensors.gravity.at(&earth, first)));
        let at = (first, &sensors_state);
        let disturbance_e = disturbance.as_ref().map(Disturbance::at_last_e);
        let start = start_errors(options, &earth, at, &truth, disturbance_e, sensors)?;
        let state = with_errors(&earth, options, &truth, &start).earth_fixed(&earth);
        let mechanization = Mechanization::new(earth, options.frame, options.scheme, &state);
        mechanization.check()?;
        let beside = Beside { block, disturbance, sensors_state };
        Ok(Self::new(options, earth, first, &start, mechanization, start != StateErrors::NONE, beside))
    }

    /// A chain at the truth `first` whose navigator is `mechanization`, off the truth by `start`.
    fn new(
        options: &Options,
        earth: Earth,
        first: &TruthPoint,
        start: &StateErrors,
        mechanization: Mechanization,
        with_shadow: bool,
        Beside { block, disturbance, sensors_state }: Beside,
    ) -> Self {
        let closed_loop = options.closed_loop_time_s.map(|time_constant_s| {
            let at_truth = || Mechanization::new(earth, options.frame, options.scheme, &sensors_state);
            ClosedLoop::new(time_constant_s, first.time_s, with_shadow.then(at_truth))
        });
        let error_model = options
            .error_model
            .then(|| ErrorModel::new(earth, options.frame, &first.vertical(), &sensors_state.v_e, start));
        Self {
            options: *options,
            earth,
            generator: SignalGenerator::new(earth.rate_rad_s),
            ideal: [Increment::ZERO; MAX_INCREMENTS],
            measured: [Increment::ZERO; MAX_INCREMENTS],
            updates: options.updates_per_sample,
            last: LastInterval::None,
            is_plain: block.is_none() && disturbance.is_none() && closed_loop.is_none(),
            block,
            disturbance,
            mechanization,
            error_model,
            accuracy: Accuracy::new(first.time_s),
            intervals: 0,
            closure: Closure::new(),
            closed_loop,
            views: Views::default(),
        }
    }

    /// Flies the interval that `recent` ends; on an error nothing has changed.
    pub fn advance(&mut self, recent: &Recent<'_>, sensors: &mut SensorSuite) -> Result<(), Error> {
        self.check_truth(recent.next)?;
        let change = recent.next.state.v_e - recent.current.state.v_e;
        // Gravity and rotation of the axes change the velocity as well, by a thousandth of the bound.
        let limit = 0.2 * Mechanization::TAME_CHANGE_M_S;
        let is_tame = sensors.are_tame()
            && recent.next.interval_s <= Mechanization::TAME_INTERVAL_S
            && change.norm_squared() < limit * limit;
        // What tame sensors add, by their definition, stays below 5000 √t.
        let largest_change = 5.0 * change.norm_squared().sqrt() + 5e3 * recent.next.interval_s.sqrt();
        if is_tame && self.mechanization.is_safe(recent.next.interval_s, largest_change) {
            self.fly(recent, sensors);
            return Ok(());
        }
        self.fly_watched(recent, sensors)
    }

    /// Flies, and goes back where the solution left its limits. Kept apart for the stack that the copies take.
    #[cold]
    #[inline(never)]
    fn fly_watched(&mut self, recent: &Recent<'_>, sensors: &mut SensorSuite) -> Result<(), Error> {
        let before = (self.clone(), sensors.clone());
        self.fly(recent, sensors);
        let result = self.mechanization.check();
        if result.is_err() {
            (*self, *sensors) = before;
        }
        result
    }

    /// Whether the mechanization can follow the truth to `next`.
    fn check_truth(&self, next: &TruthPoint) -> Result<(), Error> {
        if self.options.frame == Frame::Geographic {
            let cos = sin_cos(next.sample.place.latitude_rad).1;
            if cos < Mechanization::MIN_COS_LATITUDE {
                return Err(singular(
                    "cosine of sample.latitude_rad",
                    cos,
                    "the geographic frame needs at least",
                    Mechanization::MIN_COS_LATITUDE,
                ));
            }
        }
        Ok(())
    }

    fn fly(&mut self, recent: &Recent<'_>, sensors: &mut SensorSuite) {
        let next = recent.next;
        let t = next.interval_s;
        self.updates = self.options.updates_over(recent);
        let count = self.increments();
        self.views = Views::default();

        // Signal generator.
        let motion = self.generator.advance(recent);
        motion.integrate(&mut self.ideal[..count]);
        if !self.is_plain {
            self.complete_ideal_signals(&motion, recent, sensors);
        }
        let ideal = &self.ideal[..count];

        // Sensors.
        let sensors_were_ideal = sensors.are_ideal();
        let mut flags = ImuFlags::default();
        let increments = if sensors_were_ideal {
            ideal
        } else {
            let measured = &mut self.measured[..count];
            sensors.begin_interval(t, || conditions(recent, &motion, self.block.as_ref()));
            flags = sensors.sense(ideal, t / count as f64, measured);
            &*measured
        };

        // Mechanization.
        let aid = vertical_aid(self.options.vertical, next, |height_m| {
            sensors.altimeter.sense(height_m, next.interval_s)
        });
        self.last = LastInterval::Flown {
            time_s: next.time_s,
            interval_s: t,
            sensors_were_ideal,
            flags,
            vertical_unaided: aid == VerticalAid::None,
        };
        navigate(&mut self.mechanization, self.options.subsamples, increments, t);
        if self.is_plain {
            self.mechanization.aid_vertical(&aid, t);
        } else {
            self.aid_and_observe(next, &aid);
        }

        // Errors.
        if let Some(model) = &mut self.error_model {
            let increments = if sensors_were_ideal { &self.ideal } else { &self.measured };
            let mut errors = SensorErrors::between(&self.ideal[..count], &increments[..count], t);
            if let Some(disturbance) = &self.disturbance {
                errors = errors.plus(disturbance.felt());
            }
            model.advance(&motion, next, &errors, &aid, self.block.as_ref());
        }
        let inconsistency = motion.displacement() - (next.state.r_e - recent.current.state.r_e);
        self.closure.advance(&self.earth, next, &inconsistency);
        self.intervals += 1;
        if self.accuracy.is_due(next.time_s) {
            let errors = *self.navigation_errors(next);
            self.accuracy.add(next.time_s, &errors, next.is_near_pole());
        }
    }

    pub fn intervals(&self) -> u64 {
        self.intervals
    }

    /// The solution of the truth, which is at `truth`.
    pub fn truth(&self, truth: &TruthPoint) -> Solution {
        let inconsistent = self.closure.last_flagged();
        Solution { inconsistent, ..Solution::new(&self.earth, truth.time_s, *self.true_view(truth)) }
    }

    /// The navigated solution while the truth is at `truth`.
    pub fn navigation(&self, truth: &TruthPoint) -> Solution {
        let vertical_unaided =
            self.last.vertical_unaided().unwrap_or(self.options.vertical == VerticalMode::Free);
        Solution { vertical_unaided, ..Solution::new(&self.earth, truth.time_s, *self.navigated_view()) }
    }

    pub fn ideal_increments(&self) -> &[Increment] {
        match self.last {
            LastInterval::Flown { .. } => &self.ideal[..self.increments()],
            LastInterval::None | LastInterval::Loaded { .. } => &[],
        }
    }

    pub fn imu(&self) -> Option<ImuInterval> {
        let (time_s, interval_s, sensors_were_ideal, flags) = match self.last {
            LastInterval::None => return None,
            LastInterval::Loaded { imu, .. } => return Some(imu),
            LastInterval::Flown { time_s, interval_s, sensors_were_ideal, flags, .. } => {
                (time_s, interval_s, sensors_were_ideal, flags)
            }
        };
        let measured = if sensors_were_ideal { &self.ideal } else { &self.measured };
        Some(ImuInterval {
            time_s,
            interval_s,
            ideal: Increment::sum(self.ideal_increments()),
            measured: Increment::sum(&measured[..self.increments()]),
            flags,
        })
    }

    /// Sub-increments of an interval.
    fn increments(&self) -> usize {
        self.options.subsamples * self.updates
    }

    fn true_view(&self, truth: &TruthPoint) -> &Navigation {
        self.views.truth.get_or_init(|| truth.navigation(&self.earth, self.options.axes))
    }

    /// What the INS gives out, of the reference point.
    fn navigated_view(&self) -> &Navigation {
        let axes = self.options.axes;
        self.views.navigation.get_or_init(|| match &self.block {
            None => self.mechanization.navigation(axes),
            Some(block) => {
                block.belief().reference_point(&self.mechanization.state()).navigation(&self.earth, axes)
            }
        })
    }

    fn navigation_errors(&self, truth: &TruthPoint) -> &NavigationErrors {
        self.views
            .difference
            .get_or_init(|| navigation_minus_truth(&self.earth, self.navigated_view(), self.true_view(truth)))
    }

    /// The errors while the truth is at `truth`; `None` while the error model is off.
    pub fn errors(&self, source: ErrorSource, truth: &TruthPoint) -> Option<NavigationErrors> {
        match source {
            ErrorSource::Navigation => Some(*self.navigation_errors(truth)),
            ErrorSource::Model => self.error_model.as_ref().map(|model| {
                let (truth_view, axes) = (self.true_view(truth), self.options.axes);
                *self.views.model.get_or_init(|| model.errors(truth, truth_view, axes, self.block.as_ref()))
            }),
        }
    }

    pub fn trim(&self) -> TrimFigures {
        self.closed_loop.as_ref().map_or(TrimFigures::default(), ClosedLoop::largest)
    }

    pub fn accuracy(&self, truth: &TruthPoint) -> AccuracyFigures {
        self.accuracy.figures(truth.time_s)
    }

    pub fn closure(&self, truth: &TruthPoint) -> ClosureFigures {
        self.closure.figures(&self.earth, truth, self.navigation_errors(truth))
    }
}

/// Navigates over an interval of length `t` [s], in updates of so many subsamples.
fn navigate(mechanization: &mut Mechanization, subsamples: usize, increments: &[Increment], t: f64) {
    let updates = increments.chunks_exact(subsamples);
    let update_s = t / updates.len() as f64;
    for update in updates {
        mechanization.update(update, update_s);
    }
}
