//! Names of what is wrong with a record.

use crate::base::error::Error;

/// What the library says of a record or of a check: the field of the host's struct, and the axis.
const FIELDS: [(&str, &str, Option<usize>); 16] = [
    ("record.count", "increments", None),
    ("record.time_s", "increments.time_s", None),
    ("record.interval_s", "increments.interval_s", None),
    ("record.angle", "increments.angle_rad", None),
    ("record.angle.x", "increments.angle_rad", Some(0)),
    ("record.angle.y", "increments.angle_rad", Some(1)),
    ("record.angle.z", "increments.angle_rad", Some(2)),
    ("record.velocity", "increments.velocity_m_s", None),
    ("record.velocity.x", "increments.velocity_m_s", Some(0)),
    ("record.velocity.y", "increments.velocity_m_s", Some(1)),
    ("record.velocity.z", "increments.velocity_m_s", Some(2)),
    ("check.twins", "request.twins", None),
    ("truth.position_m", "request.position_m", None),
    ("truth.velocity_m_s", "request.velocity_m_s", None),
    ("truth.tilt_rad", "request.tilt_rad", None),
    ("truth.heading_rad", "request.heading_rad", None),
];

/// An error about a record or a check, about the field of the host's struct. What is no field, as the motion, keeps its name.
pub(super) fn in_fields(error: Error) -> Error {
    match FIELDS.iter().find(|(own, ..)| *own == error.field) {
        Some((_, field, axis)) => Error { field, index: axis.or(error.index), ..error },
        None => error,
    }
}
