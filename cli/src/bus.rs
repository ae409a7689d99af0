//! `sins bus`: the words of ARINC 429 that `sins fly --bus` writes.

use sins::bus::{Format, LABELS, Label, WordStatus, decode, reversed};

use crate::failure::Failure;
use crate::terminal::print;

/// Lists the labels of the words that a unit sends, or decodes words
#[derive(Debug, clap::Subcommand)]
pub enum Order {
    /// Lists the labels: number, quantity, unit, resolution, range, interval
    Labels,
    /// Decodes words in hexadecimal: label, quantity, value, unit, status
    Decode {
        /// The words, as e40000c8
        #[arg(required = true, value_name = "WORD")]
        words: Vec<String>,
        /// The label bits are reversed, as many cards take them
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
        let Label { number, name, unit, .. } = label;
        format!("| {number:03o} | {name} | {unit} | {} | {interval} |\n", format_of(label))
    });
    "| label | quantity | unit | data | interval |\n|---|---|---|---|---|\n".to_owned()
        + &rows.collect::<String>()
}

fn format_of(label: &Label) -> String {
    let resolution = label.resolution;
    match label.format {
        Format::Binary { bits, is_signed, .. } => {
            let range = resolution * (1_u64 << (bits - u32::from(is_signed))) as f64;
            let sign = if is_signed { "±" } else { "" };
            format!("binary, {bits} bits{}, {sign}{range}", if is_signed { " with sign" } else { "" })
        }
        Format::Decimal(digits) => format!("{} decimal digits, {resolution:.4}", digits.len()),
        Format::Bits => "single bits".to_owned(),
    }
}

fn decoded(text: &str, is_reversed: bool) -> Result<String, Failure> {
    let bits = u32::from_str_radix(text.trim_start_matches("0x"), 16);
    let bits =
        bits.map_err(|_| Failure::new(format!("{text}: expected a word of up to 8 hexadecimal digits")))?;
    let bits = if is_reversed { reversed(bits) } else { bits };
    let found = decode(bits).ok_or_else(|| {
        Failure::new(format!("{text}: has an even parity, or a label that the table does not have"))
    })?;
    let Label { number, name, unit, .. } = found.label;
    Ok(format!("{number:03o} {name} {} {unit} {}", value(found.label, found.value), status(found.status)))
}

/// A value with the digits of its resolution.
pub fn value(label: &Label, value: f64) -> String {
    let digits = (0..9).find(|digits| label.resolution * 10_f64.powi(*digits) >= 1.0).unwrap_or(9);
    format!("{value:.0$}", digits as usize)
}

pub fn status(status: WordStatus) -> &'static str {
    match status {
        WordStatus::Normal => "normal",
        WordStatus::NoComputedData => "no-computed-data",
        WordStatus::FunctionalTest => "functional-test",
        WordStatus::FailureWarning => "failure-warning",
    }
}
