//! `sins bus`: the words of ARINC 429 that `sins fly --bus` writes.

use sins::unit::bus::{Decoded, Format, LABELS, Label, WordStatus, decode, decode_reversed};

use crate::failure::Failure;
use crate::terminal::print;
use crate::units::six_digits;

/// Lists the labels of the words that a unit sends, or decodes words
#[derive(Debug, clap::Subcommand)]
pub enum Order {
    /// Lists the labels: number, quantity, unit, data, resolution, legal range, interval
    Labels,
    /// Decodes words in hexadecimal: label, quantity, value, unit, status, and why a value is illegal
    Decode {
        /// The words, as e40000c8
        #[arg(required = true, value_name = "WORD")]
        words: Vec<String>,
        /// The label bits are reversed: the first bit of the label is the lowest of the word
        #[arg(long)]
        reversed: bool,
    },
}

pub fn run(order: &Order) -> Result<(), Failure> {
    match order {
        Order::Labels => print(&labels()),
        Order::Decode { words, reversed } => {
            let lines = words.iter().map(|word| decoded(word, *reversed)).collect::<Result<Vec<_>, _>>()?;
            print(&(lines.join("\n") + "\n"))
        }
    }
}

/// The table, in Markdown as `docs/bus.md` has it.
fn labels() -> String {
    let rows = LABELS.iter().map(|label| {
        let interval = match label.interval_ms {
            0 => "input".to_owned(),
            interval => format!("{interval} ms"),
        };
        let (data, numbers) = format_of(label);
        let Label { number, name, unit, .. } = label;
        format!("| {number:03o} | {name} | {unit} | {data} | {numbers} | {interval} |\n")
    });
    "| label | quantity | unit | data | resolution | range | interval |\n|---|---|---|---|---|---|---|\n"
        .to_owned()
        + &rows.collect::<String>()
}

/// What the data are; and resolution and range, as two cells.
fn format_of(label: &Label) -> (String, String) {
    let Label { resolution, range: (low, high), .. } = label;
    match label.format {
        Format::Binary { lowest, .. } => (
            format!("binary, {} bits with sign", 29 - lowest),
            format!("{} | {low} to {high}", six_digits(*resolution)),
        ),
        Format::Decimal(digits) => (
            format!("{} decimal digits", digits.len()),
            format!("{} | {low} to {high}", six_digits(*resolution)),
        ),
        Format::Bits => ("single bits".to_owned(), " | ".to_owned()),
    }
}

fn decoded(text: &str, is_reversed: bool) -> Result<String, Failure> {
    let bits = u32::from_str_radix(text.trim_start_matches("0x"), 16);
    let bits =
        bits.map_err(|_| Failure::new(format!("{text}: expected a word of up to 8 hexadecimal digits")))?;
    let found = if is_reversed { decode_reversed(bits) } else { decode(bits) };
    let Decoded { label, value, status, illegal } = found.map_err(|error| Failure::new(error.to_string()))?;
    let Label { number, name, unit, .. } = label;
    let why = illegal.map_or(String::new(), |why| format!(": {why}"));
    Ok(format!("{number:03o} {name} {} {unit} {}{why}", self::value(label, value), self::status(status)))
}

/// A value with the digits of its resolution; "-": none.
pub fn value(label: &Label, value: f64) -> String {
    if value.is_nan() {
        return "-".to_owned();
    }
    let digits = (0..9).find(|digits| label.resolution * 10_f64.powi(*digits) >= 1.0).unwrap_or(9);
    format!("{value:.0$}", digits as usize)
}

pub fn status(status: WordStatus) -> &'static str {
    match status {
        WordStatus::Normal => "normal",
        WordStatus::NoComputedData => "no-computed-data",
        WordStatus::FunctionalTest => "functional-test",
        WordStatus::FailureWarning => "failure-warning",
        WordStatus::IllegalValue => "illegal-value",
    }
}
