//! One word of ARINC 429: label, source, data, status and parity.
//!
//! ```text
//! bits 1-8 label, 9-10 source or data, 11-29 data, 30-31 status, 32 odd parity; bit 1 is the lowest of the integer
//! ```

/// How a number stands in the data bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Format {
    /// Binary, two's complement if signed. The lowest bit, counted from 0, and the number of bits with the sign.
    Binary {
        /// Lowest bit, from 0.
        lowest: u32,
        /// Number of bits, with the sign.
        bits: u32,
        /// Whether the highest bit is a sign.
        is_signed: bool,
        /// Whether the value is an angle that wraps at the end of its range.
        wraps: bool,
    },
    /// Decimal digits: lowest bit, number of bits and weight, in units of the resolution; the highest first. The sign is in the status.
    Decimal(&'static [(u32, u32, u64)]),
    /// Single bits.
    Bits,
}

/// Statuses of a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WordStatus {
    /// The value is valid.
    #[default]
    Normal,
    /// There is no value.
    NoComputedData,
    /// The equipment is in its test.
    FunctionalTest,
    /// The equipment has failed. A decimal word has no such status: it then says "no computed data".
    FailureWarning,
}

impl WordStatus {
    const ALL: [Self; 4] = [Self::Normal, Self::NoComputedData, Self::FunctionalTest, Self::FailureWarning];
}

/// The status bits of a normal decimal number below zero.
const NEGATIVE: u32 = 3;

/// The status bits of each status, in the order of `WordStatus`.
fn codes(format: &Format) -> [u32; 4] {
    match format {
        Format::Binary { .. } => [3, 1, 2, 0],
        Format::Decimal(_) => [0, 1, 2, 1],
        Format::Bits => [0, 1, 2, 3],
    }
}

const STATUS: u32 = 29;
const PARITY: u32 = 31;
/// Bits for data, with those of the source.
const DATA: u32 = 0x1fff_ff00;

/// Bits of a number, saturated at the ends of its range; whether it is negative.
fn bits_of(format: &Format, steps: f64) -> (u32, bool) {
    match *format {
        Format::Binary { lowest, bits, is_signed, wraps } => {
            let span = 1_i64 << bits;
            let (low, high) = if is_signed { (-span / 2, span / 2 - 1) } else { (0, span - 1) };
            let count = (steps + 0.5).floor() as i64;
            let count = if wraps { count } else { count.clamp(low, high) };
            (((count & (span - 1)) as u32) << lowest, false)
        }
        Format::Decimal(digits) => {
            let most: u64 =
                digits.iter().map(|(_, bits, weight)| weight * ((1_u64 << bits) - 1).min(9)).sum();
            let mut rest = ((steps.abs() + 0.5).floor() as u64).min(most);
            let mut word = 0;
            for &(lowest, bits, weight) in digits {
                let digit = (rest / weight).min(((1 << bits) - 1).min(9));
                rest -= digit * weight;
                word |= (digit as u32) << lowest;
            }
            (word, steps < 0.0)
        }
        Format::Bits => ((steps as u32) << 10 & DATA, false),
    }
}

/// The word with the label `number`: `steps` is the value in units of the resolution. A word that needs the bits of the source for
/// its data has no source.
pub fn encode(number: u8, format: &Format, source: u32, steps: f64, status: WordStatus) -> u32 {
    let steps = if steps.is_finite() { steps } else { 0.0 };
    let (data, is_negative) = if status == WordStatus::Normal { bits_of(format, steps) } else { (0, false) };
    let needs_source_bits = match *format {
        Format::Binary { lowest, .. } => lowest < 10,
        Format::Decimal(digits) => digits.iter().any(|(lowest, ..)| *lowest < 10),
        Format::Bits => false,
    };
    let code = if is_negative { NEGATIVE } else { codes(format)[status as usize] };
    let source = if needs_source_bits { 0 } else { (source & 3) << 8 };
    let word = u32::from(number) | source | data | code << STATUS;
    let is_even = word.count_ones().is_multiple_of(2);
    word | u32::from(is_even) << PARITY
}

/// Value in units of the resolution, and status, of a word of this format. `None`: its parity is even.
pub fn decode(format: &Format, word: u32) -> Option<(f64, WordStatus)> {
    if word.count_ones().is_multiple_of(2) {
        return None;
    }
    let code = word >> STATUS & 3;
    let place = codes(format).iter().position(|own| *own == code);
    // Only the negative decimal number is not among the codes.
    let status = place.map_or(WordStatus::Normal, |place| WordStatus::ALL[place]);
    let steps = match *format {
        Format::Binary { lowest, bits, is_signed, .. } => {
            let count = i64::from(word >> lowest) & ((1 << bits) - 1);
            let is_negative = is_signed && count >> (bits - 1) != 0;
            (if is_negative { count - (1 << bits) } else { count }) as f64
        }
        Format::Decimal(digits) => {
            let digit = |&(lowest, bits, weight): &(u32, u32, u64)| {
                u64::from(word >> lowest & ((1 << bits) - 1)) * weight
            };
            let count = digits.iter().map(digit).sum::<u64>() as f64;
            if code == NEGATIVE { -count } else { count }
        }
        Format::Bits => f64::from((word & DATA) >> 10),
    };
    Some((steps, status))
}

/// The word with its label bits in the order in which hosts' cards take them: bit 8 first.
pub fn reversed(word: u32) -> u32 {
    word & !0xff | u32::from((word as u8).reverse_bits())
}
