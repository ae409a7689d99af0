//! `[log]` and `[imu]`: how a table is read, and what is repaired.

use std::borrow::Cow;

use super::column::{ColumnFrom, LogColumn};
use super::quantity::{IMU_QUANTITIES, Q0, QUANTITIES, ROLL, VARIATION, VELOCITY};

/// How times are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TimeFormat {
    /// A number, in seconds or the unit of the column.
    #[default]
    Number,
    /// hh:mm:ss or hhmmss, with decimals; a day is added at midnight. A number may lack its first zero: 91459.
    Hms,
    /// Date and time in ISO 8601, year, month and day also between slashes or points. Times count from the midnight before the first row.
    Iso,
    /// Day, month and year between points, slashes or hyphens, and a time; otherwise as ISO 8601.
    Dmy,
    /// Month, day and year, and a time; otherwise as ISO 8601.
    Mdy,
    /// mm:ss or h:mm:ss, with decimals, as a stopwatch shows them.
    Mmss,
    /// Not at all: the rows have a rate.
    Row,
}

impl TimeFormat {
    /// Words of a scene.
    pub const WORDS: [(&str, Self); 7] = [
        ("s", Self::Number),
        ("hms", Self::Hms),
        ("iso", Self::Iso),
        ("row", Self::Row),
        ("dmy", Self::Dmy),
        ("mdy", Self::Mdy),
        ("mmss", Self::Mmss),
    ];

    /// Its word of a scene.
    pub(super) fn word(self) -> &'static str {
        Self::WORDS.iter().find(|(_, format)| *format == self).map_or("", |(word, _)| word)
    }
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
    /// Each quantity. They are not part of the struct, which would take 5 KB of a stack.
    pub columns: Box<[LogColumn]>,
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
    /// Of a table with the rows of several vehicles: the column that tells them apart, and its cell in the rows that are read. Empty:
    /// every row is read.
    pub only_column: String,
    /// See [`Self::only_column`].
    pub only: String,
    /// Whether the path is smoothed ([`crate::log::smooth`]).
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
    /// That of `[imu]`, for a record of an IMU: no column is named.
    pub fn of_imu() -> Self {
        Self { columns: vec![LogColumn::default(); IMU_QUANTITIES.len()].into(), ..Self::default() }
    }

    /// Whether the path is smoothed: so it is too if the attitude follows from it.
    pub fn smooths(&self) -> bool {
        self.smooth || self.is_coordinated
    }

    /// Whether it says where an angle of the attitude or a part of its quaternion stands.
    pub fn names_attitude(&self) -> bool {
        let is_named = |quantity: usize| self.columns[quantity].from != ColumnFrom::OwnName;
        (ROLL..VELOCITY).chain(Q0..VARIATION).any(is_named)
    }

    /// The same repair of a table of the library's own columns.
    pub fn of_own_columns(&self) -> Self {
        let Self {
            smooth,
            smooth_rate_hz,
            position_sigma_m,
            attitude_sigma_rad,
            is_coordinated,
            attack_rad,
            ..
        } = *self;
        Self {
            smooth,
            smooth_rate_hz,
            position_sigma_m,
            attitude_sigma_rad,
            is_coordinated,
            attack_rad,
            ..Self::default()
        }
    }

    /// Whether the table is another than one of the library's own.
    pub(super) fn is_foreign(&self) -> bool {
        *self != self.of_own_columns()
    }
}

impl Default for LogMapping {
    fn default() -> Self {
        Self {
            columns: vec![LogColumn::default(); QUANTITIES.len()].into(),
            time_format: TimeFormat::Number,
            rate_hz: None,
            is_track_magnetic: false,
            separator: Separator::Comma,
            header: 1,
            skip: 0,
            missing: None,
            comment: "#".to_owned(),
            only_column: String::new(),
            only: String::new(),
            smooth: false,
            smooth_rate_hz: 50.0,
            position_sigma_m: None,
            attitude_sigma_rad: None,
            is_coordinated: false,
            attack_rad: 0.0,
        }
    }
}
