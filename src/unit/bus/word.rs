//! One word of ARINC 429: label, source, data, status and parity.
//!
//! ```text
//! bits 1-8 label, 9-10 source or data, 11-29 data, 30-31 status, 32 odd parity
//! ```
//!
//! ARINC 429 numbers the bits in the order in which they are sent: bit 1 is the most significant of the label. The lowest byte of the
//! integer is the number of the label, so bits 1 to 8 are its bits 7 to 0; bit n from 9 on is bit n - 1 of the integer.

use crate::base::error::{Error, check_integer};

/// How a number stands in the data bits. Bits are those of the integer, from 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Format {
    /// Binary, two's complement.
    Binary {
        /// Lowest bit; the highest is the sign, bit 28.
        lowest: u32,
        /// Whether the value is an angle that wraps at the end of its range.
        wraps: bool,
    },
    /// Decimal digits, the highest first. The sign is in the status.
    Decimal(&'static [Digit]),
    /// Single bits.
    Bits,
}

/// A decimal digit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Digit {
    /// Lowest bit.
    pub lowest: u32,
    /// Number of bits.
    pub bits: u32,
    /// Weight, in units of the resolution.
    pub weight: i64,
    /// Greatest value.
    pub most: i64,
}

impl Digit {
    const fn of(self, word: u32) -> i64 {
        (word >> self.lowest & ((1 << self.bits) - 1)) as i64
    }
}

/// Statuses of a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WordStatus {
    /// The value is valid.
    #[default]
    Normal = 0,
    /// There is no value.
    NoComputedData = 1,
    /// The equipment is in its test.
    FunctionalTest = 2,
    /// The equipment has failed. A decimal word has no such status: it then says "no computed data".
    FailureWarning = 3,
    /// The status bits say normal, but the data are no value of the label: a decimal digit above its greatest value, or a value out of
    /// the range of the quantity. No word is encoded so.
    IllegalValue = 4,
}

/// The status bits of a normal decimal number below zero.
const NEGATIVE: u32 = 3;

/// The statuses of the status bits 0 to 3.
fn statuses(format: &Format) -> [WordStatus; 4] {
    use WordStatus::{FailureWarning, FunctionalTest, NoComputedData, Normal};
    match format {
        Format::Binary { .. } => [FailureWarning, NoComputedData, FunctionalTest, Normal],
        Format::Decimal(_) => [Normal, NoComputedData, FunctionalTest, Normal],
        Format::Bits => [Normal, NoComputedData, FunctionalTest, FailureWarning],
    }
}

/// The status bits of a status; 1, no computed data, where the format does not have it.
fn code(format: &Format, status: WordStatus) -> u32 {
    statuses(format).iter().position(|own| *own == status).map_or(1, |place| place as u32)
}

const SIGN: u32 = 28;
const STATUS: u32 = 29;
const PARITY: u32 = 31;
/// Bits for data, with those of the source.
const DATA: u32 = 0x1fff_ff00;

/// The least and the greatest number of the format, in units of the resolution.
pub fn limits(format: &Format) -> (i64, i64) {
    match *format {
        Format::Binary { lowest, .. } => (-(1 << (SIGN - lowest)), (1 << (SIGN - lowest)) - 1),
        Format::Decimal(digits) => {
            let most: i64 = digits.iter().map(|digit| digit.weight * digit.most).sum();
            (-most, most)
        }
        Format::Bits => (0, i64::from(DATA >> 10)),
    }
}

/// Bits of a number within the limits of the format, and whether the status has its sign.
fn bits_of(format: &Format, steps: i64) -> (u32, bool) {
    match *format {
        Format::Binary { lowest, .. } => ((steps << lowest) as u32 & DATA, false),
        Format::Decimal(digits) => {
            let (mut rest, mut word) = (steps.abs(), 0);
            for digit in digits {
                let value = (rest / digit.weight).min(digit.most);
                rest -= value * digit.weight;
                word |= (value as u32) << digit.lowest;
            }
            (word, steps < 0)
        }
        Format::Bits => ((steps << 10) as u32 & DATA, false),
    }
}

/// The word with the label `number`: `steps` is the value in units of the resolution. A word that needs the bits of the source for
/// its data has no source.
pub fn encode(number: u8, format: &Format, source: u32, steps: i64, status: WordStatus) -> u32 {
    let (data, is_negative) = if status == WordStatus::Normal { bits_of(format, steps) } else { (0, false) };
    let needs_source_bits = match *format {
        Format::Binary { lowest, .. } => lowest < 10,
        Format::Decimal(digits) => digits.iter().any(|digit| digit.lowest < 10),
        Format::Bits => false,
    };
    let code = if is_negative { NEGATIVE } else { code(format, status) };
    let source = if needs_source_bits { 0 } else { (source & 3) << 8 };
    let word = u32::from(number) | source | data | code << STATUS;
    word | u32::from(has_even_parity(word)) << PARITY
}

pub fn has_even_parity(word: u32) -> bool {
    word.count_ones().is_multiple_of(2)
}

/// What the status bits of a word say.
pub fn status(format: &Format, word: u32) -> WordStatus {
    statuses(format)[(word >> STATUS & 3) as usize]
}

/// Value of a word in units of the resolution. The error: a digit, counted from 0, is above its greatest value.
pub fn steps(format: &Format, word: u32) -> Result<i64, Error> {
    match *format {
        Format::Binary { lowest, .. } => {
            // The sign becomes the highest bit, and is repeated by the shift to the right.
            Ok(i64::from((word << (31 - SIGN)) as i32 >> (31 - SIGN + lowest)))
        }
        Format::Decimal(digits) => {
            let mut sum = 0;
            for (index, digit) in digits.iter().enumerate() {
                let value = digit.of(word);
                check_integer("digit", value as u64, 0, digit.most as u64)
                    .map_err(|error| error.at(index))?;
                sum += value * digit.weight;
            }
            Ok(if word >> STATUS & 3 == NEGATIVE { -sum } else { sum })
        }
        Format::Bits => Ok(i64::from((word & DATA) >> 10)),
    }
}

/// The word with its label bits in the other order.
pub fn reversed(word: u32) -> u32 {
    word & !0xff | u32::from((word as u8).reverse_bits())
}

/// For the model checker Kani, as in `abi::boundary::key`. Untried.
#[cfg(kani)]
mod proofs {
    use super::super::table::LABELS;
    use super::*;

    /// Every word of each label: a digit is rejected, or the number is within the limits, and its own word says it again.
    #[kani::proof]
    #[kani::unwind(8)]
    fn every_word_of_each_label_is_read_or_rejected() {
        let place: usize = kani::any();
        let word: u32 = kani::any();
        kani::assume(place < LABELS.len());
        let format = &LABELS[place].format;
        let Ok(found) = steps(format, word) else { return };
        let (low, high) = limits(format);
        assert!(low <= found && found <= high);
        let again = encode(LABELS[place].number, format, 0, found, WordStatus::Normal);
        assert!(steps(format, again) == Ok(found) && status(format, again) == WordStatus::Normal);
        assert!(again as u8 == LABELS[place].number && !has_even_parity(again));
    }
}
