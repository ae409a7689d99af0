//! Geodetic coordinates and Earth-fixed positions.

use core::f64::consts::FRAC_PI_2;

use nalgebra::{Matrix3, Quaternion, Vector3};

use super::Earth;
use super::position::Direction;
use crate::base::math::{Pair, atan2_of_two, hypot, sin_cos, sin_cos_each};
use crate::base::snapshot::{ANY, stored};

/// Geodetic coordinates of a place.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Geodetic {
    /// Geodetic latitude, -π/2 to π/2 [rad].
    pub latitude_rad: f64,
    /// Longitude, east positive [rad].
    pub longitude_rad: f64,
    /// Height above the ellipsoid [m].
    pub height_m: f64,
}

stored!(Geodetic { latitude_rad: ANY, longitude_rad: ANY, height_m: ANY });

/// The vertical at a place: the normal of the ellipsoid, given without latitude and longitude, and the height along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertical {
    /// Unit vector up, Earth-fixed axes. Its z component is the sine of the latitude.
    pub up_e: Vector3<f64>,
    /// Height above the ellipsoid [m].
    pub height_m: f64,
}

/// Centre of curvature of the meridian, below the equator and from the axis [m]. It is kept from one position to the next, to find
/// the vertical in one pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VerticalTrack {
    centre_z: f64,
    centre_p: f64,
}

stored!(VerticalTrack { centre_z: 1e6, centre_p: 1e6 });

impl VerticalTrack {
    /// Track made of the numbers that [`Self::numbers`] returns.
    #[inline(always)]
    pub(crate) fn from_numbers([centre_z, centre_p]: [f64; 2]) -> Self {
        Self { centre_z, centre_p }
    }

    /// The numbers that define the track.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> [f64; 2] {
        [self.centre_z, self.centre_p]
    }
}

/// Sine and cosine of a latitude. The solution of the meridian ellipse uses only these, so that nothing is singular.
#[derive(Debug, Clone, Copy)]
struct Latitude {
    sin: f64,
    cos: f64,
}

/// The vector of length 1 along `v`.
#[inline(always)]
fn unit(v: Pair) -> Pair {
    v * (Pair::both(1.0) / (v * v).sums().sqrt())
}

impl Latitude {
    #[inline]
    fn of(sin: f64, cos: f64) -> Self {
        let scale = 1.0 / hypot(sin, cos);
        Self { sin: sin * scale, cos: cos * scale }
    }
}

impl Earth {
    /// Geodetic coordinates of an Earth-fixed position [m]; on the axis the longitude is 0.
    #[inline(always)]
    pub fn to_geodetic(&self, r_e: &Vector3<f64>) -> Geodetic {
        let p = hypot(r_e.x, r_e.y);
        let (latitude, height_m) = self.meridian(p, r_e.z);
        let angles = atan2_of_two(Pair::new(latitude.sin, r_e.y), Pair::new(latitude.cos, r_e.x));
        let (latitude_rad, longitude_rad) = (angles.first(), angles.second());
        let mut place = Geodetic { latitude_rad, longitude_rad, height_m };
        // One Newton step on the position in twice the precision removes the rounding error, which is up to 3 nm.
        let direction = Direction::of(&place);
        let position = self.position(&direction, height_m);
        let xy = (Pair::new(r_e.x, r_e.y) - position.xy.0) - position.xy.1;
        let z = (r_e.z - position.z.0) - position.z.1;
        let (cl, sl) = (direction.latitude.first(), direction.latitude.second());
        let north = (direction.longitude * -sl * xy).sum() + z * cl;
        place.latitude_rad += north / (self.radii(latitude.sin).meridian_m + height_m);
        place.latitude_rad = place.latitude_rad.clamp(-FRAC_PI_2, FRAC_PI_2);
        if p > 1.0 {
            let (co, so) = (direction.longitude.first(), direction.longitude.second());
            let east = xy.first() * -so + xy.second() * co + z * 0.0;
            place.longitude_rad += east / p;
        }
        place.height_m += (direction.longitude * cl * xy).sum() + z * sl;
        place
    }

    /// Distance of a place from the axis of the Earth [m]. Near a pole, where it is small, longitude and heading lose meaning.
    #[cold]
    #[inline(never)]
    pub fn distance_from_axis(&self, place: Geodetic) -> f64 {
        let (sin, cos) = sin_cos(place.latitude_rad);
        (self.radii(sin).transverse_m + place.height_m) * cos
    }

    /// The vertical at an Earth-fixed position [m].
    pub fn vertical(&self, r_e: &Vector3<f64>) -> Vertical {
        let p = hypot(r_e.x, r_e.y);
        let (latitude, height_m) = self.meridian(p, r_e.z);
        vertical_of(r_e, p, latitude, height_m)
    }

    /// The vertical at an Earth-fixed position [m] at most some kilometres from the previous position that `track` followed.
    #[inline(always)]
    pub fn follow(&self, track: &mut VerticalTrack, r_e: &Vector3<f64>) -> Vertical {
        let p = hypot(r_e.x, r_e.y);
        let latitude = Latitude::of(r_e.z + track.centre_z, p - track.centre_p);
        let w2 = 1.0 - self.eccentricity2 * latitude.sin * latitude.sin;
        let w = w2.sqrt();
        let height_m = p * latitude.cos + r_e.z * latitude.sin - self.equatorial_radius_m * w;
        *track = self.centre(latitude, w * w2);
        vertical_of(r_e, p, latitude, height_m)
    }

