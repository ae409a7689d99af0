//! The error equations in geographic axes: the paper's (4)-(6) with their misprints corrected.

use nalgebra::Vector3;

use super::ERRORS;
use super::geometry::LocalGeometry;
use crate::base::math::VectorPair;
use crate::base::snapshot::stored;
use crate::earth::Earth;
use crate::earth::state::StateErrors;
use crate::mechanization::VerticalCorrection;
use crate::signal::MotionNode;
use crate::truth::TruthPoint;

/// φ [rad], δv [m/s], (δL [rad], δλ [rad], δh [m]).
///
/// Departure: against the paper, eps enters (4) with a minus sign, the gravity gradient enters the vertical row of (5), each
/// term has the radius of its own direction, and the radii's change with latitude is kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GeographicForm {
    pub(super) phi: Vector3<f64>,
    pub(super) dv: Vector3<f64>,
    pub(super) d_place: Vector3<f64>,
}

stored!(GeographicForm { phi: ERRORS, dv: ERRORS, d_place: ERRORS });

/// Coefficients of the error equations at an instant.
pub(super) struct Coefficients {
    local: LocalGeometry,
    /// Tangent and secant of latitude.
    tan: f64,
    sec: f64,
    /// Velocity, specific force, gyro and accelerometer error, east-north-up.
    v: Vector3<f64>,
    f: Vector3<f64>,
    eps: Vector3<f64>,
    nabla: Vector3<f64>,
    /// Earth rate W cos L, W sin L and rate of the axes w_in [rad/s].
    rate_north: f64,
    rate_up: f64,
    omega_in: Vector3<f64>,
    /// dRM/dL, dRN/dL [m/rad]
    dm: f64,
    dn: f64,
    /// Derivatives of gravity's north and up components with height [1/s²] and with latitude [m/s²/rad].
    north_h: f64,
    up_h: f64,
    north_l: f64,
    up_l: f64,
}

impl Coefficients {
    fn at(earth: &Earth, node: &MotionNode, errors_e: &VectorPair) -> Self {
        let MotionNode { r_e, v_e, f_e } = node;
        let local = LocalGeometry::new(earth, &earth.vertical(r_e));
        let (s, c) = (local.sin, local.cos);
        let (tan, sec) = (s / c, 1.0 / c);
        let v = local.in_local_axes(v_e);
        let (rate_north, rate_up) = (earth.rate_rad_s * c, earth.rate_rad_s * s);
        let omega_in =
            Vector3::new(-v.y / local.m, rate_north + v.x / local.n, rate_up + v.x * tan / local.n);
        let e2 = earth.eccentricity2;
        let w2 = 1.0 - e2 * s * s;
        let radii = earth.radii(s);
        let gradient = earth.gravity_gradient(r_e);
        let gravity = earth.gravity(r_e);
        let by_north = gradient * local.north * local.m;
        let by_up = gradient * local.up;
        Self {
            tan,
            sec,
            v,
            f: local.in_local_axes(f_e),
            eps: local.in_local_axes(&errors_e.first()),
            nabla: local.in_local_axes(&errors_e.second()),
            rate_north,
            rate_up,
            omega_in,
            dm: 3.0 * radii.meridian_m * e2 * s * c / w2,
            dn: radii.transverse_m * e2 * s * c / w2,
            north_h: local.north.dot(&by_up),
            up_h: local.up.dot(&by_up),
            // The north and up axes turn with latitude.
            north_l: local.north.dot(&by_north) - local.up.dot(&gravity),
            up_l: local.up.dot(&by_north) + local.north.dot(&gravity),
            local,
        }
    }
}

impl GeographicForm {
    pub fn new(local: &LocalGeometry, start: &StateErrors) -> Self {
        Self {
            phi: start.misalignment_n,
            dv: start.velocity_n,
            d_place: local.change_of_place(&start.position_n),
        }
    }

    /// Advances by `t` [s], with the gyros' and the accelerometers' errors `errors_e` in Earth-fixed axes.
    pub fn advance(&mut self, earth: &Earth, t: f64, nodes: &[MotionNode; 3], errors_e: &[VectorPair; 3]) {
        let at = |i: usize| Coefficients::at(earth, &nodes[i], &errors_e[i]);
        let coefficients = [at(0), at(1), at(2)];
        *self = self.after(&coefficients, t);
    }

    /// φ, δv, (δL, δλ, δh).
    pub fn state(&mut self) -> [&mut Vector3<f64>; 3] {
        [&mut self.phi, &mut self.dv, &mut self.d_place]
    }

    /// Error of the height [m].
    pub fn height_error(&self, _: &TruthPoint) -> f64 {
        self.d_place.z
    }

    /// Error of the velocity up [m/s].
    pub fn velocity_up_error(&self, _: &Earth, _: &TruthPoint) -> f64 {
        self.dv.z
    }

