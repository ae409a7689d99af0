//! How the clock of the record is shifted against that of the path, from the motion that both have.

use core::ops::Range;

use nalgebra::Matrix3;

use super::axes::SIZES;
use super::blocks::Block;
use super::path::{IdealPath, Six};
use crate::base::error::{Error, Rule};
use crate::base::memory::{filled, room};

/// Largest number of cells of the record and of the path, and the shortest cell [s].
const MOST_CELLS: f64 = 2500.0;
const SHORTEST_S: f64 = 0.2;
/// A shift that fits as well has at least this part of the best score.
const AS_WELL: f64 = 0.9;
/// The peak of a shift ends where the score falls below this part of its height above the usual score.
const PEAK: f64 = 0.5;
/// A part of the record, of 2, that no shift explains by chance.
pub(super) const MUCH: f64 = 0.5;
/// What rounding leaves of a sum of squares less that of its mean.
const ROUNDING: f64 = 1e-12;
/// Part of a cell between the shifts that are tried in the second round, the largest step between them [s], and most steps to each side.
const FINE: f64 = 0.125;
const FINE_S: f64 = 0.25;
const MOST_STEPS: f64 = 1000.0;

/// A shift that is given is known to this [s].
pub(super) const KNOWN_S: f64 = 10.0;
/// Parts of the record, whose shifts may differ if its clock jumps.
pub(super) const PARTS: usize = 8;

/// A shift of the clock and how well it fits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shift {
    /// Path time less record time [s].
    pub offset_s: f64,
    pub score: f64,
}

/// The best shift, and another one that fits as well, if there is one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Found {
    pub best: Shift,
    pub other: Option<Shift>,
}

/// Sums over cells that record and path have in common: m of the record, u of the path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sums {
    count: f64,
    recorded: Six,
    ideal: Six,
    /// Σ m uᵀ, Σ|m|² and Σ|u|² of the gyros and of the accelerometers.
    cross: [Matrix3<f64>; 2],
    squares: [(f64, f64); 2],
}

impl Default for Sums {
    fn default() -> Self {
        let (six, cross) = (Six::zeros(), [Matrix3::zeros(); 2]);
        Self { count: 0.0, recorded: six, ideal: six, cross, squares: [(0.0, 0.0); 2] }
    }
}

impl Sums {
    fn add(&mut self, m: &Six, u: &Six) {
        self.count += 1.0;
        self.recorded += m;
        self.ideal += u;
        for part in 0..2 {
            let [m, u] = [m, u].map(|signal| signal.fixed_rows::<3>(3 * part));
            self.cross[part] += m * u.transpose();
            self.squares[part].0 += m.norm_squared();
            self.squares[part].1 += u.norm_squared();
        }
    }

    pub fn plus(mut self, other: &Self) -> Self {
        self.count += other.count;
        self.recorded += other.recorded;
        self.ideal += other.ideal;
        for part in 0..2 {
            self.cross[part] += other.cross[part];
            self.squares[part].0 += other.squares[part].0;
            self.squares[part].1 += other.squares[part].1;
        }
        self
    }

    /// The part of the signals of the record, each less its mean, that those of the path explain with the best rotation, reflections
    /// too, and the best factor within `factors`, of gyros and accelerometers together: 0 to 2. With C = Σ m uᵀ, whose singular values
    /// have the sum c, it is
    /// ```text
    /// (2 s c - s² Σ|u|²) / Σ|m|²
    /// ```
    pub fn explained(&self, factors: (f64, f64)) -> f64 {
        let of = |part: usize| {
            let [m, u] = [&self.recorded, &self.ideal].map(|sum| sum.fixed_rows::<3>(3 * part) / self.count);
            let recorded = self.squares[part].0 - self.count * m.norm_squared();
            let ideal = self.squares[part].1 - self.count * u.norm_squared();
            let is_rounding = |left: f64, of: f64| left <= ROUNDING * of;
            if is_rounding(recorded, self.squares[part].0) || is_rounding(ideal, self.squares[part].1) {
                return 0.0;
            }
            let cross = self.cross[part] - m * u.transpose() * self.count;
            let along = cross.singular_values().sum();
            let factor = (along / ideal).clamp(factors.0, factors.1);
            ((2.0 * along - factor * ideal) * factor / recorded).max(0.0)
        };
        if self.count > 1.0 { of(0) + of(1) } else { 0.0 }
    }
}

/// The search of the shift at which the signals of the record and of the path belong together. The score of a shift is the part of the
/// record that the path explains there ([`Sums::explained`]), times the square of the part that both have in common of the shorter one.
/// Rotation and means leave out axes and biases. Of a record of the right units, a piece of the path of another size explains nothing;
/// other units are for others to reject, so that sizes do not count where no shift explains much.
pub(super) struct Search {
    /// Weight and mean of the cells of the record and of the path, less the mean of all; weight 0: a cell without a signal.
    pub recorded: Box<[(f64, Six)]>,
    pub ideal: Box<[(f64, Six)]>,
    /// First times [s] of the record and of the path, and length of a cell [s].
    pub first_s: f64,
    begin_s: f64,
    pub cell_s: f64,
    /// Factors of the path by which it may explain the record.
    factors: (f64, f64),
    /// What the path explains at the best shift in the right units, 0 to 2.
    pub explained: f64,
    /// Sums of each part of the record at shift k - (cells of the record - 1), in cells.
    of_lag: Vec<[Sums; PARTS]>,
}

