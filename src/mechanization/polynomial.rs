//! The polynomial body-frame part: angular rate and specific force as the polynomials through the increments, attitude by
//! the sixth-order Magnus expansion, velocity integrals by quadrature.

use nalgebra::Vector3;

use super::body::{BodyMotion, FIRST_MOMENT, MAX_SUBSAMPLES, SECOND_MOMENT};
use crate::base::math::{GAUSS_4, RotationSeries};
use crate::signal::Increment;

/// The polynomial of u = 0..1 over the update whose integrals over n equal parts are the increments. Row k has the weights of the
/// increments in the coefficient of u^k.
const COEFFICIENTS: [&[&[f64]]; MAX_SUBSAMPLES] = [
    &[&[1.0]],
    &[&[3.0, -1.0], &[-4.0, 4.0]],
    &[&[11.0 / 2.0, -7.0 / 2.0, 1.0], &[-18.0, 27.0, -9.0], &[27.0 / 2.0, -27.0, 27.0 / 2.0]],
    &[
        &[25.0 / 3.0, -23.0 / 3.0, 13.0 / 3.0, -1.0],
        &[-140.0 / 3.0, 92.0, -60.0, 44.0 / 3.0],
        &[80.0, -208.0, 176.0, -48.0],
        &[-128.0 / 3.0, 128.0, -128.0, 128.0 / 3.0],
    ],
    &[
        &[137.0 / 12.0, -163.0 / 12.0, 137.0 / 12.0, -21.0 / 4.0, 1.0],
        &[-375.0 / 4.0, 2725.0 / 12.0, -875.0 / 4.0, 425.0 / 4.0, -125.0 / 6.0],
        &[2125.0 / 8.0, -3375.0 / 4.0, 1000.0, -2125.0 / 4.0, 875.0 / 8.0],
        &[-625.0 / 2.0, 6875.0 / 6.0, -3125.0 / 2.0, 1875.0 / 2.0, -625.0 / 3.0],
        &[3125.0 / 24.0, -3125.0 / 6.0, 3125.0 / 4.0, -3125.0 / 6.0, 3125.0 / 24.0],
    ],
];

/// A polynomial of u = 0..1 with vector coefficients.
struct Polynomial {
    coefficients: [Vector3<f64>; MAX_SUBSAMPLES],
    /// Number of coefficients.
    count: usize,
}

impl Polynomial {
    /// The polynomial whose integrals over equal parts of 0..1 are `parts`.
    fn through(parts: impl ExactSizeIterator<Item = Vector3<f64>> + Clone) -> Self {
        let mut coefficients = [Vector3::zeros(); MAX_SUBSAMPLES];
        let count = parts.len();
        for (coefficient, row) in coefficients.iter_mut().zip(COEFFICIENTS[count - 1]) {
            *coefficient = parts.clone().zip(*row).fold(Vector3::zeros(), |sum, (part, &k)| sum + part * k);
        }
        Self { coefficients, count }
    }

    #[inline]
    fn at(&self, u: f64) -> Vector3<f64> {
        self.coefficients[..self.count].iter().rev().fold(Vector3::zeros(), |sum, c| sum * u + c)
    }

    /// Integral from 0 to `u`.
    #[inline]
    fn integral(&self, u: f64) -> Vector3<f64> {
        let terms = self.coefficients[..self.count].iter().enumerate().rev();
        terms.fold(Vector3::zeros(), |sum, (k, c)| sum * u + c * (1.0 / (k as f64 + 1.0))) * u
    }

    /// Rotation vector [rad] of the rotation from 0 to `u`, if this polynomial is the rate and `angle` its integral: Magnus' series
    /// with three Gauss nodes (Blanes, Casas and Ros 2000).
    fn rotation(&self, u: f64, angle: &Vector3<f64>) -> Vector3<f64> {
        const SQRT_15: f64 = 3.872_983_346_207_417;
        let (middle, offset) = (0.5 * u, 0.1 * SQRT_15 * u);
        let [r1, r2, r3] = [middle - offset, middle, middle + offset].map(|u| self.at(u));
        let a1 = r2 * u;
        let a2 = (r3 - r1) * (SQRT_15 / 3.0 * u);
        let a3 = (r3 - r2 * 2.0 + r1) * (10.0 / 3.0 * u);
        let c1 = a2.cross(&a1);
        let c2 = (a3 * 2.0 + c1).cross(&a1) * (-1.0 / 60.0);
        angle + (a2 + c2).cross(&(c1 - a1 * 20.0 - a3)) * (1.0 / 240.0)
    }
}

impl BodyMotion {
    /// Rate and force as polynomials through the increments. So large rotations within an update are integrated too, which the
    /// coefficients for small coning do not cover.
    pub fn polynomial(increments: &[Increment]) -> Self {
        let n = increments.len();
        let rate = Polynomial::through(increments.iter().map(|increment| increment.angle));
        let force = Polynomial::through(increments.iter().map(|increment| increment.velocity));
        let sum = Increment::sum(increments);

        // The part without rotation is exact; the part by which the rotation turns the force is integrated by quadrature.
        let mut motion = Self {
            rotation: rate.rotation(1.0, &sum.angle),
            s1: sum.velocity,
            s2: sum.velocity * 0.5,
            s3: sum.velocity * (1.0 / 6.0),
        };
        for (i, increment) in increments.iter().enumerate() {
            motion.s2 += increment.velocity * FIRST_MOMENT[n - 1][i];
            motion.s3 += increment.velocity * SECOND_MOMENT[n - 1][i];
        }
        for (u, weight) in GAUSS_4 {
            let phi = rate.rotation(u, &rate.integral(u));
            let n2 = phi.norm_squared();
            let series = RotationSeries::new(n2);
            let cross = phi.cross(&force.at(u));
            let turned = (cross * (1.0 - n2 * series.cubic) + phi.cross(&cross) * series.square) * weight;
            motion.s1 += turned;
            motion.s2 += turned * (1.0 - u);
            motion.s3 += turned * (u * (1.0 - u));
        }
        motion
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polynomial_has_the_increments_as_its_integrals() {
        for n in 1..=MAX_SUBSAMPLES {
            let parts: Vec<Vector3<f64>> =
                (0..n).map(|i| Vector3::new(1.0 + i as f64, (i * i) as f64 - 3.0, 0.5)).collect();
            let polynomial = Polynomial::through(parts.iter().copied());
            for (i, part) in parts.iter().enumerate() {
                let ends = [i + 1, i].map(|i| polynomial.integral(i as f64 / n as f64));
                // The coefficients reach 1e4 times the increments and cancel.
                assert!((ends[0] - ends[1] - part).norm() < 1e-11, "{n} {i}");
            }
        }
    }
}
