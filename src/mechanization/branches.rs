//! The rare branches of an update: the single navigator asks at each of them, a loop over many has asked before.
//!
//! One formula serves both: with [`Usual`] it has no branch and no call left, so that the compiler can compute the runs of a loop
//! side by side.

use nalgebra::Vector3;

use super::norm::{correct_norm, lacks_much, renormalize};
use crate::earth::Earth;
use crate::math::{Compensated, RotationSeries};

/// What is done at the branches.
pub(super) trait Branches: Copy {
    /// The coefficients for the squared angle `n2` [rad²].
    fn series(self, n2: f64) -> RotationSeries;
    /// Gravity at `r_e` [m].
    fn gravity(self, earth: &Earth, r_e: &Vector3<f64>) -> Vector3<f64>;
    /// Brings the norm of `q` to 1; whether that is left to the caller.
    fn renormalize(self, q: &mut Compensated<4>) -> bool;
}

/// Asks each time.
#[derive(Clone, Copy)]
pub(super) struct Any;

/// As it is nearly always: rotations that are short, the normal field, a norm that lacks little. The first two hold for the caller's
/// word; a norm that lacks more is left as it is, and told.
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
