//! Reads of a simulator: the truth, the navigation, its signals and errors.

use super::{ClosureFigures, ErrorSource, ImuInterval, Mode, Moment, Simulator, Solution, TrimFigures, View};
use crate::base::error::Error;
use crate::base::instruction_set::InstructionSet;
use crate::errors::correction::Compensation;
use crate::errors::covariance::{NavigationCovariance, Propagation};
use crate::errors::{AccuracyFigures, NavigationErrors};
use crate::signal::Increment;
use crate::truth::{TruthPoint, TruthSummary};

/// Number of values that the formulas of a read compute at a time.
pub(super) const READ_WIDTH: usize = 4;

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

    /// Figures of the true motion since the start or the last reset, across repositions and jumps; `None` before the first
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
            None => self.read(|moment| moment.navigation()),
            alone => Ok(alone),
        }
    }

    /// The solution while navigating on increments, without a truth; `None` otherwise.
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

    /// Whether the alignment at the start could not find north, and no unit has found it since.
    pub(crate) fn lacks_north(&self) -> bool {
        matches!(&self.mode, Mode::Flying(chain) if chain.north_unknown)
    }

    /// Increments on which the INS navigated in update `update` of the last interval, measured and compensated, and the length of the
    /// update [s]. [`Self::push_imu`] takes them. `None` if there is no such update, and while navigating on increments.
    pub fn measured_update(&self, update: usize) -> Option<(&[Increment], f64)> {
        match &self.mode {
            Mode::Flying(chain) => chain.measured_update(update),
            _ => None,
        }
    }

    /// Compensation of the sensors in force; all zero before the first step.
    pub fn compensation(&self) -> Compensation {
        let compensation = match &self.mode {
            Mode::Waiting => &None,
            Mode::Flying(chain) => &chain.compensation,
            Mode::Navigating(navigator) => &navigator.compensation,
        };
        compensation.unwrap_or_default()
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
        Ok(self.read(|moment| moment.errors_and_pole(source))?.flatten())
    }

    /// Checks that there are errors of `source`.
    pub(crate) fn refuse_without(&self, source: ErrorSource) -> Result<(), Error> {
        self.refuse_while_navigating()?;
        self.options.check_source(source)
    }

    /// Fills a struct of the host with what `V` reads of this moment; false before the first sample.
    #[inline(always)]
    pub(crate) fn fill<V: View>(&mut self, place: &mut V::Struct) -> Result<bool, Error> {
        self.fill_by::<V>(InstructionSet::up_to(READ_WIDTH), place)
    }

    #[inline(always)]
    fn fill_by<V: View>(&mut self, set: InstructionSet, place: &mut V::Struct) -> Result<bool, Error> {
        let (Mode::Flying(chain), Some(point)) = (&mut self.mode, self.intake.current()) else {
            return self.fill_at_start::<V>(set, place);
        };
        chain.fill::<V>(set, point, place);
        Ok(true)
    }

    #[cold]
    #[inline(never)]
    fn fill_at_start<V: View>(&self, set: InstructionSet, place: &mut V::Struct) -> Result<bool, Error> {
        self.refuse_while_navigating()?;
        let Some(first) = self.intake.front() else { return Ok(false) };
        match &mut self.chain_from_first_sample() {
            Ok(chain) => chain.fill::<V>(set, first, place),
            Err(error) => return Err(*error),
        }
        Ok(true)
    }

    /// Time [s], covariance of the navigation errors and whether the truth is near a pole; `None` before the first sample. The call
    /// changes only scratch memory.
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
        self.covariance.iter_mut().for_each(Propagation::undo_start);
        Ok(covariance)
    }

    /// Accuracy and closure so far; `None` before the first sample.
    pub fn accuracy(&self) -> Result<Option<(f64, AccuracyFigures, ClosureFigures)>, Error> {
        self.read(|Moment { chain, point }| (point.time_s, chain.accuracy(point), chain.closure(point)))
    }

    /// The trim of the closed loop so far, 0 without one; `None` before the first sample.
    pub fn trim(&self) -> Result<Option<TrimFigures>, Error> {
        self.read(|moment| moment.chain.trim())
    }

    /// Reads the chain as it is, or as it will start from the first sample that waits; `None` before the first sample.
    #[inline(always)]
    fn read<T>(&self, view: impl FnOnce(Moment<'_>) -> T) -> Result<Option<T>, Error> {
        self.refuse_while_navigating()?;
        match (&self.mode, self.intake.current(), self.intake.front()) {
            (Mode::Flying(chain), Some(point), _) => Ok(Some(view(Moment { chain, point }))),
            (_, _, Some(first)) => self.read_start(view, first).map(Some),
            _ => Ok(None),
        }
    }

    /// Not inlined, because no other read needs the stack of a chain. The chain is read by reference: `?` would take it out of its
    /// `Result`, which is a copy.
    #[cold]
    #[inline(never)]
    fn read_start<T>(&self, view: impl FnOnce(Moment<'_>) -> T, point: &TruthPoint) -> Result<T, Error> {
        match &self.chain_from_first_sample() {
            Ok(chain) => Ok(view(Moment { chain, point })),
            Err(error) => Err(*error),
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use nalgebra::Vector3;

    use super::*;
    use crate::base::math::{Euler, mix};
    use crate::earth::Geodetic;
    use crate::earth::state::BodyAxes;
    use crate::sensors::InitialErrorParameters;
    use crate::simulator::{Options, Step};
    use crate::truth::FlightSample;

    struct Everything;

    impl View for Everything {
        type Struct = String;
        const OF_TRUTH: bool = true;
        const OF_NAVIGATION: bool = true;

        #[inline(always)]
        fn fill(text: &mut String, moment: Moment<'_>) {
            let errors = (moment.navigation_errors(), moment.model_errors());
            *text = format!("{:?}", (moment.truth(), moment.navigation(), errors));
        }
    }

    /// Any places and attitudes, including poles, the zenith and the date line, with errors up to half a turn.
    #[test]
    fn every_instruction_set_reads_the_same_bits() {
        let mut draws = 0;
        let mut draw = |size: f64| {
            draws += 1;
            size * (mix(draws) as f64 / 2f64.powi(63) - 1.0)
        };
        for k in 0..2000_u64 {
            let axes = if k % 3 == 0 { BodyAxes::ForwardRightDown } else { BodyAxes::RightForwardUp };
            let options = Options { error_model: true, axes, ..Options::default() };
            let mut simulator = Simulator::new(&options).unwrap();
            let error = 10f64.powi(-(k as i32 % 12));
            simulator
                .set_initial_errors(&InitialErrorParameters {
                    position_n: Vector3::new(draw(1e6), draw(1e6), draw(1e3)) * error,
                    velocity_n: Vector3::repeat(100.0 * error),
                    misalignment_n: Vector3::new(draw(3.0), draw(3.0), draw(3.0)) * error,
                    ..Default::default()
                })
                .unwrap();
            let near =
                |angle: f64, limit: f64, is_near: bool| if is_near { limit + 1e-5 * angle } else { angle };
            let sample = FlightSample {
                place: Geodetic {
                    latitude_rad: near(draw(FRAC_PI_2), FRAC_PI_2 - 1e-4, k % 5 == 0),
                    longitude_rad: near(draw(PI), PI - 1e-5, k % 7 == 0),
                    height_m: draw(9000.0),
                },
                euler: Euler {
                    roll: draw(PI),
                    pitch: near(draw(FRAC_PI_2), 1e-4 - FRAC_PI_2, k % 11 == 0),
                    heading: draw(7.0),
                },
                v_n: (k % 4 > 0).then(|| Vector3::new(draw(100.0), draw(100.0), draw(10.0))),
                ..FlightSample::default()
            };
            simulator.push_sample(&sample).unwrap();
            simulator.push_sample(&FlightSample { time_s: 0.01, ..sample }).unwrap();
            assert_eq!(simulator.step(), Ok(Step::Done));
            let read = |set: InstructionSet| {
                let mut text = String::new();
                assert_eq!(simulator.clone().fill_by::<Everything>(set, &mut text), Ok(true));
                text
            };
            assert_eq!(read(InstructionSet::up_to(1)), read(InstructionSet::up_to(READ_WIDTH)), "{k}");
        }
    }
}
