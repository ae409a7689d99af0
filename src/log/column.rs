//! A column of `[log]`: where a quantity stands, and what its cells mean.

use super::quantity::{QUANTITIES, unit_of};
use crate::base::text::{number_text, text_in_quotes};

/// Where the values of a quantity stand.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum ColumnFrom {
    /// In the column of the quantity's own name, if the log has it.
    #[default]
    OwnName,
    /// In the column of this name.
    Name(String),
    /// In the column of this number, from 1.
    Number(usize),
    /// In no column: it is this number.
    Constant(f64),
}

impl ColumnFrom {
    /// In TOML; empty: it has its own name.
    fn text(&self) -> String {
        match self {
            Self::OwnName => String::new(),
            Self::Name(name) => text_in_quotes(name),
            Self::Number(number) => number.to_string(),
            Self::Constant(value) => number_text(*value),
        }
    }
}

/// The parts of a column of degrees that say where their minutes and seconds stand.
pub const SIXTIETHS: [&str; 2] = ["minutes", "seconds"];

/// How a quantity is read: value = scale · unit · cell + add.
#[derive(Debug, Clone, PartialEq)]
pub struct LogColumn {
    /// Where its values stand.
    pub from: ColumnFrom,
    /// Its unit; empty: deg, m, m/s, rad/s, m/s², °C or s.
    pub unit: &'static str,
    /// Factor of a cell; -1: the opposite sign.
    pub scale: f64,
    /// Added to the value, in the unit that it has without a stated one.
    pub add: f64,
    /// File beside the log that has the column; empty: the log itself.
    /// [`FlightLog::parse_files`](super::FlightLog::parse_files) joins them.
    pub file: String,
    /// Which part of a cell of several values it is, from 1; 0: the whole cell.
    pub part: usize,
    /// Where the letter of the hemisphere of a latitude or a longitude stands, S and W being negative; `OwnName`: it has none.
    pub hemisphere: ColumnFrom,
    /// Where the minutes and the seconds of a latitude or a longitude stand whose cells are degrees; `OwnName`: it has none.
    pub sixtieths: [ColumnFrom; 2],
}

impl Default for LogColumn {
    /// That of the quantity's own name.
    fn default() -> Self {
        Self {
            from: ColumnFrom::OwnName,
            unit: "",
            scale: 1.0,
            add: 0.0,
            file: String::new(),
            part: 0,
            hemisphere: ColumnFrom::OwnName,
            sixtieths: [ColumnFrom::OwnName, ColumnFrom::OwnName],
        }
    }
}

impl LogColumn {
    /// Whether it has what only cells of a table have.
    pub(crate) fn is_of_cells(&self) -> bool {
        let is_one = |from: &ColumnFrom| *from != ColumnFrom::OwnName;
        self.part > 0 || is_one(&self.hemisphere) || self.sixtieths.iter().any(is_one)
    }

    /// The column in TOML, which reads back to the bit; empty: the quantity has its own name.
    pub(crate) fn text(&self) -> String {
        let from = match &self.from {
            ColumnFrom::OwnName => return String::new(),
            ColumnFrom::Constant(value) => format!("value = {}", number_text(*value)),
            from => format!("col = {}", from.text()),
        };
        let is_plain = *self == Self { from: self.from.clone(), ..Self::default() };
        match &self.from {
            ColumnFrom::Name(name) if is_plain => return text_in_quotes(name),
            ColumnFrom::Constant(value) if is_plain => return number_text(*value),
            _ => {}
        }
        let mut text = format!("{{ {from}");
        if !self.unit.is_empty() {
            text += &format!(", unit = \"{}\"", self.unit);
        }
        match self.scale {
            1.0 => {}
            -1.0 => text += ", sign = -1",
            scale => text += &format!(", scale = {}", number_text(scale)),
        }
        if self.add != 0.0 {
            text += &format!(", add = {}", number_text(self.add));
        }
        if !self.file.is_empty() {
            text += &format!(", file = {}", text_in_quotes(&self.file));
        }
        if self.part > 0 {
            text += &format!(", part = {}", self.part);
        }
        if self.hemisphere != ColumnFrom::OwnName {
            text += &format!(", hemisphere = {}", self.hemisphere.text());
        }
        for (part, from) in SIXTIETHS.iter().zip(&self.sixtieths) {
            if *from != ColumnFrom::OwnName {
                text += &format!(", {part} = {}", from.text());
            }
        }
        text + " }"
    }

    /// A cell of this unit in SI is this number times the cell, plus the second one.
    pub(super) fn factor_and_offset(&self, quantity: usize, unit: &str) -> [f64; 2] {
        let dimension = QUANTITIES[quantity].dimension;
        let si = |unit| unit_of(dimension, unit).map_or(1.0, |(_, si)| si);
        [self.scale * si(unit), self.add * si("")]
    }
}
