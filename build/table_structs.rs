//! The structs that the tables beside that of the triads make, as Rust sources.

use crate::base::parameter::{Row, Shape};
use crate::sensor_structs::{Access, comment, definition, sentence, structure, unit};
use crate::tables::{ALTIMETER, GRAVITY, INITIAL, MOUNTING, START, UNIT};

/// A struct of the interface with that of the crate.
struct Pair {
    name: &'static str,
    doc: &'static str,
    own: &'static str,
    /// Empty: the crate declares its struct itself.
    own_doc: &'static str,
    rows: &'static [Row],
    /// Name of the table.
    table: &'static str,
    /// `None`: no function of a simulator sets them.
    access: Option<Access>,
}

const PAIRS: [Pair; 6] = [
    Pair {
        name: "sins_altimeter_params",
        doc: "\
Errors of the barometric altimeter, whose height damps the vertical channel. All zero is an ideal altimeter.",
        own: "AltimeterParameters",
        own_doc: "Errors of the barometric height. All zero is an ideal altimeter.",
        rows: &ALTIMETER,
        table: "ALTIMETER",
        access: Some(Access {
            name: "altimeter",
            argument: "params",
            set: "\
Sets the errors of the barometric altimeter, whose height damps the vertical channel (SINS_VERTICAL_DAMPED), from the next
interval on.

SINS_ERROR_INVALID_ARGUMENT: a value out of its range.",
            get: "\
Reads the errors of the altimeter that are set. May be called at any moment. After sins_snapshot_load() they are those of
the snapshot.",
        }),
    },
    Pair {
        name: "sins_mounting",
        doc: "\
Position and attitude of the sensor block relative to the reference point of the flight samples, and the errors of what
the INS believes about them: believed = true + error, component by component. All zero is a block at the reference
point, along the body axes.

The ideal sensors measure the motion of the block, and sensor errors act in the axes of the block: sins_imu describes
the block. The INS navigates the block, and converts its solution to the reference point with the mounting that it
believes: sins_navigation and sins_errors describe the reference point. Initial errors apply to the solution for the
block, so at the start sins_errors can differ from them. Angular rate and specific force of a sample are those of the
reference point, along body axes. The barometric height is that of the reference point too.

Start in motion: at the start of a moving flight, and after a reposition, samples without an angular rate do not show
the angular acceleration of the first interval. The specific force of a block away from the reference point then lacks
the term angular acceleration times lever arm. In the second interval this term is correct to first order in the
interval's length, in the third to second order, later to third order. The navigation is not affected, because the INS
starts with the velocity that the block has at the mean angular rate of the first interval. With SINS_SAMPLE_ANGULAR_RATE
no term is missing.",
        own: "MountingParameters",
        own_doc: "Where the sensor block sits, and what the INS believes of it. The belief is the true value plus its error, for each \
            component of the arm and for each angle. All zero is a block at the reference point, along the body axes.",
        rows: &MOUNTING,
        table: "MOUNTING",
        access: Some(Access {
            name: "mounting",
            argument: "mounting",
            set: "\
Sets the mounting of the sensor block. Allowed before the first step, and after a reset or a reposition until the next
step. A reset and a reposition keep the mounting. The mounting does not affect a navigator on increments: its solution is
that of the block.

SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
SINS_ERROR_BAD_STATE: steps have been made.",
            get: "\
Reads the mounting of the sensor block that is set. May be called at any moment. After sins_snapshot_load() it is that of
the snapshot.",
        }),
    },
    Pair {
        name: "sins_gravity_params",
        doc: "\
Gravity disturbance: true gravity less the normal gravity that the INS computes, at the same point. The horizontal part is
the deflection of the vertical. The vertical part is called anomaly here. Each has a constant part and a random part. The
random part is a first-order Gauss-Markov field along the track: correlation sigma^2 exp(-d/D) over the distance d flown
over ground; D is the correlation distance. At rest it does not change. All zero is normal gravity.

Perfect accelerometers measure the disturbance, so it is in the ideal signals of sins_imu. In the INS it acts like an
accelerometer error. At rest, without a levelled start, a deflection xi makes the position error oscillate between 0 and 2
R xi, where R is the Earth's radius. A levelled start (SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS) is tilted by the deflection.",
        own: "GravityDisturbanceParameters",
        own_doc: "",
        rows: &GRAVITY,
        table: "GRAVITY",
        access: Some(Access {
            name: "gravity_disturbance",
            argument: "params",
            set: "\
Sets the gravity disturbance, true gravity less normal gravity. Allowed before the first step, and after a reset or a
reposition until the next step. A reset brings the same field back; after a reposition the field continues from its
current values. The disturbance does not affect a navigator on increments, because the host's increments already contain
its effect.

SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
SINS_ERROR_BAD_STATE: steps have been made.",
            get: "\
Reads the parameters of the gravity disturbance that are set. May be called at any moment. After sins_snapshot_load() they
are those of the snapshot.",
        }),
    },
    Pair {
        name: "sins_initial_errors",
        doc: "\
Errors with which the navigation starts: computed less true, east-north-up. Random errors with the standard deviations
(sigma) are drawn once a run and added. A reset and a reposition use the same random numbers again. With
SINS_VERTICAL_FOLLOW_TRUTH the errors of height and vertical velocity start at 0.",
        own: "InitialErrorParameters",
        own_doc: "Initial errors, computed less true, east-north-up axes. Each error is the sum of a given part and a part that is \
            drawn once a run.",
        rows: &INITIAL,
        table: "INITIAL",
        access: Some(Access {
            name: "initial_errors",
            argument: "errors",
            set: "\
Sets the errors with which the navigation starts. Allowed before the first step, and after a reset or a reposition until
the next step. After a reposition they apply to the start at its sample.

SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
SINS_ERROR_BAD_STATE: steps have been made.",
            get: "\
Reads the set errors with which the navigation starts. May be called at any moment. After sins_snapshot_load() they are
those of the snapshot.",
        }),
    },
    Pair {
        name: "sins_flight_start",
        doc: "\
Start of an embedded flight, level and straight.",
        own: "FlightStart",
        own_doc: "Start of a flight, level and straight.",
        rows: &START,
        table: "START",
        access: None,
    },
    Pair {
    name: "sins_unit_params",
    doc: "\
Times and limits of a unit. All zero, the default, is the unit that the comments describe.",
    own: "UnitParameters",
    own_doc: "Times and limits of a unit. 0 is the default of the table.",
    rows: &UNIT,
    table: "UNIT",
    access: None,
    },
];

