//! Progress on a terminal: completed part, speed and remaining time. Nothing of it goes into a file or a pipe.

use std::fmt::Write;
use std::io::Read;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::failure::printable;
use crate::units::time_text;

/// Duration of the longest work that shows no line; also the interval at which the line is renewed.
const QUIET: Duration = Duration::from_secs(1);

/// A line at the bottom of a terminal, shown after `QUIET` until it is dropped.
pub struct Progress {
    bar: ProgressBar,
    /// Simulated time flown so far [µs].
    flown_us: Arc<AtomicU64>,
}

impl Progress {
    /// Progress of flights of `steps` steps in all.
    pub fn flying(what: impl Into<String>, steps: usize, quiet: bool) -> Self {
        Self::new(what, Some(steps as u64), quiet)
    }

    /// Progress of work in `parts` parts.
    pub fn counting(what: impl Into<String>, parts: usize) -> Self {
        Self::new(what, Some(parts as u64), false)
    }

    /// Progress of work whose end is not known.
    pub fn working(what: impl Into<String>) -> Self {
        Self::new(what, None, false)
    }

    fn new(what: impl Into<String>, whole: Option<u64>, quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(whole, target);
        let flown_us = Arc::new(AtomicU64::new(0));
        let (what, flown) = (printable(&what.into()), Arc::clone(&flown_us));
        let line = move |state: &ProgressState, text: &mut dyn Write| {
            let done = state.len().map(|_| f64::from(state.fraction()));
            let flown_s = 1e-6 * flown.load(Ordering::Relaxed) as f64;
            let _ = text.write_str(&line(&what, state.elapsed(), done, state.eta(), flown_s));
        };
        if let Ok(style) = ProgressStyle::with_template("{line}") {
            bar.set_style(style.with_key("line", line));
        }
        bar.enable_steady_tick(QUIET);
        Self { bar, flown_us }
    }

    /// Adds `steps` flown steps of `period_s` [s].
    pub fn fly(&self, steps: usize, period_s: f64) {
        let flown_us = 1e6 * period_s * steps as f64;
        self.flown_us.fetch_add(flown_us.round() as u64, Ordering::Relaxed);
        self.bar.inc(steps as u64);
    }

    /// Adds one completed part.
    pub fn count(&self) {
        self.bar.inc(1);
    }

    /// Reader of `input` that adds each byte as a completed part.
    pub fn reading<R: Read>(&self, input: R) -> impl Read + use<R> {
        self.bar.wrap_read(input)
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Text of the line; empty while the work may still be short.
fn line(what: &str, elapsed: Duration, done: Option<f64>, left: Duration, flown_s: f64) -> String {
    if elapsed < QUIET {
        return String::new();
    }
    let Some(done) = done else {
        return format!("{what}, {}", time_text(elapsed.as_secs_f64().round()));
    };
    let mut text = format!("{what}: {:.0} %", (100.0 * done).floor());
    if flown_s > 0.0 {
        text += &format!(", {:.0} simulated seconds a second", flown_s / elapsed.as_secs_f64());
    }
    if !left.is_zero() {
        text += &format!(", {} left", time_text(left.as_secs_f64().ceil()));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn how_far_how_fast_and_how_long_still() {
        let seconds = Duration::from_secs;
        let of =
            |elapsed, done, left, flown_s| line("flying", seconds(elapsed), done, seconds(left), flown_s);
        assert_eq!(of(0, Some(0.1), 30, 1e4), "");
        assert_eq!(of(4, Some(0.259), 12, 1e5), "flying: 25 %, 25000 simulated seconds a second, 12 s left");
        assert_eq!(of(2, Some(0.5), 150, 0.0), "flying: 50 %, 2.5 min left");
        assert_eq!(of(2, Some(0.0), 0, 0.0), "flying: 0 %");
        assert_eq!(of(3, None, 0, 0.0), "flying, 3 s");
    }
}
