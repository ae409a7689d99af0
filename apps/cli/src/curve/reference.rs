//! The reference that solutions are compared with, and its uncertainty.

use nalgebra::Vector3;
use sins::Options;
use sins::analysis::recommend::{Reference, Refusal, SolutionError, Track};
use sins::earth::Earth;
use sins::earth::state::{BodyAxes, EarthFixedState, Navigation};
use sins::math::{Compensated, GAUSS_5, attitude_from_euler};
use sins::truth::FlightSample;
use sins::truth::flight::Flight;

use crate::failure::Failure;

/// Floor of the reported errors, as a multiple of the uncertainty of the reference. A smaller error is reported as the floor.
const MARGIN: f64 = 100.0;

/// Longest step of the quadrature that checks a flight [s]: at 4 Hz it is half a radian, which five nodes integrate to 1e-16.
const STEP_S: f64 = 0.02;

/// 2π over Schuler's period [rad/s]: ratio of the velocity error to the position error that causes it.
const SCHULER_RAD_S: f64 = 1.24e-3;

/// A reference solution.
pub struct Judge {
    track: Track,
    /// Possible errors of the reference itself.
    pub uncertainty: SolutionError,
    /// The kind of reference, and the source of its uncertainty.
    pub description: &'static str,
}

/// Errors of a solution, none below the floor of the reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Judgement {
    pub error: SolutionError,
    /// For position, velocity and attitude: whether the error is at the floor.
    pub at_floor: [bool; 3],
}

impl Judge {
    /// The reference is the flight itself. Velocity and attitude are closed forms of time. The position is an integral: its
    /// uncertainty is its difference from an independent quadrature of the velocity, plus the rounding of the coordinates.
    pub fn of_flight(
        earth: &Earth,
        flight: &Flight,
        samples: &[FlightSample],
        instants: &[usize],
    ) -> Result<Self, Failure> {
        let states: Vec<EarthFixedState> = instants.iter().map(|&k| state(earth, &samples[k])).collect();
        let mut moved = Compensated::new(Vector3::zeros());
        let (start, mut time_s) = (state(earth, &samples[0]), samples[0].time_s);
        let (mut inconsistency, mut speed): (f64, f64) = (0.0, 0.0);
        for (state, &instant) in states.iter().zip(instants) {
            let span = samples[instant].time_s - time_s;
            let steps = (span / STEP_S).ceil().max(1.0);
            let step = span / steps;
            for k in 0..steps as usize {
                for (node, weight) in GAUSS_5 {
                    let sample = flight.sample_at(time_s + (k as f64 + node) * step)?;
                    moved.add(&(velocity(earth, &sample) * (weight * step)));
                }
            }
            time_s = samples[instant].time_s;
            inconsistency = inconsistency.max(moved.minus(&(state.r_e - start.r_e)).norm());
            speed = speed.max(state.v_e.norm());
        }
        let uncertainty = of_inconsistency(inconsistency, earth.equatorial_radius_m, speed);
        let description = "the flight in closed form; uncertainty: its position against a quadrature of its velocity, and rounding";
        Ok(Self { track: Track { states }, uncertainty, description })
    }

    /// The reference is the finest solution that the samples of a log allow. The motion between the samples is unknown.
    pub fn of_log(options: &Options, samples: &[FlightSample], instants: &[usize]) -> Result<Self, Refusal> {
        let Reference { track, uncertainty } = Reference::new(&(*options).into(), samples, instants)?;
        let uncertainty = uncertainty.max(&of_inconsistency(0.0, options.earth().equatorial_radius_m, 0.0));
        let description = "polynomials through 5 subsamples, 16 updates a sample of the log; uncertainty: against 8 updates";
        Ok(Self { track, uncertainty, description })
    }

    /// The smallest errors that are reported.
    pub fn floor(&self) -> SolutionError {
        self.uncertainty.times(MARGIN)
    }

    /// The errors of `track`.
    pub fn judge(&self, track: &Track) -> Judgement {
        clamped(&track.minus(&self.track), &self.floor())
    }
}

impl Judgement {
    /// The larger errors of two; at the floor is what both have there.
    pub fn worse(&self, other: &Self) -> Self {
        let at_floor = [0, 1, 2].map(|part| self.at_floor[part] && other.at_floor[part]);
        Self { error: self.error.max(&other.error), at_floor }
    }
}

/// `error`, but no smaller than `floor`.
fn clamped(error: &SolutionError, floor: &SolutionError) -> Judgement {
    let (parts, floors) = (error.parts(), floor.parts());
    Judgement { error: error.max(floor), at_floor: [0, 1, 2].map(|part| parts[part] < floors[part]) }
}

/// Uncertainty from an inconsistency of the position and from rounding: of coordinates of the size `radius` [m], of velocities of
/// the size `speed` [m/s] and of attitudes. Products of sines and cosines are rounded by four units in the last place.
fn of_inconsistency(inconsistency_m: f64, radius: f64, speed: f64) -> SolutionError {
    let position_m = inconsistency_m + f64::EPSILON * radius;
    SolutionError {
        position_m,
        velocity_m_s: SCHULER_RAD_S * position_m + 4.0 * f64::EPSILON * speed,
        attitude_rad: 4.0 * f64::EPSILON,
    }
}

fn state(earth: &Earth, sample: &FlightSample) -> EarthFixedState {
    let v_n = sample.v_n.unwrap_or_default();
    Navigation::new(sample.place, v_n, attitude_from_euler(&sample.euler), BodyAxes::default())
        .earth_fixed(earth)
}

fn velocity(earth: &Earth, sample: &FlightSample) -> Vector3<f64> {
    let (east, north, up) = earth.east_north_up(&sample.place);
    let v_n = sample.v_n.unwrap_or_default();
    east * v_n.x + north * v_n.y + up * v_n.z
}

#[cfg(test)]
mod tests {
    use super::*;
    use sins::truth::flight::{FlightStart, Manoeuvre};

    #[test]
    fn nothing_below_the_floor_is_claimed() {
        let floor = SolutionError { position_m: 1e-6, velocity_m_s: 1e-9, attitude_rad: 1e-13 };
        let error = SolutionError { position_m: 1e-7, velocity_m_s: 2e-9, attitude_rad: 0.0 };
        let Judgement { error, at_floor } = clamped(&error, &floor);
        assert_eq!((error.position_m, error.velocity_m_s, error.attitude_rad), (1e-6, 2e-9, 1e-13));
        assert_eq!(at_floor, [true, false, true]);
    }

    /// The position of a loop is the integral of its velocity except for rounding. The samples of another flight contradict the
    /// integral.
    #[test]
    fn a_flight_that_contradicts_itself_is_found() {
        let start = FlightStart { speed_m_s: 150.0, height_m: 1e3, latitude_rad: 0.8, ..Default::default() };
        let flight = |duration_s| {
            Flight::new(&start, &[Manoeuvre::Loop { duration_s, turns: 1.0, ramp_s: 4.0 }]).unwrap()
        };
        let (flown, other) = (flight(30.0), flight(30.01));
        let samples: Vec<_> = (0..=30).map(|k| flown.sample_at(f64::from(k)).unwrap()).collect();
        let judge = |flight| Judge::of_flight(&Earth::default(), flight, &samples, &[10, 20, 30]).unwrap();
        let own = judge(&flown).uncertainty.position_m;
        assert!(own < 20.0 * f64::EPSILON * 6.4e6, "{own:e}");
        assert!(judge(&other).uncertainty.position_m > 1e-3);
    }
}
