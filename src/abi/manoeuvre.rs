//! `sins_manoeuvre`, of which embedded flights are made.

use super::choice::{Choice, check_reserved, choices, of_kinds};
use super::failure::CallError;
use super::memory::interface_struct;
use crate::base::error::{Error, Rule, Value, check_integer};
use crate::truth::flight::{Channel, MAX_SINUSOIDS, Manoeuvre, ManoeuvreFields, Sinusoid, Sinusoids};

include!(concat!(env!("OUT_DIR"), "/sins_manoeuvre_kind.rs"));
include!(concat!(env!("OUT_DIR"), "/sins_channel.rs"));

/// One manoeuvre of an embedded flight; each begins and ends straight and level. Fields that its kind does not use must be 0.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
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

impl sins_manoeuvre {
    /// The quantities, in the order of [`ManoeuvreFields`].
    fn numbers_mut(&mut self) -> [&mut f64; 7] {
        let Self {
            duration_s,
            ramp_s,
            speed_change_m_s,
            height_change_m,
            heading_change_rad,
            bank_rad,
            turns,
            ..
        } = self;
        [duration_s, ramp_s, speed_change_m_s, height_change_m, heading_change_rad, bank_rad, turns]
    }

    #[cfg(feature = "scenes")]
    pub(super) fn from_manoeuvre(manoeuvre: &Manoeuvre) -> Self {
        let mut fields = ManoeuvreFields::from(manoeuvre);
        let terms = fields.sinusoids.terms();
        let each =
            |number: fn(&Sinusoid) -> f64| core::array::from_fn(|index| terms.get(index).map_or(0.0, number));
        let mut made = Self {
            struct_size: size_of::<Self>() as u32,
            kind: fields.kind as i32,
            sinusoid_count: terms.len() as i32,
            channel: core::array::from_fn(|index| terms.get(index).map_or(0, |term| term.channel.code())),
            amplitude: each(|term| term.amplitude),
            frequency_hz: each(|term| term.frequency_hz),
            phase_rad: each(|term| term.phase_rad),
            ..Self::default()
        };
        fields.clear_unused();
        made.numbers_mut().into_iter().zip(fields.numbers_mut()).for_each(|(to, from)| *to = *from);
        made
    }

    pub(super) fn to_manoeuvre(mut self) -> Result<Manoeuvre, CallError> {
        check_reserved("manoeuvre.reserved", self.reserved)?;
        let kind =
            of_kinds("manoeuvre.kind", self.kind, ManoeuvreFields::KINDS.len(), "sins_manoeuvre_kind")?;
        let numbers = self.numbers_mut().map(|number| *number);
        let mut fields = ManoeuvreFields { kind, sinusoids: self.sinusoids()?, ..ManoeuvreFields::default() };
        fields.check_unused(&numbers)?;
        // 0 is what the library takes where nobody sets a quantity.
        let set = fields.numbers_mut().into_iter().zip(numbers).filter(|(_, number)| *number != 0.0);
        set.for_each(|(to, number)| *to = number);
        Ok(fields.kind().unwrap_or(Manoeuvre::Rest { duration_s: self.duration_s }))
    }

    fn sinusoids(&self) -> Result<Sinusoids, CallError> {
        const NOT_USED: Rule = Rule::Zero(": this manoeuvre does not use it");
        let mut sinusoids = Sinusoids::default();
        let mut count = 0;
        if self.kind == SINS_MANOEUVRE_SINUSOIDS {
            check_integer("manoeuvre.sinusoid_count", self.sinusoid_count, 1, MAX_SINUSOIDS as u64)?;
            count = self.sinusoid_count as usize;
        } else if self.sinusoid_count != 0 {
            return Err(Error::invalid("manoeuvre.sinusoid_count", self.sinusoid_count, NOT_USED).into());
        }
        for i in 0..count {
            sinusoids.push(Sinusoid {
                channel: Channel::of("manoeuvre.channel", self.channel[i])?,
                amplitude: self.amplitude[i],
                frequency_hz: self.frequency_hz[i],
                phase_rad: self.phase_rad[i],
            });
        }
        for i in count..MAX_SINUSOIDS {
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
        Ok(sinusoids)
    }
}
