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
use crate::math::{atan2, rotation_quaternion, rotation_vector, sin_cos};
use crate::snapshot::{SIGNALS, stored};

/// Mean of a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fix {
    /// Its middle, since the start of the alignment \[s\].
    pub time_s: f64,
    /// Direction of the specific force, and attitude of the block; inertial axes.
    pub up_i: Vector3<f64>,
    pub q_is: Quaternion<f64>,
}

stored!(Fix { time_s: SIGNALS, up_i: 2.0, q_is: 2.0 } then |fix, from| {
    let sizes = fix.up_i.norm_squared().min(fix.q_is.norm_squared());
    from.require(sizes > 0.9, sizes, "is not of size 1")
});

impl Default for Fix {
    fn default() -> Self {
        Self { time_s: 0.0, up_i: Vector3::z(), q_is: Quaternion::identity() }
    }
}

/// Sums over the present window.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Window {
    /// Start and end since the start of the alignment \[s\].
    from_s: f64,
    to_s: f64,
    weight: f64,
    time_s: f64,
    force_i: Vector3<f64>,
    q_is: Quaternion<f64>,
}

stored!(Window {
    from_s: SIGNALS,
    to_s: SIGNALS,
    weight: SIGNALS,
    time_s: SIGNALS,
    force_i: SIGNALS,
    q_is: SIGNALS
});

impl Default for Window {
    fn default() -> Self {
        let q_is = Quaternion::new(0.0, 0.0, 0.0, 0.0);
        Self { from_s: 0.0, to_s: 0.0, weight: 0.0, time_s: 0.0, force_i: Vector3::zeros(), q_is }
    }
}

impl Window {
    /// `None`: in free fall there is no vertical; over whole turns there is no mean attitude.
    fn fix(&self) -> Option<Fix> {
        let (force, size) = (self.force_i.norm_squared().sqrt(), self.q_is.norm_squared().sqrt());
        (force.min(size) > 1e-6 * self.weight).then(|| Fix {
            time_s: self.time_s / self.weight,
            up_i: self.force_i / force,
            q_is: self.q_is / size,
        })
    }
}

/// An alignment in progress.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Alignment {
    pub elapsed_s: f64,
    window: Window,
    pub first: Option<Fix>,
    pub last: Option<Fix>,
    pub in_flight: InFlight,
}

stored!(Alignment { elapsed_s: SIGNALS, window, first, last, in_flight });

/// What an alignment has found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct North {
    /// Rotates east-north-up at the end of the alignment so far to inertial axes.
    pub q_in: Quaternion<f64>,
    /// Horizontal Earth rate that the gyros found, and vertical Earth rate less that of the entered latitude \[rad/s\].
    pub horizontal_rad_s: f64,
    pub vertical_excess_rad_s: f64,
}

impl Alignment {
    /// Times since a start.
    pub fn clocks(&self) -> [f64; 3] {
        let [elapsed_s, window_s] = self.in_flight.clocks();
        [self.elapsed_s, elapsed_s, window_s]
    }

    /// Takes the integral of the specific force over `dt` \[s\] that ends at the attitude `q_is`. Returns whether a window of length
    /// `window_s` \[s\], at least `dt`, is complete and has a mean.
    pub fn advance(
        &mut self,
        velocity_i: &Vector3<f64>,
        q_is: &Quaternion<f64>,
        dt: f64,
        window_s: f64,
    ) -> bool {
        let window = &mut self.window;
        if window.weight == 0.0 {
            // A window of no interval would have no weight.
            (window.from_s, window.to_s) =
                (self.elapsed_s, (window.to_s + window_s).max(self.elapsed_s + dt));
        }
        let middle_s = self.elapsed_s + 0.5 * dt;
        let (_, cos) =
            sin_cos(core::f64::consts::TAU * (middle_s - window.from_s) / (window.to_s - window.from_s));
        let weight = (1.0 - cos) * dt;
        window.weight += weight;
        window.time_s += weight * middle_s;
        window.force_i += velocity_i * (weight / dt);
        window.q_is += q_is * weight;
        self.elapsed_s += dt;
        if self.elapsed_s < window.to_s - 0.5 * dt {
            return false;
        }
        let fix = window.fix();
        self.window = Window { to_s: window.to_s, ..Window::default() };
        if self.first.is_none() {
            self.first = fix;
        } else {
            self.last = fix.or(self.last);
        }
        fix.is_some()
    }

    /// The last complete window.
    pub fn newest(&self) -> Option<&Fix> {
        self.last.as_ref().or(self.first.as_ref())
    }

    /// North, for an Earth that turns at `earth_rate` \[rad/s\], at `latitude_rad`. `None`: there are no two windows, or they show no
    /// motion of the vertical.
    pub fn north(&self, latitude_rad: f64, earth_rate: f64) -> Option<North> {
        let (first, last) = (self.first.as_ref()?, self.last.as_ref()?);
        let apart_s = last.time_s - first.time_s;
        let (sin, cos) = sin_cos(latitude_rad);
        let (sin_half, cos_half) = sin_cos(0.5 * earth_rate * apart_s);
        let moved = last.up_i - first.up_i;
        let horizontal = moved - last.up_i * moved.dot(&last.up_i);
        let size = horizontal.norm_squared().sqrt();
        if size < 1e-12 {
            return None;
        }
        let half_way = horizontal / size;
        let (sin_turn, cos_turn) = sin_cos(atan2(sin_half * sin, cos_half));
        let east = half_way * cos_turn + last.up_i.cross(&half_way) * sin_turn;
        let axes = Matrix3::from_columns(&[east, last.up_i.cross(&east), last.up_i]);
        let turned = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
        let earth_rate_n = Vector3::new(0.0, earth_rate * cos, earth_rate * sin);
        // East-north-up at rest turn with the Earth.
        let at = |time_s: f64| *turned * rotation_quaternion(&(earth_rate_n * (time_s - last.time_s)));
        let yaw = (at(last.time_s).conjugate() * last.q_is)
            * (at(first.time_s).conjugate() * first.q_is).conjugate();
        Some(North {
            q_in: at(self.elapsed_s),
            horizontal_rad_s: earth_rate * moved.norm_squared().sqrt() / (2.0 * sin_half),
            vertical_excess_rad_s: rotation_vector(&yaw).z / apart_s,
        })
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
        let mut alignment = Alignment::default();
        let level = Quaternion::identity();
        assert!(!alignment.advance(&Vector3::zeros(), &level, 0.1, 0.1));
        // A turn by 2π changes the sign of the quaternion. Half-way through a window both intervals have the same weight.
        assert!(!alignment.advance(&Vector3::z(), &level, 0.1, 0.2));
        assert!(!alignment.advance(&Vector3::z(), &-level, 0.1, 0.2));
        assert_eq!(alignment.newest(), None);
        assert!(alignment.advance(&Vector3::z(), &level, 0.1, 0.1));
        assert_eq!(alignment.newest().unwrap().up_i, Vector3::z());
    }
}
