//! The structs that the table of sensor parameters makes, as Rust sources: `TriadParameters` of the crate, `sins_gyro_params` and
//! `sins_accel_params` of the interface.

use crate::base::parameter::{Field, Parameter, Range, Shape};
use crate::tables::PARAMETERS;
use crate::text;

const TRIAD_DOC: &str = "\
Errors of a triad of sensors, axis by axis in sensor axes. All zero is an ideal triad.";

const GYRO_DOC: &str = "\
Errors of the gyros; each array is x, y, z of the sensor axes (sins_options.axes), each matrix row by row. All zero is an ideal
triad. Signal: the angular rate. Densities do not depend on the sample rate.

Effects act in this order, along the path of the signal: bandwidth; then errors that depend on the signal (scale factor,
misalignment, asymmetry, nonlinearity), on the true specific force (g-sensitivity, g2-sensitivity) and on temperature; then
biases and noise; then dead zone, range, quantization.

Asymmetry, nonlinearity, dead zone and range, g2-sensitivity of the gyros, and vibration rectification of the accelerometers
act on the mean signal of a subsample, whose length is dt = interval / (updates_per_sample * subsamples). The mean reduces the
effect of a vibration of frequency f. With x = pi f dt, nonlinearity and rectification are too small by the fraction 1 - (sin
x / x)^2. Asymmetry is too small by up to the fraction 1 - cos x, if the vibration changes the sign of the signal. If f is a
tenth of the sample rate, these fractions are 0.8 % and 1.2 % with two subsamples per interval, 3.2 % and 4.9 % with one.";

const ACCEL_DOC: &str = "\
Errors of the accelerometers; each array is x, y, z of the sensor axes (sins_options.axes), each matrix row by row. All zero is
an ideal triad. Signal: the specific force. Densities do not depend on the sample rate.

Effects act in this order, along the path of the signal: size effect, bandwidth; then errors that depend on the signal (scale
factor, misalignment, asymmetry, nonlinearity, vibration rectification) and on temperature; then biases and noise; then dead
zone, range, quantization. sins_gyro_params describes the effects that act on the mean of a subsample.";

const GYRO_ACCESS: Access = Access {
    name: "gyro",
    argument: "params",
    set: r#"
Sets the gyro errors: before the first sample or in flight, from the next interval on. The random numbers of other
effects do not change. Random processes that were active continue.

SINS_ERROR_INVALID_ARGUMENT: a value out of its range.
SINS_ERROR_BAD_STATE: temperature coefficients while samples without a temperature wait, or while navigating on
increments.

```c
gyro.bias_rad_s[2] = 0.02 * SINS_DEG_PER_HOUR;
gyro.random_walk_rad_sqrt_s[0] = 0.005 * SINS_DEG_PER_SQRT_HOUR;
gyro.scale_factor[0] = 100.0 * SINS_PPM;
printf("%s\n", sins_status_string(sins_set_gyro(sim, &gyro)));  // SINS_OK
```"#,
    get: "\
Reads the gyro errors that are set. May be called at any moment. After sins_snapshot_load() they are those of the
snapshot.",
};

const ACCEL_ACCESS: Access = Access {
    name: "accel",
    argument: "params",
    set: r#"
Sets the accelerometer errors: before the first sample or in flight, from the next interval on. The random numbers of
other effects do not change. Random processes that were active continue.

SINS_ERROR_INVALID_ARGUMENT, SINS_ERROR_BAD_STATE: as sins_set_gyro().

```c
accel.bias_m_s2[1] = 50.0 * SINS_MICRO_G;
printf("%s\n", sins_status_string(sins_set_accel(sim, &accel)));  // SINS_OK
```"#,
    get: "\
Reads the accelerometer errors that are set. May be called at any moment. After sins_snapshot_load() they are those of the
snapshot.",
};

/// Width of the text of a comment.
const WIDTH: usize = 110;

/// The functions that set and read parameters of a simulator.
pub struct Access {
    /// Their names behind sins_set_ and sins_get_; that of the function of the crate that reads.
    pub name: &'static str,
    /// Name of their argument.
    pub argument: &'static str,
    /// Documentation of the function that sets.
    pub set: &'static str,
    /// Documentation of the function that reads.
    pub get: &'static str,
}

