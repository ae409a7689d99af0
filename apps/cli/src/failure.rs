//! Reasons why the program stopped: a sentence that names file, line, column and what was expected.

use std::fmt;
use std::path::Path;
use std::process::ExitCode;

/// The kind of failure, which sets the exit code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A file or an option that cannot be used.
    Input,
    /// The machine: a folder that cannot be made; or a solution that left its range.
    Failed,
    /// A log that is doubtful, and only those without doubt were wanted.
    Doubtful,
    /// An output that cannot be written: the disk is full, or another program holds the file.
    Unwritten,
    /// Stopped by Ctrl-C, SIGTERM or SIGHUP.
    Interrupted,
    /// No options, or not enough runs, meet the requirement.
    NotMet,
    /// The runs are too few to decide whether they meet the requirement.
    Undecided,
}

/// The exit codes, for `--help`.
pub const EXIT_CODES: &str = "\
Exit codes:
  0    done; also a live flight that Ctrl-C ended
  1    failed: the solution diverged, or an output cannot be written. What was flown until then is written. Or a log is doubtful, with
       --strict; nothing is written then
  2    an option or an input file cannot be used, another run writes the same output, or live ended without a flight; nothing is written
       but the file of log --map with what it asks
  3    not met: recommend found no options for the requirement and printed the best; or the runs of an ensemble do not meet --meets
  4    ensemble: the runs are too few to decide whether they meet --meets
  130  interrupted by Ctrl-C, SIGTERM or SIGHUP: no temporary file is left, and all files are complete. A second one ends at once";

/// A failure: its kind and its sentences, one on each line.
#[derive(Debug)]
pub struct Failure {
    kind: Kind,
    sentence: String,
}

impl Failure {
    /// Failure about an input.
    pub fn new(sentence: impl Into<String>) -> Self {
        Self { kind: Kind::Input, sentence: sentence.into() }
    }

    /// Failure of the given kind.
    pub fn of_kind(kind: Kind, sentence: impl Into<String>) -> Self {
        Self { kind, sentence: sentence.into() }
    }

    /// Failure about a whole input file.
    pub fn of_file(path: &Path, what: &dyn fmt::Display) -> Self {
        Self::new(format!("{}: {what}", path.display()))
    }

    /// Failure about an input file that cannot be read.
    pub fn of_input(path: &Path, error: &dyn fmt::Display) -> Self {
        Self::of_file(path, &format!("cannot be read: {error}"))
    }

    /// Failure about a line of an input file, counted from 1.
    pub fn of_line(path: &Path, line: u64, what: &dyn fmt::Display) -> Self {
        Self::new(format!("{}:{line}: {what}", path.display()))
    }

    /// Failure about an output that cannot be written.
    pub fn of_output(path: &Path, error: &dyn fmt::Display) -> Self {
        Self::of_kind(Kind::Unwritten, format!("{}: cannot be written: {error}", path.display()))
    }

    /// One failure made of several: all sentences, and the kind of the first.
    pub fn all(failures: Vec<Self>) -> Self {
        let kind = failures.first().map_or(Kind::Input, |failure| failure.kind);
        let sentences: Vec<String> = failures.into_iter().map(|failure| failure.sentence).collect();
        Self { kind, sentence: sentences.join("\n") }
    }

    /// The failures among `results`, as one.
    pub fn each(results: impl IntoIterator<Item = Result<(), Self>>) -> Result<(), Self> {
        let failures: Vec<Self> = results.into_iter().filter_map(Result::err).collect();
        if failures.is_empty() { Ok(()) } else { Err(Self::all(failures)) }
    }

    /// The same failure with more about it.
    pub fn with(self, more: &dyn fmt::Display) -> Self {
        Self { sentence: format!("{}; {more}", self.sentence), ..self }
    }

    /// The kind of failure.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The exit code.
    pub fn code(&self) -> ExitCode {
        ExitCode::from(match self.kind {
            Kind::Failed | Kind::Unwritten | Kind::Doubtful => 1,
            Kind::Input => 2,
            Kind::NotMet => 3,
            Kind::Undecided => 4,
            Kind::Interrupted => 130,
        })
    }
}

impl fmt::Display for Failure {
    /// The sentence can contain text of files and paths: characters that would steer a terminal are replaced.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&printable(&self.sentence))
    }
}

impl From<sins::analysis::recommend::Refusal> for Failure {
    fn from(refusal: sins::analysis::recommend::Refusal) -> Self {
        Self::new(refusal.to_string())
    }
}

impl From<sins::Error> for Failure {
    fn from(error: sins::Error) -> Self {
        Self::new(error.to_string())
    }
}

/// `text` with a question mark for each character that would steer a terminal or hide text: control characters except line feed and
/// tab, and characters that turn the direction of writing.
pub fn printable(text: &str) -> String {
    let is_turning = |letter: char| matches!(letter, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let is_steering = |letter: char| letter.is_control() && letter != '\n' && letter != '\t';
    text.chars().map(|letter| if is_steering(letter) || is_turning(letter) { '?' } else { letter }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_terminal_is_not_steered() {
        let failure = Failure::of_line(Path::new("a\u{1b}[2Jb.csv"), 7, &"found \"\u{9b}31m\"\r");
        assert_eq!(failure.to_string(), "a?[2Jb.csv:7: found \"?31m\"?");
        let both = Failure::all(vec![Failure::new("one"), Failure::new("two")]);
        assert_eq!((both.to_string().as_str(), both.kind()), ("one\ntwo", Kind::Input));
    }
}
