//! A robust fit of samples by a spline, with a cut-off that the samples set.

use core::f64::consts::PI;

use super::check_steps;
use super::spectrum::spectrum;
use super::spline::{Knots, Normal, Spline};
use crate::base::error::Error;
use crate::base::math::{exp, ln, sin_cos};
use crate::base::memory::room;
use nalgebra::{Matrix3, Vector3};

/// Tukey's constant: residuals beyond that many deviations have no weight.
const TUKEY: f64 = 4.685;

/// Rounds of weights, and weight below which a row is an outlier.
const ROUNDS: usize = 4;
const OUTLIER: f64 = 0.01;

/// Share of the usual step below which the scale of residuals does not fall.
const LEAST_SHARE: f64 = 0.02;

/// A row is a spike if it is that many medians beside the cubic of its neighbours.
const SPIKE: f64 = 50.0;

/// Share of the noise of rounding below which the white noise that a spectrum shows is not that of the steps: the values are stairs.
const STAIRS: f64 = 0.8;

/// Residuals of rounding are within half a step: within this share of it, but for a hundredth of the rows. Factor of a cut-off to the next.
const WITHIN_STEP: f64 = 0.6;
const BEYOND_STEP: f64 = 0.01;
const FINER: f64 = 1.25;

/// Time over which the squared jerk is averaged, in units of 1/(2π f_c); and bounds of its ratio to the mean.
const SPAN: f64 = 8.0;
const JERKS: (f64, f64) = (0.01, 30.0);

/// Samples of a curve and what is known of them.
pub(super) struct Samples<'a, const N: usize> {
    pub times_s: &'a [f64],
    pub values: &'a [[f64; N]],
    /// White noise of a component, if it is known.
    pub sigma: Option<f64>,
    /// Largest cut-off [Hz].
    pub cap_hz: f64,
    /// Step of which the values are multiples, as that of a component; 0: none.
    pub step: f64,
}

/// A curve through samples.
#[derive(Debug, Clone)]
pub(super) struct Curve<const N: usize> {
    spline: Spline<N>,
    /// The parabola of least squares, which the penalty does not see: by its coefficients in x = (t - start) / span.
    parabola: [[f64; N]; 3],
    start_s: f64,
    span_s: f64,
    /// Cut-off [Hz].
    pub cutoff_hz: f64,
    /// Usual interval of the samples [s].
    period_s: f64,
    /// Noise of a component: median of the residuals.
    pub noise: f64,
    /// Rows whose weight is 0.
    pub outliers: u64,
    /// Largest residual of the rows that have weight, and its time [s].
    pub largest: (f64, f64),
}

impl<const N: usize> Curve<N> {
    /// The derivative of order 0 or 1 at a time.
    pub fn at(&self, time_s: f64, order: usize) -> [f64; N] {
        let mut value = self.spline.at(time_s, order);
        let x = (time_s - self.start_s) / self.span_s;
        let basis =
            if order == 0 { [1.0, x, x * x] } else { [0.0, 1.0 / self.span_s, 2.0 * x / self.span_s] };
        for (share, coefficient) in basis.iter().zip(&self.parabola) {
            (0..N).for_each(|k| value[k] += share * coefficient[k]);
        }
        value
    }

