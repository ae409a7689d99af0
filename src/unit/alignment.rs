//! Alignment at rest on measured increments: the vertical from the accelerometers, north from its motion in inertial axes.
//!
//! The gyros keep inertial axes while the vehicle sways. There the specific force at rest turns with the Earth. It is averaged over
//! windows; the weight 1 - cos(2πt/a) within a window of length a suppresses a sway of frequency f by 1/(f a)³. With the directions
//! u₁ and u₂ of the first and of the last window, D apart, and the angle δ = Ω D/2 of the Earth,
//! ```text
//! u₂ - u₁ = 2 sin δ cos L · east half-way,   east half-way = cos δ · east₂ + sin δ (cos L · u₂ - sin L · north₂)
//! ```
//! so the horizontal part of u₂ - u₁ is east at the last window, turned by a known angle; its length is the cosine of latitude that the
//! gyros find. White noise N of the gyros over the time T gives a heading error of N/(Ω cos L √T) \[(1 - 1.207 a/T)^½/(1 - a/T)\]: 1.02 of
//! the least possible one for a = T/20.

use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

use super::in_flight::InFlight;
use crate::base::math::{atan2, rotate, rotation_quaternion, rotation_vector, sin_cos};
use crate::base::snapshot::{SIGNALS, stored};
use crate::earth::{Earth, Geodetic};

/// Mean acceleration in a window up to which the aircraft rests \[m/s²\]. It tilts the vertical by 5e-5 rad. Departure: as in the test for
/// motion, a real unit does not know it.
const AT_REST_M_S2: f64 = 5e-4;

/// The Earth under an aircraft at rest: its rotation, and the vertical.
#[derive(Debug, Clone, Copy)]
pub(super) struct EarthAtRest {
    pub rate_rad_s: f64,
    /// Of the latitude.
    pub sin: f64,
    pub cos: f64,
    /// Direction of the reaction to gravity, east-north-up: above the ellipsoid it leans to the pole.
    up_n: Vector3<f64>,
}

impl EarthAtRest {
    pub fn new(earth: &Earth, place: &Geodetic) -> Self {
        let (sin, cos) = sin_cos(place.latitude_rad);
        let (r_e, [_, north, up]) = earth.to_earth_fixed_with_axes(place);
        let reaction_e = -earth.gravity(&r_e);
        let reaction_n = Vector3::new(0.0, north.dot(&reaction_e), up.dot(&reaction_e));
        Self { rate_rad_s: earth.rate_rad_s, sin, cos, up_n: reaction_n / reaction_n.norm_squared().sqrt() }
    }

    /// Direction of the Earth's axis, east-north-up.
    pub fn axis_n(&self) -> Vector3<f64> {
        Vector3::new(0.0, self.cos, self.sin)
    }

    /// Rotates the axes east-north-up `t` \[s\] later to these axes.
    pub fn over(&self, t: f64) -> Quaternion<f64> {
        rotation_quaternion(&(self.axis_n() * (self.rate_rad_s * t)))
    }

    /// Direction of the mean vertical of a window, in the axes east-north-up at its middle. The vertical u moves on a cone about the
    /// axis a of the Earth, so the mean over the variance σ² of time is u + (Ωσ)²/2 (a (a·u) - u).
    fn mean_up_n(&self, variance_s2: f64) -> Vector3<f64> {
        let inwards = 0.5 * self.rate_rad_s * self.rate_rad_s * variance_s2;
        let up = self.up_n + (self.axis_n() * self.axis_n().dot(&self.up_n) - self.up_n) * inwards;
        up / up.norm_squared().sqrt()
    }
}

/// Mean of a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fix {
    /// Its middle, since the start of the alignment \[s\], and the variance of time around it \[s²\].
    pub time_s: f64,
    pub variance_s2: f64,
    /// Direction of the specific force, and attitude of the block; inertial axes.
    pub up_i: Vector3<f64>,
    pub q_is: Quaternion<f64>,
}

stored!(Fix { time_s: SIGNALS, variance_s2: SIGNALS, up_i: 2.0, q_is: 2.0 } then |fix, from| {
    let sizes = fix.up_i.norm_squared().min(fix.q_is.norm_squared());
    from.require(sizes > 0.9, sizes, "is not of size 1")
});

impl Default for Fix {
    fn default() -> Self {
        Self { time_s: 0.0, variance_s2: 0.0, up_i: Vector3::z(), q_is: Quaternion::identity() }
    }
}

/// Sums over the present window.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Window {
    /// Start and end since the start of the alignment \[s\].
    from_s: f64,
    to_s: f64,
    weight: f64,
    /// Weighted sums: time since its start, its square, force, attitude.
    time_s: f64,
    time_s2: f64,
    force_i: Vector3<f64>,
    /// Of the aircraft.
    acceleration_e: Vector3<f64>,
    q_is: Quaternion<f64>,
}

