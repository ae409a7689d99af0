//! What an INS shows, how wrong it is, and why it does not show all.

use nalgebra::Vector3;
use sins::unit::{Reasons, Status, UnitNavigation};
use sins::{Error, Simulator};

use crate::units::{ANGLE, LENGTH, SPEED, brief, six_digits};

/// What an INS shows, and its error.
pub struct Shown {
    pub status: Status,
    pub navigation: UnitNavigation,
    /// Position error of the solution, east, north, up [m].
    pub position_error_n: Vector3<f64>,
}

/// A reason for outputs of the unit that are not valid, with its first and last time since the start of the flight [s].
#[derive(Debug, Clone, PartialEq)]
pub struct Reason {
    pub words: String,
    pub from_s: f64,
    pub until_s: f64,
}

impl Reason {
    pub fn text(&self) -> String {
        let [from, until] = [self.from_s, self.until_s].map(six_digits);
        format!("{} {from} s to {until} s", self.words)
    }
}

/// Notes the reasons that the unit has at `time_s`, after those that it had before.
pub fn note(reasons: &mut Vec<Reason>, now: &Reasons, time_s: f64) {
    if *now == Reasons::default() {
        return;
    }
    let words = now.words().replace(' ', ", ");
    match reasons.last_mut() {
        Some(last) if last.words == words => last.until_s = time_s,
        _ => reasons.push(Reason { words, from_s: time_s, until_s: time_s }),
    }
}

impl Shown {
    /// The valid outputs and the reasons of the others, and the errors of the valid ones, in words.
    pub fn at_end(&self, simulator: &Simulator) -> Result<String, Error> {
        let Self { status, navigation, position_error_n } = self;
        let valid = status.validity.words();
        let mut text = if valid.is_empty() { "nothing".to_owned() } else { valid.replace(' ', ", ") };
        let reasons = status.reasons.words();
        if !reasons.is_empty() {
            text += &format!(" ({})", reasons.replace(' ', ", "));
        }
        let Some(truth) = simulator.truth()?.map(|truth| truth.navigation) else { return Ok(text) };
        let (shown, true_one) = (&navigation.euler, &truth.euler);
        let turn = |angle_rad: f64| brief(angle_rad.sin().atan2(angle_rad.cos()).abs(), ANGLE);
        let tilt_rad = (shown.roll - true_one.roll).hypot(shown.pitch - true_one.pitch);
        let wrong: Vec<String> = [
            (status.validity.position, "position", brief(position_error_n.xy().norm(), LENGTH)),
            (status.validity.velocity, "velocity", brief((navigation.v_n - truth.v_n).norm(), SPEED)),
            (status.validity.attitude, "roll and pitch", turn(tilt_rad)),
            (status.validity.heading, "heading", turn(shown.heading - true_one.heading)),
        ]
        .into_iter()
        .filter(|(is_valid, ..)| *is_valid)
        .map(|(_, name, error)| format!("{name} {error}"))
        .collect();
        Ok(if wrong.is_empty() { text } else { format!("{text}; wrong by: {}", wrong.join(", ")) })
    }
}
