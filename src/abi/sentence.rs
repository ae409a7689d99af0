//! The sentence of a failure.

use core::fmt::{self, Write};

use super::failure::CallError;

/// A sentence in a fixed buffer: made without an allocation, cut at a character.
#[derive(Clone, Copy)]
pub(super) struct Sentence {
    bytes: [u8; 512],
    len: usize,
}

impl Sentence {
    pub const EMPTY: Self = Self { bytes: [0; 512], len: 0 };

    pub fn new(text: fmt::Arguments<'_>) -> Self {
        let mut sentence = Self::EMPTY;
        // Writing never fails: what does not fit is cut.
        let _ = sentence.write_fmt(text);
        sentence
    }

    pub fn of(failure: Option<&CallError>) -> Self {
        match failure {
            Some(failure) => Self::new(format_args!("{failure}")),
            None => Self::new(format_args!("no error")),
        }
    }

    pub fn as_bytes(&self) -> &[u8] {
        &self.bytes[..self.len]
    }

    /// It was cut between two characters.
    pub fn as_str(&self) -> &str {
        core::str::from_utf8(self.as_bytes()).unwrap_or_default()
    }
}

impl Write for Sentence {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let room = self.bytes.len() - self.len;
        let mut take = text.len().min(room);
        while !text.is_char_boundary(take) {
            take -= 1;
        }
        self.bytes[self.len..self.len + take].copy_from_slice(&text.as_bytes()[..take]);
        self.len += take;
        Ok(())
    }
}