stored!(Window {
    from_s: SIGNALS,
    to_s: SIGNALS,
    weight: SIGNALS,
    time_s: SIGNALS,
    time_s2: SIGNALS,
    force_i: SIGNALS,
    acceleration_e: SIGNALS,
    q_is: SIGNALS
});

impl Default for Window {
    fn default() -> Self {
        let q_is = Quaternion::new(0.0, 0.0, 0.0, 0.0);
        let (force_i, acceleration_e) = (Vector3::zeros(), Vector3::zeros());
        Self { from_s: 0.0, to_s: 0.0, weight: 0.0, time_s: 0.0, time_s2: 0.0, force_i, acceleration_e, q_is }
    }
}

impl Window {
    /// `None`: in free fall there is no vertical; over whole turns there is no mean attitude; an aircraft that starts slowly, or sways in
    /// a short window, has another vertical.
    fn fix(&self) -> Option<Fix> {
        let (force, size) = (self.force_i.norm_squared().sqrt(), self.q_is.norm_squared().sqrt());
        let mean_s = self.time_s / self.weight;
        let is_at_rest = self.acceleration_e.norm_squared().sqrt() <= AT_REST_M_S2 * self.weight;
        (is_at_rest && force.min(size) > 1e-6 * self.weight).then(|| Fix {
            time_s: self.from_s + mean_s,
            variance_s2: (self.time_s2 / self.weight - mean_s * mean_s).max(0.0),
            up_i: self.force_i / force,
            q_is: self.q_is / size,
        })
    }
}

/// An alignment in progress.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct AlignmentProgress {
    pub elapsed_s: f64,
    window: Window,
    /// Temperature at its start \[°C\], if it is known.
    pub temperature_c: Option<f64>,
    pub first: Option<Fix>,
    pub last: Option<Fix>,
    /// Of a gyrocompass with two windows, at a latitude that is known \[rad\].
    pub heading_sigma_rad: Option<f64>,
    pub in_flight: InFlight,
}

stored!(AlignmentProgress {
    elapsed_s: SIGNALS,
    window,
    temperature_c: SIGNALS,
    first,
    last,
    heading_sigma_rad: SIGNALS,
    in_flight
});

/// What an alignment has found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct North {
    /// Rotates east-north-up at the end of the alignment so far to inertial axes.
    pub q_in: Quaternion<f64>,
    /// Horizontal Earth rate that the gyros found, and vertical Earth rate less that of the entered latitude \[rad/s\].
    pub horizontal_rad_s: f64,
    pub vertical_excess_rad_s: f64,
}

impl AlignmentProgress {
    /// Times since a start.
    pub fn clocks(&self) -> [f64; 3] {
        let [elapsed_s, window_s] = self.in_flight.clocks();
        [self.elapsed_s, elapsed_s, window_s]
    }

    /// Takes the integral of the specific force over `dt` \[s\] that ends at the attitude `q_is`, and the acceleration of an aircraft that
    /// should rest. If this completes a window of length `window_s` \[s\], at least `dt`, it returns whether the window has a mean.
    pub fn advance(
        &mut self,
        velocity_i: &Vector3<f64>,
        q_is: &Quaternion<f64>,
        acceleration_e: &Vector3<f64>,
        dt: f64,
        window_s: f64,
    ) -> Option<bool> {
        let window = &mut self.window;
        if window.weight == 0.0 {
            // A window of no interval would have no weight.
            (window.from_s, window.to_s) =
                (self.elapsed_s, (window.to_s + window_s).max(self.elapsed_s + dt));
        }
        let middle_s = self.elapsed_s + 0.5 * dt - window.from_s;
        let (_, cos) = sin_cos(core::f64::consts::TAU * middle_s / (window.to_s - window.from_s));
        let weight = (1.0 - cos) * dt;
        window.weight += weight;
        window.time_s += weight * middle_s;
        // With the variance of time within the interval itself.
        window.time_s2 += weight * (middle_s * middle_s + dt * dt / 12.0);
        window.force_i += velocity_i * (weight / dt);
        window.acceleration_e += acceleration_e * weight;
        window.q_is += q_is * weight;
        self.elapsed_s += dt;
        if self.elapsed_s < window.to_s - 0.5 * dt {
            return None;
        }
        let fix = window.fix();
        self.window = Window { to_s: window.to_s, ..Window::default() };
        if self.first.is_none() {
            self.first = fix;
        } else {
            self.last = fix.or(self.last);
        }
        Some(fix.is_some())
    }

    /// The last complete window.
    pub fn newest(&self) -> Option<&Fix> {
        self.last.as_ref().or(self.first.as_ref())
    }

    /// Time between the middles of the first and of the last window, and the length of these \[s\], if there are two.
    pub fn windows_s(&self) -> Option<(f64, f64)> {
        let (first, last) = (self.first.as_ref()?, self.last.as_ref()?);
        // The weight 1 - cos(2πt/a) gives time the variance a² (1/12 - 1/(2π²)).
        const VARIANCE: f64 = 1.0 / 12.0 - 0.5 / (core::f64::consts::PI * core::f64::consts::PI);
        Some((last.time_s - first.time_s, (last.variance_s2 / VARIANCE).sqrt()))
    }

