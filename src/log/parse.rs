//! Logs from texts: tables and flight records.

use csv::StringRecord;

use super::columns::{columns, only_place, unread};
use super::foreign::foreign;
use super::lines::{cells, check_line, names_of, next_row, reader, single_blanks, with_row_names};
use super::reading::Reading;
use super::record::FlightRecord;
use super::rows::Cells;
use super::text::decoded;
use super::unread::Evidence;
use super::{ColumnFrom, FlightLog, LogError, LogMapping, MAX_COLUMNS, Separator, fault};
use crate::base::text::Fault;

impl FlightLog {
    /// Reads the log in a text: at least two samples, in the order of time, with values in their ranges. How they follow each
    /// other is checked when they are pushed.
    pub fn parse(text: &[u8]) -> Result<Self, LogError> {
        Self::parse_with(text, &LogMapping::default())
    }

    /// As [`FlightLog::parse`], of a table that is read as `mapping` says. A row in which a value is missing is then left out; so is, of
    /// a log that will be smoothed, a row that is not later than the one before. The text may also be a flight record in IGC, GPX or FDR,
    /// whose columns have the names of the library's own: such a log is to be smoothed.
    pub fn parse_with(text: &[u8], mapping: &LogMapping) -> Result<Self, LogError> {
        let text = decoded(text).map_err(LogError::Memory)?;
        let kind = foreign(text.as_bytes());
        let record = kind.map(|kind| FlightRecord::read(kind, &text)).transpose()?.flatten();
        let log = match &record {
            Some(record) => Self::of_record(record, mapping),
            None => Self::of_table(text.as_bytes(), mapping).map_err(|error| match (&error, kind) {
                (LogError::Fault(_), Some(what)) if !mapping.is_foreign() => fault(
                    1,
                    1,
                    format!("is {what}: expected a flight log, a table of comma-separated values"),
                ),
                _ => error,
            }),
        };
        log.map(|log| Self { mapping: kept(mapping), ..log })
    }

    // Of its own stack frame: a mapping takes several KB, and a table takes the most of the stack.
    #[inline(never)]
    fn of_record(record: &FlightRecord, mapping: &LogMapping) -> Result<Self, LogError> {
        let mapping = record.complete(mapping)?;
        let names = StringRecord::from(record.names);
        let columns = columns(&names, 0, &mapping)?;
        let mut notes = vec![Fault { sentence: record.note.clone(), ..Fault::default() }];
        notes.extend(unread(&names, 0, &columns, &mapping));
        let evidence = Evidence::of_record(&record.beside);
        let mut reading = Reading::new(String::new(), columns, notes, &mapping, evidence);
        let mut last = 0;
        for (numbers, line) in record.rows() {
            reading.row(Cells::Numbers(numbers), line)?;
            last = line;
        }
        reading.finish(last)
    }

    fn of_table(text: &[u8], mapping: &LogMapping) -> Result<Self, LogError> {
        let comment = mapping.comment.as_bytes().first().copied().unwrap_or(b'#');
        // The first comment of another program holds its own data.
        let title = if mapping.is_foreign() { String::new() } else { title(text, comment) };
        let begin = |names: &StringRecord, line: u64| {
            let has_names = mapping.header > 0;
            let columns = columns(names, line, mapping)?;
            let notes = if has_names { unread(names, line, &columns, mapping) } else { Vec::new() };
            let evidence = match has_names {
                true => Evidence::new(names, line, &columns, mapping, only_place(names, line, mapping)?),
                false => Evidence::of_record(&[]),
            };
            Ok(Reading::new(title, columns, notes, mapping, evidence))
        };
        let (reading, last) = read_table(text, mapping, begin)?;
        reading.finish(last)
    }
}

/// What takes the rows of a table.
pub trait Take {
    /// Takes the row on `line`.
    fn row(&mut self, row: &StringRecord, line: u64) -> Result<(), LogError>;
    /// Leaves the row on `line` out.
    fn leave_out(&mut self, line: u64);
    /// Leaves the last row out, which is cut off.
    fn cut_off(&mut self, line: u64);
    /// Counts a row of another vehicle.
    fn other(&mut self);
    /// Whether no row was taken yet.
    fn is_empty(&self) -> bool;
}