/// The structs of the interface: sources by their names.
pub fn interface() -> Vec<(String, String)> {
    PAIRS.iter().map(|pair| (pair.table.to_lowercase() + "_params", pair.interface())).collect()
}

/// The structs of the crate, their checks and their numbers: sources by their names.
pub fn own() -> Vec<(String, String)> {
    PAIRS.iter().map(|pair| (pair.table.to_lowercase(), pair.own())).collect()
}

impl Pair {
    fn interface(&self) -> String {
        let field = |row: &Row| {
            let name = row.field.name();
            if let Shape::Choice(_, enumeration) = row.shape {
                let doc = format!("{}, of enum {enumeration}. {}", sentence(row.field.doc), row.note);
                let reserved = "    /// Must be 0.\n    pub reserved2: u32,\n";
                return comment("    ", &doc) + &format!("    pub {name}: i32,\n{reserved}");
            }
            let kind = if row.shape.count() == 1 { "f64" } else { "[f64; 3]" };
            let sigma = row.field.range.needed_by().and_then(|sigma| sigma.split_once('.'));
            let doc = definition(row.field.doc, &row.field, sigma.map(|(_, name)| name), row.note);
            comment("    ", &doc) + &format!("    pub {name}: {kind},\n")
        };
        structure(self.name, self.doc, &self.rows.iter().map(field).collect::<String>())
            + &format!("impl {} {{\n", self.name)
            + &self.numbers(|row, names| match names {
                [one] => format!("{one} = &mut self.{}", row.field.name()),
                _ => format!("[{}] = self.{}.each_mut()", names.join(", "), row.field.name()),
            })
            + "}\n"
            + &self.access.as_ref().map(|access| access.functions(self.name)).unwrap_or_default()
    }

    fn own(&self) -> String {
        let Self { own, table, .. } = self;
        let checks = format!(
            "    /// Checks every field.
    pub fn validate(&self) -> Result<(), Error> {{
        check(&{table}, &self.numbers())
    }}\n\n"
        );
        let numbers = self.numbers(|row, names| match (row.shape, names) {
            (Shape::Angles, [roll, pitch, heading]) => {
                format!(
                    "Euler {{ roll: {roll}, pitch: {pitch}, heading: {heading} }} = &mut self.{}",
                    row.place
                )
            }
            (_, [one]) => format!("{one} = &mut self.{}", row.place),
            _ => format!("[{}] = self.{}.data.0[0].each_mut()", names.join(", "), row.place),
        });
        self.declaration() + &format!("impl {own} {{\n{checks}{numbers}}}\n\n")
    }

    /// The numbers, in the order of the interface. `taken` is how the numbers of a row get names.
    fn numbers(&self, taken: fn(&Row, &[String]) -> String) -> String {
        let (mut lets, mut names) = (String::new(), Vec::new());
        for row in self.rows.iter().filter(|row| row.shape.count() > 0) {
            let first = names.len();
            names.extend((first..first + row.shape.count()).map(|index| format!("n{index}")));
            lets += &format!("        let {};\n", taken(row, &names[first..]));
        }
        let (count, names) = (names.len(), names.join(", "));
        format!(
            "    pub(crate) fn numbers(&self) -> [f64; {count}] {{
        {{ *self }}.numbers_mut().map(|number| *number)
    }}

    pub(crate) fn numbers_mut(&mut self) -> [&mut f64; {count}] {{
{lets}        [{names}]
    }}\n"
        )
    }

    /// The struct of the crate with what a snapshot keeps of it.
    fn declaration(&self) -> String {
        if self.own_doc.is_empty() {
            return String::new();
        }
        let field = |row: &Row| {
            let (low, high) = row.field.range.ends();
            let limit = format!(": {:?}", high.max(-low).ceil());
            let (kind, stored, unit) = match row.shape {
                Shape::Number => ("f64", limit, unit(&row.field)),
                Shape::Angles => ("Euler", String::new(), unit(&row.field)),
                Shape::Choice(own, _) => (own, String::new(), ""),
                _ => ("Vector3<f64>", limit, unit(&row.field)),
            };
            let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
            let doc = format!("{}{unit}.", sentence(row.field.doc));
            let line = comment("    ", &doc) + &format!("    pub {}: {kind},\n", row.place);
            (line, format!("    {}{stored},\n", row.place))
        };
        let (fields, stored): (String, String) = self.rows.iter().map(field).unzip();
        comment("", self.own_doc)
            + &format!(
                "#[derive(Debug, Clone, Copy, PartialEq, Default)]\npub struct {} {{\n{fields}}}\n\n",
                self.own
            )
            + &format!("stored!({} {{\n{stored}}});\n\n", self.own)
    }
}
