//! Flight data recorder files of X-Plane (FDR), version 4: keywords, then rows of time, longitude, latitude, altitude, heading, pitch,
//! roll, and of what the keywords DREF name.

use super::Record;
use crate::base::text::excerpt;
use crate::log::{Clock, LogError, LogMapping, TimeFormat, fault};

/// Columns of a row behind its time.
const COLUMNS: [&str; 6] = ["longitude", "latitude", "altitude", "magnetic heading", "pitch", "roll"];

/// Metres of a foot.
const FOOT_M: f64 = 0.3048;

/// The rows of a text.
pub fn record(text: &str) -> Result<Record, LogError> {
    // The first line says how lines end.
    let mut lines = text.lines().map(str::trim).zip(1..).skip(1).filter(|(line, _)| !line.is_empty());
    let (version, line) = lines.next().unwrap_or(("", 2));
    if version.split_whitespace().next() != Some("4") {
        let what =
            "expected version 4, whose rows are time, longitude, latitude, altitude, heading, pitch, roll";
        return Err(fault(line, 1, format!("FDR version {}: {what}", excerpt(version))));
    }
    let is_row = |line: &str| line.starts_with(|letter: char| letter.is_ascii_digit());
    let mut rows = Record::new(&[
        "time_s",
        "latitude_deg",
        "longitude_deg",
        "height_m",
        "roll_deg",
        "pitch_deg",
        "heading_deg",
    ]);
    let mut clock: Option<Clock> = None;
    for (row, line) in lines.filter(|(line, _)| is_row(line)) {
        let mut cells = row.split(',').map(str::trim);
        let time = cells.next().unwrap_or_default();
        let clock = clock.get_or_insert_with(|| {
            let time_format = if time.contains(':') { TimeFormat::Hms } else { TimeFormat::Number };
            Clock::new(&LogMapping { time_format, ..LogMapping::default() })
        });
        let expected = |name: &str, what: &str, found: &str| {
            fault(line, 1, format!("{name}: expected {what}, found \"{}\"", excerpt(found)))
        };
        let time_s = clock.next(time).ok_or_else(|| expected("zulu time", clock.expected(), time))?;
        let mut values = [0.0; COLUMNS.len()];
        for (name, value) in COLUMNS.into_iter().zip(&mut values) {
            let ends = || fault(line, 1, format!("the line ends before the {name}"));
            let cell = cells.next().ok_or_else(ends)?;
            let number = cell.parse().ok().filter(|number: &f64| number.is_finite());
            *value = number.ok_or_else(|| expected(name, "a finite number", cell))?;
        }
        let [longitude, latitude, altitude_ft, heading, pitch, roll] = values;
        rows.push(line, [time_s, latitude, longitude, altitude_ft * FOOT_M, roll, pitch, heading])?;
    }
    if rows.count() == 0 {
        let what = "no rows behind the keywords: expected time, longitude, latitude and so on";
        return Err(fault(0, 1, what.to_owned()));
    }
    let headings = "headings are magnetic, with the variation 0 unless log.variation sets it";
    let heights = "altitudes are above the sea, with the geoid 0 m unless log.geoid sets it";
    let (count, spacing) = (rows.count(), rows.spacing());
    rows.note = format!("FDR record, {count} rows {spacing}: {headings}; {heights}");
    Ok(rows)
}
