//! The rows of a log on which a quantity is new: a position, a height or an attitude.
//!
//! Rows that repeat a value are those of a slower source, or those of a vehicle at rest. A slower source shows at the end of a run of equal
//! values: the value changes at once by what the vehicle did meanwhile. Behind a rest, the next value is about that of the rest.

use super::fit::median;
use crate::base::error::Error;
use crate::base::memory::room;

/// Share of held rows above which the source is slower than the rows, and share of the mean rate below which a value does not change.
const HELD: f64 = 0.03;
const MOVING: f64 = 0.05;

/// Steps of the values up to which a change behind a run of equal values is that of their resolution.
const STEPS: f64 = 3.0;

/// Intervals of the source above which equal values are a rest, or a source that froze, or one after the other. Ways of an interval, at the
/// speed behind, above which the first change is that of a source that froze before the vehicle moved off; and the time in which it moved
/// off, over that of the change at the speed behind: that of a steady acceleration.
const LONG: f64 = 3.0;
const FROZE: f64 = 1.5;
const MOVED_OFF: f64 = 2.0;

/// Intervals of the source up to which equal values at the end of the log are those of a slower source.
const LAST: f64 = 1.5;

/// A quantity along the rows of a log.
pub(super) struct Quantity<'a> {
    pub times_s: &'a [f64],
    /// Whether the value of a row is that of the row before, to the last bit.
    pub is_equal: &'a dyn Fn(usize) -> bool,
    /// Distance between the values of two rows.
    pub distance: &'a dyn Fn(usize, usize) -> f64,
    /// The step of its values; 0: none.
    pub step: f64,
}

/// Equal values that follow each other: those of the rows from `first` up to `next`. At rest are those before `moves_off`.
struct Run {
    first: usize,
    next: usize,
    is_held: bool,
    moves_off: usize,
}

