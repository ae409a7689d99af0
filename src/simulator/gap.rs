//! An interval much longer than those before it: samples were lost, or the host stood still for a moment.

use super::Options;
use crate::signal::MAX_INCREMENTS;
use crate::truth::{GAP, Recent};

impl Options {
    /// Updates of the mechanization over the interval that `recent` ends. In a gap they are as long as those before, as far as
    /// there is memory for their increments: what an update that is too long loses of a manoeuvre stays for good.
    ///
    /// Evidence: 1 s lost in a weave of 4 g at 100 Hz, 500 s later: 15 km with one update, 5 cm so.
    #[inline]
    pub(super) fn updates_over(&self, recent: &Recent<'_>) -> usize {
        if recent.next.ends_gap(recent.current) {
            return self.updates_over_longer(recent);
        }
        self.updates_per_sample
    }

    #[cold]
    #[inline(never)]
    fn updates_over_longer(&self, recent: &Recent<'_>) -> usize {
        // Of the two intervals that lie between the points that are kept, and that a snapshot has.
        let before_s = recent.before[0].map_or(0.0, |point| point.interval_s);
        let usual_s = recent.current.interval_s.max(before_s);
        let ratio = recent.next.interval_s / usual_s;
        // At the start there is no usual one.
        if ratio <= GAP || usual_s == 0.0 {
            return self.updates_per_sample;
        }
        let most = MAX_INCREMENTS / (self.updates_per_sample * self.subsamples);
        self.updates_per_sample * ratio.min(most as f64).round() as usize
    }
}
