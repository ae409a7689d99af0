//! Tracks in the GPS Exchange Format (GPX 1.0 and 1.1): the points of all tracks and segments, in the order of the file.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::{Record, left_out};
use crate::base::memory::{room, room_for_one_more};
use crate::base::text::excerpt;
use crate::log::{Clock, LogError, LogMapping, TimeFormat, fault};

/// Most elements that are open at once, longest name of one, and longest text of a time or a height [bytes].
const MAX_DEPTH: usize = 64;
const MAX_NAME: usize = 256;
const MAX_TEXT: usize = 256;

/// Copies of one name that the reader may have at once.
const QUOTES: usize = 4;

/// A point of a track, while it is read.
#[derive(Default)]
struct Point {
    line: u64,
    latitude_deg: f64,
    longitude_deg: f64,
    /// Texts of its elements; empty: it has none.
    elevation: String,
    time: String,
}

/// A point with its time.
struct Fix {
    line: u64,
    time_s: f64,
    latitude_deg: f64,
    longitude_deg: f64,
    /// Height above the sea; `None`: the point has none.
    elevation_m: Option<f64>,
}

/// The points of a file.
struct Fixes {
    clock: Clock,
    found: Vec<Fix>,
    without_time: u64,
    /// Number of segments that have points.
    segments: u64,
}

/// The rows of a text.
pub fn record(text: &str) -> Result<Record, LogError> {
    // The reader keeps names, and quotes them in its errors.
    drop(room::<u8>(QUOTES * text.len()).map_err(LogError::Memory)?);
    let Fixes { found, without_time, segments, .. } = fixes(text.as_bytes())?;
    if found.is_empty() {
        let what = "no track: expected trkpt with lat, lon and time, found";
        return Err(fault(0, 1, format!("{what} {without_time} without time")));
    }
    let has_elevation = found.iter().any(|fix| fix.elevation_m.is_some());
    let mut rows = Record::new(&["time_s", "latitude_deg", "longitude_deg", "height_m"]);
    let mut without_elevation = 0;
    for Fix { line, time_s, latitude_deg, longitude_deg, elevation_m } in found {
        if has_elevation && elevation_m.is_none() {
            without_elevation += 1;
            continue;
        }
        rows.push(line, [time_s, latitude_deg, longitude_deg, elevation_m.unwrap_or(0.0)])?;
    }
    let heights = if has_elevation {
        "ele is taken as the height above the sea, and the geoid as 0 m unless log.geoid sets it"
    } else {
        "without ele; the height is 0 unless log.height sets it"
    };
    let left_out = left_out(&[(without_time, "without time"), (without_elevation, "without ele")]);
    let (count, spacing) = (rows.count(), rows.spacing());
    let segments = if segments == 1 { "1 segment".to_owned() } else { format!("{segments} segments") };
    rows.note = format!("GPX track, {count} points {spacing} in {segments}: {heights}{left_out}");
    Ok(rows)
}

