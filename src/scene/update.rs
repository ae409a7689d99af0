//! Planned updates: at their times a fix of the position or of the velocity takes the place of the navigated one.

use nalgebra::Vector3;

use super::Scene;
use super::schedule::{FliesScene, MAX_ITEMS, ROUNDING, TIMES_S};
use crate::base::error::{Error, check_range, check_ranges, check_within};
use crate::base::snapshot::codes;
use crate::earth::Geodetic;
use crate::errors::NavigationErrors;
use crate::errors::correction::Correction;
use crate::mechanization::VerticalMode;
use crate::sensors::StreamKey;
use crate::simulator::Simulator;
use crate::unit::Unit;

/// What an update corrects. The numbers are part of the bit-for-bit guarantee: never reuse one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Updated {
    /// Position: east, north and height.
    #[default]
    Position = 0,
    /// Position along east and north.
    HorizontalPosition = 1,
    /// Velocity: east, north and up.
    Velocity = 2,
}

codes!(Updated { Position = 0 "position", HorizontalPosition = 1 "horizontal_position", Velocity = 2 "velocity" });

/// A planned update. After it the solution has the error of the fix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlannedUpdate {
    /// What it corrects.
    pub updated: Updated,
    /// Its time since the start of the flight [s].
    pub at_s: f64,
    /// Time from one update to the next [s]; infinite: there is only one.
    pub every_s: f64,
    /// Standard deviation of the error of the fix, east-north-up [m] or [m/s]; that of a height that is not corrected does not count.
    pub sigma_n: Vector3<f64>,
}

impl PlannedUpdate {
    /// Times of updates [s]: the navigation starts with the first interval.
    pub(super) const TIMES_S: (f64, f64) = (1e-4, TIMES_S.1);
    /// Standard deviations of a position [m], and of a velocity [m/s].
    pub(super) const SIGMAS_M: (f64, f64) = (0.0, 1e5);
    pub(super) const SIGMAS_M_S: (f64, f64) = (0.0, 1e3);

    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {
        let Self { updated, at_s, every_s, sigma_n } = self;
        check_within("update.at_s", *at_s, Self::TIMES_S)?;
        if *every_s != f64::INFINITY {
            check_within("update.every_s", *every_s, Self::TIMES_S)?;
        }
        let (field, (low, high)) = match updated {
            Updated::Velocity => ("update.sigma_m_s", Self::SIGMAS_M_S),
            _ => ("update.sigma_m", Self::SIGMAS_M),
        };
        check_ranges(field, sigma_n.as_slice(), low, high)
    }

    /// The planned time of the last update that is due after `before_s` and not after `time_s` [s].
    fn due_s(&self, before_s: f64, time_s: f64) -> Option<f64> {
        let &Self { at_s, every_s, .. } = self;
        let count = if every_s.is_finite() { ((time_s - at_s) / every_s).floor().max(0.0) } else { 0.0 };
        // The quotient is rounded, so its neighbours may be the last one.
        let planned = [count + 1.0, count, count - 1.0].into_iter().filter(|count| *count >= 0.0);
        let planned_s = planned.map(|count| if count == 0.0 { at_s } else { at_s + count * every_s });
        planned_s.into_iter().find(|planned_s| *planned_s <= time_s).filter(|planned_s| *planned_s > before_s)
    }

    /// Adds this update, planned for `at_s` [s], to the correction of the run `key`, whose solution has the errors `errors`. The error
    /// of the fix depends on the run, on what is updated, and on the planned time alone.
    fn add_to(
        &self,
        correction: &mut Correction,
        at_s: f64,
        vertical: VerticalMode,
        key: StreamKey,
        errors: &NavigationErrors,
    ) {
        let (of_solution, removed) = match self.updated {
            Updated::Velocity => (&errors.velocity_n, &mut correction.errors.velocity_n),
            _ => (&errors.position_n, &mut correction.errors.position_n),
        };
        let of_fix = self.error_of_fix(at_s, key);
        let has_height = self.updated != Updated::HorizontalPosition && vertical != VerticalMode::FollowTruth;
        for axis in 0..if has_height { 3 } else { 2 } {
            removed[axis] = of_solution[axis] - of_fix[axis];
        }
    }

    fn error_of_fix(&self, at_s: f64, key: StreamKey) -> Vector3<f64> {
        self.sigma_n.component_mul(&key.fix(self.updated as u64, at_s))
    }
}