impl Search {
    /// With a shift that is known to [`KNOWN_S`], the search is that of the times that path and record have in common at it: cells of a
    /// long path would be longer than the manoeuvres of a short record.
    pub fn new(path: &IdealPath, blocks: &[Block], known_s: Option<f64>) -> Result<Self, Error> {
        let (mut begin_s, mut end_s) = path.ends_s()?;
        let (mut first_s, mut last_s) = (blocks[0].start_s, blocks[blocks.len() - 1].end_s);
        if let Some(known_s) = known_s {
            let of_path = (begin_s - known_s - KNOWN_S, end_s - known_s + KNOWN_S);
            let of_record = (first_s + known_s - KNOWN_S, last_s + known_s + KNOWN_S);
            (first_s, last_s) = (first_s.max(of_path.0), last_s.min(of_path.1));
            (begin_s, end_s) = (begin_s.max(of_record.0), end_s.min(of_record.1));
            if begin_s >= end_s || first_s >= last_s {
                let rule = Rule::Sentence("leaves the path and the record no time in common");
                return Err(Error::invalid("request.shift_s", known_s, rule));
            }
        }
        let longest = blocks.iter().map(Block::length_s).fold(0.0, f64::max);
        let cell_s = ((end_s - begin_s).max(last_s - first_s) / MOST_CELLS).max(SHORTEST_S).max(longest);
        let count = |span_s: f64| ((span_s / cell_s) as usize).max(1);
        let mut recorded = filled(count(last_s - first_s), (0.0, Six::zeros()))?;
        for block in blocks.iter().filter(|block| block.middle_s() >= first_s) {
            let cell = ((block.middle_s() - first_s) / cell_s) as usize;
            if let Some((weight, sum)) = recorded.get_mut(cell) {
                *weight += block.length_s();
                *sum += block.mean * block.length_s();
            }
        }
        recorded.iter_mut().filter(|cell| cell.0 > 0.0).for_each(|(weight, sum)| *sum /= *weight);
        let mut ideal = filled(count(end_s - begin_s), (0.0, Six::zeros()))?;
        for (k, cell) in ideal.iter_mut().enumerate() {
            let start_s = begin_s + k as f64 * cell_s;
            if let Some((mean, _)) = path.mean(start_s, start_s + cell_s) {
                *cell = (1.0, mean);
            }
        }
        center(&mut recorded);
        center(&mut ideal);
        let shifts = recorded.len() + ideal.len() - 1;
        let of_lag = room(shifts)?;
        let (factors, explained) = (SIZES, 0.0);
        let mut search = Self { recorded, ideal, first_s, begin_s, cell_s, factors, explained, of_lag };
        for lag in 0..shifts {
            let of_parts = core::array::from_fn(|part| search.in_common(lag, part));
            search.of_lag.push(of_parts);
        }
        search.explained = search.score(search.best(&(0..PARTS)), 0..PARTS);
        if search.explained < MUCH {
            search.factors = (0.0, f64::INFINITY);
        }
        Ok(search)
    }

    fn in_common(&self, lag: usize, part: usize) -> Sums {
        let mut sums = Sums::default();
        for cell in self.first_cell(part)..self.first_cell(part + 1) {
            let Some(place) = self.place(cell, lag) else { continue };
            let (m, u) = (&self.recorded[cell], &self.ideal[place]);
            if m.0 > 0.0 && u.0 > 0.0 {
                sums.add(&m.1, &u.1);
            }
        }
        sums
    }

    pub fn first_cell(&self, part: usize) -> usize {
        part * self.recorded.len() / PARTS
    }

    /// Cell of the path that a cell of the record meets.
    pub fn place(&self, cell: usize, lag: usize) -> Option<usize> {
        (cell + lag).checked_sub(self.recorded.len() - 1).filter(|place| *place < self.ideal.len())
    }

    pub fn offset_s(&self, lag: usize) -> f64 {
        self.begin_s - self.first_s + (lag as f64 - (self.recorded.len() as f64 - 1.0)) * self.cell_s
    }

    pub fn sum(&self, lag: usize, parts: Range<usize>) -> Sums {
        self.of_lag[lag][parts].iter().fold(Sums::default(), Sums::plus)
    }

    /// What the path explains at these sums of some parts of the record, less for what it has not in common with it.
    pub fn score_of(&self, sums: &Sums, parts: Range<usize>) -> f64 {
        let cells = self.first_cell(parts.end) - self.first_cell(parts.start);
        let common = sums.count / cells.min(self.ideal.len()).max(1) as f64;
        common * common * sums.explained(self.factors)
    }

    fn score(&self, lag: usize, parts: Range<usize>) -> f64 {
        self.score_of(&self.sum(lag, parts.clone()), parts)
    }

