//! A record of an IMU as a table that `[imu]` describes: its cells become numbers as those of a log do.

use csv::StringRecord;

use super::columns::{Column, place_of, unit_of_name};
use super::parse::{Take, read_table};
use super::quantity::{IMU_QUANTITIES, TIME};
use super::rows::number_of;
use super::text::decoded;
use super::{Clock, ColumnFrom, LogError, LogMapping, TimeFormat, fault};
use crate::base::memory::room_for_one_more;
use crate::base::text::excerpt;

/// A column of a record.
#[derive(Debug, Clone, PartialEq)]
pub struct ImuColumn {
    /// Its key with that of its section: "imu.gyro_x".
    pub key: String,
    /// Whether it is that of a gyro, and not of an accelerometer.
    pub is_gyro: bool,
    /// Its name in the record.
    pub name: String,
    /// Its unit ([`imu_units`](super::imu_units)); empty: `[imu]` states none.
    pub unit: &'static str,
    /// Factor of its numbers beside the unit.
    pub scale: f64,
    /// Added to its values [rad/s, m/s², rad or m/s].
    pub add: f64,
    /// Numbers of its cells.
    pub numbers: Vec<f64>,
}

/// The rows of a record.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ImuTable {
    /// Name of the column of times; empty: rows have a rate, and no times.
    pub time: String,
    /// Times of the rows [s].
    pub times_s: Vec<f64>,
    /// The columns that `[imu]` names in this file, in the order of its keys.
    pub columns: Vec<ImuColumn>,
    /// The line of each row, from 1.
    pub lines: Vec<u64>,
    /// Number of rows that were left out, because a value is missing, and the line of the first.
    pub left_out: Option<(u64, u64)>,
}

impl ImuTable {
    /// Reads the columns that `mapping`, an `[imu]`, names in the file of this name; empty: in the record itself.
    pub fn parse(text: &[u8], mapping: &LogMapping, file: &str) -> Result<Self, LogError> {
        let text = decoded(text).map_err(LogError::Memory)?;
        let begin = |names: &StringRecord, line: u64| Reading::new(names, line, mapping, file);
        let (Reading { table, .. }, _) = read_table(text.as_bytes(), mapping, begin)?;
        match table.left_out {
            Some((count, line)) if count > table.lines.len() as u64 => {
                let rows = count + table.lines.len() as u64;
                Err(fault(line, 1, format!("a value is missing here and in most rows: in {count} of {rows}")))
            }
            _ => Ok(table),
        }
    }
}

/// A record while its rows are read.
struct Reading<'m> {
    mapping: &'m LogMapping,
    clock: Clock,
    /// The column of the times, if rows have them, then those of the table.
    time: Option<Column>,
    columns: Vec<Column>,
    table: ImuTable,
    /// The numbers of a row.
    row: Vec<f64>,
}

impl<'m> Reading<'m> {
    fn new(names: &StringRecord, line: u64, mapping: &'m LogMapping, file: &str) -> Result<Self, LogError> {
        let mut reading = Self {
            mapping,
            clock: Clock::new(mapping),
            time: None,
            columns: Vec::new(),
            table: ImuTable::default(),
            row: Vec::new(),
        };
        let refused = |sentence: String| Err(fault(line, 1, sentence));
        match (mapping.time_format, mapping.rate_hz) {
            (TimeFormat::Row, None) => {
                return refused("imu.rate_hz: expected the rate of rows without times".to_owned());
            }
            (format, Some(rate_hz)) if format != TimeFormat::Row => {
                let what = "only for rows without times, time_format = \"row\"";
                return refused(format!("imu.rate_hz = {rate_hz}: {what}"));
            }
            _ => {}
        }
        if mapping.time_format != TimeFormat::Row {
            let time = &mapping.columns[TIME];
            let Some(mut column) = column(names, line, mapping, TIME)? else {
                let what = "imu.time: expected the column of the times, or time_format = \"row\" and rate_hz";
                return refused(what.to_owned());
            };
            let stated = column.place.and_then(|place| unit_of_name(time, names.get(place)?, TIME));
            [column.factor, column.offset] = time.factor_and_offset(TIME, stated.unwrap_or(time.unit));
            reading.table.time.clone_from(&column.name);
            reading.time = Some(column);
        }
        for (quantity, mapped) in mapping.columns.iter().enumerate().skip(TIME + 1) {
            if mapped.from == ColumnFrom::OwnName || mapped.file != file {
                continue;
            }
            let Some(column) = column(names, line, mapping, quantity)? else { continue };
            let key = IMU_QUANTITIES[quantity].key;
            let keys = reading.table.columns.iter().map(|other| other.key.as_str()).zip(&reading.columns);
            let mut others = reading.time.iter().map(|time| ("imu.time", time)).chain(keys);
            let is_same = |other: &Column| (other.place, other.part) == (column.place, column.part);
            if let Some((other, _)) = others.find(|(_, other)| is_same(other)) {
                let what = "both read the column";
                let expected = "expected another column, or part of it, for one of them";
                return refused(format!(
                    "{other} and imu.{key}: {what} {}: {expected}",
                    excerpt(&column.name)
                ));
            }
            reading.table.columns.push(ImuColumn {
                key: format!("imu.{key}"),
                is_gyro: key.starts_with("gyro"),
                name: column.name.clone(),
                unit: mapped.unit,
                scale: mapped.scale,
                add: mapped.add,
                numbers: Vec::new(),
            });
            reading.columns.push(column);
        }
        if reading.columns.is_empty() {
            let is_beside = mapping.columns.iter().any(|mapped| !mapped.file.is_empty());
            let what = match is_beside {
                true => {
                    "imu: all sensors are in files beside the record: at least one must be in the record itself"
                }
                false => "imu: expected the column of a gyro or an accelerometer, as gyro_x = \"NAME\"",
            };
            return refused(what.to_owned());
        }
        Ok(reading)
    }

