//! An IMU log: columns of rates, forces or increments at equal intervals.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::ops::Range;
use std::path::Path;

use sins::log::LogMapping;
use sins_allan::FEWEST_SAMPLES;

use super::quantity::Sensor;
use super::rows::{Read as Column, Rows, Source, keep};
use super::stamps::{self, EVEN, EXACT, Stamps};
use super::uneven::{between, lengths};
use crate::failure::Failure;
use crate::given::open_table;
use crate::progress::Progress;
use crate::units::{significant, time_text};

/// Longest step of stamps, in lengths of the rest of the record.
const JUMP: f64 = 1e6;

/// Scatter of the stamps, as a part of the interval, beyond which they say nothing of single rows.
const SCATTER: f64 = 0.5;
/// Scatter that is worth a remark: digits of the stamps are not.
const REMARKED: f64 = 0.25;
/// Largest distance of rounded stamps from equal intervals, in those of their steps.
const OF_ROUNDED: f64 = 2.0;

/// A column.
pub struct Series {
    pub name: String,
    pub sensor: Sensor,
    /// Angles [rad] or velocities [m/s] over the intervals, of all pieces.
    pub increments: Vec<f64>,
}

/// All columns of one log.
pub struct Log {
    /// Name of the file.
    pub name: String,
    pub interval_s: f64,
    pub series: Vec<Series>,
    /// Number of rows of each piece between gaps.
    pub pieces: Vec<usize>,
    /// What the stamps have: gaps, rows that are left out, jitter; empty: nothing.
    pub remarks: Vec<String>,
    /// Whether the rate is that of --rate, and not that of the time stamps of the log.
    pub is_counted: bool,
    /// Whether the user says that the sensor is at rest.
    pub is_still: bool,
    /// End of the interval of each row [s], by its own stamp unless stamps scatter.
    pub times_s: Vec<f64>,
    /// Lengths of the intervals of uneven rows [s]; of others nothing.
    pub lengths_s: Vec<f64>,
    /// The `[imu]` that reads such a record in the same way; `None`: it has more than three columns of a sensor.
    pub taken: Option<Box<LogMapping>>,
}

impl Log {
    /// Reads a record.
    pub fn read(source: &Source<'_>) -> Result<Self, Failure> {
        let path = source.path;
        let (input, length) = open_table(path)?;
        let what = format!("reading {}", path.display());
        let progress = match length {
            0 => Progress::working(what),
            bytes => Progress::counting(what, bytes as usize),
        };
        Self::from_input(source, progress.reading(input)).map_err(|failure| source.of_table(failure))
    }

    fn from_input(source: &Source<'_>, input: impl Read) -> Result<Self, Failure> {
        let rows = Rows::read(source, input).map_err(|unread| begin(&unread.file, unread.failure))?;
        Self::from_rows(source, rows).map_err(|failure| begin(source.path, failure))
    }

