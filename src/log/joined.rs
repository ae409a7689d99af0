//! Logs of several files with one clock, as the tools of autopilots write them: one message or topic a file. The values of the other
//! files are interpolated onto the times of the positions.

use core::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use super::column::{ColumnFrom, LogColumn};
use super::parse::kept;
use super::record::left_out;
use super::{FlightLog, LogError, LogMapping, QUANTITIES, TimeFormat, fault};
use crate::base::math::{Euler, attitude_from_euler, euler_from_attitude};
use crate::base::memory::{room, room_for_one_more};
use crate::base::records::rounded;
use crate::base::text::{Fault, excerpt};
use crate::truth::FlightSample;

/// Quantities that stand in one file, and what they are together.
const GROUPS: [(&str, &[&str]); 6] = [
    ("height", &["height", "geoid"]),
    ("attitude", &["roll", "pitch", "heading", "q0", "q1", "q2", "q3", "variation"]),
    ("velocity", &["east", "north", "up", "speed", "track", "climb", "forward", "right", "down"]),
    ("angular rate", &["rate_x", "rate_y", "rate_z"]),
    ("specific force", &["force_x", "force_y", "force_z"]),
    ("temperature", &["temperature"]),
];
const ATTITUDE: usize = 1;
const VELOCITY: usize = 2;

/// Longest interval that is interpolated, in usual intervals of a file.
const GAP: f64 = 2.5;

/// Share of a usual interval within which a row belongs to the row before: several filters report one right after the other, and the rows
/// of the first of them are read.
const NEAR: f64 = 0.2;

const DAY_S: f64 = 86_400.0;

/// The file of each group; empty: the log itself.
type Files = [String; GROUPS.len()];

/// Why several files are no log.
#[derive(Debug, Clone, PartialEq)]
pub enum FilesError<E> {
    /// A file has a fault: its name, which is empty for the log itself.
    Of(String, Box<LogError>),
    /// The program cannot read a file.
    Unread(E),
}

fn place(key: &str) -> usize {
    QUANTITIES.iter().position(|quantity| quantity.key == key).unwrap_or_default()
}

/// The file of each group.
fn files(mapping: &LogMapping) -> Result<Files, LogError> {
    let mut files = Files::default();
    for (group, (name, keys)) in GROUPS.iter().enumerate() {
        if group == ATTITUDE && mapping.is_coordinated {
            continue;
        }
        let columns = keys.iter().map(|key| (key, &mapping.columns[place(key)]));
        let mut named =
            columns.filter(|(_, column)| matches!(column.from, ColumnFrom::Name(_) | ColumnFrom::Number(_)));
        let Some((_, first)) = named.next() else { continue };
        if let Some((key, other)) = named.find(|(_, column)| column.file != first.file) {
            let [one, other] = [&first.file, &other.file]
                .map(|file| if file.is_empty() { "the log".to_owned() } else { excerpt(file) });
            let sentence = format!("log.{key}: the {name} must stand in one file, not in {one} and {other}");
            return Err(fault(0, 1, sentence));
        }
        files[group].clone_from(&first.file);
    }
    let is_named = |key: &str| mapping.columns[place(key)].from != ColumnFrom::OwnName;
    let is_column =
        |key: &str| is_named(key) && !matches!(mapping.columns[place(key)].from, ColumnFrom::Constant(_));
    let needs_attitude = is_named("forward") || mapping.is_track_magnetic && is_column("variation");
    if needs_attitude && files[ATTITUDE] != files[VELOCITY] {
        let what = "log: this velocity needs the attitude or the variation: all must stand in one file";
        return Err(fault(0, 1, what.to_owned()));
    }
    Ok(files)
}

