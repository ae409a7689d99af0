//! The unit and its panel: `[unit]`, `[[panel]]`.

use super::super::key::{Key, Place, Section, Target, one};
use super::super::panel::{Action, PlannedAction};
use super::super::schedule::TIMES_S;
use super::sensors::of_rows;
use super::{choice, number, si, unit};
use crate::base::parameter::Shape;
use crate::base::units::DEG;
use crate::unit::{AlignmentKind, Mode, Power, UNIT};

const U: Section = Section::Unit;
const P: Section = Section::Panel;
const N: Shape = Shape::Number;

const STARTS: [(&str, Option<Mode>); 3] =
    [("none", None), ("off", Some(Mode::Off)), ("nav", Some(Mode::Navigate))];

/// The words of what is done at the panel.
const ACTIONS: [(&str, Action); 11] = {
    let ([off, align, nav, att], [aircraft, battery, none]) = (Mode::WORDS, Power::WORDS);
    [
        (off.0, Action::Select(off.1)),
        (align.0, Action::Select(align.1)),
        (nav.0, Action::Select(nav.1)),
        (att.0, Action::Select(att.1)),
        ("position", Action::Position),
        ("true_position", Action::TruePosition),
        ("heading", Action::Heading),
        (aircraft.0, Action::Power(aircraft.1)),
        (battery.0, Action::Power(battery.1)),
        (none.0, Action::Power(none.1)),
        ("test", Action::Test),
    ]
};

pub const START: &[Key] = &[
    choice!(U, "start", "mode selector at the start; nav: aligned already; none: the scene has no unit",
        "unit.start" => scene.unit.start, STARTS),
    choice!(U, "alignment", "kind of alignment; fast and instant: only a simulation has them; in_flight: on the updates of the velocity",
        "unit.alignment" => scene.unit.alignment, AlignmentKind::WORDS),
];

pub const UNIT_KEYS: &[Key] = &of_rows(U, &UNIT);

pub const PANEL: &[Key] = &[
    choice!(P, "kind", "what is done: the selector is turned, something is entered, the power changes", "panel.kind" => action.action, ACTIONS),
    number!(P, N, "at_s", si("s"), "its time, from the start of the flight", "panel.at_s" in TIMES_S => one(action.at_s)),
    number!(P, N, "latitude_deg", unit("deg", DEG, "rad"), "latitude that is entered", "panel.latitude_rad" in PlannedAction::LATITUDES_RAD => one(action.latitude_rad)),
    number!(P, N, "longitude_deg", unit("deg", DEG, "rad"), "longitude that is entered", "panel.longitude_rad" in PlannedAction::ANGLES_RAD => one(action.longitude_rad)),
    number!(P, N, "heading_deg", unit("deg", DEG, "rad"), "heading that is entered in ATT", "panel.heading_rad" in PlannedAction::ANGLES_RAD => one(action.heading_rad)),
];
