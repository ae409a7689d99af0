//! The columns of a log: which quantity each of them has.

use core::ops::Range;

use csv::StringRecord;

use super::column::{ColumnFrom, LogColumn, SIXTIETHS};
use super::guess::{Guess, guess, hemisphere_of};
use super::mapping::{LogMapping, TimeFormat};
use super::quantity::{
    DDMM, FORCE, FORWARD, OF_SAMPLE, Q0, QUANTITIES, RATE, ROLL, SPEED, TEMPERATURE, VARIATION, VELOCITY,
    in_degrees, name, unit_of,
};
use super::words::unit_in_name;
use super::{LogError, fault};
use crate::base::text::{Fault, excerpt, listed, nearest};
use crate::base::units::DEG;

/// Number of quantities.
pub const COUNT: usize = QUANTITIES.len();

/// The quantities of the attitude.
const ATTITUDE: Range<usize> = ROLL..VELOCITY;

/// The quantities of a quaternion, and those of the velocity in each form.
const QUATERNION: Range<usize> = Q0..VARIATION;
const VELOCITIES: [Range<usize>; 3] = [VELOCITY..RATE, SPEED..FORWARD, FORWARD..Q0];

/// The quantities that come together: all of them or none.
const TOGETHER: [Range<usize>; 6] =
    [VELOCITY..RATE, RATE..FORCE, FORCE..TEMPERATURE, SPEED..FORWARD, FORWARD..Q0, QUATERNION];

/// How the values of a quantity follow from the rows: factor · cell + offset.
#[derive(Debug, Clone)]
pub struct Column {
    /// Place of the cell in a row; `None`: the value is a constant, the offset.
    pub place: Option<usize>,
    pub factor: f64,
    pub offset: f64,
    /// Which part of the cell it is, from 1; 0: the whole cell.
    pub part: usize,
    /// Whether the cell has degrees and minutes.
    pub is_ddmm: bool,
    /// Place of the letter of the hemisphere; `None`: it has none of its own.
    pub hemisphere: Option<usize>,
    /// Places of its minutes and seconds.
    pub sixtieths: [Option<usize>; 2],
    /// Name of the column.
    pub name: String,
}

impl Column {
    /// Whether it reads the cells at a place.
    pub fn reads(&self, place: usize) -> bool {
        [self.place, self.hemisphere].iter().chain(&self.sixtieths).any(|its| *its == Some(place))
    }
}

/// The columns of a log, by their quantities.
pub type Columns = [Option<Column>; COUNT];

/// Whether any of these quantities has a column.
pub fn has(columns: &Columns, quantities: Range<usize>) -> bool {
    columns[quantities].iter().any(Option::is_some)
}

/// Whether the log has a quaternion.
pub fn has_quaternion(columns: &Columns) -> bool {
    has(columns, QUATERNION)
}

/// The columns of a header, by their quantities.
pub fn columns(header: &StringRecord, line: u64, mapping: &LogMapping) -> Result<Columns, LogError> {
    let mut columns = [const { None }; COUNT];
    for (quantity, column) in columns.iter_mut().enumerate() {
        if mapping.is_coordinated && (ATTITUDE.contains(&quantity) || QUATERNION.contains(&quantity)) {
            continue;
        }
        *column = match &mapping.columns[quantity].from {
            ColumnFrom::OwnName if quantity < OF_SAMPLE => own_column(header, line, quantity)?,
            ColumnFrom::OwnName => None,
            _ => Some(mapped_column(header, line, mapping, quantity)?),
        };
    }
    if mapping.time_format == TimeFormat::Row {
        columns[0] = None;
        if mapping.rate_hz.is_none() {
            return Err(fault(line, 1, "log.rate_hz: expected the rate of rows without times".to_owned()));
        }
    }
    check_together(&columns, line)?;
    let has_angles = !mapping.is_coordinated && !has_quaternion(&columns);
    let is_wanted = |index: usize| match TOGETHER.iter().find(|group| group.contains(&index)) {
        Some(group) => has(&columns, group.clone()),
        None if index == 0 => mapping.time_format != TimeFormat::Row,
        None => index < VELOCITY && (has_angles || !ATTITUDE.contains(&index)),
    };
    let missing = (0..COUNT).filter(|&index| columns[index].is_none() && is_wanted(index));
    let missing: Vec<String> = missing.map(|index| missing_column(index, header)).collect();
    let other = [(';', ("semicolons", "semicolon")), ('\t', ("tabs", "tab"))]
        .into_iter()
        .find(|(mark, _)| header.iter().any(|name| name.contains(*mark)));
    if missing.is_empty() {
        return Ok(columns);
    }
    let sentence = match other {
        Some((_, (marks, word))) => {
            format!(
                "columns separated by {marks}: expected commas between fields, and decimal points, or separator = \"{word}\" in [log]"
            )
        }
        None => {
            format!("missing columns: {}; the header has {}", missing.join(", "), listed(header.iter()))
        }
    };
    Err(LogError::of_columns(line, sentence))
}