impl LogMapping {
    /// The names of the files beside the log that are read, in alphabetical order.
    pub fn files(&self) -> Vec<&str> {
        let is_read = |group: &usize| !(*group == ATTITUDE && self.is_coordinated);
        let keys = (0..GROUPS.len()).filter(is_read).flat_map(|group| GROUPS[group].1);
        let files = keys.map(|key| self.columns[place(key)].file.as_str());
        let mut names: Vec<&str> = Vec::new();
        for file in files.filter(|file| !file.is_empty()) {
            if let Err(place) = names.binary_search(&file) {
                names.insert(place, file);
            }
        }
        names
    }
}

/// The mapping of the groups that stand in `file`; what it lacks is 0.
// Of its own stack frame, as `of_record`.
#[inline(never)]
fn part_of(mapping: &LogMapping, files: &Files, file: &str) -> Box<LogMapping> {
    let mut part = Box::new(mapping.clone());
    let mut clear = |key: &str| {
        let is_needed = ["latitude", "longitude", "height", "roll", "pitch", "heading"].contains(&key);
        let from = if is_needed { ColumnFrom::Constant(0.0) } else { ColumnFrom::OwnName };
        part.columns[place(key)] = LogColumn { from, ..LogColumn::default() };
    };
    if !file.is_empty() {
        ["latitude", "longitude"].iter().for_each(|key| clear(key));
    }
    for ((_, keys), its_file) in GROUPS.iter().zip(files) {
        // A constant variation is also that of the track.
        let is_kept = |key: &str| {
            key == "variation" && matches!(mapping.columns[place(key)].from, ColumnFrom::Constant(_))
        };
        if its_file != file {
            keys.iter().filter(|key| !is_kept(key)).for_each(|key| clear(key));
        }
    }
    part.columns.iter_mut().for_each(|column| column.file.clear());
    if !file.is_empty() {
        part.is_coordinated = false;
        // Repeated stamps are left out: several filters may report at one time.
        part.smooth = true;
    }
    part
}

/// A file that is interpolated.
struct Other {
    name: String,
    samples: Vec<FlightSample>,
    /// Added to its times: whole days between the midnights from which the times of the files count [s].
    shift_s: f64,
    /// Longest interval that is interpolated [s].
    longest_s: f64,
    /// Whether its attitude is that of quaternions, and not of angles.
    has_quaternion: bool,
    groups: Vec<usize>,
    /// Rows right behind the one before, which are not read.
    near: u64,
    outside: u64,
    in_gaps: u64,
}

impl Other {
    fn new(
        name: &str,
        log: FlightLog,
        mapping: &LogMapping,
        first_s: f64,
        files: &Files,
    ) -> Result<Self, LogError> {
        let mut samples = log.samples;
        let mut intervals: Vec<f64> = room(samples.len()).map_err(LogError::Memory)?;
        intervals.extend(samples.windows(2).map(|two| two[1].time_s - two[0].time_s));
        intervals.sort_unstable_by(f64::total_cmp);
        // Up to three of four intervals are those between the filters.
        let near_s = NEAR * intervals[intervals.len() * 4 / 5];
        let own = &intervals[intervals.partition_point(|interval_s| *interval_s <= near_s)..];
        let usual_s = own[own.len() / 2];
        let (mut last_s, all) = (f64::NEG_INFINITY, samples.len());
        samples.retain(|sample| {
            let is_far = sample.time_s - last_s > near_s;
            last_s = if is_far { sample.time_s } else { last_s };
            is_far
        });
        let days = ((first_s - samples[0].time_s) / DAY_S).round();
        Ok(Self {
            name: name.to_owned(),
            longest_s: GAP * usual_s,
            near: (all - samples.len()) as u64,
            samples,
            shift_s: if mapping.time_format == TimeFormat::Number { 0.0 } else { days * DAY_S },
            has_quaternion: mapping.columns[place("q0")].from != ColumnFrom::OwnName,
            groups: (0..GROUPS.len()).filter(|group| files[*group] == name).collect(),
            outside: 0,
            in_gaps: 0,
        })
    }

