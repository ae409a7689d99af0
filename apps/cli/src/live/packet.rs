//! A datagram that a flight simulator sent: a sample, or the reason why it is none.

use sins::truth::FlightSample;

use super::{foreign, json, native, text};

/// Formats of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// FlightGear's native FDM packet, which JSBSim sends too
    Fgfs,
    /// A line of text:
    /// time_s,latitude_deg,longitude_deg,height_m,velocity_east_m_s,velocity_north_m_s,velocity_up_m_s,roll_deg,pitch_deg,heading_deg
    Generic,
    /// A JSON object with those ten keys
    Json,
}

impl Format {
    /// Whether packets carry their time.
    pub fn has_time(self) -> bool {
        self != Self::Fgfs
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Fgfs => "fgfs",
            Self::Generic => "generic",
            Self::Json => "json",
        }
    }

    /// Whether a datagram has this format.
    pub fn is(self, datagram: &[u8]) -> bool {
        self.parse(datagram).is_ok()
    }

    /// The sample in a datagram. Its time stamp is 0 if packets carry none.
    pub fn decode(self, datagram: &[u8]) -> Result<FlightSample, Refused> {
        self.parse(datagram).map_err(|refused| match refused.why {
            Why::Length | Why::Version | Why::Syntax => {
                foreign::recognized(datagram, self).unwrap_or(refused)
            }
            _ => refused,
        })
    }

    fn parse(self, datagram: &[u8]) -> Result<FlightSample, Refused> {
        match self {
            Self::Fgfs => native::decode(datagram),
            Self::Generic => text::decode(datagram),
            Self::Json => json::decode(datagram),
        }
    }
}

/// Why a packet is not flown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Why {
    Address,
    Length,
    Version,
    Syntax,
    Foreign,
    NotANumber,
    Range,
    Late,
    Period,
    Jump,
}

impl Why {
    pub const ALL: [Self; 10] = [
        Self::Address,
        Self::Length,
        Self::Version,
        Self::Syntax,
        Self::Foreign,
        Self::NotANumber,
        Self::Range,
        Self::Late,
        Self::Period,
        Self::Jump,
    ];

    pub fn words(self) -> &'static str {
        match self {
            Self::Address => "from another address",
            Self::Length => "of another length",
            Self::Version => "of another version",
            Self::Syntax => "not of the format",
            Self::Foreign => "of another kind",
            Self::NotANumber => "with NaN or infinity",
            Self::Range => "out of range",
            Self::Late => "late or repeated",
            Self::Period => "off the sample period",
            Self::Jump => "with a jump",
        }
    }
}

/// A packet that is not flown: the reason, and a sentence about this packet.
#[derive(Debug, Clone, PartialEq)]
pub struct Refused {
    pub why: Why,
    pub sentence: String,
}

impl Refused {
    pub fn new(why: Why, sentence: impl Into<String>) -> Self {
        Self { why, sentence: sentence.into() }
    }

    /// A number of a packet that is none.
    pub fn not_a_number(name: &str, value: f64) -> Self {
        Self::new(Why::NotANumber, format!("{name} = {value}: must be a finite number"))
    }
}
