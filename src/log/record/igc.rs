//! Flight records in the format of the International Gliding Commission (IGC): a fix in each B record.

use std::ops::Range;

use super::{FlightRecord, left_out};
use crate::base::memory::room_for_one_more;
use crate::base::text::excerpt;
use crate::log::quantity::{SPEED, TRACK};
use crate::log::unread::Unread;
use crate::log::{Clock, LogError, LogMapping, TimeFormat, fault};

/// The columns of a B record, from 0.
const TIME: Range<usize> = 1..7;
const LATITUDE: Range<usize> = 7..15;
const LONGITUDE: Range<usize> = 15..24;
const VALIDITY: Range<usize> = 24..25;
const PRESSURE: Range<usize> = 25..30;
const GNSS: Range<usize> = 30..35;

/// What extensions of B records add that is used.
#[derive(Default)]
struct Extensions {
    /// Columns of further digits of the latitude, the longitude and the seconds; empty: a B record has none.
    digits: [Range<usize>; 3],
    /// Columns of the speed over ground and the true track; empty: a B record has none.
    motion: [Range<usize>; 2],
}

impl Extensions {
    /// Their names in an I record.
    const DIGITS: [&str; 3] = ["LAD", "LOD", "TDS"];
    const MOTION: [&str; 2] = ["GSP", "TRT"];

    /// Those of an I record: behind the number of extensions each has its first and last column, from 1, and its name.
    fn of(record: &str) -> Self {
        let mut all = Self::default();
        let extensions = record.as_bytes().get(3..).unwrap_or_default().chunks_exact(7);
        for extension in extensions.filter_map(|bytes| std::str::from_utf8(bytes).ok()) {
            let place = |columns| extension.get(columns).and_then(|text: &str| text.parse::<usize>().ok());
            let (Some(first @ 1..), Some(last)) = (place(0..2), place(2..4)) else { continue };
            let is_it = |name: &&str| extension.ends_with(name);
            if let Some(known) = Self::DIGITS.iter().position(is_it) {
                all.digits[known] = first - 1..last;
            } else if let Some(known) = Self::MOTION.iter().position(is_it) {
                all.motion[known] = first - 1..last;
            }
        }
        all
    }

    /// The digits of each in a B record; empty: it has none.
    fn texts<'r>(&self, record: &'r str) -> [&'r str; 3] {
        let text = |columns: &Range<usize>| record.get(columns.clone()).filter(|text| whole(text).is_some());
        [0, 1, 2].map(|known| text(&self.digits[known]).unwrap_or_default())
    }

    /// Speed over ground [km/h] and true track [deg] of a B record; NaN: it has none. Others than of three digits are whole
    /// numbers in some recorders and hundredths in others.
    fn motion(&self, record: &str) -> [f64; 2] {
        self.motion.clone().map(|columns| {
            let text = record.get(columns).unwrap_or_default();
            whole(text).filter(|_| text.len() == 3).unwrap_or(f64::NAN)
        })
    }

    /// The columns of the motion, behind those of these names.
    fn columns(names: &[&str]) -> Vec<Unread> {
        let [speed, track] = Self::MOTION;
        let place = names.len();
        vec![Unread::defined(place, speed, SPEED, "km/h"), Unread::defined(place + 1, track, TRACK, "deg")]
    }
}

/// A position in three dimensions.
struct Fix {
    line: u64,
    time_s: f64,
    latitude_deg: f64,
    longitude_deg: f64,
    pressure_m: f64,
    /// Height above the ellipsoid; `None`: 0 or no number.
    gnss_m: Option<f64>,
    /// Speed over ground [km/h] and true track [deg]; NaN: none.
    motion: [f64; 2],
}

