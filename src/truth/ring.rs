//! The last points taken in: those that wait for a step, and those before them that a stencil still looks back to.

use super::TruthPoint;
use crate::base::error::Error;
use crate::base::memory::filled;

/// Samples that may wait for a step.
pub const QUEUE_CAPACITY: usize = 16;

/// Points before the queue that are still needed: the current one and two before it.
pub(super) const LOOK_BACK: usize = 3;

/// A power of two that has room for a full queue and the points before it.
const RING: usize = 32;

/// Points in the order in which they came, in memory of fixed size. It is on the heap, because 13 KB are much for a stack.
#[derive(Debug, Clone)]
pub(super) struct Ring {
    points: Box<[Option<TruthPoint>; RING]>,
    /// A counter of 64 bits, because one of 32 bits would overflow in a long run.
    pushed: u64,
    taken: u64,
}

/// The point that ends an interval and the ones before it.
#[derive(Debug, Clone, Copy)]
pub struct Recent<'a> {
    /// The point at the end.
    pub next: &'a TruthPoint,
    /// The point at the start.
    pub current: &'a TruthPoint,
    /// The two points before that, newest first; `None` before the start or the last reposition.
    pub before: [Option<&'a TruthPoint>; 2],
}

impl Recent<'_> {
    /// [`TruthPoint::gap_ratio`] of the interval.
    #[inline]
    pub(crate) fn gap_ratio(&self) -> Option<f64> {
        self.next.gap_ratio(self.current, self.before[0])
    }
}

impl Ring {
    pub fn new() -> Result<Self, Error> {
        match filled(RING, None)?.try_into() {
            Ok(points) => Ok(Self { points, pushed: 0, taken: 0 }),
            Err(_) => Err(Error::bad_state("internal: the ring has another size")),
        }
    }

    /// Another of the same points; unlike a clone it reports a lack of memory.
    pub fn copy(&self) -> Result<Self, Error> {
        let mut copy = Self { pushed: self.pushed, taken: self.taken, ..Self::new()? };
        copy.points.copy_from_slice(&*self.points);
        Ok(copy)
    }

    /// Removes all points.
    pub fn clear(&mut self) {
        (self.pushed, self.taken) = (0, 0);
    }

    /// Points that wait.
    pub fn waiting(&self) -> usize {
        (self.pushed - self.taken) as usize
    }

    pub fn push(&mut self, point: TruthPoint) {
        self.points[place(self.pushed)] = Some(point);
        self.pushed += 1;
    }

    /// The points taken last that a stencil still looks back to, then those that wait, oldest first.
    pub fn kept(&self) -> impl Iterator<Item = &TruthPoint> {
        (self.taken - self.behind() as u64..self.pushed).filter_map(|index| self.at(index))
    }

    /// [`Self::kept`], newest first, to be moved in time.
    pub fn for_each_kept_mut(&mut self, mut change: impl FnMut(&mut TruthPoint)) {
        for index in (self.taken - self.behind() as u64..self.pushed).rev() {
            if let Some(point) = &mut self.points[place(index)] {
                change(point);
            }
        }
    }

    /// How many of the kept points have been taken.
    pub fn behind(&self) -> usize {
        self.taken.min(LOOK_BACK as u64) as usize
    }

    /// Makes the oldest point that waits the current one.
    pub fn take(&mut self) {
        if self.waiting() > 0 {
            self.taken += 1;
        }
    }

    /// The point pushed `back` before the last.
    pub fn pushed(&self, back: usize) -> Option<&TruthPoint> {
        self.at(self.pushed.checked_sub(back as u64 + 1)?)
    }

    /// The point pushed last, for changes.
    pub fn pushed_mut(&mut self) -> Option<&mut TruthPoint> {
        self.points[place(self.pushed.checked_sub(1)?)].as_mut()
    }

    /// The oldest point that waits.
    pub fn front(&self) -> Option<&TruthPoint> {
        if self.waiting() > 0 { self.at(self.taken) } else { None }
    }

    /// The point that waits behind the oldest.
    pub fn second(&self) -> Option<&TruthPoint> {
        if self.waiting() > 1 { self.at(self.taken + 1) } else { None }
    }

    /// The point taken `back` before the last.
    pub fn taken(&self, back: usize) -> Option<&TruthPoint> {
        self.at(self.taken.checked_sub(back as u64 + 1)?)
    }

    fn at(&self, index: u64) -> Option<&TruthPoint> {
        self.points[place(index)].as_ref()
    }
}

/// Index of the point with this number.
fn place(index: u64) -> usize {
    (index % RING as u64) as usize
}
