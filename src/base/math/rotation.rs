//! Rotations: quaternions (scalar first in print, `nalgebra` order inside) and rotation vectors.
//!
//! `q_nb` rotates a vector from body to navigation axes: `v_n = rotate(q_nb, v_b)`.

use nalgebra::{Matrix3, Quaternion, Vector3};

use super::pair::Pair;
use super::transcendental::{atan2, sin_cos};

/// The two coefficients from which every rotation formula is built, for a rotation angle n:
/// R(φ) = I + (1 - n² `cubic`) [φ×] + `square` [φ×]², right Jacobian = I - `square` [φ×] + `cubic` [φ×]².
#[derive(Debug, Clone, Copy)]
pub struct RotationSeries {
    /// (1 - cos n) / n²
    pub square: f64,
    /// (n - sin n) / n³
    pub cubic: f64,
}

impl RotationSeries {
    /// The coefficients for the squared angle `n2` = n² [rad²].
    #[inline(always)]
    pub fn new(n2: f64) -> Self {
        if Self::is_short(n2) { Self::short(n2) } else { Self::long(n2) }
    }

    /// The coefficients for a squared angle `n2` [rad²] that is not short.
    #[inline(never)]
    fn long(n2: f64) -> Self {
        // Taylor series, because the closed forms cancel at 0. Dropped terms are below 1e-17 of the sum: n² / 16! in the long
        // series, up to 0.5 rad, and n² / 10! in the short series, up to 0.06 rad, which is enough for most intervals.
        let x = n2;
        if n2 < 0.25 {
            let tail = 1.0 / 3_628_800.0
                - x * (1.0 / 479_001_600.0 - x * (1.0 / 87_178_291_200.0 - x / 20_922_789_888_000.0));
            let square = 1.0 / 2.0 - x * (1.0 / 24.0 - x * (1.0 / 720.0 - x * (1.0 / 40_320.0 - x * tail)));
            let tail = 1.0 / 39_916_800.0
                - x * (1.0 / 6_227_020_800.0 - x * (1.0 / 1_307_674_368_000.0 - x / 355_687_428_096_000.0));
            let cubic =
                1.0 / 6.0 - x * (1.0 / 120.0 - x * (1.0 / 5_040.0 - x * (1.0 / 362_880.0 - x * tail)));
            Self { square, cubic }
        } else {
            let n = n2.sqrt();
            let (half_sin, _) = sin_cos(0.5 * n);
            Self { square: 2.0 * half_sin * half_sin / n2, cubic: (n - sin_cos(n).0) / (n2 * n) }
        }
    }

    /// Whether [`Self::short`] holds for the squared angle `n2` [rad²].
    #[inline(always)]
    pub fn is_short(n2: f64) -> bool {
        n2 < SHORT_SERIES
    }

    /// The coefficients for a squared angle `x` [rad²] that is short.
    #[inline(always)]
    pub fn short(x: f64) -> Self {
        Self {
            square: 1.0 / 2.0 - x * (1.0 / 24.0 - x * (1.0 / 720.0 - x * (1.0 / 40_320.0))),
            cubic: 1.0 / 6.0 - x * (1.0 / 120.0 - x * (1.0 / 5_040.0 - x * (1.0 / 362_880.0))),
        }
    }

    /// `square` and `cubic` for two squared angles [rad²]. They are computed together if the short series holds for both.
    #[inline(always)]
    pub fn of_pair(n2: Pair) -> (Pair, Pair) {
        if n2.max() < SHORT_SERIES {
            let one = Pair::both;
            let square =
                one(1.0 / 2.0) - n2 * (one(1.0 / 24.0) - n2 * (one(1.0 / 720.0) - n2 * (1.0 / 40_320.0)));
            let cubic =
                one(1.0 / 6.0) - n2 * (one(1.0 / 120.0) - n2 * (one(1.0 / 5_040.0) - n2 * (1.0 / 362_880.0)));
            return (square, cubic);
        }
        let [first, second] = n2.0.map(Self::new);
        (Pair([first.square, second.square]), Pair([first.cubic, second.cubic]))
    }
}

