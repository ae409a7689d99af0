//! What a session says. A terminal that is gone, or a full disk behind standard output, ends no flight.

use crate::failure::Failure;
use crate::terminal;

/// Standard output and standard error of a session.
#[derive(Debug, Default)]
pub struct Voice {
    is_quiet: bool,
    /// Why standard output cannot be written: then nothing more is.
    failure: Option<Failure>,
}

impl Voice {
    pub fn new(is_quiet: bool) -> Self {
        Self { is_quiet, failure: None }
    }

    pub fn is_quiet(&self) -> bool {
        self.is_quiet
    }

    /// Writes on standard output.
    pub fn print(&mut self, text: &str) {
        if !self.is_quiet && self.failure.is_none() {
            self.failure = terminal::print(text).err();
        }
    }

    /// Writes a message on standard error.
    pub fn say(&self, text: &str) {
        if !self.is_quiet {
            terminal::say(text);
        }
    }

    /// Why standard output could not be written.
    pub fn end(self) -> Option<Failure> {
        self.failure
    }
}
