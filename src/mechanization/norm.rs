//! The norm of an attitude's quaternion.

use crate::base::math::Compensated;

/// Largest difference of the squared norm of an attitude's quaternion from 1.
pub(super) const MAX_NORM_ERROR: f64 = 1e-12;

/// Difference of the squared norm from 1 beyond which a first-order correction is not enough.
pub(super) const SMALL_NORM_ERROR: f64 = 1e-8;

/// Brings the norm of a quaternion to 1. The correction is added at once: the quaternion of the next update can differ by any
/// rotation, and a correction along it would be none.
///
/// Evidence: rotation vectors of 1e8 rad and more, which accepted sensors can cause, have too few digits left for a quaternion of
/// norm 1; the first-order correction alone left a squared norm of 0.001.
#[inline]
pub(super) fn renormalize(q: &mut Compensated<4>) {
    let lack = 1.0 - q.value.norm_squared();
    if lacks_much(lack) {
        *q = Compensated::new(q.value / q.value.norm_squared().sqrt());
    } else {
        correct_norm(q, lack);
    }
}

/// Whether a first-order correction is not enough.
#[inline(always)]
pub(super) fn lacks_much(lack: f64) -> bool {
    lack.abs() > SMALL_NORM_ERROR
}

/// Corrects the norm to first order.
#[inline(always)]
pub(super) fn correct_norm(q: &mut Compensated<4>, lack: f64) {
    q.add(&(q.value * (0.5 * lack)));
}
