//! Records that are made from the definitions of the noises: intervals contain the truth as often as they claim.

use sins_allan::{Estimator, TERMS, Term, total};

use super::noises::{Coefficients, Normal, increments};

const NONE: Coefficients = Coefficients { q: 0.0, n: 0.0, b: 0.0, k: 0.0, r: 0.0 };

/// Number of samples of a record, at intervals of 1 s.
const COUNT: usize = 4096;

const RUNS: u32 = if cfg!(feature = "long-tests") { 10_000 } else { 500 };

/// Bounds of the coverage of intervals of 95 %: the distribution of overlapping variances is only nearly χ².
const LEAST: f64 = 0.93;
const MOST: f64 = 0.985;

/// Checks how often an interval contained the truth, within five binomial standard deviations of the claim.
fn assert_coverage(label: &str, held: u32, may_be_long: bool) {
    let share = f64::from(held) / f64::from(RUNS);
    let scatter = |p: f64| 5.0 * (p * (1.0 - p) / f64::from(RUNS)).sqrt();
    assert!(share > LEAST - scatter(LEAST), "{label}: {share}");
    assert!(may_be_long || (share < MOST + scatter(MOST) && held < RUNS), "{label}: {share}");
}

/// Each noise alone, mixtures of two, and all five: every deviation, and every coefficient that is not zero. Intervals may be
/// too long with a ramp, which counts as random walk, and with quantization: rounding errors are uniform, and their squares
/// scatter less than those of normal numbers.
#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let estimator = Estimator::new(COUNT, 1.0).unwrap();
    for (label, truth) in [
        ("Q", Coefficients { q: 1.0, ..NONE }),
        ("N", Coefficients { n: 1.0, ..NONE }),
        ("B", Coefficients { b: 1.0, ..NONE }),
        ("K", Coefficients { k: 1.0, ..NONE }),
        ("N and K", Coefficients { n: 1.0, k: 0.01, ..NONE }),
        ("N and R", Coefficients { n: 1.0, r: 3e-4, ..NONE }),
        ("all", Coefficients { q: 10.0, n: 1.0, b: 0.1, k: 3e-3, r: 1e-4 }),
    ] {
        let squares = truth.squares();
        let may_be_long = truth.q > 0.0 || truth.r > 0.0;
        let mut held_deviations = vec![0; estimator.taus_s().len()];
        let mut held = [0; TERMS];
        for run in 0..RUNS {
            let series = increments(&truth, COUNT, 1.0, &mut Normal::new(u64::from(run)));
            let found = estimator.estimate(&series).unwrap();
            for (held, point) in held_deviations.iter_mut().zip(&found.points) {
                *held += u32::from(point.interval(0.95).contains(total(&squares, point.tau_s)));
            }
            for term in (0..TERMS).filter(|term| squares[*term] > 0.0) {
                held[term] += u32::from(found.interval(Term::ALL[term], 0.95).contains(squares[term]));
            }
        }
        let percent = |held: u32| 100.0 * f64::from(held) / f64::from(RUNS);
        let least = held_deviations.iter().copied().min().unwrap();
        let most = held_deviations.iter().copied().max().unwrap();
        print!("{label}: deviations {:.1} to {:.1} %", percent(least), percent(most));
        for (tau_s, held) in estimator.taus_s().iter().zip(&held_deviations) {
            assert_coverage(&format!("{label}, deviation at {tau_s} s"), *held, may_be_long);
        }
        for term in (0..TERMS).filter(|term| squares[*term] > 0.0) {
            print!(", {} {:.1} %", Term::ALL[term].letter(), percent(held[term]));
            assert_coverage(&format!("{label}, {}", Term::ALL[term].letter()), held[term], may_be_long);
        }
        println!();
    }
}

