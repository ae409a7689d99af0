//! Embedded flights: a list of manoeuvres that makes an analytic trajectory.
//!
//! Speed, climb angle, course and bank are closed forms of time, smooth to the third derivative; position is their
//! integral over the ellipsoid, held as piecewise Chebyshev series that are exact to rounding. Courses are kept against
//! axes that are carried along without turning (wander azimuth): straight flight is a geodesic and no pole is singular.

mod manoeuvre;
mod path;
mod profile;
mod steps;
mod table;

pub(crate) use manoeuvre::ManoeuvreFields;
pub use manoeuvre::{Channel, MAX_SINUSOIDS, Manoeuvre, Sinusoid, Sinusoids};
pub use table::START;

use nalgebra::Quaternion;

use crate::base::error::{Error, check_range};
use crate::base::math::{Euler, atan2, attitude_from_euler, euler_from_attitude, hypot, rotate, rotated_z};
use crate::base::memory::room;
use crate::base::rows::check;
use crate::base::snapshot::stored;
use crate::earth::{Earth, Ellipsoid, Geodetic, GravityModel, navigation_axes};
use crate::truth::FlightSample;
use path::Path;
use profile::Segment;

// The start of a flight with its checks and numbers, which build.rs writes from the table.
include!(concat!(env!("OUT_DIR"), "/start.rs"));

/// Largest number of manoeuvres in a flight.
pub const MAX_MANOEUVRES: usize = 4096;

/// A trajectory.
#[derive(Debug, Clone)]
pub struct Flight {
    segments: Vec<Segment>,
    path: Path,
    duration_s: f64,
    /// Attitude of the body against the path's axes.
    body_attitude: Quaternion<f64>,
}

impl Flight {
    /// The flight from `start` through `manoeuvres`. The call takes about a millisecond for each minute of turning flight.
    pub fn new(start: &FlightStart, manoeuvres: &[Manoeuvre]) -> Result<Self, Error> {
        let (segments, duration_s) = segments(start, manoeuvres)?;
        let earth = Earth::new(start.ellipsoid, GravityModel::Normal);
        let path = Path::integrate(&earth, start, &segments)?;
        let body_attitude =
            attitude_from_euler(&Euler { roll: start.roll_rad, pitch: start.pitch_rad, heading: 0.0 });
        Ok(Self { segments, path, duration_s, body_attitude })
    }

    /// Length [s] of the flight that [`Self::new`] would make, checked but not integrated.
    pub fn length_s(start: &FlightStart, manoeuvres: &[Manoeuvre]) -> Result<f64, Error> {
        segments(start, manoeuvres).map(|(_, duration_s)| duration_s)
    }

    /// Length of the flight [s].
    pub fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// The sample at `time_s` [s] since the start, 0 to the duration. Times that are outside only by a host's rounding are accepted.
    pub fn sample_at(&self, time_s: f64) -> Result<FlightSample, Error> {
        let rounding = 1e-9 + 1e-12 * self.duration_s;
        if !(-rounding..=self.duration_s + rounding).contains(&time_s) {
            check_range("time_s", time_s, 0.0, self.duration_s)?;
        }
        let time_s = time_s.clamp(0.0, self.duration_s);
        let segment = &self.segments[self.segments.partition_point(|s| s.end_s() < time_s)];
        let motion = segment.at(time_s);
        let (q_ew, height_m) = self.path.at(time_s);
        let up = rotated_z(&q_ew);
        let place = Geodetic {
            latitude_rad: atan2(up.z, hypot(up.x, up.y)),
            longitude_rad: atan2(up.y, up.x),
            height_m,
        };
        let q_nw = navigation_axes(place.latitude_rad, place.longitude_rad).conjugate() * q_ew;
        let q_nb = q_nw * motion.attitude() * self.body_attitude;
        Ok(FlightSample {
            time_s,
            place,
            v_n: Some(rotate(&q_nw, &motion.velocity())),
            euler: euler_from_attitude(&q_nb),
            omega_ib_b: None,
            f_b: None,
            temperature_c: None,
        })
    }
}

/// The manoeuvres in time, each with the speed and the course at the end of the one before, and their total length [s].
fn segments(start: &FlightStart, manoeuvres: &[Manoeuvre]) -> Result<(Vec<Segment>, f64), Error> {
    start.validate()?;
    check_range("manoeuvres", manoeuvres.len() as f64, 1.0, MAX_MANOEUVRES as f64)?;
    let mut segments = room(manoeuvres.len())?;
    let mut duration_s = 0.0;
    // Course 0 of the carried axes is true north at the start.
    let mut speed_m_s = start.speed_m_s;
    let mut course_rad = start.heading_rad;
    for (index, manoeuvre) in manoeuvres.iter().enumerate() {
        let segment = Segment::new(manoeuvre, duration_s, speed_m_s, course_rad).map_err(|e| e.at(index))?;
        duration_s = segment.end_s();
        (speed_m_s, course_rad) = segment.leaves();
        segments.push(segment);
    }
    check_range("duration of the flight [s]", duration_s, 0.0, 1e8)?;
    Ok((segments, duration_s))
}
