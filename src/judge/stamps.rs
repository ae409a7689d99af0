//! Time stamps: the usual interval, gaps, stamps too near to each other, and scatter about a steady clock.

use super::finding::At;
use super::histogram::Histogram;
use super::positions::Largest;
use super::row::Row;

/// An interval below this share of the usual one is near.
const NEAR: f64 = 0.2;

/// An interval above this multiple of each of the two before is a gap.
const GAP: f64 = 2.5;

/// Intervals until the usual one is known.
const LEAST: u64 = 8;

/// Share of the way of the window's speed that a fix must have made behind held rows.
const HELD_WAY: f64 = 0.25;

/// Rows of the window in which displacements are compared with stamps: the one in the middle, and ten on each side.
pub(super) const WINDOW: usize = 21;
pub(super) const MIDDLE: usize = WINDOW / 2;

/// An interval of the window.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Tick {
    pub interval_s: f64,
    /// Number of usual intervals in it.
    pub ticks: f64,
    /// Horizontal displacement [m].
    pub step_m: f64,
    pub is_held: bool,
    /// Whether it is a repeat of a fix while the vehicle moves: `None` where the next fix is not yet known.
    pub is_held_fix: Option<bool>,
    pub at: At,
}

#[derive(Debug, Clone)]
pub(super) struct Stamps {
    intervals: Histogram,
    /// Number and sum of the intervals near the median [s]: their mean is the usual interval.
    usual: (u64, f64),
    window: [Tick; WINDOW],
    count: u64,
    was_near: bool,
    /// An interval that is near: it counts if the next is not.
    pending: Option<(f64, At)>,
    /// Number of near stamps, the shortest interval [s] and its row.
    pub near: u64,
    pub shortest: Option<(f64, At)>,
    /// The last two intervals that are not near, the newer first; infinite: not known yet [s].
    last_s: [f64; 2],
    /// Number of gaps, and the longest with the row behind it.
    pub gaps: u64,
    pub longest: Largest,
    /// Sums over rows: x², xy, y², deviation², number; x = v (Δt - n tick), y = |d| - v n tick.
    sums: [f64; 4],
    compared: u64,
}

impl Stamps {
    pub const fn new() -> Self {
        Self {
            intervals: Histogram::new(),
            usual: (0, 0.0),
            window: [Tick {
                interval_s: 0.0,
                ticks: 0.0,
                step_m: 0.0,
                is_held: false,
                is_held_fix: None,
                at: At { row: 0, time_s: 0.0 },
            }; WINDOW],
            count: 0,
            was_near: false,
            pending: None,
            near: 0,
            shortest: None,
            last_s: [f64::INFINITY; 2],
            gaps: 0,
            longest: Largest { value: 0.0, at: At { row: 0, time_s: 0.0 } },
            sums: [0.0; 4],
            compared: 0,
        }
    }

    /// Usual interval: the mean of those that are nearly the median [s].
    pub fn usual_s(&self) -> f64 {
        let (count, sum_s) = self.usual;
        if count > 0 { sum_s / count as f64 } else { self.intervals.recent_median() }
    }

    /// Takes an interval. Whether its row is so near to the row before that it is left out.
    pub fn take(&mut self, interval_s: f64, at: At) -> bool {
        let is_near = self.intervals.total() >= LEAST && interval_s < NEAR * self.usual_s();
        self.intervals.add(interval_s);
        let median_s = self.intervals.recent_median();
        if (0.75 * median_s..1.3 * median_s).contains(&interval_s) {
            self.usual = (self.usual.0 + 1, self.usual.1 + interval_s);
        }
        // Of several in a row none is near: the rate has changed.
        if let Some((shortest_s, shortest_at)) = self.pending.take()
            && !is_near
        {
            self.near += 1;
            if self.shortest.is_none_or(|(known_s, _)| shortest_s < known_s) {
                self.shortest = Some((shortest_s, shortest_at));
            }
        }
        let is_left_out = is_near && !self.was_near;
        if is_left_out {
            self.pending = Some((interval_s, at));
        } else {
            if self.last_s.iter().all(|last_s| interval_s > GAP * last_s) {
                self.gaps += 1;
                self.longest.take(interval_s, at);
            }
            self.last_s = [interval_s, self.last_s[0]];
        }
        self.was_near = is_near;
        is_left_out
    }

    /// Adds a row that was not left out. The window around the row in its middle, once it is full.
    pub fn add(&mut self, row: &Row) -> Option<(&Tick, f64)> {
        let ticks = (row.interval_s / self.usual_s()).round().max(1.0);
        let tick = Tick {
            interval_s: row.interval_s,
            ticks,
            step_m: row.step_m(),
            is_held: row.is_held,
            is_held_fix: None,
            at: row.at,
        };
        self.window[(self.count % WINDOW as u64) as usize] = tick;
        self.count += 1;
        if self.count < WINDOW as u64 {
            return None;
        }
        let (mut time_s, mut ticks, mut path_m) = (0.0, 0.0, 0.0);
        for tick in &self.window {
            time_s += tick.interval_s;
            ticks += tick.ticks;
            path_m += tick.step_m;
        }
        let speed = path_m / time_s;
        let is_held = self.is_held_fix(speed);
        let middle = &mut self.window[((self.count - 1 - MIDDLE as u64) % WINDOW as u64) as usize];
        middle.is_held_fix = is_held;
        let deviation_s = middle.interval_s - middle.ticks * (time_s / ticks);
        let (x, y) = (speed * deviation_s, middle.step_m - path_m * (middle.ticks / ticks));
        for (sum, term) in self.sums.iter_mut().zip([x * x, x * y, y * y, deviation_s * deviation_s]) {
            *sum += term;
        }
        self.compared += 1;
        Some((&*middle, path_m / WINDOW as f64))
    }

    /// Whether the row in the middle of the window repeats a fix that is held while the vehicle moves at `speed_m_s` [m/s]: the next fix
    /// has the way that was made meanwhile. Behind a rest, or a climb over one place, it has not.
    fn is_held_fix(&self, speed_m_s: f64) -> Option<bool> {
        let tick = |place: usize| &self.window[((self.count + place as u64) % WINDOW as u64) as usize];
        if !tick(MIDDLE).is_held {
            return Some(false);
        }
        let next = (MIDDLE + 1..WINDOW).find(|&place| !tick(place).is_held)?;
        let run = (0..next).rev().take_while(|&place| tick(place).is_held);
        let length_s = tick(next).interval_s + run.map(|place| tick(place).interval_s).sum::<f64>();
        Some(tick(next).step_m > HELD_WAY * speed_m_s * length_s)
    }

    /// Scatter of the stamps [s], if displacements follow a steady clock and not the stamps. The positions have steps of `step_m` [m].
    pub fn jitter_s(&self, step_m: f64) -> Option<f64> {
        let [xx, xy, yy, deviations] = self.sums;
        let count = self.compared as f64;
        let deviation_s = (deviations / count).sqrt();
        let is_seen = (xx / count).sqrt() > 5.0 * step_m + 1e-3 && deviation_s > 2e-3 * self.usual_s();
        if self.compared < 100 || self.near > 0 || !is_seen {
            return None;
        }
        let (slope, slope_sigma) = (xy / xx, (yy / count / xx).sqrt());
        (slope < 0.5 && slope_sigma < 0.1).then_some(deviation_s / 2f64.sqrt())
    }
}
