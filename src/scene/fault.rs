//! Faults of a text, each with its place and a sentence.

use core::fmt;
use core::ops::Range;

/// Largest number of faults that are kept of one text. A text with more is not read further.
pub const MAX_FAULTS: usize = 200;

/// One fault of a scene or of a flight log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Line, from 1; 0: the fault is in a setting ([`Scene::parse_with`](super::Scene::parse_with)).
    pub line: usize,
    /// Column, in characters from 1; for a setting its number, from 1.
    pub column: usize,
    /// Sentence that names key, value and limit.
    pub sentence: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.sentence)
    }
}

/// The faults of `text` so far.
#[derive(Debug)]
pub struct Faults<'a> {
    text: &'a str,
    found: Vec<(usize, String)>,
}

impl<'a> Faults<'a> {
    pub fn new(text: &'a str) -> Self {
        Self { text, found: Vec::new() }
    }

    /// The span of setting `index`: behind the text.
    pub fn setting_span(&self, index: usize) -> Range<usize> {
        let start = self.text.len() + 1 + index;
        start..start
    }

    /// Notes a fault of what stands at `span` [bytes].
    pub fn add(&mut self, span: &Range<usize>, sentence: impl Into<String>) {
        if !self.are_many() {
            self.found.push((span.start, sentence.into()));
        }
    }

    /// Whether the largest number of faults is reached.
    pub fn are_many(&self) -> bool {
        self.found.len() >= MAX_FAULTS
    }

    pub fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// The faults in the order of the text.
    pub fn into_list(mut self) -> Vec<Fault> {
        self.found.sort_by_key(|(at, _)| *at);
        self.found.iter().map(|(at, sentence)| self.fault(*at, sentence)).collect()
    }

    fn fault(&self, at: usize, sentence: &str) -> Fault {
        if at > self.text.len() {
            return Fault { line: 0, column: at - self.text.len(), sentence: sentence.to_owned() };
        }
        let before = self.text.get(..at).unwrap_or(self.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Fault {
            line: 1 + before.matches('\n').count(),
            column: 1 + before[line_start..].chars().count(),
            sentence: sentence.to_owned(),
        }
    }
}

/// The word of `words` that is nearest to `word`, if it is near enough to be meant.
pub fn nearest<'w>(word: &str, words: impl Iterator<Item = &'w str>) -> Option<&'w str> {
    // Longer than any word of the library: the distance takes the product of both lengths.
    const LONGEST: usize = 64;
    if word.len() > LONGEST {
        return None;
    }
    // A third of the letters may be wrong.
    let most = 1 + word.chars().count() / 3;
    words
        .filter(|other| other.len() <= LONGEST)
        .map(|other| (strsim::osa_distance(word, other), other))
        .filter(|(distance, _)| *distance <= most)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, other)| other)
}

/// A user's text as a message can quote it: short, without control characters.
pub fn excerpt(text: &str) -> String {
    const MOST: usize = 40;
    let printable = |letter: char| if letter.is_control() { '?' } else { letter };
    let mut short: String = text.chars().take(MOST).map(printable).collect();
    if text.chars().nth(MOST).is_some() {
        short.push_str("...");
    }
    short
}

/// The sentence about a name that there is not, and the `near`est that there is.
pub(super) fn unknown(what: &str, name: &str, near: Option<&str>) -> String {
    let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
    format!("no such {what}: {}{near}", excerpt(name))
}
