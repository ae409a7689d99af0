//! Logs of several files with one clock, as the tools of autopilots write them: one message or topic a file. The values of the other
//! files are interpolated onto the times of the positions.

use std::f64::consts::{PI, TAU};
use std::io;
use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use sins::log::{ColumnFrom, FlightLog, LogMapping, QUANTITIES, TimeFormat};
use sins::math::{Euler, attitude_from_euler, euler_from_attitude};
use sins::scene::excerpt;
use sins::truth::FlightSample;

use super::{Rows, Table, left_out};
use crate::failure::Failure;
use crate::given::log::{of_log, read_table};
use crate::units::six_digits;

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

fn place(key: &str) -> usize {
    QUANTITIES.iter().position(|quantity| quantity.key == key).unwrap_or_default()
}

/// The file of each group.
fn files(mapping: &LogMapping) -> Result<Files, Failure> {
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
                .map(|file| if file.is_empty() { "the log".to_owned() } else { excerpt(file).to_string() });
            return Err(Failure::new(format!(
                "log.{key}: the {name} must stand in one file, not in {one} and {other}"
            )));
        }
        files[group].clone_from(&first.file);
    }
    let is_named = |key: &str| mapping.columns[place(key)].from != ColumnFrom::OwnName;
    let is_column =
        |key: &str| is_named(key) && !matches!(mapping.columns[place(key)].from, ColumnFrom::Constant(_));
    let needs_attitude = is_named("forward") || mapping.is_track_magnetic && is_column("variation");
    if needs_attitude && files[ATTITUDE] != files[VELOCITY] {
        return Err(Failure::new(
            "log: this velocity needs the attitude or the variation: all must stand in one file",
        ));
    }
    Ok(files)
}