    /// The curve of samples, of which there are at least 16, in the order of time.
    pub fn through(samples: &Samples<'_, N>) -> Result<Self, Error> {
        let &Samples { times_s, values, sigma, cap_hz, step } = samples;
        let (start_s, end_s) = (times_s[0], times_s[times_s.len() - 1]);
        let span_s = end_s - start_s;
        let period_s = median(times_s.windows(2).map(|two| two[1] - two[0]))?;
        check_steps(span_s, period_s, times_s.len())?;
        let mut weights: Vec<f64> = room(times_s.len())?;
        weights.resize(times_s.len(), 1.0);
        let without = without_spikes(times_s, values, &mut weights)?;
        let found = spectrum(&even(times_s, &without, period_s)?, period_s)?;
        let lowest_hz = 1.5 / span_s;
        let mut cutoff_hz = found.cutoff_hz.min(cap_hz).max(lowest_hz);
        let largest = values.iter().flatten().map(|value| value.abs()).fold(0.0, f64::max);
        // Values that are all 0 have no size.
        let size = if largest > 0.0 { largest } else { 1.0 };
        // Values with steps have their noise, also where they stay the same.
        let rounding = step / 12f64.sqrt();
        let is_stairs = found.white < STAIRS * rounding;
        let sigma = sigma.unwrap_or(0.0).max(found.white).max(1e-12 * size).max(rounding);
        let parabola = parabola(times_s, values);
        let steps = values.windows(2).map(|two| distance(&two[0], &two[1]));
        let least = LEAST_SHARE * median(steps)? / (N as f64).sqrt();
        let knots_of = |cutoff_hz: f64| Knots::new(start_s, end_s, period_s.max(1.0 / (16.0 * cutoff_hz)));
        let density_of = |cutoff_hz: f64| {
            let omega = 2.0 * PI * cutoff_hz;
            omega * omega * omega * omega * omega * omega * sigma * sigma * period_s
        };
        let mut curve = Self {
            spline: Spline::at_rest(knots_of(cutoff_hz))?,
            parabola,
            start_s,
            span_s,
            cutoff_hz,
            period_s,
            noise: 0.0,
            outliers: 0,
            largest: (0.0, start_s),
        };
        let residuals_of = |curve: &Self| -> Result<Vec<f64>, Error> {
            let mut residuals = room(times_s.len())?;
            residuals.extend(
                times_s.iter().zip(values).map(|(t, y)| distance(y, &curve.at(*t, 0)) / (N as f64).sqrt()),
            );
            Ok(residuals)
        };
        let fitted = |curve: &Self, weights: &[f64], cutoff_hz: f64, jerks: &[f64]| {
            let (knots, q) = (knots_of(cutoff_hz), density_of(cutoff_hz));
            let mut normal = Normal::new(knots)?;
            for ((time_s, value), weight) in times_s.iter().zip(values).zip(weights) {
                let trend = curve.trend(*time_s);
                let rest = core::array::from_fn(|k| value[k] - trend[k]);
                normal.add(*time_s, 0, &rest, weight / (sigma * sigma));
            }
            normal.add_penalty(|time_s| q * density(jerks, &knots, time_s));
            Ok::<_, Error>(normal.solve())
        };
        if is_stairs {
            // A staircase has the spectrum of motion. The stiffest curve counts whose residuals are those of rounding.
            let highest_hz = cutoff_hz;
            cutoff_hz = lowest_hz;
            while cutoff_hz < highest_hz {
                curve.spline = fitted(&curve, &weights, cutoff_hz, &[])?;
                let beyond = residuals_of(&curve)?.iter().filter(|rest| **rest > WITHIN_STEP * step).count();
                if beyond as f64 <= BEYOND_STEP * values.len() as f64 {
                    break;
                }
                cutoff_hz *= FINER;
            }
            cutoff_hz = cutoff_hz.min(highest_hz);
            curve.cutoff_hz = cutoff_hz;
        }
        let mut jerks: Vec<f64> = Vec::new();
        // Where stairs have an edge is no manoeuvre.
        let turns = if is_stairs { 1 } else { 2 };
        for turn in 0..turns {
            for round in 0..=ROUNDS {
                curve.spline = fitted(&curve, &weights, cutoff_hz, &jerks)?;
                if round == ROUNDS {
                    break;
                }
                let residuals = residuals_of(&curve)?;
                let scales = scales(&residuals, N)?;
                curve.noise = median(scales.iter().copied())?.max(sigma);
                for ((weight, residual), scale) in weights.iter_mut().zip(&residuals).zip(&scales) {
                    let u = (residual / (TUKEY * scale.max(curve.noise).max(least))).min(1.0);
                    *weight = (1.0 - u * u) * (1.0 - u * u);
                }
            }
            if turn + 1 < turns {
                jerks = jerks_of(&curve.spline, cutoff_hz)?;
            }
        }
        let residuals = residuals_of(&curve)?;
        for ((residual, weight), time_s) in residuals.iter().zip(&weights).zip(times_s) {
            curve.outliers += u64::from(*weight < OUTLIER);
            if *weight >= OUTLIER && *residual > curve.largest.0 {
                curve.largest = (*residual, *time_s);
            }
        }
        Ok(curve)
    }