/// Squared angle up to which the short series holds [rad²].
const SHORT_SERIES: f64 = 0.003_6;

/// `v` rotated by the unit quaternion `q`.
#[inline]
pub fn rotate(q: &Quaternion<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    let u = q.imag();
    let t = 2.0 * u.cross(v);
    v + q.w * t + u.cross(&t)
}

/// `v` rotated by the inverse of the unit quaternion `q`.
#[inline]
pub fn rotate_inverse(q: &Quaternion<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    let u = q.imag();
    let t = 2.0 * v.cross(&u);
    v + q.w * t + t.cross(&u)
}

/// The z axis rotated by the unit quaternion `q`.
#[inline]
pub fn rotated_z(q: &Quaternion<f64>) -> Vector3<f64> {
    let (w, x, y, z) = (q.w, q.i, q.j, q.k);
    Vector3::new(2.0 * (x * z + w * y), 2.0 * (y * z - w * x), (w * w + z * z) - (x * x + y * y))
}

/// (0, 0, `w`) × `v`
#[inline]
pub fn axis_cross(w: f64, v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-w * v.y, w * v.x, 0.0)
}

/// Matrix of the unit quaternion `q`: cheaper than [`rotate`] for three vectors or more.
#[inline]
pub fn rotation_matrix(q: &Quaternion<f64>) -> Matrix3<f64> {
    let (w, x, y, z) = (q.w, q.i, q.j, q.k);
    let (x2, y2, z2) = (x + x, y + y, z + z);
    let (xx, yy, zz) = (x * x2, y * y2, z * z2);
    let (xy, xz, yz) = (x * y2, x * z2, y * z2);
    let (wx, wy, wz) = (w * x2, w * y2, w * z2);
    Matrix3::new(
        1.0 - (yy + zz),
        xy - wz,
        xz + wy,
        xy + wz,
        1.0 - (xx + zz),
        yz - wx,
        xz - wy,
        yz + wx,
        1.0 - (xx + yy),
    )
}

/// A turn about the z axis of the outer frame.
#[derive(Debug, Clone, Copy)]
pub struct AxisTurn {
    sine: f64,
    cosine_less_one: f64,
}

impl AxisTurn {
    /// Turn by `angle` [rad].
    #[inline]
    pub fn new(angle: f64) -> Self {
        let h = 0.5 * angle;
        let h2 = h * h;
        // The Earth turns by 1e-6 to 1e-3 rad in an interval; the dropped terms are below 1e-17 there.
        let (sine, cosine_less_one) = if h2 < 1e-5 {
            (h * (1.0 - h2 * (1.0 / 6.0 - h2 / 120.0)), -0.5 * h2 * (1.0 - h2 / 12.0))
        } else {
            let (quarter_sine, _) = sin_cos(0.5 * h);
            (sin_cos(h).0, -2.0 * quarter_sine * quarter_sine)
        };
        Self { sine, cosine_less_one }
    }

    /// (q_z - 1) `q`: the increment that the turn adds to `q`.
    #[inline(always)]
    pub fn increment(&self, q: &Quaternion<f64>) -> Quaternion<f64> {
        let Self { sine, cosine_less_one } = *self;
        Quaternion::new(
            cosine_less_one * q.w - sine * q.k,
            cosine_less_one * q.i - sine * q.j,
            cosine_less_one * q.j + sine * q.i,
            cosine_less_one * q.k + sine * q.w,
        )
    }
}

/// Quaternion of the rotation vector `phi` [rad], less the identity: small rotations keep all their digits.
#[inline]
pub fn rotation_increment(phi: &Vector3<f64>) -> Quaternion<f64> {
    rotation_increment_by(phi, RotationSeries::new)
}

/// [`rotation_increment`] with the coefficients that `series` gives.
#[inline(always)]
pub fn rotation_increment_by(
    phi: &Vector3<f64>,
    series: impl FnOnce(f64) -> RotationSeries,
) -> Quaternion<f64> {
    let quarter = quarter_square(phi);
    let series = series(quarter);
    let imaginary = phi * (0.5 * (1.0 - quarter * series.cubic));
    Quaternion::from_parts(-quarter * series.square, imaginary)
}

