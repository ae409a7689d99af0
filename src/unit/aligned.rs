//! The end of an alignment, and the attitude of ATT.

use nalgebra::{Quaternion, Vector3};

use super::alignment::{EarthAtRest, North, shortest_rotation};
use super::enter::Entry;
use super::states::{correct, remove_errors};
use super::{AlignmentKind, Mode, State, Unit, UnitParameters};
use crate::base::error::Error;
use crate::base::math::{rotate_inverse, rotation_quaternion};
use crate::earth::state::Navigation;
use crate::earth::{Earth, Geodetic};
use crate::errors::navigation_minus_truth;
use crate::simulator::Simulator;

/// Failed tests of the latitude after which the unit fails.
const LATITUDE_FAILURES: usize = 2;
/// Tolerance of the cosine of latitude beside that of the gyros, and that of the sine: the aircraft may turn a little.
const COSINE_TOLERANCE: f64 = 0.004;
const SINE_TOLERANCE: f64 = 0.2;
/// Standard deviations of the sensors that the test of the latitude and the vertical channel allow.
const SIGMAS: f64 = 5.0;

impl Unit {
    /// A unit that is no longer ready aligns on.
    fn align_on(&mut self) {
        if self.state == State::Ready {
            self.enter(State::FineAlignment);
        }
    }

    /// Ends the alignment if the position is known and the tests are passed.
    pub(super) fn finish(
        &mut self,
        parameters: &UnitParameters,
        simulator: &mut Simulator,
    ) -> Result<(), Error> {
        if self.realigned {
            return self.level_again(simulator);
        }
        let earth = simulator.options().earth();
        if self.is_made_up() {
            remove_errors(simulator, &simulator.initial_errors().draw(simulator.options().key))?;
            self.become_ready(simulator);
            return Ok(());
        }
        self.reasons.no_position = self.entered.is_none();
        let Some(Entry { latitude_rad, .. }) = self.entered else {
            self.align_on();
            return Ok(());
        };
        self.reasons.latitude_too_high = latitude_rad.abs() > parameters.max_latitude_rad;
        if self.reasons.latitude_too_high {
            return Ok(());
        }
        let Some(present) = simulator.navigation()? else { return Ok(()) };
        let place = self.entered_place(&present.navigation, simulator);
        let at_rest = EarthAtRest::new(&earth, &place);
        if self.stored_heading_rad().is_none() {
            let Some(north) = self.alignment.north(&at_rest) else { return Ok(()) };
            if !self.latitude_passes(&north, &at_rest, parameters, simulator) {
                return Ok(());
            }
            if !self.knows_north(parameters) {
                self.align_on();
                return Ok(());
            }
        }
        let Some(q_nb) = self.found_attitude(&at_rest) else { return Ok(()) };
        self.settle(&earth, place, Vector3::zeros(), q_nb, simulator)?;
        self.become_ready(simulator);
        Ok(())
    }

    /// The solution is the aligned one, and goes on from here.
    pub(super) fn become_ready(&mut self, simulator: &mut Simulator) {
        simulator.limit_vertical_bias(SIGMAS, self.age_s + simulator.initial_errors().alignment_s);
        if self.state != State::Ready {
            self.enter(State::Ready);
        }
        if self.selector == Mode::Navigate {
            self.enter(State::Navigation);
        }
    }

    /// The heading that the alignment in progress takes from what is stored.
    pub(super) fn stored_heading_rad(&self) -> Option<f64> {
        let is_used = self.kind == AlignmentKind::StoredHeading && self.switched_on_e.is_some();
        self.stored.filter(|_| is_used).map(|stored| stored.heading_rad)
    }

    /// The attitude that an alignment at rest on `at_rest` has found so far, with its heading.
    pub(super) fn found_attitude(&self, at_rest: &EarthAtRest) -> Option<Quaternion<f64>> {
        match self.stored_heading_rad() {
            Some(heading_rad) => self.with_heading(heading_rad, at_rest),
            None => self.alignment.north(at_rest).map(|north| self.attitude_in(&north.q_in)),
        }
    }

    /// The attitude in axes that `q_in` rotates to the inertial axes of the gyros.
    pub(super) fn attitude_in(&self, q_in: &Quaternion<f64>) -> Quaternion<f64> {
        q_in.conjugate() * self.inertial.q_is * self.q_bs.conjugate()
    }

    /// The attitude with the measured vertical, and with this heading when the gyros began to keep their axes. The vertical that was
    /// measured depends on the heading, as the Earth has turned since then.
    fn with_heading(&self, heading_rad: f64, at_rest: &EarthAtRest) -> Option<Quaternion<f64>> {
        const MOST: usize = 40;
        let since = at_rest.over(self.inertial.kept_s);
        let mut q_in = shortest_rotation(&Vector3::z(), &self.alignment.newest()?.up_i);
        for _ in 0..MOST {
            let q_in_then = q_in * since.conjugate();
            let turn = self.turn_about_up(&(q_in_then.conjugate() * self.q_bs.conjugate()), heading_rad);
            q_in = self.alignment.levelled(&(q_in_then * turn.conjugate() * since), at_rest)?;
            if turn.imag().norm_squared() < 1e-32 {
                break;
            }
        }
        Some(self.attitude_in(&q_in))
    }

