//! The errors of an INS at rest in closed form: Schuler, Foucault and 24 h oscillations on a sphere, level channels only.

use nalgebra::{Complex, Vector3};

/// Earth rate [rad/s].
pub const W: f64 = super::EARTH_RATE;

/// Constant sensor errors, east-north-up, at a latitude on a sphere of radius `r` [m] with gravity `g` [m/s²].
pub struct AtRest {
    pub latitude_rad: f64,
    pub r: f64,
    pub g: f64,
    /// Gyro errors [rad/s] and accelerometer errors [m/s²], of which only the level ones count.
    pub eps: Vector3<f64>,
    pub nabla: Vector3<f64>,
}

/// Misalignment φ [rad], velocity east + i north [m/s], position east + i north [m].
pub struct Solution {
    pub phi: Vector3<f64>,
    pub velocity: Complex<f64>,
    pub position: Complex<f64>,
}

impl AtRest {
    /// The errors at `t` [s] after a start without errors.
    ///
    /// u = psiE + i (s psiN - c psiU) = U e^{-iWt} + i eu/W and p = c psiN + s psiU = -ep t drive
    /// z'' + 2iWs z' + ws² z = K0 + K1 t + A- e^{-iWt} + A+ e^{iWt} for z = east + i north.
    pub fn after(&self, t: f64) -> Solution {
        let i = Complex::new(0.0, 1.0);
        let real = |x: f64| Complex::new(x, 0.0);
        let turn = |angle: f64| Complex::new(angle.cos(), angle.sin());
        let (s, c) = self.latitude_rad.sin_cos();
        let (r, g) = (self.r, self.g);
        let ws2 = g / r;
        let wf = (ws2 + W * W * s * s).sqrt();
        let eu = Complex::new(self.eps.x, s * self.eps.y - c * self.eps.z);
        let ep = c * self.eps.y + s * self.eps.z;
        let uinf = i * eu / W;
        let amplitude = -uinf;
        let k0 = Complex::new(self.nabla.x, self.nabla.y)
            + i * (0.5 * g) * (uinf * (1.0 + s) + uinf.conj() * (1.0 - s));
        let k1 = g * c * ep;
        let minus = i * (0.5 * g * (1.0 + s)) * amplitude;
        let plus = i * (0.5 * g * (1.0 - s)) * amplitude.conj();
        let d = |w: f64| -w * w - 2.0 * W * s * w + ws2;
        let a = k1 / ws2;
        let b = (k0 - i * (2.0 * W * s * a)) / ws2;
        let (minus, plus) = (minus / d(-W), plus / d(W));
        let forced = |t: f64| real(a * t) + b + minus * turn(-W * t) + plus * turn(W * t);
        let forced_rate = |t: f64| real(a) - i * W * minus * turn(-W * t) + i * W * plus * turn(W * t);
        let b1 = -forced(0.0);
        let b2 = (-forced_rate(0.0) + i * (W * s) * b1) / wf;
        let foucault = turn(-W * s * t);
        let (sin, cos) = (wf * t).sin_cos();
        let free = b1 * cos + b2 * sin;
        let position = foucault * free + forced(t);
        let velocity = foucault * ((b2 * cos - b1 * sin) * wf - i * (W * s) * free) + forced_rate(t);

        let u = amplitude * turn(-W * t) + uinf;
        let p = -ep * t;
        let psi = Vector3::new(u.re, c * p + s * u.im, s * p - c * u.im);
        let dth = Vector3::new(-position.im, position.re, position.re * s / c) / r;
        Solution { phi: psi + dth, velocity, position }
    }
}
