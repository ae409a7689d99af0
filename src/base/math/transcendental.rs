//! All transcendental functions of the crate. They use the `libm` crate, or the sine and the arc tangent of this crate, and so
//! give the same bits on every operating system, processor and word size. `f64::sin` and similar functions call the platform's
//! library and are forbidden elsewhere (`clippy.toml`).

use core::f64::consts::{PI, TAU};

use super::sine::sin_cos_each;

/// Sine and cosine of `x` [rad].
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    let ([sine], [cosine]) = sin_cos_each(&[x]);
    (sine, cosine)
}

/// Tangent of `x` [rad].
#[inline]
pub fn tan(x: f64) -> f64 {
    libm::tan(x)
}

/// Arc sine [rad].
#[inline]
pub fn asin(x: f64) -> f64 {
    libm::asin(x)
}

/// Arc tangent [rad].
#[inline]
pub fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// Angle of the point (`x`, `y`) [rad], -π to π.
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// e to the `x`.
#[inline]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// e to the `x`, less one, without cancellation near 0.
#[inline]
pub fn exp_m1(x: f64) -> f64 {
    libm::expm1(x)
}

/// Natural logarithm.
#[inline]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// Hyperbolic tangent.
#[inline]
pub fn tanh(x: f64) -> f64 {
    libm::tanh(x)
}

/// Length of (`x`, `y`), for arguments whose squares neither overflow nor underflow, such as Earth-fixed coordinates.
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// Limit below 3π: an angle below it is wrapped by at most one turn.
const BELOW_THREE_HALVES: f64 = 9.0;

/// `angle` [rad] wrapped to -π..π by an exact remainder.
#[inline]
pub fn wrap_angle(angle: f64) -> f64 {
    let size = angle.abs();
    if size <= PI {
        angle
    } else if size < BELOW_THREE_HALVES {
        // The subtraction is exact, because the two numbers differ by less than a factor of two.
        if angle < 0.0 { -(size - TAU) } else { size - TAU }
    } else {
        many_turns(angle)
    }
}

#[cold]
#[inline(never)]
fn many_turns(angle: f64) -> f64 {
    libm::remainder(angle, TAU)
}
