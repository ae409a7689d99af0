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

use core::slice::ChunksExact;

use super::branches::{Any, Usual};
use super::earth_fixed::EarthFixed;
use super::geographic::Geographic;
use super::limits::WELL_WITHIN_M;
use super::scratch::Scratch;
use super::{
    Frame, FrameState, MAX_SUBSAMPLES, Mechanization, Scheme, Solution, VerticalAid, VerticalCorrection,
    VerticalRows,
};
use crate::earth::{Earth, GravityModel};
use crate::signal::{Increment, IncrementRows, RUNS, Row, increment_of};

/// Navigators of one frame that get the same intervals.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(crate) struct NavigatorBlock {
    frame: Frame,
    axes: [Row; EarthFixed::NUMBERS],
    vertical: VerticalRows,
}

/// What the vertical channels of a block are told.
#[derive(Debug, Clone, Copy)]
pub(crate) enum AidOfEach<'a> {
    /// All the same: nothing, or the truth.
    Same(VerticalAid),
    /// A barometric height each [m].
    Barometer { heights_m: &'a Row },
    /// A barometric height [m], or none.
    Some { heights_m: &'a Row, is_none: &'a [bool; RUNS] },
}

impl AidOfEach<'_> {
    /// That of the run at `lane`.
    #[inline(always)]
    pub fn at(&self, lane: usize) -> VerticalAid {
        match *self {
            Self::Same(aid) => aid,
            Self::Some { is_none, .. } if is_none[lane] => VerticalAid::None,
            Self::Barometer { heights_m } | Self::Some { heights_m, .. } => {
                VerticalAid::Barometer { height_m: heights_m[lane] }
            }
        }
    }
}

impl NavigatorBlock {
    /// A block of navigators that nothing is known of yet.
    pub fn new(frame: Frame) -> Self {
        Self { frame, axes: [[0.0; RUNS]; EarthFixed::NUMBERS], vertical: VerticalRows::new() }
    }

    /// Takes `navigator` in.
    pub fn put(&mut self, lane: usize, navigator: &Mechanization) {
        match &navigator.solution.axes {
            FrameState::EarthFixed(axes) => self.put_axes(lane, axes),
            FrameState::Geographic(axes) => axes.put_numbers(|i, number| self.axes[i][lane] = number),
        }
        self.vertical.put(lane, &navigator.solution.vertical);
    }

    /// The navigator at `lane`.
    pub fn get(&self, lane: usize, earth: &Earth, scheme: Scheme) -> Mechanization {
        let axes = match self.frame {
            Frame::EarthFixed => FrameState::EarthFixed(self.axes(lane)),
            Frame::Geographic => FrameState::Geographic(Geographic::from_numbers(|i| self.axes[i][lane])),
        };
        Mechanization {
            earth: *earth,
            scheme,
            solution: Solution { axes, vertical: self.vertical.get(lane) },
        }
    }

    /// Lets `act` act on one navigator after the other, of the first `count` runs.
    pub fn each(
        &mut self,
        (earth, scheme): (&Earth, Scheme),
        count: usize,
        mut act: impl FnMut(usize, &mut Mechanization),
    ) {
        for lane in 0..count.min(RUNS) {
            let mut navigator = self.get(lane, earth, scheme);
            act(lane, &mut navigator);
            self.put(lane, &navigator);
        }
    }

    /// The navigator at `lane` goes back to what it was in `before`.
    pub fn go_back(&mut self, lane: usize, before: &Self) {
        self.axes.iter_mut().zip(&before.axes).for_each(|(row, before)| row[lane] = before[lane]);
        self.vertical.go_back(lane, &before.vertical);
    }

    #[inline(always)]
    fn axes(&self, lane: usize) -> EarthFixed {
        EarthFixed::from_numbers(|i| self.axes[i][lane])
    }

    #[inline(always)]
    fn put_axes(&mut self, lane: usize, axes: &EarthFixed) {
        axes.put_numbers(|i, number| self.axes[i][lane] = number);
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
        if self.frame == Frame::Geographic {
            return self.navigate_one_by_one((earth, scheme), updates, update_s, count);
        }
        let is_always_usual = scheme != Scheme::Paper && earth.gravity_model == GravityModel::Normal;
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
            }
            if !is_always_usual || !(is_usual || scratch.are_usual(count)) {
                self.update_one_by_one((earth, scheme), update_s, count, scratch);
                continue;
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
    fn navigate_one_by_one(
        &mut self,
        kind: (&Earth, Scheme),
        updates: ChunksExact<'_, IncrementRows>,
        update_s: f64,
        count: usize,
    ) {
        let mut increments = [Increment::ZERO; MAX_SUBSAMPLES];
        self.each(kind, count, |lane, navigator| {
            for update in updates.clone() {
                let increments = &mut increments[..update.len()];
                increments.iter_mut().zip(update).for_each(|(one, rows)| *one = increment_of(rows, lane));
                navigator.update(increments, update_s);
            }
        });
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
        (earth, scheme): (&Earth, Scheme),
        aid: &AidOfEach<'_>,
        t: f64,
        count: usize,
        is_good: &mut [u64; RUNS],
    ) {
        match *aid {
            _ if self.frame == Frame::Geographic || !self.vertical.are_alike(count) => {
                self.aid_one_by_one((earth, scheme), aid, t, count);
            }
            AidOfEach::Some { .. } => self.aid_one_by_one((earth, scheme), aid, t, count),
            AidOfEach::Same(VerticalAid::None) => self.vertical.skip(),
            AidOfEach::Same(VerticalAid::Truth { height_m, velocity_up_m_s }) => {
                self.shift_vertical(earth, count, |_, _, height, velocity_up| {
                    VerticalCorrection::to_truth(height_m - height, velocity_up_m_s - velocity_up, t)
                });
            }
            AidOfEach::Same(VerticalAid::Barometer { height_m }) => {
                self.follow(earth, t, count, |_| height_m);
            }
            AidOfEach::Barometer { heights_m } => self.follow(earth, t, count, |lane| heights_m[lane]),
        }
        let is_earth_fixed = self.frame == Frame::EarthFixed;
        for lane in 0..count.min(RUNS) {
            is_good[lane] = u64::from(is_earth_fixed & self.axes(lane).is_far_within(WELL_WITHIN_M));
        }
    }

    #[cold]
    #[inline(never)]
    fn aid_one_by_one(&mut self, kind: (&Earth, Scheme), aid: &AidOfEach<'_>, t: f64, count: usize) {
        self.each(kind, count, |lane, navigator| navigator.aid_vertical(&aid.at(lane), t));
    }

    /// Keeps the vertical channels by barometric heights.
    #[inline(always)]
    fn follow(&mut self, earth: &Earth, t: f64, count: usize, height_m: impl Fn(usize) -> f64) {
        let beginning = self.vertical.begin(t);
        self.shift_vertical(earth, count, |vertical, lane, height, _| {
            vertical.answer(lane, height - height_m(lane), &beginning)
        });
    }

    #[inline(always)]
    fn shift_vertical(
        &mut self,
        earth: &Earth,
        count: usize,
        correct: impl Fn(&mut VerticalRows, usize, f64, f64) -> VerticalCorrection,
    ) {
        for lane in 0..count.min(RUNS) {
            let mut axes = self.axes(lane);
            let (up, height, velocity_up) = axes.observe_vertical(earth);
            let correction = correct(&mut self.vertical, lane, height, velocity_up);
            axes.shift_vertical(earth, &up, &correction);
            self.put_axes(lane, &axes);
        }
    }
}
