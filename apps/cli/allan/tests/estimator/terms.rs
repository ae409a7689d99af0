//! The terms of the Allan variance, and what cannot be estimated.

use sins::Error;
use sins_allan::{Estimator, Term, total};

/// Half the variance of the second difference over τ², 3 s(0) - 4 s(τ) + s(2τ), is the shape.
#[test]
fn covariance_and_shape_are_of_the_same_noise() {
    for term in &Term::ALL[..4] {
        for tau_s in [0.01, 1.0, 300.0] {
            let s = |k: f64| term.covariance(k * tau_s);
            let variance = (3.0 * s(0.0) - 4.0 * s(1.0) + s(2.0)) / (tau_s * tau_s);
            assert!((variance / term.shape(tau_s) - 1.0).abs() < 1e-12, "{term:?} {tau_s}");
        }
    }
}

#[test]
fn each_term_has_its_slope() {
    for (term, slope) in Term::ALL.iter().zip([-2, -1, 0, 1, 2]) {
        assert!((term.shape(20.0) / term.shape(2.0) - 10f64.powi(slope)).abs() < 1e-12);
    }
    assert!((Term::Flicker.shape(1.0).sqrt() - 0.664).abs() < 5e-4);
    assert_eq!(total(&[1.0, 1.0, 0.0, 3.0, 2.0], 1.0), 3.0 + 1.0 + 1.0 + 1.0);
}

#[test]
fn what_cannot_be_estimated_is_rejected_with_its_limit() {
    let words = |error: Option<Error>| error.map(|error| error.to_string()).unwrap_or_default();
    assert_eq!(words(Estimator::new(44, 1.0).err()), "count = 44: must be at least 45");
    assert_eq!(words(Estimator::new(45, 0.0).err()), "interval_s = 0: must be from 1e-9 to 1e9");
    let estimator = Estimator::new(45, 1.0).unwrap();
    let rejected = |increments: &[f64]| words(estimator.estimate(increments).err());
    assert_eq!(rejected(&[1.0; 44]), "number of increments = 44: must be 45");
    assert_eq!(rejected(&[0.1; 45]), "increments = 0.1: expected noise, found this value throughout");
    // A first and a last value of another size are no noise; a third one may be.
    let mut constant = [0.1; 45];
    (constant[0], constant[44]) = (0.0, 0.2);
    assert_eq!(rejected(&constant), "increments = 0.1: expected noise, found this value throughout");
    constant[20] = 0.2;
    assert_eq!(rejected(&constant), "");
    let mut increments: Vec<f64> = (0..45).map(|k| f64::from(k * k % 11)).collect();
    assert!(estimator.estimate(&increments).is_ok());
    let small: Vec<f64> = increments.iter().map(|increment| 1e-40 * increment).collect();
    assert!(rejected(&small).contains("must be from 1e-70 to 1e70"), "{}", rejected(&small));
    increments[7] = f64::NAN;
    assert_eq!(rejected(&increments), "increments[7] = NaN: must be a finite number");
}
