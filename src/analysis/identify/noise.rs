//! The noise of one sensor from its residual, and what the record says of the coefficients of that sensor with it.

use nalgebra::{SMatrix, SVector};

use super::whiten::{COLUMNS, Columns, Filter, Shape, Steps};
use crate::base::error::Error;
use crate::base::math::{exp, ln};
use crate::base::memory::room;

/// Coefficients of a sensor: bias, the three signals, the change by a shift of the clock, and by a drift of the clock; then those of a fit
/// that is asked for more: three by forces (gyros) or by the lever arm (accelerometers), the asymmetry, and the temperature.
pub(super) const COEFFICIENTS: usize = COLUMNS - 1;
/// Number of those that each fit has.
const ALWAYS: usize = 6;
pub(super) type Information = SMatrix<f64, COEFFICIENTS, COEFFICIENTS>;
pub(super) type Coefficients = SVector<f64, COEFFICIENTS>;

/// A coefficient of noise with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NoiseEstimate {
    /// Mean of the posterior distribution.
    pub value: f64,
    /// Ends of the 95 % interval; the low end 0: the record does not show the noise.
    pub low: f64,
    /// High end.
    pub high: f64,
}

impl NoiseEstimate {
    /// Whether the record shows the noise.
    pub fn is_seen(&self) -> bool {
        self.low > 0.0
    }
}

/// Noise of the residual of a sensor, that of the truth included. The unit u is rad/s or m/s².
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SensorNoise {
    /// White noise N \[u √s\].
    pub random_walk: NoiseEstimate,
    /// Flicker noise B \[u\].
    pub flicker: NoiseEstimate,
    /// Random walk K \[u/√s\].
    pub rate_random_walk: NoiseEstimate,
}

/// What the rows of a sensor say of its coefficients: a normal distribution in the form of information.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Evidence {
    pub information: Information,
    /// Information times mean.
    pub vector: Coefficients,
    pub noise: SensorNoise,
    /// The most probable shape, and N².
    pub shape: Shape,
    pub square: f64,
}

/// What a fit is that cannot be solved.
pub(super) const TOO_EXACT: &str = "the fit cannot be solved: the noise of a sensor is too small beside the priors for the digits of its numbers, as that of a sensor without noise";

/// Neighbours of the grid of shapes: a factor of 4 in the time at which flicker noise equals white noise, and of 3 for the walk.
const FLICKER_STEP: f64 = 4.0;
const WALK_STEP: f64 = 3.0;
/// The first time of the grid [blocks]. The last is two records.
const FIRST: f64 = 1.0;
const MOST_SHAPES: usize = 12;

/// The shapes of the noise that a fit mixes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shapes {
    /// One of each sensor.
    Of([Shape; 6]),
    All,
}

/// σ² = N²/τ of white noise is that of flicker noise, 2 ln 2/π B² (IEEE Std 952-1997), and that of the walk, K² τ/3, at the time τ.
fn grid(block_s: f64, span_s: f64) -> impl Iterator<Item = Shape> {
    let times = move |step: f64| {
        let next = move |time: &f64| Some(time * step).filter(|time| *time <= 2.0 * span_s);
        core::iter::successors(Some(FIRST * block_s), next).take(MOST_SHAPES)
    };
    let flicker = move || core::iter::once(0.0).chain(times(FLICKER_STEP).map(|t| 1.0 / (0.4413 * t)));
    let walk = move || core::iter::once(0.0).chain(times(WALK_STEP).map(|t| 3.0 / (t * t)));
    flicker().flat_map(move |flicker| walk().map(move |walk| Shape { flicker, walk }))
}

/// One shape: its logarithm of the likelihood, and the distribution of the coefficients.
struct Fit {
    shape: Shape,
    likelihood: f64,
    square: f64,
    mean: Coefficients,
    covariance: Information,
}

/// The fit of one shape. With whitened data y, columns X and the diagonal S of the wide prior deviations `scale`, the coefficients are
/// normal with A = I + S XᵀX S/N², mean S A⁻¹ S Xᵀy/N² and covariance S A⁻¹ S. N² is RSS over n less the coefficients that are found, and
/// the likelihood that of the data, with the coefficients integrated out (restricted likelihood, Patterson and Thompson 1971).
fn fit(filter: &Filter<'_>, rows: &[Columns], shape: Shape, scale: &Coefficients) -> Option<Fit> {
    let (mut yy, mut xy, mut xx) = (0.0, Coefficients::zeros(), Information::zeros());
    filter.whiten(rows, |_, white| {
        yy += white[0] * white[0];
        for i in 0..COEFFICIENTS {
            xy[i] += white[1 + i] * white[0];
            for j in 0..=i {
                xx[(i, j)] += white[1 + i] * white[1 + j];
            }
        }
    });
    xx.fill_upper_triangle_with_lower_triangle();
    let scaled = Information::from_fn(|i, j| scale[i] * xx[(i, j)] * scale[j]);
    let side = xy.component_mul(scale);
    let n = rows.len() as f64;
    // A residual of nothing, as of perfect sensors, has the noise of rounding.
    let floor = f64::MIN_POSITIVE + 1e-28 * xx.diagonal().rows(0, ALWAYS).max();
    let mut square = yy / n + floor;
    for _ in 0..4 {
        let inverse = (Information::identity() + scaled / square).cholesky()?.inverse();
        let mean = inverse * side / square;
        let rss = yy - 2.0 * mean.dot(&side) + mean.dot(&(scaled * mean));
        let found = COEFFICIENTS as f64 - inverse.trace();
        square = rss.max(0.0) / (n - found) + floor;
    }
    let factor = (Information::identity() + scaled / square).cholesky()?;
    let inverse = factor.inverse();
    let mean = inverse * side / square;
    let rss = yy - 2.0 * mean.dot(&side) + mean.dot(&(scaled * mean)) + square * mean.norm_squared();
    let determinant: f64 = factor.l_dirty().diagonal().iter().map(|value| 2.0 * ln(*value)).sum();
    let likelihood = -0.5 * (filter.logarithms + n * ln(square) + rss / square + determinant);
    let covariance = Information::from_fn(|i, j| scale[i] * inverse[(i, j)] * scale[j]);
    Some(Fit { shape, likelihood, square, mean: mean.component_mul(scale), covariance })
}

