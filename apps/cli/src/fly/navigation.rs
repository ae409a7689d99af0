//! The navigation of a unit: from the moment when its state becomes NAV until it leaves that state.

use sins::errors::{Accuracy, AccuracyFigures};
use sins::unit::State;
use sins::{Error, ErrorSource, Simulator};

/// A navigation with its figures, which count from its begin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Navigation {
    /// Begin and end, as times since the start of the flight [s].
    pub from_s: f64,
    pub until_s: f64,
    pub figures: AccuracyFigures,
}

impl Navigation {
    /// One that lasts the whole flight.
    pub fn whole(figures: AccuracyFigures) -> Self {
        Self { from_s: 0.0, until_s: figures.duration_s, figures }
    }

    pub fn duration_s(&self) -> f64 {
        self.until_s - self.from_s
    }
}

/// The navigations of a unit in flight.
#[derive(Debug, Default)]
pub struct Navigations {
    /// The one in progress: its begin [s] and its sums.
    now: Option<(f64, Accuracy)>,
    longest: Option<Navigation>,
}

impl Navigations {
    /// Takes the state of the unit and the errors of the solution at `time_s` since the start of the flight.
    pub fn take(&mut self, state: State, simulator: &Simulator, time_s: f64) -> Result<(), Error> {
        if state != State::Navigation {
            self.end(time_s);
            return Ok(());
        }
        let (_, sums) = self.now.get_or_insert_with(|| (time_s, Accuracy::new(time_s)));
        if sums.is_due(time_s)
            && let Some((_, errors)) = simulator.errors(ErrorSource::Navigation)?
        {
            // Whether a pole is near concerns the velocities, which are not used here.
            sums.add(time_s, &errors, false);
        }
        Ok(())
    }

    /// The longest navigation until `time_s`; `None`: the unit did not navigate.
    pub fn longest(mut self, time_s: f64) -> Option<Navigation> {
        self.end(time_s);
        self.longest
    }

    fn end(&mut self, until_s: f64) {
        let Some((from_s, sums)) = self.now.take() else { return };
        let ended = Navigation { from_s, until_s, figures: sums.figures(until_s) };
        if self.longest.is_none_or(|longest| longest.duration_s() < ended.duration_s()) {
            self.longest = Some(ended);
        }
    }
}