/// The mapping of the groups that stand in `file`; what it lacks is 0.
fn part_of(mapping: &LogMapping, files: &Files, file: &str) -> LogMapping {
    let mut part = mapping.clone();
    let mut clear = |key: &str| {
        let is_needed = ["latitude", "longitude", "height", "roll", "pitch", "heading"].contains(&key);
        let from = if is_needed { ColumnFrom::Constant(0.0) } else { ColumnFrom::OwnName };
        part.columns[place(key)] = sins::log::LogColumn { from, ..Default::default() };
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
    fn new(log: &FlightLog, mapping: &LogMapping, first_s: f64, groups: Vec<usize>) -> Self {
        let samples = log.samples();
        let mut intervals: Vec<f64> = samples.windows(2).map(|two| two[1].time_s - two[0].time_s).collect();
        intervals.sort_unstable_by(f64::total_cmp);
        // Up to three of four intervals are those between the filters.
        let near_s = NEAR * intervals[intervals.len() * 4 / 5];
        let own = &intervals[intervals.partition_point(|interval_s| *interval_s <= near_s)..];
        let usual_s = own[own.len() / 2];
        let mut last_s = f64::NEG_INFINITY;
        let is_far = |sample: &&FlightSample| {
            let is_far = sample.time_s - last_s > near_s;
            last_s = if is_far { sample.time_s } else { last_s };
            is_far
        };
        let samples: Vec<FlightSample> = samples.iter().filter(is_far).copied().collect();
        let near = log.samples().len() as u64 - samples.len() as u64;
        let days = ((first_s - samples[0].time_s) / DAY_S).round();
        let shift_s = if mapping.time_format == TimeFormat::Number { 0.0 } else { days * DAY_S };
        let has_quaternion = mapping.columns[place("q0")].from != ColumnFrom::OwnName;
        Self {
            longest_s: GAP * usual_s,
            samples,
            shift_s,
            has_quaternion,
            groups,
            near,
            outside: 0,
            in_gaps: 0,
        }
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

    /// What was left out, as the end of a sentence.
    fn left_out(&self) -> String {
        let gaps = format!("in its gaps of more than {} s", six_digits(self.longest_s));
        left_out(&[(self.outside, "outside of its times"), (self.in_gaps, &gaps)])
    }
}

/// The path of the file `name` beside the log at `path`: a plain file in the folder of the log, or in that to which a link to the log
/// leads. The text that names it may be another's, and a message can quote what was read.
fn beside(path: &Path, name: &str) -> Result<PathBuf, Failure> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let beside = folder.join(name);
    let unread = |error: io::Error| Failure::of_input(&beside, &error);
    let place = beside.canonicalize().map_err(unread)?;
    let folders = [Path::new(".").join(folder).canonicalize(), path.canonicalize().map(in_folder)];
    if !folders.into_iter().flatten().any(|folder| in_folder(place.clone()) == folder) {
        return Err(Failure::of_file(
            &beside,
            &"is a link to another folder: expected a file beside the log",
        ));
    }
    // A pipe would wait for its other end.
    if !place.is_file() {
        return Err(Failure::of_file(&beside, &"is no plain file: expected one beside the log"));
    }
    Ok(beside)
}

fn in_folder(mut place: PathBuf) -> PathBuf {
    place.pop();
    place
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

impl Table {
    /// Joins the files that `mapping` names with the log at `path`. The table then has the library's own columns, and so has the mapping.
    pub fn join(&mut self, path: &Path, mapping: &mut LogMapping) -> Result<(), Failure> {
        let files = files(mapping)?;
        let mut names: Vec<&String> = files.iter().filter(|file| !file.is_empty()).collect();
        names.sort();
        names.dedup();
        let Some(first) = names.first() else {
            // An attitude that is not read has no file.
            mapping.columns.iter_mut().for_each(|column| column.file.clear());
            return Ok(());
        };
        if path == Path::new("-") {
            return Err(Failure::of_file(
                path,
                &format!("{} is looked for beside a file, not beside standard input", excerpt(first)),
            ));
        }
        if mapping.time_format == TimeFormat::Row {
            let what = format!("rows without times cannot be joined with {}", excerpt(first));
            return Err(Failure::of_file(path, &what));
        }
        let read = |path: &Path, text: &[u8], file: &str| {
            let part = part_of(mapping, &files, file);
            let log = FlightLog::parse_with(text, &part).map_err(|error| of_log(path, error))?;
            Ok::<_, Failure>((log, part))
        };
        let (log, _) = read(path, &self.text, "")?;
        let [first_s, .., last_s] = log.samples() else { return Ok(()) };
        let (first_s, last_s) = (first_s.time_s, last_s.time_s);
        let mut notes: Vec<String> = self.note.take().into_iter().collect();
        let mut note = |path: &Path, log: &FlightLog| {
            for said in log.notes() {
                let line = if said.line > 0 { format!(":{}", said.line) } else { String::new() };
                notes.push(format!("{}{line}: {}", path.display(), said.sentence));
            }
            let late = log.of_rows().iter();
            notes.extend(
                late.map(|(found, line)| format!("{}:{line}: {}", path.display(), found.with_remedy())),
            );
        };
        note(path, &log);
        let mut others = Vec::new();
        for name in &names {
            let path = beside(path, name)?;
            let table = read_table(&path)?;
            let (other, part) = read(&path, &table.text, name)?;
            note(&path, &other);
            let groups = (0..GROUPS.len()).filter(|group| files[*group] == **name).collect();
            others.push(Other::new(&other, &part, first_s, groups));
            self.others.push(path);
        }
        let mut joined = Vec::new();
        for (index, sample) in log.samples().iter().enumerate() {
            let mut sample = *sample;
            let mut is_whole = true;
            for other in &mut others {
                match other.at(sample.time_s) {
                    Some(from) => other.groups.iter().for_each(|group| put(*group, &from, &mut sample)),
                    None => is_whole = false,
                }
            }
            if is_whole {
                joined.push((log.line(index).unwrap_or_default(), sample));
            }
        }
        for (other, path) in others.iter().zip(&self.others) {
            let near = match other.near {
                0 => String::new(),
                near => {
                    format!(", without {near} rows right behind the one before: those of another filter?")
                }
            };
            notes.push(format!(
                "{} is interpolated onto the rows of the log{near}{}",
                path.display(),
                other.left_out()
            ));
        }
        if joined.len() < 2 {
            let spans = others.iter().zip(&self.others).map(|(other, path)| {
                let [first, last] = [0, other.samples.len() - 1]
                    .map(|row| six_digits(other.samples[row].time_s + other.shift_s));
                format!("{} from {first} to {last} s", path.display())
            });
            let (spans, [first, last]) =
                (spans.collect::<Vec<_>>().join(", "), [first_s, last_s].map(six_digits));
            let what = format!(
                "{} rows have values in all files: the times are from {first} to {last} s, those of {spans}",
                joined.len()
            );
            return Err(Failure::of_file(path, &what));
        }
        let has_attitude = log.has_attitude();
        self.text = table(&joined, has_attitude).into_bytes();
        self.note = Some(notes.join("; "));
        *mapping = mapping.of_own_columns();
        Ok(())
    }
}

/// The table of samples that have the same columns, each on its line.
fn table(samples: &[(u64, FlightSample)], has_attitude: bool) -> String {
    let has = samples.first().map(|(_, sample)| *sample);
    let has = |part: fn(&FlightSample) -> bool| has.as_ref().is_some_and(part);
    let parts = [
        (true, "latitude_rad,longitude_rad,height_m"),
        (has_attitude, "roll_rad,pitch_rad,heading_rad"),
        (has(|sample| sample.v_n.is_some()), "velocity_east_m_s,velocity_north_m_s,velocity_up_m_s"),
        (has(|sample| sample.omega_ib_b.is_some()), "rate_x_rad_s,rate_y_rad_s,rate_z_rad_s"),
        (has(|sample| sample.f_b.is_some()), "force_x_m_s2,force_y_m_s2,force_z_m_s2"),
        (has(|sample| sample.temperature_c.is_some()), "temperature_c"),
    ];
    let names: Vec<&str> = parts.iter().filter(|(has, _)| *has).map(|(_, names)| *names).collect();
    let mut rows = Rows::new(&format!("time_s,{}", names.join(",")));
    for (line, sample) in samples {
        let (place, euler) = (sample.place, sample.euler);
        let mut values = vec![place.latitude_rad, place.longitude_rad, place.height_m];
        if has_attitude {
            values.extend([euler.roll, euler.pitch, euler.heading]);
        }
        for vector in [sample.v_n, sample.omega_ib_b, sample.f_b].into_iter().flatten() {
            values.extend(vector.iter());
        }
        values.extend(sample.temperature_c);
        rows.push(*line, sample.time_s, &values);
    }
    rows.text
}

#[cfg(test)]
mod tests;
