//! An interval much longer than the intervals before it: samples were lost, or the host stopped for a moment.

use super::Options;
use crate::signal::MAX_INCREMENTS;
use crate::truth::Recent;

impl Options {
    /// Number of mechanization updates over the interval that `recent` ends. In a gap, the updates are as long as before the gap,
    /// if there is enough memory for their increments. An update that is too long loses a part of a manoeuvre for good.
    ///
    /// Evidence: 1 s lost in a weave of 4 g at 100 Hz. The error 500 s later is 15 km with one update, and 5 cm with these updates.
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
