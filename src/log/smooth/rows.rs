//! The rows of a log that a path is fitted to.

use crate::base::error::{Error, Rule};
use crate::base::math::{Euler, attitude_from_euler, relative_rotation, rotation_vector};
use crate::base::memory::room;
use crate::base::units::DEG;
use crate::earth::{Earth, Geodetic};
use crate::judge::{Finding, Judge, Kind, MAX_FINDINGS};
use crate::truth::FlightSample;

use super::fit::median;
use super::fresh::Quantity;

/// Rows that a fit needs.
const LEAST: usize = 20;

/// Longest gap that is bridged \[s\], or in usual intervals if these are long: behind a longer one there is another flight, or a wrong
/// stamp.
const LONGEST_GAP_S: f64 = 300.0;
const GAP_INTERVALS: f64 = 30.0;

/// Share of the usual interval below which a row is too near to the row before.
const NEAR: f64 = 0.2;

/// Edges that stairs need, and share of them at which the number of steps of a change goes up and down again, or the reverse: rounding
/// scatters, and a steady climb or a steady thrust does not.
const LEAST_EDGES: u32 = 4;
const SCATTERS: f64 = 0.2;

/// Acceleration of a change between rows without one that no vehicle flies [m/s²]: such an edge is one of stairs by itself, up to the
/// coarsest that logs have, 100 ft [m].
const NOT_FLOWN_M_S2: f64 = 150.0;
const COARSEST_M: f64 = 31.0;

/// Steps of angles that logs have [deg], the coarsest first; and steps over which angles must extend to have them.
const ANGLES_DEG: [f64; 5] = [1.0, 0.5, 0.1, 0.05, 0.01];
const LEAST_STEPS: f64 = 4.0;

/// Rows that were kept, with the times of a steady clock if the stamps scatter about one.
pub(super) struct Rows {
    pub samples: Vec<FlightSample>,
    pub times_s: Vec<f64>,
    /// The rows on which latitude and longitude, the height, and the attitude are new.
    pub places: Vec<usize>,
    pub heights: Vec<usize>,
    pub attitudes: Vec<usize>,
    pub is_steady_clock: bool,
    /// Rows whose position was left out: from before the first fix, repeats, and rows too near to the row before.
    pub left_out: u64,
    /// The steps of the horizontal positions and of the heights [m]; 0: none.
    pub steps_m: [f64; 2],
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
    let list = apart(kept)?;
    let mut times_s = room(list.len())?;
    times_s.extend(list.iter().map(|sample| sample.time_s));
    if is_steady_clock && list.len() >= LEAST {
        steady(&mut times_s)?;
    }
    let [horizontal_m, judged_m] = judge.steps_m();
    let height_step_m = judged_m.max(stairs_m(&list));
    let places = Quantity {
        times_s: &times_s,
        is_equal: &|k| is_over(&list[k].place, &list[k - 1].place),
        distance: &|a, b| {
            let level = |k: usize| Geodetic { height_m: 0.0, ..list[k].place };
            earth.displacement(&level(a), &level(b)).0.norm_squared().sqrt()
        },
        step: horizontal_m,
    };
    let places = places.fresh()?;
    if places.len() < LEAST {
        let rule = Rule::AtLeast("rows that are not repeats, to fit a path to them:", (LEAST as u64).into());
        return Err(Error::invalid("samples", places.len() as u64, rule));
    }
    let heights = Quantity {
        times_s: &times_s,
        is_equal: &|k| list[k].place.height_m == list[k - 1].place.height_m,
        distance: &|a, b| (list[a].place.height_m - list[b].place.height_m).abs(),
        step: height_step_m,
    };
    let heights = not_repeated(heights.fresh()?, &places, heights.is_equal);
    let attitudes = Quantity {
        times_s: &times_s,
        is_equal: &|k| list[k].euler == list[k - 1].euler,
        distance: &|a, b| angle(&list[a].euler, &list[b].euler),
        step: angle_step(&list),
    };
    let attitudes = not_repeated(attitudes.fresh()?, &places, attitudes.is_equal);
    let mut findings = room(MAX_FINDINGS)?;
    findings.extend(judge.findings());
    Ok(Rows {
        left_out: (samples.len() - places.len()) as u64,
        samples: list,
        times_s,
        places,
        heights,
        attitudes,
        is_steady_clock,
        steps_m: [horizontal_m, height_step_m],
        findings,
    })
}

