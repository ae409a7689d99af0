//! The interval of a record and its pieces between gaps, from its time stamps.

use std::ops::Range;

/// A step longer than this part of the interval may be a gap.
pub const LONG: f64 = 1.5;

/// Rows before and behind a long step that tell whether it is a gap. Behind a late stamp the next ones are on time again; behind a gap none
/// is. Where long steps are near to each other, as between batches of rows with one stamp, it is twice their distance, up to the most.
const ROWS: usize = 20;
const MOST_ROWS: usize = 2000;
pub const FEW: usize = 5;

/// Largest number of gaps, as a part of the rows: more of them are stamps that come in batches, each as late as the last row of its batch.
const MOST_GAPS: f64 = 0.1;

/// How far stamps of rows without gaps are off a line at most, over how far their steps are off the interval, in root mean squares. Stamps
/// that are late independently have 0.7. Where steps are off by more than a part of the interval, rows wait for each other, and the second
/// limit holds: a single lost row is not told there.
const SCATTERS: [f64; 2] = [0.9, 1.5];
const LATE: f64 = 0.6;

/// Rows of mean steps.
pub const MEANS: usize = 30;

/// Stamps whose steps are whole numbers of intervals to this part of one do not scatter: each long step of them is a gap. Steps of stamps
/// in whole milliseconds may be off by one, where that is not more than a part of an interval.
pub const EVEN: f64 = 0.1;
const DIGIT_S: f64 = 1e-3;
/// Scatter of stamps that are not rounded, as a part of an interval.
pub const EXACT: f64 = 1e-4;
const MOST_DIGIT: f64 = 0.25;
/// Longest step that is compared with whole numbers of intervals, which are known less well than a long gap.
const LONGEST_EVEN: f64 = 100.0;

/// Least usual step, as a part of the mean step: a gap is not longer than the record a million times.
const SHORTEST: f64 = 1e-6;

/// Steps of which the usual one is taken.
const MOST_STEPS: usize = 100_000;

/// The same of stamps that do not scatter, if fewer rows are lost than are there.
const MOST_LOST: f64 = 0.5;

/// A tick of the clock of Windows [s], by which old hosts stamp their rows: a row may be at the second tick behind the one before without
/// one being lost. Part by which the ticks of a record may be off it.
const TICK_S: f64 = 1.0 / 64.0;
const OF_TICK: f64 = 0.01;

/// Rounds in which the interval is found: a round leaves that part of its error that the gaps are of the record.
const ROUNDS: usize = 60;

/// What the stamps of a record say.
#[derive(Debug, PartialEq)]
pub struct Stamps {
    pub interval_s: f64,
    /// Rows, and gaps between them.
    pub rows: usize,
    pub gaps: usize,
    /// The pieces of rows at equal intervals between the gaps.
    pub pieces: Vec<Range<usize>>,
    /// Intervals that are missing between the pieces.
    pub lost: usize,
    /// The rows before gaps, and intervals that are missing behind each.
    pub lost_before: Vec<(usize, usize)>,
    /// Whether rows are at the times of their stamps, and not at equal intervals.
    pub is_uneven: bool,
    /// Largest difference between a step within a piece and the interval, as a part of the interval.
    pub jitter: f64,
}

impl Stamps {
    /// Rows that are each the next sample.
    pub fn counted(rows: usize, interval_s: f64) -> Self {
        let pieces = std::iter::once(0..rows).collect();
        Self {
            interval_s,
            rows,
            gaps: 0,
            pieces,
            lost: 0,
            lost_before: Vec::new(),
            is_uneven: false,
            jitter: 0.0,
        }
    }