/// Square of half the angle of the rotation vector `phi`, for which [`rotation_increment`] needs its coefficients [rad²].
#[inline(always)]
pub fn quarter_square(phi: &Vector3<f64>) -> f64 {
    0.25 * phi.norm_squared()
}

/// Quaternion of the rotation vector `phi` [rad].
#[inline]
pub fn rotation_quaternion(phi: &Vector3<f64>) -> Quaternion<f64> {
    let mut q = rotation_increment(phi);
    q.w += 1.0;
    q
}

/// Rotation vector [rad] of the quaternion `q`, of length 0 to π. The norm of `q` cancels.
///
/// It is the arc tangent of the vector part over the scalar part; 2 acos(w) would give 0 for rotations below 1e-8 rad.
#[inline]
pub fn rotation_vector(q: &Quaternion<f64>) -> Vector3<f64> {
    // Of q and -q, the one with a scalar part that is not negative.
    let sign = Pair::both(q.w).less(Pair::both(0.0)) & Pair::both(-0.0);
    let (xy, zw) = (Pair::new(q.i, q.j) ^ sign, Pair::new(q.k, q.w) ^ sign);
    let (u, w) = (Vector3::new(xy.first(), xy.second(), zw.first()), zw.second().abs());
    let n2 = u.norm_squared();
    // atan(√t)/√t by its series for t = n²/w² < 4e-3; the first dropped term is below 1e-18 of it.
    if n2 < 4e-3 * w * w {
        let inverse_w = 1.0 / w;
        let t = n2 * (inverse_w * inverse_w);
        let tail = 1.0 / 9.0 - t * (1.0 / 11.0 - t * (1.0 / 13.0 - t / 15.0));
        let series = 1.0 - t * (1.0 / 3.0 - t * (1.0 / 5.0 - t * (1.0 / 7.0 - t * tail)));
        u * (2.0 * series * inverse_w)
    } else {
        let n = n2.sqrt();
        u * (2.0 * atan2(n, w) / n)
    }
}

/// q0* q1 of two unit quaternions, the rotation from one attitude to the other. It is computed from their difference, so that equal
/// attitudes give exactly the identity. A product would leave 5e-17 rad of rounding each time: 5e-15 rad/s at 100 Hz. At rest this
/// rounding always has the same sense: 5 mm after 48 h.
#[inline]
pub fn relative_rotation(from: &Quaternion<f64>, to: &Quaternion<f64>) -> Quaternion<f64> {
    let to = if from.dot(to) < 0.0 { -to } else { *to };
    let mut relative = from.conjugate() * (to - from);
    relative.w += 1.0;
    relative
}

/// Angular rate, body axes, of a body whose rotation vector is `phi` [rad] and changes at `rate`: the right Jacobian applied
/// to `rate`.
#[inline]
pub fn right_jacobian(phi: &Vector3<f64>, rate: &Vector3<f64>) -> Vector3<f64> {
    let series = RotationSeries::new(phi.norm_squared());
    let cross = phi.cross(rate);
    rate - series.square * cross + series.cubic * phi.cross(&cross)
}

/// Rate of the rotation vector `phi` [rad] when the body turns at `omega` (body axes): the inverse of the right
/// Jacobian applied to `omega`.
#[inline]
pub fn inverse_right_jacobian(phi: &Vector3<f64>, omega: &Vector3<f64>) -> Vector3<f64> {
    let n2 = phi.norm_squared();
    let coefficient = if n2 < 0.04 {
        let x = n2;
        1.0 / 12.0
            + x * (1.0 / 720.0
                + x * (1.0 / 30_240.0
                    + x * (1.0 / 1_209_600.0 + x * (1.0 / 47_900_160.0 + x * (691.0 / 1_307_674_368_000.0)))))
    } else {
        let s = RotationSeries::new(n2);
        (1.0 - 0.5 * (1.0 - n2 * s.cubic) / s.square) / n2
    };
    let cross = phi.cross(omega);
    omega + 0.5 * cross + coefficient * phi.cross(&cross)
}
