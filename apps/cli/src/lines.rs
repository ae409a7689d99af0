//! The lines of a file that hold data: neither blank nor comments, each with its number.

use std::io::{BufRead, BufReader, Error, ErrorKind, Read, Result};

/// The bytes with which some editors begin a file in UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Longest line [bytes]: a pipe may have no line end at all.
const MAX_LINE: u64 = 1 << 24;

/// Passes the data on and counts the lines.
pub struct Lines<R: Read> {
    input: BufReader<R>,
    line: Vec<u8>,
    /// Number of bytes of the line that were passed on.
    given: usize,
    /// Number of lines that were read, and of those that were passed on.
    count: u64,
    passed: usize,
    numbers: Numbers,
}

/// The numbers of the lines that were passed on, counted from 1.
#[derive(Debug, Clone, Default)]
pub struct Numbers {
    /// The lines behind others that were left out: their place among the lines that were passed on, and their number.
    begins: Vec<(usize, u64)>,
}

impl Numbers {
    /// Number of the line at a place among those that were passed on, from 0.
    pub fn of(&self, place: usize) -> u64 {
        let behind = self.begins.partition_point(|begin| begin.0 <= place);
        self.begins[..behind].last().map_or(0, |begin| begin.1 + (place - begin.0) as u64)
    }
}

impl<R: Read> Lines<R> {
    pub fn new(input: R) -> Self {
        Self {
            input: BufReader::new(input),
            line: Vec::new(),
            given: 0,
            count: 0,
            passed: 0,
            numbers: Numbers::default(),
        }
    }

    pub fn numbers(&self) -> &Numbers {
        &self.numbers
    }

    fn advance(&mut self) -> Result<()> {
        loop {
            self.line.clear();
            self.given = 0;
            if (&mut self.input).take(MAX_LINE + 1).read_until(b'\n', &mut self.line)? == 0 {
                return Ok(());
            }
            if self.line.len() as u64 > MAX_LINE {
                let what = format!("line {} has more than {MAX_LINE} bytes", self.count + 1);
                return Err(Error::new(ErrorKind::InvalidData, what));
            }
            self.count += 1;
            if self.count == 1 && self.line.starts_with(BYTE_ORDER_MARK) {
                self.line.drain(..BYTE_ORDER_MARK.len());
            }
            let text = self.line.trim_ascii_start();
            if !text.is_empty() && text[0] != b'#' {
                if self.numbers.begins.is_empty() || self.numbers.of(self.passed) != self.count {
                    self.numbers.begins.push((self.passed, self.count));
                }
                self.passed += 1;
                return Ok(());
            }
        }
    }
}

impl<R: Read> Read for Lines<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        if self.given == self.line.len() {
            self.advance()?;
        }
        let rest = &self.line[self.given..];
        let count = rest.len().min(buffer.len());
        buffer[..count].copy_from_slice(&rest[..count]);
        self.given += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_blank_lines_count_and_are_left_out() {
        let mut lines = Lines::new("a,b\r\n# later\n\n \n1,2\n  # last\n3,4".as_bytes());
        let mut text = String::new();
        lines.read_to_string(&mut text).unwrap();
        assert_eq!(
            (text.as_str(), [0, 1, 2].map(|place| lines.numbers().of(place))),
            ("a,b\r\n1,2\n3,4", [1, 5, 7])
        );
        let mut lines = Lines::new("\u{feff}# first\na,b\n1,2".as_bytes());
        text.clear();
        lines.read_to_string(&mut text).unwrap();
        assert_eq!((text.as_str(), [0, 1].map(|place| lines.numbers().of(place))), ("a,b\n1,2", [2, 3]));
        assert_eq!(lines.numbers().begins.len(), 1);
    }
}
