//! A column of `[log]`: where a quantity stands, and what its cells mean.

use super::hemisphere::sides;
use super::quantity::{QUANTITIES, Quantity, unit_of, units_of};
use crate::base::text::{MAX_TEXT_VALUE, excerpt, listed, nearest};
use crate::base::text::{number_text, text_in_quotes};
use crate::scene::value::Value;

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
    /// File beside the log that has the column; empty: the log itself. The library reads one table, and the program joins them.
    pub file: String,
    /// Which part of a cell of several values it is, from 1; 0: the whole cell.
    pub part: usize,
    /// Where the letter of the hemisphere of a latitude or a longitude stands, S and W being negative; `OwnName`: it has none.
    pub hemisphere: ColumnFrom,
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
        }
    }
}

/// What a column takes, in words.
pub(crate) const TAKES: &str = "\"NAME\" of a column, { col = \"NAME\", unit = \"ft\" }, or a number";

/// Whether a text is a name alone, on every system: no path leads out of the folder of the log. On Windows a colon stands behind a drive.
fn is_beside(name: &str) -> bool {
    !name.contains(['/', '\\', ':']) && !matches!(name, "." | "..")
}

impl LogColumn {
    /// The column that a value of a text describes; on an error what is wrong.
    pub(crate) fn of(value: &Value, quantity: usize) -> Result<Self, String> {
        let Quantity { key, dimension, .. } = QUANTITIES[quantity];
        let is_name = |text: &str| {
            !text.is_empty() && !text.chars().any(char::is_control) && text.len() <= MAX_TEXT_VALUE
        };
        let name = |text: &str| {
            let name = text.trim();
            if !is_name(name) {
                return Err(format!("log.{key}: expected the name of a column, without control characters"));
            }
            Ok(ColumnFrom::Name(name.to_owned()))
        };
        let place = |part: &str, value: &Value| match value {
            Value::Text(text) => name(text),
            Value::Whole(number) => {
                let place = usize::try_from(*number).ok().filter(|place| (1..=1000).contains(place));
                let expected = || format!("log.{key}.{part}: expected a column from 1 to 1000");
                place.map(ColumnFrom::Number).ok_or_else(expected)
            }
            _ => Err(format!("log.{key}.{part}: expected the name or the number of a column")),
        };
        let parts = match value {
            Value::Text(text) => return Ok(Self { from: name(text)?, ..Self::default() }),
            Value::Whole(_) | Value::Number(_) => {
                let constant = value.number().unwrap_or_default();
                return Ok(Self { from: ColumnFrom::Constant(constant), ..Self::default() });
            }
            Value::Table(parts) => parts,
            _ => return Err(format!("log.{key}: expected {TAKES}")),
        };
        let mut column = Self::default();
        for (part, value) in parts {
            let expected = |what: &str| format!("log.{key}.{part}: expected {what}");
            let number = || value.number().ok_or_else(|| expected("a number"));
            match (part.as_str(), value) {
                ("col" | "value", _) if column.from != ColumnFrom::OwnName => {
                    return Err(format!("log.{key}: expected either col or value"));
                }
                ("col", value) => column.from = place(part, value)?,
                ("value", _) => column.from = ColumnFrom::Constant(number()?),
                ("unit", Value::Text(text)) if !text.is_empty() && unit_of(dimension, text).is_some() => {
                    column.unit = unit_of(dimension, text).map_or("", |(unit, _)| unit);
                }
                ("unit", _) => {
                    let units: Vec<&str> = units_of(dimension).collect();
                    return Err(expected(&units.join(", ")));
                }
                ("sign", _) => {
                    let sign = number()?;
                    if sign.abs() != 1.0 {
                        return Err(expected("1 or -1"));
                    }
                    column.scale *= sign;
                }
                ("scale", _) => {
                    let scale = number()?;
                    if scale == 0.0 {
                        return Err(expected("a number that is not 0"));
                    }
                    column.scale *= scale;
                }
                ("add", _) => column.add = number()?,
                ("file", _) if ["time", "latitude", "longitude"].contains(&key) => {
                    return Err(format!("log.{key}.file: times and positions are those of the log itself"));
                }
                ("file", Value::Text(text)) if is_name(text) && is_beside(text) => {
                    column.file.clone_from(text);
                }
                ("file", _) => {
                    return Err(expected("the name of a file beside the log, without a folder or a colon"));
                }
                ("part", Value::Whole(number @ 1..=100)) => column.part = *number as usize,
                ("part", _) => return Err(expected("a part of a cell, from 1 to 100")),
                ("hemisphere", _) if sides(quantity).is_none() => {
                    return Err(format!("log.{key}.{part}: only latitude and longitude have one"));
                }
                ("hemisphere", value) => column.hemisphere = place(part, value)?,
                _ => {
                    let names =
                        ["col", "value", "unit", "sign", "scale", "add", "file", "part", "hemisphere"];
                    let near = nearest(part, names.into_iter())
                        .map_or(String::new(), |near| format!("; did you mean {near}?"));
                    let names = listed(names.into_iter());
                    return Err(format!(
                        "log.{key}: no such part: {}; expected {names}{near}",
                        excerpt(part)
                    ));
                }
            }
        }
        if column.from == ColumnFrom::OwnName {
            return Err(format!("log.{key}: expected its col or its value"));
        }
        let is_of_cells =
            column.part > 0 || column.hemisphere != ColumnFrom::OwnName || !column.file.is_empty();
        if matches!(column.from, ColumnFrom::Constant(_)) && is_of_cells {
            return Err(format!("log.{key}: a value has no file, no part and no hemisphere; give its col"));
        }
        Ok(column)
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
        text + " }"
    }