    fn from_rows(source: &Source<'_>, mut rows: Rows) -> Result<Self, Failure> {
        let path = source.path;
        if rows.count < FEWEST_SAMPLES {
            let what = format!("expected at least {FEWEST_SAMPLES} rows, found {}", rows.count);
            return Err(Failure::of_file(path, &what));
        }
        let repeats = if source.rate_hz.is_none() { rows.drop_repeats() } else { 0 };
        let is_counted = source.rate_hz.is_some() && rows.has_stamps;
        let time = rows.time.take();
        let (stamps, all_s) = stamps(source, &rows, time)?;
        let (times_s, is_spaced) = times(&stamps, all_s);
        let interval_s = stamps.interval_s;
        let lengths_s = lengths(&stamps, &times_s);
        let series = rows.columns.into_iter().map(|column| {
            let Column { name, quantity, scale, add, numbers: mut increments } = column;
            let over_s = if quantity.is_increment { 1.0 } else { interval_s };
            let unit = scale * (quantity.si * over_s);
            keep(&mut increments, &stamps.pieces);
            if stamps.is_uneven && !quantity.is_increment {
                between(&mut increments, &stamps.pieces, &lengths_s);
                let of_interval = |(value, length_s): (&mut f64, &f64)| *value *= length_s / interval_s;
                increments.iter_mut().zip(&lengths_s).for_each(of_interval);
            }
            increments.iter_mut().for_each(|value| *value *= unit);
            // Without an addition a value keeps its bits, also -0.
            if add != 0.0 {
                increments.iter_mut().for_each(|value| *value += add * over_s);
            }
            Series { name, sensor: quantity.sensor, increments }
        });
        let name = match path.file_name() {
            Some(name) if path != Path::new("-") => name.to_string_lossy().into_owned(),
            _ => "standard input".to_owned(),
        };
        let series = series.collect();
        let (pieces, mut remarks) =
            (stamps.pieces.iter().map(Range::len).collect(), remarks(&stamps, is_spaced));
        if repeats > 0 {
            let rows = if repeats == 1 { "row that repeats" } else { "rows that repeat" };
            remarks.push(format!(
                "{repeats} {rows} the one before {} left out",
                if repeats == 1 { "is" } else { "are" }
            ));
        }
        if let Some((count, line)) = rows.left_out {
            let rows = if count == 1 { "row without a value is" } else { "rows without a value are" };
            remarks.push(format!("{count} {rows} left out, the first in line {line}"));
        }
        let taken = rows.taken;
        let is_still = false;
        Ok(Self {
            name,
            interval_s,
            series,
            pieces,
            remarks,
            is_counted,
            is_still,
            times_s,
            lengths_s,
            taken,
        })
    }

    /// What is said of the rate.
    pub fn counted(&self) -> &'static str {
        if self.is_counted { " (--rate; the time stamps are not used)" } else { "" }
    }

    pub fn count(&self) -> usize {
        self.series.first().map_or(0, |series| series.increments.len())
    }

    pub fn duration_s(&self) -> f64 {
        self.count() as f64 * self.interval_s
    }
}

/// Lines of a file that are quoted where it cannot be read, and letters of each.
const QUOTED: usize = 10;
const LETTERS: usize = 100;

/// The failure with the first lines of the file.
fn begin(path: &Path, failure: Failure) -> Failure {
    let Ok(file) = File::open(path) else { return failure };
    let cut =
        |line: Vec<u8>| String::from_utf8_lossy(&line).trim_end().chars().take(LETTERS).collect::<String>();
    let lines =
        BufReader::new(file.take((QUOTED * 4096) as u64)).split(b'\n').map_while(Result::ok).take(QUOTED);
    let quoted: String =
        lines.enumerate().map(|(place, line)| format!("\n{:4} | {}", place + 1, cut(line))).collect();
    if quoted.is_empty() {
        failure
    } else {
        Failure::of_kind(failure.kind(), format!("{failure}\n{} begins:{quoted}", path.display()))
    }
}

/// Sentences about the stamps.
fn remarks(stamps: &Stamps, is_spaced: bool) -> Vec<String> {
    let Stamps { interval_s, rows, gaps, pieces, lost, jitter, is_uneven, .. } = stamps;
    let mut remarks = Vec::new();
    if *gaps > 0 {
        let (used, pieces) = (stamps.used(), pieces.len());
        let percent = 100.0 * used as f64 / *rows as f64;
        let of_them = if used < *rows { format!(" with {percent:.1} % of the rows") } else { String::new() };
        let (name, lost_s) = (if *gaps == 1 { "gap" } else { "gaps" }, time_text(*lost as f64 * *interval_s));
        remarks.push(format!("{gaps} {name}, {lost_s} in all: {pieces} pieces{of_them} are joined"));
    }
    if *is_uneven {
        let jitter = significant(*jitter);
        remarks.push(format!(
            "rows are at uneven times: their intervals differ by up to {jitter} of the mean one"
        ));
    } else if is_spaced && *jitter > REMARKED {
        let jitter = significant(*jitter);
        remarks.push(format!(
            "stamps scatter by up to {jitter} of an interval: rows are taken as equally spaced"
        ));
    }
    remarks
}

