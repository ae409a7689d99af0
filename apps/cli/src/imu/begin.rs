//! The begin of a table: a header behind a "#", and separators other than commas.

use std::io::{Cursor, Read, Result};

/// Bytes in which the header and the first row are looked for.
const BEGIN: u64 = 1 << 16;

/// A table with commas, whose header is a line of its own.
pub struct Plain<R> {
    pub input: R,
    /// What separated its fields.
    pub separator: u8,
    /// Whether its header stood behind a "#".
    pub is_marked: bool,
}

/// The table in a plain form.
///
/// A first line "#timestamp [ns],w_RS_S_x [rad s^-1]" is a header, and no comment, if it has as many fields as the row below it, and that
/// row is one of numbers. Tabs and semicolons become commas if the header has no comma.
pub fn plain(mut input: impl Read) -> Result<Plain<impl Read>> {
    let mut begin = Vec::new();
    (&mut input).take(BEGIN).read_to_end(&mut begin)?;
    if begin.starts_with(b"\xef\xbb\xbf") {
        begin.drain(..3);
    }
    let mut lines = begin.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii).enumerate();
    let is_comment = |line: &[u8]| line.is_empty() || line.starts_with(b"#");
    let first = lines.clone().find(|(_, line)| !is_comment(line));
    let before = first.and_then(|(place, line)| {
        let separator = separator(line);
        let above = begin.split(|byte| *byte == b'\n').nth(place.checked_sub(1)?)?.trim_ascii();
        let fields = |line: &[u8]| line.split(|byte| *byte == separator).count();
        let is_number =
            |field: &[u8]| std::str::from_utf8(field).is_ok_and(|text| text.trim().parse::<f64>().is_ok());
        let is_header = above.starts_with(b"#") && fields(above) == fields(line) && fields(line) > 1;
        (is_header && line.split(|byte| *byte == separator).all(is_number)).then_some(place - 1)
    });
    let header = match before {
        Some(place) => lines.find(|(line, _)| *line == place),
        None => first,
    };
    let separator = header.map_or(b',', |(_, line)| separator(line));
    if let Some((place, _)) = header.filter(|_| before.is_some()) {
        let start: usize = begin.split(|byte| *byte == b'\n').take(place).map(|line| line.len() + 1).sum();
        if let Some(mark) = begin[start..].iter().position(|byte| *byte == b'#') {
            begin[start + mark] = b' ';
        }
    }
    let input = Separated { input: Cursor::new(begin).chain(input), separator };
    Ok(Plain { input, separator, is_marked: before.is_some() })
}

fn separator(line: &[u8]) -> u8 {
    [b',', b'\t', b';'].into_iter().find(|byte| line.contains(byte)).unwrap_or(b',')
}

/// The input with commas in the place of another separator.
struct Separated<R: Read> {
    input: R,
    separator: u8,
}

impl<R: Read> Read for Separated<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let count = self.input.read(buffer)?;
        if self.separator != b',' {
            buffer[..count].iter_mut().filter(|byte| **byte == self.separator).for_each(|byte| *byte = b',');
        }
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> String {
        let mut out = String::new();
        plain(text.as_bytes()).unwrap().input.read_to_string(&mut out).unwrap();
        out
    }

    #[test]
    fn headers_behind_a_mark_and_tabs_are_read() {
        assert_eq!(read("#t [ns],w [rad s^-1]\n1,2\n"), " t [ns],w [rad s^-1]\n1,2\n");
        assert_eq!(read("# by me\n#t\tw\r\n1\t2\n"), "# by me\n t,w\r\n1,2\n");
        assert_eq!(read("t;w\n1;2\n"), "t,w\n1,2\n");
        // Comments above a header with names stay comments, as a header of another width does.
        for same in ["# a, b\nt,w\n1,2\n", "# a\n1,2\n", "", "#a,b\n", "t,w;x\n1,2\n"] {
            assert_eq!(read(same), same);
        }
    }
}
