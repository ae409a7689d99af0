//! The sensor block at the start of a flight.

use nalgebra::Vector3;

use super::Options;
use crate::earth::Earth;
use crate::math::{relative_rotation, rotate_inverse, rotation_vector};
use crate::mounting::{Block, MountingParameters};
use crate::truth::{Recent, TruthPoint};

/// The block at `first`. Its rate is the host's. Without one it is the mean of the first interval, if the interval is known, as in
/// the generator. Otherwise it is the Earth's rate.
pub(super) fn block_at_start(
    parameters: &MountingParameters,
    options: &Options,
    earth: &Earth,
    first: &TruthPoint,
    interval: Option<&Recent<'_>>,
) -> Block {
    Block::new(parameters, options.axes, earth.rate_rad_s, rate_at_start(earth, first, interval))
}

/// Angular rate of the vehicle at `first` relative to inertial space, body axes [rad/s].
pub(super) fn rate_at_start(
    earth: &Earth,
    first: &TruthPoint,
    interval: Option<&Recent<'_>>,
) -> Vector3<f64> {
    let against_earth = interval.map_or(Vector3::zeros(), |recent| {
        let turn = relative_rotation(&first.state.q_eb, &recent.next.state.q_eb);
        rotation_vector(&turn) / recent.next.interval_s
    });
    let earth_rate_b = rotate_inverse(&first.state.q_eb, &Vector3::new(0.0, 0.0, earth.rate_rad_s));
    first.omega_ib_b().unwrap_or(against_earth + earth_rate_b)
}
