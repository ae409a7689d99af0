//! The description of a key of a scene file: name, unit, place in the scene, meaning. The keys themselves are in [`super::table`].

use nalgebra::Vector3;

use super::draft::{Draft, FailureDraft};
use super::table::of_sensor;
use super::{Action, Scene, Updated};
use crate::base::error::Error;
use crate::base::parameter::{Range, Shape};
use crate::base::rows::of_path;
use crate::sensors::FailureFields;
use crate::truth::flight::{Channel, ManoeuvreFields, START};
use crate::unit::UNIT;

/// The sections, each with its name, as it stands in brackets, and what its keys set, in words.
macro_rules! sections {
    ($($section:ident $name:literal $doc:literal)*) => {
        /// The sections of a scene file.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Section {
            $($section),*
        }

        impl Section {
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$section),*];

            /// Its name, as it stands in brackets.
            pub fn name(self) -> &'static str {
                [$($name),*][self as usize]
            }

            /// What its keys set, in words.
            pub fn doc(self) -> &'static str {
                [$($doc),*][self as usize]
            }
        }
    };
}

sections! {
    Flight "flight" "the flight: a log, a built-in flight, or a start and [[manoeuvre]]s"
    Log "log" "how the table of a flight log is read: the column of each quantity that has not its own name; and its repair"
    Imu "imu" "how a record of an IMU is read, by a program that identifies its sensors: the columns of gyros and accelerometers"
    Manoeuvre "manoeuvre" "a manoeuvre; the list is flown in order; angles are positive to the right and up"
    Sinusoid "manoeuvre.sinusoid" "a sinusoid of the manoeuvre of kind sinusoids above it; up to 6"
    Options "options" "options of the simulator"
    Gyro "gyro" "gyro errors: a preset, and what differs from it"
    Accelerometer "accelerometer" "accelerometer errors: a preset, and what differs from it"
    Altimeter "altimeter" "errors of the altimeter, which aids the damped vertical channel"
    Start "start" "errors at the start: computed less true"
    Mounting "mounting" "mounting of the sensor block, and errors of what the INS believes about it: believed less true"
    Gravity "gravity" "true gravity less normal gravity: constant, and random over the distance flown"
    Failure "failure" "failure of one output of a sensor, for a time"
    Update "update" "update: a fix takes the place of the navigated position or velocity"
    Unit "unit" "the unit: an INS with a mode selector, an alignment and a status; times: 0 is a default"
    Panel "panel" "what the crew does at the panel of the unit, and when"
    Output "output" "what a program that flies the scene writes"
}

impl Section {
    /// Whether it stands in double brackets, any number of times.
    pub fn is_list(self) -> bool {
        matches!(self, Self::Manoeuvre | Self::Sinusoid | Self::Failure | Self::Update | Self::Panel)
    }

    /// How many lists an item of it is in: 0, it is no list.
    pub fn lists(self) -> usize {
        usize::from(self.is_list()) + usize::from(self == Self::Sinusoid)
    }
}

/// A unit of a scene file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its name, such as "deg/h"; empty for a pure number.
    pub text: &'static str,
    /// Its size in SI units.
    pub si: f64,
    /// Name of the SI unit.
    pub si_text: &'static str,
}

impl Unit {
    /// The unit in brackets, as it stands behind a meaning.
    pub fn behind(&self) -> String {
        if self.text.is_empty() { String::new() } else { format!(" [{}]", self.text) }
    }
}

impl Shape {
    /// Whether a single number sets element `index`; `None`: a single number is not enough.
    pub fn single_sets(self, index: usize) -> Option<bool> {
        match self {
            Self::Number | Self::Axes => Some(true),
            Self::OffDiagonal(_) => Some(!index.is_multiple_of(4)),
            Self::Diagonal => Some(index.is_multiple_of(4)),
            Self::Vector | Self::Angles | Self::Matrix | Self::Choice(..) => None,
        }
    }

    /// How the numbers are written.
    pub fn expected(self) -> &'static str {
        match self {
            Self::Number => "a number",
            Self::Vector | Self::Angles => "three numbers",
            Self::Axes => "one number for all axes, or three",
            Self::OffDiagonal(_) => "one number for all elements off the diagonal, or nine row by row",
            Self::Diagonal => "one number for all elements of the diagonal, or nine row by row",
            Self::Matrix => "nine numbers row by row",
            Self::Choice(..) => "no number",
        }
    }
}

/// References to up to nine numbers of a draft, row by row.
pub type Places<'d> = core::iter::Flatten<core::array::IntoIter<Option<&'d mut f64>, 9>>;

