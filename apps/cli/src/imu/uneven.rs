//! Rows at uneven times, as of a loop that reads a sensor when it comes to it.

use std::ops::Range;

use super::stamps::{EVEN, FEW, LONG, MEANS, Stamps, median, steps};

/// Times as many rows, over which stamps that wander are off by this number of times as much as over the rows of mean steps: by four
/// times, and stamps that scatter by as much. Fewest lengths of these rows in a record, and longest step, in intervals, that is no gap.
const MANY: usize = 16;
const WANDERS: f64 = 2.0;
const FEWEST_WINDOWS: usize = 4;
const LONG_UNEVEN: f64 = 20.0;
/// Steps within this part of an interval from a whole number of them; the part of the long ones that are so from which on rows are lost,
/// where more and fewer than a part of all steps are one interval.
const WHOLE: f64 = 0.25;
const MOST_WHOLE: [f64; 2] = [0.4, 0.75];
const MOST_ONES: f64 = 0.7;
/// Shorter length between a row and those beside it, of the longer one, below which the row is near to one of them.
const NEAR: f64 = 0.03;

impl Stamps {
    /// Rows that a recorder takes when it comes to it, each some time behind the one before: over many rows the stamps leave equal
    /// intervals by more and more, which stamps that are late do not. A step of many mean ones is a gap.
    pub fn uneven(&self, times_s: &[f64]) -> Option<Self> {
        // A loop of whole ticks has few steps of one.
        let shortest_s = steps(times_s).fold(f64::INFINITY, f64::min);
        if shortest_s <= 0.0 {
            return None; // rows of one stamp have no lengths
        }
        let ticks = |step_s: f64| step_s / shortest_s;
        let is_of_ticks = |step_s: f64| (ticks(step_s) - ticks(step_s).round()).abs() < EVEN;
        let ones = steps(times_s).filter(|step_s| ticks(*step_s) < LONG).count();
        let is_loop = 2 * ones < times_s.len() && steps(times_s).all(is_of_ticks);
        // Rows that are lost leave steps of whole intervals, and most of the others are one.
        let in_intervals = || steps(times_s).map(|step| step / self.interval_s);
        let is_near = |step: f64, whole: f64| (step - whole).abs() < WHOLE;
        let long = || in_intervals().filter(|step| *step > LONG);
        let count = long().count() as f64;
        let whole = long().filter(|step| is_near(*step, step.round())).count() as f64 / count.max(1.0);
        let one = in_intervals().filter(|step| is_near(*step, 1.0)).count() as f64 / times_s.len() as f64;
        let most = if one > MOST_ONES { MOST_WHOLE[0] } else { MOST_WHOLE[1] };
        if self.jitter < EVEN || (!is_loop && count > FEW as f64 && whole > most) {
            return None;
        }
        let of_many = |rows: usize| {
            let steps = |k: usize| times_s.get(k + rows).map(|end_s| end_s - times_s[k]);
            let mut over: Vec<f64> = (0..times_s.len()).map_while(steps).collect();
            if over.len() < FEWEST_WINDOWS * rows {
                return None;
            }
            let usual_s = median(&mut over);
            over.iter_mut().for_each(|time_s| *time_s = (*time_s - usual_s).abs());
            Some((usual_s, median(&mut over)))
        };
        let ((few_s, off_few), (_, off_many)) = (of_many(MEANS)?, of_many(MANY * MEANS)?);
        let interval_s = few_s / MEANS as f64;
        if off_many < WANDERS * off_few || off_few < EVEN * interval_s {
            return None;
        }
        let is_gap = |step: &f64| *step > LONG_UNEVEN * interval_s;
        let gaps = || steps(times_s).enumerate().filter(|(_, step)| is_gap(step));
        let ends = gaps().map(|(row, _)| row + 1).chain([times_s.len()]);
        let mut begin = 0;
        let pieces: Vec<Range<usize>> = ends.map(|end| std::mem::replace(&mut begin, end)..end).collect();
        let lost = gaps().map(|(_, step)| (step / interval_s) as usize).sum();
        let jitter = steps(times_s).filter(|step| !is_gap(step)).map(|step| (step / interval_s - 1.0).abs());
        let jitter = jitter.fold(0.0, f64::max);
        let stamps = Self {
            gaps: pieces.len() - 1,
            pieces,
            lost,
            is_uneven: true,
            jitter,
            ..Self::counted(times_s.len(), interval_s)
        };
        Some(stamps)
    }
}

/// Lengths of the intervals of the rows of the pieces: of uneven ones from the row before.
pub fn lengths(stamps: &Stamps, times_s: &[f64]) -> Vec<f64> {
    if !stamps.is_uneven {
        return Vec::new();
    }
    let first = std::iter::once(stamps.interval_s);
    let of_piece =
        |piece: Range<usize>| first.clone().chain(times_s[piece].windows(2).map(|pair| pair[1] - pair[0]));
    joined(&stamps.pieces).flat_map(of_piece).collect()
}