/// The column that has the name of the quantity itself, in radians or degrees.
fn own_column(header: &StringRecord, line: u64, quantity: usize) -> Result<Option<Column>, LogError> {
    let quantity = name(quantity);
    let degrees = in_degrees(quantity);
    let mut column = None;
    for (place, name) in header.iter().enumerate() {
        let factor = match name {
            _ if name == quantity => 1.0,
            _ if Some(name) == degrees.as_deref() => DEG,
            _ => continue,
        };
        if column.is_some() {
            let sentence = format!("{name}: an earlier column has that quantity");
            return Err(fault(line, place + 1, sentence));
        }
        column = Some(Column {
            place: Some(place),
            factor,
            offset: 0.0,
            part: 0,
            is_ddmm: false,
            hemisphere: None,
            sixtieths: [None; 2],
            name: name.to_owned(),
        });
    }
    Ok(column)
}

/// The column that `[log]` gives a quantity.
fn mapped_column(
    header: &StringRecord,
    line: u64,
    mapping: &LogMapping,
    quantity: usize,
) -> Result<Column, LogError> {
    let mapped = &mapping.columns[quantity];
    let key = QUANTITIES[quantity].key;
    if !mapped.file.is_empty() {
        let file = excerpt(&mapped.file);
        let sentence = format!(
            "log.{key}: stands in {file}, and a text is one table; `sins log LOG.csv --columns MAP.toml --smooth -o TRUTH.csv` joins the files"
        );
        return Err(fault(0, 1, sentence));
    }
    let place = place_of(header, line, &mapped.from, &format!("log.{key}"))?;
    let unit = place.and_then(|place| unit_of_name(mapped, header.get(place)?, quantity));
    let [factor, offset] = mapped.factor_and_offset(quantity, unit.unwrap_or(mapped.unit));
    let hemisphere = place_of(header, line, &mapped.hemisphere, &format!("log.{key}.hemisphere"))?;
    let sixtieth = |index: usize| {
        place_of(header, line, &mapped.sixtieths[index], &format!("log.{key}.{}", SIXTIETHS[index]))
    };
    let sixtieths = [sixtieth(0)?, sixtieth(1)?];
    let (offset, name) = match &mapped.from {
        ColumnFrom::Name(name) => (offset, name.clone()),
        ColumnFrom::Number(number) => (offset, format!("column {number}")),
        ColumnFrom::Constant(value) => (value * factor + offset, key.to_owned()),
        ColumnFrom::OwnName => (offset, key.to_owned()),
    };
    Ok(Column {
        place,
        factor,
        offset,
        part: mapped.part,
        is_ddmm: mapped.unit == DDMM,
        hemisphere,
        sixtieths,
        name,
    })
}

/// The unit that the name of a column states, if `[log]` states neither unit nor scale: another one than the quantity has anyway.
pub fn unit_of_name(mapped: &LogColumn, name: &str, quantity: usize) -> Option<&'static str> {
    let dimension = QUANTITIES[quantity].dimension;
    let is_open = mapped.unit.is_empty() && mapped.scale.abs() == 1.0;
    let unit = is_open.then(|| unit_in_name(name, dimension)).flatten()?;
    unit_of(dimension, "").is_some_and(|(usual, _)| usual != unit).then_some(unit)
}

/// The place in a row of the column that `key` gives, which is named with its section; `None`: it gives none.
pub fn place_of(
    header: &StringRecord,
    line: u64,
    from: &ColumnFrom,
    key: &str,
) -> Result<Option<usize>, LogError> {
    let refused = |sentence: String| Err(fault(line, 1, format!("{key}: {sentence}")));
    match from {
        ColumnFrom::Name(wanted) => {
            let mut places = header.iter().enumerate().filter(|(_, name)| name.trim() == wanted);
            match (places.next(), places.next()) {
                (Some((place, _)), None) => Ok(Some(place)),
                (Some(_), Some((place, _))) => {
                    let sentence = format!("{key}: an earlier column is {} too", excerpt(wanted));
                    Err(fault(line, place + 1, sentence))
                }
                (None, _) => {
                    let near = nearest(wanted, header.iter())
                        .map_or(String::new(), |name| format!("; did you mean {}?", excerpt(name)));
                    let names = listed(header.iter());
                    refused(format!("no column {}; the header has {names}{near}", excerpt(wanted)))
                }
            }
        }
        ColumnFrom::Number(number) if *number > header.len() => {
            refused(format!("no column {number}: the row has {}", header.len()))
        }
        ColumnFrom::Number(number) => Ok(Some(number - 1)),
        ColumnFrom::OwnName | ColumnFrom::Constant(_) => Ok(None),
    }
}

