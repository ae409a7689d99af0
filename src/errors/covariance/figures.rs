//! Figures of a covariance: 1 sigma, error ellipse, CEP50 and R95.

use core::f64::consts::PI;

use nalgebra::SMatrix;

use crate::base::math::{atan2, exp, sin_cos};

/// Covariance of the errors of position [m], velocity [m/s] and misalignment [rad], each east-north-up.
pub type Matrix9 = SMatrix<f64, 9, 9>;

/// Covariance of the navigation errors, computed less true.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NavigationCovariance {
    /// Covariance of position [m], velocity [m/s], misalignment φ [rad], each east, north, up, as in
    /// [`NavigationErrors`](crate::errors::NavigationErrors).
    pub matrix: Matrix9,
    /// Error ellipse of the horizontal position.
    pub ellipse: ErrorEllipse,
    /// Whether a standard deviation, or an error of this run, is so large that the terms neglected by the linear equations matter, or the
    /// mean of what random drop-outs lose has been so since the start.
    pub outside_validity: bool,
    /// Whether the host has corrected the INS since the start: the covariance leaves the corrections out.
    pub without_corrections: bool,
}

/// The error ellipse of one standard deviation of the horizontal position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorEllipse {
    /// Semi-axes [m].
    pub major_m: f64,
    /// See `major_m`.
    pub minor_m: f64,
    /// Azimuth of the major axis, from north to the east, 0 up to π [rad].
    pub azimuth_rad: f64,
}

impl NavigationCovariance {
    /// Standard deviations of the nine errors.
    pub fn sigma(&self) -> [f64; 9] {
        core::array::from_fn(|k| self.matrix[(k, k)].sqrt())
    }
}

impl ErrorEllipse {
    /// The ellipse of the variances east and north and their covariance [m²].
    pub fn new(east: f64, north: f64, both: f64) -> Self {
        let mean = 0.5 * (east + north);
        let half_difference = 0.5 * (north - east);
        let radius = (half_difference * half_difference + both * both).sqrt();
        let major = mean + radius;
        // By the determinant, because the difference of two large numbers loses a small result.
        let minor = if major > 0.0 { ((east * north - both * both) / major).max(0.0) } else { 0.0 };
        let azimuth = 0.5 * atan2(both, half_difference);
        Self {
            major_m: major.sqrt(),
            minor_m: minor.sqrt(),
            azimuth_rad: if azimuth < 0.0 { azimuth + PI } else { azimuth },
        }
    }

    /// Radius of the circle about the truth in which the position lies with the probability 0.5 [m].
    pub fn cep50_m(&self) -> f64 {
        self.radius_m(0.5, (CIRCLE_50, LINE_50))
    }

    /// Radius of the circle about the truth in which the position lies with the probability 0.95 [m].
    pub fn radial_95_m(&self) -> f64 {
        self.radius_m(0.95, (CIRCLE_95, LINE_95))
    }

    /// The radius of the probability `wanted`. The two further radii are those of a circle and of a line of semi-axis 1. It is computed
    /// from the integral of the normal density over the circle,
    /// ```text
    /// P(R) = 1 - 1/2π ∫ exp(-R²/(2 (σ1² cos²θ + σ2² sin²θ))) dθ
    /// ```
    /// in polar coordinates in which the ellipse is a circle. The integrand is smooth and periodic, so a sum of equal steps is exact to
    /// rounding.
    fn radius_m(&self, wanted: f64, (circle, line): (f64, f64)) -> f64 {
        if self.major_m == 0.0 {
            return 0.0;
        }
        let ratio2 = (self.minor_m / self.major_m) * (self.minor_m / self.major_m);
        let spread = |step: usize| {
            let (sin, cos) = sin_cos((step as f64 + 0.5) * (0.5 * PI / STEPS as f64));
            cos * cos + ratio2 * sin * sin
        };
        let (mut low, mut high) = (line, circle);
        let mut radius = line + (circle - line) * ratio2;
        for _ in 0..60 {
            let (mut outside, mut density) = (0.0, 0.0);
            for step in 0..STEPS {
                let spread = spread(step);
                let share = exp(-0.5 * radius * radius / spread) / STEPS as f64;
                outside += share;
                density += share * radius / spread;
            }
            let missing = wanted - (1.0 - outside);
            if missing > 0.0 {
                low = radius
            } else {
                high = radius
            }
            // Newton's step, or the middle of the bracket if the step leaves it.
            let newton = radius + missing / density;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - radius).abs() < 1e-14 * radius || missing == 0.0 {
                break;
            }
            radius = next;
        }
        radius * self.major_m
    }
}

/// Number of steps in a quarter turn.
const STEPS: usize = 32;

/// √(2 ln 2) and √(2 ln 20), of Rayleigh's distribution; 50 % and 95 % of the normal one.
const CIRCLE_50: f64 = 1.177_410_022_515_474_7;
const CIRCLE_95: f64 = 2.447_746_830_680_816;
const LINE_50: f64 = 0.674_489_750_196_081_7;
const LINE_95: f64 = 1.959_963_984_540_054;
