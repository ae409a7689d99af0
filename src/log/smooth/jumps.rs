//! The path of a filter that is corrected at fixes: it jumps at nearly regular times, and is smooth between them.
//!
//! The size of a jump is the difference of two parabolas, through the rows before and behind it. Without the jumps the path is smooth, and
//! drifts: its low frequencies are those of the path with the jumps.

use super::fit::median;
use crate::base::error::Error;
use crate::base::memory::room;

/// Horizontal position and height, as they are fitted.
pub(super) type Place = [f64; 4];

/// Rows on each side of a jump, and the value half a row beside them of the parabola of least squares: nearest row first.
const SIDE: usize = 5;
const BESIDE: [f64; SIDE] = [183.0 / 140.0, 20.5 / 140.0, -57.0 / 140.0, -49.5 / 140.0, 43.0 / 140.0];

/// Deviations of the differences without a jump above which there is one; least size of jumps [m], and in steps of the positions.
const CLEAR: f64 = 8.0;
const LEAST_M: f64 = 0.01;
const STEPS: f64 = 3.0;

/// Fewest jumps, share of the intervals between them that are multiples of the usual one, within that share of it; share of the span that
/// they cover; fewest rows of an interval.
const LEAST: usize = 5;
const REGULAR: f64 = 0.8;
const WITHIN: f64 = 0.25;
const COVERED: f64 = 0.5;
const LEAST_ROWS: f64 = 8.0;

/// Share of their size that jumps have at most once they are taken out.
const LEFT: f64 = 0.3;

/// Reach of the mean that is taken three times, in intervals of the corrections: it passes the low frequencies.
const REACH: f64 = 2.0;

/// What was found and taken out.
pub(super) struct Corrections {
    pub places: Vec<Place>,
    pub count: u64,
    /// Usual time between two of them [s].
    pub interval_s: f64,
}

/// The places without the jumps of corrections, if there are such; their steps are of `step_m` [m].
pub(super) fn without_jumps(
    times_s: &[f64],
    places: &[Place],
    step_m: f64,
) -> Result<Option<Corrections>, Error> {
    if places.len() < 4 * SIDE {
        return Ok(None);
    }
    let period_s = median(times_s.windows(2).map(|two| two[1] - two[0]))?;
    let differences = differences(times_s, places, period_s)?;
    let sizes = sizes(&differences)?;
    let usual = median(sizes.iter().copied())?;
    let mut jumps: Vec<usize> = room(sizes.len())?;
    jumps.extend((0..sizes.len()).filter(|&k| sizes[k] > CLEAR * 1.4826 * usual && is_peak(&sizes, k)));
    if jumps.len() < LEAST {
        return Ok(None);
    }
    let at_s = |jump: usize| times_s[jump + SIDE];
    let interval_s = median(jumps.windows(2).map(|two| at_s(two[1]) - at_s(two[0])))?;
    let is_regular = |two: &[usize]| {
        let count = (at_s(two[1]) - at_s(two[0])) / interval_s;
        count > 0.5 && (count - count.round()).abs() < WITHIN
    };
    let regular = jumps.windows(2).filter(|two| is_regular(two)).count();
    let size_m = median(jumps.iter().map(|&jump| sizes[jump]))?;
    let span_s = times_s[times_s.len() - 1] - times_s[0];
    let is_model = regular as f64 >= REGULAR * (jumps.len() - 1) as f64
        && jumps.len() as f64 * interval_s > COVERED * span_s
        && interval_s > LEAST_ROWS * period_s
        && size_m > LEAST_M.max(STEPS * step_m);
    if !is_model {
        return Ok(None);
    }
    let mut drifting: Vec<Place> = room(places.len())?;
    let (mut next, mut sum) = (0, Place::default());
    for (row, place) in places.iter().enumerate() {
        while next < jumps.len() && jumps[next] + SIDE <= row {
            let jump = &differences[jumps[next]];
            (0..4).for_each(|axis| sum[axis] += jump[axis]);
            next += 1;
        }
        drifting.push(core::array::from_fn(|axis| place[axis] - sum[axis]));
    }
    let after = self::sizes(&self::differences(times_s, &drifting, period_s)?)?;
    let near = |jump: usize| {
        let around = &after[jump.saturating_sub(SIDE - 1)..(jump + SIDE).min(after.len())];
        around.iter().copied().fold(0.0, f64::max)
    };
    // A spike leaves its other edge.
    if median(jumps.iter().map(|&jump| near(jump)))? > LEFT * size_m {
        return Ok(None);
    }
    add_low_frequencies(&mut drifting, places, (REACH * interval_s / period_s).round() as usize)?;
    Ok(Some(Corrections { places: drifting, count: jumps.len() as u64, interval_s }))
}

