//! An interval much longer than those before it: samples were lost, or the host stood still for a moment.

use super::Options;
use crate::signal::MAX_INCREMENTS;
use crate::truth::Recent;

impl Options {
    /// Updates of the mechanization over the interval that `recent` ends. In a gap they are as long as those before, as far as
    /// there is memory for their increments: what an update that is too long loses of a manoeuvre stays for good.
    ///
    /// Evidence: 1 s lost in a weave of 4 g at 100 Hz, 500 s later: 15 km with one update, 5 cm so.
    #[inline]
    pub(super) fn updates_over(&self, recent: &Recent<'_>) -> usize {
        match recent.gap_ratio() {
            None => self.updates_per_sample,
            Some(ratio) => {
                let most = MAX_INCREMENTS / (self.updates_per_sample * self.subsamples);
                self.updates_per_sample * ratio.min(most as f64).round() as usize
            }
        }
    }
}
