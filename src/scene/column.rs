//! A column of `[log]` or `[imu]` as the text of a scene describes it.

use super::key::{Key, Section};
use super::value::Value;
use crate::base::text::{MAX_TEXT_VALUE, excerpt, listed, nearest};
use crate::log::{
    ColumnFrom, DDMM, IMU_QUANTITIES, LogColumn, QUANTITIES, Quantity, sides, unit_of, units_of,
};

/// What a column takes, in words.
pub const TAKES: &str = "\"NAME\" of a column, { col = \"NAME\", unit = \"ft\" }, or a number";

/// The same in `[imu]`.
pub const IMU_TAKES: &str = "\"NAME\" of a column, or { col = \"NAME\", unit = \"deg/s\" }";

/// Whether a text is a name alone, on every system: no path leads out of the folder of the log. On Windows a colon stands behind a drive.
fn is_beside(name: &str) -> bool {
    !name.contains(['/', '\\', ':']) && !matches!(name, "." | "..")
}

/// The column that a value of a text describes for the quantity of a key; on an error what is wrong.
pub fn column_of(value: &Value, key: &Key, quantity: usize) -> Result<LogColumn, String> {
    let is_imu = key.section == Section::Imu;
    let (section, table) = (key.section.name(), if is_imu { &IMU_QUANTITIES[..] } else { &QUANTITIES[..] });
    let Quantity { key, dimension, .. } = table[quantity];
    let sides = if is_imu { None } else { sides(quantity) };
    let is_name =
        |text: &str| !text.is_empty() && !text.chars().any(char::is_control) && text.len() <= MAX_TEXT_VALUE;
    let name = |text: &str| {
        let name = text.trim();
        if !is_name(name) {
            return Err(format!(
                "{section}.{key}: expected the name of a column, without control characters"
            ));
        }
        Ok(ColumnFrom::Name(name.to_owned()))
    };
    let place = |part: &str, value: &Value| match value {
        Value::Text(text) => name(text),
        Value::Whole(number) => {
            let place = usize::try_from(*number).ok().filter(|place| (1..=1000).contains(place));
            let expected = || format!("{section}.{key}.{part}: expected a column from 1 to 1000");
            place.map(ColumnFrom::Number).ok_or_else(expected)
        }
        _ => Err(format!("{section}.{key}.{part}: expected the name or the number of a column")),
    };
    let parts = match value {
        Value::Text(text) => return Ok(LogColumn { from: name(text)?, ..LogColumn::default() }),
        Value::Whole(_) | Value::Number(_) => {
            let constant = value.number().unwrap_or_default();
            if is_imu {
                let whole = format!("{section}.{key} = {constant}: expected a column: {IMU_TAKES}");
                return Err(whole);
            }
            return Ok(LogColumn { from: ColumnFrom::Constant(constant), ..LogColumn::default() });
        }
        Value::Table(parts) => parts,
        _ => {
            let takes = if is_imu { IMU_TAKES } else { TAKES };
            return Err(format!("{section}.{key}: expected {takes}"));
        }
    };
    // Degrees and minutes are those of a position.
    let is_its = |unit: &str| unit != DDMM || sides.is_some();
    let mut column = LogColumn::default();
    for (part, value) in parts {
        let expected = |what: &str| format!("{section}.{key}.{part}: expected {what}");
        let number = || value.number().ok_or_else(|| expected("a number"));
        match (part.as_str(), value) {
            ("col" | "value", _) if column.from != ColumnFrom::OwnName => {
                return Err(format!("{section}.{key}: expected either col or value"));
            }
            ("col", value) => column.from = place(part, value)?,
            ("value", _) => column.from = ColumnFrom::Constant(number()?),
            ("unit", Value::Text(text))
                if !text.is_empty() && is_its(text) && unit_of(dimension, text).is_some() =>
            {
                column.unit = unit_of(dimension, text).map_or("", |(unit, _)| unit);
            }
            ("unit", _) => {
                let units: Vec<&str> = units_of(dimension).filter(|unit| is_its(unit)).collect();
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
                let what = if is_imu {
                    "each file has its own times"
                } else {
                    "times and positions are those of the log itself"
                };
                return Err(format!("{section}.{key}.file: {what}"));
            }
            ("file", Value::Text(text)) if is_name(text) && is_beside(text) => {
                column.file.clone_from(text);
            }
            ("file", _) => {
                return Err(expected("the name of a file beside the log, without a folder or a colon"));
            }
            ("part", Value::Whole(number @ 1..=100)) => column.part = *number as usize,
            ("part", _) => return Err(expected("a part of a cell, from 1 to 100")),
            ("hemisphere" | "minutes" | "seconds", _) if sides.is_none() => {
                return Err(format!("{section}.{key}.{part}: only latitude and longitude have one"));
            }
            ("hemisphere", value) => column.hemisphere = place(part, value)?,
            ("minutes", value) => column.sixtieths[0] = place(part, value)?,
            ("seconds", value) => column.sixtieths[1] = place(part, value)?,
            _ => {
                let names = [
                    "col",
                    "value",
                    "unit",
                    "sign",
                    "scale",
                    "add",
                    "file",
                    "part",
                    "hemisphere",
                    "minutes",
                    "seconds",
                ];
                let near = nearest(part, names.into_iter())
                    .map_or(String::new(), |near| format!("; did you mean {near}?"));
                let names = listed(names.into_iter());
                return Err(format!(
                    "{section}.{key}: no such part: {}; expected {names}{near}",
                    excerpt(part)
                ));
            }
        }
    }
    if column.from == ColumnFrom::OwnName {
        return Err(format!("{section}.{key}: expected its col or its value"));
    }
    if is_imu && matches!(column.from, ColumnFrom::Constant(_)) {
        return Err(format!("{section}.{key}: expected a column: no sensor has one value alone"));
    }
    let is_of_cells = column.is_of_cells() || !column.file.is_empty();
    if matches!(column.from, ColumnFrom::Constant(_)) && is_of_cells {
        return Err(format!("{section}.{key}: a value has no file, no part and no hemisphere; give its col"));
    }
    let has_seconds_alone =
        column.sixtieths[0] == ColumnFrom::OwnName && column.sixtieths[1] != ColumnFrom::OwnName;
    let is_of_degrees = column.unit.is_empty() || column.unit == "deg";
    if has_seconds_alone || column.sixtieths[0] != ColumnFrom::OwnName && !is_of_degrees {
        return Err(format!("{section}.{key}: seconds stand beside minutes, and minutes beside degrees"));
    }
    Ok(column)
}