/// The evidence of the rows of each sensor under the shapes.
pub(super) fn evidences(
    steps: &Steps,
    rows: &[Vec<Columns>; 6],
    (block_s, span_s): (f64, f64),
    scales: &[Coefficients; 6],
    shapes: Shapes,
) -> Result<[Evidence; 6], Error> {
    let mut fits: [Vec<Fit>; 6] = Default::default();
    for of_sensor in &mut fits {
        *of_sensor = room((MOST_SHAPES + 1) * (MOST_SHAPES + 1))?;
    }
    let mut add = |filter: &Filter<'_>, shape: Shape, sensor: usize| {
        fits[sensor].extend(fit(filter, &rows[sensor], shape, &scales[sensor]));
    };
    match shapes {
        Shapes::Of(shapes) => {
            for (sensor, shape) in shapes.into_iter().enumerate() {
                add(&steps.filter(shape)?, shape, sensor);
            }
        }
        Shapes::All => {
            for shape in grid(block_s, span_s) {
                let filter = steps.filter(shape)?;
                (0..6).for_each(|sensor| add(&filter, shape, sensor));
            }
        }
    }
    let mut evidences = [Evidence::default(); 6];
    for (sensor, evidence) in evidences.iter_mut().enumerate() {
        *evidence = mixture(&fits[sensor], rows[sensor].len(), &scales[sensor])?;
    }
    Ok(evidences)
}

/// The mixture of the normal distributions of the shapes by their likelihoods, as one normal distribution of the same mean and covariance.
/// So the intervals contain that the noise is itself uncertain.
fn mixture(fits: &[Fit], count: usize, scale: &Coefficients) -> Result<Evidence, Error> {
    let best = fits.iter().max_by(|a, b| a.likelihood.total_cmp(&b.likelihood));
    let unsolved = || Error::bad_state(TOO_EXACT);
    let (shape, square, top) =
        best.map(|fit| (fit.shape, fit.square, fit.likelihood)).ok_or_else(unsolved)?;
    let mut weights: Vec<f64> = room(fits.len())?;
    weights.extend(fits.iter().map(|fit| exp(fit.likelihood - top)));
    let total: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|weight| *weight /= total);
    let mut mean = Coefficients::zeros();
    for (fit, weight) in fits.iter().zip(&weights) {
        mean += fit.mean * *weight;
    }
    let mut covariance = Information::zeros();
    for (fit, weight) in fits.iter().zip(&weights) {
        let off = fit.mean - mean;
        covariance += (fit.covariance + off * off.transpose()) * *weight;
    }
    let scaled = Information::from_fn(|i, j| covariance[(i, j)] / (scale[i] * scale[j]));
    let inverse = scaled.cholesky().ok_or_else(unsolved)?.inverse();
    let information = Information::from_fn(|i, j| inverse[(i, j)] / (scale[i] * scale[j]));
    let mut values = room(fits.len())?;
    let mut quantity = |of: &dyn Fn(&Fit) -> f64| {
        values.clear();
        values.extend(fits.iter().zip(&weights).map(|(fit, weight)| (of(fit), *weight)));
        estimate(&mut values, count)
    };
    let noise = SensorNoise {
        random_walk: quantity(&|fit| fit.square.sqrt()),
        flicker: quantity(&|fit| (fit.square * fit.shape.flicker).sqrt()),
        rate_random_walk: quantity(&|fit| (fit.square * fit.shape.walk).sqrt()),
    };
    Ok(Evidence { information, vector: information * mean, noise, shape, square })
}

/// Mean and 95 % interval of weighted values. The interval is widened by that of a deviation of `count` values.
fn estimate(values: &mut [(f64, f64)], count: usize) -> NoiseEstimate {
    values.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let value = values.iter().map(|(value, weight)| value * weight).sum();
    let quantile = |p: f64| {
        let mut sum = 0.0;
        let found = values.iter().find(|(_, weight)| {
            sum += weight;
            sum >= p
        });
        found.or(values.last()).map_or(0.0, |found| found.0)
    };
    let part = 1.96 / (2.0 * count as f64).sqrt();
    NoiseEstimate { value, low: quantile(0.025) * (1.0 - part), high: quantile(0.975) * (1.0 + part) }
}
