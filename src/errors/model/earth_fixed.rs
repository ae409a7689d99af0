//! The error equations in Earth-fixed axes.

use nalgebra::{Matrix3, Vector3};

use super::geometry::LocalGeometry;
use super::{SensorErrors, StartErrors};
use crate::earth::Earth;
use crate::math::rotate;
use crate::mechanization::{VerticalCorrection, displaced_vertical};
use crate::signal::{IntervalMotion, MotionNode};
use crate::truth::TruthPoint;

/// ψ' = -W×ψ - C eps, δv' = f×ψ + C nabla - 2 W×δv + G δr, δr' = δv, with computed C_eb = (I - [ψ×]) C_eb, G the gravity
/// gradient with the centrifugal part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EarthFixedForm {
    /// ψ [rad], δv [m/s], δr [m], Earth-fixed axes.
    psi: Vector3<f64>,
    dv: Vector3<f64>,
    dr: Vector3<f64>,
}

/// What drives the equations at an instant.
struct Drive {
    f_e: Vector3<f64>,
    gyro_e: Vector3<f64>,
    accel_e: Vector3<f64>,
}

impl Drive {
    fn at(node: &MotionNode, (gyro_b, accel_b): (Vector3<f64>, Vector3<f64>)) -> Self {
        let q_eb = &node.state.q_eb;
        Self { f_e: node.f_e, gyro_e: rotate(q_eb, &gyro_b), accel_e: rotate(q_eb, &accel_b) }
    }
}

impl EarthFixedForm {
    pub fn new(local: &LocalGeometry, v_e: &Vector3<f64>, start: &StartErrors) -> Self {
        let axes = local.rotation_of_axes(&start.position_n);
        let v_n = local.to_local(v_e);
        Self {
            psi: local.to_earth(&(start.misalignment_n - axes)),
            dv: local.to_earth(&(start.velocity_n + axes.cross(&v_n))),
            dr: local.to_earth(&start.position_n),
        }
    }

    pub fn advance(&mut self, earth: &Earth, motion: &IntervalMotion<'_>, errors: &SensorErrors) {
        let t = motion.interval_s;
        let (start, middle, end) = (motion.start(), motion.middle(), motion.end());
        let gradient = earth.gravity_gradient(&middle.state.r_e);
        let w = earth.rate_rad_s;
        let d0 = Drive::at(&start, errors.at(0.0));
        let d1 = Drive::at(&middle, errors.at(0.5));
        let d2 = Drive::at(&end, errors.at(1.0));
        let k1 = self.rate(w, &gradient, &d0);
        let k2 = self.plus(&k1, 0.5 * t).rate(w, &gradient, &d1);
        let k3 = self.plus(&k2, 0.5 * t).rate(w, &gradient, &d1);
        let k4 = self.plus(&k3, t).rate(w, &gradient, &d2);
        let k = k1.plus(&k2.plus(&k3, 1.0), 2.0).plus(&k4, 1.0);
        *self = self.plus(&k, t / 6.0);
    }

    #[inline]
    fn rate(&self, w: f64, gradient: &Matrix3<f64>, drive: &Drive) -> Self {
        Self {
            psi: Vector3::new(w * self.psi.y, -w * self.psi.x, 0.0) - drive.gyro_e,
            dv: drive.f_e.cross(&self.psi)
                + drive.accel_e
                + Vector3::new(2.0 * w * self.dv.y, -2.0 * w * self.dv.x, 0.0)
                + gradient * self.dr,
            dr: self.dv,
        }
    }

    #[inline]
    fn plus(&self, rate: &Self, t: f64) -> Self {
        Self { psi: self.psi + rate.psi * t, dv: self.dv + rate.dv * t, dr: self.dr + rate.dr * t }
    }

    /// Error of the height [m].
    pub fn height_error(&self, truth: &TruthPoint) -> f64 {
        truth.up_e.dot(&self.dr)
    }

    /// Error of the velocity up [m/s]: the computed up leans with δr.
    pub fn velocity_up_error(&self, earth: &Earth, truth: &TruthPoint) -> f64 {
        let lean = earth.curvature(&truth.vertical()) * self.dr;
        truth.up_e.dot(&self.dv) + lean.dot(&truth.state.v_e)
    }

    pub fn shift_vertical(&mut self, earth: &Earth, truth: &TruthPoint, correction: &VerticalCorrection) {
        let up = &truth.up_e;
        self.dr += up * correction.height_m;
        self.dv += up * correction.velocity_up_m_s;
        if correction.displacement_m != 0.0 {
            self.dv -= displaced_vertical(earth, up, &truth.state.v_e, correction.displacement_m);
        }
    }

    /// In local terms: φ = ψ + dth, δv_n = δv - dth×v.
    pub fn errors(&self, local: &LocalGeometry, v_e: &Vector3<f64>) -> StartErrors {
        let position_n = local.to_local(&self.dr);
        let axes = local.rotation_of_axes(&position_n);
        let v_n = local.to_local(v_e);
        StartErrors {
            position_n,
            velocity_n: local.to_local(&self.dv) - axes.cross(&v_n),
            misalignment_n: local.to_local(&self.psi) + axes,
        }
    }
}
