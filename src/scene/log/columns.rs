//! The columns of a log: which quantity each of them has.

use core::ops::Range;

use csv::StringRecord;

use super::{LogError, Reading, fault};
use crate::base::error::Error;
use crate::base::units::DEG;
use crate::scene::{excerpt, listed, nearest};

/// The quantities of a log: name, field of a sample, index in it. An angle may be in degrees: the name then ends in `_deg`.
const QUANTITIES: [(&str, &str, Option<usize>); 17] = [
    ("time_s", "sample.time_s", None),
    ("latitude_rad", "sample.latitude_rad", None),
    ("longitude_rad", "sample.longitude_rad", None),
    ("height_m", "sample.height_m", None),
    ("roll_rad", "sample.roll_rad", None),
    ("pitch_rad", "sample.pitch_rad", None),
    ("heading_rad", "sample.heading_rad", None),
    ("velocity_east_m_s", "sample.velocity_enu_m_s", Some(0)),
    ("velocity_north_m_s", "sample.velocity_enu_m_s", Some(1)),
    ("velocity_up_m_s", "sample.velocity_enu_m_s", Some(2)),
    ("rate_x_rad_s", "sample.angular_rate_rad_s", Some(0)),
    ("rate_y_rad_s", "sample.angular_rate_rad_s", Some(1)),
    ("rate_z_rad_s", "sample.angular_rate_rad_s", Some(2)),
    ("force_x_m_s2", "sample.specific_force_m_s2", Some(0)),
    ("force_y_m_s2", "sample.specific_force_m_s2", Some(1)),
    ("force_z_m_s2", "sample.specific_force_m_s2", Some(2)),
    ("temperature_c", "sample.temperature_c", None),
];

/// Number of quantities.
pub const COUNT: usize = QUANTITIES.len();

/// The name of a quantity.
pub fn name(quantity: usize) -> &'static str {
    QUANTITIES[quantity].0
}

/// The quantity that an error about a sample is about, in the order time, position, attitude, velocity, angular rate, specific force,
/// temperature.
pub fn quantity_of(error: &Error) -> Option<usize> {
    QUANTITIES.iter().position(|&(_, field, index)| (field, index) == (error.field, error.index))
}

/// The name of the column that an error about a sample is about.
pub fn column_of(error: &Error) -> Option<&'static str> {
    quantity_of(error).map(name)
}

/// The quantities of the attitude.
const ATTITUDE: [&str; 3] = ["roll_rad", "pitch_rad", "heading_rad"];

/// The first of the quantities that a log may leave out.
pub const VELOCITY: usize = 7;
pub const RATE: usize = 10;
pub const FORCE: usize = 13;
pub const TEMPERATURE: usize = 16;

/// The quantities that come together: all of them or none.
const TRIPLES: [Range<usize>; 3] = [VELOCITY..RATE, RATE..FORCE, FORCE..TEMPERATURE];

/// Place of a quantity in a row, and its unit in SI.
#[derive(Clone, Copy)]
pub struct Column {
    pub place: usize,
    pub si: f64,
}

impl Column {
    /// Its name, which is that of its quantity or the one in degrees.
    pub fn name(&self, quantity: usize) -> String {
        let name = name(quantity);
        in_degrees(name).filter(|_| self.si != 1.0).unwrap_or_else(|| name.to_owned())
    }
}

/// The name of an angle in degrees. Rates can be given only in radians.
fn in_degrees(quantity: &str) -> Option<String> {
    let stem = quantity.strip_suffix("_rad")?;
    Some(format!("{stem}_deg"))
}

/// The columns of a header, by their quantities.
pub fn columns(
    header: &StringRecord,
    line: u64,
    reading: Reading,
) -> Result<[Option<Column>; COUNT], LogError> {
    let mut columns = [None; COUNT];
    for (column, quantity) in columns.iter_mut().zip((0..COUNT).map(name)) {
        let degrees = in_degrees(quantity);
        if reading == Reading::WithoutAttitude && ATTITUDE.contains(&quantity) {
            continue;
        }
        for (place, name) in header.iter().enumerate() {
            let si = match name {
                _ if name == quantity => 1.0,
                _ if Some(name) == degrees.as_deref() => DEG,
                _ => continue,
            };
            if column.is_some() {
                let sentence = format!("{name}: an earlier column has that quantity");
                return Err(fault(line, place + 1, sentence));
            }
            *column = Some(Column { place, si });
        }
    }
    let is_wanted = |index: usize| {
        let triple = TRIPLES.iter().find(|triple| triple.contains(&index));
        match triple {
            Some(triple) => columns[triple.clone()].iter().any(Option::is_some),
            None if reading == Reading::WithoutAttitude => {
                index < VELOCITY && !ATTITUDE.contains(&name(index))
            }
            None => index < VELOCITY,
        }
    };
    let missing = (0..COUNT).filter(|&index| columns[index].is_none() && is_wanted(index));
    let missing: Vec<String> = missing.map(|index| missing_column(name(index), header)).collect();
    let other = [(';', "semicolons"), ('\t', "tabs")]
        .into_iter()
        .find(|(mark, _)| header.iter().any(|name| name.contains(*mark)));
    if missing.is_empty() {
        Ok(columns)
    } else if let Some((_, marks)) = other {
        Err(fault(
            line,
            1,
            format!("columns separated by {marks}: expected commas between fields, and decimal points"),
        ))
    } else {
        let header = listed(header.iter());
        Err(fault(line, 1, format!("missing columns: {}; the header has {header}", missing.join(", "))))
    }
}

/// The name of a missing column, with the name of its form in degrees and the name that may have been meant.
fn missing_column(quantity: &str, header: &StringRecord) -> String {
    let degrees = in_degrees(quantity).map_or(String::new(), |name| format!(" or {name}"));
    let unknown = header.iter().filter(|column| !(0..COUNT).map(name).any(|own| own == *column));
    let near = nearest(quantity, unknown).map_or(String::new(), |name| format!(" (found {})", excerpt(name)));
    format!("{quantity}{degrees}{near}")
}
