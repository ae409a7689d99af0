//! The rows of a log that a path is fitted to.

use crate::base::error::{Error, Rule};
use crate::base::math::Euler;
use crate::base::memory::room;
use crate::earth::Earth;
use crate::judge::{Finding, Judge, Kind, MAX_FINDINGS};
use crate::truth::FlightSample;

use super::fit::median;

/// Rows that a fit needs.
const LEAST: usize = 20;

/// Longest gap that is bridged \[s\], or in usual intervals if these are long: behind a longer one there is another flight, or a wrong
/// stamp.
const LONGEST_GAP_S: f64 = 300.0;
const GAP_INTERVALS: f64 = 30.0;

/// Share of the usual interval below which a row is too near to the row before.
const NEAR: f64 = 0.2;

/// Share of held rows above which the receiver is slower than the rows, and share of the mean speed below which a row does not move.
const HELD: f64 = 0.03;
const MOVING: f64 = 0.05;

/// Intervals of the receiver without a new fix behind which it froze, and share of these rows that have a new attitude if that did not.
const FROZEN: f64 = 3.0;
const LIVE: f64 = 0.5;

/// Rows that were kept, with the times of a steady clock if the stamps scatter about one.
pub(super) struct Rows {
    pub samples: Vec<FlightSample>,
    pub times_s: Vec<f64>,
    /// Times and attitudes: also those of rows whose fix froze.
    pub attitudes: (Vec<f64>, Vec<Euler>),
    pub is_steady_clock: bool,
    /// Rows whose position was left out: from before the first fix, repeats, and rows too near to the row before.
    pub left_out: u64,
    /// The step of the heights [m]; 0: none.
    pub height_step_m: f64,
    /// What was found in all rows.
    pub findings: Vec<Finding>,
}

/// The rows of `samples`.
pub(super) fn rows(earth: &Earth, samples: &[FlightSample], has_attitude: bool) -> Result<Rows, Error> {
    let mut judge = Judge::new(*earth, f64::INFINITY)?;
    if !has_attitude {
        judge.ignore_attitude();
    }
    for (index, sample) in samples.iter().enumerate() {
        judge.push(sample).map_err(|error| error.at(index))?;
    }
    let count_of =
        |kind: Kind| judge.findings().find(|finding| finding.kind == kind).map_or(0, |found| found.count);
    let zeros = (count_of(Kind::NotYetFixed) as usize).min(samples.len());
    let is_steady_clock = judge.findings().any(|finding| finding.kind == Kind::StampJitter);
    let kept = &samples[zeros..];
    let longest_s = LONGEST_GAP_S.max(GAP_INTERVALS * usual_s(kept)?);
    for (index, two) in kept.windows(2).enumerate() {
        let gap_s = two[1].time_s - two[0].time_s;
        if gap_s > longest_s {
            let rule = Rule::AtMost(
                "a path is fitted to one flight at a time, whose gaps are at most",
                longest_s.into(),
            );
            return Err(Error::invalid("gap_s", gap_s, rule).at(zeros + index + 1));
        }
    }
    let mut list: Vec<FlightSample> = room(kept.len())?;
    let mut attitudes = (room(kept.len())?, room(kept.len())?);
    fresh(earth, kept, |row, is_fix| {
        if is_fix {
            list.push(*row);
        }
        attitudes.0.push(row.time_s);
        attitudes.1.push(row.euler);
    })?;
    if list.len() < LEAST {
        let rule = Rule::AtLeast("rows that are not repeats, to fit a path to them:", (LEAST as u64).into());
        return Err(Error::invalid("samples", list.len() as u64, rule));
    }
    let mut times_s = room(list.len())?;
    times_s.extend(list.iter().map(|sample| sample.time_s));
    if is_steady_clock {
        steady(&mut times_s)?;
        steady(&mut attitudes.0)?;
    }
    let left_out = (samples.len() - list.len()) as u64;
    let mut findings = room(MAX_FINDINGS)?;
    findings.extend(judge.findings());
    let height_step_m = judge.height_step_m();
    Ok(Rows { samples: list, times_s, attitudes, is_steady_clock, left_out, height_step_m, findings })
}

/// The usual interval of `samples` [s].
fn usual_s(samples: &[FlightSample]) -> Result<f64, Error> {
    median(samples.windows(2).map(|two| two[1].time_s - two[0].time_s))
}

