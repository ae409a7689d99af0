//! The true motion: `[flight]`, `[[manoeuvre]]`, `[[manoeuvre.sinusoid]]`.

use super::super::key::{Key, Section, Shape, Target, one};
use super::{PURE, first_words, numbers, si, unit, within};
use crate::flight::{Channel, MANOEUVRE_KINDS};
use crate::units::DEG;

const F: Section = Section::Flight;
const M: Section = Section::Manoeuvre;
const S: Section = Section::Sinusoid;
const N: Shape = Shape::Number;

const fn text(
    name: &'static str,
    example: &'static str,
    doc: &'static str,
    place: fn(&mut super::super::draft::Draft) -> &mut String,
) -> Key {
    Key { section: F, name, doc, target: Target::Text { example, place } }
}

pub const FLIGHT: &[Key] = &[
    text("file", "LOG.csv", "flight log: a path from the folder of the scene file", |d| &mut d.file),
    text("builtin", "patrol", "flight of a built-in scene", |d| &mut d.builtin),
    text("title", "Patrol", "title of the scene", |d| &mut d.scene.title),
    within(
        F,
        ("hours", unit("h", 3600.0, "s"), "duration to fly; default: the whole flight"),
        (1e-5, 1e5),
        "flight.duration_s",
        |d| one(&mut d.duration_s),
    ),
    within(
        F,
        ("rate_hz", si("Hz"), "sample rate; not for a log, which has its own time stamps"),
        (1e-3, 2e4),
        "flight.rate_hz",
        |d| one(&mut d.scene.rate_hz),
    ),
    within(
        F,
        ("temperature_c", si("deg C"), "temperature of the sensors at the start"),
        (-273.15, 1000.0),
        "flight.temperature_c",
        |d| one(&mut d.temperature_c),
    ),
    within(
        F,
        (
            "temperature_change_c_h",
            unit("deg C/h", 1.0 / 3600.0, "deg C/s"),
            "constant rate of change of the temperature",
        ),
        (-1e6, 1e6),
        "flight.temperature_change_c_s",
        |d| one(&mut d.temperature_change_c_s),
    ),
    numbers(
        F,
        ("latitude_deg", unit("deg", DEG, "rad"), "geodetic latitude of the start"),
        N,
        "start.latitude_rad",
        |d| one(&mut d.start.latitude_rad),
    ),
    numbers(
        F,
        ("longitude_deg", unit("deg", DEG, "rad"), "longitude of the start, east positive"),
        N,
        "start.longitude_rad",
        |d| one(&mut d.start.longitude_rad),
    ),
    numbers(F, ("height_m", si("m"), "height of the start above the ellipsoid"), N, "start.height_m", |d| {
        one(&mut d.start.height_m)
    }),
    numbers(F, ("speed_m_s", si("m/s"), "speed at the start against the Earth"), N, "start.speed_m_s", |d| {
        one(&mut d.start.speed_m_s)
    }),
    numbers(
        F,
        ("heading_deg", unit("deg", DEG, "rad"), "course and heading at the start"),
        N,
        "start.heading_rad",
        |d| one(&mut d.start.heading_rad),
    ),
    numbers(
        F,
        (
            "roll_deg",
            unit("deg", DEG, "rad"),
            "roll of the body relative to the axes of the path, throughout the flight",
        ),
        N,
        "start.roll_rad",
        |d| one(&mut d.start.roll_rad),
    ),
    numbers(
        F,
        (
            "pitch_deg",
            unit("deg", DEG, "rad"),
            "pitch of the body relative to the axes of the path, throughout the flight",
        ),
        N,
        "start.pitch_rad",
        |d| one(&mut d.start.pitch_rad),
    ),
    Key {
        section: F,
        name: "repeat",
        doc: "how many times all manoeuvres are flown",
        target: Target::Count {
            field: "flight.repeat",
            get: |d| d.repeat,
            set: |d, repeat| d.repeat = repeat,
        },
    },
];