    /// North at rest on `earth`. `None`: there are no two windows, or they show no motion of the vertical.
    pub fn north(&self, earth: &EarthAtRest) -> Option<North> {
        let (first, last) = (self.first.as_ref()?, self.last.as_ref()?);
        let apart_s = last.time_s - first.time_s;
        let (sin_half, cos_half) = sin_cos(0.5 * earth.rate_rad_s * apart_s);
        let sin_of_up = earth.axis_n().dot(&earth.up_n);
        let q_in_of = |first_i: &Vector3<f64>, last_i: &Vector3<f64>| {
            let moved = last_i - first_i;
            let horizontal = moved - last_i * moved.dot(last_i);
            let size = horizontal.norm_squared().sqrt();
            if size < 1e-12 {
                return None;
            }
            let half_way = horizontal / size;
            let (sin_turn, cos_turn) = sin_cos(atan2(sin_half * sin_of_up, cos_half));
            let east = half_way * cos_turn + last_i.cross(&half_way) * sin_turn;
            let axes = Matrix3::from_columns(&[east, last_i.cross(&east), *last_i]);
            let axes = *UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
            Some((axes * shortest_rotation(&earth.up_n, &Vector3::z()), moved))
        };
        // The axes of the means are those of the verticals in the middle to (Ω a)² of a window; these show the difference.
        let (near, _) = q_in_of(&first.up_i, &last.up_i)?;
        let in_middle = |fix: &Fix, q_in: Quaternion<f64>| {
            let shortened_n = earth.mean_up_n(fix.variance_s2) - earth.up_n;
            let up_i = fix.up_i - rotate(&q_in, &shortened_n);
            up_i / up_i.norm_squared().sqrt()
        };
        let (q_in, moved) = q_in_of(&in_middle(first, near * earth.over(-apart_s)), &in_middle(last, near))?;
        let yaw = (q_in.conjugate() * last.q_is)
            * ((q_in * earth.over(-apart_s)).conjugate() * first.q_is).conjugate();
        Some(North {
            q_in: q_in * earth.over(self.elapsed_s - last.time_s),
            horizontal_rad_s: earth.rate_rad_s * moved.norm_squared().sqrt() / (2.0 * sin_half),
            vertical_excess_rad_s: rotation_vector(&yaw).z / apart_s,
        })
    }

    /// The rotation nearest to `q_in`, of east-north-up now to inertial axes, for which the newest window had the vertical that it showed.
    pub fn levelled(&self, q_in: &Quaternion<f64>, earth: &EarthAtRest) -> Option<Quaternion<f64>> {
        let fix = self.newest()?;
        let then_n = rotate(&earth.over(fix.time_s - self.elapsed_s), &earth.mean_up_n(fix.variance_s2));
        Some(shortest_rotation(&rotate(q_in, &then_n), &fix.up_i) * q_in)
    }

    /// The vertical now, inertial axes: with two windows it moves on as between them.
    pub fn up_i(&self) -> Option<Vector3<f64>> {
        let newest = self.newest()?;
        let Some((first, last)) = self.first.as_ref().zip(self.last.as_ref()) else {
            return Some(newest.up_i);
        };
        let moved = last.up_i - first.up_i;
        let up_i = last.up_i + moved * ((self.elapsed_s - last.time_s) / (last.time_s - first.time_s));
        Some(up_i / up_i.norm_squared().sqrt())
    }
}

/// The shortest rotation that brings the unit vector `from` to the unit vector `to`.
pub(super) fn shortest_rotation(from: &Vector3<f64>, to: &Vector3<f64>) -> Quaternion<f64> {
    let axis = from.cross(to);
    let sin = axis.norm_squared().sqrt();
    if sin == 0.0 {
        return Quaternion::identity();
    }
    rotation_quaternion(&(axis * (atan2(sin, from.dot(to)) / sin)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_of_free_fall_or_of_whole_turns_has_no_mean() {
        let mut alignment = AlignmentProgress::default();
        let (level, none) = (Quaternion::identity(), Vector3::zeros());
        assert_eq!(alignment.advance(&Vector3::zeros(), &level, &none, 0.1, 0.1), Some(false));
        // A turn by 2π changes the sign of the quaternion. Half-way through a window both intervals have the same weight.
        assert_eq!(alignment.advance(&Vector3::z(), &level, &none, 0.1, 0.2), None);
        assert_eq!(alignment.advance(&Vector3::z(), &-level, &none, 0.1, 0.2), Some(false));
        assert_eq!(alignment.newest(), None);
        assert_eq!(alignment.advance(&Vector3::z(), &level, &none, 0.1, 0.1), Some(true));
        assert_eq!(alignment.newest().unwrap().up_i, Vector3::z());
    }
}
