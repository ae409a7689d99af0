//! The error equations in Earth-fixed axes.

use nalgebra::{Matrix3, Vector3};

use super::ERRORS;
use super::geometry::LocalGeometry;
use crate::base::math::VectorPair;
use crate::base::snapshot::stored;
use crate::earth::Earth;
use crate::earth::state::StateErrors;
use crate::mechanization::{VerticalCorrection, displaced_vertical};
use crate::signal::MotionNode;
use crate::truth::TruthPoint;

/// ψ' = -W×ψ - C eps, δv' = f×ψ + C nabla - 2 W×δv + G δr, δr' = δv, with computed C_eb = (I - [ψ×]) C_eb, G the gravity
/// gradient with the centrifugal part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct EarthFixedForm {
    /// ψ [rad], δv [m/s], δr [m], Earth-fixed axes.
    pub(super) psi: Vector3<f64>,
    pub(super) dv: Vector3<f64>,
    pub(super) dr: Vector3<f64>,
}

stored!(EarthFixedForm { psi: ERRORS, dv: ERRORS, dr: ERRORS });

/// Data of the truth that a step needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coefficients<'a> {
    /// Length [s].
    pub t: f64,
    /// Earth rate [rad/s].
    pub w: f64,
    /// Gradient of gravity in the middle [1/s²].
    pub gradient: Matrix3<f64>,
    /// Motion at the start, in the middle and at the end.
    pub nodes: &'a [MotionNode; 3],
}

impl<'a> Coefficients<'a> {
    #[inline(always)]
    pub fn new(earth: &Earth, t: f64, nodes: &'a [MotionNode; 3]) -> Self {
        let gradient = earth.gravity_gradient(&nodes[1].r_e);
        Self { t, w: earth.rate_rad_s, gradient, nodes }
    }
}

impl EarthFixedForm {
    pub fn new(local: &LocalGeometry, v_e: &Vector3<f64>, start: &StateErrors) -> Self {
        let axes = local.rotation_of_axes(&start.position_n);
        let v_n = local.in_local_axes(v_e);
        Self {
            psi: local.in_earth_axes(&(start.misalignment_n - axes)),
            dv: local.in_earth_axes(&(start.velocity_n + axes.cross(&v_n))),
            dr: local.in_earth_axes(&start.position_n),
        }
    }

    /// Advances by a step of length `t` [s], with the gyros' and the accelerometers' errors `errors_e` in Earth-fixed axes.
    pub fn advance(&mut self, earth: &Earth, t: f64, nodes: &[MotionNode; 3], errors_e: &[VectorPair; 3]) {
        self.advance_by(&Coefficients::new(earth, t, nodes), errors_e);
    }

    /// Advances by a step of classical Runge-Kutta. ψ does not depend on δv and δr. For δv and δr the system matrix B does not
    /// change within the interval, so that with the forcing c = f×ψ + C nabla of each stage the step is
    /// y + T (B y + (c1 + 2 c2 + 2 c3 + c4)/6 + T/6 B (k1 + k2 + k3)).
    #[inline(always)]
    pub fn advance_by(&mut self, coefficients: &Coefficients<'_>, errors_e: &[VectorPair; 3]) {
        let &Coefficients { t, w, gradient, nodes: [start, middle, end] } = coefficients;
        let half = 0.5 * t;
        let [e0, e1, e2] = errors_e;
        let (gyro, accel) = ([e0.first(), e1.first(), e2.first()], [e0.second(), e1.second(), e2.second()]);

        let drift = |psi: &Vector3<f64>, i: usize| Vector3::new(w * psi.y, -w * psi.x, 0.0) - gyro[i];
        let p1 = drift(&self.psi, 0);
        let psi2 = self.psi + p1 * half;
        let p2 = drift(&psi2, 1);
        let psi3 = self.psi + p2 * half;
        let p3 = drift(&psi3, 1);
        let psi4 = self.psi + p3 * t;
        let p4 = drift(&psi4, 2);
        let c1 = start.f_e.cross(&self.psi) + accel[0];
        let c2 = middle.f_e.cross(&psi2) + accel[1];
        let c3 = middle.f_e.cross(&psi3) + accel[1];
        let c4 = end.f_e.cross(&psi4) + accel[2];

        // The rows of δv'. The rows of δr' are δv.
        let row_v = |dv: &Vector3<f64>, dr: &Vector3<f64>| {
            gradient * dr + Vector3::new(2.0 * w * dv.y, -2.0 * w * dv.x, 0.0)
        };
        let (dv, dr) = (self.dv, self.dr);
        let free = row_v(&dv, &dr);
        let k1 = free + c1;
        let k2 = free + c2 + row_v(&k1, &dv) * half;
        let r2 = dv + k1 * half;
        let k3 = free + c3 + row_v(&k2, &r2) * half;
        let r3 = dv + k2 * half;
        let k = k1 + k2 + k3;
        let sixth = t * (1.0 / 6.0);
        self.psi += (p1 + 2.0 * (p2 + p3) + p4) * sixth;
        self.dv += free * t + (c1 + 2.0 * (c2 + c3) + c4 + row_v(&k, &(dv + r2 + r3)) * t) * sixth;
        self.dr += dv * t + k * (t * sixth);
    }

    /// ψ, δv, δr.
    #[inline(always)]
    pub fn state(&mut self) -> [&mut Vector3<f64>; 3] {
        [&mut self.psi, &mut self.dv, &mut self.dr]
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

    /// Errors in local terms: φ = ψ + dth, δv_n = δv - dth×v.
    #[inline(always)]
    pub fn errors(&self, local: &LocalGeometry, v_e: &Vector3<f64>) -> StateErrors {
        let [position_n, dv_n] = local.two_in_local_axes(&self.dr, &self.dv);
        let [psi_n, v_n] = local.two_in_local_axes(&self.psi, v_e);
        let axes = local.rotation_of_axes(&position_n);
        StateErrors { position_n, velocity_n: dv_n - axes.cross(&v_n), misalignment_n: psi_n + axes }
    }
}