impl Quantity<'_> {
    /// The rows on which it is new: the first of each run of equal values; and at rest a row for each interval of the source.
    pub fn fresh(&self) -> Result<Vec<usize>, Error> {
        let mut runs = self.runs()?;
        let times_s = self.times_s;
        let held: usize = runs.iter().filter(|run| run.is_held).map(|run| run.next - run.first - 1).sum();
        let mut source_s = median(times_s.windows(2).map(|two| two[1] - two[0]))?;
        if held as f64 > HELD * times_s.len() as f64 {
            let mut moving = room(runs.len())?;
            let lasts = runs.windows(2).filter(|two| two[0].is_held || two[0].next == two[0].first + 1);
            moving.extend(lasts.map(|two| times_s[two[1].first] - times_s[two[0].first]));
            source_s = median(moving.into_iter())?;
        }
        for k in 0..runs.len().saturating_sub(2) {
            let (first_s, next_s) = (times_s[runs[k].first], times_s[runs[k].next]);
            if next_s - first_s > LONG * source_s {
                let moves_off = self.moves_off(&runs[k], &runs[k + 1], &runs[k + 2], source_s);
                (runs[k].is_held, runs[k].moves_off) = (false, moves_off);
            }
        }
        let mut list: Vec<usize> = room(times_s.len())?;
        let last = runs.len() - 1;
        for (place, run) in runs.iter().enumerate() {
            list.push(run.first);
            // The last run has no end that shows what it is.
            let length_s = times_s[run.next - 1] - times_s[run.first];
            let ends_held =
                place == last && place > 0 && runs[place - 1].is_held && length_s < LAST * source_s;
            if run.is_held || ends_held {
                continue;
            }
            let mut last_s = times_s[run.first];
            for (k, &time_s) in times_s.iter().enumerate().take(run.moves_off).skip(run.first + 1) {
                if time_s - last_s > 0.9 * source_s {
                    list.push(k);
                    last_s = time_s;
                }
            }
        }
        Ok(list)
    }

    fn runs(&self) -> Result<Vec<Run>, Error> {
        let (times_s, count) = (self.times_s, self.times_s.len());
        let length: f64 = (1..count).map(|k| (self.distance)(k - 1, k)).sum();
        let mean = length / (times_s[count - 1] - times_s[0]);
        let mut runs: Vec<Run> = room(count)?;
        let mut first = 0;
        while first < count {
            let next = (first + 1..count).find(|&k| !(self.is_equal)(k)).unwrap_or(count);
            let is_held = next > first + 1 && next < count && {
                // An outlier behind a rest is followed by the value of the rest.
                let behind = (next + 1).min(count - 1);
                let change = (self.distance)(first, next).min((self.distance)(first, behind));
                change > STEPS * self.step && change > MOVING * mean * (times_s[next] - times_s[first])
            };
            runs.push(Run { first, next, is_held, moves_off: next });
            first = next;
        }
        Ok(runs)
    }

    /// The row of a rest from which on the source froze, as the change behind it shows; or its end.
    fn moves_off(&self, rest: &Run, now: &Run, behind: &Run, source_s: f64) -> usize {
        let (times_s, distance) = (self.times_s, self.distance);
        let change = distance(rest.first, now.first).min(distance(rest.first, behind.first));
        let speed = distance(now.first, behind.first) / (times_s[behind.first] - times_s[now.first]);
        if change <= STEPS * self.step || change <= FROZE * speed * source_s {
            return rest.next;
        }
        let from_s = times_s[now.first] - MOVED_OFF * change / speed;
        (rest.first + 1..rest.next).find(|&k| times_s[k] > from_s).unwrap_or(rest.next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fresh(values: &[f64], step: f64) -> Vec<usize> {
        let times_s: Vec<f64> = (0..values.len()).map(|k| 0.1 * k as f64).collect();
        let quantity = Quantity {
            times_s: &times_s,
            is_equal: &|k| values[k] == values[k - 1],
            distance: &|a, b| (values[a] - values[b]).abs(),
            step,
        };
        quantity.fresh().unwrap()
    }

    /// A source at a fifth of the rate of the rows, to the end; the same with rests, which have a row for each of its intervals.
    #[test]
    fn a_slower_source_is_new_once_an_interval() {
        let held: Vec<f64> = (0..103).map(|k| f64::from(k / 5)).collect();
        assert_eq!(fresh(&held, 0.0), (0..21).map(|k| 5 * k).collect::<Vec<_>>());
        let rests: Vec<f64> = (0..300).map(|k| f64::from((k / 5).clamp(20, 40))).collect();
        assert_eq!(fresh(&rests, 0.0), (0..60).map(|k| 5 * k).collect::<Vec<_>>());
    }

    /// A vehicle at rest that moves off gently, one whose values have steps, and an outlier behind a rest: every row counts.
    #[test]
    fn a_rest_is_no_slower_source() {
        let every: Vec<usize> = (0..200).collect();
        let moves_off: Vec<f64> = (0..200).map(|k| 0.05 * f64::from(k - 100).max(0.0).powi(2)).collect();
        assert_eq!(fresh(&moves_off, 0.0), every);
        let steps: Vec<f64> = (0..200).map(|k| (f64::from(k) / 7.0).floor()).collect();
        assert_eq!(fresh(&steps, 1.0), every);
        let mut outlier = moves_off;
        outlier[50] = 300.0;
        assert_eq!(fresh(&outlier, 0.0), every);
    }

    /// A source that froze at a rest, from which the vehicle moved off in the last 3 s of it: these rows are left out.
    #[test]
    fn a_source_that_froze_at_a_rest_is_left_out() {
        let moves_off = |k: i32| if k < 180 { 0.0 } else { (0.1 * f64::from(k - 150)).powi(2) };
        let froze: Vec<f64> = (0..300).map(moves_off).collect();
        let rows = fresh(&froze, 0.0);
        let kept = rows.iter().filter(|&&row| row < 180).count();
        assert!((145..=152).contains(&kept) && rows[kept..] == (180..300).collect::<Vec<_>>(), "{kept}");
    }

    /// A source that froze while the vehicle moved on has no row there.
    #[test]
    fn a_source_that_froze_is_left_out() {
        let froze: Vec<f64> =
            (0..200).map(|k| f64::from(if (60..160).contains(&k) { 60 } else { k })).collect();
        assert_eq!(fresh(&froze, 0.0), (0..=60).chain(160..200).collect::<Vec<_>>());
    }
}