    pub fn shift_vertical(&mut self, earth: &Earth, truth: &TruthPoint, correction: &VerticalCorrection) {
        let local = LocalGeometry::new(earth, &truth.vertical());
        let v = local.in_local_axes(&truth.state.v_e);
        let east = v.x / local.n;
        let omega = Vector3::new(
            -v.y / local.m,
            2.0 * earth.rate_rad_s * local.cos + east,
            2.0 * earth.rate_rad_s * local.sin + east * local.sin / local.cos,
        );
        self.d_place.z += correction.height_m;
        self.dv.z += correction.velocity_up_m_s;
        self.dv -= omega.cross(&Vector3::new(0.0, 0.0, correction.displacement_m));
    }

    /// Errors in local terms.
    pub fn errors(&self, local: &LocalGeometry, _: &Vector3<f64>) -> StateErrors {
        let position_n =
            Vector3::new(self.d_place.y * local.n * local.cos, self.d_place.x * local.m, self.d_place.z);
        StateErrors { position_n, velocity_n: self.dv, misalignment_n: self.phi }
    }
}

/// The linear equations x' = A(u) x + b(u) over an interval, u = 0..1; the coefficients are A and b at an instant.
impl GeographicForm {
    /// x after a step of length `t` [s] by the classical fourth-order Runge-Kutta method, from the coefficients at its start,
    /// middle and end.
    #[inline]
    fn after(&self, [start, middle, end]: &[Coefficients; 3], t: f64) -> Self {
        let k1 = self.rate(start);
        let k2 = self.plus(&k1, 0.5 * t).rate(middle);
        let k3 = self.plus(&k2, 0.5 * t).rate(middle);
        let k4 = self.plus(&k3, t).rate(end);
        let k = k1.plus(&k2.plus(&k3, 1.0), 2.0).plus(&k4, 1.0);
        self.plus(&k, t / 6.0)
    }

    /// x': the system matrix, row by row.
    fn rate(&self, k: &Coefficients) -> Self {
        let Coefficients { tan: t, sec, dm, dn, rate_north: wn, rate_up: wu, .. } = *k;
        let (m, n) = (k.local.m, k.local.n);
        let (m2, n2) = (m * m, n * n);
        let (ve, vn, vu) = (k.v.x, k.v.y, k.v.z);
        let (fe, fn_, fu) = (k.f.x, k.f.y, k.f.z);
        let w = &k.omega_in;
        let (pe, pn, pu) = (self.phi.x, self.phi.y, self.phi.z);
        let (dve, dvn, dvu) = (self.dv.x, self.dv.y, self.dv.z);
        let (dl, dh) = (self.d_place.x, self.d_place.z);
        let sec2 = sec * sec;
        Self {
            phi: Vector3::new(
                w.z * pn - w.y * pu - dvn / m + vn / m2 * (dh + dm * dl),
                -w.z * pe + w.x * pu + dve / n - ve / n2 * dh + (-wu - ve * dn / n2) * dl,
                w.y * pe - w.x * pn + t * dve / n - ve * t / n2 * dh
                    + (wn + ve * sec2 / n - ve * t * dn / n2) * dl,
            ) - k.eps,
            dv: Vector3::new(
                -fu * pn + fn_ * pu + (vn * t - vu) / n * dve + (2.0 * wu + ve * t / n) * dvn
                    - (2.0 * wn + ve / n) * dvu
                    + (ve * vu - ve * vn * t) / n2 * (dh + dn * dl)
                    + (2.0 * wn * vn + ve * vn * sec2 / n + 2.0 * wu * vu) * dl,
                fu * pe - fe * pu - 2.0 * (wu + ve * t / n) * dve - vu / m * dvn - vn / m * dvu
                    + (ve * ve * t / n2 + vn * vu / m2 + k.north_h) * dh
                    + (-(2.0 * wn + ve * sec2 / n) * ve
                        + ve * ve * t * dn / n2
                        + vn * vu * dm / m2
                        + k.north_l)
                        * dl,
                -fn_ * pe
                    + fe * pn
                    + 2.0 * (wn + ve / n) * dve
                    + 2.0 * vn / m * dvn
                    + (-(vn * vn / m2 + ve * ve / n2) + k.up_h) * dh
                    + (-2.0 * wu * ve - (vn * vn * dm / m2 + ve * ve * dn / n2) + k.up_l) * dl,
            ) + k.nabla,
            d_place: Vector3::new(
                dvn / m - vn / m2 * (dh + dm * dl),
                sec / n * dve - ve * sec / n2 * dh + (ve * sec * t / n - ve * sec * dn / n2) * dl,
                dvu,
            ),
        }
    }

    /// x + `rate` `t`
    fn plus(&self, rate: &Self, t: f64) -> Self {
        Self {
            phi: self.phi + rate.phi * t,
            dv: self.dv + rate.dv * t,
            d_place: self.d_place + rate.d_place * t,
        }
    }
}
