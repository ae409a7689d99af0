//! The end of an alignment, and the attitude of ATT.

use nalgebra::{Quaternion, Vector3};

use super::alignment::{North, shortest_rotation};
use super::states::{correct, remove_errors};
use super::{AlignmentKind, Mode, State, Unit, UnitParameters};
use crate::earth::{Earth, Geodetic};
use crate::error::Error;
use crate::errors::navigation_minus_truth;
use crate::math::{rotate, rotate_inverse, rotation_quaternion, sin_cos};
use crate::sensors::TriadParameters;
use crate::simulator::Simulator;
use crate::state::Navigation;

/// Failed tests of the latitude after which the unit fails.
const LATITUDE_FAILURES: usize = 2;
/// Tolerance of the cosine of latitude beside that of the gyros, and that of the sine: the aircraft may turn a little.
const COSINE_TOLERANCE: f64 = 0.004;
const SINE_TOLERANCE: f64 = 0.2;
/// Standard deviations of the gyros that the test of the latitude allows.
const SIGMAS: f64 = 5.0;

impl Unit {
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
            if self.entered.is_some() {
                let Some(present) = simulator.navigation()? else { return Ok(()) };
                let Navigation { v_n, q_nb, .. } = present.navigation;
                let place = self.entered_place(&present.navigation, simulator);
                self.settle(&earth, place, v_n, q_nb, simulator)?;
            }
            self.become_ready();
            return Ok(());
        }
        self.reasons.no_position = self.entered.is_none();
        let Some((latitude_rad, _)) = self.entered else { return Ok(()) };
        self.reasons.latitude_too_high = latitude_rad.abs() > parameters.max_latitude_rad;
        if self.reasons.latitude_too_high {
            return Ok(());
        }
        let q_is = self.inertial.q_is;
        let q_bs = self.q_bs;
        let from_stored = self.kind == AlignmentKind::StoredHeading && self.stored.is_some();
        let q_nb = if let (true, Some(stored), Some(fix)) =
            (from_stored, self.stored, self.alignment.newest())
        {
            let level = shortest_rotation(&Vector3::z(), &fix.up_i).conjugate() * q_is * q_bs.conjugate();
            let level =
                Navigation::new(Geodetic::default(), Vector3::zeros(), level, simulator.options().axes);
            about_up(level.euler.heading - stored.heading_rad) * level.q_nb
        } else {
            let Some(north) = self.alignment.north(latitude_rad, earth.rate_rad_s) else { return Ok(()) };
            if !self.latitude_passes(&north, latitude_rad, earth.rate_rad_s, parameters, simulator.gyro()) {
                return Ok(());
            }
            north.q_in.conjugate() * q_is * q_bs.conjugate()
        };
        let Some(present) = simulator.navigation()? else { return Ok(()) };
        let place = self.entered_place(&present.navigation, simulator);
        self.settle(&earth, place, Vector3::zeros(), q_nb, simulator)?;
        self.become_ready();
        Ok(())
    }

    pub(super) fn become_ready(&mut self) {
        if self.state != State::Ready {
            self.enter(State::Ready);
        }
        if self.selector == Mode::Navigate {
            self.enter(State::Navigation);
        }
    }

    /// Compares the latitude of the gyros with the entered one. After two failures the unit fails.
    fn latitude_passes(
        &mut self,
        north: &North,
        latitude_rad: f64,
        earth_rate: f64,
        parameters: &UnitParameters,
        gyro: &TriadParameters,
    ) -> bool {
        let (sin, cos) = sin_cos(latitude_rad);
        let cos_found = north.horizontal_rad_s / earth_rate;
        self.found_latitude_rad =
            Some(crate::math::atan2((1.0 - cos_found * cos_found).max(0.0).sqrt(), cos_found));
        let (of_cos, of_sin) = if parameters.latitude_tolerance_rad != 0.0 {
            (parameters.latitude_tolerance_rad * sin.abs() + COSINE_TOLERANCE, SINE_TOLERANCE)
        } else {
            let by_gyros = gyro_rate_error(gyro, self.alignment.elapsed_s, SIGMAS) / earth_rate;
            (by_gyros + COSINE_TOLERANCE, by_gyros + SINE_TOLERANCE)
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
        let (Some(fix), Some(solution)) = (self.alignment.newest(), simulator.navigation()?) else {
            return Ok(());
        };
        let earth = simulator.options().earth();
        let (q_is, q_bs) = (self.inertial.q_is, self.q_bs);
        let navigation = &solution.navigation;
        let q_in = q_is * (navigation.q_nb * q_bs).conjugate();
        let (_, cos) = sin_cos(navigation.place.latitude_rad);
        let turned = earth.rate_rad_s * cos * (self.alignment.elapsed_s - fix.time_s);
        let up_i = fix.up_i + rotate(&q_in, &Vector3::x()) * turned;
        let up_i = up_i / up_i.norm_squared().sqrt();
        let q_in = shortest_rotation(&rotate(&q_in, &Vector3::z()), &up_i) * q_in;
        let q_nb = q_in.conjugate() * q_is * q_bs.conjugate();
        let place = self.entered_place(&solution.navigation, simulator);
        self.settle(&earth, place, Vector3::zeros(), q_nb, simulator)?;
        self.become_ready();
        Ok(())
    }

    /// The entered place, with the true height. Without an entered position it is that of `present`.
    fn entered_place(&self, present: &Navigation, simulator: &Simulator) -> Geodetic {
        let mut place = present.place;
        if let Some((latitude_rad, longitude_rad)) = self.entered {
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
            let is_complete =
                self.alignment.advance(velocity_i, &self.inertial.q_is, dt, parameters.erection_s);
            if let (true, Some(fix)) = (is_complete, self.alignment.newest()) {
                self.q_il = shortest_rotation(&Vector3::z(), &fix.up_i);
                self.turn_to(0.0);
                self.enter(State::Attitude);
            }
            return;
        }
        let felt_l = rotate_inverse(&self.q_il, velocity_i);
        let size = felt_l.norm_squared().sqrt();
        if size > 0.0 {
            let share = (dt / parameters.erection_time_s).min(1.0);
            self.q_il *= rotation_quaternion(&(Vector3::z().cross(&felt_l) * (share / size)));
            self.q_il /= self.q_il.norm_squared().sqrt();
        }
    }

    /// The attitude of ATT, with level axes in place of east-north-up.
    pub(super) fn attitude(&self) -> Quaternion<f64> {
        self.q_il.conjugate() * self.inertial.q_is * self.q_bs.conjugate()
    }

    /// Turns the level axes of ATT so that the heading is `heading_rad`.
    pub(super) fn turn_to(&mut self, heading_rad: f64) {
        let present = Navigation::new(Geodetic::default(), Vector3::zeros(), self.attitude(), self.axes);
        let turn = about_up(present.euler.heading - heading_rad);
        self.q_il *= turn.conjugate();
    }
}

/// Rotation about up.
fn about_up(angle: f64) -> Quaternion<f64> {
    rotation_quaternion(&(Vector3::z() * angle))
}

/// Bound of the error of a mean gyro rate over `t` \[s\]: what is set, and `sigmas` standard deviations of what is drawn \[rad/s\].
pub(super) fn gyro_rate_error(gyro: &TriadParameters, t: f64, sigmas: f64) -> f64 {
    let largest = |axes: &Vector3<f64>| axes.amax();
    let walk = largest(&gyro.random_walk);
    let sigma = largest(&gyro.bias_sigma);
    let markov = largest(&gyro.markov_sigma);
    let variance = walk * walk / t + sigma * sigma + markov * markov;
    largest(&gyro.bias) + sigmas * variance.sqrt()
}