/// The rows of `fresh` without those that repeat a value together with the position: they repeat the whole record. Fewer than a fit needs
/// are the rows of the positions.
fn not_repeated(mut fresh: Vec<usize>, places: &[usize], is_equal: &dyn Fn(usize) -> bool) -> Vec<usize> {
    fresh.retain(|&row| row == 0 || places.binary_search(&row).is_ok() || !is_equal(row));
    if fresh.len() < LEAST { places.to_vec() } else { fresh }
}

/// Whether two places are over one point of the ellipsoid.
fn is_over(a: &Geodetic, b: &Geodetic) -> bool {
    a.latitude_rad == b.latitude_rad && a.longitude_rad == b.longitude_rad
}

/// The step of heights that change by multiples of it, by rounding [m]: their number scatters, or nobody flies them; 0: they do not. Any
/// step counts, not only those that logs usually have.
fn stairs_m(samples: &[FlightSample]) -> f64 {
    let changes = || samples.windows(2).map(|two| two[1].place.height_m - two[0].place.height_m);
    let least_m = changes().map(f64::abs).filter(|change| *change > 0.0).fold(f64::INFINITY, f64::min);
    let (mut edges, mut scattered, mut not_flown) = (0_u32, 0_u32, 0_u32);
    let (mut steps_before, mut growth_before) = (0.0, 0.0);
    for change in changes() {
        let (multiple, steps) = (change / least_m, (change / least_m).round());
        if (multiple - steps).abs() > 0.02 * multiple.abs().max(1.0) {
            return 0.0;
        }
        let growth = steps - steps_before;
        edges += u32::from(steps != 0.0);
        scattered += u32::from(growth * growth_before < 0.0);
        (steps_before, growth_before) = (steps, growth);
    }
    for four in samples.windows(4) {
        let height_m = |k: usize| four[k].place.height_m;
        let (change_m, length_s) = (height_m(2) - height_m(1), four[2].time_s - four[1].time_s);
        let is_alone = height_m(0) == height_m(1) && height_m(2) == height_m(3);
        not_flown += u32::from(is_alone && change_m.abs() > NOT_FLOWN_M_S2 * length_s * length_s);
    }
    if edges > 0 && not_flown == edges && least_m < COARSEST_M {
        return least_m;
    }
    if edges >= LEAST_EDGES && f64::from(scattered) > SCATTERS * f64::from(edges) { least_m } else { 0.0 }
}

/// Angle between two attitudes [rad].
fn angle(a: &Euler, b: &Euler) -> f64 {
    let [a, b] = [a, b].map(attitude_from_euler);
    rotation_vector(&relative_rotation(&a, &b)).norm_squared().sqrt()
}

/// The step of which all angles of the attitude are multiples [rad]; 0: none.
fn angle_step(samples: &[FlightSample]) -> f64 {
    let angles = |sample: &FlightSample| [sample.euler.roll, sample.euler.pitch, sample.euler.heading];
    let is_step = |step: f64| {
        let is_multiple = |angle: f64| {
            let multiple = angle / step;
            (multiple - multiple.round()).abs() < 0.02
        };
        samples.iter().all(|sample| angles(sample).into_iter().all(is_multiple))
    };
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for sample in samples {
        for (k, angle) in angles(sample).into_iter().enumerate() {
            (low[k], high[k]) = (low[k].min(angle), high[k].max(angle));
        }
    }
    let extent = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    let steps = ANGLES_DEG.map(|degrees| degrees * DEG);
    steps.into_iter().find(|step| extent >= LEAST_STEPS * step && is_step(*step)).unwrap_or(0.0)
}

/// The usual interval of `samples` [s].
fn usual_s(samples: &[FlightSample]) -> Result<f64, Error> {
    median(samples.windows(2).map(|two| two[1].time_s - two[0].time_s))
}

/// The rows that are not nearer to the row before than a fifth of the usual interval.
fn apart(samples: &[FlightSample]) -> Result<Vec<FlightSample>, Error> {
    let least_s = NEAR * usual_s(samples)?;
    let mut list: Vec<FlightSample> = room(samples.len())?;
    for sample in samples {
        if list.last().is_none_or(|last| sample.time_s - last.time_s >= least_s) {
            list.push(*sample);
        }
    }
    Ok(list)
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