    /// Noise of a component of the first derivative that white noise of the samples leaves: σ 2π f^1.5 √(π T/6).
    pub fn rate_noise(&self) -> f64 {
        let root = self.cutoff_hz.sqrt();
        self.noise * 2.0 * PI * root * root * root * (PI / 6.0 * self.period_s).sqrt()
    }

    fn trend(&self, time_s: f64) -> [f64; N] {
        let x = (time_s - self.start_s) / self.span_s;
        let [a, b, c] = &self.parabola;
        core::array::from_fn(|k| a[k] + x * (b[k] + x * c[k]))
    }
}

fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The median of values; 0 without values.
pub(super) fn median(values: impl Iterator<Item = f64>) -> Result<f64, Error> {
    let mut list = room(values.size_hint().0)?;
    list.extend(values);
    let middle = list.len() / 2;
    if list.is_empty() {
        return Ok(0.0);
    }
    Ok(*list.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// The samples a period apart, by the cubic through four samples where they are not: for the spectrum alone.
fn even<const N: usize>(times_s: &[f64], values: &[[f64; N]], period_s: f64) -> Result<Vec<[f64; N]>, Error> {
    let count = ((times_s[times_s.len() - 1] - times_s[0]) / period_s).round() as usize + 1;
    let mut list = room(count)?;
    if times_s.windows(2).all(|two| (two[1] - two[0] - period_s).abs() <= 0.2 * period_s) {
        list.extend_from_slice(values);
        return Ok(list);
    }
    let mut behind = 0;
    for k in 0..count {
        let time_s = times_s[0] + k as f64 * period_s;
        while behind + 1 < times_s.len() && times_s[behind + 1] <= time_s {
            behind += 1;
        }
        let first = behind.saturating_sub(1).min(times_s.len() - 4);
        let four: [usize; 4] = core::array::from_fn(|k| first + k);
        let value = cubic(times_s, values, &four, time_s);
        list.push(value);
    }
    Ok(list)
}

/// The cubic through the samples `four`, at a time.
fn cubic<const N: usize>(times_s: &[f64], values: &[[f64; N]], four: &[usize; 4], time_s: f64) -> [f64; N] {
    let mut value = [0.0; N];
    for &own in four {
        let others = four.iter().filter(|other| **other != own);
        let share: f64 =
            others.map(|&other| (time_s - times_s[other]) / (times_s[own] - times_s[other])).product();
        (0..N).for_each(|k| value[k] += share * values[own][k]);
    }
    value
}

/// The samples with each spike replaced by the cubic of its neighbours, and the weights of the spikes set to 0. A spike has a flat
/// spectrum, which hides the motion; and a curve that can follow it hides it from the residuals.
fn without_spikes<const N: usize>(
    times_s: &[f64],
    values: &[[f64; N]],
    weights: &mut [f64],
) -> Result<Vec<[f64; N]>, Error> {
    let mut list = room(values.len())?;
    list.extend_from_slice(values);
    for _ in 0..2 {
        let mut beside: Vec<f64> = room(values.len())?;
        let of =
            |list: &[[f64; N]], k: usize| cubic(times_s, list, &[k - 2, k - 1, k + 1, k + 2], times_s[k]);
        beside.extend((2..list.len() - 2).map(|k| distance(&list[k], &of(&list, k))));
        let limit = SPIKE * median(beside.iter().copied())?;
        for (first, far) in beside.iter().enumerate() {
            let around = &beside[first.saturating_sub(2)..(first + 3).min(beside.len())];
            if *far > limit && limit > 0.0 && around.iter().all(|other| other <= far) {
                list[first + 2] = of(&list, first + 2);
                weights[first + 2] = 0.0;
            }
        }
    }
    Ok(list)
}

/// Coefficients of the parabola of least squares in x from 0 to 1.
fn parabola<const N: usize>(times_s: &[f64], values: &[[f64; N]]) -> [[f64; N]; 3] {
    let (start_s, span_s) = (times_s[0], times_s[times_s.len() - 1] - times_s[0]);
    let (mut matrix, mut right) = (Matrix3::zeros(), [Vector3::zeros(); N]);
    let base = values[0];
    for (time_s, value) in times_s.iter().zip(values) {
        let x = (time_s - start_s) / span_s;
        let basis = Vector3::new(1.0, x, x * x);
        matrix += basis * basis.transpose();
        (0..N).for_each(|k| right[k] += basis * (value[k] - base[k]));
    }
    let inverse = matrix.try_inverse().unwrap_or_else(Matrix3::zeros);
    let solved = right.map(|right| inverse * right);
    core::array::from_fn(|power| {
        core::array::from_fn(|k| solved[k][power] + if power == 0 { base[k] } else { 0.0 })
    })
}

/// The scale of residuals at each row: the median of the five rows around, as a deviation. Where the curve is too stiff all rows miss, and
/// none is an outlier.
fn scales(residuals: &[f64], components: usize) -> Result<Vec<f64>, Error> {
    // Median of |x| of a normal number, and of the root mean square of several.
    let per_deviation = if components == 1 { 0.6745 } else { 0.86 };
    let last = residuals.len() - 1;
    let mut scales = room(residuals.len())?;
    for k in 0..residuals.len() {
        let around = [k.saturating_sub(2), k.saturating_sub(1), k, (k + 1).min(last), (k + 2).min(last)];
        let mut five = around.map(|at| residuals[at]);
        five.sort_by(f64::total_cmp);
        scales.push(five[2] / per_deviation);
    }
    Ok(scales)
}

/// Squared jerk of each interval over its geometric mean, averaged over time: manoeuvres keep their jerk, and cruise is calm.
fn jerks_of<const N: usize>(spline: &Spline<N>, cutoff_hz: f64) -> Result<Vec<f64>, Error> {
    let knots = spline.knots;
    let squares =
        (0..knots.count).map(|k| spline.at(knots.middle_s(k), 3).iter().map(|x| x * x).sum::<f64>());
    let mut list: Vec<f64> = room(knots.count)?;
    list.extend(squares);
    let half = ((SPAN / (2.0 * PI * cutoff_hz) / knots.step_s) as usize | 1).max(3) / 2;
    let window = |offset: usize| 1.0 + sin_cos(PI * offset as f64 / (half + 1) as f64).1;
    let mut averaged: Vec<f64> = room(list.len())?;
    for k in 0..list.len() {
        let (mut sum, mut weights) = (0.0, 0.0);
        for offset in 0..=half {
            for at in [k.saturating_sub(offset), (k + offset).min(list.len() - 1)] {
                sum += window(offset) * list[at];
                weights += window(offset);
            }
        }
        averaged.push(sum / weights);
    }
    let mean = averaged.iter().sum::<f64>() / averaged.len() as f64;
    averaged.iter_mut().for_each(|jerk| *jerk = jerk.max(JERKS.0 * mean + 1e-300));
    let middle = exp(averaged.iter().map(|jerk| ln(*jerk)).sum::<f64>() / averaged.len() as f64);
    averaged.iter_mut().for_each(|jerk| *jerk = (*jerk / middle).min(JERKS.1));
    Ok(averaged)
}

/// The ratio of the density of jerk at a time, linear between the middles of intervals; 1 before any is known.
fn density(jerks: &[f64], knots: &Knots, time_s: f64) -> f64 {
    let Some(last) = jerks.len().checked_sub(1) else { return 1.0 };
    let x = ((time_s - knots.middle_s(0)) / knots.step_s).clamp(0.0, last as f64);
    let at = (x as usize).min(last.saturating_sub(1));
    let next = (at + 1).min(last);
    jerks[at] + (jerks[next] - jerks[at]) * (x - at as f64)
}
