//! A sample with its displacement from the one before.

use nalgebra::Vector3;

use super::finding::At;
use crate::base::math::{Euler, hypot};
use crate::earth::{Earth, Geodetic};
use crate::truth::FlightSample;

/// A sample behind another one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub at: At,
    pub place: Geodetic,
    pub euler: Euler,
    pub v_n: Option<Vector3<f64>>,
    /// Time since the row before [s].
    pub interval_s: f64,
    /// Displacement since the row before, Earth-fixed axes [m]: regular at the poles and at the date line.
    pub d_e: Vector3<f64>,
    /// The same to the east, to the north, and of the height [m].
    pub d_n: Vector3<f64>,
    /// Unit vectors east, north and up, Earth-fixed axes.
    pub axes: [Vector3<f64>; 3],
    /// Whether latitude and longitude are exactly those of the row before.
    pub is_held: bool,
}

impl Row {
    /// The row of `sample`, number `row`, behind `last`.
    pub fn new(earth: &Earth, row: u64, sample: &FlightSample, last: &FlightSample) -> Self {
        let (place, before) = (sample.place, last.place);
        let (back, axes) = earth.displacement(&before, &place);
        let d_e = -back;
        let d_n = Vector3::new(d_e.dot(&axes[0]), d_e.dot(&axes[1]), place.height_m - before.height_m);
        let is_held =
            place.latitude_rad == before.latitude_rad && place.longitude_rad == before.longitude_rad;
        Self {
            at: At { row, time_s: sample.time_s },
            place,
            euler: sample.euler,
            v_n: sample.v_n,
            interval_s: sample.time_s - last.time_s,
            d_e,
            d_n,
            axes,
            is_held,
        }
    }

    /// Horizontal displacement since the row before [m].
    pub fn step_m(&self) -> f64 {
        hypot(self.d_n.x, self.d_n.y)
    }

    /// A vector in Earth-fixed axes, to the east, to the north and up.
    pub fn local(&self, v_e: &Vector3<f64>) -> Vector3<f64> {
        Vector3::new(v_e.dot(&self.axes[0]), v_e.dot(&self.axes[1]), v_e.dot(&self.axes[2]))
    }

    /// Velocity of the sample in Earth-fixed axes [m/s], if it has one.
    pub fn v_e(&self) -> Option<Vector3<f64>> {
        let [east, north, up] = &self.axes;
        self.v_n.map(|v| east * v.x + north * v.y + up * v.z)
    }
}