    /// The best shift of some parts.
    pub fn best(&self, parts: &Range<usize>) -> usize {
        let order =
            |a: &usize, b: &usize| self.score(*a, parts.clone()).total_cmp(&self.score(*b, parts.clone()));
        (0..self.of_lag.len()).max_by(order).unwrap_or(0)
    }

    /// The best shift; with `known_s`, the nearest to it of those within [`KNOWN_S`] that fit as well.
    pub fn shift(&self, path: &IdealPath, blocks: &[Block], known_s: Option<f64>) -> Result<Found, Error> {
        let shifts = self.of_lag.len();
        let mut scores = room(shifts)?;
        scores.extend((0..shifts).map(|lag| self.score(lag, 0..PARTS)));
        let shift = |lag: usize| Shift { offset_s: self.offset_s(lag), score: scores[lag] };
        // Repeated manoeuvres: of several peaks that fit as well the one at no shift, if there is one.
        let (about_s, within_s) = known_s.map_or((0.0, 2.0 * self.cell_s), |known_s| (known_s, KNOWN_S));
        let off_s = |lag: usize| (self.offset_s(lag) - about_s).abs();
        let order = |a: &usize, b: &usize| scores[*a].total_cmp(&scores[*b]);
        let is_near = |lag: &usize| off_s(*lag) <= within_s;
        let top = match known_s {
            Some(_) => (0..shifts).filter(is_near).max_by(order),
            None => (0..shifts).max_by(order),
        };
        let Some(top) = top else {
            return Ok(Found { best: Shift { offset_s: about_s, score: 0.0 }, other: None });
        };
        let near = (0..shifts)
            .filter(is_near)
            .filter(|&lag| scores[lag] >= as_well(&scores, top))
            .min_by(|&a, &b| off_s(a).total_cmp(&off_s(b)));
        let is_open = |lag: &usize| known_s.is_none() || is_near(lag);
        let best = summit(&scores, near.unwrap_or(top), is_open);
        let mut sorted: Vec<f64> = room(shifts)?;
        sorted.extend(&scores);
        let (_, usual, _) = sorted.select_nth_unstable_by(shifts / 2, f64::total_cmp);
        let edge = *usual + PEAK * (scores[best] - *usual);
        let ends = |step: isize| {
            let mut end = best as isize;
            while (0..shifts as isize).contains(&end) && scores[end as usize] > edge {
                end += step;
            }
            end
        };
        let (low, high) = (ends(-1), ends(1));
        let other = (0..shifts)
            .filter(|&k| (k as isize) < low || (k as isize) > high)
            .filter(|&k| scores[k] >= as_well(&scores, best) && near.is_none())
            .max_by(|&a, &b| scores[a].total_cmp(&scores[b]));
        let other = other.map(shift);
        let best = refine(path, blocks, shift(best), self.cell_s);
        Ok(Found { best, other })
    }
}

/// The score of a shift that fits as well as the best one, which is known to a cell.
fn as_well(scores: &[f64], best: usize) -> f64 {
    let beside = [best.saturating_sub(1), best + 1].map(|lag| scores.get(lag).copied().unwrap_or(0.0));
    beside[0].min(beside[1]).max(AS_WELL * scores[best])
}

/// The top of the peak on whose side `lag` is, over shifts that are open.
fn summit(scores: &[f64], mut lag: usize, is_open: impl Fn(&usize) -> bool) -> usize {
    loop {
        let beside =
            [lag.wrapping_sub(1), lag + 1].into_iter().filter(|lag| *lag < scores.len() && is_open(lag));
        match beside.max_by(|a, b| scores[*a].total_cmp(&scores[*b])) {
            Some(higher) if scores[higher] > scores[lag] => lag = higher,
            _ => return lag,
        }
    }
}

/// The best shift within a cell around `coarse`, by the blocks themselves.
pub(super) fn refine(path: &IdealPath, blocks: &[Block], coarse: Shift, cell_s: f64) -> Shift {
    let mut best = Shift { score: 0.0, ..coarse };
    let step_s = (FINE * cell_s).min(FINE_S).max(1.5 * cell_s / MOST_STEPS);
    let steps = (1.5 * cell_s / step_s).round() as i32;
    for step in -steps..=steps {
        let offset_s = coarse.offset_s + f64::from(step) * step_s;
        let mut sums = Sums::default();
        for block in blocks {
            if let Some((ideal, _)) = path.mean(block.start_s + offset_s, block.end_s + offset_s) {
                sums.add(&block.mean, &ideal);
            }
        }
        let score = sums.explained((0.0, f64::INFINITY));
        if score > best.score {
            best = Shift { offset_s, score };
        }
    }
    best
}

/// Subtracts the mean of the cells with a value; the others become 0.
fn center(cells: &mut [(f64, Six)]) {
    let (count, sum) = cells
        .iter()
        .filter(|cell| cell.0 > 0.0)
        .fold((0.0, Six::zeros()), |(count, sum), (_, mean)| (count + 1.0, sum + mean));
    for (weight, mean) in cells.iter_mut() {
        *mean = if *weight > 0.0 { *mean - sum / count } else { Six::zeros() };
    }
}
