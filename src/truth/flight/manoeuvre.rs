//! The manoeuvres of which a flight is composed.

use crate::base::error::{Error, Rule, check_range, check_within};
use crate::base::kinds::kinds;
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

/// Sinusoids that act together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinusoids {
    terms: [Sinusoid; MAX_SINUSOIDS],
    count: usize,
}

impl Default for Sinusoids {
    fn default() -> Self {
        Self { terms: [Sinusoid::NONE; MAX_SINUSOIDS], count: 0 }
    }
}

impl Sinusoids {
    /// Those of `terms`; beyond [`MAX_SINUSOIDS`] of them the rest is left out, and the manoeuvre is rejected.
    pub fn of(terms: &[Sinusoid]) -> Self {
        let mut all = Self { count: terms.len(), ..Self::default() };
        all.terms.iter_mut().zip(terms).for_each(|(to, term)| *to = *term);
        all
    }

    /// All of them.
    pub fn terms(&self) -> &[Sinusoid] {
        &self.terms[..self.count.min(MAX_SINUSOIDS)]
    }

    /// Adds one. Returns whether there was room for it.
    pub(crate) fn push(&mut self, term: Sinusoid) -> bool {
        let place = self.terms.get_mut(self.count);
        let has_room = place.is_some();
        if let Some(place) = place {
            *place = term;
            self.count += 1;
        }
        has_room
    }
}

/// Default of the time in which a manoeuvre builds up [s].
const DEFAULT_RAMP_S: f64 = 5.0;

kinds! {
    /// One manoeuvre; each begins and ends in straight and level flight. `ramp_s` is the time in which it builds up, and in which it
    /// dies out, at most half of its duration.
    Manoeuvre of "manoeuvre", flat ManoeuvreFields {
        /// Duration [s].
        duration_s = 0.0,
        /// Time in which the manoeuvre builds up, and in which it dies out [s].
        ramp_s = DEFAULT_RAMP_S,
        /// Change of speed [m/s].
        speed_change_m_s = 0.0,
        /// Change of height [m].
        height_change_m = 0.0,
        /// Change of heading, right positive; of an S-turn the amplitude of the course [rad].
        heading_change_rad = 0.0,
        /// Bank of a turn, 0 to 1.5 [rad].
        bank_rad = 0.0,
        /// Number of rolls, of loops, or of swings.
        turns = 0.0,
    } with sinusoids: Sinusoids {
        /// At rest for duration_s; the speed must be 0.
        Rest = 0 "rest" { duration_s },
        /// Along a geodesic at constant speed and height for duration_s.
        Straight = 1 "straight" { duration_s },
        /// Changes the speed by speed_change_m_s in duration_s.
        Accelerate = 2 "accelerate" { duration_s, speed_change_m_s },
        /// Changes the height by height_change_m in duration_s. Uses ramp_s.
        Climb = 3 "climb" { duration_s, ramp_s, height_change_m },
        /// Level coordinated turn by heading_change_rad (right positive) at bank_rad, with ramp_s to roll in and to roll out. The
        /// duration follows from these.
        Turn = 4 "turn" { ramp_s, heading_change_rad, bank_rad },
        /// Whole rolls along a straight path in duration_s; the field turns is their number (positive: right wing down).
        Roll = 5 "roll" { duration_s, turns },
        /// Whole vertical loops at constant speed in duration_s; the field turns is their number (nose up positive). Uses ramp_s.
        Loop = 6 "loop" { duration_s, ramp_s, turns },
        /// The course swings by heading_change_rad to both sides, first to the right if it is positive. The field turns is the number
        /// of swings in duration_s. A swing is a full period: to one side, to the other side, and back. Uses ramp_s.
        STurn = 7 "s_turn" { duration_s, ramp_s, heading_change_rad, turns },
        /// Sum of sinusoid_count sinusoids for duration_s: patrol patterns, rocking, coning, vibration. Uses ramp_s.
        Sinusoids = 8 "sinusoids" { duration_s, ramp_s; sinusoids: Sinusoids },
    }
}

#[cfg(feature = "scenes")]
impl ManoeuvreFields {
    /// Makes the quantities 0 that the kind does not use.
    pub fn clear_unused(&mut self) {
        let uses = Self::KINDS.get(self.kind).map_or(Self::QUANTITIES, |(_, uses)| uses);
        let numbers = Self::QUANTITIES.iter().zip(self.numbers_mut());
        numbers.filter(|(of, _)| !uses.contains(of)).for_each(|(_, number)| *number = 0.0);
    }
}

/// Greatest speed that a manoeuvre can reach [m/s].
const GREATEST_SPEED_M_S: f64 = 10e3;

impl Manoeuvre {
    // Ranges of the quantities; those of some kinds are narrower.
    pub(crate) const TIMES_S: (f64, f64) = (1e-3, 1e8);
    pub(crate) const HEADING_CHANGES_RAD: (f64, f64) = (-1e4, 1e4);
    pub(crate) const BANKS_RAD: (f64, f64) = (1e-3, 1.5);
    pub(crate) const TURNS: (f64, f64) = (-1e4, 1e4);
    pub(crate) const SWINGS: (f64, f64) = (0.0, 1e6);