/// Times of the rows of the pieces, and whether rows are equally spaced: where stamps scatter by half an interval and more, and where they
/// scatter less and are within an interval of such times, or, as rounded ones, within about their steps' scatter of them.
fn times(stamps: &Stamps, mut times_s: Vec<f64>) -> (Vec<f64>, bool) {
    let interval_s = stamps.interval_s;
    let mut is_spaced = false;
    let near_s = if stamps.jitter > EVEN { interval_s } else { OF_ROUNDED * stamps.jitter * interval_s };
    if !stamps.is_uneven && stamps.jitter > EXACT {
        let places: Vec<f64> = stamps.places().collect();
        // The mean over a piece of the time at which it would begin to count.
        let begin_s = |piece: &Range<usize>| {
            let rows = times_s[piece.clone()].iter().zip(&places[piece.clone()]);
            rows.map(|(time_s, place)| time_s - place * interval_s).sum::<f64>() / piece.len() as f64
        };
        let whole_s = begin_s(&(0..times_s.len()));
        // One clock for all pieces: the mean of few stamps that are late scatters.
        let is_one = stamps.pieces.iter().all(|piece| (begin_s(piece) - whole_s).abs() < interval_s);
        let begins_s: Vec<f64> =
            stamps.pieces.iter().map(|piece| if is_one { whole_s } else { begin_s(piece) }).collect();
        for (piece, begin_s) in stamps.pieces.iter().zip(begins_s) {
            let spaced = |row: usize| begin_s + places[row] * interval_s;
            let is_near = |row: usize| (times_s[row] - spaced(row)).abs() < near_s;
            if stamps.jitter > SCATTER || piece.clone().all(is_near) {
                piece.clone().for_each(|row| times_s[row] = spaced(row));
                is_spaced = true;
            }
        }
    }
    keep(&mut times_s, &stamps.pieces);
    (times_s, is_spaced)
}

/// The equal intervals of rows that are counted, or those of the stamps; rejects stamps that go back.
fn stamps(
    source: &Source<'_>,
    rows: &Rows,
    time: Option<(String, Vec<f64>)>,
) -> Result<(Stamps, Vec<f64>), Failure> {
    let path = source.path;
    let (name, times_s) = match (time, rows.rate_hz) {
        (Some(time), None) => time,
        (_, rate_hz) => {
            let rate_hz = rate_hz.unwrap_or(1.0);
            let times_s = (0..rows.count).map(|row| row as f64 / rate_hz).collect();
            return Ok((Stamps::counted(rows.count, 1.0 / rate_hz), times_s));
        }
    };
    // Rows that are counted may have no hole.
    let has_holes = rows.left_out.is_some();
    let counts = if has_holes { "" } else { " (--rate: counts rows)" };
    if let Some(row) = times_s.windows(2).position(|pair| pair[1] < pair[0]) {
        let what = format!(
            "column {name}: expected a stamp of {:.6} s or later, found {:.6} s{counts}",
            times_s[row],
            times_s[row + 1]
        );
        return Err(Failure::of_line(path, (rows.line)(row + 1), &what));
    }
    if times_s[0] == times_s[times_s.len() - 1] {
        return Err(Failure::of_file(path, &format!("column {name}: all stamps are the same{counts}")));
    }
    check_jump(path, rows, &name, &times_s, counts)?;
    let found = stamps::read(&times_s);
    let found = found.uneven(&times_s).unwrap_or(found);
    let found = found.longest(source.most_pieces);
    let longest = found.pieces.iter().map(Range::len).max().unwrap_or(0);
    if longest < source.fewest_rows {
        let rate = significant(1.0 / found.interval_s);
        let as_next =
            if has_holes { String::new() } else { format!("; --rate {rate}: takes each row as the next") };
        let what = format!(
            "column {name}: {} gaps, and the longest piece between them has {longest} rows (limit {}{as_next})",
            found.gaps, source.fewest_rows
        );
        return Err(Failure::of_file(path, &what));
    }
    Ok((found, times_s))
}