/// The field of a parameter with gyros, or with accelerometers.
type FieldOf = fn(&Parameter) -> Option<Field>;

/// The field that a parameter is in a struct.
struct Member {
    name: &'static str,
    kind: &'static str,
    doc: String,
    shape: Shape,
}

/// `TriadParameters`, with its numbers and what a snapshot keeps of it.
pub fn triad() -> String {
    let members: Vec<_> = PARAMETERS.iter().map(|row| Some(of_triad(row))).collect();
    let stored: String = PARAMETERS.iter().map(|row| format!("    {}: ANY,\n", row.name)).collect();
    comment("", TRIAD_DOC)
        + "#[derive(Debug, Clone, Copy, PartialEq, Default)]\npub struct TriadParameters {\n"
        + &fields(&members)
        + &format!("}}\n\nstored!(TriadParameters {{\n{stored}}});\n\n")
        + &numbers("TriadParameters", "pub", &members)
}

/// `sins_gyro_params` and `sins_accel_params`.
pub fn interface() -> String {
    let structs: [(&str, &str, FieldOf, Access); 2] = [
        ("sins_gyro_params", GYRO_DOC, |row| row.gyro, GYRO_ACCESS),
        ("sins_accel_params", ACCEL_DOC, |row| row.accel, ACCEL_ACCESS),
    ];
    let text = structs.map(|(name, doc, field, access)| {
        let members: Vec<_> =
            PARAMETERS.iter().map(|row| Some(of_interface(row, field(row)?, field))).collect();
        structure(name, doc, &fields(&members))
            + &numbers(name, "pub(super)", &members)
            + &access.functions(name)
    });
    text.join("\n")
}

impl Access {
    /// The functions, with a struct of this name.
    pub fn functions(&self, of: &str) -> String {
        let Self { name, argument, set, get } = self;
        let one = |verb, doc, pointer, own: &str| {
            comment("", doc)
                + "#[unsafe(no_mangle)]\npub unsafe extern \"C-unwind\" "
                + &format!(
                    "fn sins_{verb}_{name}(sim: *mut sins_sim, {argument}: *{pointer} {of}) -> sins_status {{\n"
                )
                + "    // SAFETY: the host's promise.\n"
                + &format!("    unsafe {{ {verb}(sim, {argument}, \"{argument}\", Simulator::{own}) }}\n}}\n")
        };
        format!("\n{}\n{}", one("set", set, "const", &format!("set_{name}")), one("get", get, "mut", name))
    }
}

/// A struct of the interface with these fields behind its size.
pub fn structure(name: &str, doc: &str, fields: &str) -> String {
    comment("", doc)
        + &format!("#[repr(C)]\n#[derive(Debug, Clone, Copy, Default)]\npub struct {name} {{\n")
        + &format!("    /// sizeof({name})\n    pub struct_size: u32,\n")
        + &format!("    /// Must be 0.\n    pub reserved: u32,\n{fields}}}\n\n")
}

fn of_triad(row: &Parameter) -> Member {
    let kind = match row.shape.count() {
        1 => "f64",
        3 => "Vector3<f64>",
        _ => "Matrix3<f64>",
    };
    let doc = match (row.gyro, row.accel) {
        (Some(gyro), Some(accel)) if unit(&gyro) != unit(&accel) => {
            format!("{} [{} or {}].", sentence(row.doc), unit(&gyro), unit(&accel))
        }
        (Some(field), Some(_)) => format!("{} [{}].", sentence(row.doc), unit(&field)),
        (Some(gyro), None) => format!("{} [{}]. Of gyros alone.", sentence(row.doc), unit(&gyro)),
        (None, Some(accel)) => format!("{} [{}]. Of accelerometers alone.", sentence(row.doc), unit(&accel)),
        (None, None) => unreachable!("{} is of no sensor", row.name),
    };
    Member { name: row.name, kind, doc, shape: row.shape }
}

