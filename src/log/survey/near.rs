//! What a table seems to have whose columns are not understood.

use super::super::lines::{cells, names_of};
use super::super::text::decoded;
use super::super::words::words;
use super::super::{MAX_LINE, Separator};
use crate::base::text::{excerpt, listed, nearest};

/// Lines in which the names are looked for.
const LINES: usize = 20;

/// The names of a table, those of its line with most cells of words, and which of them are nearest to latitude and longitude, in a
/// sentence; `None`: it has no such line.
pub fn nearest_names(table: &[u8]) -> Option<String> {
    let table = decoded(table).ok()?;
    let separators = [Separator::Comma, Separator::Semicolon, Separator::Tab, Separator::Bar];
    let lines = table.lines().take(LINES).filter(|line| line.len() <= MAX_LINE);
    let rows =
        lines.flat_map(|line| separators.map(|separator| names_of(&cells(line, separator), separator)));
    let is_word = |cell: &str| cell.starts_with(char::is_alphabetic);
    let count = |row: &csv::StringRecord| row.iter().filter(|cell| is_word(cell)).count();
    let best = rows.fold(None, |best: Option<csv::StringRecord>, row| match best {
        Some(best) if count(&best) >= count(&row) => Some(best),
        _ => Some(row),
    });
    let names = best.filter(|names| count(names) > 1)?;
    let near = |key: &str, taken: Option<&str>| {
        let others = || names.iter().filter(|name| Some(*name) != taken);
        let begins = |name: &&str| words(name).iter().any(|word| word.starts_with(&key[..3]));
        others().find(begins).or_else(|| nearest(key, others())).map(str::to_owned)
    };
    let latitude = near("latitude", None);
    let longitude = near("longitude", latitude.as_deref());
    let asked = [("latitude", latitude), ("longitude", longitude)]
        .map(|(key, name)| name.map_or(String::new(), |name| format!("; is {} the {key}?", excerpt(&name))));
    Some(format!("it has the columns {}{}", listed(names.iter()), asked.concat()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_that_is_not_understood_has_names() {
        for (table, words) in [
            (
                "Foo,Bar,Latit,Longit\n1,2,47,8\n",
                "it has the columns Foo, Bar, Latit, Longit; is Latit the latitude?; is Longit the longitude?",
            ),
            ("id;x;lattitude\n1;2;3\n", "it has the columns id, x, lattitude; is lattitude the latitude?"),
            ("# a note\nid\tx\n1\t2\n", "it has the columns id, x"),
        ] {
            assert_eq!(nearest_names(table.as_bytes()).as_deref(), Some(words));
        }
        for table in ["", "1,2,3\n4,5,6\n", "hello\n"] {
            assert_eq!(nearest_names(table.as_bytes()), None, "{table}");
        }
    }
}