/// Rejects a step that is longer than the rest of the record a million times: the interval of such stamps is unknown.
fn check_jump(path: &Path, rows: &Rows, name: &str, times_s: &[f64], counts: &str) -> Result<(), Failure> {
    let span_s = times_s[times_s.len() - 1] - times_s[0];
    let steps = times_s.windows(2).map(|pair| pair[1] - pair[0]).enumerate();
    let Some((row, longest_s)) = steps.max_by(|a, b| a.1.total_cmp(&b.1)) else { return Ok(()) };
    if longest_s <= JUMP * (span_s - longest_s) {
        return Ok(());
    }
    let what = format!(
        "column {name}: a stamp of {:.6} s follows one of {:.6} s, and all others are within {}: the clock jumps{counts}",
        times_s[row + 1],
        times_s[row],
        time_text(span_s - longest_s)
    );
    Err(Failure::of_line(path, (rows.line)(row + 1), &what))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(rate_hz: Option<f64>) -> Source<'static> {
        Source {
            path: Path::new("log.csv"),
            columns: &[],
            flag: "--columns",
            rate_hz,
            mapping: None,
            hint: "",
            most_pieces: 100,
            fewest_rows: FEWEST_SAMPLES,
        }
    }

    /// Reads a log with the rows `time(k)`, k.
    fn read(header: &str, rate_hz: Option<f64>, time: impl Fn(u32) -> String) -> Result<Log, String> {
        let rows: Vec<String> = (0..60).map(|k| format!("{},{k}\n", time(k))).collect();
        let text = format!("{header}\n{}", rows.concat());
        Log::from_input(&source(rate_hz), text.as_bytes()).map_err(|failure| failure.to_string())
    }

    #[test]
    fn rates_become_increments() {
        let log = read("time_ms,gyro_x_deg_s", None, |k| (1000 + 5 * k).to_string()).unwrap();
        assert!((log.interval_s - 0.005).abs() < 1e-15 && (log.duration_s() - 0.3).abs() < 1e-12);
        let expected = 2f64.to_radians() * 0.005;
        assert!((log.series[0].increments[2] - expected).abs() < 1e-15);
    }

    #[test]
    fn increments_stay_and_a_rate_needs_no_stamps() {
        let log = read("count,delta_v_m_s", Some(50.0), |k| format!("n{k}")).unwrap();
        assert_eq!((log.interval_s, log.series[0].increments[7]), (0.02, 7.0));
        let failure = read("count,delta_v_m_s", None, |k| k.to_string()).err().unwrap();
        assert!(failure.starts_with("log.csv:1: ") && failure.contains("--rate"), "{failure}");
    }

    /// `--rate` is no remedy where rows without a value were left out: with it the same table is refused at its hole.
    #[test]
    fn a_rate_is_advised_only_where_it_helps() {
        let back = |k: u32| (f64::from(k) - if k == 40 { 9.0 } else { 0.0 }).to_string();
        let same = |_: u32| "1".to_owned();
        let jump = |k: u32| (f64::from(k) + if k < 40 { 0.0 } else { 1e12 }).to_string();
        let apart = |k: u32| (f64::from(k) + f64::from(k / 20) * 1e3).to_string();
        let times: [&dyn Fn(u32) -> String; 4] = [&back, &same, &jump, &apart];
        for time in times {
            for hole in [None, Some(10), Some(59)] {
                let row = |k: u32| match hole {
                    Some(place) if place == k => format!("{},\n", time(k)),
                    _ => format!("{},{k}\n", time(k)),
                };
                let text = format!("time_s,a_g\n{}", (0..60).map(row).collect::<String>());
                let read = |rate_hz| Log::from_input(&source(rate_hz), text.as_bytes());
                let failure = read(None).err().unwrap().to_string();
                assert_eq!(failure.contains("--rate"), read(Some(10.0)).is_ok(), "{hole:?}: {failure}");
            }
        }
    }

    /// Rows that a recorder wrote twice are left out, and lines are still those of the file.
    #[test]
    fn rows_that_are_written_twice_count_once() {
        let text = |back: u32| {
            let row = |k: u32| format!("{:.2},{k}\n", 0.01 * f64::from(if k == back { 0 } else { k }));
            let twice = |k: u32| if k % 30 == 7 { row(k).repeat(2) } else { row(k) };
            format!("time_s,a_g\n{}", (0..90).map(twice).collect::<String>())
        };
        let read = |text: String| Log::from_input(&source(None), text.as_bytes());
        let log = read(text(900)).map_err(|failure| failure.to_string()).unwrap();
        assert_eq!(
            (log.count(), log.pieces, log.remarks),
            (90, vec![90], vec!["3 rows that repeat the one before are left out".to_owned()])
        );
        let back = read(text(60)).err().unwrap().to_string();
        // The header, 60 rows and two repeats are before it.
        assert!(back.starts_with("log.csv:64: column time_s: expected a stamp of 0.59"), "{back}");
    }

    #[test]
    fn jitter_is_taken_and_gaps_make_pieces() {
        let stamps = |k: u32| format!("{:.3}", f64::from(k) * 0.0025);
        let log = read("time_s,a_g", None, stamps).unwrap();
        assert!((log.interval_s - 0.0025).abs() < 1e-5 && log.remarks.is_empty());
        let gap = |k: u32| format!("{:.2}", f64::from(k + if k < 50 { 0 } else { 7 }) * 0.01);
        let log = read("time_s,a_g", None, gap).unwrap();
        assert_eq!((log.pieces, log.series[0].increments.len()), (vec![50, 10], 60));
        assert_eq!(log.remarks, ["1 gap, 0.1 s in all: 2 pieces are joined"]);
        // --rate believes the count.
        let log = read("time_s,a_g", Some(100.0), gap).unwrap();
        assert!((log.interval_s, log.count(), log.is_counted, log.pieces) == (0.01, 60, true, vec![60]));
        let short = read("time_s,a_g", None, |k| (k + k / 20).to_string()).err().unwrap();
        assert!(short.contains("2 gaps") && short.contains("has 20 rows (limit 45; --rate 1.000"), "{short}");
        let back = read("time_s,a_g", None, |k| (if k == 30 { 3 } else { k }).to_string()).err().unwrap();
        assert!(back.starts_with("log.csv:32: column time_s") && back.contains("--rate"), "{back}");
        // A clock that is set while it records.
        let set = read("time_s,a_g", None, |k| {
            (0.01 * f64::from(k) + if k < 20 { 0.0 } else { 1.7e9 }).to_string()
        });
        let set = set.err().unwrap();
        assert!(set.starts_with("log.csv:22: column time_s: a stamp of 1700000000.2"), "{set}");
        assert!(set.contains("follows one of 0.19") && set.contains("the clock jumps (--rate"), "{set}");
        assert!(read("time_s,a_g", None, |_| "4".into()).err().unwrap().contains("all stamps are the same"));
    }

    /// 150 pieces, one of 90 rows and the others of 50 or fewer: 100 are read.
    #[test]
    fn of_many_pieces_the_longest_stay() {
        let length = |piece: u32| {
            if piece == 70 {
                90
            } else if u32::is_multiple_of(piece, 3) {
                46
            } else {
                50
            }
        };
        let rows = (0..150).flat_map(|piece| (0..length(piece)).map(move |k| (100 * piece + k, piece)));
        let text: String = rows.map(|(time, piece)| format!("{time},{piece}\n")).collect();
        let log = Log::from_input(&source(None), format!("time_s,delta_v_m_s\n{text}").as_bytes())
            .map_err(|failure| failure.to_string());
        let log = log.unwrap();
        // 99 of 50 rows and the one of 90; 50 of 46 rows are left out.
        assert_eq!((log.pieces.len(), log.count()), (100, 5040));
        assert_eq!((log.series[0].increments[49], log.series[0].increments[50]), (1.0, 2.0));
        assert!(
            log.remarks[0].ends_with("100 pieces with 68.7 % of the rows are joined"),
            "{:?}",
            log.remarks
        );
    }

    #[test]
    fn short_logs_are_reported() {
        let failure = Log::from_input(&source(Some(1.0)), "a_g\n1\n".as_bytes()).err().unwrap().to_string();
        assert!(failure.contains("found 1"), "{failure}");
    }
}