fn of_interface(row: &Parameter, field: Field, field_of: FieldOf) -> Member {
    let kind = match row.shape.count() {
        1 => "f64",
        3 => "[f64; 3]",
        _ => "[f64; 9]",
    };
    let sigma = field.range.needed_by().map(|name| {
        let sigma = PARAMETERS.iter().find(|row| row.name == name).and_then(field_of);
        sigma.expect("it has a time").path.split_once('.').expect("a path").1
    });
    let doc = definition(row.doc_of(&field), &field, sigma, row.note);
    Member { name: field.name(), kind, doc, shape: row.shape }
}

/// The documentation of a field, which is needed where the field `sigma` is not 0.
pub fn definition(doc: &str, field: &Field, sigma: Option<&str>, note: &str) -> String {
    let (low, high) = field.range.ends();
    // In one line: with its upper end alone a line would begin as an item of a list.
    let range = format!("{}\u{a0}to\u{a0}{}", number(low), number(high));
    let (doc, off) = doc.split_once("; 0: ").unwrap_or((doc, "none"));
    let range = match field.range {
        Range::Within(..) => range,
        Range::OffOr(..) => format!("{range}; 0: {off}"),
        Range::OrDefault(default, ..) if default != 0.0 && number(default).len() < 8 => {
            format!("{range}; 0: {}", number(default))
        }
        Range::OrDefault(..) => format!("{range}; 0: the default"),
        Range::TimeOf(..) | Range::DistanceOf(..) => {
            format!("{range}; needed where {} is not 0", sigma.expect("a parameter needs it"))
        }
    };
    format!("{} [{}], {range}. {note}", sentence(doc), unit(field))
}

/// A definition as a sentence begins.
pub fn sentence(doc: &str) -> String {
    let (first, rest) = doc.split_at(1);
    first.to_uppercase() + rest
}

pub fn unit(field: &Field) -> &str {
    if field.unit.is_empty() { "1" } else { field.unit }
}

/// Few digits: 0.5, 10000, 1e6.
fn number(value: f64) -> String {
    for (part, name) in [(core::f64::consts::PI, "pi"), (core::f64::consts::FRAC_PI_2, "pi/2")] {
        if value.abs() == part {
            return if value > 0.0 { name.to_owned() } else { format!("-{name}") };
        }
    }
    if value == 0.0 || (1e-2..1e5).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}

fn fields(members: &[Option<Member>]) -> String {
    let line = |member: &Member| {
        comment("    ", &member.doc) + &format!("    pub {}: {},\n", member.name, member.kind)
    };
    members.iter().flatten().map(line).collect()
}

/// The numbers of a struct as slices, parameter by parameter; of one that it lacks an empty one.
fn numbers(name: &str, visibility: &str, members: &[Option<Member>]) -> String {
    let slices = |is_mutable: bool| -> String {
        let slice = |member: &Option<Member>| match (member, is_mutable) {
            (None, false) => "            &[],\n".to_owned(),
            (None, true) => "            &mut [],\n".to_owned(),
            (Some(Member { name, shape: Shape::Number, .. }), false) => {
                format!("            from_ref(&self.{name}),\n")
            }
            (Some(Member { name, shape: Shape::Number, .. }), true) => {
                format!("            from_mut(&mut self.{name}),\n")
            }
            (Some(Member { name, .. }), false) => format!("            self.{name}.as_slice(),\n"),
            (Some(Member { name, .. }), true) => format!("            self.{name}.as_mut_slice(),\n"),
        };
        members.iter().map(slice).collect()
    };
    format!(
        "impl {name} {{
    /// The numbers of each parameter of the table; of one that this lacks none.
    {visibility} fn numbers(&self) -> [&[f64]; COUNT] {{
        [
{}        ]
    }}

    /// [`Self::numbers`], to be changed.
    {visibility} fn numbers_mut(&mut self) -> [&mut [f64]; COUNT] {{
        [
{}        ]
    }}
}}
",
        slices(false),
        slices(true)
    )
}

/// A doc comment. Lines that end in the text stay; one line alone is broken where it is too long.
pub fn comment(indent: &str, text: &str) -> String {
    let lines: Vec<String> = text.trim().lines().map(str::to_owned).collect();
    let width = if lines.len() == 1 { indent.len() + "/// ".len() + WIDTH } else { usize::MAX };
    text::comment(&format!("{indent}///"), &lines, width).replace('\u{a0}', " ")
}
