//! A variable of the unit: an input, a parameter or an output.

use crate::values::Value;

/// Role of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Set by the master before each step.
    Input,
    /// A parameter that is set before the initialization ends.
    Fixed,
    /// A parameter that may also change in flight.
    Tunable,
    /// Read after each step.
    Output,
}

/// A variable as the model description states it.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    pub name: String,
    pub role: Role,
    /// Value before it is set; of an output, before the first step.
    pub start: Value,
    /// The words of an enumeration.
    pub words: Option<&'static [&'static str]>,
    pub unit: &'static str,
    /// Size of the unit in the SI unit.
    pub unit_si: f64,
    /// Usual size; 1 if it has none.
    pub nominal: f64,
    /// Smallest and largest number, in the unit of the variable.
    pub limits: Option<(f64, f64)>,
    pub doc: String,
}

impl Variable {
    /// A variable without unit.
    pub fn new(name: impl Into<String>, role: Role, start: Value, doc: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            role,
            start,
            words: None,
            unit: "",
            unit_si: 1.0,
            nominal: 1.0,
            limits: None,
            doc: doc.into(),
        }
    }

    /// This variable with a unit.
    pub fn in_unit(self, unit: &'static str, unit_si: f64) -> Self {
        Self { unit, unit_si, ..self }
    }
}
