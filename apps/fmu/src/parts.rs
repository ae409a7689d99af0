//! The parts of the last interval: the increments on which the INS navigates.

use sins::Simulator;

use crate::values::Value;
use crate::variable::{Role, Variable};

/// Parts that the outputs hold.
pub const MAX: usize = 16;

/// Number of outputs that are reals.
pub const REALS: usize = 6 * MAX;

/// The reals: name, unit, usual size, meaning of each output.
pub fn numbers() -> impl Iterator<Item = (String, &'static str, f64, String)> {
    let of = |name: &'static str, unit: &'static str, nominal: f64, what: &'static str| {
        (1..=MAX).flat_map(move |part| {
            ["x", "y", "z"].into_iter().enumerate().map(move |(axis, letter)| {
                let doc = format!("increment of the {what} in part {part}, sensor axis {letter}");
                (format!("imu.{name}[{part},{}]", axis + 1), unit, nominal, doc)
            })
        })
    };
    of("part_angle_rad", "rad", 0.01, "angle").chain(of("part_velocity_m_s", "m/s", 0.1, "velocity"))
}

/// The counts, which are integers.
pub fn counts() -> impl Iterator<Item = Variable> {
    [
        ("imu.updates", "number of updates of the INS in the interval"),
        ("imu.parts_per_update", "number of parts in each of them"),
    ]
    .into_iter()
    .map(|(name, doc)| Variable::new(name, Role::Output, Value::Integer(0), doc))
}

/// The counts and the reals of the last interval. If it has more parts than the outputs hold, the reals are 0.
pub fn read(simulator: &Simulator) -> ([i32; 2], [f64; REALS]) {
    let mut reals = [0.0; REALS];
    let updates = || (0..).map_while(|update| simulator.measured_update(update));
    let per_update = simulator.measured_update(0).map_or(0, |(parts, _)| parts.len());
    let count = updates().count();
    if count * per_update <= MAX {
        let (angles, velocities) = reals.split_at_mut(REALS / 2);
        let places = angles.chunks_exact_mut(3).zip(velocities.chunks_exact_mut(3));
        for ((angle, velocity), part) in places.zip(updates().flat_map(|(parts, _)| parts)) {
            angle.copy_from_slice(part.angle.as_slice());
            velocity.copy_from_slice(part.velocity.as_slice());
        }
    }
    ([count as i32, per_update as i32], reals)
}
