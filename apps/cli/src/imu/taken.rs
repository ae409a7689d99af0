//! How a record was read, as an `[imu]` that reads it in the same way.

use sins::log::{ColumnFrom, IMU_QUANTITIES, LogColumn, LogMapping, Separator, TimeFormat};
use sins::scene::Scene;

use super::quantity::{Quantity, Sensor, Stamp, unit_of_time};

/// What was found in a table without `[imu]`.
#[derive(Debug, Default)]
pub struct Guess {
    pub names: Vec<String>,
    pub columns: Vec<(String, Quantity)>,
    pub time: Option<(String, Stamp)>,
    pub rate_hz: Option<f64>,
    /// What separates fields; 0 as a comma.
    pub separator: u8,
    /// Whether the header stands behind a "#".
    pub is_marked: bool,
}

/// The `[imu]` of what was found; `None`: a sensor has more than three columns.
pub fn of(guess: &Guess) -> Option<Box<LogMapping>> {
    let mut mapping = LogMapping::of_imu();
    mapping.separator = match guess.separator {
        b';' => Separator::Semicolon,
        b'\t' => Separator::Tab,
        _ => Separator::Comma,
    };
    // A header that is a comment has no names that could be looked for.
    mapping.header = u64::from(!guess.is_marked);
    let from = |name: &str| {
        let mut places = guess.names.iter().enumerate().filter(|(_, own)| *own == name);
        let (place, is_only) = (places.next()?.0, places.next().is_none());
        let is_plain = !name.is_empty()
            && name.len() <= MOST_LETTERS
            && !name.starts_with(['#', '%'])
            && !name.contains('"')
            && !name.chars().any(char::is_control);
        let by_name = is_plain && is_only && !guess.is_marked;
        Some(if by_name { ColumnFrom::Name(name.to_owned()) } else { ColumnFrom::Number(place + 1) })
    };
    match (&guess.time, guess.rate_hz) {
        (Some((name, stamp)), None) => {
            let time = &mut mapping.columns[0];
            time.from = from(name)?;
            match stamp {
                Stamp::Clock(format) => mapping.time_format = *format,
                Stamp::Number(si) => match unit_of_time(*si) {
                    Some(unit) => time.unit = unit,
                    None => time.scale = *si,
                },
            }
        }
        (_, rate_hz) => (mapping.time_format, mapping.rate_hz) = (TimeFormat::Row, rate_hz),
    }
    let mut next = [0, 0];
    for (name, quantity) in &guess.columns {
        let (sensor, stem) = match quantity.sensor {
            Sensor::Gyro => (0, "gyro"),
            Sensor::Accelerometer => (1, "accelerometer"),
        };
        let key = format!("{stem}_{}", ["x", "y", "z"].get(next[sensor])?);
        next[sensor] += 1;
        let place = IMU_QUANTITIES.iter().position(|own| own.key == key)?;
        mapping.columns[place] = LogColumn { from: from(name)?, unit: quantity.unit, ..LogColumn::default() };
    }
    Some(Box::new(mapping))
}

/// The longest name that a key can have.
const MOST_LETTERS: usize = 200;

/// The same with accelerometers of the other sign.
pub fn reversed(mut mapping: LogMapping) -> LogMapping {
    for (quantity, column) in IMU_QUANTITIES.iter().zip(&mut mapping.columns) {
        if quantity.key.starts_with("accelerometer") {
            column.scale = -column.scale;
            column.add = -column.add;
        }
    }
    mapping
}

/// The section `[imu]` of a mapping.
pub fn text(mapping: &LogMapping) -> String {
    let scene = Scene { imu: Box::new(mapping.clone()), ..Scene::default() };
    let keys = scene.changed_keys().into_iter().filter(|key| key.section == "imu");
    let lines: String = keys.map(|key| format!("{} = {}\n", key.name, key.value)).collect();
    format!("[imu]\n{lines}")
}
