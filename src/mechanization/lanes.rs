//! Many navigators side by side.
//!
//! A batch stores each number of up to [`RUNS`] navigators in a row. A loop over the row applies the formula of the single
//! navigator to each element; the formula is inlined, and its rare branches are decided before the loop ([`super::branches`]). The compiler
//! vectorizes such a loop with the widest instructions that the surrounding function may use ([`crate::base::instruction_set`]). The bits
//! are those of the single navigator, because the compiler may not fuse or reorder operations in either.
//!
//! Evidence, for the update in Earth-fixed axes without its rare branches (Cascade Lake, ns a run with SSE2, AVX2 and AVX-512; the
//! single navigator takes 125): such a loop takes 66, 39 and 28; lane types of `[f64; N]` in nalgebra's generic vectors take 68, 39
//! and 27, which is the same. With lane types each formula, also that of the single run, would have to be generic over its scalar,
//! and each constant would have to be broadcast. In a loop the formula stays unchanged, and any inlined function can be used. Lane
//! types of intrinsics were not tried: an intrinsic passes its values through memory wherever a function of nalgebra is not
//! inlined.
//!
//! The single chain stays beside the ensembles. In a trial it was a batch of one, with the number of runs as a constant: the same bits,
//! but 5 % more instructions (11 % with sensors of navigation grade), and 1.06 to 1.08 of the time of simulation 2. It would save 200 to
//! 300 lines.
//!
//! A loop is vectorized if it has no call, and no branch except for a choice between two values; if it takes what it reads besides
//! its rows by value; and if the rows that it reads and the rows that it writes are separate allocations, or references that a
//! function takes. Otherwise it is computed run by run, to the same bits: `benches/src/ensemble.rs` shows it.

#![expect(clippy::needless_range_loop, reason = "a lane goes through many rows")]

use core::slice::ChunksExact;

use nalgebra::Vector3;

use super::earth_fixed::EarthFixed;
use super::geographic::Geographic;
use super::limits::WELL_WITHIN_M;
use super::scratch::{AxesRows, Bodies, Scratch};
use super::{
    AidOfEach, Frame, FrameState, MAX_SUBSAMPLES, Mechanization, MechanizationState, Scheme,
    VerticalCorrection, VerticalRows,
};
use crate::base::math::AxisTurn;
use crate::earth::{Earth, GravityModel};
use crate::signal::{Increment, IncrementRows, RUNS, increment_of};

/// Navigators of one frame that get the same intervals.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(crate) struct NavigatorBatch {
    frame: Frame,
    axes: AxesRows,
    vertical: VerticalRows,
}

impl NavigatorBatch {
    /// A batch of navigators without states.
    pub fn new(frame: Frame) -> Self {
        Self { frame, axes: [[0.0; RUNS]; 25], vertical: VerticalRows::new() }
    }

    /// Stores `navigator` at `lane`.
    pub fn put(&mut self, lane: usize, navigator: &Mechanization) {
        match &navigator.solution.axes {
            FrameState::EarthFixed(axes) => axes.put_into(&mut self.axes, lane),
            FrameState::Geographic(axes) => axes.put_into(&mut self.axes, lane),
        }
        self.vertical.put(lane, &navigator.solution.vertical);
    }

    /// The navigator at `lane`.
    pub fn get(&self, lane: usize, earth: &Earth, scheme: Scheme) -> Mechanization {
        let axes = match self.frame {
            Frame::EarthFixed => FrameState::EarthFixed(self.axes(lane)),
            Frame::Geographic => FrameState::Geographic(Geographic::of_rows(&self.axes, lane)),
        };
        Mechanization {
            earth: *earth,
            scheme,
            solution: MechanizationState { axes, vertical: self.vertical.get(lane) },
        }
    }

    /// Calls `act` with each navigator in turn.
    pub fn each(
        &mut self,
        (earth, scheme): (&Earth, Scheme),
        mut act: impl FnMut(usize, &mut Mechanization),
    ) {
        for lane in 0..RUNS {
            let mut navigator = self.get(lane, earth, scheme);
            act(lane, &mut navigator);
            self.put(lane, &navigator);
        }
    }

    /// Restores the navigator at `lane` from `before`.
    pub fn go_back(&mut self, lane: usize, before: &Self) {
        self.axes.iter_mut().zip(&before.axes).for_each(|(row, before)| row[lane] = before[lane]);
        self.vertical.go_back(lane, &before.vertical);
    }

    #[inline(always)]
    fn axes(&self, lane: usize) -> EarthFixed {
        EarthFixed::of_rows(&self.axes, lane)
    }

