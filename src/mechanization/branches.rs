//! The rare branches of an update, in two forms with the same formula.
//!
//! `BRANCHLESS` false, for the single navigator: the condition is tested at each branch. `BRANCHLESS` true, for a loop over many
//! navigators: no branch and no call, so that the compiler can compute the runs of the loop side by side. The loop has tested before that
//! rotations are [short](RotationSeries::is_short) and that the gravity field is normal.

use nalgebra::Vector3;

use super::norm::{correct_norm, lacks_much, renormalize};
use crate::base::math::{Compensated, RotationSeries};
use crate::earth::Earth;

/// The coefficients for the squared angle `n2` [rad²].
#[inline(always)]
pub(super) fn series<const BRANCHLESS: bool>(n2: f64) -> RotationSeries {
    if BRANCHLESS { RotationSeries::short(n2) } else { RotationSeries::new(n2) }
}

/// Gravity at `r_e` [m].
#[inline(always)]
pub(super) fn gravity<const BRANCHLESS: bool>(earth: &Earth, r_e: &Vector3<f64>) -> Vector3<f64> {
    if BRANCHLESS { earth.normal_gravity(r_e) } else { earth.gravity(r_e) }
}

/// Brings the norm of `q` to 1. If it is branchless, a norm far from 1 is left unchanged; then it returns true.
#[inline(always)]
pub(super) fn renormalized<const BRANCHLESS: bool>(q: &mut Compensated<4>) -> bool {
    if !BRANCHLESS {
        renormalize(q);
        return false;
    }
    let lack = 1.0 - q.value.norm_squared();
    let mut corrected = *q;
    correct_norm(&mut corrected, lack);
    let is_left = lacks_much(lack);
    *q = if is_left { *q } else { corrected };
    is_left
}