/// Keeps the first row of each run of equal positions while the vehicle moves; at rest a row for each interval of the receiver; and none
/// nearer to the row before than a fifth of the usual interval. Rows of a receiver that froze are kept for their attitude, if it is live:
/// `keep` gets false.
fn fresh(
    earth: &Earth,
    samples: &[FlightSample],
    mut keep: impl FnMut(&FlightSample, bool),
) -> Result<(), Error> {
    let count = samples.len();
    let usual_s = usual_s(samples)?;
    let mut path_m: Vec<f64> = room(count)?;
    let mut length_m = 0.0;
    path_m.push(0.0);
    for two in samples.windows(2) {
        length_m += earth.displacement(&two[0].place, &two[1].place).0.norm_squared().sqrt();
        path_m.push(length_m);
    }
    let is_held = |k: usize| {
        let (before, now) = (&samples[k - 1].place, &samples[k].place);
        before.latitude_rad == now.latitude_rad && before.longitude_rad == now.longitude_rad
    };
    let speed =
        |from: usize, to: usize| (path_m[to] - path_m[from]) / (samples[to].time_s - samples[from].time_s);
    let held = (1..count).filter(|&k| is_held(k)).count();
    let is_slow = held as f64 > HELD * count as f64 && length_m > 0.0;
    let mean = if count > 1 { speed(0, count - 1) } else { 0.0 };
    let reach = (count / 200).max(1);
    // For each row, the one behind the run of equal positions that it belongs to, and the first of the run.
    let mut run_of: Vec<[usize; 2]> = room(count)?;
    let mut first = 0;
    while first < count {
        let next = (first + 1..count).find(|&k| !is_held(k)).unwrap_or(count);
        run_of.extend((first..next).map(|_| [first, next.min(count - 1)]));
        first = next;
    }
    // Fixes that froze end with the way that was made meanwhile. An outlier behind a rest is followed by the place of the rest.
    let through_run = |[first, next]: [usize; 2]| {
        let way_m = |k: usize| {
            let (way, _) = earth.displacement(&samples[first].place, &samples[k.min(count - 1)].place);
            way.norm_squared().sqrt()
        };
        let time_s = samples[next].time_s - samples[first].time_s;
        if time_s > 0.0 { way_m(next).min(way_m(next + 1)) / time_s } else { 0.0 }
    };
    let moves = |k: usize| {
        let near = speed(k.saturating_sub(reach), (k + reach).min(count - 1));
        !is_slow || near > MOVING * mean || through_run(run_of[k]) > MOVING * mean
    };
    // The interval of the receiver.
    let mut fresh_s: Vec<f64> = room(count)?;
    if is_slow {
        fresh_s.extend((1..count).filter(|&k| !is_held(k) && moves(k)).map(|k| samples[k].time_s));
    }
    let receiver_s = if is_slow { median(fresh_s.windows(2).map(|two| two[1] - two[0]))? } else { usual_s };
    let is_turned = |k: usize| samples[k].euler != samples[k - 1].euler;
    let is_live = |[first, next]: [usize; 2]| {
        let turned = (first + 1..next).filter(|&k| is_turned(k)).count();
        samples[next].time_s - samples[first].time_s > FROZEN * receiver_s
            && turned as f64 > LIVE * (next - first - 1) as f64
    };
    let (mut last_s, mut last_attitude_s) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    let mut live_run = None;
    for (k, sample) in samples.iter().enumerate() {
        let since_s = sample.time_s - last_s;
        let is_fresh = k == 0 || !is_held(k);
        if is_fresh {
            live_run = Some(run_of[k]).filter(|run| is_live(*run));
        }
        if since_s >= NEAR * usual_s && (is_fresh || !moves(k) && since_s > 0.9 * receiver_s) {
            keep(sample, true);
            (last_s, last_attitude_s) = (sample.time_s, sample.time_s);
        } else if live_run.is_some() && sample.time_s - last_attitude_s >= NEAR * usual_s {
            keep(sample, false);
            last_attitude_s = sample.time_s;
        }
    }
    Ok(())
}

/// Replaces the stamps by those of a steady clock: the line through them over the number of usual intervals.
fn steady(times_s: &mut [f64]) -> Result<(), Error> {
    let usual_s = median(times_s.windows(2).map(|two| two[1] - two[0]))?;
    let mut ticks = room(times_s.len())?;
    let mut tick = 0.0;
    ticks.push(tick);
    for two in times_s.windows(2) {
        tick += ((two[1] - two[0]) / usual_s).round().max(1.0);
        ticks.push(tick);
    }
    let count = times_s.len() as f64;
    let (middle, start_s) = (ticks.iter().sum::<f64>() / count, times_s[0]);
    let mean_s = times_s.iter().map(|time_s| time_s - start_s).sum::<f64>() / count;
    let (mut square, mut product) = (0.0, 0.0);
    for (tick, time_s) in ticks.iter().zip(&*times_s) {
        square += (tick - middle) * (tick - middle);
        product += (tick - middle) * (time_s - start_s - mean_s);
    }
    for (tick, time_s) in ticks.iter().zip(times_s) {
        *time_s = start_s + mean_s + (tick - middle) * (product / square);
    }
    Ok(())
}
