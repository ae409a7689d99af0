//! The manoeuvres of which a flight is composed.

use crate::base::error::{Error, Rule, check_range};
use crate::base::snapshot::codes;

/// Largest number of sinusoids in one manoeuvre.
pub const MAX_SINUSOIDS: usize = 6;

/// What a sinusoid of SINS_MANOEUVRE_SINUSOIDS moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    /// The sinusoid moves the course [rad], with the bank of a coordinated turn.
    Course,
    /// The sinusoid moves the climb angle [rad].
    Climb,
    /// The sinusoid moves the speed [m/s].
    Speed,
    /// The sinusoid moves roll alone [rad].
    Roll,
    /// The sinusoid moves pitch alone [rad].
    Pitch,
    /// The sinusoid moves heading alone [rad].
    Heading,
}

codes!(Channel {
    Course = 0 "course", Climb = 1 "climb", Speed = 2 "speed", Roll = 3 "roll", Pitch = 4 "pitch", Heading = 5 "heading",
});

/// amplitude · sin(2π frequency t + phase), with t since the start of the manoeuvre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinusoid {
    /// What it moves.
    pub channel: Channel,
    /// Amplitude [rad] or [m/s].
    pub amplitude: f64,
    /// Frequency [Hz].
    pub frequency_hz: f64,
    /// Phase [rad].
    pub phase_rad: f64,
}

/// One manoeuvre; each begins and ends in straight and level flight. `ramp_s` is the time in which it builds up, and in which it dies
/// out, at most half of its duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Manoeuvre {
    /// At rest; the speed must be 0.
    Rest {
        /// Duration [s].
        duration_s: f64,
    },
    /// Along a geodesic at constant speed and height.
    Straight {
        /// Duration [s].
        duration_s: f64,
    },
    /// Changes the speed.
    Accelerate {
        /// Duration [s].
        duration_s: f64,
        /// Change of speed [m/s].
        speed_change_m_s: f64,
    },
    /// Changes the height: pitches up and down again.
    Climb {
        /// Duration [s].
        duration_s: f64,
        /// Change of height [m].
        height_change_m: f64,
        /// Time in which the manoeuvre builds up, and in which it ends [s].
        ramp_s: f64,
    },
    /// Level turn, coordinated: tan(bank) = speed · turn rate / 9.80665. Its duration follows from these. A turn that is too
    /// short for the bank reaches a smaller bank.
    Turn {
        /// Change of heading, right positive [rad].
        heading_change_rad: f64,
        /// Bank, 0 to 1.5 [rad].
        bank_rad: f64,
        /// Time to roll in, and to roll out [s].
        ramp_s: f64,
    },
    /// Rolls about the path, which stays straight.
    Roll {
        /// Duration [s].
        duration_s: f64,
        /// Whole turns, right positive.
        turns: f64,
    },
    /// Vertical loops at constant speed.
    Loop {
        /// Duration [s].
        duration_s: f64,
        /// Whole turns, nose up positive.
        turns: f64,
        /// Time in which the manoeuvre builds up, and in which it ends [s].
        ramp_s: f64,
    },
    /// Course swings to both sides and back.
    STurn {
        /// Duration [s].
        duration_s: f64,
        /// Amplitude of the course, first to the right if positive [rad].
        heading_amplitude_rad: f64,
        /// Number of swings.
        cycles: f64,
        /// Time in which the manoeuvre builds up, and in which it ends [s].
        ramp_s: f64,
    },
    /// Sum of sinusoids: patrol patterns, rocking, coning, vibration.
    Sinusoids {
        /// Duration [s].
        duration_s: f64,
        /// Time in which the manoeuvre builds up, and in which it ends [s].
        ramp_s: f64,
        /// Sinusoids, of which the first `count` are used.
        terms: [Sinusoid; MAX_SINUSOIDS],
        /// Number of sinusoids, 1 to 6.
        count: usize,
    },
}