    /// The numbers of the intervals at whose ends the rows are.
    pub fn places(&self) -> impl Iterator<Item = f64> + '_ {
        places(self.rows, &self.lost_before)
    }

    /// Rows of the pieces.
    pub fn used(&self) -> usize {
        self.pieces.iter().map(Range::len).sum()
    }

    /// Leaves out the shortest of more than `most` pieces, and single rows.
    pub fn longest(mut self, most: usize) -> Self {
        let mut lengths: Vec<usize> = self.pieces.iter().map(Range::len).collect();
        lengths.sort_unstable_by(|a, b| b.cmp(a));
        let least = lengths[lengths.len().min(most) - 1].max(2);
        self.pieces.retain(|piece| piece.len() >= least);
        self.pieces.truncate(most);
        self
    }
}

/// Reads stamps [s] in order, at least two.
pub fn read(times_s: &[f64]) -> Stamps {
    let found = read_gaps(times_s);
    if found.gaps == 0 {
        return found;
    }
    let rows = || (0..times_s.len()).map(|row| row as f64).zip(times_s.iter().copied());
    let interval_s = slope(rows());
    let count = times_s.len() as f64;
    let begin_s = rows().map(|(row, time_s)| time_s - row * interval_s).sum::<f64>() / count;
    let off_line = || rows().map(|(row, time_s)| time_s - begin_s - row * interval_s);
    let jitter = steps(times_s).map(|step| (step / interval_s - 1.0).abs()).fold(0.0, f64::max);
    let whole = Stamps { jitter, ..Stamps::counted(times_s.len(), interval_s) };
    if is_even(times_s, found.interval_s) {
        let is_of_ticks = (found.interval_s / TICK_S - 1.0).abs() < OF_TICK && found.gaps > FEW;
        return if is_of_ticks && off_line().all(|off| off.abs() < TICK_S) { whole } else { found };
    }
    // Late stamps look like gaps: with gaps the stamps leave a line by more than their steps scatter.
    let square = |off: f64| off * off;
    let of_line = off_line().map(square).sum::<f64>();
    let of_steps = steps(times_s).map(|step| square(step - interval_s)).sum::<f64>();
    let is_late = of_steps > square(LATE * interval_s) * count;
    let most = SCATTERS[usize::from(is_late)];
    if of_line < square(most) * of_steps { whole } else { found }
}

/// The interval, and the gaps that steps show.
fn read_gaps(times_s: &[f64]) -> Stamps {
    let whole = 0..times_s.len() - 1;
    let mean_s = mean(times_s, &whole, 0);
    // If there are gaps, the mean step is too long; if stamps come in batches, the usual step is too short, or nothing.
    let usual_s = usual(times_s);
    if usual_s > SHORTEST * mean_s {
        let found = found(times_s, &whole, usual_s);
        if is_even(times_s, found.interval_s) {
            return if found.jitter > EXACT { by_line(times_s, found) } else { found };
        }
        if found.gaps as f64 <= MOST_GAPS * times_s.len() as f64 {
            return scattered(times_s, &whole, found);
        }
    }
    // From the first row of a batch to that of the last: the end of a batch has the stamp of its begin.
    let is_long = |(row, step): (usize, f64)| (step > LONG * mean_s).then_some(row + 1);
    let firsts: Vec<usize> = steps(times_s).enumerate().filter_map(is_long).collect();
    let batches = match firsts[..] {
        [first, .., last] => first..last,
        _ => whole,
    };
    let mut found = found(times_s, &batches, mean(times_s, &batches, 0));
    // Batches of other numbers of rows, whose stamps may be those of the last: on average over all of them.
    if found.gaps == 0 && firsts.len() > FEW {
        found.interval_s = slope(firsts.iter().map(|row| (*row as f64, times_s[*row])));
    }
    found
}

/// The slope of the line nearest to points.
fn slope(points: impl Iterator<Item = (f64, f64)> + Clone) -> f64 {
    let count = points.clone().count() as f64;
    let (middle, middle_s) =
        points.clone().fold((0.0, 0.0), |sum, (k, t)| (sum.0 + k / count, sum.1 + t / count));
    let off = points.map(|(k, t)| (k - middle, t - middle_s));
    let (along, square) = off.fold((0.0, 0.0), |sum, (k, t)| (sum.0 + k * t, sum.1 + k * k));
    along / square
}