    /// Compares the latitude of the gyros with the entered one. After two failures the unit fails.
    fn latitude_passes(
        &mut self,
        north: &North,
        at_rest: &EarthAtRest,
        parameters: &UnitParameters,
        simulator: &Simulator,
    ) -> bool {
        let EarthAtRest { rate_rad_s: earth_rate, sin, cos, .. } = *at_rest;
        let cos_found = north.horizontal_rad_s / earth_rate;
        self.found_latitude_rad =
            Some(crate::base::math::atan2((1.0 - cos_found * cos_found).max(0.0).sqrt(), cos_found));
        let (of_cos, of_sin) = if parameters.latitude_tolerance_rad != 0.0 {
            (parameters.latitude_tolerance_rad * sin.abs() + COSINE_TOLERANCE, SINE_TOLERANCE)
        } else {
            let Some(errors) = self.sensor_errors(north, at_rest, simulator) else { return true };
            let of_vertical = errors.gyros.plus(&errors.vertical).at(SIGMAS);
            let of_gyros = errors.gyros.at(SIGMAS);
            (of_vertical / earth_rate + COSINE_TOLERANCE, of_gyros / earth_rate + SINE_TOLERANCE)
        };
        let passes =
            (cos_found - cos).abs() <= of_cos && (north.vertical_excess_rad_s / earth_rate).abs() <= of_sin;
        self.reasons.latitude_disagrees = !passes;
        if !passes {
            self.latitude_failures += 1;
            self.entered = None;
            if self.latitude_failures >= LATITUDE_FAILURES {
                self.enter(State::Fault);
            }
        }
        passes
    }

    /// Levels the solution and removes its velocity; its heading stays.
    fn level_again(&mut self, simulator: &mut Simulator) -> Result<(), Error> {
        let Some(solution) = simulator.navigation()? else { return Ok(()) };
        let earth = simulator.options().earth();
        let navigation = &solution.navigation;
        let q_in = self.inertial.q_is * (navigation.q_nb * self.q_bs).conjugate();
        let place = self.entered_place(navigation, simulator);
        let at_rest = EarthAtRest::new(&earth, &place);
        let Some(q_in) = self.alignment.levelled(&q_in, &at_rest) else { return Ok(()) };
        let q_nb = self.attitude_in(&q_in);
        self.settle(&earth, place, Vector3::zeros(), q_nb, simulator)?;
        self.become_ready(simulator);
        Ok(())
    }

    /// The entered place, with the true height. Without an entered position it is that of `present`.
    fn entered_place(&self, present: &Navigation, simulator: &Simulator) -> Geodetic {
        let mut place = present.place;
        if let Some(Entry { latitude_rad, longitude_rad, .. }) = self.entered {
            place = Geodetic { latitude_rad, longitude_rad, ..place };
        }
        if let Ok(Some(truth)) = simulator.truth() {
            place.height_m = truth.navigation.place.height_m;
        }
        place
    }

    /// Makes a state the solution of the simulator.
    pub(super) fn settle(
        &self,
        earth: &Earth,
        place: Geodetic,
        v_n: Vector3<f64>,
        q_nb: Quaternion<f64>,
        simulator: &mut Simulator,
    ) -> Result<(), Error> {
        let Some(present) = simulator.navigation()? else { return Ok(()) };
        let q_nb = q_nb / q_nb.norm_squared().sqrt();
        let wanted = Navigation::new(place, v_n, q_nb, simulator.options().axes);
        correct(simulator, &navigation_minus_truth(earth, &present.navigation, &wanted))
    }

    /// Reads how the unit believes itself mounted.
    pub(super) fn look_at(&mut self, simulator: &Simulator) {
        self.axes = simulator.options().axes;
        self.q_bs = simulator.mounting().believed_placement(self.axes).q_bs;
    }

    /// ATT: the first level after the erection, then a slow erection to the apparent vertical.
    pub(super) fn erect(&mut self, velocity_i: &Vector3<f64>, dt: f64, parameters: &UnitParameters) {
        if self.state == State::Erection {
            let of_aircraft = Vector3::zeros(); // It is not at rest.
            let q_is = &self.inertial.q_is;
            let is_shown = self.alignment.advance(velocity_i, q_is, &of_aircraft, dt, parameters.erection_s);
            if let (Some(true), Some(fix)) = (is_shown, self.alignment.newest()) {
                self.q_il = shortest_rotation(&Vector3::z(), &fix.up_i);
                self.turn_to(0.0);
                self.enter(State::Attitude);
            }
            return;
        }
        let felt_l = rotate_inverse(&self.q_il, velocity_i);
        let size = felt_l.norm_squared().sqrt();
        // A lost accelerometer shows another vertical, at the full rate.
        if size > 0.0 && self.has_signal {
            let share = (dt / parameters.erection_time_s).min(1.0);
            self.q_il *= rotation_quaternion(&(Vector3::z().cross(&felt_l) * (share / size)));
            self.q_il /= self.q_il.norm_squared().sqrt();
        }
    }

    /// The attitude of ATT, with level axes in place of east-north-up.
    pub(super) fn attitude(&self) -> Quaternion<f64> {
        self.attitude_in(&self.q_il)
    }

    /// Turns the level axes of ATT so that the heading is `heading_rad`.
    pub(super) fn turn_to(&mut self, heading_rad: f64) {
        self.q_il *= self.turn_about_up(&self.attitude(), heading_rad).conjugate();
    }

    /// The rotation about up after which the attitude `q_nb` has the heading `heading_rad`.
    fn turn_about_up(&self, q_nb: &Quaternion<f64>, heading_rad: f64) -> Quaternion<f64> {
        let present = Navigation::new(Geodetic::default(), Vector3::zeros(), *q_nb, self.axes);
        rotation_quaternion(&(Vector3::z() * (present.euler.heading - heading_rad)))
    }
}
