//! Records whose neighbouring values depend on each other, as most sensors give them: the coefficients are those of the noise itself,
//! within intervals that hold, from averaging times beyond the dependence.

use sins_allan::{Estimator, Filter, TERMS, Term};

use super::noises::{Coefficients, Normal, increments};

const COUNT: usize = 40_000;
const DT: f64 = 0.01;
const RUNS: u32 = if cfg!(feature = "long-tests") { 1000 } else { 60 };

/// Mean of so many neighbours.
pub fn averaged(values: &[f64], width: usize) -> Vec<f64> {
    values.windows(width).map(|window| window.iter().sum::<f64>() / width as f64).collect()
}

/// A sensor that is so many times slower than its log: each rate stands so many times.
fn repeated(truth: &Coefficients, normal: &mut Normal, times: usize) -> Vec<f64> {
    let slow = increments(truth, COUNT / times, DT * times as f64, normal);
    slow.iter().flat_map(|value| std::iter::repeat_n(value / times as f64, times)).collect()
}

/// A low-pass of so many first-order stages with the time constant `steps`.
pub fn low_passed(values: &[f64], steps: f64, stages: usize) -> Vec<f64> {
    let gain = -(-1.0 / steps).exp_m1();
    (0..stages).fold(values.to_vec(), |values, _| {
        let mut state = 0.0;
        let filtered = values.iter().map(|value| {
            state += gain * (value - state);
            state
        });
        filtered.skip(20 * steps as usize).collect()
    })
}

type Record = fn(&Coefficients, &mut Normal) -> Vec<f64>;

/// Whether a filter is that of the record.
type IsRight = fn(Filter) -> bool;

fn fast(truth: &Coefficients, normal: &mut Normal) -> Vec<f64> {
    increments(truth, COUNT, DT, normal)
}

fn is_near(found: f64, hz: f64) -> bool {
    (found / hz - 1.0).abs() < 0.1
}

const RECORDS: [(&str, Record, IsRight); 6] = [
    ("mean of 4", |truth, normal| averaged(&fast(truth, normal), 4), |found| found == Filter::Mean(4)),
    (
        "mean of 10",
        |truth, normal| averaged(&fast(truth, normal), 10),
        |found| matches!(found, Filter::Mean(9..=11)),
    ),
    ("twice", |truth, normal| repeated(truth, normal, 2), |_| true),
    ("five times", |truth, normal| repeated(truth, normal, 5), |_| true),
    (
        "low-pass of 5 Hz",
        |truth, normal| low_passed(&fast(truth, normal), 3.2, 1),
        |found| matches!(found, Filter::FirstOrder(hz) if is_near(hz, 4.97)),
    ),
    ("low-pass of second order, 13 Hz", |truth, normal| low_passed(&fast(truth, normal), 0.8, 2), |_| true),
];

#[test]
fn a_dependence_of_neighbours_leaves_the_noise_as_it_is() {
    let truths = [
        ("N", Coefficients { n: 1e-3, ..Default::default() }),
        ("N and K", Coefficients { n: 1e-3, k: 3e-4, ..Default::default() }),
        ("N and B", Coefficients { n: 1e-3, b: 5e-4, ..Default::default() }),
    ];
    std::thread::scope(|scope| {
        for halves in RECORDS.chunks(RECORDS.len() / 2) {
            scope.spawn(|| halves.iter().for_each(|record| holds(record, &truths)));
        }
    });
}

/// The figures of the runs of a record.
fn holds(&(filter, record, is_right): &(&str, Record, IsRight), truths: &[(&str, Coefficients)]) {
    let mut estimator = None;
    for (name, truth) in truths {
        let (mut held, mut reported, mut explained, mut used_from, mut named) =
            ([0_u32; TERMS], [0_u32; TERMS], 0, 0, 0);
        for run in 0..RUNS {
            let record = record(truth, &mut Normal::new(u64::from(run)));
            let estimator = estimator.get_or_insert_with(|| Estimator::new(record.len(), DT).unwrap());
            let found = estimator.estimate(&record).unwrap();
            if !found.is_explained {
                continue;
            }
            explained += 1;
            used_from += found.fit.first;
            named += u32::from(estimator.filter(&found).is_none_or(is_right));
            for term in 1..TERMS {
                let interval = found.interval(Term::ALL[term], 0.95);
                held[term] += u32::from(interval.contains(truth.squares()[term]));
                reported[term] += 1;
                assert!(interval.low < interval.high, "{filter}, {name}: {interval:?}");
            }
        }
        println!(
            "{filter}, {name}: explained {explained} of {RUNS}, from place {used_from}/{RUNS}, no wrong filter {named}; N, B, K, R held {held:?}"
        );
        assert!(explained >= RUNS * 19 / 20, "{filter}, {name}: {explained}");
        assert!(named >= explained * 19 / 20, "{filter}, {name}: {named} of {explained}");
        for term in 1..TERMS {
            // 90 %, less four standard deviations of the share.
            let least = 0.9 - 4.0 * (0.09 / f64::from(reported[term])).sqrt();
            let share = f64::from(held[term]) / f64::from(reported[term]);
            assert!(share >= least, "{filter}, {name}, {term}: {share}");
        }
    }
}
