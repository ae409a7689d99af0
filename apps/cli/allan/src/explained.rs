//! Whether the five noises explain the variances of a record, and from which averaging time on.
//!
//! Neighbouring values of many records depend on each other: a sensor has a low-pass, its output is averaged or repeated, or its flicker
//! has an upper end. At short times such a record has no sum of the five noises. Beyond the memory of a filter, white noise behind it has
//! σ² = N² / τ - c / τ², so the coefficients are found from longer times.

use super::fit::Fit;
use super::interval::Point;
use super::quantile::chi_square_quantile;
use super::terms::{Band, TERMS, Term};
use super::{Estimate, Estimator};
use sins::math::ln;

/// A fit does not explain a variance if both conditions hold: chance alone makes such a difference once in ten thousand cases, and the
/// ratio of the deviations is large enough to be seen in the curve.
const CERTAIN: f64 = 0.9999;
const VISIBLE: f64 = 1.05;

/// Two fits disagree if both conditions hold: the difference of a square is so many standard deviations of that with fewer times, and it is
/// this part of it. A wrong term at short times is taken for others, which explain them; longer times then have other coefficients.
const DEVIATIONS: f64 = 4.0;
const PART: f64 = 0.1;

/// How many more times are left out of the fits that must agree: one to five octaves.
const FEWER: [usize; 5] = [3, 6, 9, 12, 15];

/// How many times are left out beyond the first that is explained, if that is not the first of all: an octave. A dependence ends with a
/// tail that no single time shows, and that all of them together have in the coefficients.
const TAIL: usize = 3;

/// Fewest times of a fit: four octaves.
const LEAST: usize = 12;

impl Estimator {
    /// The fit with the most times that explains its variances, and agrees with fits to longer times; if there is none, that to all.
    /// Flicker noise may be that of real sensors or that of this library: if it is seen, or if nothing explains all times, both are tried.
    pub(super) fn explained(&self, variances: &[f64]) -> Estimate {
        let unlimited = self.explained_in(variances, Band::Unlimited);
        let is_seen = unlimited.interval(Term::Flicker, 0.95).low > 0.0;
        if unlimited.is_explained && unlimited.fit.first == 0 && !is_seen {
            return unlimited;
        }
        let limited = self.explained_in(variances, Band::Limited);
        let rank = |one: &Estimate| (!one.is_explained, one.fit.first);
        let is_worse = |one: &Estimate, other: &Estimate| {
            misfit(&one.points, &one.fit) > misfit(&other.points, &other.fit)
        };
        if rank(&limited) == rank(&unlimited) {
            let (best, other) =
                if is_worse(&unlimited, &limited) { (limited, unlimited) } else { (unlimited, limited) };
            let other = best.is_explained.then_some(other.fit);
            return Estimate { other, ..best };
        }
        if rank(&limited) < rank(&unlimited) { limited } else { unlimited }
    }

    fn explained_in(&self, variances: &[f64], band: Band) -> Estimate {
        let last = self.taus_s.len().saturating_sub(LEAST);
        let mut fits: Vec<Option<Fit>> = vec![None; last + 1];
        let mut fit = |first: usize| {
            let new = || Fit::new(&self.taus_s, variances, self.covariance(band), band, first);
            fits[first].get_or_insert_with(new).clone()
        };
        let estimate = |fit: Fit, is_explained| Estimate {
            points: self.points(variances, &fit),
            fit,
            is_explained,
            other: None,
        };
        for first in 0..=last {
            let found = estimate(fit(first), true);
            let mut fewer = FEWER.into_iter().map(|fewer| first + fewer).take_while(|first| *first <= last);
            if worst(&found.points, &found.fit).is_none() && fewer.all(|first| agree(&found.fit, &fit(first)))
            {
                return if first == 0 { found } else { estimate(fit((first + TAIL).min(last)), true) };
            }
        }
        estimate(fit(0), false)
    }
}

/// Sum of squares of the logarithms of variance over fit, by their degrees of freedom.
fn misfit(points: &[Point], fit: &Fit) -> f64 {
    let square = |point: &Point| {
        let ratio = ln(point.variance / fit.variance(point.tau_s));
        point.degrees * (ratio * ratio)
    };
    points.iter().skip(fit.first).map(square).sum()
}

impl Estimate {
    /// Among the variances that the fit does not explain, the place of the one with the largest ratio to it.
    pub fn unexplained(&self) -> Option<usize> {
        worst(&self.points, &self.fit)
    }

    /// Whether coefficients with these squares explain the variances that the fit explains: a part of its terms, for example.
    pub fn is_explained_by(&self, squares: &[f64; TERMS]) -> bool {
        worst(&self.points, &Fit { squares: *squares, ..self.fit.clone() }).is_none()
    }
}

fn worst(points: &[Point], fit: &Fit) -> Option<usize> {
    let ratio = |point: &Point| point.variance / fit.variance(point.tau_s);
    let size = |point: &Point| ln(ratio(point)).abs();
    let is_missed = |point: &Point| {
        let end = |probability: f64| chi_square_quantile(probability, point.degrees);
        let sum = point.degrees * ratio(point);
        let is_usual = (end(0.5 - 0.5 * CERTAIN)..=end(0.5 + 0.5 * CERTAIN)).contains(&sum);
        !is_usual && size(point) > 2.0 * ln(VISIBLE)
    };
    let used = points.iter().enumerate().skip(fit.first).filter(|(_, point)| is_missed(point));
    used.max_by(|a, b| size(a.1).total_cmp(&size(b.1))).map(|(place, _)| place)
}

fn agree(all: &Fit, fewer: &Fit) -> bool {
    let spread = fewer.variances_of_free();
    (0..TERMS).all(|term| {
        let difference = (all.free[term] - fewer.free[term]).abs();
        difference <= DEVIATIONS * spread[term].max(0.0).sqrt() || difference <= PART * all.free[term].abs()
    })
}
