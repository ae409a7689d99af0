//! What the unit shows: status and navigation.

use nalgebra::{Quaternion, Vector3};

use super::alignment::shortest_rotation;
use super::{AlignmentKind, Mode, Power, Reasons, State, Status, Unit, Validity};
use crate::base::error::Error;
use crate::base::math::{Euler, rotate};
use crate::earth::Geodetic;
use crate::earth::state::Navigation;
use crate::simulator::Simulator;

/// What the unit shows. What is not valid is 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct UnitNavigation {
    /// Time of the last update \[s\]; 0 before the first.
    pub time_s: f64,
    /// Which of the following is valid.
    pub validity: Validity,
    /// Latitude, longitude, height.
    pub place: Geodetic,
    /// Velocity, east-north-up \[m/s\].
    pub v_n: Vector3<f64>,
    /// Roll, pitch, true heading; in ATT the heading is the entered one, carried on by the gyros.
    pub euler: Euler,
    /// Measured angular rate relative to inertial space, axes of the vehicle \[rad/s\].
    pub rate_b: Vector3<f64>,
    /// Measured specific force, axes of the vehicle \[m/s²\].
    pub force_b: Vector3<f64>,
}

impl Unit {
    /// What the unit reports of itself.
    pub fn status(&self) -> Status {
        let parameters = self.limits;
        let aligns = self.aligns();
        let whole_s = self.length_s(&parameters);
        let elapsed_s = self.alignment.elapsed_s;
        let has_position = match self.kind {
            AlignmentKind::InFlight => self.alignment.in_flight.has_fix(),
            _ => self.entered.is_some() || self.is_made_up(),
        };
        let lacks_position = aligns && !has_position && !self.realigned;
        let reasons = Reasons {
            no_position: lacks_position,
            position_disagrees: self.refused.is_some(),
            turns_needed: self.needs_turns(),
            north_unknown: self.reasons.north_unknown || self.lacks_north(),
            ..self.reasons
        };
        let waits = lacks_position && elapsed_s >= whole_s
            || reasons.position_disagrees
            || reasons.latitude_disagrees
            || reasons.latitude_too_high
            || reasons.motion
            || reasons.turns_needed
            || reasons.north_unknown;
        let to_go_s = match self.state {
            State::Test => {
                parameters.power_up_test_s - self.state_s
                    + if self.selector == Mode::Attitude { parameters.erection_s } else { whole_s }
            }
            State::CoarseAlignment | State::FineAlignment | State::Realignment => whole_s - elapsed_s,
            State::Erection => parameters.erection_s - elapsed_s,
            _ => 0.0,
        };
        Status {
            state: self.state,
            selector: self.selector,
            align: aligns,
            align_flashes: aligns && waits,
            navigation_ready: self.state == State::Ready,
            fault: self.state == State::Fault,
            on_battery: self.power == Power::Battery && self.state != State::Off,
            in_test: self.test_s > 0.0 || self.state == State::Test,
            reasons,
            validity: self.validity(),
            to_go_s: to_go_s.max(0.0),
            in_navigation_s: self.in_navigation_s,
            found_latitude_rad: self.found_latitude_rad,
            stored: self.stored,
        }
    }

    /// Which outputs are valid.
    fn validity(&self) -> Validity {
        let rates = Validity { rates: self.has_signal, ..Validity::default() };
        let attitude = Validity { attitude: true, ..rates };
        match self.state {
            State::Off | State::Test | State::Fault | State::PowerDown => Validity::default(),
            State::CoarseAlignment | State::Erection => rates,
            State::FineAlignment => {
                Validity { attitude: self.shows_attitude(), heading: self.shows_heading(), ..rates }
            }
            _ if self.reasons.north_unknown => attitude,
            State::Ready | State::Realignment => {
                Validity { heading: true, position: true, velocity: self.aligns_in_flight(), ..attitude }
            }
            State::Navigation => Validity { heading: true, position: true, velocity: true, ..attitude },
            State::Attitude => Validity { heading: self.heading_entered, ..attitude },
        }
    }

    /// In flight, fixes whose velocity does not change show one direction at most. An alignment that only a simulation can make may be in
    /// motion, where the measured increments show no vertical.
    fn shows_attitude(&self) -> bool {
        !self.is_made_up() && (!self.aligns_in_flight() || self.alignment.in_flight.has_attitude())
    }

    /// In an alignment at rest the heading is shown from its half on, if it is accurate enough; in flight as soon as it is.
    fn shows_heading(&self) -> bool {
        let parameters = self.limits;
        if self.aligns_in_flight() {
            return self.alignment.in_flight.has_heading(&parameters);
        }
        !self.is_made_up()
            && self.alignment.last.is_some()
            && self.latitude_rad().is_some()
            && self.knows_north(&parameters)
            && self.alignment.elapsed_s >= 0.5 * self.length_s(&parameters)
    }

    /// What the unit shows after its last update. `simulator` is that of the update.
    pub fn navigation(&self, simulator: &Simulator) -> Result<UnitNavigation, Error> {
        let validity = self.validity();
        let mut shown =
            UnitNavigation { time_s: self.time_s.unwrap_or(0.0), validity, ..UnitNavigation::default() };
        if validity.rates {
            shown.rate_b = rotate(&self.q_bs, &(self.measured.angle / self.interval_s));
            shown.force_b = rotate(&self.q_bs, &(self.measured.velocity / self.interval_s));
        }
        if validity.attitude {
            let solution = if self.shows_solution() { simulator.navigation()? } else { None };
            let navigation = match solution {
                Some(solution) => solution.navigation,
                None => Navigation::new(
                    Geodetic::default(),
                    Vector3::zeros(),
                    self.own_attitude(simulator),
                    self.axes,
                ),
            };
            shown.euler = navigation.euler;
            if !validity.heading {
                shown.euler.heading = 0.0;
            }
            if validity.position {
                shown.place = navigation.place;
            }
            if validity.velocity {
                shown.v_n = navigation.v_n;
            } else {
                shown.place.height_m = 0.0;
            }
        }
        Ok(shown)
    }

    /// The attitude that the unit finds itself: in ATT, and in an alignment.
    fn own_attitude(&self, simulator: &Simulator) -> Quaternion<f64> {
        if self.state == State::Attitude {
            return self.attitude();
        }
        let earth = simulator.options().earth();
        if let Some(q_in) = self.alignment.in_flight.q_in(&earth) {
            return self.attitude_in(&q_in);
        }
        let found = self.at_rest_here(simulator).and_then(|at_rest| self.found_attitude(&at_rest));
        found.unwrap_or_else(|| {
            let up_i = self.alignment.up_i().unwrap_or(Vector3::z());
            self.attitude_in(&shortest_rotation(&Vector3::z(), &up_i))
        })
    }
}
