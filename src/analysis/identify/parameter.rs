//! The parameters that a record may show.

use nalgebra::{Matrix3, Vector3};

use super::noise::{COEFFICIENTS, Coefficients};
use super::solve::{Matrix, Vector};

/// Number of parameters: three angles of the mounting, shift and drift of the clock, three biases and nine elements of each triad; then
/// those of [`super::Also`]: three of the lever arm, nine g-sensitivities, and of each triad three asymmetries and three changes of the
/// biases with temperature.
pub const PARAMETERS: usize = 53;

/// Places of the parameters in a solution.
pub(super) struct Place;

impl Place {
    pub const CLOCK: usize = 3;
    pub const DRIFT: usize = 4;

    pub const fn mounting(axis: usize) -> usize {
        axis
    }

    /// Bias of a gyro, part 0, or of an accelerometer, part 1.
    pub const fn bias(part: usize, axis: usize) -> usize {
        5 + 12 * part + axis
    }

    /// Element of the error matrix: scale factor errors on the diagonal, misalignments beside it.
    pub const fn element(part: usize, row: usize, column: usize) -> usize {
        8 + 12 * part + 3 * row + column
    }

    pub const fn lever_arm(axis: usize) -> usize {
        29 + axis
    }

    /// Of gyro `row` to the force along an axis.
    pub const fn g_sensitivity(row: usize, column: usize) -> usize {
        32 + 3 * row + column
    }

    pub const fn asymmetry(part: usize, axis: usize) -> usize {
        41 + 3 * part + axis
    }

    pub const fn bias_temperature(part: usize, axis: usize) -> usize {
        47 + 3 * part + axis
    }

    /// The coefficients of a sensor in a solution.
    pub fn coefficients(sensor: usize, x: &Vector) -> [f64; COEFFICIENTS] {
        let (part, axis) = (sensor / 3, sensor % 3);
        let by_axes: Coefficients = super::rows::coefficients(part, axis) * x;
        core::array::from_fn(|k| by_axes[k])
    }
}

/// Sign of element (row, column) of \[φ×\], whose size is φ of the third axis.
pub(super) fn turning_sign(row: usize, column: usize) -> f64 {
    if (row + 1) % 3 == column { -1.0 } else { 1.0 }
}

/// The change of a solution to the axes of the sensor block: the rotation c that the misalignments of both triads have in common, the mean
/// of their antisymmetric parts, is one of the mounting. No signal changes, and what remains does not hang on the priors.
/// ```text
/// c = mean of (E21 - E12)/2, (E02 - E20)/2, (E10 - E01)/2 over both triads,   φ + c,   E - [c×]
/// ```
#[inline(never)]
pub(super) fn to_block_axes() -> Matrix {
    let mut change = Matrix::identity();
    for third in 0..3 {
        let (row, column) = ((third + 1) % 3, (third + 2) % 3);
        for of in 0..2 {
            for (i, j) in [(row, column), (column, row)] {
                let share = 0.25 * turning_sign(i, j);
                change[(Place::mounting(third), Place::element(of, i, j))] += share;
                for part in 0..2 {
                    for (k, l) in [(row, column), (column, row)] {
                        change[(Place::element(part, k, l), Place::element(of, i, j))] -=
                            share * turning_sign(k, l);
                    }
                }
            }
        }
    }
    change
}

/// The rotation that the misalignments of both triads of a solution have in common.
pub(super) fn common_rotation(x: &Vector) -> Vector3<f64> {
    Vector3::from_fn(|third, _| {
        let (row, column) = ((third + 1) % 3, (third + 2) % 3);
        let ways = [(row, column), (column, row)];
        let of = |part: usize| ways.map(|(i, j)| 0.25 * turning_sign(i, j) * x[Place::element(part, i, j)]);
        of(0).iter().chain(&of(1)).sum()
    })
}

/// A parameter that was found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimate {
    /// Mean \[unit of the parameter\].
    pub value: f64,
    /// Standard deviation.
    pub sigma: f64,
    /// Standard deviation before the record.
    pub prior: f64,
}

impl Estimate {
    /// Whether the record shows the parameter: it narrows the prior to less than a half.
    pub fn is_seen(&self) -> bool {
        self.sigma < 0.5 * self.prior
    }

    /// 95 % interval.
    pub fn interval(&self) -> (f64, f64) {
        (self.value - 1.96 * self.sigma, self.value + 1.96 * self.sigma)
    }
}

/// Errors of a triad: bias \[rad/s\] or \[m/s²\]; element (i, j) of the matrix times the true signal along axis j is an error of sensor i:
/// scale factors \[1\] on the diagonal, misalignments \[rad\] beside it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TriadEstimate {
    /// Bias of each sensor.
    pub bias: [Estimate; 3],
    /// Scale factor errors and misalignments.
    pub elements: [[Estimate; 3]; 3],
    /// Scale factor of positive signals less that of negative ones \[1\], if the request asks for it; otherwise 0.
    pub asymmetry: [Estimate; 3],
    /// Change of each bias with temperature \[(rad/s)/K\] or \[(m/s²)/K\], if the request asks for it; otherwise 0.
    pub bias_temperature: [Estimate; 3],
}

impl TriadEstimate {
    /// Changes of the biases by a temperature \[K\] above that at which they hold.
    pub(super) fn warming(&self, above_k: f64) -> Vector3<f64> {
        Vector3::from_fn(|axis, _| self.bias_temperature[axis].value * above_k)
    }

    /// The biases.
    pub(super) fn biases(&self) -> Vector3<f64> {
        Vector3::from_fn(|axis, _| self.bias[axis].value)
    }

    /// The asymmetries.
    pub(super) fn asymmetries(&self) -> Vector3<f64> {
        Vector3::from_fn(|axis, _| self.asymmetry[axis].value)
    }

    /// The matrix of scale factor errors and misalignments.
    pub(super) fn error_matrix(&self) -> Matrix3<f64> {
        Matrix3::from_fn(|row, column| self.elements[row][column].value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rotation that both triads have becomes one of the mounting; what a sensor measures does not change.
    #[test]
    fn common_misalignments_are_a_rotation() {
        let mut x = Vector::from_fn(|k, _| 1e-3 * ((k * 37 % 11) as f64 - 5.0));
        let changed = to_block_axes() * x;
        for sensor in 0..6 {
            let (before, after) = (Place::coefficients(sensor, &x), Place::coefficients(sensor, &changed));
            for k in 0..COEFFICIENTS {
                assert!((before[k] - after[k]).abs() < 1e-17, "{sensor} {k}");
            }
        }
        x.fill(0.0);
        for part in 0..2 {
            for (row, column) in [(0, 1), (1, 0)] {
                x[Place::element(part, row, column)] = turning_sign(row, column);
            }
        }
        let changed = to_block_axes() * x;
        assert_eq!(changed[Place::mounting(2)], 1.0);
        assert!(changed.iter().filter(|value| value.abs() > 1e-15).count() == 1, "{changed}");
    }
}