/// The interval of a coefficient that is zero contains zero at least as often as it claims.
#[test]
fn what_is_not_there_is_seldom_seen() {
    let estimator = Estimator::new(COUNT, 1.0).unwrap();
    let mut seen = [0; TERMS];
    for run in 0..RUNS {
        let truth = Coefficients { n: 1.0, ..NONE };
        let series = increments(&truth, COUNT, 1.0, &mut Normal::new(u64::from(run)));
        let found = estimator.estimate(&series).unwrap();
        for (term, seen) in seen.iter_mut().enumerate() {
            *seen += u32::from(found.interval(Term::ALL[term], 0.95).low > 0.0);
        }
    }
    println!("seen in {RUNS} records of N alone, of Q, N, B, K, R: {seen:?}");
    let most = 0.05 * f64::from(RUNS) + 5.0 * (0.05 * 0.95 * f64::from(RUNS)).sqrt();
    for (term, seen) in seen.iter().enumerate() {
        let is_there = Term::ALL[term] == Term::RandomWalk;
        // A record that by chance looks as if its values depended on each other may lose too many times.
        let least = RUNS - RUNS / 1000;
        assert!(if is_there { *seen >= least } else { f64::from(*seen) < most }, "{term}: {seen}");
    }
}

/// A long record of all five noises: each coefficient is within an interval that chance misses once in ten thousand times.
#[test]
fn all_five_are_recovered_from_one_record() {
    let (count, dt) = (1 << 20, 0.1);
    let estimator = Estimator::new(count, dt).unwrap();
    let truth = Coefficients { q: 0.3, n: 1.0, b: 0.2, k: 5e-3, r: 1e-4 };
    let found = estimator.estimate(&increments(&truth, count, dt, &mut Normal::new(1))).unwrap();
    for (term, square) in truth.squares().into_iter().enumerate() {
        let letter = Term::ALL[term].letter();
        let [put_in, recovered] = [square, found.fit.squares[term]].map(f64::sqrt);
        let usual = found.interval(Term::ALL[term], 0.95);
        println!(
            "{letter}: {put_in} put in, {recovered:.4e} ({:.4e} to {:.4e}) recovered",
            usual.low.sqrt(),
            usual.high.sqrt()
        );
        assert!(found.interval(Term::ALL[term], 0.9999).contains(square), "{letter}");
    }
    // Q, N and B each make most of the deviation somewhere, so they are resolved.
    for term in 0..3 {
        assert!(found.interval(Term::ALL[term], 0.95).low > 0.0, "{term} is not resolved");
    }
}

/// A record with gaps: pieces of many lengths, some too short for the longer times.
#[test]
fn intervals_hold_for_pieces() {
    let lengths = [1500, 40, 900, 300, 1000, 40, 3, 700];
    let estimator = Estimator::of_pieces(&lengths, 1.0).unwrap();
    for (label, truth) in [
        ("N", Coefficients { n: 1.0, ..NONE }),
        ("B", Coefficients { b: 1.0, ..NONE }),
        ("K", Coefficients { k: 1.0, ..NONE }),
        ("N and K", Coefficients { n: 1.0, k: 0.01, ..NONE }),
    ] {
        let squares = truth.squares();
        let mut held_deviations = vec![0; estimator.taus_s().len()];
        let mut held = [0; TERMS];
        for run in 0..RUNS {
            let whole = increments(&truth, 6000, 1.0, &mut Normal::new(u64::from(run)));
            let mut rest = &whole[..];
            let mut pieces = Vec::new();
            for (place, length) in lengths.into_iter().enumerate() {
                pieces.extend(&rest[..length]);
                rest = &rest[length + [1, 5, 100, 1, 600, 1, 1, 0][place]..];
            }
            let found = estimator.estimate(&pieces).unwrap();
            for (held, point) in held_deviations.iter_mut().zip(&found.points) {
                *held += u32::from(point.interval(0.95).contains(total(&squares, point.tau_s)));
            }
            for term in (0..TERMS).filter(|term| squares[*term] > 0.0) {
                held[term] += u32::from(found.interval(Term::ALL[term], 0.95).contains(squares[term]));
            }
        }
        println!("{label}: of {RUNS}, deviations {held_deviations:?}, coefficients {held:?}");
        for (tau_s, held) in estimator.taus_s().iter().zip(&held_deviations) {
            assert_coverage(&format!("{label}, deviation at {tau_s} s"), *held, false);
        }
        for term in (0..TERMS).filter(|term| squares[*term] > 0.0) {
            assert_coverage(&format!("{label}, {}", Term::ALL[term].letter()), held[term], false);
        }
    }
}
