//! Lines of a table, and their cells.

use csv::{ReaderBuilder, StringRecord, Trim};

use super::{LogError, MAX_LINE, Separator, fault};
use crate::base::memory::room;

/// Checks a line with its end, so that each row has a line number of its own.
pub fn check_line(line: &[u8]) -> Result<(), String> {
    let line = line.strip_suffix(b"\n").map_or(line, |line| line.strip_suffix(b"\r").unwrap_or(line));
    if line.contains(&0) {
        return Err("a zero byte: not a text".to_owned());
    }
    if line.len() > MAX_LINE {
        return Err(format!("a line of {} bytes: a line has at most {MAX_LINE}", line.len()));
    }
    if line.contains(&b'\r') {
        return Err("a carriage return without a line feed: lines end with LF or CR LF".to_owned());
    }
    Ok(())
}

/// A reader of the rows of a text.
pub fn reader(text: &[u8], separator: Separator, comment: Option<u8>) -> csv::Reader<&[u8]> {
    ReaderBuilder::new()
        .comment(comment)
        .delimiter(separator.byte())
        .flexible(true)
        .has_headers(false)
        .trim(Trim::All)
        .from_reader(text)
}

/// The text with a single blank in place of several, and none at the ends of a line.
pub fn single_blanks(text: &[u8]) -> Result<Vec<u8>, LogError> {
    let mut single = room(text.len()).map_err(LogError::Memory)?;
    for byte in text {
        let byte = if *byte == b'\t' { b' ' } else { *byte };
        if matches!(byte, b'\r' | b'\n') && single.last() == Some(&b' ') {
            single.pop();
        }
        if byte != b' ' || !matches!(single.last(), None | Some(b' ' | b'\n')) {
            single.push(byte);
        }
    }
    if single.last() == Some(&b' ') {
        single.pop();
    }
    Ok(single)
}

/// The cells of a single line, as they are those of a row.
pub fn cells(line: &str, separator: Separator) -> StringRecord {
    let single = if separator == Separator::Blanks { single_blanks(line.as_bytes()).ok() } else { None };
    let line = single.as_deref().unwrap_or(line.as_bytes());
    let mut row = StringRecord::new();
    match reader(line, separator, None).read_record(&mut row) {
        Ok(true) => unquoted(row),
        _ => StringRecord::new(),
    }
}

/// The names of columns, with an empty one for the names of rows if only the first row of values has one: R writes these, in quotes, and
/// no name for them.
pub fn with_row_names(names: StringRecord, first: &str, separator: Separator) -> StringRecord {
    let first = first.trim_end();
    let is_named = first.starts_with('"') && first.matches('"').count() == 2;
    if !is_named || cells(first, separator).len() != names.len() + 1 {
        return names;
    }
    core::iter::once("").chain(names.iter()).collect()
}

/// The cells without quotes around them: the reader keeps those that stand behind a blank.
fn unquoted(row: StringRecord) -> StringRecord {
    if !row.iter().any(|cell| cell.starts_with('"')) {
        return row;
    }
    let bare = row
        .iter()
        .map(|cell| cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"')).map_or(cell, str::trim));
    bare.collect()
}

/// The cells without the mark of a comment before them. Between blanks it may stand alone.
pub fn unmarked(row: &StringRecord, separator: Separator) -> StringRecord {
    let mut cells = row.iter();
    let first = cells.next().map(|first| match first.trim_start_matches(['#', '%']).trim_start() {
        "" if separator == Separator::Blanks => None,
        "" => Some(first),
        name => Some(name),
    });
    first.flatten().into_iter().chain(cells).collect()
}

/// The names in a row. Between blanks a unit in brackets belongs to the name before it.
pub fn names_of(row: &StringRecord, separator: Separator) -> StringRecord {
    let row = unmarked(row, separator);
    let is_unit = |cell: &str| cell.starts_with(['[', '(']) && cell.ends_with([']', ')']);
    let mut names: Vec<String> = Vec::new();
    for cell in &row {
        match names.last_mut() {
            Some(name) if separator == Separator::Blanks && is_unit(cell) => *name += &format!(" {cell}"),
            _ => names.push(cell.to_owned()),
        }
    }
    names.into()
}

/// Reads the next row of `text` and gives its line; `None` at the end.
pub fn next_row(
    reader: &mut csv::Reader<&[u8]>,
    text: &[u8],
    comment: u8,
    row: &mut StringRecord,
) -> Result<Option<u64>, LogError> {
    let before = reader.position().clone();
    let rest = text.get(before.byte() as usize..).unwrap_or_default();
    // The reader's position is that before the empty lines and comments that it passes over.
    let skipped = || {
        let is_skipped = |line: &&[u8]| line.starts_with(&[comment]) || matches!(*line, b"" | b"\r");
        rest.split(|byte| *byte == b'\n').take_while(is_skipped)
    };
    let line = || before.line() + skipped().count() as u64;
    match reader.read_record(row) {
        Ok(true) => {
            let begin: usize = skipped().map(|line| line.len() + 1).sum();
            let end = (reader.position().byte() - before.byte()) as usize;
            let record = rest.get(begin..end).unwrap_or_default().trim_ascii_end();
            if record.contains(&b'\n') {
                let sentence = "a row goes on in the next line: is the closing quote of a field missing?";
                return Err(fault(line(), 1, sentence.to_owned()));
            }
            *row = unquoted(core::mem::take(row));
            Ok(Some(line()))
        }
        Ok(false) => Ok(None),
        Err(_) => Err(fault(line(), 1, "not a row of comma-separated values".to_owned())),
    }
}
