//! The body parts of an update of many runs, between the loops over a batch.

use nalgebra::{Vector3, Vector4};

use super::{BodyMotion, MAX_SUBSAMPLES, Scheme};
use crate::base::math::{Compensated, RotationSeries, quarter_square};
use crate::signal::{Increment, IncrementRows, RUNS, Row, increment_of, put_vectors, vectors_of};

/// The numbers of the navigators of a batch: those of [`Sums`], then one or two of the frame's own.
pub(super) type AxesRows = [Row; 25];

/// What the navigators of both frames sum up, and the acceleration of their last update.
pub(super) struct Sums {
    pub place: Compensated<3>,
    pub velocity: Compensated<3>,
    pub attitude: Compensated<4>,
    pub acceleration: Vector3<f64>,
}

impl Sums {
    /// The numbers at `lane`.
    #[inline(always)]
    pub fn of_rows(rows: &AxesRows, lane: usize) -> Self {
        let [place, place_carry, velocity, velocity_carry, acceleration] = vectors_of(rows, lane);
        let [attitude, attitude_carry] =
            [15, 19].map(|first: usize| Vector4::from_fn(|i, _| rows[first + i][lane]));
        Self {
            place: Compensated { value: place, carry: place_carry },
            velocity: Compensated { value: velocity, carry: velocity_carry },
            attitude: Compensated { value: attitude, carry: attitude_carry },
            acceleration,
        }
    }

    /// Stores the numbers at `lane`.
    #[inline(always)]
    pub fn put_into(&self, rows: &mut AxesRows, lane: usize) {
        let Self { place, velocity, attitude, acceleration } = self;
        put_vectors(rows, lane, [&place.value, &place.carry, &velocity.value, &velocity.carry, acceleration]);
        for i in 0..4 {
            rows[15 + i][lane] = attitude.value[i];
            rows[19 + i][lane] = attitude.carry[i];
        }
    }
}

/// Memory for values between the loops over a batch.
#[derive(Debug)]
pub(crate) struct Scratch {
    pub(super) bodies: Bodies,
    /// Start of an update that is not the first of its interval.
    pub(super) start: AxesRows,
}

impl Scratch {
    pub const NONE: Self =
        Self { bodies: Bodies { body: [[0.0; RUNS]; 12], is_left: [0; RUNS] }, start: [[0.0; RUNS]; 25] };
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
        put_vectors(&mut self.body, lane, [&body.rotation, &body.s1, &body.s2, &body.s3]);
    }

    #[inline(always)]
    pub(super) fn body(&self, lane: usize) -> BodyMotion {
        let [rotation, s1, s2, s3] = vectors_of(&self.body, lane);
        BodyMotion { rotation, s1, s2, s3 }
    }

    /// Body parts of an update of `K` subsamples, without branches. Returns whether all rotations are short; otherwise the body parts must
    /// not be used.
    #[inline(always)]
    pub(super) fn branchless<const K: usize>(&mut self, update: &[IncrementRows]) -> bool {
        let Some(update) = update.first_chunk::<K>() else { return false };
        let mut is_any_long = 0;
        for lane in 0..RUNS {
            let increments: [Increment; K] = core::array::from_fn(|k| increment_of(&update[k], lane));
            let (body, [angle2, quarter2]) = BodyMotion::exact_by::<true>(&increments);
            self.put_body(lane, &body);
            let are_short = RotationSeries::is_short(angle2) & RotationSeries::is_short(quarter2);
            is_any_long |= u64::from(!are_short);
        }
        is_any_long == 0
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

    /// Whether the rotation of each body part is short.
    pub(super) fn are_short(&self) -> bool {
        (0..RUNS).all(|lane| RotationSeries::is_short(quarter_square(&self.body(lane).rotation)))
    }
}