/// The place of the column that tells vehicles apart.
pub fn only_place(header: &StringRecord, line: u64, mapping: &LogMapping) -> Result<Option<usize>, LogError> {
    let wanted = &mapping.only_column;
    let from = if wanted.is_empty() { ColumnFrom::OwnName } else { ColumnFrom::Name(wanted.clone()) };
    place_of(header, line, &from, "log.only_column")
}

/// Checks that no quantity is given in two forms.
fn check_together(columns: &Columns, line: u64) -> Result<(), LogError> {
    let key = |group: &Range<usize>| QUANTITIES[group.start].key;
    let given: Vec<&str> =
        VELOCITIES.iter().filter(|group| has(columns, (*group).clone())).map(key).collect();
    if let [one, other, ..] = given[..] {
        let sentence = format!("log.{other}: the velocity is given by {one} too; give one");
        return Err(fault(line, 1, sentence));
    }
    if has_quaternion(columns) && has(columns, ATTITUDE) {
        return Err(fault(line, 1, "log.q0: the attitude is given by angles too; give one".to_owned()));
    }
    Ok(())
}

/// The columns that are not read, though their names say that they have a quantity which the log lacks.
pub fn unread(header: &StringRecord, line: u64, columns: &Columns, mapping: &LogMapping) -> Vec<Fault> {
    let has_velocity = VELOCITIES.iter().any(|group| has(columns, group.clone()));
    let is_lacking = |&Guess { quantity, .. }: &Guess| {
        let is_known = columns[quantity].is_some()
            || ATTITUDE.contains(&quantity) && (mapping.is_coordinated || has_quaternion(columns))
            || (VELOCITY..RATE).contains(&quantity) && has_velocity;
        (1..OF_SAMPLE).contains(&quantity) && !is_known
    };
    let of_names = columns.iter().enumerate().filter_map(|(quantity, column)| {
        let place = column.as_ref()?.place?;
        let (mapped, name) = (&mapping.columns[quantity], header.get(place)?);
        let is_mapped = mapped.from != ColumnFrom::OwnName;
        let unit = is_mapped.then(|| unit_of_name(mapped, name, quantity)).flatten()?;
        let key = QUANTITIES[quantity].key;
        let sentence = format!(
            "{} is read in {unit}, as its name says; log.{key}.unit = ... reads it in another unit",
            excerpt(name)
        );
        Some(Fault { line: line as usize, column: place + 1, sentence, ..Fault::default() })
    });
    let note = |(place, column): (usize, &str)| {
        let is_read = columns.iter().flatten().any(|column| column.reads(place));
        if let Some(quantity) = hemisphere_of(column).filter(|_| !is_read) {
            let key = QUANTITIES[quantity].key;
            let sentence = format!("{} is not read; is it log.{key}.hemisphere?", excerpt(column));
            return Some(Fault { line: line as usize, column: place + 1, sentence, ..Fault::default() });
        }
        let Guess { quantity, unit, sign, .. } = guess(column).filter(is_lacking).filter(|_| !is_read)?;
        let unit = if unit.is_empty() { String::new() } else { format!(", in {unit}") };
        let sign = if sign < 0.0 { ", with the opposite sign" } else { "" };
        let sentence = format!("{} is not read; is it {}{unit}{sign}?", excerpt(column), name(quantity));
        Some(Fault { line: line as usize, column: place + 1, sentence, ..Fault::default() })
    };
    of_names.chain(header.iter().enumerate().filter_map(note)).collect()
}

/// The name of a missing column, with the name of its form in degrees and the name that may have been meant.
fn missing_column(quantity: usize, header: &StringRecord) -> String {
    let own = name(quantity);
    if own.is_empty() {
        return format!("log.{}", QUANTITIES[quantity].key);
    }
    let degrees = in_degrees(own).map_or(String::new(), |name| format!(" or {name}"));
    let unknown = header.iter().filter(|column| !(0..OF_SAMPLE).map(name).any(|own| own == *column));
    let says = |column: &&str| guess(column).is_some_and(|guess| guess.quantity == quantity);
    let near = nearest(own, unknown.clone()).or_else(|| unknown.clone().find(says));
    let near = near.map_or(String::new(), |name| format!(" (found {})", excerpt(name)));
    format!("{own}{degrees}{near}")
}
