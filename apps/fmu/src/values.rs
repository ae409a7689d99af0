//! Values of variables in one row for each base type of FMI. A value reference is a place in the row of its type.

/// The four base types. Enumerations are integers, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    Real,
    Integer,
    Boolean,
    String,
}

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Real(f64),
    Integer(i32),
    Boolean(bool),
    String(String),
}

impl Value {
    pub fn base(&self) -> Base {
        match self {
            Self::Real(_) => Base::Real,
            Self::Integer(_) => Base::Integer,
            Self::Boolean(_) => Base::Boolean,
            Self::String(_) => Base::String,
        }
    }
}

/// A row for each base type.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Values {
    pub reals: Vec<f64>,
    pub integers: Vec<i32>,
    pub booleans: Vec<bool>,
    pub strings: Vec<String>,
}

impl Values {
    /// Appends a value; returns its place in its row.
    pub fn push(&mut self, value: Value) -> usize {
        fn push<T>(row: &mut Vec<T>, value: T) -> usize {
            row.push(value);
            row.len() - 1
        }
        match value {
            Value::Real(value) => push(&mut self.reals, value),
            Value::Integer(value) => push(&mut self.integers, value),
            Value::Boolean(value) => push(&mut self.booleans, value),
            Value::String(value) => push(&mut self.strings, value),
        }
    }

    /// The value at a place of a row.
    pub fn get(&self, base: Base, place: usize) -> Option<Value> {
        match base {
            Base::Real => self.reals.get(place).copied().map(Value::Real),
            Base::Integer => self.integers.get(place).copied().map(Value::Integer),
            Base::Boolean => self.booleans.get(place).copied().map(Value::Boolean),
            Base::String => self.strings.get(place).cloned().map(Value::String),
        }
    }

    /// Sets the value at a place of its row; `None` if there is no such place.
    pub fn set(&mut self, place: usize, value: Value) -> Option<()> {
        fn put<T>(row: &mut [T], place: usize, value: T) -> Option<()> {
            *row.get_mut(place)? = value;
            Some(())
        }
        match value {
            Value::Real(value) => put(&mut self.reals, place, value),
            Value::Integer(value) => put(&mut self.integers, place, value),
            Value::Boolean(value) => put(&mut self.booleans, place, value),
            Value::String(value) => put(&mut self.strings, place, value),
        }
    }
}