/// The rows of a text.
pub fn record(text: &str) -> Result<FlightRecord, LogError> {
    let mut clock = Clock::new(&LogMapping { time_format: TimeFormat::Hms, ..LogMapping::default() });
    let (mut fixes, mut without_position, mut extensions) = (Vec::new(), 0, Extensions::default());
    // Records that are cut: how many, the line of the first, and its length.
    let mut cut: Option<(u64, u64, usize)> = None;
    let mut gnss_above = "above the ellipsoid";
    for (record, line) in text.split('\n').zip(1..) {
        if record.starts_with('I') {
            extensions = Extensions::of(record.trim_end_matches('\r'));
        }
        // HFALG: what GNSS heights are above.
        if record.starts_with("HFALG") && record.contains("GEO") {
            gnss_above = "above the geoid, as the record says: set log.geoid if it matters";
        }
        if !record.starts_with('B') {
            continue;
        }
        let record = record.trim_end_matches('\r');
        if record.len() < GNSS.end {
            cut.get_or_insert((0, line, record.len())).0 += 1;
            continue;
        }
        match fix(record, line, &extensions, &mut clock) {
            Ok(Some(fix)) => {
                room_for_one_more(&mut fixes).map_err(LogError::Memory)?;
                fixes.push(fix);
            }
            Ok(None) => without_position += 1,
            Err(sentence) => return Err(fault(line, 1, format!("B record: {sentence}"))),
        }
    }
    // One that the logger has not written to its end is lost; if most are so, the file is another.
    let (count_cut, first_cut, found) = cut.unwrap_or_default();
    if count_cut >= fixes.len().max(1) as u64 {
        let least = GNSS.end;
        let sentence = format!("B record: expected at least {least} characters, found {found}");
        return Err(fault(first_cut, 1, sentence));
    }
    if fixes.is_empty() {
        let what = "no fix: expected B records with the validity A, found";
        return Err(fault(0, 1, format!("{what} {without_position} with V")));
    }
    let mut rows =
        FlightRecord::new(&["time_s", "latitude_deg", "longitude_deg", "height_m", "pressure_height_m"]);
    rows.beside = Extensions::columns(rows.names);
    let without_gnss = fixes.iter().filter(|fix| fix.gnss_m.is_none()).count() as u64;
    // The path has no step where GNSS heights begin or end.
    let above = |fix: &Fix| fix.gnss_m.map(|gnss_m| gnss_m - fix.pressure_m);
    let mut above_m = fixes.iter().find_map(above).unwrap_or(0.0);
    for fix in &fixes {
        above_m = above(fix).unwrap_or(above_m);
        let Fix { line, time_s, latitude_deg, longitude_deg, pressure_m, motion, .. } = *fix;
        let row = [time_s, latitude_deg, longitude_deg, pressure_m + above_m, pressure_m];
        rows.push(line, &row, &motion)?;
    }
    let heights = match without_gnss {
        0 => format!("heights of GNSS, {gnss_above}"),
        all if all == rows.count() => {
            "pressure altitudes as heights, because those of GNSS are 0 or missing".to_owned()
        }
        some => format!(
            "heights of GNSS, {gnss_above}; {some} of them are 0 or missing: there the change of the pressure altitude continues them"
        ),
    };
    let of_cut = match count_cut {
        1 => format!("cut before its end (line {first_cut})"),
        _ => format!("cut before their ends (the first: line {first_cut})"),
    };
    let left_out = left_out(&[(without_position, "without a position (V)"), (count_cut, &of_cut)]);
    rows.note = format!("IGC record, {} fixes {}: {heights}{left_out}", rows.count(), rows.spacing());
    Ok(rows)
}

/// The fix of a B record with all its columns; `None`: its validity is V.
fn fix(record: &str, line: u64, extensions: &Extensions, clock: &mut Clock) -> Result<Option<Fix>, String> {
    let field = |name: &str, columns: Range<usize>, expected: &str| {
        let text = record.get(columns).unwrap_or(record);
        (text, format!("{name}: expected {expected}, found \"{}\"", excerpt(text)))
    };
    match field("validity", VALIDITY, "A or V") {
        ("A", _) => {}
        ("V", _) => return Ok(None),
        (_, sentence) => return Err(sentence),
    }
    let [of_latitude, of_longitude, of_time] = extensions.texts(record);
    let (text, sentence) = field("time", TIME, "HHMMSS");
    let time_s = whole(text).and_then(|_| clock.next(&format!("{text}.{of_time}"))).ok_or(sentence)?;
    let (text, sentence) = field("latitude", LATITUDE, "DDMMmmmN or DDMMmmmS, at most 90 degrees");
    let latitude_deg = angle(text, of_latitude, 90.0, ['N', 'S']).ok_or(sentence)?;
    let (text, sentence) = field("longitude", LONGITUDE, "DDDMMmmmE or DDDMMmmmW, at most 180 degrees");
    let longitude_deg = angle(text, of_longitude, 180.0, ['E', 'W']).ok_or(sentence)?;
    let (text, sentence) = field("pressure altitude", PRESSURE, "five digits [m]");
    let pressure_m = height(text).ok_or(sentence)?;
    let (text, sentence) = field("GNSS altitude", GNSS, "five digits [m]");
    let is_missing = text.chars().all(|letter| matches!(letter, ' ' | '-'));
    let gnss_m = if is_missing { 0.0 } else { height(text).ok_or(sentence)? };
    let gnss_m = (gnss_m != 0.0).then_some(gnss_m);
    let motion = extensions.motion(record);
    Ok(Some(Fix { line, time_s, latitude_deg, longitude_deg, pressure_m, gnss_m, motion }))
}

/// A number of digits alone.
fn whole(text: &str) -> Option<f64> {
    text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok()).flatten()
}

/// A height [m], which may be negative.
fn height(text: &str) -> Option<f64> {
    match text.strip_prefix('-') {
        Some(digits) => whole(digits).map(|size| -size),
        None => whole(text),
    }
}

/// An angle [deg] of degrees, of minutes and thousandths in five digits, and of the letter of its side; `more` has further digits.
fn angle(text: &str, more: &str, largest_deg: f64, [positive, negative]: [char; 2]) -> Option<f64> {
    let (digits, sign) = match (text.strip_suffix(positive), text.strip_suffix(negative)) {
        (Some(digits), _) => (digits, 1.0),
        (None, Some(digits)) => (digits, -1.0),
        (None, None) => return None,
    };
    let (degrees, minutes) = digits.split_at_checked(digits.len().checked_sub(5)?)?;
    let thousandths = whole(minutes).and_then(|_| format!("{minutes}.{more}").parse::<f64>().ok())?;
    let angle_deg = (whole(degrees)? * 60_000.0 + thousandths) / 60_000.0;
    (thousandths < 60_000.0 && angle_deg <= largest_deg).then_some(sign * angle_deg)
}
