//! Attitude of a coordinated flight, from its path: no sideslip, no lateral force, no wind.
//!
//! f = v' + 2 W × v - g; x along v, L = f - (f·x) x, z = -L/|L|, y = z × x; then x is turned up about y by the angle of attack. Only
//! positive loads: where |L| is below 0.3 g the attitude is not defined.

use core::f64::consts::PI;

use nalgebra::Vector3;

use super::fit::{Curve, Samples};
use super::{check_steps, numbers_of, place_of};
use crate::base::error::{Error, ErrorKind, Rule, check_range};
use crate::base::math::{Euler, asin, atan2, hypot, sin_cos};
use crate::base::memory::room;
use crate::base::units::STANDARD_GRAVITY as G;
use crate::earth::{Earth, Geodetic};

/// Time between two attitudes [s].
const EVERY_S: f64 = 0.1;

/// Speed below which the vehicle is level, as ships, cars and hovering aircraft are; at twice that speed it banks as an aeroplane [m/s].
const SLOW_M_S: f64 = 8.0;

/// Climb below which what goes up steeply with less load than 1 g is a drone, a helicopter or a balloon, which stays level \[m/s\].
const LIFTED_M_S: f64 = 20.0;

/// Least horizontal speed of a heading [m/s], and in deviations of the velocity of the path: below it, the heading is that of the last
/// motion.
const LEAST_COURSE_M_S: f64 = 0.1;
const COURSE_DEVIATIONS: f64 = 4.0;

/// Least load of a defined attitude [g].
const LEAST_LOAD: f64 = 0.3;

/// Largest cut-off of the attitude [Hz]: 1 / (2π 0.3 s).
pub(super) const CUTOFF_HZ: f64 = 0.53;

/// Horizontal position and height as curves.
pub(super) struct Path<'a> {
    pub earth: &'a Earth,
    pub normals: &'a Curve<3>,
    pub heights: &'a Curve<1>,
}

impl Path<'_> {
    /// Position, and velocity east, north and up [m/s]: v_E = (R_N + h) e_E·n', v_N = (R_M + h) e_N·n' of the unit normal n, v_U = h'.
    pub fn at(&self, time_s: f64) -> (Geodetic, Vector3<f64>) {
        let normal = Vector3::from(self.normals.at(time_s, 0));
        let rate = Vector3::from(self.normals.at(time_s, 1)) / normal.norm_squared().sqrt();
        let ([height_m], [climb]) = (self.heights.at(time_s, 0), self.heights.at(time_s, 1));
        let place = place_of(&normal, height_m);
        let (east, north, up) = self.earth.east_north_up(&place);
        let radii = self.earth.radii(up.z);
        let v = [radii.transverse_m + height_m, radii.meridian_m + height_m];
        (place, Vector3::new(v[0] * east.dot(&rate), v[1] * north.dot(&rate), climb))
    }

    fn velocity_e(&self, time_s: f64) -> Vector3<f64> {
        let (place, v) = self.at(time_s);
        let (east, north, up) = self.earth.east_north_up(&place);
        east * v.x + north * v.y + up * v.z
    }

    /// Velocity and specific force to the east, north and up [m/s, m/s²], between the ends of the path.
    fn motion(&self, time_s: f64, [start_s, end_s]: [f64; 2]) -> (Vector3<f64>, Vector3<f64>) {
        let (place, v_n) = self.at(time_s);
        let (before_s, behind_s) =
            ((time_s - 0.5 * EVERY_S).max(start_s), (time_s + 0.5 * EVERY_S).min(end_s));
        let change = self.velocity_e(behind_s) - self.velocity_e(before_s);
        let (east, north, up) = self.earth.east_north_up(&place);
        let v_e = east * v_n.x + north * v_n.y + up * v_n.z;
        let coriolis = Vector3::new(-v_e.y, v_e.x, 0.0) * (2.0 * self.earth.rate_rad_s);
        let f_e = change / (behind_s - before_s) + coriolis
            - self.earth.gravity(&self.earth.to_earth_fixed(&place));
        (v_n, Vector3::new(f_e.dot(&east), f_e.dot(&north), f_e.dot(&up)))
    }
}

