//! What was found as a table for the terminal.

use nalgebra::Matrix3;
use sins::analysis::identify::{Estimate, Identified};
use sins::units::DEG;

use super::record::Record;
use super::sheet::{AXES, Line, NoiseLine, Sheet, sheets};
use crate::given::Given;
use crate::units::{significant, time_text, two_digits};

/// Shift of a clock that is set by that of the path [s].
const CLOSE_S: f64 = 10.0;

/// The table.
pub fn text(given: &Given, record: &Record, found: &Identified) -> String {
    let rate = significant(1.0 / record.interval_s);
    let used = time_text(found.blocks as f64 * found.block_s);
    let remarks: String = record.remarks.iter().map(|remark| format!("; {remark}")).collect();
    let mut text = format!(
        "{}: {} rows at {rate} Hz along {}, {used} identified{remarks}; 95 % intervals\n\n",
        record.name,
        record.increments.len(),
        given.name
    );
    text += &format!("columns: {}\n", record.columns.join(", "));
    text += &format!("clock: {}\n", clock(record, found));
    text += &format!("axes: {}\n", axes(&found.axes.exchange, found.axes.is_seen));
    let turned: Vec<String> = found
        .mounting
        .iter()
        .zip(AXES)
        .map(|(angle, axis)| format!("{axis} {}", value(angle, DEG, "°")))
        .collect();
    text += &format!("turned beside them about {}\n", turned.join(", "));
    for sheet in sheets(found) {
        text += &format!("\n{}\n", sheet.sensor);
        text += &section(&sheet);
    }
    text
}

fn section(Sheet { lines, noises, .. }: &Sheet) -> String {
    let mut text = String::new();
    for line in lines {
        text += &format!("  {:<16} {}\n", line.name, seen(line));
    }
    for noise in noises {
        text += &format!("  {:<16} {}\n", noise.name, of_noise(noise));
    }
    text
}

/// A parameter with its interval, or how it could be seen.
pub fn seen(line: &Line) -> String {
    if line.estimate.is_seen() {
        value(&line.estimate, line.unit.si, line.unit.name)
    } else {
        format!("not seen in this motion and noise; {} would show it", line.shown_by)
    }
}

/// A coefficient of noise with its interval.
pub fn of_noise(line: &NoiseLine) -> String {
    let [value, low, high] = [line.estimate.value, line.estimate.low, line.estimate.high]
        .map(|value| significant(value / line.unit.si));
    match line.estimate.low > 0.0 {
        true => format!("{value} ({low} to {high}) {}", line.unit.name),
        false => format!("below {high} {}", line.unit.name),
    }
}

/// A value and half the width of its interval, with the digits that the width has.
fn value(estimate: &Estimate, si: f64, unit: &str) -> String {
    let half = two_digits(1.96 * estimate.sigma / si);
    let decimals = half.split_once('.').map_or(0, |(_, behind)| behind.len());
    format!("{:.decimals$} ± {half} {unit}", estimate.value / si)
}

fn clock(record: &Record, found: &Identified) -> String {
    if !found.offset_s.is_seen() {
        return "not seen in this motion, taken for that of the path; more turns would show it".to_owned();
    }
    let offset_s = found.offset_s.value.abs();
    // Of a clock of its own the number of samples says nothing.
    let (si, unit, samples) = match offset_s < CLOSE_S {
        true => (1e-3, "ms", format!(" ({} samples)", significant(offset_s / record.interval_s))),
        false => (1.0, "s", String::new()),
    };
    let side = if found.offset_s.value < 0.0 { "ahead of" } else { "behind" };
    let drift = match found.drift.is_seen() && found.drift.value.abs() > 1.96 * found.drift.sigma {
        true => format!(", drift {}", value(&found.drift, 1e-6, "ppm")),
        false => String::new(),
    };
    let shift = Estimate { value: offset_s, ..found.offset_s };
    format!("{} {side} the path{samples}{drift}", value(&shift, si, unit))
}

/// The exchange of axes in words.
pub fn axes(exchange: &Matrix3<f64>, is_seen: bool) -> String {
    if *exchange == Matrix3::identity() {
        return match is_seen {
            true => "those of the path".to_owned(),
            false => "taken for those of the path; the motion does not exclude others (--axes)".to_owned(),
        };
    }
    let words: Vec<String> = (0..3)
        .map(|row| {
            let column = (0..3).find(|column| exchange[(row, *column)] != 0.0).unwrap_or(row);
            let reversed = if exchange[(row, column)] < 0.0 { ", reversed" } else { "" };
            format!("{} of the record is {} of the path{reversed}", AXES[row], AXES[column])
        })
        .collect();
    words.join("; ")
}