    /// A cell in SI is this number times the cell, plus the second one.
    pub(super) fn factor_and_offset(&self, quantity: usize) -> [f64; 2] {
        let dimension = QUANTITIES[quantity].dimension;
        let si = |unit| unit_of(dimension, unit).map_or(1.0, |(_, si)| si);
        [self.scale * si(self.unit), self.add * si("")]
    }
}

#[cfg(test)]
mod tests {
    use super::super::{FlightLog, LogError};
    use crate::scene::Scene;

    const NOT_BESIDE: &str = "log.roll.file: expected the name of a file beside the log, without a folder";

    /// The program joins files; the library reads one text, and says so.
    #[test]
    fn a_column_of_another_file_is_written_and_not_read() {
        let scene =
            |keys: &str| Scene::parse(format!("[flight]\nfile = \"a.csv\"\n[log]\n{keys}\n").as_bytes());
        let of_file = scene("roll = { col = \"Roll\", file = \"ATT \\\"1\\\".csv\" }").unwrap();
        assert_eq!(of_file.log.columns[super::super::quantity::ROLL].file, "ATT \"1\".csv");
        assert_eq!(Scene::parse(of_file.write().as_bytes()).unwrap().log, of_file.log);
        let table = "time_s,latitude_deg,longitude_deg,height_m,pitch_deg,heading_deg,Roll\n0,48,11,0,0,0,0\n1,48,11,0,0,0,0\n";
        let Err(LogError::Fault(fault)) = FlightLog::parse_with(table.as_bytes(), &of_file.log) else {
            panic!()
        };
        assert!(
            fault
                .sentence
                .starts_with("log.roll: stands in ATT \"1\".csv, and a text is one table; `sins log"),
            "{fault:?}"
        );
        for (keys, words) in [
            (
                "time = { col = \"t\", file = \"a.csv\" }",
                "log.time.file: times and positions are those of the log itself",
            ),
            ("longitude = { col = \"l\", file = \"a.csv\" }", "log.longitude.file: times and positions"),
            (
                "roll = { col = \"r\", file = \"\" }",
                "log.roll.file: expected the name of a file beside the log",
            ),
            ("roll = { col = \"r\", file = 1 }", "log.roll.file: expected the name of a file beside the log"),
            ("roll = { col = \"r\", file = \"../a.csv\" }", NOT_BESIDE),
            ("roll = { col = \"r\", file = \"folder/a.csv\" }", NOT_BESIDE),
            ("roll = { col = \"r\", file = \"/a.csv\" }", NOT_BESIDE),
            ("roll = { col = \"r\", file = '\\\\host\\share\\a.csv' }", NOT_BESIDE),
            ("roll = { col = \"r\", file = '..\\a.csv' }", NOT_BESIDE),
            ("roll = { col = \"r\", file = \"C:a.csv\" }", NOT_BESIDE),
            ("roll = { col = \"r\", file = \"a.csv:stream\" }", NOT_BESIDE),
            ("roll = { col = \"r\", file = \"..\" }", NOT_BESIDE),
            ("roll = { col = \"r\", file = \".\" }", NOT_BESIDE),
            (
                "roll = { value = 1, file = \"a.csv\" }",
                "log.roll: a value has no file, no part and no hemisphere",
            ),
        ] {
            let faults = scene(keys).unwrap_err();
            assert!(faults[0].sentence.contains(words), "{faults:?}");
        }
    }
}
