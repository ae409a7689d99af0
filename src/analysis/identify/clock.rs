//! How the clock of the record is shifted against that of the path, from the motion that both have.

use core::ops::Range;

use nalgebra::Matrix3;

use super::blocks::Block;
use super::path::{IdealPath, Six};
use crate::base::error::{Error, Rule};
use crate::base::memory::{filled, room};

/// Largest number of cells of the record and of the path, and the shortest cell [s].
const MOST_CELLS: f64 = 2500.0;
const SHORTEST_S: f64 = 0.2;
/// A shift whose score is this part of the best one fits as well.
const AS_WELL: f64 = 0.9;
/// The peak of a shift ends where the score falls below this part.
const PEAK: f64 = 0.5;
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

/// Σ m(t) u(t + shift)ᵀ of the gyros and of the accelerometers.
pub(super) type Cross = [Matrix3<f64>; 2];

/// The search of the shift at which the signals of the record and of the path belong together. The score of a shift is
/// ```text
/// Σ |C|² / (Σ|m|² Σ|u|²),   C = Σ m(t) u(t + shift)ᵀ
/// ```
/// over the gyros and over the accelerometers, with m of the record and u of the path, each less its mean. The Frobenius norm |C| does not
/// depend on the axes of the record, and the means not on its biases.
pub(super) struct Search {
    /// Weight and mean of the cells of the record and of the path; weight 0: a cell without a signal.
    pub recorded: Box<[(f64, Six)]>,
    pub ideal: Box<[(f64, Six)]>,
    pub size: [f64; 2],
    /// First times [s] of the record and of the path, and length of a cell [s].
    pub first_s: f64,
    begin_s: f64,
    pub cell_s: f64,
    /// Sums of each part of the record at shift k - (cells of the record - 1), in cells.
    of_lag: Vec<[Cross; PARTS]>,
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
        let (sizes, of_path) = (center(&mut recorded), center(&mut ideal));
        let size = [0, 1].map(|part| sizes[part] * of_path[part]);
        let shifts = recorded.len() + ideal.len() - 1;
        let of_lag = room(shifts)?;
        let mut search = Self { recorded, ideal, size, first_s, begin_s, cell_s, of_lag };
        for lag in 0..shifts {
            let of_parts = core::array::from_fn(|part| search.crossed(lag, part));
            search.of_lag.push(of_parts);
        }
        Ok(search)
    }

    fn crossed(&self, lag: usize, part: usize) -> Cross {
        let mut sums = [Matrix3::zeros(); 2];
        for cell in self.first_cell(part)..self.first_cell(part + 1) {
            if let Some(place) = self.place(cell, lag) {
                add(&mut sums, &self.recorded[cell].1, &self.ideal[place].1);
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

    pub fn sum(&self, lag: usize, parts: Range<usize>) -> Cross {
        let parts = &self.of_lag[lag][parts];
        parts.iter().fold(Default::default(), |sum: Cross, of| [sum[0] + of[0], sum[1] + of[1]])
    }

    fn score(&self, lag: usize, parts: Range<usize>) -> f64 {
        score(&self.sum(lag, parts), &self.size)
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
            .filter(|&lag| scores[lag] >= AS_WELL * scores[top])
            .min_by(|&a, &b| off_s(a).total_cmp(&off_s(b)));
        let best = self.summit(&scores, near.unwrap_or(top));
        let ends = |step: isize| {
            let mut end = best as isize;
            while (0..shifts as isize).contains(&end) && scores[end as usize] > PEAK * scores[best] {
                end += step;
            }
            end
        };
        let (low, high) = (ends(-1), ends(1));
        let other = (0..shifts)
            .filter(|&k| (k as isize) < low || (k as isize) > high)
            .filter(|&k| scores[k] >= AS_WELL * scores[best] && near.is_none())
            .max_by(|&a, &b| scores[a].total_cmp(&scores[b]));
        let other = other.map(shift);
        let best = refine(path, blocks, shift(best), self.cell_s)?;
        Ok(Found { best, other })
    }

    /// The top of the peak on whose side `lag` is.
    fn summit(&self, scores: &[f64], mut lag: usize) -> usize {
        loop {
            let beside = [lag.wrapping_sub(1), lag + 1].into_iter().filter(|lag| *lag < scores.len());
            match beside.max_by(|a, b| scores[*a].total_cmp(&scores[*b])) {
                Some(higher) if scores[higher] > scores[lag] => lag = higher,
                _ => return lag,
            }
        }
    }
}

/// The best shift within a cell around `coarse`, by the blocks themselves.
pub(super) fn refine(path: &IdealPath, blocks: &[Block], coarse: Shift, cell_s: f64) -> Result<Shift, Error> {
    let mut best = Shift { score: 0.0, ..coarse };
    let mut pairs: Vec<(Six, Six)> = room(blocks.len())?;
    let step_s = (FINE * cell_s).min(FINE_S).max(1.5 * cell_s / MOST_STEPS);
    let steps = (1.5 * cell_s / step_s).round() as i32;
    for step in -steps..=steps {
        let offset_s = coarse.offset_s + f64::from(step) * step_s;
        pairs.clear();
        let mean = |block: &Block| path.mean(block.start_s + offset_s, block.end_s + offset_s);
        pairs.extend(blocks.iter().filter_map(|block| Some((block.mean, mean(block)?.0))));
        let count = pairs.len().max(1) as f64;
        let (recorded, ideal) =
            pairs.iter().fold((Six::zeros(), Six::zeros()), |a, b| (a.0 + b.0, a.1 + b.1));
        let mut size = [0.0; 2];
        for (m, u) in &mut pairs {
            *m -= recorded / count;
            *u -= ideal / count;
        }
        for (part, size) in size.iter_mut().enumerate() {
            *size = squares(pairs.iter().map(|pair| &pair.0), part)
                * squares(pairs.iter().map(|pair| &pair.1), part);
        }
        let mut sums = [Matrix3::zeros(); 2];
        pairs.iter().for_each(|(m, u)| add(&mut sums, m, u));
        let score = score(&sums, &size);
        if score > best.score {
            best = Shift { offset_s, score };
        }
    }
    Ok(best)
}

/// Subtracts the mean of the cells with a value; the others become 0. Returns the sums of squares of gyros and accelerometers.
fn center(cells: &mut [(f64, Six)]) -> [f64; 2] {
    let (count, sum) = cells
        .iter()
        .filter(|cell| cell.0 > 0.0)
        .fold((0.0, Six::zeros()), |(count, sum), (_, mean)| (count + 1.0, sum + mean));
    for (weight, mean) in cells.iter_mut() {
        *mean = if *weight > 0.0 { *mean - sum / count } else { Six::zeros() };
    }
    [0, 1].map(|part| squares(cells.iter().map(|cell| &cell.1), part))
}

fn squares<'a>(signals: impl Iterator<Item = &'a Six>, part: usize) -> f64 {
    signals.map(|signal| signal.fixed_rows::<3>(3 * part).norm_squared()).sum()
}

fn add(sums: &mut Cross, m: &Six, u: &Six) {
    for (part, sum) in sums.iter_mut().enumerate() {
        *sum += m.fixed_rows::<3>(3 * part) * u.fixed_rows::<3>(3 * part).transpose();
    }
}

pub(super) fn score(sums: &Cross, size: &[f64; 2]) -> f64 {
    let of = |part: usize| if size[part] > 0.0 { sums[part].norm_squared() / size[part] } else { 0.0 };
    of(0) + of(1)
}