    /// Speed at its end [m/s], if it begins at `speed_m_s`.
    pub(crate) fn speed_after(&self, speed_m_s: f64) -> f64 {
        let Self::Accelerate { speed_change_m_s, .. } = self else { return speed_m_s };
        // A full stop is exactly 0, without rounding.
        let speed = speed_m_s + speed_change_m_s;
        if speed.abs() < 1e-12 * speed_m_s { 0.0 } else { speed }
    }

    /// Whether the speed at its end is another than at its begin.
    #[cfg(feature = "scenes")]
    pub(crate) fn changes_speed(&self) -> bool {
        matches!(self, Self::Accelerate { .. })
    }

    /// Speed at its begin with which its limits are the widest [m/s].
    #[cfg(feature = "scenes")]
    pub(crate) fn widest_speed_m_s(&self) -> f64 {
        match self {
            Self::Rest { .. } => 0.0,
            Self::Accelerate { speed_change_m_s, .. } if *speed_change_m_s > 0.0 => 0.0,
            _ => GREATEST_SPEED_M_S,
        }
    }

    /// Why the limit in an error of [`Self::validate`] at `speed_m_s` is what it is; `None`: the limit is the same in each flight.
    #[cfg(feature = "scenes")]
    pub(crate) fn reason(&self, error: &Error, speed_m_s: f64) -> Option<String> {
        match (self, error.field) {
            (Self::Climb { duration_s, ramp_s, .. }, "manoeuvre.height_change_m") => Some(format!(
                "{duration_s} s at {speed_m_s} m/s, less a ramp of {} s, with a climb angle below 64 deg",
                ramp_s.min(0.5 * duration_s)
            )),
            (Self::Accelerate { .. }, "manoeuvre.speed_change_m_s") => Some(format!(
                "the speed before it is {speed_m_s} m/s, and it must stay from 0 to {GREATEST_SPEED_M_S} m/s"
            )),
            (Self::Sinusoids { .. }, field) if field.starts_with("manoeuvre.amplitude") => {
                let is_speed = matches!(error.rule, Rule::Between(_, high) if high == speed_m_s);
                is_speed.then(|| format!("the speed before it is {speed_m_s} m/s, and it must stay above 0"))
            }
            _ => None,
        }
    }

    /// Checks every field, for a manoeuvre that begins at `speed_m_s`.
    pub(crate) fn validate(&self, speed_m_s: f64) -> Result<(), Error> {
        let duration = |duration_s: f64| check_within("manoeuvre.duration_s", duration_s, Self::TIMES_S);
        let ramp = |ramp_s: f64| check_within("manoeuvre.ramp_s", ramp_s, Self::TIMES_S);
        let whole = |turns: f64| {
            check_within("manoeuvre.turns", turns, Self::TURNS)?;
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
                check_range(
                    "manoeuvre.speed_change_m_s",
                    speed_change_m_s,
                    -speed_m_s,
                    GREATEST_SPEED_M_S - speed_m_s,
                )?;
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
                check_within("manoeuvre.heading_change_rad", heading_change_rad, Self::HEADING_CHANGES_RAD)?;
                check_within("manoeuvre.bank_rad", bank_rad, Self::BANKS_RAD)?;
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
            Self::STurn { duration_s, heading_change_rad, turns, ramp_s } => {
                moving()?;
                check_range("manoeuvre.heading_change_rad", heading_change_rad, -10.0, 10.0)?;
                check_within("manoeuvre.turns", turns, Self::SWINGS)?;
                ramp(ramp_s)?;
                duration(duration_s)
            }
            Self::Sinusoids { duration_s, ramp_s, sinusoids } => {
                check_range("manoeuvre.sinusoids", sinusoids.count as f64, 1.0, MAX_SINUSOIDS as f64)?;
                for term in sinusoids.terms() {
                    term.validate(speed_m_s)?;
                }
                let speeds = sinusoids.terms().iter().filter(|term| matches!(term.channel, Channel::Speed));
                let together = speeds.map(|term| term.amplitude.abs()).sum();
                check_range("manoeuvre.amplitude, those of the speed together", together, 0.0, speed_m_s)?;
                ramp(ramp_s)?;
                duration(duration_s)
            }
        }
    }
}

impl Sinusoid {
    // Ranges of the quantities; that of a climb angle is narrower.
    pub(crate) const ANGLES_RAD: (f64, f64) = (-10.0, 10.0);
    pub(crate) const FREQUENCIES_HZ: (f64, f64) = (0.0, 1e3);
    pub(crate) const PHASES_RAD: (f64, f64) = (-100.0, 100.0);

    /// One without motion.
    pub(crate) const NONE: Self =
        Self { channel: Channel::Course, amplitude: 0.0, frequency_hz: 0.0, phase_rad: 0.0 };

    /// Checks every field, for a manoeuvre that begins at `speed_m_s`.
    pub(crate) fn validate(&self, speed_m_s: f64) -> Result<(), Error> {
        let limit = match self.channel {
            Channel::Climb => 1.5,
            Channel::Speed => speed_m_s,
            _ => Self::ANGLES_RAD.1,
        };
        check_range("manoeuvre.amplitude", self.amplitude, -limit, limit)?;
        check_within("manoeuvre.frequency_hz", self.frequency_hz, Self::FREQUENCIES_HZ)?;
        check_within("manoeuvre.phase_rad", self.phase_rad, Self::PHASES_RAD)
    }
}
