//! The real record among its twins.

use super::Check;
use super::drift::Drifts;
use super::starts::Starts;
use crate::base::error::Error;
use crate::base::math::{exp, ln};
use crate::base::memory::room;
use crate::ensemble::statistics::Verdict;

/// Part of the twins that keep the limit.
const KEPT: f64 = 0.95;
/// Least drift that a logarithm is taken of [m]: the rounding of a position.
const LEAST_M: f64 = 1e-6;

/// Verdict on the model of a sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Agreement {
    /// The real drift is as that of the twins.
    Agrees,
    /// The real sensors drift this many times as far as the model.
    TooGood(f64),
    /// The model drifts this many times as far as the real sensors.
    TooBad(f64),
}

/// Flights of one duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// The duration \[s\].
    pub duration_s: f64,
    /// Number of flights.
    pub flights: usize,
    /// Number of flights that do not overlap.
    pub apart: usize,
    /// Distance from the truth that half of the flights on the record as it is keep \[m\]; infinite: more than half diverged.
    pub free_m: f64,
    /// Distance that half of the flights keep \[m\], with the errors removed that were found.
    pub real_m: f64,
    /// 95 % interval of this distance \[m\]: order statistics of the flights, for the number of flights that do not overlap. With
    /// fewer than six of them, all flights are within it and its confidence is smaller.
    pub real_interval_m: (f64, f64),
    /// Root mean square of the distances \[m\].
    pub real_rms_m: f64,
    /// Distance that half of the flights of a twin keep \[m\]: geometric mean of the twins.
    pub predicted_m: f64,
    /// Interval that 95 % of the twins keep at all durations together \[m\].
    pub predicted_interval_m: (f64, f64),
    /// Root mean square of the distances of all flights of all twins \[m\].
    pub predicted_rms_m: f64,
    /// Verdict on this duration.
    pub agreement: Agreement,
}

/// Mean and standard deviation of logarithms.
#[derive(Clone, Copy)]
struct Spread {
    mean: f64,
    sigma: f64,
}

impl Spread {
    fn new(logarithms: impl Iterator<Item = f64> + Clone) -> Self {
        let count = logarithms.clone().count() as f64;
        let mean = logarithms.clone().sum::<f64>() / count;
        let squares: f64 = logarithms.map(|value| (value - mean) * (value - mean)).sum();
        Self { mean, sigma: (squares / (count - 1.0)).sqrt().max(f64::MIN_POSITIVE) }
    }

    fn z(&self, logarithm: f64) -> f64 {
        (logarithm - self.mean) / self.sigma
    }
}

fn logarithm(drifts: &Drifts) -> f64 {
    ln(drifts.quantile_m(0.5).max(LEAST_M))
}

/// The verdict. Each of `free`, `real` and `twins` has the drifts of all durations.
pub(super) fn check(
    length_s: f64,
    starts: &Starts,
    (free, real): (&[Drifts], &[Drifts]),
    twins: &[Vec<Drifts>],
) -> Result<Check, Error> {
    let mut spreads = room(starts.spans.len())?;
    spreads.extend(
        (0..starts.spans.len()).map(|span| Spread::new(twins.iter().map(move |twin| logarithm(&twin[span])))),
    );
    let largest = |drifts: &[Drifts]| {
        drifts.iter().zip(&spreads).map(|(one, spread)| spread.z(logarithm(one)).abs()).fold(0.0, f64::max)
    };
    let mut largest_of_twins: Vec<f64> = room(twins.len())?;
    largest_of_twins.extend(twins.iter().map(|twin| largest(twin)));
    largest_of_twins.sort_unstable_by(f64::total_cmp);
    let place = (KEPT * (twins.len() + 1) as f64).ceil() as usize;
    let limit = largest_of_twins[place.clamp(1, twins.len()) - 1];

    let mut spans = room(starts.spans.len())?;
    let mut worst = (0.0, Agreement::Agrees);
    for (place, (flights, spread)) in starts.spans.iter().zip(&spreads).enumerate() {
        let z = spread.z(logarithm(&real[place]));
        let factor = exp(logarithm(&real[place]) - spread.mean);
        let agreement = match (z.abs() <= limit, z > 0.0) {
            (true, _) => Agreement::Agrees,
            (false, true) => Agreement::TooGood(factor),
            (false, false) => Agreement::TooBad(1.0 / factor),
        };
        if z.abs() > worst.0 {
            worst = (z.abs(), agreement);
        }
        let even = flights.apart as u64 & !1;
        let fraction = Verdict::new(even, even / 2, 0, 50.0)?;
        let mean_square = |twin: &Vec<Drifts>| twin[place].rms_m() * twin[place].rms_m();
        spans.push(Span {
            duration_s: flights.duration_s,
            flights: flights.starts_s.len(),
            apart: flights.apart,
            free_m: free[place].quantile_m(0.5),
            real_m: real[place].quantile_m(0.5),
            real_interval_m: (real[place].quantile_m(fraction.low), real[place].quantile_m(fraction.high)),
            real_rms_m: real[place].rms_m(),
            predicted_m: exp(spread.mean),
            predicted_interval_m: (
                exp(spread.mean - limit * spread.sigma),
                exp(spread.mean + limit * spread.sigma),
            ),
            predicted_rms_m: (twins.iter().map(mean_square).sum::<f64>() / twins.len() as f64).sqrt(),
            agreement,
        });
    }
    Ok(Check { length_s, twins: twins.len(), spans, diverged_s: None, agreement: worst.1 })
}