/// Where the numbers of a key are in a draft.
#[derive(Debug, Clone, Copy)]
pub enum Place {
    /// At the place in the draft that this function gives.
    At(fn(&mut Draft) -> Places<'_>),
    /// The row of a table with this field of the interface.
    Row(&'static str),
}

impl Place {
    /// References to the numbers, row by row.
    pub fn of(self, draft: &mut Draft) -> Places<'_> {
        match self {
            Self::At(places) => places(draft),
            Self::Row(path) => {
                let Draft { start, scene: Scene { errors, unit, .. }, .. } = draft;
                let rest = of_path(&START, start.numbers_mut(), path);
                let of_unit = of_path(&UNIT, unit.parameters.numbers_mut(), path);
                row_by_row(errors.numbers_of(path).chain(of_unit).chain(rest))
            }
        }
    }
}

/// Where the value of a key goes.
#[derive(Debug, Clone, Copy)]
pub enum Target {
    /// Numbers in a unit; `field` is how the library names their place in SI. `range` is in SI, and the widest of all kinds of items.
    /// `None`: it depends on other values.
    Numbers { field: &'static str, unit: Unit, shape: Shape, range: Option<Range>, place: Place },
    /// One of several words.
    Choice {
        field: &'static str,
        words: &'static [&'static str],
        get: fn(&Draft) -> usize,
        set: fn(&mut Draft, usize),
    },
    /// A whole number. `None`: any.
    Count { field: &'static str, range: Option<Range>, get: fn(&Draft) -> u64, set: fn(&mut Draft, u64) },
    /// A text that is not empty.
    Text { example: &'static str, place: fn(&mut Draft) -> &mut String },
    /// True or false.
    Flag { get: fn(&Draft) -> bool, set: fn(&mut Draft, bool) },
    /// A column of `[log]` or `[imu]`, for the quantity of this place.
    Column(usize),
}

/// A key of a scene file.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    pub section: Section,
    pub name: &'static str,
    pub doc: &'static str,
    pub target: Target,
}

impl Key {
    pub const fn new(section: Section, name: &'static str, doc: &'static str, target: Target) -> Self {
        Self { section, name, doc, target }
    }

    /// The field of the library, as its errors name it; empty if the scene alone has this value.
    pub fn field(&self) -> &'static str {
        match self.target {
            Target::Numbers { field, .. } | Target::Choice { field, .. } | Target::Count { field, .. } => {
                field
            }
            Target::Text { .. } | Target::Flag { .. } | Target::Column(_) => "",
        }
    }

    /// Whether the section, or its item in `draft`, uses the key.
    pub fn is_used(&self, draft: &Draft) -> bool {
        match (self.section, self.name) {
            (Section::Manoeuvre, "kind") => true,
            (Section::Manoeuvre, _) => ManoeuvreFields::KINDS[draft.manoeuvre.kind].1.contains(&self.field()),
            (Section::Sinusoid, "amplitude_deg") => draft.sinusoid.channel != Channel::Speed,
            (Section::Sinusoid, "amplitude_m_s") => draft.sinusoid.channel == Channel::Speed,
            (Section::Failure, "axis") => draft.failure.sensor != 2,
            (Section::Failure, _) => {
                of_sensor(self, draft.failure.sensor).is_none() && self.is_of_kind(&draft.failure)
            }
            (Section::Update, "sigma_m") => draft.update.updated != Updated::Velocity,
            (Section::Update, "sigma_m_s") => draft.update.updated == Updated::Velocity,
            (Section::Panel, "latitude_deg" | "longitude_deg") => draft.action.action == Action::Position,
            (Section::Panel, "heading_deg") => draft.action.action == Action::Heading,
            _ => true,
        }
    }

    /// Whether the text of an item of a list needs the key, and so has it with any value.
    pub fn is_required(&self, draft: &Draft) -> bool {
        let is_one = match self.section {
            Section::Manoeuvre => self.name == "kind",
            Section::Sinusoid => self.name == "channel",
            Section::Failure => ["sensor", "axis", "kind"].contains(&self.name),
            Section::Update => ["kind", "at_s"].contains(&self.name),
            Section::Panel => true,
            _ => false,
        };
        is_one && self.is_used(draft)
    }

    /// Whether this kind of failure uses the key.
    pub fn is_of_kind(&self, failure: &FailureDraft) -> bool {
        let (_, uses) = FailureFields::KINDS[failure.fields.kind];
        let is_general = ["sensor", "axis", "kind", "from_s", "until_s"].contains(&self.name);
        is_general || uses.iter().any(|quantity| self.field().starts_with(quantity))
    }

    /// Whether only a flight of the scene's own manoeuvres has the value.
    pub fn is_of_manoeuvres(&self) -> bool {
        self.field().starts_with("start.") || (self.section == Section::Flight && self.name == "repeat")
    }

    /// Name of the key that takes this quantity in SI: the library's own name of its field; if this key has another unit.
    pub fn si_name(&self) -> Option<&'static str> {
        let Target::Numbers { field, unit, .. } = self.target else { return None };
        let name = field.split_once('.').map_or(field, |(_, name)| name);
        (unit.si != 1.0 && name != self.name).then_some(name)
    }

    /// Its name with that of its section: "gyro.bias_deg_h".
    pub fn path(&self) -> String {
        format!("{}.{}", self.section.name(), self.name)
    }

    /// An error about it, in its unit, in its words.
    pub fn sentence_of(&self, error: &Error) -> String {
        let Target::Numbers { .. } = self.target else { return error.to_string() };
        let index = error.index.map_or(String::new(), |index| format!("[{index}]"));
        error.sentence_about(&format!("{}{index}", self.path()))
    }
}

/// A writer compares hundreds of keys with their defaults, so no list is allocated.
fn places<'d>(numbers: impl IntoIterator<Item = &'d mut f64>) -> Places<'d> {
    let mut numbers = numbers.into_iter();
    [(); 9].map(|()| numbers.next()).into_iter().flatten()
}

pub fn one(number: &mut f64) -> Places<'_> {
    places([number])
}

pub fn vector(vector: &mut Vector3<f64>) -> Places<'_> {
    places(vector.iter_mut())
}

/// The numbers, those of a matrix, which stores them column by column, row by row.
fn row_by_row<'d>(numbers: impl Iterator<Item = &'d mut f64>) -> Places<'d> {
    let mut numbers = numbers;
    let [a, d, g, b, e, h, c, f, i] = [(); 9].map(|()| numbers.next());
    let places = if i.is_some() { [a, b, c, d, e, f, g, h, i] } else { [a, d, g, b, e, h, c, f, i] };
    places.into_iter().flatten()
}
