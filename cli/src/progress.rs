//! Progress on a terminal: how far, how fast, how long still. Nothing of it goes into a file or a pipe.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::terminal::printable;
use crate::units::time_text;

/// What takes no longer is not worth a line.
const QUIET: Duration = Duration::from_secs(1);

/// A line at the bottom of a terminal, from the second second on.
pub struct Progress {
    bar: ProgressBar,
    began: Instant,
    duration_s: f64,
    is_shown: bool,
}

impl Progress {
    /// Of a flight of `duration_s` [s].
    pub fn new(duration_s: f64, quiet: bool) -> Self {
        let bar = ProgressBar::with_draw_target(Some(1000), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{percent:>3} %  {msg}, {eta} left") {
            bar.set_style(style);
        }
        // A quiet one stays hidden.
        Self { bar, began: Instant::now(), duration_s, is_shown: quiet }
    }

    /// The flight has come to `time_s` [s] since its start.
    pub fn show(&mut self, time_s: f64) {
        let elapsed = self.began.elapsed();
        if !self.is_shown && elapsed > QUIET {
            self.is_shown = true;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        let rate = time_s / elapsed.as_secs_f64().max(1e-3);
        let (flown, whole) = (time_text(time_s), time_text(self.duration_s));
        self.bar.set_message(format!("{flown} of {whole}, {rate:.0} times real time"));
        self.bar.set_position((1000.0 * time_s / self.duration_s) as u64);
    }
}

/// A line for work whose end is not known: what is being done, and for how long.
pub struct Working(ProgressBar);

impl Working {
    pub fn on(what: impl Into<String>) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{msg}, {elapsed}") {
            bar.set_style(style);
        }
        bar.set_message(printable(&what.into()));
        bar.enable_steady_tick(QUIET);
        Self(bar)
    }
}

impl Drop for Working {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