/// Reads the rows of a table into what `begin` makes of its names and their line; with the number of line ends.
pub fn read_table<T: Take>(
    text: &[u8],
    mapping: &LogMapping,
    begin: impl FnOnce(&StringRecord, u64) -> Result<T, LogError>,
) -> Result<(T, u64), LogError> {
    for (line, number) in text.split_inclusive(|byte| *byte == b'\n').zip(1..) {
        check_line(line).map_err(|sentence| fault(number, 1, sentence))?;
    }
    let comment = mapping.comment.as_bytes().first().copied().unwrap_or(b'#');
    // The reader takes a comment without a line end, which can only be the last line, for a row.
    let last = text.iter().rposition(|byte| *byte == b'\n').map_or(0, |newline| newline + 1);
    let text = if text[last..].starts_with(&[comment]) { &text[..last] } else { text };
    let with_single_blanks =
        if mapping.separator == Separator::Blanks { single_blanks(text)? } else { Vec::new() };
    let text = if with_single_blanks.is_empty() { text } else { &with_single_blanks };
    let mut rows = TextRows { reader: reader(text, mapping.separator, Some(comment)), text, comment };
    let mut row = StringRecord::new();
    let line = rows.header(mapping, &mut row)?;
    let has_names = mapping.header > 0;
    let names = if has_names { names_of(&row, mapping.separator) } else { row.clone() };
    let names = if has_names && mapping.is_foreign() {
        let rest = text.get(rows.reader.position().byte() as usize..).unwrap_or_default();
        let first = rest.split(|byte| *byte == b'\n').find(|line| !line.trim_ascii().is_empty());
        with_row_names(names, &String::from_utf8_lossy(first.unwrap_or_default()), mapping.separator)
    } else {
        names
    };
    let mut taken = begin(&names, line).map_err(|error| with_later_header(error, text, mapping))?;
    let only = only_place(&names, line, mapping)?;
    let header = Header {
        names: has_names.then(|| row.clone()),
        width: names.len(),
        is_foreign: mapping.is_foreign(),
    };
    // Without names the first row is one of values.
    let mut next = if has_names { rows.next_of_values(&mut row)? } else { Some(line) };
    let mut to_skip = mapping.skip;
    let ends = text.iter().filter(|byte| **byte == b'\n').count() as u64;
    let unended = (!text.ends_with(b"\n")).then_some(ends + 1);
    let mut widest = 0;
    while let Some(line) = next {
        let is_cut = unended == Some(line) && row.len() < widest;
        widest = widest.max(row.len());
        if to_skip > 0 {
            to_skip -= 1;
        } else if is_cut {
            taken.cut_off(line);
        } else if header.is_early(&row) && taken.is_empty() {
            taken.leave_out(line);
        } else if !header.passes(&row) {
            header.check_width(&row, line)?;
            match only.is_none_or(|place| row.get(place) == Some(&mapping.only)) {
                true => taken.row(&row, line)?,
                false => taken.other(),
            }
        }
        next = rows.next_of_values(&mut row)?;
    }
    Ok((taken, ends))
}

/// A fault about columns that are not in the header, with the line that has all names of `[log]`, if there is one.
fn with_later_header(error: LogError, text: &[u8], mapping: &LogMapping) -> LogError {
    const LINES: usize = 30;
    let wanted: Vec<&str> = mapping
        .columns
        .iter()
        .filter_map(|column| match &column.from {
            ColumnFrom::Name(name) if column.file.is_empty() => Some(name.as_str()),
            _ => None,
        })
        .collect();
    let lines = text.split(|byte| *byte == b'\n').take(LINES).zip(1u64..);
    let mut lines = lines.filter(|(_, number)| *number != mapping.header);
    let has_all = |line: &[u8]| {
        let row = names_of(&cells(&String::from_utf8_lossy(line), mapping.separator), mapping.separator);
        wanted.iter().all(|name| row.iter().any(|cell| cell == *name))
    };
    match (error, lines.find(|(line, _)| !wanted.is_empty() && has_all(line))) {
        (LogError::Fault(fault), Some((_, number))) => {
            let sentence = format!("{}; line {number} has them: is it header = {number}?", fault.sentence);
            LogError::Fault(Fault { sentence, ..fault })
        }
        (error, _) => error,
    }
}

/// The mapping as a log keeps it.
// Of its own stack frame, as `of_record`.
#[inline(never)]
pub fn kept(mapping: &LogMapping) -> Option<Box<LogMapping>> {
    (*mapping != LogMapping::default()).then(|| Box::new(mapping.clone()))
}

/// The rows of a text.
struct TextRows<'t> {
    reader: csv::Reader<&'t [u8]>,
    text: &'t [u8],
    comment: u8,
}

