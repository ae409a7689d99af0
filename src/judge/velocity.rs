//! Velocities against displacements: unit, axes, signs, and rows that are wrong.

use super::blocks::{Block, Coarseness, End};
use super::finding::{At, Clue};
use super::histogram::Histogram;
use super::positions::Largest;
use crate::base::units::STANDARD_GRAVITY as G;

/// Units of velocities that logs have [m/s].
const UNITS: [(&str, f64); 7] = [
    ("m/s", 1.0),
    ("knots", 1852.0 / 3600.0),
    ("ft/s", 0.3048),
    ("km/h", 1.0 / 3.6),
    ("mph", 0.44704),
    ("cm/s", 0.01),
    ("mm/s", 0.001),
];

/// Units of velocities up [m/s], and what else makes the climb a multiple of them.
const VERTICAL: [(&str, f64); 8] = [
    ("positive is down", -1.0),
    ("height in feet", 1.0 / 0.3048),
    ("velocity in ft/min", 0.3048 / 60.0),
    ("velocity in knots", 1852.0 / 3600.0),
    ("velocity in ft/s", 0.3048),
    ("velocity in ft/s, positive is down", -0.3048),
    ("velocity in km/h", 1.0 / 3.6),
    ("velocity in cm/s", 0.01),
];

/// Vectors of a block: its displacement and the five integrals of velocities.
const VECTORS: usize = 6;

/// Blocks that a judgement needs.
const LEAST: u64 = 6;

/// Unexplained share of the displacement: spherical radii give 0.003; and one above which a unit explains nothing.
const RIGHT: f64 = 0.02;
const EXPLAINED: f64 = 0.3;

#[derive(Debug, Clone)]
pub(super) struct Velocities {
    /// Distance of the displacement by velocities from the displacement [m], and its share of the displacement.
    apart: Histogram,
    share: Histogram,
    /// Sums of the scalar products of the vectors of the blocks, each over the square of the displacement.
    products: [[f64; VECTORS]; VECTORS],
    /// Distance over what noise, turns and gravity may explain, where it is largest, and the distance there [m].
    worst: Largest,
    worst_m: f64,
    /// Number of blocks where the distance is above that.
    beyond: u64,
    /// Sums over blocks that climb: number, m², m h, h²; m by velocity, h by height.
    climbs: [f64; 4],
}

/// What velocities are wrong by.
pub(super) struct Wrong {
    pub ratio: f64,
    pub share: f64,
    pub clue: Clue,
    /// Whether the velocity up has a unit of its own.
    pub is_up_apart: bool,
    /// Whether the velocity up alone is wrong.
    pub is_up_alone: bool,
}

impl Velocities {
    pub const fn new() -> Self {
        Self {
            apart: Histogram::new(),
            share: Histogram::new(),
            products: [[0.0; VECTORS]; VECTORS],
            worst: Largest { value: 0.0, at: At { row: 0, time_s: 0.0 } },
            worst_m: 0.0,
            beyond: 0,
            climbs: [0.0; 4],
        }
    }

    pub fn add(&mut self, block: &Block, end: &End, coarse: &Coarseness) {
        let size2 = block.d_e.norm_squared();
        let apart_m = (block.d_e - block.moved_e()).norm_squared().sqrt();
        self.apart.add(apart_m);
        let noise_m = coarse.horizontal_m.max(coarse.up_m);
        let size_m = size2.sqrt();
        let allowed_m = 6.0 * noise_m + 0.02 * size_m + G * coarse.usual_s * coarse.usual_s + 0.01;
        if apart_m > allowed_m {
            self.beyond += 1;
        }
        if apart_m / allowed_m > self.worst.value {
            self.worst_m = apart_m;
            self.worst.take(apart_m / allowed_m, end.at);
        }
        let (up, climb) = (block.moved_up_m, block.climb_m);
        if up.abs().max(climb.abs()) > 10.0 * coarse.up_m + 1.0 {
            for (sum, term) in self.climbs.iter_mut().zip([1.0, up * up, up * climb, climb * climb]) {
                *sum += term;
            }
        }
        if size_m < (30.0 * noise_m).max(1.0) {
            return;
        }
        self.share.add(apart_m / size_m);
        let [a, b, c, d, e] = block.moved;
        let vectors = [block.d_e, a, b, c, d, e];
        for (row, first) in self.products.iter_mut().zip(&vectors) {
            for (sum, second) in row.iter_mut().zip(&vectors) {
                *sum += first.dot(second) / size2;
            }
        }
    }

