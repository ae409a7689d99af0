//! Normal gravity: the field of an ellipsoid of revolution that is its own level surface.

use nalgebra::{Matrix3, Vector3};

use super::Earth;
use crate::base::snapshot::codes;

/// Formulas of normal gravity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum GravityModel {
    /// Normal gravity in closed form at any height, with its north component.
    #[default]
    Normal, // Heiskanen and Moritz 1967, §6-2
    /// Somigliana's formula with the second-order height term, along the ellipsoid normal, as in most tools.
    Somigliana,
}

codes!(GravityModel { Normal = 0 "normal", Somigliana = 1 "somigliana" });

/// Constants of the field. E is the linear eccentricity, E² = a² e².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct NormalField {
    gm: f64,
    e2_linear: f64,
    /// W² a² b³ / Q(E²/b²), the scale of the flattened part of the field.
    quadrupole: f64,
    /// W²
    rate2: f64,
    /// Gravity on the ellipsoid, at the equator [m/s²].
    equator: f64,
    /// k of Somigliana's formula, (b gp) / (a ge) - 1.
    somigliana: f64,
    /// m = W² a² b / GM.
    m: f64,
    /// Zonal harmonics of the field, for its gradient.
    j2: f64,
    j4: f64,
}

/// q(E/u) = (E/u)³ Q(E²/u²), Q(x) = 2 Σ (-1)^(n+1) n x^(n-1) / ((2n+1)(2n+3)).
#[inline]
fn series_q(x: f64) -> f64 {
    2.0 * (1.0 / 15.0
        - x * (2.0 / 35.0
            - x * (3.0 / 63.0
                - x * (4.0 / 99.0 - x * (5.0 / 143.0 - x * (6.0 / 195.0 - x * (7.0 / 255.0)))))))
}

/// q'(E/u) = (E/u)² P(E²/u²), P(x) = 6 Σ (-1)^(n+1) x^(n-1) / ((2n+1)(2n+3)).
#[inline]
fn series_p(x: f64) -> f64 {
    6.0 * (1.0 / 15.0
        - x * (1.0 / 35.0
            - x * (1.0 / 63.0
                - x * (1.0 / 99.0 - x * (1.0 / 143.0 - x * (1.0 / 195.0 - x * (1.0 / 255.0)))))))
}

impl NormalField {
    pub(super) fn new(a: f64, e2: f64, b: f64, gm: f64, rate: f64) -> Self {
        let e2_linear = a * a * e2;
        let x0 = e2_linear / (b * b);
        let q0 = series_q(x0);
        let m = rate * rate * a * a * b / gm;
        // m e' q0'/q0 with q0 = e'^3 Q, q0' = e'^2 P; gravity on the ellipsoid, Heiskanen and Moritz (2-73), (2-74).
        let ratio = m * series_p(x0) / q0;
        let equator = gm / (a * b) * (1.0 - m - ratio / 6.0);
        let pole = gm / (a * a) * (1.0 + ratio / 3.0);
        // Heiskanen and Moritz (2-90), (2-92): e²/3 (1 - 2/15 m e'/q0), and the harmonic of degree four.
        let j2 = e2 / 3.0 * (1.0 - 2.0 / 15.0 * m / (x0 * q0));
        let j4 = -3.0 / 35.0 * e2 * e2 * (10.0 * j2 / e2 - 1.0);
        Self {
            gm,
            e2_linear,
            quadrupole: rate * rate * a * a * b * b * b / q0,
            rate2: rate * rate,
            equator,
            somigliana: b * pole / (a * equator) - 1.0,
            m,
            j2,
            j4,
        }
    }

    /// Closed form in ellipsoidal-harmonic coordinates u, β: `r_e` = (v cos β cos λ, v cos β sin λ, u sin β) with
    /// v² = u² + E². With cos β cos λ = x/v and sin β = z/u the Cartesian components are regular on
    /// the axis.
    #[inline(always)]
    fn closed_form(&self, r_e: &Vector3<f64>) -> Vector3<f64> {
        let p2 = r_e.x * r_e.x + r_e.y * r_e.y;
        let z2 = r_e.z * r_e.z;
        let d = p2 + z2 - self.e2_linear;
        let u2 = 0.5 * (d + (d * d + 4.0 * self.e2_linear * z2).sqrt());
        let u = u2.sqrt();
        let inverse_u2 = 1.0 / u2;
        let inverse_v2 = 1.0 / (u2 + self.e2_linear);
        let x = self.e2_linear * inverse_u2;
        let sin2 = z2 * inverse_u2;
        let cos2 = p2 * inverse_v2;
        // w² of the metric, w² = (u² + E² sin²β) / v².
        let w2 = (u2 + self.e2_linear * sin2) * inverse_v2;
        // γ_u = -A/w and γ_β = G sin β cos β / w, Heiskanen and Moritz (6-11).
        let a = inverse_v2
            * (self.gm + self.quadrupole * inverse_u2 * series_p(x) * (0.5 * sin2 - 1.0 / 6.0))
            - self.rate2 * u * cos2;
        let g_over_v = self.quadrupole * inverse_u2 * inverse_v2 * series_q(x) / u - self.rate2;
        let horizontal = (-a * u * inverse_v2 - g_over_v * sin2) / w2;
        let axial = (-a * u * inverse_u2 + g_over_v * cos2) / w2;
        Vector3::new(r_e.x * horizontal, r_e.y * horizontal, r_e.z * axial)
    }
}

