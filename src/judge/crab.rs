//! A heading that is off by a constant angle, told from the wind.
//!
//! The velocity against the air is along the nose: with the nose d, p to its right, the velocity v, the wind w and an error ε of the
//! heading, v·p = -tan ε v·d + w'·p, where w' is the wind turned by ε. It is linear in tan ε and w', and the wind does not turn with the
//! vehicle.

use nalgebra::{Matrix3, Vector3};

use crate::base::math::{atan, sin_cos};

/// Blocks that a judgement needs; consecutive blocks whose errors are one; deviations of the angle above which it is shown.
const LEAST: f64 = 12.0;
const CORRELATED: f64 = 5.0;
const DEVIATIONS: f64 = 8.0;

/// Sums of the normal equations.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crab {
    count: f64,
    matrix: Matrix3<f64>,
    right: Vector3<f64>,
    square: f64,
}

impl Crab {
    pub const NONE: Self = Self {
        count: 0.0,
        matrix: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        right: Vector3::new(0.0, 0.0, 0.0),
        square: 0.0,
    };

    /// Adds a velocity to the east and north [m/s] with a heading [rad].
    pub fn add(&mut self, [east, north]: [f64; 2], heading: f64) {
        let (sine, cosine) = sin_cos(heading);
        let (along, across) = (east * sine + north * cosine, east * cosine - north * sine);
        let basis = Vector3::new(along, cosine, -sine);
        self.count += 1.0;
        self.matrix += basis * basis.transpose();
        self.right += basis * across;
        self.square += across * across;
    }

    /// The error of the heading [rad], clockwise positive, if the blocks show one.
    pub fn offset(&self) -> Option<f64> {
        let inverse = self.matrix.try_inverse().filter(|_| self.count >= LEAST)?;
        let solved = inverse * self.right;
        let rest2 = (self.square - solved.dot(&self.right)).max(1e-12 * self.square);
        let sigma = (CORRELATED * inverse[(0, 0)].max(0.0) * rest2 / self.count).sqrt();
        (solved.x.abs() > DEVIATIONS * sigma).then(|| -atan(solved.x))
    }
}
