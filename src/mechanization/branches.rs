//! The rare branches of an update. The single navigator tests the condition at each branch; a loop over many navigators has tested
//! it before.
//!
//! Both use the same formula. With [`Usual`] the formula has no branch and no call, so the compiler can compute the runs of a loop
//! side by side.

use nalgebra::Vector3;

use super::norm::{correct_norm, lacks_much, renormalize};
use crate::earth::Earth;
use crate::math::{Compensated, RotationSeries};

/// What an update does at the rare branches.
pub(super) trait Branches: Copy {
    /// The coefficients for the squared angle `n2` [rad²].
    fn series(self, n2: f64) -> RotationSeries;
    /// Gravity at `r_e` [m].
    fn gravity(self, earth: &Earth, r_e: &Vector3<f64>) -> Vector3<f64>;
    /// Brings the norm of `q` to 1. Returns true if this is left to the caller.
    fn renormalize(self, q: &mut Compensated<4>) -> bool;
}

/// Tests the condition at each branch.
#[derive(Clone, Copy)]
pub(super) struct Any;

/// The usual case: short rotations, the normal gravity field, a norm close to 1. The caller guarantees the first two. A norm that
/// is farther from 1 is left unchanged, and reported.
#[derive(Clone, Copy)]
pub(super) struct Usual;

impl Branches for Any {
    #[inline(always)]
    fn series(self, n2: f64) -> RotationSeries {
        RotationSeries::new(n2)
    }

    #[inline(always)]
    fn gravity(self, earth: &Earth, r_e: &Vector3<f64>) -> Vector3<f64> {
        earth.gravity(r_e)
    }

    #[inline(always)]
    fn renormalize(self, q: &mut Compensated<4>) -> bool {
        renormalize(q);
        false
    }
}

impl Branches for Usual {
    #[inline(always)]
    fn series(self, n2: f64) -> RotationSeries {
        RotationSeries::short(n2)
    }

    #[inline(always)]
    fn gravity(self, earth: &Earth, r_e: &Vector3<f64>) -> Vector3<f64> {
        earth.normal_gravity(r_e)
    }

    #[inline(always)]
    fn renormalize(self, q: &mut Compensated<4>) -> bool {
        let lack = 1.0 - q.value.norm_squared();
        let mut corrected = *q;
        correct_norm(&mut corrected, lack);
        let is_left = lacks_much(lack);
        *q = if is_left { *q } else { corrected };
        is_left
    }
}
