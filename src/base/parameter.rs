//! Rows of the tables of parameters. `build.rs` reads this file too.

/// Correlation times [s] for which the discretisation is accurate to every digit. A longer time would be a constant, a shorter one
/// white noise.
pub const CORRELATION_TIMES_S: (f64, f64) = (1e-9, 1e15);

/// A parameter of a triad of gyros or of accelerometers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Field of [`TriadParameters`](crate::sensors::TriadParameters).
    pub name: &'static str,
    /// How many numbers the parameter has, and which of them may be set.
    pub shape: Shape,
    /// Whether the parameter is the size of a random quantity, which is drawn anew in each run.
    pub is_random: bool,
    /// Definition, without unit and range, in lower case.
    pub doc: &'static str,
    /// Further sentences for the header; empty: no further sentence.
    pub note: &'static str,
    /// The parameter of gyros.
    pub gyro: Option<Field>,
    /// The parameter of accelerometers.
    pub accel: Option<Field>,
}

/// A parameter of another table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Place in the struct of the crate: "anomaly.mean".
    pub place: &'static str,
    /// How many numbers the parameter has.
    pub shape: Shape,
    /// Whether the parameter is the size of a random quantity, which is drawn anew in each run.
    pub is_random: bool,
    /// Name, definition, range and key.
    pub field: Field,
    /// Further sentences for the header; empty: no further sentence.
    pub note: &'static str,
}

/// A parameter of one kind of sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Field {
    /// Field of the C interface with its struct, as in error messages: "gyro.bias_rad_s".
    pub path: &'static str,
    /// SI unit; empty: a pure number.
    pub unit: &'static str,
    /// Definition for this kind of sensor; empty: the definition of the parameter.
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

/// How many numbers a parameter has. Matrices are row by row in the interface and in scene files.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// One number.
    Number,
    /// One number an axis: x, y, z of the sensor axes.
    Axes,
    /// Three numbers: x, y, z.
    Vector,
    /// Three numbers: roll, pitch, heading.
    Angles,
    /// A matrix. A single number in a scene file sets all elements off the diagonal. The rule says why the diagonal is 0.
    OffDiagonal(&'static str),
    /// A matrix. A single number in a scene file sets the diagonal.
    Diagonal,
    /// A matrix of nine numbers.
    Matrix,
    /// No number: a variant of the first enumeration, that of the crate, which is a number of the second one in the interface.
    Choice(&'static str, &'static str),
}

/// The values that a parameter may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// A value from the first to the second number.
    Within(f64, f64),
    /// 0, which means off, or a value from the first to the second number.
    OffOr(f64, f64),
    /// 0, which means the first number or, if that is 0, a default that depends on other things; or a value from the second to the
    /// third number.
    OrDefault(f64, f64, f64),
    /// Correlation time of the process whose standard deviation is the named parameter. It is from the first to the second number
    /// if the standard deviation is not 0; otherwise it may also be 0.
    TimeOf(&'static str, f64, f64),
    /// Correlation distance, likewise.
    DistanceOf(&'static str, f64, f64),
}

impl Parameter {
    /// Definition of `field`, which is the gyro or the accelerometer field of this parameter.
    pub const fn doc_of(&self, field: &Field) -> &'static str {
        if field.doc.is_empty() { self.doc } else { field.doc }
    }
}

impl Shape {
    /// Number of values.
    pub const fn count(self) -> usize {
        match self {
            Self::Number => 1,
            Self::Axes | Self::Vector | Self::Angles => 3,
            Self::OffDiagonal(_) | Self::Diagonal | Self::Matrix => 9,
            Self::Choice(..) => 0,
        }
    }

    /// Place in memory, where matrices are column by column, of the element `index` of the interface. The inverse mapping is the
    /// same.
    pub const fn place(self, index: usize) -> usize {
        if self.count() == 9 { index % 3 * 3 + index / 3 } else { index }
    }
}

impl Range {
    /// Least and largest value, except for a 0 that means off or a default.
    pub const fn ends(self) -> (f64, f64) {
        match self {
            Self::Within(low, high)
            | Self::OffOr(low, high)
            | Self::OrDefault(_, low, high)
            | Self::TimeOf(_, low, high)
            | Self::DistanceOf(_, low, high) => (low, high),
        }
    }

    /// The parameter whose correlation time or distance this is.
    pub const fn needed_by(self) -> Option<&'static str> {
        match self {
            Self::TimeOf(sigma, ..) | Self::DistanceOf(sigma, ..) => Some(sigma),
            Self::Within(..) | Self::OffOr(..) | Self::OrDefault(..) => None,
        }
    }
}

impl Field {
    /// Name of the field in its struct.
    pub fn name(&self) -> &'static str {
        self.path.split_once('.').map_or(self.path, |(_, name)| name)
    }
}

/// Of a row: its number is the same in each run.
pub const GIVEN: bool = false;
/// Of a row: its number says how large an error is that is drawn in each run.
pub const RANDOM: bool = true;

/// A field, with its key and the SI units in one unit of the key.
pub const fn own_field(
    (path, unit): (&'static str, &'static str),
    range: Range,
    (key, key_unit, key_si): (&'static str, &'static str, f64),
    effect: &'static str,
) -> Field {
    Field { path, unit, doc: "", range, key, key_unit, key_si, effect }
}

/// A field of sensors that have the parameter.
pub const fn field(
    path: (&'static str, &'static str),
    range: Range,
    key: (&'static str, &'static str, f64),
    effect: &'static str,
) -> Option<Field> {
    Some(own_field(path, range, key, effect))
}

/// `field` with its own definition.
pub const fn defined(doc: &'static str, field: Option<Field>) -> Option<Field> {
    match field {
        Some(field) => Some(Field { doc, ..field }),
        None => None,
    }
}

/// A row with its definition.
pub const fn row(
    place: &'static str,
    shape: Shape,
    is_random: bool,
    doc: &'static str,
    field: Field,
    note: &'static str,
) -> Row {
    Row { place, shape, is_random, field: Field { doc, ..field }, note }
}

/// A row without numbers.
pub const fn choice(
    place: &'static str,
    (own, enumeration): (&'static str, &'static str),
    (path, doc): (&'static str, &'static str),
    note: &'static str,
) -> Row {
    let field = own_field((path, ""), Range::Within(0.0, 0.0), ("", "", 1.0), "");
    row(place, Shape::Choice(own, enumeration), false, doc, field, note)
}
