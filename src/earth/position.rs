//! Earth-fixed positions of places, in twice the precision of a double.

use nalgebra::Vector3;

use super::{Earth, Geodetic};
use crate::base::math::{Pair, sin_cos_each_inlined, two_product, two_sum};

/// Cosine and sine of the latitude and of the longitude of a place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Direction {
    pub latitude: Pair,
    pub longitude: Pair,
}

impl Direction {
    #[inline(always)]
    fn new(sines: Pair, cosines: Pair) -> Self {
        Self { latitude: cosines.firsts(sines), longitude: cosines.seconds(sines) }
    }

    #[inline(always)]
    pub fn of(place: &Geodetic) -> Self {
        let ([sl, so], [cl, co]) = sin_cos_each_inlined(&[place.latitude_rad, place.longitude_rad]);
        Self::new(Pair::new(sl, so), Pair::new(cl, co))
    }

    /// Unit vectors east, north and up, Earth-fixed axes.
    #[inline(always)]
    fn east_north_up(&self) -> (Vector3<f64>, Vector3<f64>, Vector3<f64>) {
        let (cl, sl) = (self.latitude.first(), self.latitude.second());
        let (co, so) = (self.longitude.first(), self.longitude.second());
        (Vector3::new(-so, co, 0.0), Vector3::new(-sl * co, -sl * so, cl), Vector3::new(cl * co, cl * so, sl))
    }
}

/// An Earth-fixed position [m], each component an unevaluated sum of two doubles.
pub(super) struct Position {
    pub xy: (Pair, Pair),
    pub z: (f64, f64),
}

impl Position {
    #[inline(always)]
    fn rounded(&self) -> Vector3<f64> {
        let xy = self.xy.0 + self.xy.1;
        Vector3::new(xy.first(), xy.second(), self.z.0 + self.z.1)
    }
}

/// Product of an unevaluated sum of two doubles and a factor, also as an unevaluated sum of two doubles.
#[inline(always)]
fn times((high, low): (Pair, Pair), factor: Pair) -> (Pair, Pair) {
    let (product, error) = two_product(high, factor);
    (product, error + low * factor)
}

impl Earth {
    /// Earth-fixed position [m] of a place. Its error is half a unit in the last place and the rounding of the sines.
    pub fn to_earth_fixed(&self, place: &Geodetic) -> Vector3<f64> {
        self.to_earth_fixed_with_axes(place).0
    }

    /// Earth-fixed position [m], and the unit vectors east, north and up there.
    pub fn to_earth_fixed_with_axes(&self, place: &Geodetic) -> (Vector3<f64>, [Vector3<f64>; 3]) {
        let direction = Direction::of(place);
        (self.position(&direction, place.height_m).rounded(), direction.east_north_up().into())
    }

    /// Displacement [m] from the place `at` to the place `to`, Earth-fixed axes, and the unit vectors east, north and up at `at`.
    /// The computation is that in `position`, with the two places side by side.
    #[inline(always)]
    pub fn displacement(&self, to: &Geodetic, at: &Geodetic) -> (Vector3<f64>, [Vector3<f64>; 3]) {
        let ([sl0, sl1, so0, so1], [cl0, cl1, co0, co1]) =
            sin_cos_each_inlined(&[to.latitude_rad, at.latitude_rad, to.longitude_rad, at.longitude_rad]);
        let (sin_latitude, cos_latitude) = (Pair::new(sl0, sl1), Pair::new(cl0, cl1));
        let (sin_longitude, cos_longitude) = (Pair::new(so0, so1), Pair::new(co0, co1));
        let (a, excess) = (Pair::both(self.equatorial_radius_m), self.excess(sin_latitude));
        let height_m = Pair::new(to.height_m, at.height_m);
        let p = times(two_sum(a, excess + height_m), cos_latitude);
        let flattened = self.flattened(excess) + height_m;
        let difference = |(high, low): (Pair, Pair)| {
            let sum = high + low;
            sum.first() - sum.second()
        };
        let displacement = Vector3::new(
            difference(times(p, cos_longitude)),
            difference(times(p, sin_longitude)),
            difference(times(two_sum(a, flattened), sin_latitude)),
        );
        let here = Direction { latitude: Pair::new(cl1, sl1), longitude: Pair::new(co1, so1) };
        (displacement, here.east_north_up().into())
    }

    /// RN - a at a place. It is small, and is computed without cancellation: RN = a + a e² s² / (w (1 + w)), w² = 1 - e² s².
    #[inline(always)]
    fn excess(&self, sin_latitude: Pair) -> Pair {
        let bulge = sin_latitude * self.eccentricity2 * sin_latitude;
        let w = (Pair::both(1.0) - bulge).sqrt();
        Pair::both(self.equatorial_radius_m) * bulge / (w * (Pair::both(1.0) + w))
    }

    /// RN (1 - e²) - a at a place.
    #[inline(always)]
    fn flattened(&self, excess: Pair) -> Pair {
        excess * (1.0 - self.eccentricity2) - Pair::both(self.equatorial_radius_m * self.eccentricity2)
    }

    /// Earth-fixed position of a place. x and y are computed side by side, and so are the distance from the axis and z.
    #[inline(always)]
    pub(super) fn position(&self, direction: &Direction, height_m: f64) -> Position {
        let Direction { latitude, longitude } = *direction;
        let a = Pair::both(self.equatorial_radius_m);
        let excess = self.excess(latitude.seconds(latitude));
        let radii = two_sum(a, excess.firsts(self.flattened(excess)) + Pair::both(height_m));
        let (high, low) = times(radii, latitude);
        let z = (high.second(), low.second());
        Position { xy: times((high.firsts(high), low.firsts(low)), longitude), z }
    }

    /// Unit vectors east, north and up at a place, Earth-fixed axes.
    pub fn east_north_up(&self, place: &Geodetic) -> (Vector3<f64>, Vector3<f64>, Vector3<f64>) {
        Direction::of(place).east_north_up()
    }
}
