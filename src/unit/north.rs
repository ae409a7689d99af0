//! How accurately a gyrocompass finds north with the sensors that are set.

use super::alignment::{EarthAtRest, North};
use super::{State, Unit, UnitParameters};
use crate::base::math::rotate_inverse;
use crate::base::units::STANDARD_GRAVITY as GRAVITY;
use crate::earth::Geodetic;
use crate::errors::covariance::Signals;
use crate::simulator::{Bound, Simulator};
use crate::truth::TruthPoint;

/// Bounds of the errors of an alignment.
pub(super) struct SensorErrors {
    /// Of the mean rate of the gyros, and of the rate of the vertical that the accelerometers show \[rad/s\].
    pub gyros: Bound,
    pub vertical: Bound,
    /// Of the mean specific force \[m/s²\].
    force: Bound,
    /// Time between the first and the last window \[s\].
    apart_s: f64,
}

impl Unit {
    /// The Earth where the aircraft stands, at the latitude that is known.
    pub(super) fn at_rest_here(&self, simulator: &Simulator) -> Option<EarthAtRest> {
        let height_m = simulator.true_point().map_or(0.0, TruthPoint::height_m);
        let place = Geodetic { latitude_rad: self.latitude_rad()?, height_m, ..Geodetic::default() };
        Some(EarthAtRest::new(&simulator.options().earth(), &place))
    }

    /// The errors with which the sensors show the rotation of the Earth between both windows.
    pub(super) fn sensor_errors(
        &self,
        north: &North,
        at_rest: &EarthAtRest,
        simulator: &Simulator,
    ) -> Option<SensorErrors> {
        let (apart_s, window_s) = self.alignment.windows_s()?;
        let windows = (window_s.max(self.interval_s), apart_s);
        let q_ns = north.q_in.conjugate() * self.inertial.q_is;
        let earth_rate_n = at_rest.axis_n() * at_rest.rate_rad_s;
        let signals = Signals {
            rate_s: rotate_inverse(&q_ns, &earth_rate_n),
            force_s: rotate_inverse(&q_ns, &nalgebra::Vector3::z()) * GRAVITY,
        };
        let now_c = simulator.true_point().and_then(TruthPoint::temperature_c);
        let temperatures_c = [self.alignment.temperature_c.or(now_c), now_c];
        let before_s = self.age_s - self.alignment.elapsed_s + simulator.initial_errors().alignment_s;
        let before_s = before_s.max(0.0);
        let change = simulator.force_error_change(&signals, windows, temperatures_c);
        Some(SensorErrors {
            gyros: simulator.mean_rate_error(&signals, apart_s, temperatures_c, before_s),
            vertical: Bound { set: change.set / GRAVITY / apart_s, sigma: change.sigma / GRAVITY / apart_s },
            force: simulator.mean_force_error(&signals, apart_s, temperatures_c, before_s),
            apart_s,
        })
    }

    /// Standard deviation of the heading that a gyrocompass has found so far \[rad\]: an error e of the rate gives e/(Ω cos L), an error b
    /// of the vertical gyro b T/2, a force error B to the east B tan L/g. What is set counts with its size.
    pub(super) fn heading_sigma_rad(&self, simulator: &Simulator) -> Option<f64> {
        let at_rest = self.at_rest_here(simulator)?;
        let north = self.alignment.north(&at_rest)?;
        let errors = self.sensor_errors(&north, &at_rest, simulator)?;
        let EarthAtRest { rate_rad_s, sin, cos, .. } = at_rest;
        let of_east = errors.gyros.plus(&errors.vertical).times(1.0 / (rate_rad_s * cos));
        let of_turn = errors.gyros.times(0.5 * errors.apart_s);
        let of_tilt = errors.force.times(sin.abs() / (cos * GRAVITY));
        Some(of_east.plus(&of_turn).plus(&of_tilt).at(1.0).min(core::f64::consts::PI))
    }

    /// Notes the accuracy of a gyrocompass after a window, or when a latitude is new.
    pub(super) fn note_north(&mut self, is_new_window: bool, simulator: &Simulator) {
        let is_compass = !self.realigned && !self.is_made_up() && self.stored_heading_rad().is_none();
        let is_due = is_new_window || self.alignment.heading_sigma_rad.is_none();
        if is_compass && is_due && self.alignment.last.is_some() {
            self.alignment.heading_sigma_rad = self.heading_sigma_rad(simulator);
        }
    }

    /// Whether the heading of an alignment at rest is stored, or as accurate as `parameters` ask.
    pub(super) fn knows_north(&self, parameters: &UnitParameters) -> bool {
        self.stored_heading_rad().is_some()
            || self.alignment.heading_sigma_rad.is_some_and(|sigma| sigma <= parameters.heading_limit_rad)
    }

    /// Whether a gyrocompass goes on because its heading is not accurate enough.
    pub(super) fn lacks_north(&self) -> bool {
        let parameters = &self.limits;
        let is_over = self.alignment.elapsed_s >= self.length_s(parameters) - 0.5 * self.interval_s;
        self.state == State::FineAlignment
            && is_over
            && self.alignment.heading_sigma_rad.is_some_and(|sigma| sigma > parameters.heading_limit_rad)
    }
}
