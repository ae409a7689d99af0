//! The errors of gyros and accelerometers: `[gyro]`, `[accelerometer]`, from the table of sensor parameters.

use super::super::draft::Draft;
use super::super::key::{Key, Place, Section, Target, Unit};
use crate::base::joined::first_words;
use crate::base::parameter::{Row, Shape};
use crate::sensors::{Field, Grade, PARAMETERS, Sensor, TriadParameters};

/// The words of a preset, and the grade of each; the first is none.
const GRADES: [(&str, Option<Grade>); 7] = [
    ("ideal", None),
    ("strategic", Some(Grade::Strategic)),
    ("navigation", Some(Grade::Navigation)),
    ("tactical", Some(Grade::Tactical)),
    ("industrial", Some(Grade::Industrial)),
    ("consumer", Some(Grade::Consumer)),
    ("paper2", Some(Grade::PaperSimulation2)),
];

/// Errors of gyros and accelerometers of a preset.
fn of_grade(index: usize) -> (TriadParameters, TriadParameters) {
    GRADES[index].1.map(Grade::parameters).unwrap_or_default()
}

/// The preset of the errors of the start.
pub const START: Key = preset(Section::Start, "initial.preset", |d, grade| {
    d.scene.errors.initial = GRADES[grade].1.map(Grade::start).unwrap_or_default();
});

/// A preset; a scene that is written states the errors themselves.
const fn preset(section: Section, field: &'static str, set: fn(&mut Draft, usize)) -> Key {
    let target = Target::Choice { field, words: const { &first_words(GRADES) }, get: |_| 0, set };
    Key {
        section,
        name: "preset",
        doc: "grade whose errors are set first; other keys then change single errors",
        target,
    }
}

pub const GYRO: &[Key] = &keys::<{ count(Sensor::Gyro) }>(
    Sensor::Gyro,
    preset(Section::Gyro, "gyro.preset", |d, grade| d.scene.errors.gyro = of_grade(grade).0),
);

pub const ACCELEROMETER: &[Key] = &keys::<{ count(Sensor::Accelerometer) }>(
    Sensor::Accelerometer,
    preset(Section::Accelerometer, "accel.preset", |d, grade| d.scene.errors.accel = of_grade(grade).1),
);

/// Number of keys: the preset, and each parameter that these sensors have.
const fn count(sensor: Sensor) -> usize {
    let (mut row, mut count) = (0, 1);
    while row < PARAMETERS.len() {
        if PARAMETERS[row].of(sensor).is_some() {
            count += 1;
        }
        row += 1;
    }
    count
}

/// The preset, then the parameters.
const fn keys<const N: usize>(sensor: Sensor, preset: Key) -> [Key; N] {
    let mut keys = [preset; N];
    let (mut row, mut place) = (0, 1);
    while row < PARAMETERS.len() {
        let parameter = &PARAMETERS[row];
        if let Some(field) = parameter.of(sensor) {
            let doc = parameter.doc_of(&field);
            keys[place] = key(preset.section, &field, doc, parameter.shape);
            place += 1;
        }
        row += 1;
    }
    keys
}

/// The parameters of another table. The key of a choice has no number and is not for use.
pub const fn of_rows<const N: usize>(section: Section, rows: &[Row; N]) -> [Key; N] {
    let mut keys = [row_key(section, &rows[0]); N];
    let mut row = 1;
    while row < N {
        keys[row] = row_key(section, &rows[row]);
        row += 1;
    }
    keys
}

const fn row_key(section: Section, row: &Row) -> Key {
    key(section, &row.field, row.field.doc, row.shape)
}

const fn key(section: Section, field: &Field, doc: &'static str, shape: Shape) -> Key {
    let unit = Unit { text: field.key_unit, si: field.key_si, si_text: field.unit };
    let (range, place) = (Some(field.range), Place::Row(field.path));
    let target = Target::Numbers { field: field.path, unit, shape, range, place };
    Key { section, name: field.key, doc, target }
}
