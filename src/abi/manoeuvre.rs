//! `sins_manoeuvre`, of which embedded flights are made.

use super::choice::{Choice, check_reserved, choices};
use super::failure::Failure;
use super::memory::interface_struct;
use crate::base::error::{Error, Rule, Value, check_integer};
use crate::truth::flight::{
    Channel, DEFAULT_RAMP_S, MANOEUVRE_KINDS, MAX_SINUSOIDS, Manoeuvre, ManoeuvreFields, Sinusoid,
};

/// Kinds of manoeuvre.
pub type sins_manoeuvre_kind = i32;

/// At rest for duration_s; the speed must be 0.
pub const SINS_MANOEUVRE_REST: sins_manoeuvre_kind = 0;
/// Along a geodesic at constant speed and height for duration_s.
pub const SINS_MANOEUVRE_STRAIGHT: sins_manoeuvre_kind = 1;
/// Changes the speed by speed_change_m_s in duration_s.
pub const SINS_MANOEUVRE_ACCELERATE: sins_manoeuvre_kind = 2;
/// Changes the height by height_change_m in duration_s. Uses ramp_s.
pub const SINS_MANOEUVRE_CLIMB: sins_manoeuvre_kind = 3;
/// Level coordinated turn by heading_change_rad (right positive) at bank_rad, with ramp_s to roll in and to roll out. The
/// duration follows from these.
pub const SINS_MANOEUVRE_TURN: sins_manoeuvre_kind = 4;
/// Whole rolls along a straight path in duration_s; the field turns is their number (positive: right wing down).
pub const SINS_MANOEUVRE_ROLL: sins_manoeuvre_kind = 5;
/// Whole vertical loops at constant speed in duration_s; the field turns is their number (nose up positive). Uses ramp_s.
pub const SINS_MANOEUVRE_LOOP: sins_manoeuvre_kind = 6;
/// The course swings by heading_change_rad to both sides, first to the right if it is positive. The field turns is the number
/// of swings in duration_s. A swing is a full period: to one side, to the other side, and back. Uses ramp_s.
pub const SINS_MANOEUVRE_S_TURN: sins_manoeuvre_kind = 7;
/// Sum of sinusoid_count sinusoids for duration_s: patrol patterns, rocking, coning, vibration. Uses ramp_s.
pub const SINS_MANOEUVRE_SINUSOIDS: sins_manoeuvre_kind = 8;

include!(concat!(env!("OUT_DIR"), "/sins_channel.rs"));

/// One manoeuvre of an embedded flight; each begins and ends straight and level. Fields that its kind does not use must be 0.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct sins_manoeuvre {
    /// sizeof(sins_manoeuvre); in an array it is enough to set it in the first element and 0 in the others.
    pub struct_size: u32,
    /// Must be 0.
    pub reserved: u32,
    /// Kind of the manoeuvre, of enum sins_manoeuvre_kind.
    pub kind: i32,
    /// Number of sinusoids, 1 to 6.
    pub sinusoid_count: i32,
    /// Duration, 1e-3 to 1e8 [s].
    pub duration_s: f64,
    /// Time in which the manoeuvre builds up, and time in which it dies out, 1e-3 to 1e8; 0: 5 s [s]. If it is longer than
    /// half of the duration, half of the duration is used.
    pub ramp_s: f64,
    /// Change of speed; the speed must stay between 0 and 10 km/s [m/s].
    pub speed_change_m_s: f64,
    /// Change of height; the climb angle must stay below 64 degrees [m].
    pub height_change_m: f64,
    /// Change of heading, up to 1e4 rad, or amplitude of the swings of an S-turn, up to 10 rad [rad].
    pub heading_change_rad: f64,
    /// Bank of a turn, 1e-3 to 1.5 [rad]. If the heading change is too small to reach this bank, the turn uses a smaller
    /// bank.
    pub bank_rad: f64,
    /// Number of rolls or loops, a whole number from -1e4 to 1e4, not 0; or number of swings of an S-turn, 0 to 1e6.
    pub turns: f64,
    /// What each sinusoid moves, of enum sins_channel.
    pub channel: [i32; 6],
    /// Amplitude of each sinusoid [rad] or [m/s]: up to 10 rad; for the climb angle up to 1.5 rad; for the speed, the sum of the
    /// amplitudes is at most the speed.
    pub amplitude: [f64; 6],
    /// Frequency of each sinusoid, 0 to 1000 [Hz].
    pub frequency_hz: [f64; 6],
    /// Phase of each sinusoid: amplitude sin(2 pi frequency t + phase), with t since the start of the manoeuvre [rad].
    pub phase_rad: [f64; 6],
}

interface_struct!(sins_manoeuvre, "manoeuvre", 240);

const NOT_USED: Rule = Rule::Zero(": this manoeuvre does not use it");

