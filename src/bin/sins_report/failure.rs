//! Why the report could not be written: one sentence that names file, line, column and what was expected.

use std::fmt;
use std::path::Path;

/// The sentence.
#[derive(Debug)]
pub struct Failure(String);

impl Failure {
    pub fn new(sentence: impl Into<String>) -> Self {
        Self(sentence.into())
    }

    /// About a whole file.
    pub fn of_file(path: &Path, what: &dyn fmt::Display) -> Self {
        Self(format!("{}: {what}", path.display()))
    }

    /// About a line of a file, counted from 1.
    pub fn of_line(path: &Path, line: u64, what: &dyn fmt::Display) -> Self {
        Self(format!("{}, line {line}: {what}", path.display()))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl From<sins::recommend::Refusal> for Failure {
    fn from(refusal: sins::recommend::Refusal) -> Self {
        Self(refusal.to_string())
    }
}

impl From<sins::Error> for Failure {
    fn from(error: sins::Error) -> Self {
        Self(error.to_string())
    }
}

impl From<lexopt::Error> for Failure {
    fn from(error: lexopt::Error) -> Self {
        Self(error.to_string())
    }
}

impl<E: std::error::Error + Send + Sync> From<plotters::drawing::DrawingAreaErrorKind<E>> for Failure {
    fn from(error: plotters::drawing::DrawingAreaErrorKind<E>) -> Self {
        Self(format!("a figure could not be drawn: {error}"))
    }
}