pub const MANOEUVRE: &[Key] = &[
    Key {
        section: M,
        name: "kind",
        doc: "kind of the manoeuvre",
        target: Target::Choice {
            field: "manoeuvre.kind",
            words: &first_words(MANOEUVRE_KINDS),
            get: |d| d.manoeuvre.kind,
            set: |d, kind| d.manoeuvre.kind = kind,
        },
    },
    numbers(
        M,
        ("duration_s", si("s"), "duration; not for turn, whose duration follows from its bank"),
        N,
        "manoeuvre.duration_s",
        |d| one(&mut d.manoeuvre.duration_s),
    ),
    numbers(
        M,
        ("ramp_s", si("s"), "time in which the manoeuvre builds up, and in which it dies out; default: 5"),
        N,
        "manoeuvre.ramp_s",
        |d| one(&mut d.manoeuvre.ramp_s),
    ),
    numbers(
        M,
        ("speed_change_m_s", si("m/s"), "change of the speed, for accelerate"),
        N,
        "manoeuvre.speed_change_m_s",
        |d| one(&mut d.manoeuvre.speed_change_m_s),
    ),
    numbers(
        M,
        ("height_change_m", si("m"), "change of the height, for climb"),
        N,
        "manoeuvre.height_change_m",
        |d| one(&mut d.manoeuvre.height_change_m),
    ),
    numbers(
        M,
        (
            "heading_change_deg",
            unit("deg", DEG, "rad"),
            "change of the heading, for turn; swing to each side, for s_turn",
        ),
        N,
        "manoeuvre.heading_change_rad",
        |d| one(&mut d.manoeuvre.heading_change_rad),
    ),
    numbers(M, ("bank_deg", unit("deg", DEG, "rad"), "bank, for turn"), N, "manoeuvre.bank_rad", |d| {
        one(&mut d.manoeuvre.bank_rad)
    }),
    numbers(
        M,
        ("turns", PURE, "number of whole rolls, of whole loops, or of swings, for roll, loop and s_turn"),
        N,
        "manoeuvre.turns",
        |d| one(&mut d.manoeuvre.turns),
    ),
];

/// The words of what a sinusoid moves.
pub const CHANNELS: [(&str, Channel); 6] = [
    ("course", Channel::Course),
    ("climb", Channel::Climb),
    ("speed", Channel::Speed),
    ("roll", Channel::Roll),
    ("pitch", Channel::Pitch),
    ("heading", Channel::Heading),
];

pub const SINUSOID: &[Key] = &[
    Key {
        section: S,
        name: "channel",
        doc: "quantity that the sinusoid moves",
        target: Target::Choice {
            field: "sinusoid.channel",
            words: &first_words(CHANNELS),
            get: |d| CHANNELS.iter().position(|(_, channel)| *channel == d.sinusoid.channel).unwrap_or(0),
            set: |d, index| d.sinusoid.channel = CHANNELS[index].1,
        },
    },
    numbers(
        S,
        ("amplitude_deg", unit("deg", DEG, "rad"), "amplitude of an angle"),
        N,
        "sinusoid.amplitude_rad",
        |d| one(&mut d.sinusoid.amplitude_rad),
    ),
    numbers(S, ("amplitude_m_s", si("m/s"), "amplitude of the speed"), N, "sinusoid.amplitude_m_s", |d| {
        one(&mut d.sinusoid.amplitude_m_s)
    }),
    numbers(S, ("frequency_hz", si("Hz"), "frequency"), N, "sinusoid.frequency_hz", |d| {
        one(&mut d.sinusoid.frequency_hz)
    }),
    numbers(
        S,
        ("phase_deg", unit("deg", DEG, "rad"), "phase at the start of the manoeuvre"),
        N,
        "sinusoid.phase_rad",
        |d| one(&mut d.sinusoid.phase_rad),
    ),
];
