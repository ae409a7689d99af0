//! Covariances of the Allan variances of one record: neighbouring averaging times share the same samples.

use nalgebra::{SMatrix, SVector};

use super::lags::Pair;
use super::pieces::Pieces;
use super::terms::{Band, NOISES, TERMS, Term};

/// Quadratic form in the squares of the coefficients.
pub type Form = SMatrix<f64, TERMS, TERMS>;

/// Let second differences of Gaussian noise have the covariance c, and with a ramp the means µ and µ'. Then their squares have the
/// covariance 2 c² + 4 µ µ' c. An Allan variance is the mean of M of these squares, halved:
/// ```text
/// cov(σ²(τ), σ²(τ')) = Σ times(l) (2 c(l)² + 4 µ µ' c(l)) / (4 M M')
/// ```
/// where the sum is over the distances l of two differences, times(l) is how often the record has the distance, and M is the number
/// of differences. c is linear in the squares of the coefficients, as is µ µ' = R² τ τ'. The covariance is exact for Gaussian
/// noises (Greenhall and Riley, PTTI 2003, for τ = τ'). It depends on the lengths of the record's pieces only.
#[derive(Debug, Clone)]
pub struct Covariance {
    size: usize,
    forms: Vec<Form>,
}

impl Covariance {
    /// For records in these pieces with the averaging times `factors`.
    pub fn new(pieces: &Pieces, interval_s: f64, factors: &[usize], band: Band) -> Self {
        let size = factors.len();
        let mut forms = vec![Form::zeros(); size * size];
        for (i, &a) in factors.iter().enumerate() {
            for (j, &b) in factors.iter().enumerate().skip(i) {
                let of_piece = |count| form(Pair { count, a, b }, interval_s, band);
                let form = pieces.joined(a, b).map(|(count, weight)| of_piece(count) * weight).sum();
                forms[i * size + j] = form;
                forms[j * size + i] = form;
            }
        }
        Self { size, forms }
    }

    /// Covariance of the variances at averaging times `i` and `j`, as a form in the squares of the coefficients.
    pub fn form(&self, i: usize, j: usize) -> &Form {
        &self.forms[i * self.size + j]
    }

    /// Variance of σ² at an averaging time.
    pub fn variance(&self, i: usize, squares: &[f64; TERMS]) -> f64 {
        let x = SVector::from(*squares);
        x.dot(&(self.form(i, i) * x))
    }
}

/// Variance of the Allan variance at `factor` intervals, for Gaussian noise whose integral has the generalised covariance
/// `covariance(t_s)`.
pub fn variance_of_noise(
    pieces: &Pieces,
    factor: usize,
    interval_s: f64,
    covariance: impl Fn(f64) -> f64,
) -> f64 {
    let of_piece = |count| {
        let pair = Pair { count, a: factor, b: factor };
        let squared = |samples: f64| {
            let c = of_differences(&pair, interval_s, samples, &covariance);
            c * c
        };
        let sum: f64 = pair.lags().iter().map(|lag| lag.weight * squared(lag.samples)).sum();
        let starts = pair.starts().0 as f64;
        sum / (2.0 * starts * starts)
    };
    pieces.joined(factor, factor).map(|(count, weight)| of_piece(count) * weight).sum()
}

/// Covariance of two second differences over their averaging times, `samples` apart.
fn of_differences(pair: &Pair, interval_s: f64, samples: f64, covariance: impl Fn(f64) -> f64) -> f64 {
    let sum: f64 = pair
        .meetings()
        .map(|(meeting, factor)| factor * covariance((samples - meeting as f64) * interval_s))
        .sum();
    sum / (pair.a as f64 * pair.b as f64 * interval_s * interval_s)
}

