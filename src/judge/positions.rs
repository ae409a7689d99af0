//! Positions: held rows, spikes, accelerations, values from before the first fix, and the extent of the flight.

use nalgebra::Vector3;

use super::finding::At;
use super::histogram::Histogram;
use super::row::Row;
use super::stamps::{MIDDLE, Tick};
use crate::base::math::end_derivative_weights;
use crate::base::units::STANDARD_GRAVITY as G;
use crate::truth::FlightSample;

/// Usual interval from which a single position is compared with the path of its neighbours [s].
const SLOW_S: f64 = 0.5;

/// Share of the usual speed above which the way that was made during a run of held rows shows that the vehicle moved.
const MOVING: f64 = 0.05;

/// A value and the row where it is largest.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Largest {
    pub value: f64,
    pub at: At,
}

impl Largest {
    pub fn take(&mut self, value: f64, at: At) {
        if value > self.value {
            *self = Self { value, at };
        }
    }
}

#[derive(Debug, Clone)]
pub(super) struct Positions {
    /// Rows that move, and those of them that are held.
    pub moving: u64,
    pub held: u64,
    pub first_held: Option<At>,
    /// Held rows that follow each other, since the first of them, and how long that is [s].
    run: Option<(At, u64, f64)>,
    steps: Histogram,
    /// Distance of a position from the cubic through two neighbours on each side [m].
    beside: Histogram,
    pub farthest: Largest,
    /// Rows and intervals [s] of the last rows, the newest first.
    past: [(At, f64); 4],
    /// Displacements of the last rows, the newest first [m], Earth-fixed axes.
    displacements: [Vector3<f64>; 2],
    known: usize,
    /// Second difference of the positions over the time squared [m/s²].
    pub acceleration: Largest,
    /// Acceleration that is flown: by the velocities, or those derived from the positions as the simulator derives them [m/s²].
    pub flown: Largest,
    v_e: Option<Vector3<f64>>,
    /// Displacement since the first row, and the largest [m].
    from_start: Vector3<f64>,
    pub extent_m: f64,
    /// Values from before the first fix.
    unfixed: Unfixed,
    /// Latitude, longitude, height of the first row.
    first: [f64; 3],
}

#[derive(Debug, Clone, Copy)]
enum Unfixed {
    /// So many rows have the height, or the latitude and longitude, of the first: all so far.
    Counting([Option<u64>; 2]),
    Over(u64),
}

impl Positions {
    pub const fn new() -> Self {
        const ZERO: Vector3<f64> = Vector3::new(0.0, 0.0, 0.0);
        const NONE: Largest = Largest { value: 0.0, at: At { row: 0, time_s: 0.0 } };
        Self {
            moving: 0,
            held: 0,
            first_held: None,
            run: None,
            steps: Histogram::new(),
            beside: Histogram::new(),
            farthest: NONE,
            past: [(At { row: 0, time_s: 0.0 }, 0.0); 4],
            displacements: [ZERO; 2],
            known: 0,
            acceleration: NONE,
            flown: NONE,
            v_e: None,
            from_start: ZERO,
            extent_m: 0.0,
            unfixed: Unfixed::Counting([Some(0), Some(0)]),
            first: [0.0; 3],
        }
    }

    /// Takes the first sample.
    pub fn begin(&mut self, sample: &FlightSample) {
        let place = &sample.place;
        self.first = [place.latitude_rad, place.longitude_rad, place.height_m];
        self.unfixed = Unfixed::Counting([Some(1), Some(1)]);
    }

    /// Adds a row. `usual_s` is the usual interval [s], `fourth` the fourth difference of the positions [m].
    pub fn add(&mut self, row: &Row, sample: &FlightSample, usual_s: f64, fourth: Option<Vector3<f64>>) {
        let t = row.interval_s;
        let step_m = row.step_m();
        self.add_run(row, step_m);
        // The displacement of a row straight above the row before is rounding.
        if step_m > 0.0 && !row.is_held {
            self.steps.add(step_m / t);
        }
        self.from_start += row.d_e;
        self.extent_m = self.extent_m.max(self.from_start.norm_squared());
        if self.known > 0 {
            let before_s = self.past[0].1;
            let change = row.d_e / t - self.displacements[0] / before_s;
            self.acceleration.take(2.0 * change.norm_squared().sqrt() / (t + before_s), self.past[0].0);
        }
        self.add_flown(row);
        self.past.rotate_right(1);
        self.past[0] = (row.at, t);
        self.displacements.rotate_right(1);
        self.displacements[0] = row.d_e;
        self.known = (self.known + 1).min(2);
        let is_even = self.past.iter().all(|(_, past_s)| (past_s - t).abs() < 0.2 * t);
        if usual_s >= SLOW_S
            && is_even
            && let Some(fourth) = fourth
        {
            // (-1, 4, 0, 4, -1)/6 less the position itself is the fourth difference over 6.
            let beside_m = fourth.norm_squared().sqrt() / 6.0;
            self.beside.add(beside_m);
            self.farthest.take(beside_m, self.past[2].0);
        }
        self.add_unfixed(row, sample, usual_s);
    }