impl Scene {
    /// Gives `unit` the fixes that are due at the end of the last interval of `simulator`: those of the velocity, each with the
    /// position of an update at the same time, else with the true one.
    pub(super) fn push_fixes(
        &self,
        unit: &mut Unit,
        simulator: &mut Simulator,
        start_s: f64,
    ) -> Result<(), Error> {
        let Some(interval_s) = simulator.last_interval_s() else { return Ok(()) };
        let [before_s, time_s] =
            interval_s.map(|at_s| at_s - start_s + ROUNDING * (interval_s[1] - interval_s[0]));
        let key = self.options.key;
        let error = |is_meant: fn(&Updated) -> bool| {
            let mut meant = self.updates.iter().filter(|planned| is_meant(&planned.updated));
            meant.find_map(|planned| Some(planned.error_of_fix(planned.due_s(before_s, time_s)?, key)))
        };
        let (Some(of_velocity), Some(truth)) = (error(|of| *of == Updated::Velocity), simulator.truth()?)
        else {
            return Ok(());
        };
        let of_position = error(|of| *of != Updated::Velocity).unwrap_or_default();
        let (earth, place) = (simulator.options().earth(), truth.navigation.place);
        let (east, north, _) = earth.east_north_up(&place);
        let r_e = earth.to_earth_fixed(&place) + east * of_position.x + north * of_position.y;
        let place = Geodetic { height_m: place.height_m + of_position.z, ..earth.to_geodetic(&r_e) };
        unit.push_fix(simulator, place, truth.navigation.v_n + of_velocity)
    }

    /// Plans another update, which has been validated.
    pub fn add_update(&mut self, planned: PlannedUpdate) -> Result<(), Error> {
        check_range("updates of the scene", (self.updates.len() + 1) as f64, 0.0, MAX_ITEMS as f64)?;
        self.updates.push(planned);
        Ok(())
    }

    /// Makes the updates that are due at `time_s` [s] since the start of the flight, whose first time stamp is `start_s` [s].
    pub(super) fn update(&self, flown: &mut dyn FliesScene, start_s: f64, time_s: f64) -> Result<(), Error> {
        if self.updates.is_empty() {
            return Ok(());
        }
        let Some([from_s, to_s]) = flown.last_interval_s() else { return Ok(()) };
        // To the bit the `time_s` of the call before, so that no update is lost or made twice.
        let before_s = from_s - start_s + ROUNDING * (to_s - from_s);
        let due = |planned: &PlannedUpdate| planned.due_s(before_s, time_s);
        if self.updates.iter().all(|planned| due(planned).is_none()) {
            return Ok(());
        }
        flown.correct_each(&|key, errors| {
            let mut correction = Correction::default();
            for planned in &self.updates {
                if let Some(at_s) = due(planned) {
                    planned.add_to(&mut correction, at_s, self.options.vertical, key, errors);
                }
            }
            correction
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Over many intervals of a length that binary numbers cannot hold, each planned time is due once.
    #[test]
    fn every_planned_time_is_due_in_one_interval() {
        for (at_s, every_s, period_s) in [(0.3, 0.1, 0.01), (0.1, 0.7, 0.1), (1.0, 1.0, 1.0 / 3.0)] {
            let planned =
                PlannedUpdate { updated: Updated::Velocity, at_s, every_s, sigma_n: Vector3::zeros() };
            let end = |index: i32| f64::from(index) * period_s + 1e-9 * period_s;
            let due: Vec<f64> =
                (1..100_000).filter_map(|index| planned.due_s(end(index - 1), end(index))).collect();
            let count = ((end(99_999) - at_s) / every_s).floor() as usize + 1;
            assert_eq!(due.len(), count);
            let is_planned = |(k, due_s): (usize, &f64)| *due_s == at_s + k as f64 * every_s;
            assert!(due.iter().enumerate().all(is_planned));
        }
        let once = PlannedUpdate {
            updated: Updated::Position,
            at_s: 5.0,
            every_s: f64::INFINITY,
            sigma_n: Vector3::zeros(),
        };
        assert_eq!(
            [once.due_s(4.0, 4.9), once.due_s(4.0, 5.0), once.due_s(5.0, 6.0)],
            [None, Some(5.0), None]
        );
    }
}
