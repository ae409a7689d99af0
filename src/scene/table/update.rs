//! Planned updates: `[[update]]`.

use super::super::key::{Key, Place, Section, Target, one, vector};
use super::super::{PlannedUpdate, Updated};
use super::{choice, number, si};
use crate::base::parameter::Shape;

const U: Section = Section::Update;

pub const UPDATE: &[Key] = &[
    choice!(U, "kind", "what the fix gives", "update.kind" => update.updated, Updated::WORDS),
    number!(U, Shape::Number, "at_s", si("s"), "time of the update, from the start of the flight", "update.at_s" in PlannedUpdate::TIMES_S => one(update.at_s)),
    number!(U, Shape::Number, "every_s", si("s"), "time from one update to the next; default: only one",
        "update.every_s" in PlannedUpdate::TIMES_S => one(update.every_s)),
    number!(U, Shape::Axes, "sigma_m", si("m"), "standard deviation of the error of a position fix, east-north-up",
        "update.sigma_m" in PlannedUpdate::SIGMAS_M => vector(update.sigma_n)),
    number!(U, Shape::Axes, "sigma_m_s", si("m/s"), "standard deviation of the error of a velocity fix, east-north-up",
        "update.sigma_m_s" in PlannedUpdate::SIGMAS_M_S => vector(update.sigma_n)),
];
