//! A fault of a text: its place, a sentence, and what it concerns.

use core::fmt;

/// One fault of a scene or of a flight log.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Fault {
    /// Line, from 1; 0: the fault is in a setting ([`Scene::parse_with`](crate::scene::Scene::parse_with)), or, of a scene that is
    /// changed, in a value that the change leaves.
    pub line: usize,
    /// Column, in characters from 1; for a setting its number, from 1; 0: in a value that a change leaves.
    pub column: usize,
    /// Sentence that names key, value and limit.
    pub sentence: String,
    /// The value, section or item that the fault concerns.
    pub about: About,
}

/// The value, section or item that a fault of a scene concerns, for programs.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct About {
    /// Path of the value, as [`Scene::value`](crate::scene::Scene::value) takes it, or of the section or the item; empty: of none.
    pub path: String,
    /// The value at fault, in the unit of the key; `None`: the fault is not the value of a number.
    pub value: Option<f64>,
    /// Least value, in the unit of the key, if there is one.
    pub minimum: Option<f64>,
    /// Greatest value, in the unit of the key, if there is one.
    pub maximum: Option<f64>,
    /// It is no fault of the text: there was not enough memory.
    pub lacks_memory: bool,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.sentence)
    }
}
