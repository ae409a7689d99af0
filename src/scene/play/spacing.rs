//! Spacing of the records.

use super::super::{Samples, Scene};
use super::Source;
use crate::base::error::Error;
use crate::base::snapshot::{CLOCK_S, stored};

/// Spacing of the records of a host's samples, if the scene does not set it [s].
const OF_HOST_S: f64 = 1.0;

/// Records at the first sample from each multiple of a time on. Intervals of a log may differ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spacing {
    /// Time from one record to the next [s].
    pub every_s: f64,
    /// Time of the next record since the start of the flight [s].
    next_s: f64,
}

stored!(Spacing { every_s: CLOCK_S, next_s: CLOCK_S } then |spacing, from| {
    from.require(spacing.every_s > 0.0, spacing.every_s, "is no time between records")
});

impl Spacing {
    /// Records `every_s` [s] apart.
    pub fn new(every_s: f64) -> Self {
        Self { every_s, next_s: every_s }
    }

    /// That of the scene, else the one for about 2000 records, of a host's samples one a second.
    pub fn of(scene: &Scene, source: &Source, samples: Option<&Samples>) -> Result<Self, Error> {
        let every_s = match (scene.output.every_s, source, samples) {
            (Some(every_s), Source::Log(_) | Source::Host, _) => every_s,
            (None, Source::Host, _) | (_, _, None) => OF_HOST_S,
            (_, _, Some(samples)) => {
                scene.record_every(samples.count, samples.period_s)? as f64 * samples.period_s
            }
        };
        Ok(Self::new(every_s))
    }

    /// Whether the interval of `interval_s` [s] that ends at `time_s` [s] since the start has a record.
    pub fn take(&mut self, time_s: f64, interval_s: f64) -> bool {
        // Stamps of a log are rounded.
        let latest_s = time_s + 0.1 * interval_s;
        let is_due = latest_s >= self.next_s;
        if is_due {
            self.next_s = self.every_s * ((latest_s / self.every_s).floor() + 1.0);
        }
        is_due
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_are_at_the_samples_from_their_times_on() {
        let uneven = [1.0, 2.0, 3.0, 4.0, 4.1, 4.2, 4.3, 4.4, 4.6, 5.0, 9.0, 9.5, 10.0];
        let mut spacing = Spacing::new(1.5);
        let mut last_s = 0.0;
        let due = |time_s: &f64| {
            let interval_s = time_s - std::mem::replace(&mut last_s, *time_s);
            spacing.take(*time_s, interval_s)
        };
        let found: Vec<f64> = uneven.into_iter().filter(due).collect();
        assert_eq!(found, [2.0, 3.0, 4.6, 9.0]);
    }
}
