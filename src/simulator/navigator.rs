//! Navigation alone, on recorded or foreign increments.

use super::imperfections::IntervalConditions;
use super::{Imperfections, ImuInterval, Options, Solution};
use crate::base::error::{Error, Rule, check_range, check_ranges};
use crate::base::math::two_sum;
use crate::base::snapshot::{CLOCK_S, stored};
use crate::earth::Earth;
use crate::earth::state::{BodyAxes, Navigation, StateErrors};
use crate::errors::correction::{Compensation, Correction};
use crate::mechanization::{MAX_SUBSAMPLES, Mechanization};
use crate::signal::Increment;

/// A mechanization without a truth: its vertical channel is free.
#[derive(Debug, Clone)]
pub(super) struct Navigator {
    earth: Earth,
    axes: BodyAxes,
    mechanization: Mechanization,
    /// Time [s]; `time_carry_s` is what its sum over the intervals lost by rounding [s].
    time_s: f64,
    time_carry_s: f64,
    imu: Option<ImuInterval>,
    pub compensation: Option<Compensation>,
}

stored!(Navigator { mechanization, time_s: CLOCK_S, time_carry_s: 1.0, imu, compensation } rebuilt { earth, axes });

impl Navigator {
    pub fn new(options: &Options, earth: Earth, time_s: f64, navigation: &Navigation) -> Self {
        let state = navigation.earth_fixed(&earth);
        let mechanization = Mechanization::new(earth, options.frame, options.scheme, &state);
        Self {
            earth,
            axes: options.axes,
            mechanization,
            time_s,
            time_carry_s: 0.0,
            imu: None,
            compensation: None,
        }
    }

    pub fn check(&self) -> Result<(), Error> {
        self.mechanization.check()
    }

    pub fn advance(
        &mut self,
        increments: &[Increment],
        interval_s: f64,
        imperfections: &mut Imperfections,
    ) -> Result<(), Error> {
        check_range("imu.interval_s", interval_s, 5e-5, 10.0)?;
        check_range("imu.count", increments.len() as f64, 1.0, MAX_SUBSAMPLES as f64)?;
        for (index, increment) in increments.iter().enumerate() {
            let at = |error: Error| error.at(3 * index + error.index.unwrap_or(0));
            check_ranges("imu.angle_rad", increment.angle.as_slice(), -1e3, 1e3).map_err(at)?;
            check_ranges("imu.velocity_m_s", increment.velocity.as_slice(), -1e4, 1e4).map_err(at)?;
        }
        let (time_s, lost) = two_sum(self.time_s, interval_s + self.time_carry_s);
        check_range("time after the interval [s]", time_s, -CLOCK_S, CLOCK_S)?;
        let sum = Increment::sum(increments);
        let largest =
            increments.iter().chain([&sum]).map(|part| part.angle.norm_squared()).fold(0.0, f64::max);
        if largest >= core::f64::consts::PI * core::f64::consts::PI {
            let rule =
                Rule::Sentence("the rotation of an increment and of an interval must stay below half a turn");
            return Err(Error::invalid("imu.angle_rad", largest.sqrt(), rule));
        }

        let before = self.mechanization.solution();
        let dt = interval_s / increments.len() as f64;
        let mut measured = [Increment::ZERO; MAX_SUBSAMPLES];
        let measured = &mut measured[..increments.len()];
        imperfections.begin_interval(interval_s, IntervalConditions::default);
        let flags = imperfections.sense(increments, dt, measured);
        let sum_measured = match &self.compensation {
            Some(compensation) => compensation.apply(measured, dt),
            None => Increment::sum(measured),
        };
        self.mechanization.update(measured, interval_s);
        if let Err(error) = self.mechanization.check() {
            self.mechanization.go_back(&before);
            imperfections.undo();
            return Err(error);
        }
        (self.time_s, self.time_carry_s) = (time_s, lost);
        let compensated = Increment::sum(measured);
        self.imu =
            Some(ImuInterval { time_s, interval_s, ideal: sum, measured: sum_measured, compensated, flags });
        Ok(())
    }

    /// Removes the errors of `correction`.
    pub fn correct(&mut self, correction: &Correction) -> Result<(), Error> {
        let compensation = Compensation::sum(self.compensation.as_ref(), &correction.sensors)?;
        if correction.errors != StateErrors::NONE {
            let state = correction.corrected(&self.earth, &self.mechanization.state())?;
            let mechanization = self.mechanization.moved_to(&state);
            mechanization.check()?;
            self.mechanization = mechanization;
        }
        self.compensation = compensation;
        Ok(())
    }

    pub fn solution(&self) -> Solution {
        let navigation = self.mechanization.navigation(self.axes);
        Solution { vertical_unaided: true, ..Solution::new(&self.earth, self.time_s, navigation) }
    }

    pub fn imu(&self) -> Option<ImuInterval> {
        self.imu
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::earth::Geodetic;
    use crate::simulator::Simulator;
    use nalgebra::{Quaternion, Vector3};

    /// A navigator reaches only states that a snapshot may hold: it goes no further than the limit of clocks.
    #[test]
    fn a_navigator_at_the_end_of_time_can_be_saved_and_loaded() {
        let options = Options::default();
        let start =
            Navigation::new(Geodetic::default(), Vector3::zeros(), Quaternion::identity(), options.axes);
        let mut simulator = Simulator::new(&options).unwrap();
        simulator.start_navigation(CLOCK_S - 15.0, &start).unwrap();
        let increment = Increment { angle: Vector3::zeros(), velocity: Vector3::z() * 98.0 };
        let mut buffer = [0; 8192];
        let mut answers = Vec::new();
        for _ in 0..3 {
            answers.push(simulator.push_imu(&[increment], 10.0).is_ok());
            let length = simulator.save_snapshot(&mut buffer).unwrap();
            simulator.load_snapshot(&buffer[..length]).unwrap();
        }
        assert_eq!(answers, [true, false, false]);
    }
}
