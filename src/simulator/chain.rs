//! Truth → signal generator → sensors → mechanization → errors, for the samples of a flight.

mod snapshot;

use super::closed_loop::{ClosedLoop, TrimFigures};
use super::closure::{Closure, ClosureFigures};
use super::interval::{ImuInterval, LastInterval};
use super::start::{start_errors, with_errors};
use super::{ErrorSource, Options, Saturation, SensorSuite, Solution, singular};
use crate::earth::Earth;
use crate::error::Error;
use crate::errors::{
    Accuracy, AccuracyFigures, ErrorModel, NavigationErrors, SensorErrors, StartErrors,
    navigation_minus_truth,
};
use crate::math::sin_cos;
use crate::mechanization::{Frame, Mechanization, VerticalAid, VerticalMode};
use crate::signal::{Increment, MAX_INCREMENTS, SignalGenerator};
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
    last: LastInterval,
    mechanization: Mechanization,
    error_model: Option<ErrorModel>,
    accuracy: Accuracy,
    intervals: u64,
    closure: Closure,
    closed_loop: Option<ClosedLoop>,
}

impl Chain {
    /// The INS set up at the truth `first` with its initial errors.
    pub fn start(
        options: &Options,
        earth: Earth,
        first: &TruthPoint,
        sensors: &SensorSuite,
    ) -> Result<Self, Error> {
        let truth = first.navigation(&earth, options.axes);
        let start = start_errors(options, &earth, first, &truth, sensors)?;
        let state = with_errors(&earth, options, &truth, &start).earth_fixed(&earth);
        let mechanization = Mechanization::new(earth, options.frame, options.scheme, &state);
        mechanization.check()?;
        Ok(Self::new(options, earth, first, &start, mechanization, start != StartErrors::NONE))
    }