// A kind is its place in the table.
const _: () =
    assert!(SINS_MANOEUVRE_REST == 0 && SINS_MANOEUVRE_SINUSOIDS + 1 == MANOEUVRE_KINDS.len() as i32);

impl sins_manoeuvre {
    /// The quantities that a kind may use, under their names.
    fn quantities(&mut self) -> [(&'static str, &mut f64); 7] {
        [
            ("manoeuvre.duration_s", &mut self.duration_s),
            ("manoeuvre.ramp_s", &mut self.ramp_s),
            ("manoeuvre.speed_change_m_s", &mut self.speed_change_m_s),
            ("manoeuvre.height_change_m", &mut self.height_change_m),
            ("manoeuvre.heading_change_rad", &mut self.heading_change_rad),
            ("manoeuvre.bank_rad", &mut self.bank_rad),
            ("manoeuvre.turns", &mut self.turns),
        ]
    }

    #[cfg(feature = "scenes")]
    pub(super) fn from_manoeuvre(manoeuvre: &Manoeuvre) -> Self {
        let fields = ManoeuvreFields::from(manoeuvre);
        let terms = &fields.sinusoids;
        let mut made = Self {
            struct_size: size_of::<Self>() as u32,
            reserved: 0,
            kind: fields.kind as i32,
            sinusoid_count: fields.sinusoid_count as i32,
            duration_s: fields.duration_s,
            ramp_s: fields.ramp_s,
            speed_change_m_s: fields.speed_change_m_s,
            height_change_m: fields.height_change_m,
            heading_change_rad: fields.heading_change_rad,
            bank_rad: fields.bank_rad,
            turns: fields.turns,
            channel: terms.map(|term| term.channel.code()),
            amplitude: terms.map(|term| term.amplitude),
            frequency_hz: terms.map(|term| term.frequency_hz),
            phase_rad: terms.map(|term| term.phase_rad),
        };
        let (_, uses) = MANOEUVRE_KINDS[fields.kind];
        for (field, value) in made.quantities() {
            if !uses.contains(&field) {
                *value = 0.0;
            }
        }
        made
    }

    pub(super) fn to_manoeuvre(mut self) -> Result<Manoeuvre, Failure> {
        check_reserved("manoeuvre.reserved", self.reserved)?;
        let kind = usize::try_from(self.kind).unwrap_or(usize::MAX);
        let Some((_, uses)) = MANOEUVRE_KINDS.get(kind) else {
            let rule = Rule::OneOf("sins_manoeuvre_kind", 0, MANOEUVRE_KINDS.len() as i32 - 1);
            return Err(Error::invalid("manoeuvre.kind", self.kind, rule).into());
        };
        for (field, value) in self.quantities() {
            if *value != 0.0 && !uses.contains(&field) {
                return Err(Error::invalid(field, *value, NOT_USED).into());
            }
        }
        let mut fields = ManoeuvreFields {
            kind,
            duration_s: self.duration_s,
            ramp_s: if self.ramp_s == 0.0 { DEFAULT_RAMP_S } else { self.ramp_s },
            speed_change_m_s: self.speed_change_m_s,
            height_change_m: self.height_change_m,
            heading_change_rad: self.heading_change_rad,
            bank_rad: self.bank_rad,
            turns: self.turns,
            ..ManoeuvreFields::default()
        };
        self.set_sinusoids(&mut fields)?;
        Ok(fields.to_manoeuvre())
    }

    fn set_sinusoids(&self, fields: &mut ManoeuvreFields) -> Result<(), Failure> {
        if self.kind == SINS_MANOEUVRE_SINUSOIDS {
            check_integer("manoeuvre.sinusoid_count", self.sinusoid_count, 1, MAX_SINUSOIDS as u64)?;
            fields.sinusoid_count = self.sinusoid_count as usize;
        } else if self.sinusoid_count != 0 {
            return Err(Error::invalid("manoeuvre.sinusoid_count", self.sinusoid_count, NOT_USED).into());
        }
        for (i, term) in fields.sinusoids.iter_mut().enumerate().take(fields.sinusoid_count) {
            *term = Sinusoid {
                channel: Channel::of("manoeuvre.channel", self.channel[i])?,
                amplitude: self.amplitude[i],
                frequency_hz: self.frequency_hz[i],
                phase_rad: self.phase_rad[i],
            };
        }
        for i in fields.sinusoid_count..MAX_SINUSOIDS {
            let unused: [(_, Value); 4] = [
                ("manoeuvre.channel", self.channel[i].into()),
                ("manoeuvre.amplitude", self.amplitude[i].into()),
                ("manoeuvre.frequency_hz", self.frequency_hz[i].into()),
                ("manoeuvre.phase_rad", self.phase_rad[i].into()),
            ];
            if let Some((field, value)) = unused.into_iter().find(|(_, value)| value.as_f64() != 0.0) {
                return Err(Error::invalid(field, value, NOT_USED).into());
            }
        }
        Ok(())
    }
}