/// Covariance of two Allan variances as a quadratic form. The smooth noises enter by their integrals over the lags, the white error
/// of quantization only at the distances at which its points meet.
fn form(pair: Pair, interval_s: f64, band: Band) -> Form {
    const RAMP: usize = NOISES;
    const QUANTIZATION: usize = 0;
    let taus = pair.a as f64 * pair.b as f64 * interval_s * interval_s;
    let noises = |samples: f64| -> [f64; NOISES] {
        core::array::from_fn(|p| match Term::ALL[p] {
            Term::Quantization => 0.0,
            term => of_differences(&pair, interval_s, samples, |t| band.covariance(term, t)),
        })
    };
    let mut form = Form::zeros();
    for lag in pair.lags() {
        let c = noises(lag.samples);
        for p in 1..NOISES {
            for q in 1..NOISES {
                form[(p, q)] += lag.weight * c[p] * c[q];
            }
            form[(p, RAMP)] += lag.weight * taus * c[p];
        }
    }
    let mut meetings: Vec<(i64, f64)> = pair.meetings().collect();
    meetings.sort_unstable_by_key(|meeting| meeting.0);
    for group in meetings.chunk_by(|a, b| a.0 == b.0) {
        let samples = group[0].0 as f64;
        let (times, mut c) = (pair.times(samples), noises(samples));
        c[QUANTIZATION] = group.iter().map(|meeting| meeting.1).sum::<f64>() / taus;
        for p in 0..NOISES {
            form[(QUANTIZATION, p)] += times * c[QUANTIZATION] * c[p];
        }
        form[(QUANTIZATION, RAMP)] += times * taus * c[QUANTIZATION];
    }
    for p in 0..NOISES {
        form[(p, QUANTIZATION)] = form[(QUANTIZATION, p)];
        form[(RAMP, p)] = form[(p, RAMP)];
    }
    let (first, second) = pair.starts();
    form / (2.0 * first as f64 * second as f64)
}

#[cfg(test)]
mod tests {
    use super::super::deviation::factors;
    use super::*;

    /// Degrees of freedom 2 σ⁴ / var of pure noise, compared with the approximations of NIST SP 1065, table 5 (Howe, Allan and
    /// Barnes 1981), for n points of the integral. The approximations are good to a few per cent.
    #[test]
    fn degrees_of_freedom_are_those_of_sp_1065() {
        let count = 1000;
        let factors = factors(count);
        let covariance = Covariance::new(&Pieces::new(&[count]), 1.0, &factors, Band::Unlimited);
        let n = count as f64 + 1.0;
        for (i, &factor) in factors.iter().enumerate() {
            let m = factor as f64;
            let quantization = (n + 1.0) * (n - 2.0 * m) / (2.0 * (n - m));
            let white =
                (3.0 * (n - 1.0) / (2.0 * m) - 2.0 * (n - 2.0) / n) * 4.0 * m * m / (4.0 * m * m + 5.0);
            let flicker = if factor == 1 {
                2.0 * (n - 2.0).powi(2) / (2.3 * n - 4.9)
            } else {
                5.0 * n * n / (4.0 * m * (n + 3.0 * m))
            };
            let walk =
                (n - 2.0) / m * ((n - 1.0).powi(2) - 3.0 * m * (n - 1.0) + 4.0 * m * m) / (n - 3.0).powi(2);
            for (p, expected) in [quantization, white, flicker, walk].into_iter().enumerate() {
                let mut squares = [0.0; TERMS];
                squares[p] = 1.0;
                let variance = Term::ALL[p].shape(m).powi(2);
                let degrees = 2.0 * variance / covariance.variance(i, &squares);
                println!("{:?} m = {m}: {degrees:.1} SP 1065 {expected:.1}", Term::ALL[p]);
                assert!(
                    (degrees / expected - 1.0).abs() < 0.15,
                    "{:?} {m}: {degrees} {expected}",
                    Term::ALL[p]
                );
            }
        }
    }

    /// Compared with the definition, a sum over all pairs of differences, for all noises and the ramp, at equal and unequal times.
    #[test]
    fn sums_over_lags_are_those_over_all_pairs() {
        let (count, interval_s) = (120, 0.5);
        let squares = [0.3, 1.0, 0.7, 0.05, 1e-3];
        for (a, b) in [(1, 1), (1, 2), (2, 7), (13, 13), (3, 13)] {
            let pair = Pair { count, a, b };
            let (first, second) = pair.starts();
            let mean = squares[4] * (a * b) as f64 * interval_s * interval_s;
            let mut exact = 0.0;
            for k in 0..first {
                for l in 0..second {
                    let samples = l as f64 - k as f64;
                    let total = |t: f64| -> f64 {
                        Term::ALL.iter().zip(squares).map(|(term, square)| square * term.covariance(t)).sum()
                    };
                    let c = of_differences(&pair, interval_s, samples, total);
                    exact += (2.0 * c * c + 4.0 * mean * c) / (4 * first * second) as f64;
                }
            }
            let x = SVector::from(squares);
            let found = x.dot(&(form(pair, interval_s, Band::Unlimited) * x));
            assert!((found / exact - 1.0).abs() < 2e-3, "{a} {b}: {found} {exact}");
        }
    }
}