    /// A chain at the truth `first` whose navigator is `mechanization`, off the truth by `start`.
    fn new(
        options: &Options,
        earth: Earth,
        first: &TruthPoint,
        start: &StartErrors,
        mechanization: Mechanization,
        with_shadow: bool,
    ) -> Self {
        let closed_loop = options.closed_loop_time_s.map(|time_constant_s| {
            let at_truth = || Mechanization::new(earth, options.frame, options.scheme, &first.state);
            ClosedLoop::new(time_constant_s, first.time_s, with_shadow.then(at_truth))
        });
        let error_model = options.error_model.then(|| ErrorModel::new(earth, options.frame, first, start));
        Self {
            options: *options,
            earth,
            generator: SignalGenerator::new(earth.rate_rad_s),
            ideal: [Increment::ZERO; MAX_INCREMENTS],
            measured: [Increment::ZERO; MAX_INCREMENTS],
            last: LastInterval::None,
            mechanization,
            error_model,
            accuracy: Accuracy::new(first.time_s),
            intervals: 0,
            closure: Closure::new(),
            closed_loop,
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
        if is_tame && self.mechanization.is_safe() {
            self.fly(recent, sensors);
            return Ok(());
        }
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
        let count = self.increments();

        // Signal generator.
        let motion = self.generator.advance(recent);
        let ideal = &mut self.ideal[..count];
        motion.integrate(ideal);
        if let Some(closed_loop) = &self.closed_loop {
            closed_loop.trim(ideal, t);
        }

        // Sensors.
        let sensors_were_ideal = sensors.are_ideal();
        let mut saturation = Saturation::default();
        let increments = if sensors_were_ideal {
            &*ideal
        } else {
            let measured = &mut self.measured[..count];
            saturation = sensors.sense(ideal, t / count as f64, measured);
            &*measured
        };
        self.last =
            LastInterval::Flown { time_s: next.time_s, interval_s: t, sensors_were_ideal, saturation };

        // Mechanization, and the error-free one beside it.
        let aid = vertical_aid(self.options.vertical, next, |height_m| {
            sensors.altimeter.sense(height_m, next.interval_s)
        });
        let errs = !sensors.all_are_ideal();
        if let Some(shadow) =
            self.closed_loop.as_mut().and_then(|closed_loop| closed_loop.shadow(&self.mechanization, errs))
        {
            let aid = vertical_aid(self.options.vertical, next, |height_m| height_m);
            navigate(shadow, &self.options, ideal, t, &aid);
        }
        navigate(&mut self.mechanization, &self.options, increments, t, &aid);
        if let Some(closed_loop) = &mut self.closed_loop {
            closed_loop.observe(&self.mechanization, next);
        }

        // Errors.
        if let Some(model) = &mut self.error_model {
            let errors = SensorErrors::between(ideal, increments, t);
            model.advance(&motion, next, &errors, &aid);
        }
        let inconsistency = motion.displacement() - (next.state.r_e - recent.current.state.r_e);
        self.closure.advance(&self.earth, next, &inconsistency);
        self.intervals += 1;
        if self.accuracy.is_due(next.time_s) {
            let errors = self.navigation_errors(next);
            self.accuracy.add(next.time_s, &errors);
        }
    }

    pub fn intervals(&self) -> u64 {
        self.intervals
    }

    /// The solution of the truth, which is at `truth`.
    pub fn truth(&self, truth: &TruthPoint) -> Solution {
        let inconsistent = self.closure.last_flagged();
        Solution { inconsistent, ..Solution::of_truth(&self.options, &self.earth, truth) }
    }

    /// The navigated solution while the truth is at `truth`.
    pub fn navigation(&self, truth: &TruthPoint) -> Solution {
        let navigation = self.mechanization.navigation(self.options.axes);
        let vertical_unaided = self.options.vertical == VerticalMode::Free;
        Solution { vertical_unaided, ..Solution::new(&self.earth, truth.time_s, navigation) }
    }

    pub fn ideal_increments(&self) -> &[Increment] {
        match self.last {
            LastInterval::Flown { .. } => &self.ideal[..self.increments()],
            LastInterval::None | LastInterval::Loaded(_) => &[],
        }
    }

    pub fn imu(&self) -> Option<ImuInterval> {
        let (time_s, interval_s, sensors_were_ideal, saturation) = match self.last {
            LastInterval::None => return None,
            LastInterval::Loaded(imu) => return Some(imu),
            LastInterval::Flown { time_s, interval_s, sensors_were_ideal, saturation } => {
                (time_s, interval_s, sensors_were_ideal, saturation)
            }
        };
        let measured = if sensors_were_ideal { &self.ideal } else { &self.measured };
        Some(ImuInterval {
            time_s,
            interval_s,
            ideal: Increment::sum(self.ideal_increments()),
            measured: Increment::sum(&measured[..self.increments()]),
            saturation,
        })
    }

    /// Sub-increments of an interval.
    fn increments(&self) -> usize {
        self.options.subsamples * self.options.updates_per_sample
    }

    fn navigation_errors(&self, truth: &TruthPoint) -> NavigationErrors {
        let axes = self.options.axes;
        let truth = truth.navigation(&self.earth, axes);
        navigation_minus_truth(&self.earth, &self.mechanization.navigation(axes), &truth)
    }

    /// The errors while the truth is at `truth`; `None` while the error model is off.
    pub fn errors(&self, source: ErrorSource, truth: &TruthPoint) -> Option<NavigationErrors> {
        let axes = self.options.axes;
        match source {
            ErrorSource::Navigation => Some(self.navigation_errors(truth)),
            ErrorSource::Model => self
                .error_model
                .as_ref()
                .map(|model| model.errors(&truth.navigation(&self.earth, axes), axes)),
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

/// Navigates over an interval of length `t` [s], with the vertical channel's aid at its end.
fn navigate(
    mechanization: &mut Mechanization,
    options: &Options,
    increments: &[Increment],
    t: f64,
    aid: &VerticalAid,
) {
    for update in increments.chunks_exact(options.subsamples) {
        mechanization.update(update, t / options.updates_per_sample as f64);
    }
    mechanization.aid_vertical(aid, t);
}

/// What the vertical channel is told at the sample `next`; `sense` makes the indicated height of the true one.
fn vertical_aid(mode: VerticalMode, next: &TruthPoint, sense: impl FnOnce(f64) -> f64) -> VerticalAid {
    let height_m = next.sample.place.height_m;
    match mode {
        VerticalMode::Free => VerticalAid::None,
        VerticalMode::Damped => VerticalAid::Barometer { height_m: sense(height_m) },
        VerticalMode::FollowTruth => VerticalAid::Truth {
            height_m,
            velocity_up_m_s: match &next.sample.v_n {
                Some(v_n) => v_n.z,
                None => next.up_e.dot(&next.state.v_e),
            },
        },
    }
}