    /// Starts following the vertical at an Earth-fixed position [m].
    pub fn track(&self, r_e: &Vector3<f64>) -> VerticalTrack {
        let (latitude, _) = self.meridian(hypot(r_e.x, r_e.y), r_e.z);
        let w2 = 1.0 - self.eccentricity2 * latitude.sin * latitude.sin;
        self.centre(latitude, w2 * w2.sqrt())
    }

    /// Centre of curvature of the meridian at `latitude`, with `w3` = (1 - e² sin²L)^1.5 there.
    #[inline]
    fn centre(&self, latitude: Latitude, w3: f64) -> VerticalTrack {
        let (scale_z, scale_p) = self.centre_scales(w3);
        VerticalTrack {
            centre_z: scale_z * latitude.sin * latitude.sin * latitude.sin,
            centre_p: scale_p * latitude.cos * latitude.cos * latitude.cos,
        }
    }

    /// Factors of the cubes of sine and cosine in [`Self::centre`].
    #[inline]
    fn centre_scales(&self, w3: f64) -> (f64, f64) {
        let scale = self.equatorial_radius_m * self.eccentricity2 / w3;
        let flattened = (1.0 - self.flattening) * (1.0 - self.flattening);
        (scale * flattened, scale)
    }

    /// Latitude and height of a point of the meridian plane, `p` from the axis and `z` above the equator. The height needs no
    /// division: h = p cos L + z sin L - a sqrt(1 - e² sin²L).
    #[inline(always)]
    fn meridian(&self, p: f64, z: f64) -> (Latitude, f64) {
        let place = Pair::new(z, p);
        let mut latitude = unit(Pair::new(z, p * (1.0 - self.eccentricity2)));
        for _ in 0..3 {
            latitude = self.bowring(place, latitude);
        }
        let (sin, cos) = (latitude.first(), latitude.second());
        let w2 = 1.0 - self.eccentricity2 * sin * sin;
        let height_m = (latitude * Pair::new(z, p)).sum() - self.equatorial_radius_m * w2.sqrt();
        (Latitude { sin, cos }, height_m)
    }

    /// Bowring's step: the normal through the centre of curvature that belongs to the latitude `guess`. The centre
    /// moves along the normal itself. So each step squares the error (times e² h/a).
    #[inline(always)]
    fn bowring(&self, place: Pair, guess: Pair) -> Pair {
        let sin = guess.first();
        let w2 = 1.0 - self.eccentricity2 * sin * sin;
        let (scale_z, scale_p) = self.centre_scales(w2 * w2.sqrt());
        unit(place + Pair::new(scale_z, -scale_p) * guess * guess * guess)
    }

    /// Derivative of the up vector with respect to position, Earth-fixed axes [rad/m]:
    /// I/N over the horizontal plane, and 1/M - 1/N in the meridian, without a division by cos L.
    pub fn curvature(&self, vertical: &Vertical) -> Matrix3<f64> {
        let up = &vertical.up_e;
        let (inverse_n, meridian_excess) = self.curvature_terms(up.z, vertical.height_m);
        let north_cos = Vector3::new(-up.x * up.z, -up.y * up.z, 1.0 - up.z * up.z);
        (Matrix3::identity() - up * up.transpose()) * inverse_n
            + north_cos * north_cos.transpose() * meridian_excess
    }

    /// 1/(RN + h) [1/m], and the factor of (north cos L)(north cos L)ᵀ: (1/(RM + h) - 1/(RN + h)) / cos²L.
    #[inline]
    pub(crate) fn curvature_terms(&self, sin_latitude: f64, height_m: f64) -> (f64, f64) {
        let w2 = 1.0 - self.eccentricity2 * sin_latitude * sin_latitude;
        let radii = self.radii(sin_latitude);
        let inverse_n = 1.0 / (radii.transverse_m + height_m);
        let inverse_m = 1.0 / (radii.meridian_m + height_m);
        (inverse_n, radii.transverse_m * self.eccentricity2 / w2 * inverse_n * inverse_m)
    }
}

#[inline]
fn vertical_of(r_e: &Vector3<f64>, p: f64, latitude: Latitude, height_m: f64) -> Vertical {
    let scale = if p > 0.0 { latitude.cos / p } else { 0.0 };
    Vertical { up_e: Vector3::new(scale * r_e.x, scale * r_e.y, latitude.sin), height_m }
}

/// `q_en` at a place: rotates east-north-up to Earth-fixed axes.
pub fn navigation_axes(latitude_rad: f64, longitude_rad: f64) -> Quaternion<f64> {
    let (sines, cosines) = sin_cos_each(&[0.5 * latitude_rad, 0.5 * longitude_rad]);
    navigation_axes_from_half_angles(&sines, &cosines)
}

/// Navigation axes from the sines and cosines of half of latitude and longitude: Rz(longitude + 90°) Rx(90° - latitude).
#[inline]
pub(crate) fn navigation_axes_from_half_angles(
    &[sl, so]: &[f64; 2],
    &[cl, co]: &[f64; 2],
) -> Quaternion<f64> {
    let (minus, plus) = (0.5 * (co - so), 0.5 * (co + so));
    let (up, down) = (cl + sl, cl - sl);
    Quaternion::new(minus * up, minus * down, plus * down, plus * up)
}
