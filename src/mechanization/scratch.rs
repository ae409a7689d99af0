//! The body parts of an update of many runs, between the loops over a block.

use nalgebra::Vector3;

use super::branches::Usual;
use super::earth_fixed::EarthFixed;
use super::{BodyMotion, MAX_SUBSAMPLES, Scheme};
use crate::math::RotationSeries;
use crate::signal::{Increment, IncrementRows, RUNS, Row, increment_of};

/// The numbers of the navigators of a block.
pub(super) type AxesRows = [Row; EarthFixed::NUMBERS];

/// Memory for values between the loops over a block.
#[derive(Debug)]
pub(crate) struct Scratch {
    pub(super) bodies: Bodies,
    /// Start of an update that is not the first of its interval.
    pub(super) start: AxesRows,
}

impl Scratch {
    pub const NONE: Self = Self {
        bodies: Bodies { body: [[0.0; RUNS]; 12], is_left: [0; RUNS] },
        start: [[0.0; RUNS]; EarthFixed::NUMBERS],
    };
}

/// The body parts, and the runs whose attitude is left to be renormalized.
#[derive(Debug)]
#[repr(align(64))]
pub(super) struct Bodies {
    body: [Row; 12],
    pub(super) is_left: [u64; RUNS],
}

impl Bodies {
    #[inline(always)]
    fn put_body(&mut self, lane: usize, body: &BodyMotion) {
        let BodyMotion { rotation, s1, s2, s3 } = body;
        for i in 0..3 {
            self.body[i][lane] = rotation[i];
            self.body[3 + i][lane] = s1[i];
            self.body[6 + i][lane] = s2[i];
            self.body[9 + i][lane] = s3[i];
        }
    }

    #[inline(always)]
    pub(super) fn body(&self, lane: usize) -> BodyMotion {
        let vector = |first: usize| Vector3::from_fn(|i, _| self.body[first + i][lane]);
        BodyMotion { rotation: vector(0), s1: vector(3), s2: vector(6), s3: vector(9) }
    }

    /// Body parts of an update of `K` subsamples. Returns whether all are usual; otherwise they must not be used.
    #[inline(always)]
    pub(super) fn of_usual<const K: usize>(&mut self, update: &[IncrementRows]) -> bool {
        let Some(update) = update.first_chunk::<K>() else { return false };
        let mut unusual = 0;
        for lane in 0..RUNS {
            let increments: [Increment; K] = core::array::from_fn(|k| increment_of(&update[k], lane));
            let (body, [angle2, quarter2]) = BodyMotion::exact_by(&increments, Usual);
            self.put_body(lane, &body);
            let is_usual = RotationSeries::is_short(angle2) & RotationSeries::is_short(quarter2);
            unusual |= u64::from(!is_usual);
        }
        unusual == 0
    }

    /// Body parts of any scheme.
    #[inline(never)]
    pub(super) fn one_by_one(&mut self, scheme: Scheme, update: &[IncrementRows]) {
        let mut increments = [Increment::ZERO; MAX_SUBSAMPLES];
        let increments = &mut increments[..update.len()];
        for lane in 0..RUNS {
            for (increment, rows) in increments.iter_mut().zip(update) {
                *increment = increment_of(rows, lane);
            }
            self.put_body(lane, &BodyMotion::of(scheme, increments));
        }
    }

    /// Whether an update by each of the body parts is usual.
    pub(super) fn are_usual(&self) -> bool {
        (0..RUNS).all(|lane| RotationSeries::is_short(crate::math::quarter_square(&self.body(lane).rotation)))
    }
}
