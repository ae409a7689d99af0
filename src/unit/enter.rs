//! The panel: what the crew and the aircraft do.

use nalgebra::Vector3;

use super::{AlignmentKind, Mode, Power, State, StoredAlignment, Unit, UnitParameters};
use crate::base::error::{Error, check_range};
use crate::base::snapshot::{SIGNALS, stored};

const QUARTER: f64 = core::f64::consts::FRAC_PI_2;
const WHOLE: f64 = core::f64::consts::TAU;

/// Largest distance from where it was entered at which a position holds, if motion_distance_m is larger \[m\].
const ENTRY_HOLDS_M: f64 = 10.0;

/// A position that was entered.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Entry {
    pub latitude_rad: f64,
    pub longitude_rad: f64,
    /// Where the aircraft stood then, Earth-fixed axes \[m\].
    place_e: Option<Vector3<f64>>,
}

stored!(Entry { latitude_rad: 1.6, longitude_rad: 3.2, place_e: SIGNALS });

impl Unit {
    /// Turns the mode selector. The unit follows with the next update.
    pub fn select(&mut self, mode: Mode) {
        self.selector = mode;
    }

    /// Sets the supply of power.
    pub fn set_power(&mut self, power: Power) {
        self.power = power;
    }

    /// Sets how the unit aligns. With another kind an alignment in progress begins anew, and a unit that is ready aligns again. A
    /// realignment is the same with each kind.
    pub fn set_alignment(&mut self, kind: AlignmentKind) {
        let begins_anew = self.state == State::Ready || self.aligns() && !self.realigned;
        if kind != self.kind && begins_anew {
            self.realigned = false;
            self.start_anew();
            (self.motion, self.reasons.motion) = (Default::default(), false);
        }
        self.kind = kind;
    }

    /// Presses the test button: for the length of the power-up test the status says so.
    pub fn press_test(&mut self) {
        self.test_s = self.limits.power_up_test_s;
    }

    /// Enters the present position, of an alignment or a realignment. It holds as long as the aircraft stands where it was entered. A
    /// position that is far from the stored one is refused, with a reason in the status, until it is entered again there.
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
        let entry = Entry { latitude_rad, longitude_rad, place_e: self.place_e };
        let tolerance = self.limits.position_tolerance_rad;
        let is_far = self.stored.is_some_and(|stored| {
            let east = crate::base::math::wrap_angle(longitude_rad - stored.longitude_rad);
            (latitude_rad - stored.latitude_rad).abs() > tolerance || east.abs() > tolerance
        });
        let is_refused =
            |refused: Entry| (refused.latitude_rad, refused.longitude_rad) == (latitude_rad, longitude_rad);
        if is_far && !self.refused.is_some_and(is_refused) {
            self.refused = Some(entry);
        } else {
            (self.entered, self.refused) = (Some(entry), None);
            // These are of the position before.
            (self.reasons.latitude_disagrees, self.reasons.latitude_too_high) = (false, false);
            self.alignment.heading_sigma_rad = None;
        }
        Ok(())
    }

    /// Drops the positions that were entered.
    pub(super) fn forget_entries(&mut self) {
        (self.entered, self.refused) = (None, None);
    }

    /// The aircraft is at `place_e`: drops what does not hold there, the positions that were entered at another place, and the place where
    /// the unit was switched on.
    pub(super) fn stand_at(&mut self, place_e: Option<Vector3<f64>>, parameters: &UnitParameters) {
        let is_within = |then: Option<Vector3<f64>>, farthest: f64| {
            then.zip(place_e).is_some_and(|(then, now)| (now - then).norm_squared() <= farthest * farthest)
        };
        let farthest = parameters.motion_distance_m;
        let holds = |entry: &Entry| is_within(entry.place_e, farthest.min(ENTRY_HOLDS_M));
        self.switched_on_e = self.switched_on_e.filter(|then| is_within(Some(*then), farthest));
        self.entered = self.entered.filter(holds);
        self.refused = self.refused.filter(holds);
        self.place_e = place_e;
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
