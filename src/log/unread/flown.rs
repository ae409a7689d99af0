//! What flies, at the times of the rows.

use crate::base::math::wrap_angle;
use crate::base::units::DEG;
use crate::truth::FlightSample;

/// The samples that fly.
pub struct Flown<'s> {
    samples: &'s [FlightSample],
    /// Whether their attitude is that of the log.
    pub has_attitude: bool,
}

/// A place in degrees, the height [m] and the heading [rad].
#[derive(Debug, Clone, Copy)]
pub struct There {
    pub latitude: f64,
    pub longitude: f64,
    pub height_m: f64,
    pub heading: f64,
}

impl<'s> Flown<'s> {
    pub fn new(samples: &'s [FlightSample], has_attitude: bool) -> Self {
        Self { samples, has_attitude }
    }

    /// What flies at a time between the samples; `None`: nothing does.
    pub fn at(&self, time_s: f64) -> Option<There> {
        let behind = self.samples.partition_point(|sample| sample.time_s < time_s);
        let b = self.samples.get(behind)?;
        let a = match behind.checked_sub(1) {
            Some(before) => &self.samples[before],
            None if b.time_s == time_s => b,
            None => return None,
        };
        let interval_s = b.time_s - a.time_s;
        let part = if interval_s > 0.0 { (time_s - a.time_s) / interval_s } else { 0.0 };
        let between = |a: f64, b: f64| a + part * (b - a);
        let turned = |a: f64, b: f64| a + part * wrap_angle(b - a);
        Some(There {
            latitude: between(a.place.latitude_rad, b.place.latitude_rad) / DEG,
            longitude: turned(a.place.longitude_rad, b.place.longitude_rad) / DEG,
            height_m: between(a.place.height_m, b.place.height_m),
            heading: turned(a.euler.heading, b.euler.heading),
        })
    }
}