    /// Navigates the navigators `before`, with `shift_e` [m/s] more, over an interval of length `t` [s], in updates of `subsamples`
    /// subsamples. Overwrites this batch.
    #[inline(always)]
    pub fn navigate(
        &mut self,
        (before, shift_e): (&Self, Option<&Vector3<f64>>),
        (earth, scheme): (&Earth, Scheme),
        subsamples: usize,
        measured: &[IncrementRows],
        t: f64,
        scratch: &mut Scratch,
    ) {
        let updates = measured.chunks_exact(subsamples);
        let update_s = t / updates.len() as f64;
        let mut is_begun = shift_e.is_some() || self.frame == Frame::Geographic;
        if is_begun {
            self.clone_from(before);
            if let Some(shift_e) = shift_e {
                self.each((earth, scheme), |_, navigator| navigator.shift_velocity(shift_e));
            }
        } else {
            self.vertical.clone_from(&before.vertical);
        }
        if self.frame == Frame::Geographic {
            return self.navigate_one_by_one((earth, scheme), updates, update_s);
        }
        let Scratch { bodies, start } = scratch;
        let can_be_branchless = scheme != Scheme::Paper && earth.gravity_model == GravityModel::Normal;
        let turn = EarthFixed::earth_turn(earth, update_s);
        for update in updates {
            let are_short = match (scheme, subsamples) {
                (Scheme::Exact, 1) => bodies.branchless::<1>(update),
                (Scheme::Exact, 2) => bodies.branchless::<2>(update),
                (Scheme::Exact, 3) => bodies.branchless::<3>(update),
                _ => false,
            };
            if !are_short {
                bodies.one_by_one(scheme, update);
            }
            let is_first = !is_begun;
            is_begun = true;
            if !can_be_branchless || !(are_short || bodies.are_short()) {
                if is_first {
                    self.axes = before.axes;
                }
                self.update_one_by_one((earth, scheme), update_s, bodies);
                continue;
            }
            // Two calls: with one call on selected rows the compiler could not know that the rows do not overlap.
            let is_any_left = if is_first {
                update_branchless(&before.axes, &mut self.axes, bodies, earth, update_s, &turn)
            } else {
                *start = self.axes;
                update_branchless(start, &mut self.axes, bodies, earth, update_s, &turn)
            };
            if is_any_left {
                self.renormalize(bodies);
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
    ) {
        let mut increments = [Increment::ZERO; MAX_SUBSAMPLES];
        self.each(kind, |lane, navigator| {
            for update in updates.clone() {
                let increments = &mut increments[..update.len()];
                increments.iter_mut().zip(update).for_each(|(one, rows)| *one = increment_of(rows, lane));
                navigator.update(increments, update_s);
            }
        });
    }

    #[cold]
    #[inline(never)]
    fn renormalize(&mut self, bodies: &Bodies) {
        for lane in (0..RUNS).filter(|&lane| bodies.is_left[lane] != 0) {
            let mut axes = self.axes(lane);
            axes.renormalize();
            axes.put_into(&mut self.axes, lane);
        }
    }

    #[cold]
    #[inline(never)]
    fn update_one_by_one(&mut self, (earth, scheme): (&Earth, Scheme), t: f64, bodies: &Bodies) {
        let turn = EarthFixed::earth_turn(earth, t);
        for lane in 0..RUNS {
            let (mut axes, body) = (self.axes(lane), bodies.body(lane));
            match scheme {
                Scheme::Paper => axes.update_paper(earth, &body, t),
                _ => {
                    axes.update_by::<false>(earth, &body, t, &turn);
                }
            }
            axes.put_into(&mut self.axes, lane);
        }
    }

    /// Corrects the vertical channels at the end of an interval of length `t` [s], and checks the solutions. Returns whether each
    /// is far within its limits.
    #[inline(always)]
    pub fn aid_vertical(
        &mut self,
        (earth, scheme): (&Earth, Scheme),
        aid: &AidOfEach<'_>,
        t: f64,
        is_good: &mut [u64; RUNS],
    ) {
        match *aid {
            _ if self.frame == Frame::Geographic || !self.vertical.are_alike() => {
                self.aid_one_by_one((earth, scheme), aid, t);
            }
            AidOfEach::Some { .. } => self.aid_one_by_one((earth, scheme), aid, t),
            AidOfEach::None => self.vertical.skip(),
            AidOfEach::Truth { height_m, velocity_up_m_s } => {
                self.shift_vertical(earth, |_, _, height, velocity_up| {
                    VerticalCorrection::to_truth(height_m - height, velocity_up_m_s - velocity_up, t)
                });
            }
            AidOfEach::Barometer { heights_m } => {
                let beginning = self.vertical.begin(t);
                self.shift_vertical(earth, |vertical, lane, height, _| {
                    vertical.answer(lane, height - heights_m[lane], &beginning)
                });
            }
        }
        let is_earth_fixed = self.frame == Frame::EarthFixed;
        for lane in 0..RUNS {
            is_good[lane] = u64::from(is_earth_fixed & self.axes(lane).is_far_within(WELL_WITHIN_M));
        }
    }

    #[cold]
    #[inline(never)]
    fn aid_one_by_one(&mut self, kind: (&Earth, Scheme), aid: &AidOfEach<'_>, t: f64) {
        self.each(kind, |lane, navigator| navigator.aid_vertical(&aid.at(lane), t));
    }

    #[inline(always)]
    fn shift_vertical(
        &mut self,
        earth: &Earth,
        correct: impl Fn(&mut VerticalRows, usize, f64, f64) -> VerticalCorrection,
    ) {
        for lane in 0..RUNS {
            let mut axes = self.axes(lane);
            let (up, height, velocity_up) = axes.observe_vertical(earth);
            let correction = correct(&mut self.vertical, lane, height, velocity_up);
            axes.shift_vertical(earth, &up, &correction);
            axes.put_into(&mut self.axes, lane);
        }
    }
}

/// Updates each navigator from `start` into `end`. Returns whether an attitude is left to be renormalized. It is a function of its own
/// because its references tell the compiler that the rows do not overlap.
#[inline(always)]
fn update_branchless(
    start: &AxesRows,
    end: &mut AxesRows,
    bodies: &mut Bodies,
    earth: &Earth,
    t: f64,
    turn: &AxisTurn,
) -> bool {
    let mut any_left = 0;
    for lane in 0..RUNS {
        let mut axes = EarthFixed::of_rows(start, lane);
        let is_left = u64::from(axes.update_by::<true>(earth, &bodies.body(lane), t, turn));
        axes.put_into(end, lane);
        bodies.is_left[lane] = is_left;
        any_left |= is_left;
    }
    any_left != 0
}