/// The mean interval between two rows, if `lost` rows are missing between them.
fn mean(times_s: &[f64], rows: &Range<usize>, lost: usize) -> f64 {
    (times_s[rows.end] - times_s[rows.start]) / (rows.len() + lost) as f64
}

pub fn steps(times_s: &[f64]) -> impl Iterator<Item = f64> {
    times_s.windows(2).map(|pair| pair[1] - pair[0])
}

/// The middle one of some values.
pub fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// The mean step without gaps. Not the median: stamps with few digits have steps of two lengths, and the median is one of the two.
fn usual(times_s: &[f64]) -> f64 {
    let mut some: Vec<f64> = steps(times_s).step_by(1 + times_s.len() / MOST_STEPS).collect();
    let median = median(&mut some);
    let single = steps(times_s).filter(|step| *step < 1.75 * median);
    let (sum, count) = single.fold((0.0, 0_u32), |(sum, count), step| (sum + step, count + 1));
    if count == 0 { median } else { sum / f64::from(count) }
}

/// What stamps that scatter say, if their usual step says `by_step`. Stamps that are late by a random time have few steps far above the
/// usual one, so that it is too short, and many of them count as gaps: the median of the mean steps over some rows is not. Of both the one
/// whose rows are nearer to their stamps.
fn scattered(times_s: &[f64], whole: &Range<usize>, by_step: Stamps) -> Stamps {
    let mut means: Vec<f64> =
        times_s.windows(MEANS + 1).map(|rows| (rows[MEANS] - rows[0]) / MEANS as f64).collect();
    let mut best = by_step;
    if !means.is_empty() {
        let by_means = found(times_s, whole, median(&mut means));
        if off(times_s, &by_means) < off(times_s, &best) {
            best = by_means;
        }
    }
    by_line(times_s, best)
}

/// The first and the last stamp scatter too: the interval is that of the line nearest to all.
fn by_line(times_s: &[f64], stamps: Stamps) -> Stamps {
    let interval_s = slope(places(times_s.len(), &stamps.lost_before).zip(times_s.iter().copied()));
    Stamps { interval_s, ..stamps }
}

/// The numbers of the intervals at whose ends `rows` rows are.
fn places(rows: usize, lost_before: &[(usize, usize)]) -> impl Iterator<Item = f64> + Clone + '_ {
    let mut lost = lost_before.iter().peekable();
    let mut sum = 0;
    (0..rows).map(move |row| {
        while let Some((_, of_gap)) = lost.next_if(|gap| gap.0 < row) {
            sum += of_gap;
        }
        (row + sum) as f64
    })
}

/// Mean distance of the stamps from equal intervals over some rows, in intervals.
fn off(times_s: &[f64], stamps: &Stamps) -> f64 {
    let places: Vec<f64> = places(times_s.len(), &stamps.lost_before).collect();
    let off = |(t, k): (&[f64], &[f64])| ((t[MEANS] - t[0]) / stamps.interval_s - (k[MEANS] - k[0])).abs();
    times_s.windows(MEANS + 1).zip(places.windows(MEANS + 1)).map(off).sum::<f64>() / times_s.len() as f64
}

/// The interval such that rows and gaps fill the time from the first of these rows to the last.
fn found(times_s: &[f64], rows: &Range<usize>, begin_s: f64) -> Stamps {
    let mut interval_s = begin_s;
    let mut gaps = gaps(times_s, interval_s);
    for _ in 0..ROUNDS {
        let lost = gaps.iter().filter(|(row, _)| rows.contains(row)).map(|(_, lost)| lost).sum();
        let next_s = mean(times_s, rows, lost);
        let is_same = next_s == interval_s;
        interval_s = next_s;
        if is_same {
            break;
        }
        gaps = self::gaps(times_s, interval_s);
    }
    let ends = gaps.iter().map(|(row, _)| row + 1).chain([times_s.len()]);
    let mut begin = 0;
    let pieces: Vec<Range<usize>> = ends.map(|end| std::mem::replace(&mut begin, end)..end).collect();
    let is_gap = |row: usize| gaps.binary_search_by_key(&row, |gap| gap.0).is_ok();
    let off = |(row, step): (usize, f64)| if is_gap(row) { 0.0 } else { (step / interval_s - 1.0).abs() };
    let jitter = steps(times_s).enumerate().map(off).fold(0.0, f64::max);
    let lost = gaps.iter().map(|(_, lost)| lost).sum();
    Stamps {
        interval_s,
        rows: times_s.len(),
        gaps: gaps.len(),
        pieces,
        lost,
        lost_before: gaps,
        is_uneven: false,
        jitter,
    }
}