    /// Its values at a time of the log; `None`: it has none there, which is counted.
    fn at(&mut self, time_s: f64) -> Option<FlightSample> {
        let time_s = time_s - self.shift_s;
        let samples = &self.samples;
        let behind = samples.partition_point(|sample| sample.time_s < time_s);
        let Some(b) = samples.get(behind) else {
            self.outside += 1;
            return None;
        };
        if b.time_s == time_s {
            return Some(*b);
        }
        let Some(a) = behind.checked_sub(1).map(|before| &samples[before]) else {
            self.outside += 1;
            return None;
        };
        let interval_s = b.time_s - a.time_s;
        if interval_s > self.longest_s {
            self.in_gaps += 1;
            return None;
        }
        Some(between(a, b, (time_s - a.time_s) / interval_s, self.has_quaternion))
    }

    /// What was done, in a sentence.
    fn said(&self) -> String {
        let near = match self.near {
            0 => String::new(),
            near => format!(", without {near} rows right behind the one before: those of another filter?"),
        };
        let gaps = format!("in its gaps of more than {} s", rounded(self.longest_s, 6));
        let left_out = left_out(&[(self.outside, "outside of its times"), (self.in_gaps, &gaps)]);
        format!("{} is interpolated onto the rows of the log{near}{left_out}", excerpt(&self.name))
    }

    /// Its name and its times, in words.
    fn span(&self) -> String {
        let at = |sample: &FlightSample| rounded(sample.time_s + self.shift_s, 6);
        let [first, .., last] = self.samples.as_slice() else { return excerpt(&self.name) };
        format!("{} from {} to {} s", excerpt(&self.name), at(first), at(last))
    }
}

/// The sample at `part` of the way from `a` to `b`: angles turn the shorter way, and so does a quaternion.
fn between(a: &FlightSample, b: &FlightSample, part: f64, has_quaternion: bool) -> FlightSample {
    let number = |a: f64, b: f64| a + part * (b - a);
    let vector = |a: Option<Vector3<f64>>, b: Option<Vector3<f64>>| Some(a? + (b? - a?) * part);
    let angle = |a: f64, b: f64| symmetric(a + part * symmetric(b - a));
    let euler = if has_quaternion {
        let [from, to] = [a, b].map(|sample| attitude_from_euler(&sample.euler));
        let to = if from.dot(&to) < 0.0 { -to } else { to };
        euler_from_attitude(&(from * (1.0 - part) + to * part).normalize())
    } else {
        Euler {
            roll: angle(a.euler.roll, b.euler.roll),
            pitch: angle(a.euler.pitch, b.euler.pitch),
            heading: angle(a.euler.heading, b.euler.heading).rem_euclid(TAU),
        }
    };
    let mut sample = FlightSample { euler, ..*a };
    sample.place.height_m = number(a.place.height_m, b.place.height_m);
    sample.v_n = vector(a.v_n, b.v_n);
    sample.omega_ib_b = vector(a.omega_ib_b, b.omega_ib_b);
    sample.f_b = vector(a.f_b, b.f_b);
    sample.temperature_c = a.temperature_c.zip(b.temperature_c).map(|(a, b)| number(a, b));
    sample
}