impl Earth {
    /// Gravity (attraction and centrifugal acceleration) at the Earth-fixed position `r_e` [m], in Earth-fixed axes
    /// [m/s²]. It is the only gravity function of the simulator: signal generator and mechanization both call it.
    #[inline]
    pub fn gravity(&self, r_e: &Vector3<f64>) -> Vector3<f64> {
        match self.gravity_model {
            GravityModel::Normal => self.normal_gravity(r_e),
            GravityModel::Somigliana => {
                let vertical = self.vertical(r_e);
                -vertical.up_e * self.somigliana(vertical.up_e.z * vertical.up_e.z, vertical.height_m)
            }
        }
    }

    /// Gravity of the model [`GravityModel::Normal`].
    #[inline(always)]
    pub(crate) fn normal_gravity(&self, r_e: &Vector3<f64>) -> Vector3<f64> {
        self.field.closed_form(r_e)
    }

    /// Somigliana's gravity [m/s²] at sin²L = `sin2` and height `h` [m]:
    /// ge (1 + k sin²L) / sqrt(1 - e² sin²L) · (1 - 2/a (1 + f + m - 2 f sin²L) h + 3 h²/a²).
    fn somigliana(&self, sin2: f64, h: f64) -> f64 {
        let a = self.equatorial_radius_m;
        let f = self.flattening;
        let surface = self.field.equator * (1.0 + self.field.somigliana * sin2)
            / (1.0 - self.eccentricity2 * sin2).sqrt();
        surface * (1.0 - 2.0 / a * (1.0 + f + self.field.m - 2.0 * f * sin2) * h + 3.0 * h * h / (a * a))
    }

    /// Gradient of [`Earth::gravity`] in Earth-fixed axes [1/s²], for the error equations. The gradient of the closed form is
    /// computed by its zonal harmonics of degree two and four, with a relative error of 1e-6. The gradient of Somigliana's formula
    /// is exact.
    pub fn gravity_gradient(&self, r_e: &Vector3<f64>) -> Matrix3<f64> {
        match self.gravity_model {
            GravityModel::Normal => self.normal_gradient(r_e),
            GravityModel::Somigliana => self.somigliana_gradient(r_e),
        }
    }

    /// Gradient of [`GravityModel::Normal`]. Attraction is g_x = x F, g_y = y F, where F is a function of r² and s = z²/r². The
    /// other components follow, because the attraction has no curl and no divergence.
    fn normal_gradient(&self, r_e: &Vector3<f64>) -> Matrix3<f64> {
        let field = &self.field;
        let inverse_r2 = 1.0 / r_e.norm_squared();
        let k = field.gm * inverse_r2 * inverse_r2.sqrt();
        let s = r_e.z * r_e.z * inverse_r2;
        let scale = self.equatorial_radius_m * self.equatorial_radius_m * inverse_r2;
        let j2 = 1.5 * field.j2 * scale;
        let j4 = 0.625 * field.j4 * scale * scale;
        let f = -k * (1.0 + j2 * (1.0 - 5.0 * s) - j4 * (3.0 - s * (42.0 - 63.0 * s)));
        // r² dF/d(r²) at fixed s, and dF/ds at fixed r².
        let f_r = k * (1.5 + 2.5 * j2 * (1.0 - 5.0 * s) - 3.5 * j4 * (3.0 - s * (42.0 - 63.0 * s)));
        let f_s = k * (5.0 * j2 - j4 * (42.0 - 126.0 * s));
        // Derivatives of F with respect to p² and to z².
        let f_p2 = (f_r - s * f_s) * inverse_r2;
        let f_z2 = (f_r + (1.0 - s) * f_s) * inverse_r2;
        let p2 = r_e.x * r_e.x + r_e.y * r_e.y;
        let zz = -2.0 * f - 2.0 * p2 * f_p2;
        let (x, y, z) = (r_e.x, r_e.y, r_e.z);
        let centrifugal = field.rate2;
        let xy = 2.0 * x * y * f_p2;
        let xz = 2.0 * x * z * f_z2;
        let yz = 2.0 * y * z * f_z2;
        Matrix3::new(
            f + 2.0 * x * x * f_p2 + centrifugal,
            xy,
            xz,
            xy,
            f + 2.0 * y * y * f_p2 + centrifugal,
            yz,
            xz,
            yz,
            zz,
        )
    }

    fn somigliana_gradient(&self, r_e: &Vector3<f64>) -> Matrix3<f64> {
        let vertical = self.vertical(r_e);
        let (up, height) = (vertical.up_e, vertical.height_m);
        let sin2 = up.z * up.z;
        let g = self.somigliana(sin2, height);
        let a = self.equatorial_radius_m;
        let f = self.flattening;
        let k = self.field.somigliana;
        // Derivatives of g with respect to sin²L and to height.
        let bracket = 1.0 - 2.0 / a * (1.0 + f + self.field.m - 2.0 * f * sin2) * height
            + 3.0 * height * height / (a * a);
        let surface = g / bracket;
        let g_sin2 = g
            * (k / (1.0 + k * sin2) + 0.5 * self.eccentricity2 / (1.0 - self.eccentricity2 * sin2))
            + surface * 4.0 * f / a * height;
        let g_height =
            surface * (-2.0 / a * (1.0 + f + self.field.m - 2.0 * f * sin2) + 6.0 * height / (a * a));
        // d up_e / d r_e is the curvature of the level surface; sin²L = up_z².
        let curvature = self.curvature(&vertical);
        let sin2_gradient = 2.0 * up.z * curvature.row(2);
        -(g * curvature + up * (g_sin2 * sin2_gradient + g_height * up.transpose()))
    }
}