/// Whether the steps are whole numbers of intervals, and most of them one.
fn is_even(times_s: &[f64], interval_s: f64) -> bool {
    let digit = DIGIT_S / interval_s;
    let in_digits =
        || times_s.iter().all(|time_s| (time_s / DIGIT_S - (time_s / DIGIT_S).round()).abs() < 1e-3);
    let most = if (EVEN..=MOST_DIGIT).contains(&digit) && in_digits() { 1.01 * digit } else { EVEN };
    let is_whole = |step: f64| {
        let intervals = step / interval_s;
        let off = (intervals - intervals.round()).abs();
        intervals > LONGEST_EVEN || (intervals.round() >= 1.0 && off < most)
    };
    let rows = times_s.len() as f64;
    let long = || steps(times_s).map(|step| step / interval_s).filter(|step| *step > LONG);
    let lost: f64 = long().map(|step| step - 1.0).sum();
    let few = long().count() as f64 <= if lost < rows { MOST_LOST } else { MOST_GAPS } * rows;
    few && steps(times_s).all(is_whole)
}

/// The rows before gaps, and how many intervals each gap has more than one.
fn gaps(times_s: &[f64], interval_s: f64) -> Vec<(usize, usize)> {
    let is_long = |step: &f64| *step > LONG * interval_s;
    if is_even(times_s, interval_s) {
        let long = steps(times_s).enumerate().filter(|(_, step)| is_long(step));
        return long.map(|(row, step)| (row, (step / interval_s).round() as usize - 1)).collect();
    }
    let long = steps(times_s).filter(is_long).count();
    let mut gaps = Vec::new();
    let mut begin = 0;
    for (row, step) in steps(times_s).enumerate().filter(|(_, step)| is_long(step)) {
        let rows = rows_beside(times_s.len(), long, step / interval_s);
        // When the row was due, by the stamps before and behind it: the earliest, as stamps are late rather than early.
        let before =
            (begin.max(row.saturating_sub(rows))..=row).map(|k| times_s[k] + (row - k) as f64 * interval_s);
        let behind =
            (row + 1..times_s.len().min(row + 1 + rows)).map(|k| times_s[k] - (k - row) as f64 * interval_s);
        let [before_s, behind_s] =
            [before.fold(f64::INFINITY, f64::min), behind.fold(f64::INFINITY, f64::min)];
        let lost = ((behind_s - before_s) / interval_s).round();
        // A single one is not told from scatter by a few rows.
        let is_told = row - begin >= FEW && row + FEW < times_s.len();
        if lost >= if is_told { 1.0 } else { 2.0 } {
            gaps.push((row, lost as usize));
            begin = row + 1;
        }
    }
    gaps
}

