//! `[log]`: how the table of a log is read, and what is repaired.

use std::borrow::Cow;

use super::hemisphere::sides;
use super::quantity::{Q0, QUANTITIES, Quantity, ROLL, VARIATION, VELOCITY, unit_of, units_of};
use crate::scene::value::Value;
use crate::scene::written::{number_text, text_in_quotes};
use crate::scene::{MAX_TEXT_VALUE, excerpt, listed, nearest};

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
    /// Where the letter of the hemisphere of a latitude or a longitude stands, S and W being negative; `OwnName`: it has none.
    pub hemisphere: ColumnFrom,
}

impl Default for LogColumn {
    fn default() -> Self {
        Self::OWN_NAME
    }
}

/// How times are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TimeFormat {
    /// A number, in seconds or the unit of the column.
    #[default]
    Number,
    /// hh:mm:ss or hhmmss, with decimals; a day is added at midnight.
    Hms,
    /// Date and time in ISO 8601, year, month and day also between slashes or points. Times count from the midnight before the first row.
    Iso,
    /// Day, month and year between points, slashes or hyphens, and a time; otherwise as ISO 8601.
    Dmy,
    /// Month, day and year, and a time; otherwise as ISO 8601.
    Mdy,
    /// Not at all: the rows have a rate.
    Row,
}

impl TimeFormat {
    /// Words of a scene.
    pub const WORDS: [(&str, Self); 6] = [
        ("s", Self::Number),
        ("hms", Self::Hms),
        ("iso", Self::Iso),
        ("row", Self::Row),
        ("dmy", Self::Dmy),
        ("mdy", Self::Mdy),
    ];
}

/// What separates fields. Where it is no comma, decimals may follow one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Separator {
    /// Commas.
    #[default]
    Comma,
    /// Semicolons.
    Semicolon,
    /// Tabs.
    Tab,
    /// Vertical bars.
    Bar,
    /// Blanks, any number of them.
    Blanks,
}

impl Separator {
    /// Words of a scene.
    pub const WORDS: [(&str, Self); 5] = [
        ("comma", Self::Comma),
        ("semicolon", Self::Semicolon),
        ("tab", Self::Tab),
        ("bar", Self::Bar),
        ("blanks", Self::Blanks),
    ];

    pub(super) fn byte(self) -> u8 {
        match self {
            Self::Comma => b',',
            Self::Semicolon => b';',
            Self::Tab => b'\t',
            Self::Bar => b'|',
            Self::Blanks => b' ',
        }
    }

    /// A cell with a decimal point. Where fields are not separated by commas, decimals may follow one.
    pub(super) fn with_point(self, cell: &str) -> Cow<'_, str> {
        let has_comma = self != Self::Comma && cell.matches(',').count() == 1;
        if has_comma { cell.replace(',', ".").into() } else { cell.into() }
    }
}

/// How the table of a log is read, and what is repaired.
#[derive(Debug, Clone, PartialEq)]
pub struct LogMapping {
    /// Each quantity.
    pub columns: [LogColumn; QUANTITIES.len()],
    /// How times are written.
    pub time_format: TimeFormat,
    /// Rate of the rows if times are not written [Hz].
    pub rate_hz: Option<f64>,
    /// Whether the track is magnetic: the variation is added to it.
    pub is_track_magnetic: bool,
    /// What separates fields.
    pub separator: Separator,
    /// The first line that can be that of the names, from 1; 0: no line has names.
    pub header: u64,
    /// Number of rows behind the names that are left out.
    pub skip: u64,
    /// A number that stands for a missing value; a row with one is left out.
    pub missing: Option<f64>,
    /// The character with which comments begin.
    pub comment: String,
    /// Whether the path is smoothed ([`crate::truth::smooth`]).
    pub smooth: bool,
    /// Rate of the samples of a smoothed path [Hz].
    pub smooth_rate_hz: f64,
    /// White noise of a horizontal component of the position [m]; `None`: it is found from the rows.
    pub position_sigma_m: Option<f64>,
    /// White noise of an angle of the attitude [rad]; `None`: it is found from the rows.
    pub attitude_sigma_rad: Option<f64>,
    /// Whether the attitude is that of a coordinated flight along the smoothed path, and not that of the log.
    pub is_coordinated: bool,
    /// Angle of attack of a coordinated flight [rad].
    pub attack_rad: f64,
}

impl LogMapping {
    /// Whether the path is smoothed: so it is too if the attitude follows from it.
    pub fn smooths(&self) -> bool {
        self.smooth || self.is_coordinated
    }

    /// Whether it says where an angle of the attitude or a part of its quaternion stands.
    pub fn names_attitude(&self) -> bool {
        let is_named = |quantity: usize| self.columns[quantity].from != ColumnFrom::OwnName;
        (ROLL..VELOCITY).chain(Q0..VARIATION).any(is_named)
    }

    /// Whether the table is another than one of the library's own.
    pub(super) fn is_foreign(&self) -> bool {
        let Self {
            smooth,
            smooth_rate_hz,
            position_sigma_m,
            attitude_sigma_rad,
            is_coordinated,
            attack_rad,
            ..
        } = *self;
        let own = Self {
            smooth,
            smooth_rate_hz,
            position_sigma_m,
            attitude_sigma_rad,
            is_coordinated,
            attack_rad,
            ..Self::default()
        };
        *self != own
    }
}

impl Default for LogMapping {
    fn default() -> Self {
        Self {
            columns: [LogColumn::OWN_NAME; QUANTITIES.len()],
            time_format: TimeFormat::Number,
            rate_hz: None,
            is_track_magnetic: false,
            separator: Separator::Comma,
            header: 1,
            skip: 0,
            missing: None,
            comment: "#".to_owned(),
            smooth: false,
            smooth_rate_hz: 50.0,
            position_sigma_m: None,
            attitude_sigma_rad: None,
            is_coordinated: false,
            attack_rad: 0.0,
        }
    }
}

/// What a column takes, in words.
pub(in crate::scene) const TAKES: &str =
    "\"NAME\" of a column, { col = \"NAME\", unit = \"ft\" }, or a number";

impl LogColumn {
    /// That of the quantity's own name.
    const OWN_NAME: Self =
        Self { from: ColumnFrom::OwnName, unit: "", scale: 1.0, add: 0.0, hemisphere: ColumnFrom::OwnName };

    /// The column that a value of a text describes; on an error what is wrong.
    pub(in crate::scene) fn of(value: &Value, quantity: usize) -> Result<Self, String> {
        let Quantity { key, dimension, .. } = QUANTITIES[quantity];
        let name = |text: &str| {
            let name = text.trim();
            if name.is_empty() || name.chars().any(char::is_control) || name.len() > MAX_TEXT_VALUE {
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
                ("hemisphere", _) if sides(quantity).is_none() => {
                    return Err(format!("log.{key}.{part}: only latitude and longitude have one"));
                }
                ("hemisphere", value) => column.hemisphere = place(part, value)?,
                _ => {
                    let names = ["col", "value", "unit", "sign", "scale", "add", "hemisphere"];
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
        if matches!(column.from, ColumnFrom::Constant(_)) && column.hemisphere != ColumnFrom::OwnName {
            return Err(format!("log.{key}: a value has no hemisphere; give its col"));
        }
        Ok(column)
    }

    /// The column in TOML, which reads back to the bit; empty: the quantity has its own name.
    pub(in crate::scene) fn text(&self) -> String {
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
