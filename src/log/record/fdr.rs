//! Flight data recorder files of X-Plane (FDR), version 4: keywords, then rows of time, longitude, latitude, altitude, heading, pitch,
//! roll, and of what the keywords DREF name, which is compared with what flies.

use super::FlightRecord;
use crate::base::text::excerpt;
use crate::log::quantity::{SPEED, TRACK};
use crate::log::unread::{MOST, Unread};
use crate::log::{Clock, LogError, LogMapping, TimeFormat, fault};

/// Columns of a row behind its time.
const COLUMNS: [&str; 6] = ["longitude", "latitude", "altitude", "magnetic heading", "pitch", "roll"];

/// Names of datarefs whose names do not say the quantity and its unit. The climb stands behind the track.
const DATAREFS: [(&str, usize, &str); 4] = [
    ("groundspeed", SPEED, "m/s"),
    ("hpath", TRACK, "deg"),
    ("vh_ind", TRACK + 1, "m/s"),
    ("vh_ind_fpm", TRACK + 1, "ft/min"),
];

/// Metres of a foot.
const FOOT_M: f64 = 0.3048;

/// The rows of a text.
pub fn record(text: &str) -> Result<FlightRecord, LogError> {
    // The first line says how lines end.
    let mut lines = text.lines().map(str::trim).zip(1..).skip(1).filter(|(line, _)| !line.is_empty());
    let (version, line) = lines.next().unwrap_or(("", 2));
    if version.split_whitespace().next() != Some("4") {
        let what =
            "expected version 4, whose rows are time, longitude, latitude, altitude, heading, pitch, roll";
        return Err(fault(line, 1, format!("FDR version {}: {what}", excerpt(version))));
    }
    let is_row = |line: &str| line.starts_with(|letter: char| letter.is_ascii_digit());
    let mut rows = FlightRecord::new(&[
        "time_s",
        "latitude_deg",
        "longitude_deg",
        "height_m",
        "roll_deg",
        "pitch_deg",
        "heading_deg",
    ]);
    let mut clock: Option<Clock> = None;
    // The number of each dataref that is compared, from 0.
    let (mut compared, mut datarefs) = (Vec::new(), 0);
    for (row, line) in lines {
        let after = row.get(..4).filter(|key| key.eq_ignore_ascii_case("DREF")).map(|_| &row[4..]);
        let named = after.filter(|rest| rest.starts_with([',', ' ', '\t']) && rows.count() == 0);
        if let Some(text) = named.map(|rest| rest.trim_start_matches([',', ' ', '\t'])) {
            if let Some(of) =
                dataref(text, rows.names.len() + compared.len()).filter(|_| compared.len() < MOST)
            {
                rows.beside.push(of);
                compared.push(datarefs);
            }
            datarefs += 1;
        }
        if !is_row(row) {
            continue;
        }
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
        let more: Vec<&str> = cells.take(datarefs).collect();
        let number = |of: &usize| more.get(*of).and_then(|cell| cell.parse().ok()).unwrap_or(f64::NAN);
        let beside: Vec<f64> = compared.iter().map(number).collect();
        let row = [time_s, latitude, longitude, altitude_ft * FOOT_M, roll, pitch, heading];
        rows.push(line, &row, &beside)?;
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

/// The column of a dataref: its name, and a factor that is 1, since another one may be to the unit or from it; `None`: it is none of the
/// motion.
fn dataref(text: &str, place: usize) -> Option<Unread> {
    let before_comment = text.split("//").next().unwrap_or(text);
    let mut words = before_comment.split([',', ' ', '\t']).filter(|word| !word.is_empty());
    let (path, factor) = (words.next()?, words.next()?.parse::<f64>().ok()?);
    let name = path.rsplit('/').next().filter(|_| factor == 1.0)?;
    let defined = DATAREFS.iter().find(|(known, ..)| *known == name);
    match defined {
        Some((_, quantity, unit)) => Some(Unread::defined(place, name, *quantity, unit)),
        None => Unread::of_name(place, name),
    }
}
