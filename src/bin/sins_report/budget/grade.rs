//! The library's presets by name.

use sins::budget::ErrorParameters;
use sins::sensors::Grade;

use crate::failure::Failure;

const GRADES: [(&str, Grade); 6] = [
    ("strategic", Grade::Strategic),
    ("navigation", Grade::Navigation),
    ("tactical", Grade::Tactical),
    ("industrial", Grade::Industrial),
    ("consumer", Grade::Consumer),
    ("simulation2", Grade::PaperSimulation2),
];

/// The grade called `name`.
pub fn named(name: &str) -> Result<Grade, Failure> {
    GRADES.iter().find(|(known, _)| *known == name).map(|(_, grade)| *grade).ok_or_else(|| {
        let names: Vec<&str> = GRADES.iter().map(|(name, _)| *name).collect();
        Failure::new(format!("--sensors {name}: expected one of {}", names.join(", ")))
    })
}

/// What its sensors are called.
pub fn title(grade: Grade) -> String {
    let name = GRADES.iter().find(|(_, known)| *known == grade).map_or("", |(name, _)| name);
    match grade {
        Grade::PaperSimulation2 => "sensors of the paper's simulation 2".to_owned(),
        _ => format!("sensors of {name} grade"),
    }
}

/// Gyros and accelerometers of `grade`, an ideal altimeter, a start without errors.
pub fn parameters(grade: Grade) -> ErrorParameters {
    let (gyro, accel) = grade.parameters();
    ErrorParameters { gyro, accel, ..Default::default() }
}
