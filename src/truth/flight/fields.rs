//! Manoeuvres of all kinds in one flat form: that of the C interface and of scenes.

use super::manoeuvre::{Channel, MAX_SINUSOIDS, Manoeuvre, Sinusoid};

/// Default of the time in which a manoeuvre builds up [s].
pub(crate) const DEFAULT_RAMP_S: f64 = 5.0;

/// The kinds of manoeuvres, and the fields that each of them uses, as errors name them.
pub(crate) const MANOEUVRE_KINDS: [(&str, &[&str]); 9] = [
    ("rest", &[DURATION]),
    ("straight", &[DURATION]),
    ("accelerate", &[DURATION, "manoeuvre.speed_change_m_s"]),
    ("climb", &[DURATION, RAMP, "manoeuvre.height_change_m"]),
    ("turn", &[RAMP, HEADING_CHANGE, "manoeuvre.bank_rad"]),
    ("roll", &[DURATION, TURNS]),
    ("loop", &[DURATION, RAMP, TURNS]),
    ("s_turn", &[DURATION, RAMP, HEADING_CHANGE, TURNS]),
    ("sinusoids", &[DURATION, RAMP]),
];

const DURATION: &str = "manoeuvre.duration_s";
const RAMP: &str = "manoeuvre.ramp_s";
const HEADING_CHANGE: &str = "manoeuvre.heading_change_rad";
const TURNS: &str = "manoeuvre.turns";

/// A manoeuvre of any kind. It has the quantities of all kinds; a kind uses those that [`MANOEUVRE_KINDS`] lists.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ManoeuvreFields {
    /// Index in [`MANOEUVRE_KINDS`].
    pub kind: usize,
    pub duration_s: f64,
    pub ramp_s: f64,
    pub speed_change_m_s: f64,
    pub height_change_m: f64,
    pub heading_change_rad: f64,
    pub bank_rad: f64,
    pub turns: f64,
    /// Sinusoids, of which the first `sinusoid_count` are used.
    pub sinusoids: [Sinusoid; MAX_SINUSOIDS],
    pub sinusoid_count: usize,
}

impl Default for ManoeuvreFields {
    fn default() -> Self {
        let none = Sinusoid { channel: Channel::Course, amplitude: 0.0, frequency_hz: 0.0, phase_rad: 0.0 };
        Self {
            kind: 0,
            duration_s: 0.0,
            ramp_s: DEFAULT_RAMP_S,
            speed_change_m_s: 0.0,
            height_change_m: 0.0,
            heading_change_rad: 0.0,
            bank_rad: 0.0,
            turns: 0.0,
            sinusoids: [none; MAX_SINUSOIDS],
            sinusoid_count: 0,
        }
    }
}

impl ManoeuvreFields {
    /// The manoeuvre; fields that its kind does not use are ignored.
    pub fn to_manoeuvre(self) -> Manoeuvre {
        let Self { duration_s, ramp_s, speed_change_m_s, height_change_m, turns, bank_rad, .. } = self;
        let heading_change_rad = self.heading_change_rad;
        match self.kind {
            0 => Manoeuvre::Rest { duration_s },
            1 => Manoeuvre::Straight { duration_s },
            2 => Manoeuvre::Accelerate { duration_s, speed_change_m_s },
            3 => Manoeuvre::Climb { duration_s, height_change_m, ramp_s },
            4 => Manoeuvre::Turn { heading_change_rad, bank_rad, ramp_s },
            5 => Manoeuvre::Roll { duration_s, turns },
            6 => Manoeuvre::Loop { duration_s, turns, ramp_s },
            7 => Manoeuvre::STurn {
                duration_s,
                heading_amplitude_rad: heading_change_rad,
                cycles: turns,
                ramp_s,
            },
            _ => {
                let (terms, count) = (self.sinusoids, self.sinusoid_count);
                Manoeuvre::Sinusoids { duration_s, ramp_s, terms, count }
            }
        }
    }
}

impl From<&Manoeuvre> for ManoeuvreFields {
    fn from(manoeuvre: &Manoeuvre) -> Self {
        let base = Self::default();
        match *manoeuvre {
            Manoeuvre::Rest { duration_s } => Self { kind: 0, duration_s, ..base },
            Manoeuvre::Straight { duration_s } => Self { kind: 1, duration_s, ..base },
            Manoeuvre::Accelerate { duration_s, speed_change_m_s } => {
                Self { kind: 2, duration_s, speed_change_m_s, ..base }
            }
            Manoeuvre::Climb { duration_s, height_change_m, ramp_s } => {
                Self { kind: 3, duration_s, height_change_m, ramp_s, ..base }
            }
            Manoeuvre::Turn { heading_change_rad, bank_rad, ramp_s } => {
                Self { kind: 4, heading_change_rad, bank_rad, ramp_s, ..base }
            }
            Manoeuvre::Roll { duration_s, turns } => Self { kind: 5, duration_s, turns, ..base },
            Manoeuvre::Loop { duration_s, turns, ramp_s } => {
                Self { kind: 6, duration_s, turns, ramp_s, ..base }
            }
            Manoeuvre::STurn { duration_s, heading_amplitude_rad, cycles, ramp_s } => {
                let (heading_change_rad, turns) = (heading_amplitude_rad, cycles);
                Self { kind: 7, duration_s, heading_change_rad, turns, ramp_s, ..base }
            }
            Manoeuvre::Sinusoids { duration_s, ramp_s, terms, count } => {
                Self { kind: 8, duration_s, ramp_s, sinusoids: terms, sinusoid_count: count, ..base }
            }
        }
    }
}