/// An angle from -π to π [rad].
fn symmetric(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

/// Puts a group of `from` into `to`.
fn put(group: usize, from: &FlightSample, to: &mut FlightSample) {
    match group {
        0 => to.place.height_m = from.place.height_m,
        ATTITUDE => to.euler = from.euler,
        VELOCITY => to.v_n = from.v_n,
        3 => to.omega_ib_b = from.omega_ib_b,
        4 => to.f_b = from.f_b,
        _ => to.temperature_c = from.temperature_c,
    }
}

/// The notes of a file and what was found in its rows, as notes; those of another file than the log itself begin with its name.
fn notes_of(name: &str, log: &FlightLog) -> impl Iterator<Item = Fault> {
    let found = log.of_rows.iter().map(|(found, line)| (*line as usize, found.with_remedy().to_string()));
    let noted = log.notes.iter().map(|note| (note.line, note.sentence.clone()));
    noted.chain(found).map(move |(line, sentence)| match (name, line) {
        ("", line) => Fault { line, column: 1, sentence, ..Fault::default() },
        (name, 0) => Fault { sentence: format!("{}: {sentence}", excerpt(name)), ..Fault::default() },
        (name, line) => {
            Fault { sentence: format!("{}:{line}: {sentence}", excerpt(name)), ..Fault::default() }
        }
    })
}

impl FlightLog {
    /// As [`FlightLog::parse_with`], of a log whose `mapping` names files beside it: `read` gives the contents of each by its name. Their
    /// values are interpolated onto the times of the log's own rows.
    pub fn parse_files<T: AsRef<[u8]>, E>(
        text: &[u8],
        mapping: &LogMapping,
        mut read: impl FnMut(&str) -> Result<T, E>,
    ) -> Result<Self, FilesError<E>> {
        let of_log = |error| FilesError::Of(String::new(), Box::new(error));
        let files = files(mapping).map_err(of_log)?;
        let names = mapping.files();
        let whole = |log: Self| Self { mapping: kept(mapping), ..log };
        let parse = |text: &[u8], file: &str| {
            let part = part_of(mapping, &files, file);
            Self::parse_with(text, &part).map(|log| (log, part))
        };
        let Some(first) = names.first() else {
            // An attitude that is not read has no file.
            return parse(text, "").map(|(log, _)| whole(log)).map_err(of_log);
        };
        if mapping.time_format == TimeFormat::Row {
            let sentence = format!("rows without times cannot be joined with {}", excerpt(first));
            return Err(of_log(fault(0, 1, sentence)));
        }
        let (log, _) = parse(text, "").map_err(of_log)?;
        let mut notes: Vec<Fault> = notes_of("", &log).collect();
        let mut others = Vec::new();
        for name in names {
            let text = read(name).map_err(FilesError::Unread)?;
            let of_other = |error| FilesError::Of(name.to_owned(), Box::new(error));
            let (other, part) = parse(text.as_ref(), name).map_err(of_other)?;
            notes.extend(notes_of(name, &other));
            others.push(Other::new(name, other, &part, log.samples[0].time_s, &files).map_err(of_other)?);
        }
        let mut joined = log.onto_rows(&mut others).map_err(of_log)?;
        notes.extend(others.iter().map(|other| Fault { sentence: other.said(), ..Fault::default() }));
        joined.notes = notes;
        Ok(whole(joined))
    }

    /// The rows at whose times each of `others` has values, with these values.
    fn onto_rows(self, others: &mut [Other]) -> Result<Self, LogError> {
        let (mut samples, mut lines) = (Vec::new(), Vec::new());
        for (sample, line) in self.samples.iter().zip(&self.lines) {
            let (mut sample, mut is_whole) = (*sample, true);
            for other in &mut *others {
                match other.at(sample.time_s) {
                    Some(from) => other.groups.iter().for_each(|group| put(*group, &from, &mut sample)),
                    None => is_whole = false,
                }
            }
            if is_whole {
                room_for_one_more(&mut samples).map_err(LogError::Memory)?;
                room_for_one_more(&mut lines).map_err(LogError::Memory)?;
                samples.push(sample);
                lines.push(*line);
            }
        }
        if samples.len() < 2 {
            let [first, last] = [self.samples.first(), self.samples.last()]
                .map(|sample| sample.map_or(0.0, |sample| rounded(sample.time_s, 6)));
            let spans: Vec<String> = others.iter().map(Other::span).collect();
            let sentence = format!(
                "{} rows have values in all files: the times are from {first} to {last} s, those of {}",
                samples.len(),
                spans.join(", ")
            );
            return Err(fault(0, 1, sentence));
        }
        Ok(Self { samples, lines, of_rows: Vec::new(), ..self })
    }
}

#[cfg(test)]
mod tests;