/// The attitude along a path of `rows` rows between its ends, from a time stamp on [s], with an angle of attack [rad].
pub(super) fn attitudes(
    path: &Path<'_>,
    ends_s: [f64; 2],
    from_s: f64,
    rows: usize,
    attack_rad: f64,
) -> Result<Curve<4>, Error> {
    check_range("coordinated_attack_rad", attack_rad, -0.5, 0.5)?;
    let span_s = [from_s, ends_s[1]];
    check_steps(span_s[1] - span_s[0], EVERY_S, rows)?;
    let count = ((span_s[1] - span_s[0]) / EVERY_S).ceil().max(20.0) as usize;
    let time_s = |k: usize| span_s[0] + (span_s[1] - span_s[0]) * k as f64 / count as f64;
    let (mut times_s, mut eulers) = (room(count + 1)?, room::<Euler>(count + 1)?);
    let least = LEAST_COURSE_M_S.max(COURSE_DEVIATIONS * path.normals.rate_noise());
    let mut first_moving = None;
    for k in 0..=count {
        let (v, f) = path.motion(time_s(k), ends_s);
        let speed = v.norm_squared().sqrt();
        times_s.push(time_s(k));
        let is_on_course = hypot(v.x, v.y) >= least;
        let heading = match is_on_course {
            true => course(&v),
            false => eulers.last().map_or(0.0, |last: &Euler| last.heading),
        };
        if is_on_course {
            first_moving.get_or_insert((k, heading));
        }
        let x = v / speed.max(f64::MIN_POSITIVE);
        let lift = f - x * f.dot(&x);
        let level = hypot(v.x, v.y);
        let is_lifted = v.z.abs() > level && v.z.abs() < LIFTED_M_S && lift.norm_squared() < G * G;
        let speed = if is_lifted { level } else { speed };
        if speed < SLOW_M_S {
            eulers.push(Euler { roll: 0.0, pitch: 0.0, heading });
            continue;
        }
        let euler = euler_of(&x, &lift, attack_rad).ok_or_else(|| {
            let rule = Rule::Sentence(
                "the path is inverted or nearly without load then, and a coordinated attitude is not defined: give the attitude",
            );
            Error::of(ErrorKind::Discontinuity, "sample.time_s", time_s(k), rule)
        })?;
        let share = (speed / SLOW_M_S - 1.0).min(1.0);
        let heading = if is_on_course { euler.heading } else { heading };
        eulers.push(Euler { roll: share * euler.roll, pitch: share * euler.pitch, heading });
    }
    if let Some((first, heading)) = first_moving {
        eulers[..first].iter_mut().for_each(|euler| euler.heading = heading);
    }
    let mut values: Vec<[f64; 4]> = room(count + 1)?;
    for euler in &eulers {
        let numbers = numbers_of(euler);
        let is_opposite = values
            .last()
            .is_some_and(|last| last.iter().zip(&numbers).map(|(a, b)| a * b).sum::<f64>() < 0.0);
        values.push(if is_opposite { numbers.map(|number| -number) } else { numbers });
    }
    let cap_hz = path.normals.cutoff_hz.min(CUTOFF_HZ);
    Curve::through(&Samples { times_s: &times_s, values: &values, sigma: None, cap_hz, step: 0.0 })
}

/// Direction of a vector from north, clockwise [rad].
fn course(v: &Vector3<f64>) -> f64 {
    let angle = atan2(v.x, v.y);
    if angle < 0.0 { angle + 2.0 * PI } else { angle }
}

/// Attitude of a flight along the unit vector `x` with the specific force `lift` across it, both east, north, up; `None`: it is not
/// defined.
fn euler_of(x: &Vector3<f64>, lift: &Vector3<f64>, attack_rad: f64) -> Option<Euler> {
    let load = lift.norm_squared().sqrt();
    let z = -lift / load;
    if load < LEAST_LOAD * G || z.z > 0.0 {
        return None;
    }
    let y = z.cross(x);
    let (sine, cosine) = sin_cos(attack_rad);
    let (forward, down) = (x * cosine - z * sine, z * cosine + x * sine);
    Some(Euler {
        roll: atan2(-y.z, -down.z),
        pitch: asin(forward.z.clamp(-1.0, 1.0)),
        heading: course(&forward),
    })
}
