//! The rows of a record: with columns that their names say, or those of `[imu]`.

use std::io::Read as Input;
use std::ops::Range;
use std::path::{Path, PathBuf};

use sins::log::{Clock, IMU_QUANTITIES, ImuColumn, ImuTable, LogMapping, TimeFormat};
use sins::scene::excerpt;

use super::begin::{Plain, plain};
use super::quantity::{self, Quantity, Stamp, Wanted, choose, mapped};
use super::taken::{self, Guess};
use crate::failure::Failure;
use crate::given::{beside, of_log, read_bytes, read_whole};
use crate::table::{Chosen, Table};

/// Largest number of rows of a record, as of the library.
pub const MOST_ROWS: usize = 100_000_000;

/// Names of columns that tell several sensors apart, as in the messages of ArduPilot.
const INSTANCES: [&str; 3] = ["i", "instance", "imu_instance"];

/// One of this many rows may repeat the one before, and be left out.
const FEW_REPEATS: usize = 10;

/// Part of an interval by which the stamps of two files may differ.
const APART: f64 = 0.1;

/// A record, and how it is read.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// Its file; "-": standard input.
    pub path: &'a Path,
    /// Columns of the command line, and the argument that names them.
    pub columns: &'a [Wanted],
    pub flag: &'static str,
    /// Samples a second of the command line.
    pub rate_hz: Option<f64>,
    /// `[imu]`, if one is given.
    pub mapping: Option<&'a LogMapping>,
    /// What is said behind a failure of its table; empty: nothing.
    pub hint: &'a str,
    /// Most pieces between gaps that are read, the longest; and fewest rows of the longest of all.
    pub most_pieces: usize,
    pub fewest_rows: usize,
}

impl Source<'_> {
    /// `failure` of the table, with what is said behind one.
    pub fn of_table(&self, failure: Failure) -> Failure {
        match self.hint {
            "" => failure,
            hint => Failure::of_kind(failure.kind(), format!("{failure}\n{hint}")),
        }
    }
}

/// A column: value = scale · unit · number + add.
pub struct Read {
    pub name: String,
    pub quantity: Quantity,
    pub scale: f64,
    pub add: f64,
    pub numbers: Vec<f64>,
}

/// Keeps the values of these rows.
pub fn keep(values: &mut Vec<f64>, rows: &[Range<usize>]) {
    let mut to = 0;
    for rows in rows {
        values.copy_within(rows.clone(), to);
        to += rows.len();
    }
    values.truncate(to);
}

/// The rows of a record.
pub struct Rows {
    pub columns: Vec<Read>,
    /// Name of the column of stamps, and the stamps [s].
    pub time: Option<(String, Vec<f64>)>,
    /// Whether the record has stamps, also if its rows are counted.
    pub has_stamps: bool,
    /// Rate of rows that are counted; otherwise there are stamps.
    pub rate_hz: Option<f64>,
    pub count: usize,
    /// Number of rows that were left out, and the line of the first.
    pub left_out: Option<(usize, u64)>,
    /// Line of a row, from 0.
    pub line: Box<dyn Fn(usize) -> u64>,
    /// The `[imu]` that reads it in the same way.
    pub taken: Option<Box<LogMapping>>,
}

/// Why rows cannot be read, and in which file: that of the record, or one beside it.
pub struct Unread {
    pub file: PathBuf,
    pub failure: Failure,
}

impl Rows {
    /// Leaves out rows that repeat the one before with stamp and all values: recorders write some twice. Their number. Where other rows
    /// have the stamp of the one before, stamps come in batches, in which held values may be the same.
    pub fn drop_repeats(&mut self) -> usize {
        let Some((_, times_s)) = &mut self.time else { return 0 };
        let is_same = |row: usize| times_s[row] == times_s[row - 1];
        let repeats = |row: usize| self.columns.iter().all(|one| one.numbers[row] == one.numbers[row - 1]);
        let dropped: Vec<usize> = (1..times_s.len()).filter(|row| is_same(*row)).collect();
        if dropped.is_empty()
            || dropped.len() > times_s.len() / FEW_REPEATS
            || !dropped.iter().all(|row| repeats(*row))
        {
            return 0;
        }
        let ends = dropped.iter().copied().chain([times_s.len()]);
        let mut begin = 0;
        let pieces: Vec<Range<usize>> = ends.map(|end| std::mem::replace(&mut begin, end + 1)..end).collect();
        keep(times_s, &pieces);
        self.columns.iter_mut().for_each(|column| keep(&mut column.numbers, &pieces));
        self.count -= dropped.len();
        let line = std::mem::replace(&mut self.line, Box::new(|_| 0));
        let lost: Vec<usize> = dropped.iter().enumerate().map(|(before, row)| row - before).collect();
        self.line = Box::new(move |row| line(row + lost.partition_point(|first| *first <= row)));
        dropped.len()
    }

