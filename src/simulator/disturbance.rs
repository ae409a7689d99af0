//! Gravity beyond the normal field in flight, as perfect accelerometers sense it.

use nalgebra::Vector3;

use crate::base::math::GAUSS_2;
use crate::base::snapshot::{SIGNALS, stored};
use crate::earth::Earth;
use crate::errors::SensorErrors;
use crate::sensors::GravityDisturbance;
use crate::signal::mounting::Block;
use crate::signal::{Increment, IntervalMotion};
use crate::truth::Recent;

/// True less normal gravity δg along the flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Disturbance {
    /// δg at the last sample, Earth-fixed axes [m/s²].
    at_last_e: Vector3<f64>,
    /// Apparent sensor errors in the last interval.
    apparent: SensorErrors,
}

stored!(Disturbance { at_last_e: SIGNALS } rebuilt { apparent });

impl Disturbance {
    /// Starts with `at_first_e` [m/s²].
    pub const fn new(at_first_e: Vector3<f64>) -> Self {
        Self { at_last_e: at_first_e, apparent: SensorErrors::NONE }
    }

    /// δg at the last sample, Earth-fixed axes [m/s²].
    pub fn at_last_e(&self) -> &Vector3<f64> {
        &self.at_last_e
    }

    /// Moves `gravity` on over the interval of `motion`, the last of `recent`, and then acts as [`Self::advance`].
    pub fn fly(
        &mut self,
        earth: &Earth,
        recent: &Recent<'_>,
        motion: &IntervalMotion<'_>,
        block: Option<&Block>,
        gravity: &mut GravityDisturbance,
        increments: &mut [Increment],
    ) {
        gravity.advance(earth, recent.current, recent.next);
        self.advance(gravity.at(earth, recent.next), motion, block, increments);
    }

    /// Adds -∫ Cᵀ δg dt to the velocity of each of `increments`, over the interval of `motion`. δg changes linearly to
    /// `at_next_e` [m/s²] at the end of the interval. With a mounting, the increments are those of `block`.
    fn advance(
        &mut self,
        at_next_e: Vector3<f64>,
        motion: &IntervalMotion<'_>,
        block: Option<&Block>,
        increments: &mut [Increment],
    ) {
        let part = 1.0 / increments.len() as f64;
        let half_dt = 0.5 * motion.interval_s * part;
        let change_e = at_next_e - self.at_last_e;
        let sensed = increments.iter_mut().enumerate().map(|(m, increment)| {
            // With two nodes in each increment, the relative error is θ⁴/4320 at a rotation θ [rad].
            let sensed_b = GAUSS_2.iter().fold(Vector3::zeros(), |sum, (node, _)| {
                let u = (m as f64 + node) * part;
                sum - motion.to_earth(u).tr_mul(&(self.at_last_e + change_e * u)) * half_dt
            });
            let velocity = block.map_or(sensed_b, |block| block.in_block_axes(&sensed_b));
            increment.velocity += velocity;
            Increment { velocity, ..Increment::ZERO }
        });
        self.apparent = SensorErrors::of_increments(sensed, motion.interval_s);
        self.at_last_e = at_next_e;
    }

    /// Errors that the sensors seem to have in the last interval, for an INS that computes with normal gravity.
    pub fn apparent_errors(&self) -> &SensorErrors {
        &self.apparent
    }
}
