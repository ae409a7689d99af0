//! Many navigators side by side.
//!
//! A block keeps the same number of up to [`RUNS`] navigators in a row, and a loop over the row applies to each the formula of the
//! single navigator, inlined and with its rare branches decided beforehand ([`Usual`]). The compiler makes vector instructions of
//! such a loop, as wide as the function it is inlined into may use ([`crate::instruction_set`]); the bits are those of the single
//! navigator, as neither it nor the loop is allowed to fuse or to reorder operations.
//!
//! Tried, on the update in Earth-fixed axes without its rare branches (Cascade Lake, ns a run with SSE2, AVX2 and AVX-512; the single
//! navigator 125): such a loop 66, 39 and 28; lane types of `[f64; N]` under nalgebra's generic vectors 68, 39 and 27. The times are
//! the same. With lane types each formula has to be generic over its scalar, that of the single run too, and each constant in it
//! be spread; in a loop it is left as it reads, and any function that is inlined will do. Lane types of intrinsics were not tried:
//! an intrinsic is called through memory wherever a function of nalgebra in between is not inlined.
//!
//! What a loop needs: no call and no branch that is not a choice of two values; what it reads besides its rows by value; the rows it
//! reads and those it writes in allocations of their own, or behind references of a function. Where one of these is missed it is
//! computed run by run, to the same bits: `benches/src/ensemble.rs` shows it.

#![expect(clippy::needless_range_loop, reason = "a lane goes through many rows")]

use nalgebra::Vector3;

use super::branches::{Any, Usual};
use super::earth_fixed::EarthFixed;
use super::{
    Axes, BodyMotion, MAX_SUBSAMPLES, Mechanization, Scheme, Solution, VerticalCorrection, VerticalLoop,
};
use crate::earth::{Earth, GravityModel};
use crate::math::RotationSeries;
use crate::mechanization::{Frame, WELL_WITHIN_M};
use crate::signal::{Increment, IncrementRows, RUNS, increment_of};

/// Whether navigators of these kinds go into a block.
pub(crate) fn is_for_lanes(frame: Frame, gravity: GravityModel) -> bool {
    frame == Frame::EarthFixed && gravity == GravityModel::Normal
}

/// Navigators in Earth-fixed axes that get the same intervals.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(crate) struct NavigatorBlock {
    axes: [[f64; RUNS]; EarthFixed::NUMBERS],
    bias_m_s2: [f64; RUNS],
    residual_m: [f64; RUNS],
    /// What the vertical channels share: the interval and its gains.
    vertical: VerticalLoop,
}

/// What the vertical channels of a block are told.
pub(crate) enum AidOfEach<'a> {
    /// Nothing.
    None,
    /// The truth: height [m] and velocity up [m/s].
    Truth { height_m: f64, velocity_up_m_s: f64 },
    /// A barometric height each [m].
    Barometer { heights_m: &'a [f64; RUNS] },
}

/// What is needed between the loops over a block.
#[derive(Debug)]
#[repr(align(64))]
pub(crate) struct Scratch {
    body: [[f64; RUNS]; 12],
    is_left: [u64; RUNS],
}

impl Scratch {
    pub const NONE: Self = Self { body: [[0.0; RUNS]; 12], is_left: [0; RUNS] };

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
    fn body(&self, lane: usize) -> BodyMotion {
        let vector = |first: usize| Vector3::from_fn(|i, _| self.body[first + i][lane]);
        BodyMotion { rotation: vector(0), s1: vector(3), s2: vector(6), s3: vector(9) }
    }