    /// The number of a column in a row; `None`: the value is missing.
    fn number(&mut self, row: &StringRecord, line: u64, at: Option<usize>) -> Result<Option<f64>, LogError> {
        let column = at.map_or(self.time.as_ref(), |at| self.columns.get(at));
        let Some((column, place)) = column.and_then(|column| Some((column, column.place?))) else {
            return Ok(None);
        };
        let clock = at.is_none().then_some(&mut self.clock);
        // Only a latitude or a longitude is read in another way.
        number_of(row, line, (TIME, column, place), self.mapping, true, clock)
    }
}

/// The column of a quantity; `None`: `[imu]` names none.
fn column(
    names: &StringRecord,
    line: u64,
    mapping: &LogMapping,
    quantity: usize,
) -> Result<Option<Column>, LogError> {
    let mapped = &mapping.columns[quantity];
    let place = place_of(names, line, &mapped.from, &format!("imu.{}", IMU_QUANTITIES[quantity].key))?;
    let own = place.and_then(|place| names.get(place)).filter(|name| mapping.header > 0 && !name.is_empty());
    let name = match &mapped.from {
        ColumnFrom::Name(name) => name.clone(),
        ColumnFrom::Number(number) => own.map_or_else(|| format!("column {number}"), str::to_owned),
        ColumnFrom::OwnName | ColumnFrom::Constant(_) => return Ok(None),
    };
    Ok(Some(Column {
        place,
        factor: 1.0,
        offset: 0.0,
        part: mapped.part,
        is_ddmm: false,
        hemisphere: None,
        sixtieths: [None; 2],
        name,
    }))
}

impl Take for Reading<'_> {
    fn row(&mut self, row: &StringRecord, line: u64) -> Result<(), LogError> {
        self.row.clear();
        let time = match &self.time {
            Some(column) => {
                let [factor, offset] = [column.factor, column.offset];
                let factor = if self.clock.is_number() { factor } else { 1.0 };
                let time_s = self.number(row, line, None)?;
                time_s.map(|time_s| if offset == 0.0 { time_s * factor } else { time_s * factor + offset })
            }
            None => self.clock.next(""),
        };
        for at in 0..self.columns.len() {
            let number = self.number(row, line, Some(at))?;
            self.row.extend(number);
        }
        let Some(time_s) = time.filter(|_| self.row.len() == self.columns.len()) else {
            if self.time.is_none() {
                let what = "a value is missing, and rows without times are counted: none may be left out";
                return Err(fault(line, 1, what.to_owned()));
            }
            self.leave_out(line);
            return Ok(());
        };
        let table = &mut self.table;
        room_for_one_more(&mut table.times_s).map_err(LogError::Memory)?;
        room_for_one_more(&mut table.lines).map_err(LogError::Memory)?;
        table.times_s.push(time_s);
        table.lines.push(line);
        for (column, number) in table.columns.iter_mut().zip(&self.row) {
            room_for_one_more(&mut column.numbers).map_err(LogError::Memory)?;
            column.numbers.push(*number);
        }
        Ok(())
    }

    fn leave_out(&mut self, line: u64) {
        self.table.left_out.get_or_insert((0, line)).0 += 1;
    }

    fn cut_off(&mut self, line: u64) {
        self.leave_out(line);
    }

    fn other(&mut self) {}

    fn is_empty(&self) -> bool {
        self.table.lines.is_empty()
    }
}