impl Manoeuvre {
    /// Checks every field, for a manoeuvre that begins at `speed_m_s`.
    pub(crate) fn validate(&self, speed_m_s: f64) -> Result<(), Error> {
        let duration = |duration_s: f64| check_range("manoeuvre.duration_s", duration_s, 1e-3, 1e8);
        let ramp = |ramp_s: f64| check_range("manoeuvre.ramp_s", ramp_s, 1e-3, 1e8);
        let whole = |turns: f64| {
            check_range("manoeuvre.turns", turns, -1e4, 1e4)?;
            let rule = Rule::Sentence("must be a whole number other than 0");
            if turns == 0.0 || turns != turns.round() {
                Err(Error::invalid("manoeuvre.turns", turns, rule))
            } else {
                Ok(())
            }
        };
        let moving = || {
            let rule = Rule::Sentence("must be greater than 0 in this manoeuvre; accelerate first");
            if speed_m_s > 0.0 { Ok(()) } else { Err(Error::invalid("speed_m_s", speed_m_s, rule)) }
        };
        match *self {
            Self::Rest { duration_s } => {
                let rule = Rule::Zero(" at rest; slow down first");
                if speed_m_s != 0.0 {
                    return Err(Error::invalid("speed_m_s", speed_m_s, rule));
                }
                duration(duration_s)
            }
            Self::Straight { duration_s } => duration(duration_s),
            Self::Accelerate { duration_s, speed_change_m_s } => {
                check_range("manoeuvre.speed_change_m_s", speed_change_m_s, -speed_m_s, 10e3 - speed_m_s)?;
                duration(duration_s)
            }
            Self::Climb { duration_s, height_change_m, ramp_s } => {
                moving()?;
                duration(duration_s)?;
                ramp(ramp_s)?;
                // The climb angle stays below 64°.
                let limit = 0.9 * speed_m_s * (duration_s - ramp_s.min(0.5 * duration_s));
                check_range("manoeuvre.height_change_m", height_change_m, -limit, limit)
            }
            Self::Turn { heading_change_rad, bank_rad, ramp_s } => {
                moving()?;
                check_range("manoeuvre.heading_change_rad", heading_change_rad, -1e4, 1e4)?;
                check_range("manoeuvre.bank_rad", bank_rad, 1e-3, 1.5)?;
                ramp(ramp_s)
            }
            Self::Roll { duration_s, turns } => {
                whole(turns)?;
                duration(duration_s)
            }
            Self::Loop { duration_s, turns, ramp_s } => {
                moving()?;
                whole(turns)?;
                ramp(ramp_s)?;
                duration(duration_s)
            }
            Self::STurn { duration_s, heading_amplitude_rad, cycles, ramp_s } => {
                moving()?;
                check_range("manoeuvre.heading_change_rad", heading_amplitude_rad, -10.0, 10.0)?;
                check_range("manoeuvre.turns", cycles, 0.0, 1e6)?;
                ramp(ramp_s)?;
                duration(duration_s)
            }
            Self::Sinusoids { duration_s, ramp_s, terms, count } => {
                check_range("manoeuvre.sinusoids", count as f64, 1.0, MAX_SINUSOIDS as f64)?;
                for term in &terms[..count] {
                    term.validate(speed_m_s)?;
                }
                let speeds = terms[..count].iter().filter(|term| matches!(term.channel, Channel::Speed));
                let together = speeds.map(|term| term.amplitude.abs()).sum();
                check_range("manoeuvre.amplitude, those of the speed together", together, 0.0, speed_m_s)?;
                ramp(ramp_s)?;
                duration(duration_s)
            }
        }
    }
}

impl Sinusoid {
    /// Checks every field, for a manoeuvre that begins at `speed_m_s`.
    pub(crate) fn validate(&self, speed_m_s: f64) -> Result<(), Error> {
        let limit = match self.channel {
            Channel::Climb => 1.5,
            Channel::Speed => speed_m_s,
            _ => 10.0,
        };
        check_range("manoeuvre.amplitude", self.amplitude, -limit, limit)?;
        check_range("manoeuvre.frequency_hz", self.frequency_hz, 0.0, 1e3)?;
        check_range("manoeuvre.phase_rad", self.phase_rad, -100.0, 100.0)
    }
}