    pub fn read(source: &Source<'_>, input: impl Input) -> Result<Self, Unread> {
        match source.mapping {
            Some(mapping) => Self::of_mapping(source, mapping, input),
            None => Self::of_names(source, input)
                .map_err(|failure| Unread { file: source.path.to_owned(), failure }),
        }
    }

    /// The columns that the names and the command line say.
    fn of_names(source: &Source<'_>, input: impl Input) -> Result<Self, Failure> {
        let Source { path, flag, rate_hz, .. } = *source;
        let Plain { input, separator, is_marked } =
            plain(input).map_err(|error| Failure::of_input(path, &error))?;
        let mut instance = None;
        let mut guess = Guess { separator, is_marked, rate_hz, ..Guess::default() };
        let mut table = Table::read_some(path, input, |names| {
            guess.columns =
                choose(names, source.columns, flag).map_err(|failure| Failure::of_line(path, 1, &failure))?;
            guess.time = quantity::stamps(names, source.columns);
            guess.names = names.to_vec();
            instance = names.iter().find(|name| INSTANCES.contains(&name.to_lowercase().as_str())).cloned();
            let clock = guess.time.iter().find_map(|(name, stamp)| match stamp {
                Stamp::Clock(format) => {
                    let mapping = LogMapping { time_format: *format, ..LogMapping::default() };
                    Some((name.clone(), Clock::new(&mapping)))
                }
                Stamp::Number(_) => None,
            });
            let names =
                guess.columns.iter().map(|(name, _)| name).chain(guess.time.iter().map(|(name, _)| name));
            let names = names.chain(&instance);
            // Where rows are counted, a row that is left out would move those behind it.
            let may_have_holes = rate_hz.is_none() && guess.time.is_some();
            Ok(Chosen { names: names.cloned().collect(), clock, may_have_holes, most: Some(MOST_ROWS) })
        })?;
        if let Some(name) = &instance {
            let of_rows = table.take(name)?;
            if of_rows.iter().any(|number| *number != of_rows[0]) {
                let what = format!(
                    "column {name} has several numbers, as of several sensors; an [imu] (--imu-map) with only_column = \"{name}\" and \
                     only = \"{}\" reads the rows of one",
                    of_rows[0]
                );
                return Err(Failure::of_line(path, 1, &what));
            }
        }
        if guess.time.is_none() && rate_hz.is_none() {
            let header = table.header();
            let what = format!(
                "expected a column \"time_s\" in the header, --rate, or {flag} \"NAME=s\"; the header has {header}"
            );
            return Err(Failure::of_line(path, 1, &what));
        }
        let time: Option<Result<_, Failure>> = guess.time.as_ref().map(|(name, stamp)| {
            // The stamps of rows that are counted are not read.
            let mut times_s = if rate_hz.is_some() { Vec::new() } else { table.take(name)? };
            if let Stamp::Number(unit) = stamp {
                times_s.iter_mut().for_each(|time| *time *= unit);
            }
            Ok((name.clone(), times_s))
        });
        let time = time.transpose()?;
        let taken = taken::of(&guess);
        let columns = guess.columns.into_iter().map(|(name, quantity)| {
            let numbers = table.take(&name)?;
            Ok(Read { name, quantity, scale: 1.0, add: 0.0, numbers })
        });
        let columns = columns.collect::<Result<_, Failure>>()?;
        let (count, left_out) = (table.rows(), table.left_out());
        let line = Box::new(move |row| table.line(row));
        let has_stamps = time.is_some();
        Ok(Self { columns, time, has_stamps, rate_hz, count, left_out, line, taken })
    }