impl TextRows<'_> {
    /// Reads the next row, and gives its line; `None` at the end.
    fn next(&mut self, row: &mut StringRecord) -> Result<Option<u64>, LogError> {
        next_row(&mut self.reader, self.text, self.comment, row)
    }

    /// As [`Self::next`], without comments that begin behind blanks. Names may stand behind such a mark.
    fn next_of_values(&mut self, row: &mut StringRecord) -> Result<Option<u64>, LogError> {
        loop {
            let from = self.reader.position().byte() as usize;
            let next = self.next(row)?;
            let end = self.reader.position().byte() as usize;
            let read = self.text.get(from..end).unwrap_or_default().trim_ascii_end();
            let line = read.rsplit(|byte| *byte == b'\n').next().unwrap_or_default();
            if next.is_none() || line.trim_ascii_start().first() != Some(&self.comment) {
                return Ok(next);
            }
        }
    }

    /// Reads the row of the names, or the first of the values of a table without them, and gives its line.
    fn header(&mut self, mapping: &LogMapping, row: &mut StringRecord) -> Result<u64, LogError> {
        let first = loop {
            let next = if mapping.header > 0 { self.next(row)? } else { self.next_of_values(row)? };
            match next {
                Some(line) if line < mapping.header => {}
                first => break first,
            }
        };
        let none = || {
            let expected = if mapping.is_foreign() {
                String::new()
            } else {
                ", as time_s,latitude_rad,longitude_rad,height_m,roll_rad,pitch_rad,heading_rad".to_owned()
            };
            fault(1, 1, format!("no header: expected the names of the columns{expected}"))
        };
        let line = first.ok_or_else(none)?;
        if row.len() > MAX_COLUMNS {
            return Err(fault(line, 1, format!("{} columns: a log has at most {MAX_COLUMNS}", row.len())));
        }
        Ok(line)
    }
}

/// What the rows of a table are compared with.
struct Header {
    /// The row of the names, if there is one.
    names: Option<StringRecord>,
    /// Number of columns.
    width: usize,
    /// Whether the table is another than one of the library's own.
    is_foreign: bool,
}

impl Header {
    /// Whether a row of a foreign table is passed over: a recorder that begins anew writes the names anew; a line of blanks has one cell.
    fn passes(&self, row: &StringRecord) -> bool {
        let is_blank = || row.len() < self.width && row.iter().all(str::is_empty);
        self.is_foreign && (is_blank() || self.names.as_ref() == Some(row))
    }

    /// Whether a row of a foreign table is short, as those before the first fix may be.
    fn is_early(&self, row: &StringRecord) -> bool {
        self.is_foreign && row.len() < self.width && !self.passes(row)
    }

    /// Rejects a row with more fields than columns. Decimal commas do this: each value is cut in two, and what stands behind it moves to
    /// the next column.
    fn check_width(&self, row: &StringRecord, line: u64) -> Result<(), LogError> {
        let width = self.width;
        if row.iter().skip(width).all(|field| self.is_foreign && field.is_empty()) {
            return Ok(());
        }
        let sentence =
            format!("{} fields, and the header names {width} columns; are there decimal commas?", row.len());
        Err(fault(line, width + 1, sentence))
    }
}

