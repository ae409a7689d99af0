//! The true motion: `[flight]`, `[[manoeuvre]]`, `[[manoeuvre.sinusoid]]`.

use super::super::key::{Key, Place, Section, Target, one};
use super::sensors::of_rows;
use super::{PURE, choice, count, number, si, text, unit, word};
use crate::base::parameter::Shape;
use crate::base::units::DEG;
use crate::truth::flight::{self, Channel, MAX_MANOEUVRES, Manoeuvre, ManoeuvreFields, Sinusoid};

const F: Section = Section::Flight;
const M: Section = Section::Manoeuvre;
const S: Section = Section::Sinusoid;
const N: Shape = Shape::Number;

pub const FLIGHT: &[Key] = &[
    text(F, "file", "LOG.csv", "flight log: a path from the folder of the scene file", |d| &mut d.file),
    text(F, "builtin", "patrol", "flight of a built-in scene", |d| &mut d.builtin),
    text(F, "title", "Patrol", "title of the scene", |d| &mut d.scene.title),
    number!(F, N, "hours", unit("h", 3600.0, "s"), "duration to fly; default: the whole flight",
        "flight.duration_s" in (0.036, 3.6e8) => one(duration_s)),
    number!(F, N, "rate_hz", si("Hz"), "sample rate; not for a log, which has its own time stamps",
        "flight.rate_hz" in (1e-3, 2e4) => one(scene.rate_hz)),
    number!(F, N, "temperature_c", si("deg C"), "temperature of the sensors at the start",
        "flight.temperature_c" in (-273.15, 1000.0) => one(temperature_c)),
    number!(F, N, "temperature_change_c_h", unit("deg C/h", 1.0 / 3600.0, "deg C/s"),
        "constant rate of change of the temperature",
        "flight.temperature_change_c_s" in (-1e6 / 3600.0, 1e6 / 3600.0) => one(temperature_change_c_s)),
];

/// The keys of the start, without that of the ellipsoid, which is an option.
pub const START: &[Key] = &{
    let [keys @ .., _] = of_rows(F, &flight::START);
    keys
};

pub const REPEAT: &[Key] = &[
    count!(F, "repeat", "how many times all manoeuvres are flown", "flight.repeat" in (1.0, MAX_MANOEUVRES as f64) => repeat),
];

pub const MANOEUVRE: &[Key] = &[
    word!(M, "kind", "kind of the manoeuvre", "manoeuvre.kind", ManoeuvreFields::WORDS, manoeuvre.kind),
    number!(M, N, "duration_s", si("s"), "duration; not for turn, whose duration follows from its bank",
        "manoeuvre.duration_s" in Manoeuvre::TIMES_S => one(manoeuvre.duration_s)),
    number!(M, N, "ramp_s", si("s"), "time in which the manoeuvre builds up, and in which it dies out; default: 5",
        "manoeuvre.ramp_s" in Manoeuvre::TIMES_S => one(manoeuvre.ramp_s)),
    number!(M, N, "speed_change_m_s", si("m/s"), "change of the speed, for accelerate",
        "manoeuvre.speed_change_m_s" => one(manoeuvre.speed_change_m_s)),
    number!(M, N, "height_change_m", si("m"), "change of the height, for climb",
        "manoeuvre.height_change_m" => one(manoeuvre.height_change_m)),
    number!(M, N, "heading_change_deg", unit("deg", DEG, "rad"),
        "change of the heading, for turn; swing to each side, for s_turn",
        "manoeuvre.heading_change_rad" in Manoeuvre::HEADING_CHANGES_RAD => one(manoeuvre.heading_change_rad)),
    number!(M, N, "bank_deg", unit("deg", DEG, "rad"), "bank, for turn", "manoeuvre.bank_rad" in Manoeuvre::BANKS_RAD => one(manoeuvre.bank_rad)),
    number!(M, N, "turns", PURE, "number of whole rolls, of whole loops, or of swings, for roll, loop and s_turn",
        "manoeuvre.turns" in (Manoeuvre::TURNS.0, Manoeuvre::SWINGS.1) => one(manoeuvre.turns)),
];

pub const SINUSOID: &[Key] = &[
    choice!(S, "channel", "quantity that the sinusoid moves", "sinusoid.channel" => sinusoid.channel, Channel::WORDS),
    number!(S, N, "amplitude_deg", unit("deg", DEG, "rad"), "amplitude of an angle",
        "sinusoid.amplitude_rad" in Sinusoid::ANGLES_RAD => one(sinusoid.amplitude)),
    number!(S, N, "amplitude_m_s", si("m/s"), "amplitude of the speed", "sinusoid.amplitude_m_s" => one(sinusoid.amplitude)),
    number!(S, N, "frequency_hz", si("Hz"), "frequency", "sinusoid.frequency_hz" in Sinusoid::FREQUENCIES_HZ => one(sinusoid.frequency_hz)),
    number!(S, N, "phase_deg", unit("deg", DEG, "rad"), "phase at the start of the manoeuvre",
        "sinusoid.phase_rad" in Sinusoid::PHASES_RAD => one(sinusoid.phase_rad)),
];