/// Where the pieces are when only their rows are kept.
fn joined(pieces: &[Range<usize>]) -> impl Iterator<Item = Range<usize>> + '_ {
    let mut to = 0;
    pieces.iter().map(move |piece| {
        to += piece.len();
        to - piece.len()..to
    })
}

/// Makes of values at the ends of intervals of these lengths [s] means over them, on cubics between the rows of a piece.
pub fn between(values: &mut [f64], pieces: &[Range<usize>], lengths_s: &[f64]) {
    for piece in joined(pieces) {
        let (own, length_s) = (values[piece.clone()].to_vec(), &lengths_s[piece.clone()]);
        let last = own.len() - 1;
        // Of the parabola through a row and those beside it, or of the chord past a row that is near to one of them, whose noise would be
        // the slope; at the ends that of the line.
        let slope = |row: usize| {
            let part = |row: usize| (own[row] - own[row - 1]) / length_s[row];
            match row {
                0 => part(1),
                _ if row == last => part(row),
                _ => {
                    let [before, behind] = [length_s[row], length_s[row + 1]];
                    if before.min(behind) < NEAR * before.max(behind) {
                        return (own[row + 1] - own[row - 1]) / (before + behind);
                    }
                    (part(row) * behind + part(row + 1) * before) / (before + behind)
                }
            }
        };
        for row in 1..own.len() {
            let mean = 0.5 * (own[row - 1] + own[row]);
            values[piece.start + row] = mean + length_s[row] / 12.0 * (slope(row - 1) - slope(row));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::stamps::read;
    use super::super::stamps::tests::random;
    use super::*;

    /// Rows of an uneven loop are told from late stamps and from lost rows.
    #[test]
    fn rows_of_an_uneven_loop_are_where_their_stamps_are() {
        for spread in [0.3, 0.8, 1.5] {
            let mut time_s = 0.0;
            let mut times_s: Vec<f64> = (0..3000)
                .map(|k| {
                    time_s += 0.01 * (1.0 + spread * (random(k) - 0.5));
                    time_s
                })
                .collect();
            times_s[2000..].iter_mut().for_each(|time_s| *time_s += 5.0);
            let found = read(&times_s).uneven(&times_s).unwrap();
            assert!((found.interval_s / 0.01 - 1.0).abs() < 0.05, "{spread}: {found:?}");
            assert_eq!(found.pieces, [0..2000, 2000..3000], "{spread}");
        }
        for late in [random, |k: usize| -0.3 * (1.0 - random(k)).ln(), |k: usize| (3 - k % 4) as f64] {
            for lost in [|_: usize| false, |k: usize| (k * k) % 17 == 3] {
                let times_s: Vec<f64> =
                    (0..3000).filter(|k| !lost(*k)).map(|k| 0.01 * (k as f64 + 0.3 * late(k))).collect();
                assert!(read(&times_s).uneven(&times_s).is_none());
            }
        }
    }

    /// A loop of ticks of 5 ms, of which each step has one to four.
    #[test]
    fn rows_of_a_loop_of_ticks_are_where_their_stamps_are() {
        let mut ticks = 0;
        let times_s: Vec<f64> = (0..3000)
            .map(|k| {
                ticks += 1 + (4.0 * random(k)) as u32;
                0.005 * f64::from(ticks)
            })
            .collect();
        let found = read(&times_s).uneven(&times_s).unwrap();
        assert!((found.interval_s / 0.0125 - 1.0).abs() < 0.05 && found.gaps == 0, "{found:?}");
    }

    /// A row that is near to the next one does not make its noise a slope.
    #[test]
    fn rows_that_are_near_to_each_other_add_no_noise() {
        let lengths_s: Vec<f64> = (0..1000).map(|k| if k % 5 == 2 { 1e-6 } else { 0.02 }).collect();
        let noise: Vec<f64> = (0..1000).map(|k| random(k) - 0.5).collect();
        let mut values = noise.clone();
        between(&mut values, &[0..500, 500..1000], &lengths_s);
        let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        assert!(largest < 0.75, "{largest}");
    }

    /// The mean of a parabola over each interval is exact but at the ends of a piece.
    #[test]
    fn means_between_uneven_rows_are_those_of_a_cubic() {
        let lengths_s: Vec<f64> = (0..20).map(|k| 0.5 + random(k)).collect();
        let ends: Vec<f64> = lengths_s
            .iter()
            .scan(0.0, |sum, length| {
                *sum += length;
                Some(*sum)
            })
            .collect();
        let integral = |t: f64| t * t * t / 3.0 - t;
        let mut values: Vec<f64> = ends.iter().map(|t| t * t - 1.0).collect();
        between(&mut values, &[0..10, 12..22], &lengths_s);
        for row in (2..9).chain(12..19) {
            let [from, to] = [ends[row - 1], ends[row]];
            let mean = (integral(to) - integral(from)) / (to - from);
            assert!((values[row] - mean).abs() < 1e-12, "{row}: {} {mean}", values[row]);
        }
    }
}
