//! The norm of an attitude's quaternion.

use crate::math::Compensated;

/// What the squared norm of an attitude's quaternion may be off 1 by.
pub(super) const MAX_NORM_ERROR: f64 = 1e-12;

/// What the squared norm lacks to 1, beyond which the first order of the correction is not enough.
pub(super) const SMALL_NORM_ERROR: f64 = 1e-8;

/// Brings the norm of a quaternion to 1: adds what it lacks, at once, as along the quaternion of the next update, which can be
/// turned by any angle from this one, it would be no correction.
///
/// Evidence: rotation vectors of 1e8 rad and more, of accepted sensors, have lost the digits that make a quaternion of them; the
/// first order alone left a squared norm of 0.001.
#[inline]
pub(super) fn renormalize(q: &mut Compensated<4>) {
    let lack = 1.0 - q.value.norm_squared();
    if lacks_much(lack) {
        *q = Compensated::new(q.value / q.value.norm_squared().sqrt());
    } else {
        correct_norm(q, lack);
    }
}

/// Whether the first order of the correction is not enough.
#[inline(always)]
pub(super) fn lacks_much(lack: f64) -> bool {
    lack.abs() > SMALL_NORM_ERROR
}

/// Adds what the squared norm lacks, to the first order.
#[inline(always)]
pub(super) fn correct_norm(q: &mut Compensated<4>, lack: f64) {
    q.add(&(q.value * (0.5 * lack)));
}
