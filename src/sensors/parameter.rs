//! What one row of the table of sensor parameters states. `build.rs` reads it too.

/// A parameter of a triad of gyros or of accelerometers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Field of [`TriadParameters`](super::TriadParameters).
    pub name: &'static str,
    /// How many numbers it is, and which of them may be set.
    pub shape: Shape,
    /// Whether it is the size of something random, drawn anew each run.
    pub is_random: bool,
    /// Definition, without unit and range, in lower case.
    pub doc: &'static str,
    /// Further sentences of the header; empty: none.
    pub note: &'static str,
    /// The parameter of gyros.
    pub gyro: Option<Field>,
    /// The parameter of accelerometers.
    pub accel: Option<Field>,
}

/// A parameter of one kind of sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Field {
    /// Field of the C interface, with its struct as error messages have it: "gyro.bias_rad_s".
    pub path: &'static str,
    /// SI unit; empty: a pure number.
    pub unit: &'static str,
    /// Definition for this kind of sensor; empty: that of the parameter.
    pub doc: &'static str,
    /// The values that are accepted.
    pub range: Range,
    /// Key of a scene file, in the unit of data sheets.
    pub key: &'static str,
    /// The unit of the key; empty: a pure number.
    pub key_unit: &'static str,
    /// SI units in one unit of the key.
    pub key_si: f64,
    /// Effect of an error budget; empty: the parameter belongs to the effect of another one, or to several.
    pub effect: &'static str,
}

/// How many numbers a parameter is. Matrices are row by row in the interface and in scene files.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// One number.
    Number,
    /// One number an axis: x, y, z of the sensor axes.
    Axes,
    /// A matrix of which a single number in a scene file is all elements off the diagonal; the rule says why the diagonal is 0.
    OffDiagonal(&'static str),
    /// A matrix of which a single number in a scene file is the diagonal.
    Diagonal,
    /// A matrix of nine numbers.
    Matrix,
}

/// The values that a parameter may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// From the first to the second.
    Within(f64, f64),
    /// 0, which is off, or from the first to the second.
    OffOr(f64, f64),
    /// Correlation time of the process whose standard deviation the named parameter is: from the first to the second where that is
    /// not 0; elsewhere 0 too.
    TimeOf(&'static str, f64, f64),
}

impl Parameter {
    /// Definition of `field`, one of its two.
    pub const fn doc_of(&self, field: &Field) -> &'static str {
        if field.doc.is_empty() { self.doc } else { field.doc }
    }
}

impl Shape {
    /// How many numbers.
    pub const fn count(self) -> usize {
        match self {
            Self::Number => 1,
            Self::Axes => 3,
            Self::OffDiagonal(_) | Self::Diagonal | Self::Matrix => 9,
        }
    }

    /// Place in memory, where matrices are column by column, of the element `index` of the interface, or the other way round.
    pub const fn place(self, index: usize) -> usize {
        if self.count() == 9 { index % 3 * 3 + index / 3 } else { index }
    }
}

impl Range {
    /// Least and largest value, but for a 0 that is off.
    pub const fn ends(self) -> (f64, f64) {
        match self {
            Self::Within(low, high) | Self::OffOr(low, high) | Self::TimeOf(_, low, high) => (low, high),
        }
    }
}

impl Field {
    /// Name of the field in its struct.
    pub fn name(&self) -> &'static str {
        self.path.split_once('.').map_or(self.path, |(_, name)| name)
    }
}

/// A field, with its key and the SI units in one unit of the key.
pub(super) const fn field(
    (path, unit): (&'static str, &'static str),
    range: Range,
    (key, key_unit, key_si): (&'static str, &'static str, f64),
    effect: &'static str,
) -> Option<Field> {
    Some(Field { path, unit, doc: "", range, key, key_unit, key_si, effect })
}

/// `field` with a definition of its own.
pub(super) const fn defined(doc: &'static str, field: Option<Field>) -> Option<Field> {
    match field {
        Some(field) => Some(Field { doc, ..field }),
        None => None,
    }
}