    /// The columns that `[imu]` says.
    fn of_mapping(source: &Source<'_>, mapping: &LogMapping, input: impl Input) -> Result<Self, Unread> {
        let path = source.path;
        let unread = |failure: Failure| Unread { file: path.to_owned(), failure };
        let mut taken = Box::new(mapping.clone());
        if source.rate_hz.is_some() {
            (taken.time_format, taken.rate_hz) = (TimeFormat::Row, source.rate_hz);
        }
        let bytes = read_whole(path, input).map_err(unread)?;
        let table = ImuTable::parse(&bytes, &taken, "").map_err(|error| of_log(path, error));
        let mut table = table.map_err(unread)?;
        drop(bytes);
        if table.lines.len() > MOST_ROWS {
            return Err(unread(Failure::of_file(path, &format!("more than {MOST_ROWS} rows"))));
        }
        let mut columns = read_as(std::mem::take(&mut table.columns), path).map_err(unread)?;
        let mut files: Vec<&str> = taken.columns.iter().map(|column| column.file.as_str()).collect();
        files.sort_unstable();
        files.dedup();
        for file in files.into_iter().filter(|file| !file.is_empty()) {
            // A file that is not there has no lines.
            let other = beside(path, file).map_err(|failure| Unread { file: PathBuf::new(), failure })?;
            let of_other = || {
                let parsed = ImuTable::parse(&read_bytes(&other)?, &taken, file);
                let mut of_other = parsed.map_err(|error| of_log(&other, error))?;
                check_stamps(&table, &of_other, path, &other)?;
                read_as(std::mem::take(&mut of_other.columns), &other)
            };
            let of_other = of_other().map_err(|failure| Unread { file: other.clone(), failure })?;
            columns.extend(of_other);
        }
        // In the order of the keys: gyros, then accelerometers.
        columns.sort_by_key(|(place, _)| *place);
        let columns = columns.into_iter().map(|(_, column)| column).collect();
        let lines = table.lines;
        let rate_hz = taken.rate_hz.filter(|_| taken.time_format == TimeFormat::Row);
        let time = rate_hz.is_none().then_some((table.time, table.times_s));
        let left_out = table.left_out.map(|(count, line)| (count as usize, line));
        let count = lines.len();
        let line = Box::new(move |row: usize| lines.get(row).copied().unwrap_or_default());
        let has_stamps = mapping.time_format != TimeFormat::Row;
        Ok(Self { columns, time, has_stamps, rate_hz, count, left_out, line, taken: Some(taken) })
    }
}

/// The columns of the table in `file`, each with the place of its key.
fn read_as(columns: Vec<ImuColumn>, file: &Path) -> Result<Vec<(usize, Read)>, Failure> {
    let read = |column: ImuColumn| {
        let quantity = mapped(&column).map_err(|failure| Failure::of_file(file, &failure))?;
        let place = IMU_QUANTITIES.iter().position(|its| column.key.ends_with(its.key)).unwrap_or_default();
        let ImuColumn { name, scale, add, numbers, .. } = column;
        Ok((place, Read { name, quantity, scale, add, numbers }))
    };
    columns.into_iter().map(read).collect()
}

/// Rejects a file beside the record whose rows are not at the times of the rows of the record: nothing is interpolated, which would
/// change the noise.
fn check_stamps(record: &ImuTable, other: &ImuTable, path: &Path, file: &Path) -> Result<(), Failure> {
    let (own, its) = (&record.times_s, &other.times_s);
    let name = excerpt(&path.display().to_string());
    if own.len() != its.len() {
        let what = format!("{} rows: must be the {} rows of {name}, at the same times", its.len(), own.len());
        return Err(Failure::of_file(file, &what));
    }
    let interval_s = match own.as_slice() {
        [first, .., last] => (last - first) / (own.len() - 1) as f64,
        _ => 0.0,
    };
    let limit_s = APART * interval_s;
    let apart = own.iter().zip(its).position(|(own_s, its_s)| (own_s - its_s).abs() > limit_s);
    let Some(row) = apart else { return Ok(()) };
    let what = format!(
        "{} s: must be within {} s of the time of that row in {name}, {} s",
        its[row],
        crate::units::significant(limit_s),
        own[row]
    );
    Err(Failure::of_line(file, other.lines[row], &what))
}