/// The fixes of all tracks.
fn fixes(file: &[u8]) -> Result<Fixes, LogError> {
    let mut reader = Reader::from_reader(file);
    reader.config_mut().expand_empty_elements = true;
    let clock = Clock::new(&LogMapping { time_format: TimeFormat::Iso, ..LogMapping::default() });
    let mut fixes = Fixes { clock, found: Vec::new(), without_time: 0, segments: 0 };
    let mut point: Option<Point> = None;
    let mut is_in_new_segment = false;
    // Names of the elements that are open.
    let mut open: Vec<String> = Vec::new();
    let (mut line, mut counted_to) = (1, 0);
    loop {
        let at = reader.buffer_position() as usize;
        line += newlines(&file[counted_to..at]);
        counted_to = at;
        let event = reader.read_event().map_err(|error| {
            let at = (reader.error_position() as usize).clamp(counted_to, file.len());
            fault(
                line + newlines(&file[counted_to..at]),
                1,
                format!("expected XML: {}", excerpt(&error.to_string())),
            )
        })?;
        match event {
            Event::Start(element) => {
                if open.len() >= MAX_DEPTH || element.name().as_ref().len() > MAX_NAME {
                    let sentence = format!(
                        "expected at most {MAX_DEPTH} elements in one another, with names of at most {MAX_NAME} bytes"
                    );
                    return Err(fault(line, 1, sentence));
                }
                let name = String::from_utf8_lossy(element.local_name().as_ref()).into_owned();
                if name == "trkseg" {
                    is_in_new_segment = true;
                }
                if name == "trkpt" {
                    fixes.take(point.take())?;
                    fixes.segments += u64::from(core::mem::take(&mut is_in_new_segment));
                    let at = |sentence| fault(line, 1, format!("trkpt: {sentence}"));
                    let latitude_deg = angle(&element, "lat", 90.0).map_err(at)?;
                    let longitude_deg = angle(&element, "lon", 180.0).map_err(at)?;
                    point = Some(Point { line, latitude_deg, longitude_deg, ..Point::default() });
                }
                open.push(name);
            }
            // The reader compares the names.
            Event::End(_) => {
                open.pop();
            }
            Event::Text(text) => {
                // Extensions have times and heights of their own deeper in the point.
                let of_point = match (point.as_mut(), open.as_slice()) {
                    (Some(point), [.., parent, name]) if parent == "trkpt" => match name.as_str() {
                        "ele" => &mut point.elevation,
                        "time" => &mut point.time,
                        _ => continue,
                    },
                    _ => continue,
                };
                if of_point.len() + text.len() > MAX_TEXT {
                    let sentence =
                        format!("trkpt: a text of a time or a height has at most {MAX_TEXT} bytes");
                    return Err(fault(line, 1, sentence));
                }
                *of_point += &String::from_utf8_lossy(&text);
            }
            Event::Eof => break,
            _ => {}
        }
    }
    if let Some(name) = open.last() {
        return Err(fault(line, 1, format!("expected </{}>, found the end of the file", excerpt(name))));
    }
    fixes.take(point)?;
    Ok(fixes)
}

impl Fixes {
    /// Takes a point that has been read.
    fn take(&mut self, point: Option<Point>) -> Result<(), LogError> {
        let Some(point) = point else { return Ok(()) };
        let of_point = |sentence: String| fault(point.line, 1, format!("trkpt: {sentence}"));
        match fix(&point, &mut self.clock).map_err(of_point)? {
            Some(fix) => {
                room_for_one_more(&mut self.found).map_err(LogError::Memory)?;
                self.found.push(fix);
            }
            None => self.without_time += 1,
        }
        Ok(())
    }
}

/// The fix of a point; `None`: it has no time.
fn fix(point: &Point, clock: &mut Clock) -> Result<Option<Fix>, String> {
    let Point { line, latitude_deg, longitude_deg, .. } = *point;
    let [time, elevation] = [point.time.trim(), point.elevation.trim()];
    if time.is_empty() {
        return Ok(None);
    }
    let expected =
        |name: &str, what: &str, text: &str| format!("{name}: expected {what}, found \"{}\"", excerpt(text));
    let time_s = clock.next(time).ok_or_else(|| expected("time", clock.expected(), time))?;
    let elevation_m = match elevation {
        "" => None,
        text => {
            let finite = text.parse().ok().filter(|elevation_m: &f64| elevation_m.is_finite());
            Some(finite.ok_or_else(|| expected("ele", "a finite number [m]", text))?)
        }
    };
    Ok(Some(Fix { line, time_s, latitude_deg, longitude_deg, elevation_m }))
}

fn newlines(text: &[u8]) -> u64 {
    text.iter().filter(|byte| **byte == b'\n').count() as u64
}

/// An attribute of a point [deg].
fn angle(element: &BytesStart<'_>, name: &str, largest_deg: f64) -> Result<f64, String> {
    let attribute = element
        .try_get_attribute(name)
        .map_err(|error| format!("expected XML: {}", excerpt(&error.to_string())))?;
    let expected = format!("expected its {name}, from -{largest_deg} to {largest_deg} degrees");
    let Some(attribute) = attribute else { return Err(expected) };
    let text = String::from_utf8_lossy(&attribute.value);
    let angle_deg = text.trim().parse().ok().filter(|angle_deg: &f64| angle_deg.abs() <= largest_deg);
    angle_deg.ok_or_else(|| format!("{expected}, found \"{}\"", excerpt(&text)))
}