/// The comment with which a log begins.
fn title(text: &[u8], comment: u8) -> String {
    let mark = char::from(comment);
    let first = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
    let first = String::from_utf8_lossy(first);
    let comment = first.strip_prefix(mark).unwrap_or_default();
    comment.trim_start_matches(mark).trim().chars().filter(|letter| !letter.is_control()).take(160).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{FlightLog, LogError};
    use crate::scene::Scene;

    fn read(keys: &str, table: &str) -> Result<FlightLog, LogError> {
        let text = format!("[flight]\nfile = \"a.csv\"\n[log]\n{keys}");
        let scene = Scene::parse(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}"));
        assert_eq!(Scene::parse(scene.write().as_bytes()).unwrap().log, scene.log);
        FlightLog::parse_with(table.as_bytes(), &scene.log)
    }

    const KEYS: &str = "time = \"Uhrzeit\"\nlatitude = \"Breite\"\nlongitude = \"Lon\"\nheight = 0\nroll = 0\npitch = 0\nheading = 0\n";

    /// A recorder without power ends within a line; a whole last line needs no end.
    #[test]
    fn a_last_line_that_is_cut_off_is_left_out() {
        let rows = "0,47,8,1\n1,47.01,8.01,1\n2,47.02,8.02,1\n";
        for (end, count) in [("", 3), ("3,47.03,8.03,1", 4), ("3,47.0", 3), ("3,47.03,8", 3), ("3", 3)] {
            for (keys, names) in [
                (KEYS, "Uhrzeit,Breite,Lon,n\n"),
                ("", "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg\n"),
            ] {
                let more = if keys.is_empty() { ",0,0,0" } else { "" };
                let is_whole = end.matches(',').count() == 3;
                let rows = rows.replace('\n', &format!("{more}\n"));
                let end = if is_whole { format!("{end}{more}") } else { end.to_owned() };
                let log = read(keys, &format!("{names}{rows}{end}")).unwrap();
                assert_eq!(log.samples().len(), count, "{end}");
                let cut = log.notes().iter().find(|note| note.sentence.contains("cut off"));
                assert_eq!(cut.map(|note| note.line), (count == 3 && !end.is_empty()).then_some(5), "{end}");
            }
        }
        // A short row within the table is a fault, and so is a short last line that has an end.
        for table in ["0,47,8,1\n1,47\n2,47.02,8.02,1\n", "0,47,8,1\n1,47.01,8.01,1\n2,47\n"] {
            assert!(read(KEYS, &format!("Uhrzeit,Breite,Lon,n\n{table}")).is_err(), "{table}");
        }
        let log = read(KEYS, &format!("Uhrzeit,Breite,Lon,n\n0\n0.5,47\n{}", &rows[9..])).unwrap();
        assert_eq!(log.samples().len(), 2);
        assert_eq!(log.notes()[0].sentence, "2 rows are left out, the first here: a value is missing");
    }

    #[test]
    fn midnight_and_the_end_of_a_week_are_named() {
        for (last, next, what) in [
            (86399.0, 0.0, Some("midnight")),
            (86399.5, 0.5, Some("midnight")),
            (604_799.0, 0.0, Some("the end of a GPS week")),
            (86399.0, 86390.0, None),
            (5000.0, 0.0, None),
        ] {
            for smooth in ["", "smooth = \"auto\"\n"] {
                let table = format!(
                    "Uhrzeit,Breite,Lon,n\n{},47,8,1\n{last},47.01,8.01,1\n{next},47.02,8.02,1\n{},47.03,8.03,1\n",
                    last - 1.0,
                    next + 1.0
                );
                let found = read(&format!("{smooth}{KEYS}"), &table);
                match (what, found) {
                    (Some(what), Err(LogError::Fault(fault))) => {
                        assert!(fault.line == 4 && fault.sentence.contains(what), "{fault:?}");
                    }
                    (Some(what), found) => panic!("{what}: {found:?}"),
                    (None, Err(LogError::Fault(fault))) => {
                        assert!(fault.sentence.contains("not later than"), "{fault:?}");
                    }
                    (None, found) => assert!(!smooth.is_empty(), "{found:?}"),
                }
            }
        }
    }

    /// A quote that is never closed would swallow the rows behind it.
    #[test]
    fn a_row_of_several_lines_is_refused_at_its_line() {
        let rows = "0,47,8,\"a, b\"\n\n1,47.01,8.01,c\n# note\n2,47.02,8.02,\"d\"\n";
        assert_eq!(read(KEYS, &format!("Uhrzeit,Breite,Lon,n\n{rows}")).unwrap().samples().len(), 3);
        for (from, to, line) in [
            (",c\n", ",\"c\n", 4),
            (",\"a, b\"", ",\"a, b", 2),
            (",\"a, b\"", ",\"a\nb\"", 2),
            ("1,47.01", "1,\"47.01", 4),
        ] {
            for end in ["\n", "\r\n"] {
                let table = format!("Uhrzeit,Breite,Lon,n\n{}", rows.replace(from, to)).replace('\n', end);
                let Err(LogError::Fault(fault)) = read(KEYS, &table) else { panic!("{table}") };
                assert_eq!(fault.line, line, "{table}: {fault:?}");
                assert!(fault.sentence.starts_with("a row goes on in the next line"), "{fault:?}");
            }
        }
    }

    #[test]
    fn names_in_a_later_line_are_pointed_at() {
        let table = "Messung 7\nUhrzeit;Breite;Lon\n0;47;8\n1;47,01;8\n";
        let keys = format!("separator = \"semicolon\"\n{KEYS}");
        let Err(LogError::Fault(fault)) = read(&keys, table) else { panic!() };
        assert!(fault.sentence.contains("no column Uhrzeit"), "{fault:?}");
        assert!(fault.sentence.ends_with("line 2 has them: is it header = 2?"), "{fault:?}");
        let log = read(&format!("header = 2\n{keys}"), table).unwrap();
        assert!((log.samples()[1].place.latitude_rad.to_degrees() - 47.01).abs() < 1e-9);
        let Err(LogError::Fault(fault)) = read(&keys, &table.replace("Lon", "x")) else { panic!() };
        assert!(!fault.sentence.contains("header = 2"), "{fault:?}");
    }
}
