//! What perfect accelerometers feel of gravity beyond the normal one.

use nalgebra::Vector3;

use crate::mounting::Block;
use crate::signal::{Increment, IntervalMotion};

/// Gauss-Legendre nodes on 0..1: with two in each increment its error is θ⁴/4320 of it, at a rotation θ [rad].
const NODES: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// Adds -∫ Cᵀ δg dt to the velocity of each of `increments` over the interval of `motion`: δg is `disturbance_e` [m/s²] at the
/// start and at the end, Earth-fixed axes, and changes evenly. The increments are those of `block`, where there is a mounting.
#[inline(never)]
pub(super) fn feel_gravity(
    motion: &IntervalMotion<'_>,
    [start_e, end_e]: &[Vector3<f64>; 2],
    block: Option<&Block>,
    increments: &mut [Increment],
) {
    let part = 1.0 / increments.len() as f64;
    let half_dt = 0.5 * motion.interval_s * part;
    for (m, increment) in increments.iter_mut().enumerate() {
        let felt_b = NODES.iter().fold(Vector3::zeros(), |sum, node| {
            let u = (m as f64 + node) * part;
            sum - motion.to_earth(u).tr_mul(&(start_e + (end_e - start_e) * u)) * half_dt
        });
        increment.velocity += block.map_or(felt_b, |block| block.in_block_axes(&felt_b));
    }
}