/// Adds the low frequencies of the path with the jumps less the one without.
fn add_low_frequencies(drifting: &mut [Place], places: &[Place], reach: usize) -> Result<(), Error> {
    let mut low: Vec<Place> = room(places.len())?;
    low.extend(
        places
            .iter()
            .zip(&*drifting)
            .map(|(a, b)| core::array::from_fn::<f64, 4, _>(|axis| a[axis] - b[axis])),
    );
    for _ in 0..3 {
        low = means(&low, reach)?;
    }
    for (place, low) in drifting.iter_mut().zip(&low) {
        (0..4).for_each(|axis| place[axis] += low[axis]);
    }
    Ok(())
}

/// The same of the heights alone.
pub(super) fn without_jumps_of_heights(
    times_s: &[f64],
    places: &[Place],
    step_m: f64,
) -> Result<Option<Corrections>, Error> {
    let mut heights: Vec<Place> = room(places.len())?;
    heights.extend(places.iter().map(|place| [0.0, 0.0, 0.0, place[3]]));
    without_jumps(times_s, &heights, step_m)
}

/// For each row from `SIDE` on, what the path jumps by before it; 0 where the rows are not even.
fn differences(times_s: &[f64], places: &[Place], period_s: f64) -> Result<Vec<Place>, Error> {
    let mut list: Vec<Place> = room(places.len())?;
    for (times_s, rows) in times_s.windows(2 * SIDE).zip(places.windows(2 * SIDE)) {
        let is_even = times_s.windows(2).all(|two| (two[1] - two[0] - period_s).abs() < 0.2 * period_s);
        let mut difference = Place::default();
        for (offset, weight) in BESIDE.iter().enumerate().filter(|_| is_even) {
            let (behind, before) = (&rows[SIDE + offset], &rows[SIDE - 1 - offset]);
            (0..4).for_each(|axis| difference[axis] += weight * (behind[axis] - before[axis]));
        }
        list.push(difference);
    }
    Ok(list)
}

fn sizes(differences: &[Place]) -> Result<Vec<f64>, Error> {
    let mut list: Vec<f64> = room(differences.len())?;
    list.extend(differences.iter().map(|jump| jump.iter().map(|part| part * part).sum::<f64>().sqrt()));
    Ok(list)
}

/// Whether a size is the largest of those whose rows it shares.
fn is_peak(sizes: &[f64], k: usize) -> bool {
    let around = &sizes[k.saturating_sub(SIDE - 1)..(k + SIDE).min(sizes.len())];
    around.iter().all(|other| *other <= sizes[k])
}

/// Means of the values up to `reach` rows away.
fn means(values: &[Place], reach: usize) -> Result<Vec<Place>, Error> {
    let mut sums: Vec<Place> = room(values.len() + 1)?;
    let mut sum = Place::default();
    sums.push(sum);
    for value in values {
        (0..4).for_each(|axis| sum[axis] += value[axis]);
        sums.push(sum);
    }
    let mut list: Vec<Place> = room(values.len())?;
    for k in 0..values.len() {
        let (first, next) = (k.saturating_sub(reach), (k + reach + 1).min(values.len()));
        let count = (next - first) as f64;
        list.push(core::array::from_fn(|axis| (sums[next][axis] - sums[first][axis]) / count));
    }
    Ok(list)
}
