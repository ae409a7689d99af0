//! Faults of a text, each with its place and a sentence.

use core::ops::Range;

use super::site::Site;
use super::table::KEYS;
use crate::base::text::{About, Fault};

/// Largest number of faults that are kept of one text. A text with more is not read further.
pub const MAX_FAULTS: usize = 200;

/// The faults of `text` so far.
#[derive(Debug)]
pub struct Faults<'a> {
    text: &'a str,
    found: Vec<(usize, String, About)>,
    /// Contents of the text: each place with its section or item, and its key.
    names: Vec<(usize, Site, Option<usize>)>,
}

impl<'a> Faults<'a> {
    pub fn new(text: &'a str) -> Self {
        Self { text, found: Vec::new(), names: Vec::new() }
    }

    /// The span of setting `index`: behind the text.
    pub fn setting_span(&self, index: usize) -> Range<usize> {
        let start = self.text.len() + 1 + index;
        start..start
    }

    /// Records the key, section or item at `span` [bytes].
    pub fn name(&mut self, span: &Range<usize>, site: Site, key: Option<usize>) {
        self.names.push((span.start, site, key));
    }

    /// Reports a fault of the key, section or item at `span` [bytes].
    pub fn add(&mut self, span: &Range<usize>, sentence: impl Into<String>) {
        self.add_about(span, sentence, About::default());
    }

    /// Reports a fault at `span` [bytes], and what it concerns.
    pub fn add_about(&mut self, span: &Range<usize>, sentence: impl Into<String>, about: About) {
        if !self.are_many() {
            self.found.push((span.start, sentence.into(), about));
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
        self.found.sort_by_key(|(at, ..)| *at);
        let found = core::mem::take(&mut self.found);
        found.into_iter().map(|(at, sentence, about)| self.fault(at, sentence, about)).collect()
    }

    fn fault(&self, at: usize, sentence: String, mut about: About) -> Fault {
        if about.path.is_empty()
            && let Some((_, site, key)) = self.names.iter().find(|(place, ..)| *place == at)
        {
            about.path = key.map_or(site.to_string(), |key| format!("{site}.{}", KEYS[key].name));
        }
        if at > self.text.len() {
            return Fault { line: 0, column: at - self.text.len(), sentence, about };
        }
        let before = self.text.get(..at).unwrap_or(self.text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let column = 1 + before[line_start..].chars().count();
        Fault { line: 1 + before.matches('\n').count(), column, sentence, about }
    }
}
