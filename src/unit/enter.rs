//! The panel: what the crew and the aircraft do.

use super::{AlignmentKind, Mode, Power, State, StoredAlignment, Unit};
use crate::base::error::{Error, check_range};

const QUARTER: f64 = core::f64::consts::FRAC_PI_2;
const WHOLE: f64 = core::f64::consts::TAU;

impl Unit {
    /// Turns the mode selector. The unit follows with the next update.
    pub fn select(&mut self, mode: Mode) {
        self.selector = mode;
    }

    /// Sets the supply of power.
    pub fn set_power(&mut self, power: Power) {
        self.power = power;
    }

    /// Sets how the unit aligns. With another kind an alignment in progress begins anew; a realignment is the same with each kind.
    pub fn set_alignment(&mut self, kind: AlignmentKind) {
        let is_aligning = self.aligns() || self.state == State::Ready;
        if kind != self.kind && is_aligning && !self.realigned {
            self.start_anew();
            (self.motion, self.reasons.motion) = (Default::default(), false);
        }
        self.kind = kind;
    }

    /// Presses the test button: for the length of the power-up test the status says so.
    pub fn press_test(&mut self) {
        self.test_s = self.limits.power_up_test_s;
    }

    /// Enters the present position, of an alignment or a realignment. A position that is far from the stored one is refused, with a
    /// reason in the status, until it is entered again.
    pub fn enter_position(&mut self, latitude_rad: f64, longitude_rad: f64) -> Result<(), Error> {
        check_range("latitude_rad", latitude_rad, -QUARTER, QUARTER)?;
        check_range("longitude_rad", longitude_rad, -WHOLE, WHOLE)?;
        if !self.aligns() && self.state != State::Ready {
            return Err(Error::bad_state(match self.state {
                State::Off | State::PowerDown => {
                    "a position can be entered during an alignment; the unit is off"
                }
                State::Test => "a position can be entered during an alignment; the power-up test is not over",
                State::Navigation => "a position can be entered during an alignment; the unit navigates",
                State::Erection | State::Attitude => {
                    "a position can be entered during an alignment; the unit is in ATT"
                }
                _ => "a position can be entered during an alignment; the unit has failed",
            }));
        }
        let longitude_rad = crate::base::math::wrap_angle(longitude_rad);
        let position = (latitude_rad, longitude_rad);
        let tolerance = self.limits.position_tolerance_rad;
        let is_far = self.stored.is_some_and(|stored| {
            let east = crate::base::math::wrap_angle(longitude_rad - stored.longitude_rad);
            (latitude_rad - stored.latitude_rad).abs() > tolerance || east.abs() > tolerance
        });
        self.reasons.position_disagrees = is_far && self.refused != Some(position);
        if self.reasons.position_disagrees {
            self.refused = Some(position);
        } else {
            self.entered = Some(position);
        }
        Ok(())
    }

    /// Enters the heading of ATT.
    pub fn enter_heading(&mut self, heading_rad: f64) -> Result<(), Error> {
        check_range("heading_rad", heading_rad, -WHOLE, WHOLE)?;
        if self.state != State::Attitude {
            return Err(Error::bad_state(match self.state {
                State::Test => {
                    "a heading can be entered when the attitude of ATT is valid; the power-up test is not over"
                }
                State::Erection => {
                    "a heading can be entered when the attitude of ATT is valid; the erection is not over"
                }
                _ => "a heading can be entered when the attitude of ATT is valid",
            }));
        }
        self.turn_to(heading_rad);
        self.heading_entered = true;
        Ok(())
    }

    /// Sets what the unit stored at its last switching off; `None`: nothing.
    pub fn set_stored(&mut self, stored: Option<StoredAlignment>) -> Result<(), Error> {
        if let Some(stored) = &stored {
            stored.validate()?;
        }
        self.stored = stored;
        Ok(())
    }
}
