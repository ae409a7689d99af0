//! The error equations in Earth-fixed axes.

use nalgebra::{Matrix3, Vector3};

use super::geometry::LocalGeometry;
use super::runge_kutta::LinearEquations;
use super::{SensorErrors, StartErrors};
use crate::earth::Earth;
use crate::math::VectorPair;
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

/// What drives the equations at an instant: Earth rate [rad/s], gravity gradient in the middle of the interval [1/s²],
/// specific force [m/s²], gyro [rad/s] and accelerometer error [m/s²].
pub(super) struct Coefficients {
    earth_rate: f64,
    gradient: Matrix3<f64>,
    f_e: Vector3<f64>,
    gyro_e: Vector3<f64>,
    accel_e: Vector3<f64>,
}

impl Coefficients {
    fn at(earth_rate: f64, gradient: Matrix3<f64>, node: &MotionNode, errors_e: &VectorPair) -> Self {
        Self { earth_rate, gradient, f_e: node.f_e, gyro_e: errors_e.first(), accel_e: errors_e.second() }
    }
}

impl EarthFixedForm {
    pub fn new(local: &LocalGeometry, v_e: &Vector3<f64>, start: &StartErrors) -> Self {
        let axes = local.rotation_of_axes(&start.position_n);
        let v_n = local.in_local_axes(v_e);
        Self {
            psi: local.in_earth_axes(&(start.misalignment_n - axes)),
            dv: local.in_earth_axes(&(start.velocity_n + axes.cross(&v_n))),
            dr: local.in_earth_axes(&start.position_n),
        }
    }

    pub fn advance(&mut self, earth: &Earth, motion: &IntervalMotion<'_>, errors: &SensorErrors) {
        let nodes = motion.nodes();
        let gradient = earth.gravity_gradient(&nodes[1].r_e);
        let errors_e = motion.to_earth_axes(&errors.nodes());
        let at = |i: usize| Coefficients::at(earth.rate_rad_s, gradient, &nodes[i], &errors_e[i]);
        let coefficients = [at(0), at(1), at(2)];
        *self = self.after(&coefficients, motion.interval_s);
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
        let position_n = local.in_local_axes(&self.dr);
        let axes = local.rotation_of_axes(&position_n);
        let v_n = local.in_local_axes(v_e);
        StartErrors {
            position_n,
            velocity_n: local.in_local_axes(&self.dv) - axes.cross(&v_n),
            misalignment_n: local.in_local_axes(&self.psi) + axes,
        }
    }
}

impl LinearEquations for EarthFixedForm {
    type Coefficients = Coefficients;

    #[inline]
    fn rate(&self, at: &Coefficients) -> Self {
        let w = at.earth_rate;
        Self {
            psi: Vector3::new(w * self.psi.y, -w * self.psi.x, 0.0) - at.gyro_e,
            dv: at.f_e.cross(&self.psi)
                + at.accel_e
                + Vector3::new(2.0 * w * self.dv.y, -2.0 * w * self.dv.x, 0.0)
                + at.gradient * self.dr,
            dr: self.dv,
        }
    }

    #[inline]
    fn plus(&self, rate: &Self, t: f64) -> Self {
        Self { psi: self.psi + rate.psi * t, dv: self.dv + rate.dv * t, dr: self.dr + rate.dr * t }
    }
}
