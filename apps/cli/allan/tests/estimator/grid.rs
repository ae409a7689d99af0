//! Random records: each coefficient there or not, over four decades, behind a filter, repeated, or with gaps. What is reported holds.

use sins_allan::{Estimator, TERMS, Term};

use super::dependent::{averaged, low_passed};
use super::draws::Draws;
use super::noises::{Coefficients, Normal, increments};

const RUNS: u64 = if cfg!(feature = "long-tests") { 4000 } else { 240 };

/// Samples of a record of 1.1 h or 11 h at 10 Hz, less what a filter needs to begin.
const COUNTS: [usize; 2] = [40_000, 400_000];
const DT: f64 = 0.1;
const PIECES: [usize; 4] = [10, 3, 2, 5];

/// 0 in half of the cases, otherwise from `low` to 10⁴ `low`.
fn some(draws: &mut Draws, low: f64) -> f64 {
    if draws.one_in(2) { 0.0 } else { low * 1e4f64.powf(draws.unit()) }
}

#[test]
fn intervals_hold_over_a_grid() {
    let mut estimators: Vec<Option<Estimator>> = vec![None; 2 * COUNTS.len()];
    let (mut held, mut reported, mut explained) = ([0_u32; TERMS], [0_u32; TERMS], 0_u32);
    for run in 0..RUNS {
        let mut draws = Draws::new(run);
        let truth = Coefficients {
            q: some(&mut draws, 1e-3),
            n: 1.0,
            b: some(&mut draws, 1e-3),
            k: some(&mut draws, 1e-5),
            r: some(&mut draws, 1e-8),
        };
        // The longer records are a tenth: they take ten times as long.
        let size = usize::from(run % 10 == 0);
        let count = COUNTS[size];
        let whole = increments(&truth, count + 200, DT, &mut Normal::new(run));
        let kind = run / 10 % 5;
        let mut record = match kind {
            1 => averaged(&whole, 4),
            2 => whole
                .iter()
                .step_by(2)
                .zip(whole[1..].iter().step_by(2))
                .flat_map(|(a, b)| [0.5 * (a + b); 2])
                .collect(),
            3 => low_passed(&whole, 1.5, 2),
            _ => whole,
        };
        record.truncate(count);
        let has_gaps = kind == 4;
        if has_gaps {
            // Behind each piece a twentieth of the record is lost.
            let mut rest = &record[..];
            let mut pieces = Vec::new();
            for part in PIECES {
                pieces.extend(&rest[..part * count / 24]);
                rest = &rest[(part * count / 24 + count / 24).min(rest.len())..];
            }
            record = pieces;
        }
        let estimator = estimators[2 * size + usize::from(has_gaps)].get_or_insert_with(|| {
            let pieces: Vec<usize> = PIECES.iter().map(|part| part * count / 24).collect();
            Estimator::of_pieces(if has_gaps { &pieces } else { std::slice::from_ref(&count) }, DT).unwrap()
        });
        let found = estimator.estimate(&record).unwrap();
        if !found.is_explained {
            continue;
        }
        explained += 1;
        // Quantization shows in the shortest times only.
        for term in usize::from(found.fit.first > 0)..TERMS {
            let interval = found.interval(Term::ALL[term], 0.95);
            reported[term] += 1;
            held[term] += u32::from(interval.contains(truth.squares()[term]));
        }
    }
    println!("explained {explained} of {RUNS}; Q, N, B, K, R held {held:?} of {reported:?}");
    assert!(f64::from(explained) > 0.7 * RUNS as f64, "{explained}");
    for term in 0..TERMS {
        // 90 %, less four standard deviations of the share.
        let least = 0.9 - 4.0 * (0.09 / f64::from(reported[term])).sqrt();
        assert!(
            f64::from(held[term]) >= least * f64::from(reported[term]),
            "{term}: {held:?} of {reported:?}"
        );
    }
}
