//! Tracks in the GPS Exchange Format (GPX 1.0 and 1.1): the points of all tracks and segments, in the order of the file. What a point and
//! its extensions say of the motion is compared with what flies.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::{FlightRecord, left_out};
use crate::base::memory::{room, room_for_one_more};
use crate::base::text::excerpt;
use crate::log::unread::{MOST, Unread};
use crate::log::{Clock, LogError, LogMapping, TimeFormat, fault};

/// Most elements that are open at once, longest name of one, and longest text of a time or a height [bytes].
const MAX_DEPTH: usize = 64;
const MAX_NAME: usize = 256;
const MAX_TEXT: usize = 256;

/// Most names of elements in points that are looked at.
const MAX_NAMES: usize = 64;

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
    /// Numbers of other elements, and the place of each name.
    beside: Vec<(usize, f64)>,
}

/// A point with its time.
struct Fix {
    line: u64,
    time_s: f64,
    latitude_deg: f64,
    longitude_deg: f64,
    /// Height above the sea; `None`: the point has none.
    elevation_m: Option<f64>,
    beside: Vec<(usize, f64)>,
}

/// The points of a file.
struct Fixes {
    clock: Clock,
    found: Vec<Fix>,
    without_time: u64,
    /// Number of segments that have points.
    segments: u64,
    /// Names of other elements in points, each with its place among the columns beside, if it is one of the motion.
    names: Vec<(String, Option<usize>)>,
    beside: Vec<Unread>,
}

/// Columns of a point that are read.
const COLUMNS: [&str; 4] = ["time_s", "latitude_deg", "longitude_deg", "height_m"];

/// The rows of a text.
pub fn record(text: &str) -> Result<FlightRecord, LogError> {
    // The reader keeps names, and quotes them in its errors.
    drop(room::<u8>(QUOTES * text.len()).map_err(LogError::Memory)?);
    let Fixes { found, without_time, segments, beside, .. } = fixes(text.as_bytes())?;
    if found.is_empty() {
        let what = "no track: expected trkpt with lat, lon and time, found";
        return Err(fault(0, 1, format!("{what} {without_time} without time")));
    }
    let has_elevation = found.iter().any(|fix| fix.elevation_m.is_some());
    let mut rows = FlightRecord::new(&COLUMNS);
    rows.beside = beside;
    let mut without_elevation = 0;
    for Fix { line, time_s, latitude_deg, longitude_deg, elevation_m, beside } in found {
        if has_elevation && elevation_m.is_none() {
            without_elevation += 1;
            continue;
        }
        let mut numbers = [f64::NAN; MOST];
        beside.iter().for_each(|(place, number)| numbers[*place] = *number);
        let row = [time_s, latitude_deg, longitude_deg, elevation_m.unwrap_or(0.0)];
        let count = rows.beside.len();
        rows.push(line, &row, &numbers[..count])?;
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
    let (found, names, beside) = (Vec::new(), Vec::new(), Vec::new());
    let mut fixes = Fixes { clock, found, without_time: 0, segments: 0, names, beside };
    // The text of the element that is open.
    let mut inner = String::new();
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
                inner.clear();
            }
            // The reader compares the names.
            Event::End(_) => {
                let name = open.pop().unwrap_or_default();
                if let Some(point) = point.as_mut().filter(|_| open.iter().any(|above| above == "trkpt")) {
                    fixes.take_beside(point, &name, &inner);
                }
                inner.clear();
            }
            Event::Text(text) => {
                // Extensions have times and heights of their own deeper in the point.
                let is_own = |name: &str| matches!(open.as_slice(), [.., parent, own] if parent == "trkpt" && own == name);
                let of_point = match point.as_mut() {
                    Some(point) if is_own("ele") => &mut point.elevation,
                    Some(point) if is_own("time") => &mut point.time,
                    _ if inner.len() + text.len() <= MAX_TEXT => &mut inner,
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
    /// Takes the text of an element in a point, if it is a number of the motion.
    fn take_beside(&mut self, point: &mut Point, name: &str, text: &str) {
        let Some(number) = text.trim().parse().ok().filter(|number: &f64| number.is_finite()) else { return };
        let known = self.names.iter().find(|(known, _)| known == name).map(|(_, place)| *place);
        let place = known.unwrap_or_else(|| {
            if self.names.len() == MAX_NAMES || self.beside.len() == MOST {
                return None;
            }
            let place = self.beside.len();
            let found = Unread::of_name(COLUMNS.len() + place, name);
            let place = found.is_some().then_some(place);
            self.beside.extend(found);
            self.names.push((name.to_owned(), place));
            place
        });
        if let Some(place) = place {
            point.beside.retain(|(other, _)| *other != place);
            point.beside.push((place, number));
        }
    }

    /// Takes a point that has been read.
    fn take(&mut self, point: Option<Point>) -> Result<(), LogError> {
        let Some(point) = point else { return Ok(()) };
        let of_point = |sentence: String| fault(point.line, 1, format!("trkpt: {sentence}"));
        let fix = fix(&point, &mut self.clock).map_err(of_point)?;
        match fix.map(|fix| Fix { beside: point.beside, ..fix }) {
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
    Ok(Some(Fix { line, time_s, latitude_deg, longitude_deg, elevation_m, beside: Vec::new() }))
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
