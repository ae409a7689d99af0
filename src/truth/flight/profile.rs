//! Speed, climb angle, course and attitude of a manoeuvre as functions of time.

use core::f64::consts::TAU;

use nalgebra::{Quaternion, Vector3};

use super::manoeuvre::{Channel, Manoeuvre, Sinusoid};
use super::steps::{Window, step};
use crate::base::error::Error;
use crate::base::math::{Euler, asin, atan, attitude_from_euler, sin_cos, tan};
use crate::base::units::STANDARD_GRAVITY;

/// Gravity with which the bank of a coordinated turn is computed [m/s²].
const G: f64 = STANDARD_GRAVITY;

/// Motion along the path at an instant, in the carried axes x, y, z up; course 0 along y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kinematics {
    pub speed_m_s: f64,
    pub climb_rad: f64,
    pub course_rad: f64,
    /// Attitude of the path's body axes.
    pub euler: Euler,
}

impl Kinematics {
    /// Velocity [m/s] in the carried axes.
    pub fn velocity(&self) -> Vector3<f64> {
        let (sin_climb, cos_climb) = sin_cos(self.climb_rad);
        let (sin_course, cos_course) = sin_cos(self.course_rad);
        Vector3::new(cos_climb * sin_course, cos_climb * cos_course, sin_climb) * self.speed_m_s
    }

    /// Rotates body axes right-forward-up to the carried axes.
    pub fn attitude(&self) -> Quaternion<f64> {
        attitude_from_euler(&self.euler)
    }

    /// Body along the path, banked by `roll`.
    fn along(speed_m_s: f64, climb_rad: f64, course_rad: f64, roll: f64) -> Self {
        Self {
            speed_m_s,
            climb_rad,
            course_rad,
            euler: Euler { roll, pitch: climb_rad, heading: course_rad },
        }
    }
}

/// A manoeuvre at its place in the flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Segment {
    manoeuvre: Manoeuvre,
    pub start_s: f64,
    window: Window,
    /// Speed [m/s] and course [rad] at its start.
    speed_m_s: f64,
    course_rad: f64,
}

impl Segment {
    pub fn new(manoeuvre: &Manoeuvre, start_s: f64, speed_m_s: f64, course_rad: f64) -> Result<Self, Error> {
        manoeuvre.validate(speed_m_s)?;
        let window = match *manoeuvre {
            Manoeuvre::Rest { duration_s }
            | Manoeuvre::Straight { duration_s }
            | Manoeuvre::Accelerate { duration_s, .. }
            | Manoeuvre::Roll { duration_s, .. } => Window::new(duration_s, duration_s),
            Manoeuvre::Climb { duration_s, ramp_s, .. }
            | Manoeuvre::Loop { duration_s, ramp_s, .. }
            | Manoeuvre::STurn { duration_s, ramp_s, .. }
            | Manoeuvre::Sinusoids { duration_s, ramp_s, .. } => Window::new(duration_s, ramp_s),
            Manoeuvre::Turn { heading_change_rad, bank_rad, ramp_s } => {
                let steady_s = heading_change_rad.abs() * speed_m_s / (G * tan(bank_rad));
                Window::new((steady_s + ramp_s).max(2.0 * ramp_s), ramp_s)
            }
        };
        Ok(Self { manoeuvre: *manoeuvre, start_s, window, speed_m_s, course_rad })
    }

    pub fn end_s(&self) -> f64 {
        self.start_s + self.window.length
    }

    /// Times since its start between which the functions are analytic [s].
    pub fn knots(&self) -> [f64; 4] {
        let Window { length, ramp } = self.window;
        [0.0, ramp, length - ramp, length]
    }

    /// Whether it is at rest.
    pub fn is_rest(&self) -> bool {
        matches!(self.manoeuvre, Manoeuvre::Rest { .. })
    }

    /// Speed and course at its end.
    pub fn leaves(&self) -> (f64, f64) {
        let course_rad = match self.manoeuvre {
            Manoeuvre::Turn { heading_change_rad, .. } => self.course_rad + heading_change_rad,
            _ => self.course_rad,
        };
        (self.manoeuvre.speed_after(self.speed_m_s), course_rad)
    }

    /// The motion at `time_s` of the flight.
    pub fn at(&self, time_s: f64) -> Kinematics {
        let window = &self.window;
        let t = time_s - self.start_s;
        let u = t / window.length;
        let (v, course) = (self.speed_m_s, self.course_rad);
        match &self.manoeuvre {
            Manoeuvre::Rest { .. } | Manoeuvre::Straight { .. } => Kinematics::along(v, 0.0, course, 0.0),
            Manoeuvre::Accelerate { speed_change_m_s, .. } => {
                Kinematics::along(v + speed_change_m_s * step(u), 0.0, course, 0.0)
            }
            Manoeuvre::Climb { height_change_m, .. } => {
                let climb_rate = height_change_m / window.whole() * window.at(t);
                Kinematics::along(v, asin(climb_rate / v), course, 0.0)
            }
            Manoeuvre::Turn { heading_change_rad, .. } => {
                let rate = heading_change_rad / window.whole();
                let course = course + rate * window.integral(t);
                Kinematics::along(v, 0.0, course, coordinated_bank(v, rate * window.at(t)))
            }
            Manoeuvre::Roll { turns, .. } => Kinematics::along(v, 0.0, course, TAU * turns * step(u)),
            Manoeuvre::Loop { turns, .. } => {
                let climb = TAU * turns / window.whole() * window.integral(t);
                Kinematics::along(v, climb, course, 0.0)
            }
            Manoeuvre::STurn { heading_change_rad, turns, .. } => {
                let swing = Sinusoid {
                    channel: Channel::Course,
                    amplitude: *heading_change_rad,
                    frequency_hz: turns / window.length,
                    phase_rad: 0.0,
                };
                self.sum_of_sinusoids(t, &[swing])
            }
            Manoeuvre::Sinusoids { sinusoids, .. } => self.sum_of_sinusoids(t, sinusoids.terms()),
        }
    }

    fn sum_of_sinusoids(&self, t: f64, terms: &[Sinusoid]) -> Kinematics {
        let (window, slope) = (self.window.at(t), self.window.slope(t));
        let mut speed = self.speed_m_s;
        let (mut climb, mut course, mut course_rate) = (0.0, self.course_rad, 0.0);
        let mut alone = Euler::default();
        for term in terms {
            let omega = TAU * term.frequency_hz;
            let (sin, cos) = sin_cos(omega * t + term.phase_rad);
            let value = term.amplitude * window * sin;
            match term.channel {
                Channel::Course => {
                    course += value;
                    course_rate += term.amplitude * (slope * sin + window * omega * cos);
                }
                Channel::Climb => climb += value,
                Channel::Speed => speed += value,
                Channel::Roll => alone.roll += value,
                Channel::Pitch => alone.pitch += value,
                Channel::Heading => alone.heading += value,
            }
        }
        let mut motion = Kinematics::along(speed, climb, course, coordinated_bank(speed, course_rate));
        motion.euler.roll += alone.roll;
        motion.euler.pitch += alone.pitch;
        motion.euler.heading += alone.heading;
        motion
    }
}

/// tan(bank) = v · turn rate / g.
fn coordinated_bank(speed_m_s: f64, turn_rate: f64) -> f64 {
    atan(speed_m_s * turn_rate / G)
}
