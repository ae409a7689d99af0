//! What was found as a table for the terminal.

use nalgebra::Matrix3;
use sins::analysis::identify::sheet::{AXES, Sheet, sheets};
use sins::analysis::identify::text::{axes, of_noise, seen, with_interval};
use sins::analysis::identify::{Estimate, Identified};
use sins::units::{DEG, DEG_PER_HOUR, STANDARD_GRAVITY as G};

use super::record::SensorRecord;
use crate::given::Given;
use crate::units::{significant, time_text};

/// Shift of a clock that is set by that of the path [s].
const CLOSE_S: f64 = 10.0;

/// The table.
pub fn text(given: &Given, record: &SensorRecord, found: &Identified) -> String {
    let [first, others @ ..] = head(given, record, found);
    let mut text = format!("{first}\n\n{}\n", others.join("\n"));
    for sheet in sheets(found) {
        text += &format!("\n{}\n", sheet.section);
        text += &section(&sheet);
    }
    text
}

/// The record, its columns, its clock and its axes, a line each.
pub fn head(given: &Given, record: &SensorRecord, found: &Identified) -> [String; 5] {
    let rate = significant(1.0 / record.interval_s);
    let used = time_text(found.blocks as f64 * found.block_s);
    let sensed = found.left_g_sensitivity.map(|size| {
        format!(
            "the gyros have a g-sensitivity of about {} °/h/g, which is taken for misalignments (--also g-sensitivity)",
            significant(size * G / DEG_PER_HOUR)
        )
    });
    let remarks: String = record.remarks.iter().chain(&sensed).map(|remark| format!("; {remark}")).collect();
    let is_taken = !found.axes.is_seen && found.axes.exchange == Matrix3::identity();
    let option = if is_taken { " (--axes)" } else { "" };
    let turned: Vec<String> = found
        .mounting
        .iter()
        .zip(AXES)
        .map(|(angle, axis)| format!("{axis} {}", with_interval(angle, DEG, "°")))
        .collect();
    [
        format!(
            "{}: {} rows at {rate} Hz{} along {}, {used} identified{remarks}; 95 % intervals",
            record.name,
            record.increments.len(),
            record.counted,
            given.name
        ),
        format!("columns: {}", record.columns.join(", ")),
        format!("clock: {}", clock(record, found)),
        format!("axes: {}{option}", axes(&found.axes.exchange, found.axes.is_seen)),
        format!("turned beside them about {}", turned.join(", ")),
    ]
}

fn section(sheet: &Sheet) -> String {
    let mut text = String::new();
    for line in sheet.fitted() {
        text += &format!("  {:<18} {}\n", line.name, seen(line));
    }
    for noise in &sheet.noises {
        text += &format!("  {:<18} {}\n", noise.name, of_noise(noise));
    }
    text
}

fn clock(record: &SensorRecord, found: &Identified) -> String {
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
        true => format!(", drift {}", with_interval(&found.drift, 1e-6, "ppm")),
        false => String::new(),
    };
    let shift = Estimate { value: offset_s, ..found.offset_s };
    format!("{} {side} the path{samples}{drift}", with_interval(&shift, si, unit))
}
