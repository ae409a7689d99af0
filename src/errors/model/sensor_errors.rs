//! Sensor errors that drive the error model.

use nalgebra::Vector3;

use crate::base::math::{Pair, VectorPair};
use crate::signal::Increment;
use crate::signal::mounting::Block;

/// Errors of gyros [rad/s] and accelerometers [m/s²] over an interval, measured less ideal, sensor axes: a straight line in
/// u = 0..1, with the mean and the first moment of the errors that the mechanization receives. The moment matters: noise of the
/// first subsample tilts the force for longer than noise of the last subsample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorErrors {
    /// Mean, gyros [rad/s].
    pub gyro_b: Vector3<f64>,
    /// Mean, accelerometers [m/s²].
    pub accel_b: Vector3<f64>,
    /// Change from the start to the end, gyros [rad/s].
    pub gyro_change_b: Vector3<f64>,
    /// Change from the start to the end, accelerometers [m/s²].
    pub accel_change_b: Vector3<f64>,
}

impl SensorErrors {
    /// No errors: all zero.
    pub const NONE: Self = Self {
        gyro_b: Vector3::new(0.0, 0.0, 0.0),
        accel_b: Vector3::new(0.0, 0.0, 0.0),
        gyro_change_b: Vector3::new(0.0, 0.0, 0.0),
        accel_change_b: Vector3::new(0.0, 0.0, 0.0),
    };

    /// Errors of the `measured` increments of an interval of length `t` [s], in parts of equal length.
    #[inline(always)] // 30 instructions less in each step
    pub fn between(ideal: &[Increment], measured: &[Increment], t: f64) -> Self {
        let errors = ideal.iter().zip(measured).map(|(ideal, measured)| measured.minus(ideal));
        Self::of_increments(errors, t)
    }

    /// Sensor errors from the errors of the increments of an interval of length `t` [s].
    #[inline(always)]
    pub fn of_increments(errors: impl ExactSizeIterator<Item = Increment>, t: f64) -> Self {
        let mut sums = ErrorSums::NONE;
        let part = 1.0 / errors.len() as f64;
        for (i, error) in errors.enumerate() {
            sums.add(&error, ErrorSums::from_middle(i, part));
        }
        sums.errors(t)
    }

    /// Sum of both sensor errors.
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            gyro_b: self.gyro_b + other.gyro_b,
            accel_b: self.accel_b + other.accel_b,
            gyro_change_b: self.gyro_change_b + other.gyro_change_b,
            accel_change_b: self.accel_change_b + other.accel_change_b,
        }
    }

    /// The errors of a mounted block, in body axes.
    pub(super) fn in_body_axes(&self, block: &Block) -> Self {
        Self {
            gyro_b: block.in_body_axes(&self.gyro_b),
            accel_b: block.in_body_axes(&self.accel_b),
            gyro_change_b: block.in_body_axes(&self.gyro_change_b),
            accel_change_b: block.in_body_axes(&self.accel_change_b),
        }
    }

    /// Gyro and accelerometer errors at the start, in the middle and at the end.
    #[inline(always)]
    pub(super) fn nodes(&self) -> [VectorPair; 3] {
        let mean = VectorPair::new(&self.gyro_b, &self.accel_b);
        let half_change = VectorPair::new(&self.gyro_change_b, &self.accel_change_b).times(Pair::both(0.5));
        [mean - half_change, mean, mean + half_change]
    }
}

/// Sum of the errors of the increments of an interval, and their first moment about the middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct ErrorSums {
    pub sum: Increment,
    pub moment: Increment,
}

impl ErrorSums {
    pub const NONE: Self = Self { sum: Increment::ZERO, moment: Increment::ZERO };

    /// Position of increment `i` in the interval, from the middle: -½ to ½. Each increment is the share `part` of the interval.
    #[inline(always)]
    pub fn from_middle(i: usize, part: f64) -> f64 {
        (i as f64 + 0.5) * part - 0.5
    }

    #[inline(always)]
    pub fn add(&mut self, error: &Increment, from_middle: f64) {
        self.sum.angle += error.angle;
        self.sum.velocity += error.velocity;
        self.moment.angle += error.angle * from_middle;
        self.moment.velocity += error.velocity * from_middle;
    }

    /// Sensor errors over an interval of length `t` [s]. The first moment of a line about the middle is a twelfth of its change.
    #[inline(always)]
    pub fn errors(&self, t: f64) -> SensorErrors {
        let rate = 1.0 / t;
        SensorErrors {
            gyro_b: self.sum.angle * rate,
            accel_b: self.sum.velocity * rate,
            gyro_change_b: self.moment.angle * (12.0 * rate),
            accel_change_b: self.moment.velocity * (12.0 * rate),
        }
    }
}