/// Number of rows before and behind one of `long` long steps that are looked at. Rows that waited for it are all written then, each less
/// late than the one before.
fn rows_beside(rows: usize, long: usize, waited: f64) -> usize {
    let apart = 2 * rows / (1 + long);
    let usual = if apart > MOST_ROWS { ROWS } else { apart.max(ROWS) };
    usual.max((2.0 * waited).min(MOST_ROWS as f64) as usize).min(usual.max(2 * apart))
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// Rows 0 to 999 at 100 Hz, less those that `is_lost`, with the stamps `late`.
    fn stamps(is_lost: impl Fn(usize) -> bool, late: impl Fn(usize) -> f64) -> Stamps {
        let times_s: Vec<f64> =
            (0..1000).filter(|k| !is_lost(*k)).map(|k| 0.01 * (k as f64 + late(k))).collect();
        read(&times_s)
    }

    fn jitter(k: usize) -> f64 {
        (k * 7919 % 97) as f64 / 97.0
    }

    /// A number from 0 to 1 that does not hang on those before.
    pub fn random(k: usize) -> f64 {
        let mixed = (k as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mixed = (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (mixed >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Of stamps that do not scatter, single rows that are lost near to each other are gaps too, and no row is moved.
    #[test]
    fn single_rows_are_missed_where_stamps_do_not_scatter() {
        let lost = [300, 304, 306, 308, 310, 311, 700, 998];
        let found = stamps(|k| lost.contains(&k), |_| 0.0);
        assert_eq!((found.gaps, found.lost), (7, 8), "{found:?}");
        assert!((found.interval_s / 0.01 - 1.0).abs() < 1e-9 && found.jitter < 1e-6, "{found:?}");
    }

    #[test]
    fn gaps_are_found_among_stamps_that_scatter() {
        for (late, jitter) in [
            ((|_| 0.0) as fn(usize) -> f64, 0.0..0.01),
            (jitter, 0.5..1.0),
            (|k| (3.0 * k as f64).round() / 3.0 - k as f64, 0.0..0.5),
        ] {
            let whole = stamps(|_| false, late);
            assert!(
                (whole.interval_s / 0.01 - 1.0).abs() < 2e-3
                    && (whole.pieces.len(), whole.pieces[0].len()) == (1, 1000)
                    && whole.lost == 0,
                "{whole:?}"
            );
            assert!(jitter.contains(&whole.jitter) || whole.jitter == 0.0, "{whole:?}");
            let lossy = stamps(|k| k == 300 || (500..900).contains(&k), late);
            // Where a gap begins is known as well as the stamps are.
            let long: Vec<_> = lossy.pieces.iter().filter(|piece| piece.len() > 5).collect();
            assert_eq!(
                (long.len(), long[0], long[1].start, long[2]),
                (3, &(0..300), 300, &(499..599)),
                "{lossy:?}"
            );
            assert!(lossy.lost.abs_diff(401) <= 1, "{lossy:?}");
            assert!((lossy.interval_s / 0.01 - 1.0).abs() < 2e-3, "{}", lossy.interval_s);
        }
    }

    /// A host that is late by a random time writes stamps whose usual step is shorter than the interval.
    #[test]
    fn stamps_that_are_late_by_a_random_time_have_no_gaps() {
        let late = |k: usize| 0.01 * (k as f64 - 2.0 * (1.0 - random(k)).ln());
        let times_s = (0..2000).scan(0.0, |last: &mut f64, k| {
            *last = late(k).max(*last + 1e-6);
            Some(*last)
        });
        let found = read(&times_s.collect::<Vec<f64>>());
        assert!((found.interval_s / 0.01 - 1.0).abs() < 1e-3 && found.gaps == 0, "{found:?}");
        for mean in [0.05, 0.2, 0.3] {
            for (from, lost) in [(600, 0), (600, 100), (300, 1)] {
                let rows = (0..2000).filter(|k| !(from..from + lost).contains(k));
                let late = |k: usize| 0.01 * (k as f64 - mean * (1.0 - random(k)).ln());
                // No row is written before the one in front of it.
                let times_s = rows.scan(0.0, |last: &mut f64, k| {
                    *last = late(k).max(*last + 1e-6);
                    Some(*last)
                });
                let found = read(&times_s.collect::<Vec<f64>>());
                assert!((found.interval_s / 0.01 - 1.0).abs() < 1e-4, "{mean}: {found:?}");
                // The last row before a gap may be so late that it seems to be behind one of one row.
                assert!(found.lost == lost && found.gaps <= 2 * lost.min(1), "{mean}: {found:?}");
            }
        }
    }

    #[test]
    fn batches_are_no_gaps() {
        for late in [|k: usize| (3 - k % 4) as f64, |k: usize| (3 - k % 4) as f64 + 0.02 * (k % 4) as f64] {
            let batches = stamps(|_| false, late);
            assert!(
                (batches.interval_s / 0.01 - 1.0).abs() < 5e-3 && batches.pieces.len() == 1,
                "{batches:?}"
            );
            assert!(batches.jitter > 1.0);
            let lossy = stamps(|k| (500..600).contains(&k), late);
            assert_eq!((lossy.pieces, lossy.lost), (vec![0..500, 500..900], 100));
        }
    }

    /// However many steps are long, and however long, the rows beside them are a few times those of the record.
    #[test]
    fn rows_beside_long_steps_are_bounded() {
        let rows = 1_000_000;
        for long in [1, 100, 1000, 10_000, 500_000] {
            for waited in [1.5, 40.0, 1e9, f64::INFINITY] {
                let looked = long * rows_beside(rows, long, waited);
                assert!(looked <= 20 * long + 5 * rows, "{long} {waited}: {looked}");
            }
        }
    }

    #[test]
    fn stamps_of_whole_seconds_are_batches() {
        for batch in [25, 50, 100, 200] {
            let found = stamps(|_| false, |k| -((k % batch) as f64));
            assert_eq!(found.pieces.len(), 1, "{batch}: {found:?}");
            assert!((found.interval_s / 0.01 - 1.0).abs() < 1e-9, "{batch}: {}", found.interval_s);
        }
    }

    /// Of rows at 120 to 250 Hz with stamps in whole milliseconds each one that is lost is missed, also where some are near to each other.
    #[test]
    fn whole_milliseconds_do_not_hide_lost_rows() {
        for rate_hz in [120.0, 160.0, 208.0, 250.0] {
            for part in [0.002, 0.02, 0.1] {
                let is_lost = |k: usize| k > 0 && k < 19_999 && random(k) < part;
                let at = |k: usize| (k as f64 / rate_hz * 1e3).floor() / 1e3;
                let found = read(&(0..20_000).filter(|k| !is_lost(*k)).map(at).collect::<Vec<f64>>());
                let lost = (0..20_000).filter(|k| is_lost(*k)).count();
                assert_eq!(found.lost, lost, "{rate_hz} {part}: {}", found.gaps);
                assert!((found.interval_s * rate_hz - 1.0).abs() < 2e-7, "{rate_hz}: {}", found.interval_s);
            }
        }
    }

    /// Rows of 40, 50 and 60 Hz at the ticks of Windows, also as whole milliseconds, have none that is lost; rows of 64 Hz have.
    #[test]
    fn ticks_of_windows_are_no_gaps() {
        for digits in [1e3, 1e6] {
            let of = |rate_hz: f64, is_lost: fn(usize) -> bool| {
                let at = |k: usize| ((k as f64 / rate_hz + 0.003) * 64.0).floor() / 64.0;
                let times_s = (0..4000).filter(|k| !is_lost(*k)).map(|k| (at(k) * digits).floor() / digits);
                read(&times_s.collect::<Vec<f64>>())
            };
            for rate_hz in [40.0, 50.0, 60.0] {
                let found = of(rate_hz, |_| false);
                assert!(
                    (found.interval_s * rate_hz - 1.0).abs() < 1e-4 && found.gaps == 0,
                    "{rate_hz}: {found:?}"
                );
            }
            let lossy = of(64.0, |k| random(k) < 0.06);
            assert!((lossy.interval_s * 64.0 - 1.0).abs() < 1e-4 && lossy.gaps > 150, "{lossy:?}");
        }
    }

    #[test]
    fn every_twentieth_row_that_is_lost_is_a_gap() {
        let lossy = stamps(|k| k % 20 == 10, |_| 0.0);
        assert_eq!((lossy.lost, lossy.pieces.len(), lossy.pieces[1].clone()), (50, 51, 10..29));
        assert!((lossy.interval_s / 0.01 - 1.0).abs() < 1e-9);
    }
}
