//! Mean directions in the plane.

use crate::base::math::{atan2, hypot, sin_cos};

/// A sum of unit vectors in the plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Direction {
    cosine: f64,
    sine: f64,
}

impl Direction {
    pub const NONE: Self = Self { cosine: 0.0, sine: 0.0 };

    pub fn add(&mut self, angle: f64) {
        let (sine, cosine) = sin_cos(angle);
        self.cosine += cosine;
        self.sine += sine;
    }

    pub fn length(&self) -> f64 {
        hypot(self.cosine, self.sine)
    }

    pub fn angle(&self) -> Option<f64> {
        (self.length() > 0.0).then(|| atan2(self.sine, self.cosine))
    }
}