    /// Whether there are enough blocks for a judgement.
    pub fn is_enough(&self) -> bool {
        self.share.total() >= LEAST
    }

    /// What velocities are wrong by, if they are.
    pub fn wrong(&self) -> Option<Wrong> {
        if !self.is_enough() {
            return None;
        }
        let count = self.share.total() as f64;
        let moved2: f64 = self.products[1][1] + self.products[2][2] + self.products[3][3];
        let ratio = (moved2 / count).sqrt();
        let mut best = (f64::INFINITY, Clue::None);
        // The velocity up may have another unit than the others: that of the climb.
        let up = self.vertical().map(|(slope, _)| slope);
        let mut is_up_apart = false;
        for up in [None, up] {
            for (unit, si) in UNITS {
                for exchanged in [false, true] {
                    for signs in 0..if up.is_some() { 4 } else { 8 } {
                        let opposite = [1, 2, 4].map(|bit| signs & bit != 0);
                        let [east, north, same] = opposite.map(|is| if is { -si } else { si });
                        let unexplained = self.unexplained([east, north, up.unwrap_or(same)], exchanged);
                        // The first of equals has the fewest changes.
                        if unexplained + 0.002 < best.0 {
                            best = (unexplained, Clue::Velocity { unit, exchanged, opposite });
                            is_up_apart = up.is_some();
                        }
                    }
                }
            }
        }
        let is_right = |clue: &Clue| {
            *clue == Clue::Velocity { unit: "m/s", exchanged: false, opposite: [false; 3] } && is_up_apart
        };
        // Of a flight along one axis, more than half of the blocks may be right. Single rows that are wrong have no factor.
        let [median, mean] = [self.share.median(), self.unexplained([1.0; 3], false)];
        let explained = |share: f64| best.0 < (share / 3.0).min(EXPLAINED);
        let share = if mean > 2.5 * RIGHT && explained(mean) { mean } else { median };
        let is_up_alone = explained(share) && is_right(&best.1);
        let clue = if explained(share) && !is_up_alone { best.1 } else { Clue::None };
        (share > RIGHT).then_some(Wrong { ratio, share, clue, is_up_apart, is_up_alone })
    }

    /// Root mean square of |Σd - f P ∫v| / |Σd|, with the factors f of the three axes and the exchange P.
    fn unexplained(&self, factors: [f64; 3], exchanged: bool) -> f64 {
        let chosen = if exchanged { [4, 5, 3] } else { [1, 2, 3] };
        let mut sum = self.products[0][0];
        for (axis, &vector) in chosen.iter().enumerate() {
            sum -= 2.0 * factors[axis] * self.products[0][vector];
            for (other, &second) in chosen.iter().enumerate() {
                sum += factors[axis] * factors[other] * self.products[vector][second];
            }
        }
        (sum.max(0.0) / self.share.total() as f64).sqrt()
    }

    /// The largest distance [m] of the displacement by velocities, its row, and the number of such blocks, if it stands out.
    pub fn outlier(&self) -> Option<(f64, At, u64)> {
        let stands_out = self.apart.total() >= LEAST
            && self.worst.value > 1.0
            && self.worst_m > 20.0 * self.apart.median();
        stands_out.then_some((self.worst_m, self.worst.at, self.beyond))
    }

    /// Climb over the velocity up, if the climb is a multiple of it and not equal; and what it would be.
    pub fn vertical(&self) -> Option<(f64, Clue)> {
        let [count, moved2, mixed, climb2] = self.climbs;
        let slope = mixed / moved2;
        let correlation2 = mixed * mixed / (moved2 * climb2);
        if count < LEAST as f64 || correlation2 < 0.9 || (slope - 1.0).abs() < 0.2 {
            return None;
        }
        let near = VERTICAL.iter().find(|(_, factor)| (slope / factor - 1.0).abs() < 0.1);
        Some((slope, near.map_or(Clue::None, |(name, _)| Clue::Known(name))))
    }
}