    /// Held rows that are farther from the next fix than a window reaches: that they moved shows when the run ends.
    fn add_run(&mut self, row: &Row, step_m: f64) {
        if row.is_held {
            let (first, count, length_s) = self.run.unwrap_or((row.at, 0, 0.0));
            self.run = Some((first, count + 1, length_s + row.interval_s));
        } else if let Some((first, count, length_s)) = self.run.take()
            && self.speed_m_s() > 0.0
            && step_m > MOVING * self.speed_m_s() * (length_s + row.interval_s)
        {
            let unseen = count.saturating_sub(MIDDLE as u64);
            self.moving += unseen;
            self.held += unseen;
            if unseen > 0 && self.first_held.is_none_or(|known| known.row > first.row) {
                self.first_held = Some(first);
            }
        }
    }

    /// The acceleration of the interval as the simulator flies it: its velocities are the host's, or the derivative of the polynomial
    /// through up to four positions.
    fn add_flown(&mut self, row: &Row) {
        let v_e = row.v_e().unwrap_or_else(|| {
            let [first, second] = self.displacements;
            let [t0, t1, t2] = [row.interval_s, self.past[0].1, self.past[1].1];
            let positions = [row.d_e, row.d_e + first, row.d_e + first + second].map(|past| -past);
            match self.known {
                0 => -positions[0] / t0,
                1 => weighted([-t0, -t0 - t1], &positions),
                _ => weighted([-t0, -t0 - t1, -t0 - t1 - t2], &positions),
            }
        });
        if let Some(last) = self.v_e {
            self.flown.take((v_e - last).norm_squared().sqrt() / row.interval_s, row.at);
        }
        self.v_e = Some(v_e);
    }

    /// Takes the row in the middle of a window, in which rows move by `mean_m` [m] on average. The positions have steps of `step_m` [m].
    pub fn add_window(&mut self, middle: &Tick, mean_m: f64, usual_s: f64, step_m: f64) {
        if mean_m <= (3.0 * step_m).max(0.02 * usual_s + 1e-9) {
            return;
        }
        // Of a row farther from the next fix, that fix shows what it was.
        let Some(is_held_fix) = middle.is_held_fix else { return };
        self.moving += 1;
        if is_held_fix {
            self.held += 1;
            self.first_held.get_or_insert(middle.at);
        }
    }

    fn add_unfixed(&mut self, row: &Row, sample: &FlightSample, usual_s: f64) {
        let Unfixed::Counting(counts) = &mut self.unfixed else { return };
        let ([latitude, longitude, height], place) = (self.first, &sample.place);
        let now =
            [place.height_m == height, place.latitude_rad == latitude && place.longitude_rad == longitude];
        let is_zero = [height == 0.0, latitude == 0.0 && longitude == 0.0];
        let jump = [row.d_n.z.abs(), row.step_m()];
        let allowed_m = [10.0 + 100.0 * usual_s, 1000.0 + 1000.0 * usual_s];
        let mut found = None;
        for kind in 0..2 {
            match counts[kind] {
                Some(count) if now[kind] => counts[kind] = Some(count + 1),
                Some(count) => {
                    // A single row may be a fix, and the next one wrong.
                    if jump[kind] > allowed_m[kind] && (count > 1 || is_zero[kind]) {
                        found = Some(count);
                    }
                    counts[kind] = None;
                }
                None => {}
            }
        }
        if found.is_some() || counts.iter().all(Option::is_none) {
            self.unfixed = Unfixed::Over(found.unwrap_or(0));
        }
    }

    /// Number of rows at the start with a value from before the first fix.
    pub fn unfixed(&self) -> u64 {
        match self.unfixed {
            Unfixed::Over(count) => count,
            Unfixed::Counting(_) => 0,
        }
    }

    /// Median speed of the rows that move [m/s].
    pub fn speed_m_s(&self) -> f64 {
        self.steps.median()
    }

    /// Displacement from the start, the largest [m].
    pub fn extent_m(&self) -> f64 {
        self.extent_m.sqrt()
    }

    /// Number of positions beside the path of their neighbours: by more than ten medians, and by more than a manoeuvre of 2 g and steps
    /// of `step_m` [m] explain.
    pub fn spikes(&self, usual_s: f64, step_m: f64) -> u64 {
        let limit = (10.0 * self.beside.median()).max(2.0 * G * usual_s * usual_s + 2.0 * step_m);
        if self.farthest.value > limit { self.beside.count_above(limit).max(1) } else { 0 }
    }
}

/// Derivative at the newest position of the polynomial through positions relative to it.
fn weighted<const N: usize>(times_s: [f64; N], positions: &[Vector3<f64>; 3]) -> Vector3<f64> {
    let weights = end_derivative_weights(&times_s);
    positions.iter().zip(weights).fold(Vector3::zeros(), |sum, (position, weight)| sum + position * weight)
}