    /// Body parts of an update of `K` subsamples; whether all are usual, else they are not to be used.
    #[inline(always)]
    fn bodies<const K: usize>(&mut self, update: &[IncrementRows], count: usize) -> bool {
        let Some(update) = update.first_chunk::<K>() else { return false };
        let mut unusual = 0;
        for lane in 0..count.min(RUNS) {
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
    fn bodies_one_by_one(&mut self, scheme: Scheme, update: &[IncrementRows], count: usize) {
        let mut increments = [Increment::ZERO; MAX_SUBSAMPLES];
        let increments = &mut increments[..update.len()];
        for lane in 0..count.min(RUNS) {
            for (increment, rows) in increments.iter_mut().zip(update) {
                *increment = increment_of(rows, lane);
            }
            self.put_body(lane, &BodyMotion::of(scheme, increments));
        }
    }

    /// Whether an update by each of the body parts is usual.
    fn are_usual(&self, count: usize) -> bool {
        (0..count.min(RUNS))
            .all(|lane| RotationSeries::is_short(crate::math::quarter_square(&self.body(lane).rotation)))
    }
}

impl NavigatorBlock {
    /// A block of navigators that nothing is known of yet.
    pub fn new() -> Self {
        Self {
            axes: [[0.0; RUNS]; EarthFixed::NUMBERS],
            bias_m_s2: [0.0; RUNS],
            residual_m: [0.0; RUNS],
            vertical: VerticalLoop::new(),
        }
    }

    /// Takes `navigator` in; the runs of a block have all come to the same interval.
    pub fn put(&mut self, lane: usize, navigator: &Mechanization) {
        if let Axes::EarthFixed(axes) = &navigator.solution.axes {
            self.put_axes(lane, axes);
        }
        self.vertical = navigator.solution.vertical;
        self.bias_m_s2[lane] = self.vertical.bias_m_s2;
        self.residual_m[lane] = self.vertical.residual_m;
    }

    /// The navigator at `lane`.
    pub fn get(&self, lane: usize, earth: &Earth, scheme: Scheme) -> Mechanization {
        let axes = Axes::EarthFixed(self.axes(lane));
        Mechanization { earth: *earth, scheme, solution: Solution { axes, vertical: self.vertical_at(lane) } }
    }

    /// The navigator at `lane` goes back to what it was in `before`.
    pub fn go_back(&mut self, lane: usize, before: &Self) {
        self.put_axes(lane, &before.axes(lane));
        self.bias_m_s2[lane] = before.bias_m_s2[lane];
        self.residual_m[lane] = before.residual_m[lane];
    }

    #[inline(always)]
    fn axes(&self, lane: usize) -> EarthFixed {
        EarthFixed::from_numbers(|i| self.axes[i][lane])
    }

    #[inline(always)]
    fn put_axes(&mut self, lane: usize, axes: &EarthFixed) {
        axes.put_numbers(|i, number| self.axes[i][lane] = number);
    }

    #[inline(always)]
    fn vertical_at(&self, lane: usize) -> VerticalLoop {
        self.vertical.with(self.bias_m_s2[lane], self.residual_m[lane])
    }

    /// Navigates the first `count` runs over an interval of length `t` [s], in updates of so many subsamples.
    #[inline(always)]
    pub fn navigate(
        &mut self,
        (earth, scheme): (&Earth, Scheme),
        subsamples: usize,
        measured: &[IncrementRows],
        t: f64,
        count: usize,
        scratch: &mut Scratch,
    ) {
        let updates = measured.chunks_exact(subsamples);
        let update_s = t / updates.len() as f64;
        let turn = EarthFixed::earth_turn(earth, update_s);
        for update in updates {
            let is_usual = match (scheme, subsamples) {
                (Scheme::Exact, 1) => scratch.bodies::<1>(update, count),
                (Scheme::Exact, 2) => scratch.bodies::<2>(update, count),
                (Scheme::Exact, 3) => scratch.bodies::<3>(update, count),
                _ => false,
            };
            if !is_usual {
                scratch.bodies_one_by_one(scheme, update, count);
                if scheme == Scheme::Paper || !scratch.are_usual(count) {
                    self.update_one_by_one((earth, scheme), update_s, count, scratch);
                    continue;
                }
            }
            let mut any_left = 0;
            for lane in 0..count.min(RUNS) {
                let mut axes = self.axes(lane);
                let is_left = u64::from(axes.update_by(earth, &scratch.body(lane), update_s, &turn, Usual));
                self.put_axes(lane, &axes);
                scratch.is_left[lane] = is_left;
                any_left |= is_left;
            }
            if any_left != 0 {
                self.renormalize(count, scratch);
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn renormalize(&mut self, count: usize, scratch: &Scratch) {
        for lane in (0..count.min(RUNS)).filter(|&lane| scratch.is_left[lane] != 0) {
            let mut axes = self.axes(lane);
            axes.renormalize();
            self.put_axes(lane, &axes);
        }
    }

    #[cold]
    #[inline(never)]
    fn update_one_by_one(
        &mut self,
        (earth, scheme): (&Earth, Scheme),
        t: f64,
        count: usize,
        scratch: &Scratch,
    ) {
        let turn = EarthFixed::earth_turn(earth, t);
        for lane in 0..count.min(RUNS) {
            let (mut axes, body) = (self.axes(lane), scratch.body(lane));
            match scheme {
                Scheme::Paper => axes.update_paper(earth, &body, t),
                _ => {
                    axes.update_by(earth, &body, t, &turn, Any);
                }
            }
            self.put_axes(lane, &axes);
        }
    }

    /// Keeps the vertical channels at the end of an interval of length `t` [s], and checks the solutions: whether each is far within
    /// its limits.
    #[inline(always)]
    pub fn aid_vertical(
        &mut self,
        earth: &Earth,
        aid: &AidOfEach<'_>,
        t: f64,
        count: usize,
        is_good: &mut [u64; RUNS],
    ) {
        match *aid {
            AidOfEach::None => {
                self.vertical.skip();
                for lane in 0..count.min(RUNS) {
                    is_good[lane] = u64::from(self.axes(lane).is_far_within(WELL_WITHIN_M));
                }
            }
            AidOfEach::Truth { height_m, velocity_up_m_s } => {
                self.shift_vertical(earth, count, is_good, |loop_, _, height, velocity_up| {
                    let _ = loop_;
                    VerticalCorrection::to_truth(height_m - height, velocity_up_m_s - velocity_up, t)
                });
            }
            AidOfEach::Barometer { heights_m } => {
                let is_first = self.vertical.begin(t);
                self.shift_vertical(earth, count, is_good, |vertical, lane, height, _| {
                    let residual_m = height - heights_m[lane];
                    vertical.residual_m = if is_first { residual_m } else { vertical.residual_m };
                    vertical.answer(residual_m)
                });
            }
        }
    }

    #[inline(always)]
    fn shift_vertical(
        &mut self,
        earth: &Earth,
        count: usize,
        is_good: &mut [u64; RUNS],
        correct: impl Fn(&mut VerticalLoop, usize, f64, f64) -> VerticalCorrection,
    ) {
        // By value, or the compiler fears that the rows lie over it.
        let shared = self.vertical;
        for lane in 0..count.min(RUNS) {
            let mut axes = self.axes(lane);
            let mut vertical = shared.with(self.bias_m_s2[lane], self.residual_m[lane]);
            let (up, height, velocity_up) = axes.observe_vertical(earth);
            let correction = correct(&mut vertical, lane, height, velocity_up);
            axes.shift_vertical(earth, &up, &correction);
            self.put_axes(lane, &axes);
            self.bias_m_s2[lane] = vertical.bias_m_s2;
            self.residual_m[lane] = vertical.residual_m;
            is_good[lane] = u64::from(axes.is_far_within(WELL_WITHIN_M));
        }
    }
}
