//! What is put into a sensor comes out of its Allan deviation, by the estimator of the report program.

#[allow(dead_code)] // the report program uses the rest
#[path = "../src/bin/sins_report/allan/estimate/mod.rs"]
mod estimate;
#[path = "support/noises.rs"]
mod noises;

use estimate::covariance::Covariance;
use estimate::deviation::{allan_variance, factors, integral};
use estimate::fit::Fit;
use estimate::interval::{self, Interval};
use estimate::terms::{TERMS, Term, total};
use noises::{Coefficients, Normal, increments};

/// Averaging times of records of one length, and what is known of them before a record is seen.
struct Records {
    count: usize,
    dt: f64,
    factors: Vec<usize>,
    taus_s: Vec<f64>,
    covariance: Covariance,
}

impl Records {
    fn new(count: usize, dt: f64) -> Self {
        let factors = factors(count);
        let taus_s = factors.iter().map(|factor| *factor as f64 * dt).collect();
        let covariance = Covariance::new(count, dt, &factors);
        Self { count, dt, factors, taus_s, covariance }
    }

    fn variances(&self, increments: &[f64]) -> Vec<f64> {
        let theta = integral(increments);
        self.factors.iter().map(|factor| allan_variance(&theta, self.dt, *factor)).collect()
    }

    fn fit(&self, variances: &[f64]) -> Fit {
        Fit::new(&self.taus_s, variances, &self.covariance)
    }
}

#[test]
fn explore() {
    let runs = 2000;
    let cases = [
        ("Q", Coefficients { q: 1.0, ..Default::default() }),
        ("N", Coefficients { n: 1.0, ..Default::default() }),
        ("B", Coefficients { b: 1.0, ..Default::default() }),
        ("K", Coefficients { k: 1.0, ..Default::default() }),
        ("NR", Coefficients { n: 1.0, r: 3e-5, ..Default::default() }),
        ("NK", Coefficients { n: 1.0, k: 3e-3, ..Default::default() }),
        ("QNBKR", Coefficients { q: 10.0, n: 1.0, b: 0.05, k: 3e-4, r: 1e-5 }),
        ("QNBKR+", Coefficients { q: 10.0, n: 1.0, b: 0.1, k: 3e-3, r: 1e-4 }),
    ];
    for count in [4096] {
        let records = Records::new(count, 1.0);
        for (name, c) in cases {
            let mut inside = vec![0; records.taus_s.len()];
            let mut covered = [0; TERMS];
            let mut resolved = [0; TERMS];
            let mut moved = [0; TERMS];
            let mut upper = [0.0; TERMS];
            let mut means = [0.0; TERMS];
            for run in 0..runs {
                let series = increments(&c, count, 1.0, &mut Normal::new(run));
                let variances = records.variances(&series);
                let fit = records.fit(&variances);
                let mut points = vec![];
                for (i, tau) in records.taus_s.iter().enumerate() {
                    let edf = interval::degrees_of_freedom(&fit, &records.covariance, i, *tau);
                    points.push(interval::Point { tau_s: *tau, variance: variances[i], degrees: edf });
                    let int = interval::of_variance(variances[i], edf, 0.95);
                    inside[i] += usize::from(int.contains(total(&c.squares(), *tau)));
                }
                for p in 0..TERMS {
                    let int = interval::of_square(&fit, p, &points, 0.95);
                    covered[p] += usize::from(int.contains(c.squares()[p]));
                    resolved[p] += usize::from(int.low > 0.0);
                    moved[p] += usize::from(int.low == fit.squares[p] || int.high == fit.squares[p]);
                    upper[p] += int.high.sqrt() / runs as f64;
                    means[p] += fit.free[p] / runs as f64;
                }
            }
            println!(
                "{name} {count}: taus {:?}",
                inside.iter().map(|x| *x as f64 * 100.0 / runs as f64).collect::<Vec<_>>()
            );
            println!(
                "   covered {covered:?} resolved {resolved:?} at end {moved:?} upper {} means {}",
                upper.map(|x| format!("{x:.2e}")).join(" "),
                means.map(|x| format!("{x:.2e}")).join(" ")
            );
        }
    }
    let _ = (Term::ALL, Interval { low: 0.0, high: 0.0 });
}
