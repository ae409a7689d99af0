//! Statistics of many runs: the same bits for any split, right where means are large and scatter small, and at the ends of their
//! ranges; damaged statistics are refused.

use nalgebra::{SMatrix, SVector, Vector3};
use sins::ensemble::Ensemble;
use sins::ensemble::statistics::{Decision, MAX_RUNS, RADIAL_ERROR, Statistics, Verdict};
use sins::errors::NavigationErrors;
use sins::mechanization::VerticalMode;
use sins::sensors::{InitialErrorParameters, TriadParameters, paper_simulation2};
use sins::{ErrorKind, ErrorSource, Options, Simulator};

use crate::support::draws::Draws;
use crate::support::resting_sample;

type States = SVector<f64, 9>;
type Covariance = SMatrix<f64, 9, 9>;

/// Resolutions of position, velocity and misalignment, as the header states them.
const RESOLUTIONS: [f64; 3] = [1.0 / 4194304.0, 1.0 / 536870912.0, 1.0 / 35184372088832.0];
/// Ends of the ranges of position, velocity and misalignment.
const RANGES: [f64; 3] = [33554432.0, 262144.0, 4.0];

fn errors(states: &States) -> NavigationErrors {
    NavigationErrors {
        position_n: states.fixed_rows::<3>(0).into(),
        latitude_rad: 0.0,
        longitude_rad: 0.0,
        velocity_n: states.fixed_rows::<3>(3).into(),
        misalignment_n: states.fixed_rows::<3>(6).into(),
        roll_rad: 0.0,
        pitch_rad: 0.0,
        heading_rad: 0.0,
        outside_validity: false,
    }
}

fn of(samples: &[States]) -> Statistics {
    let mut statistics = Statistics::default();
    samples.iter().for_each(|states| statistics.add(&errors(states)).unwrap());
    statistics
}

/// Numbers of mean 0 and variance 1 to a percent.
fn normal(draws: &mut Draws) -> f64 {
    (0..12).map(|_| draws.within(-0.5, 0.5)).sum()
}

/// Correlated states with these means and scatters of position, velocity and misalignment.
fn samples(draws: &mut Draws, count: usize, mean: [f64; 3], sigma: [f64; 3]) -> Vec<States> {
    (0..count)
        .map(|_| {
            let shared = normal(draws);
            States::from_fn(|k, _| {
                let own = if k % 2 == 0 { 0.6 * shared + 0.8 * normal(draws) } else { normal(draws) };
                mean[k / 3] * (1.0 - 0.1 * k as f64) + sigma[k / 3] * own
            })
        })
        .collect()
}

#[test]
fn any_split_and_any_order_of_merges_gives_the_same_bits() {
    let mut draws = Draws::new(1);
    for round in 0..50 {
        let mut all = samples(&mut draws, 200, [0.0, 3.0, 1e-3], [10f64.powi(round % 8 - 1), 0.1, 1e-4]);
        // Some out of range, in every way.
        all[7][round as usize % 9] = f64::NAN;
        all[8][0] = 1e9;
        all[9][4] = -3e5;
        let mut whole = of(&all);
        whole.add_diverged().unwrap();
        assert_eq!((whole.runs, whole.out_of_range, whole.diverged, whole.good()), (201, 3, 1, 197));

        let mut parts: Vec<Statistics> = Vec::new();
        let mut rest = &all[..];
        while !rest.is_empty() {
            let (part, others) = rest.split_at(draws.below(rest.len().min(40)) + 1);
            parts.push(of(part));
            rest = others;
        }
        parts.push(Statistics::default());
        let mut one_diverged = Statistics::default();
        one_diverged.add_diverged().unwrap();
        parts.push(one_diverged);
        while parts.len() > 1 {
            let from = parts.swap_remove(draws.below(parts.len()));
            let into = draws.below(parts.len());
            let mut turned = from;
            turned.merge(&parts[into]).unwrap();
            parts[into].merge(&from).unwrap();
            assert_eq!(turned, parts[into]);
        }
        assert_eq!(parts[0], whole);
    }
}

/// The two-pass algorithm of a textbook, on the numbers as they were rounded to their resolutions.
fn two_passes(samples: &[States]) -> (States, Covariance, States) {
    let n = samples.len() as f64;
    let rounded: Vec<States> = samples
        .iter()
        .map(|states| States::from_fn(|k, _| (states[k] / RESOLUTIONS[k / 3]).round_ties_even()))
        .collect();
    let unit = States::from_fn(|k, _| RESOLUTIONS[k / 3]);
    // Whole numbers of less than 2^47: their differences from one of them are exact, and so are the sums of these.
    let origin = rounded[0];
    let shift = rounded.iter().fold(States::zeros(), |sum, states| sum + (states - origin)) / n;
    let mut covariance = Covariance::zeros();
    let mut squares = States::zeros();
    for states in &rounded {
        let deviation = (states - origin - shift).component_mul(&unit);
        covariance += deviation * deviation.transpose();
        squares += states.component_mul(&unit).map(|x| x * x);
    }
    ((origin + shift).component_mul(&unit), covariance / (n - 1.0), (squares / n).map(f64::sqrt))
}

/// The verdict of a split ensemble is that of the whole, and its counts are those of the runs one by one.
#[test]
fn a_verdict_counts_the_runs_and_does_not_depend_on_the_split() {
    let mut draws = Draws::new(7);
    let all = samples(&mut draws, 2000, [0.0; 3], [500.0, 0.1, 1e-4]);
    let radius = |states: &States| states[0].hypot(states[1]);
    let mut whole = of(&all);
    whole.add_diverged().unwrap();
    let mut merged = of(&all[1200..]);
    merged.merge(&of(&all[..1200])).unwrap();
    merged.add_diverged().unwrap();
    for limit_m in [0.01, 40.0, 580.0, 1000.0, 1222.0, 1e5] {
        let verdict = whole.meets(limit_m, 95.0).unwrap();
        assert_eq!(verdict, merged.meets(limit_m, 95.0).unwrap());
        let inside = all.iter().filter(|states| radius(states) <= limit_m).count() as u64;
        assert!(
            (verdict.inside..=verdict.inside + verdict.near_limit).contains(&inside),
            "{limit_m}: {verdict:?}"
        );
        let near = all.iter().filter(|states| (radius(states) / limit_m - 1.0).abs() < 0.011).count() as u64;
        assert!(verdict.near_limit <= near, "{limit_m}: {verdict:?}");
        assert_eq!(verdict.runs, 2001);
    }
    // R95 of a circular normal distribution is 2.4477 sigma: 1224 m. The samples' own is a bucket from there.
    assert_eq!(whole.meets(580.0, 95.0).unwrap().decision, Decision::NotMet);
    assert_eq!(whole.meets(2000.0, 95.0).unwrap().decision, Decision::Met);
    let r95 = whole.figures().unwrap().r95_m;
    assert_eq!(whole.meets(r95, 95.0).unwrap().decision, Decision::Undecided);
}

/// Wilson's interval contains the required fraction exactly while the requirement is undecided, and the number of further runs is
/// the smallest that decides. Reference intervals: Newcombe, Stat. Med. 17 (1998) 857, table I, method 3.
#[test]
fn a_verdict_decides_where_the_interval_of_wilson_ends() {
    let interval = |inside, runs| Verdict::new(runs, inside, 0, 50.0).map(|v| [v.low, v.high]).unwrap();
    for (inside, runs, expected) in
        [(81, 263, [0.2553, 0.3662]), (15, 148, [0.0624, 0.1605]), (0, 20, [0.0, 0.1611])]
    {
        let found = interval(inside, runs);
        assert!((0..2).all(|end| (found[end] - expected[end]).abs() < 5e-5), "{inside}/{runs}: {found:?}");
    }
    for percent in [1.0, 50.0, 95.0, 99.9] {
        for runs in [1_u64, 10, 73, 500] {
            for inside in 0..=runs {
                let verdict = Verdict::new(runs, inside, 0, percent).unwrap();
                let contains = verdict.low <= percent / 100.0 && percent / 100.0 <= verdict.high;
                assert_eq!(
                    contains,
                    verdict.decision == Decision::Undecided,
                    "{inside}/{runs} {percent} {verdict:?}"
                );
                let Some(more) = verdict.more_runs.filter(|&more| more > 0 && inside == runs) else {
                    continue;
                };
                // All runs inside: the fraction stays 1 with any number of runs.
                let with = |more: u64| Verdict::new(runs + more, runs + more, 0, percent).unwrap().decision;
                assert_eq!((with(more), with(more - 1)), (Decision::Met, Decision::Undecided));
            }
        }
    }
    let none = Verdict::new(0, 0, 0, 95.0).unwrap();
    assert_eq!((none.decision, none.low, none.high, none.more_runs), (Decision::Undecided, 0.0, 1.0, None));
    assert_eq!(Verdict::new(100, 50, 0, 50.0).unwrap().more_runs, None);
    for percent in [0.0, 100.0, -1.0, f64::NAN] {
        assert_eq!(Verdict::new(10, 5, 0, percent).unwrap_err().kind, ErrorKind::InvalidArgument);
    }
    for radius_m in [0.0, -1.0, f64::NAN, f64::INFINITY, 33554433.0] {
        assert_eq!(Statistics::EMPTY.meets(radius_m, 50.0).unwrap_err().field, "radius_m");
    }
}

#[test]
fn figures_are_those_of_two_passes_in_floating_point() {
    let mut draws = Draws::new(2);
    let (count, limit, mut roundings) = (3000, 1e4, 0.0_f64);
    for (mean, sigma) in [
        ([0.0, 0.0, 0.0], [100.0, 0.1, 1e-4]),
        ([5000.0, -3.0, 1e-2], [800.0, 0.5, 1e-3]),
        // Means a million and more times the scatter: a sum of squares in floating point has no digit of it.
        ([2e7, 2e5, 3.0], [1e-3, 1e-6, 1e-10]),
        // The scatter is a few resolutions.
        ([2.3e7, 2.5e5, -3.9], [1e-6, 1e-8, 1e-13]),
    ] {
        let all = samples(&mut draws, count, mean, sigma);
        let figures = of(&all).figures().unwrap();
        let (mean, covariance, rms) = two_passes(&all);
        for k in 0..9 {
            // The first number of the two passes is up to six sigmas from their mean.
            let scale = mean[k].abs() + 6.0 * covariance[(k, k)].sqrt();
            assert!((figures.mean[k] - mean[k]).abs() <= 2.0 * f64::EPSILON * scale, "mean {k}");
            // Rounded once for each of the 3000 terms.
            assert!((figures.rms[k] - rms[k]).abs() <= 3e3 * f64::EPSILON * rms[k], "rms {k}");
            for l in 0..9 {
                let scale = (covariance[(k, k)] * covariance[(l, l)]).sqrt();
                let error = (figures.covariance[(k, l)] - covariance[(k, l)]).abs();
                assert!(error <= limit * f64::EPSILON * scale, "covariance {k} {l}: {error} of {scale}");
                roundings = roundings.max(error / (f64::EPSILON * scale));
            }
        }
        let radial = (rms[0] * rms[0] + rms[1] * rms[1]).sqrt();
        assert!((figures.radial_rms_m - radial).abs() <= 3e3 * f64::EPSILON * radial);
    }
    println!("figure: covariances to {roundings:.0} roundings of {count} terms (limit {limit:e})");
}

#[test]
fn radii_are_those_of_the_sorted_runs_to_the_stated_error() {
    let mut draws = Draws::new(3);
    let mut off = 0.0_f64;
    for (count, sigma) in [(1, 1.0), (2, 300.0), (19, 0.02), (20, 5.0), (21, 5.0), (1000, 1e5), (1001, 4e-3)]
    {
        let all = samples(&mut draws, count, [0.0; 3], [sigma, 0.0, 0.0]);
        let mut radii: Vec<f64> = all.iter().map(|states| states.fixed_rows::<2>(0).norm()).collect();
        radii.sort_by(f64::total_cmp);
        let figures = of(&all).figures().unwrap();
        // The least radius that at least this share of the runs does not exceed.
        let exact = |percent: usize| radii[(percent * count).div_ceil(100) - 1];
        for (found, exact) in [(figures.cep50_m, exact(50)), (figures.r95_m, exact(95))] {
            let allowed = (RADIAL_ERROR * exact).max(0.5e-3) + 2.0 * RESOLUTIONS[0];
            assert!((found - exact).abs() <= allowed, "{count} runs: {found} for {exact}");
            if RADIAL_ERROR * exact > 0.5e-3 {
                off = off.max((found - exact).abs() / exact);
            }
        }
        let largest = radii[count - 1];
        assert!((figures.largest_radial_m - largest).abs() <= 2.0 * RESOLUTIONS[0], "{largest}");
    }
    assert_eq!(RADIAL_ERROR, 0.005);
    println!("figure: radii to {:.2} % (limit {:.1} %)", 100.0 * off, 100.0 * RADIAL_ERROR);
}

#[test]
fn no_run_and_one_run_have_figures() {
    let figures = Statistics::default().figures().unwrap();
    assert_eq!((figures.runs, figures.mean, figures.rms), (0, States::zeros(), States::zeros()));
    assert_eq!((figures.covariance, figures.cep50_m, figures.r95_m), (Covariance::zeros(), 0.0, 0.0));

    let states = States::from_fn(|k, _| 0.5 * (k as f64 - 4.0));
    let figures = of(&[states]).figures().unwrap();
    assert_eq!((figures.mean, figures.rms), (states, states.abs()));
    assert_eq!(figures.covariance, Covariance::zeros());
    // 2.5 m, rounded down to a resolution.
    assert!((figures.largest_radial_m - 2.5).abs() <= RESOLUTIONS[0] && figures.cep50_m <= figures.r95_m);

    let mut diverged = Statistics::default();
    diverged.add_diverged().unwrap();
    let figures = diverged.figures().unwrap();
    assert_eq!((figures.runs, figures.diverged, figures.r95_m), (1, 1, 0.0));
}

/// The largest possible number of runs, each of `samples` equally often: by doubling.
fn most_of(samples: &[States]) -> Statistics {
    let mut doubled = of(samples);
    let mut sum = Statistics::default();
    while sum.runs + doubled.runs <= MAX_RUNS.into() {
        sum.merge(&doubled).unwrap();
        if doubled.runs * 2 > MAX_RUNS.into() {
            break;
        }
        let same = doubled;
        doubled.merge(&same).unwrap();
    }
    sum
}

/// All states at the ends of their ranges in the largest possible number of runs.
#[test]
fn nothing_overflows_at_the_ends_of_all_ranges_together() {
    let mut end = States::from_fn(|k, _| RANGES[k / 3]);
    // East and north together are a radius, which has the same limit.
    (end[0], end[1]) = (RANGES[0] - 1.0, 0.0);
    let all = most_of(&[end]);
    assert_eq!((all.runs, all.out_of_range), (u64::from(MAX_RUNS), 0));
    let figures = all.figures().unwrap();
    assert_eq!((figures.mean, figures.rms, figures.covariance), (end, end, Covariance::zeros()));

    let both = most_of(&[end, -end]);
    let figures = both.figures().unwrap();
    assert_eq!((both.runs, figures.mean), (u64::from(MAX_RUNS) - 1, States::zeros()));
    let n = f64::from(MAX_RUNS) - 1.0;
    for (k, l) in (0..9).flat_map(|k| (0..9).map(move |l| (k, l))) {
        let exact = end[k] * end[l] * n / (n - 1.0);
        assert!((figures.covariance[(k, l)] - exact).abs() <= 2.0 * f64::EPSILON * exact);
    }
    assert_eq!(figures.cep50_m, figures.r95_m);

    let (mut into, one) = (all, of(&[end]));
    let error = into.merge(&one).unwrap_err();
    assert_eq!(error.to_string(), "statistics.runs = 4294967296: must be from 0 to 4294967295");
    assert!(into.add(&errors(&end)).is_err() && into.add_diverged().is_err() && into == all);
}

#[test]
fn what_is_out_of_range_is_counted_and_left_out() {
    for k in 0..9 {
        let range = RANGES[k / 3];
        for (value, out) in [
            (range, k < 2),
            (-range, k < 2),
            (range * (1.0 - 1e-9), false),
            (range * (1.0 + 1e-9), true),
            (-1e300, true),
            (f64::INFINITY, true),
            (f64::NAN, true),
        ] {
            let mut states = States::zeros();
            states[k] = value;
            let statistics = of(&[states]);
            assert_eq!((statistics.out_of_range, statistics.good()), (out.into(), (!out).into()), "{value}");
            assert!(!out || statistics.sums == [0; 18] && statistics.products == [0; 90]);
        }
    }
    let corner = States::from_fn(|k, _| if k < 2 { 0.8 * RANGES[0] } else { 0.0 });
    assert_eq!(of(&[corner]).out_of_range, 1);
}

#[test]
fn damaged_and_foreign_statistics_are_refused() {
    let mut draws = Draws::new(4);
    let good = of(&samples(&mut draws, 100, [10.0, 1.0, 1e-3], [100.0, 0.1, 1e-4]));
    let refused = |change: &dyn Fn(&mut Statistics), words: &str| {
        let mut bad = good;
        change(&mut bad);
        let mut into = good;
        let error = into.merge(&bad).unwrap_err();
        assert!(error.kind == ErrorKind::InvalidArgument && into == good, "{error}");
        assert!(error.to_string().contains(words), "{words}: {error}");
        assert_eq!(bad.figures().unwrap_err(), error);
        let before = bad;
        assert!(bad.merge(&good).is_err() && bad == before);
    };
    refused(&|s| s.struct_size += 8, "statistics.struct_size = 14928: must be 14920");
    refused(&|s| s.layout = 2, "statistics.layout = 2: is of another release or damaged; this one reads 1");
    refused(&|s| s.layout = 0, "statistics.layout = 0");
    refused(&|s| s.reserved = 1, "statistics.reserved = 1: must be 0");
    refused(&|s| s.runs = 1 << 32, "statistics.runs = 4294967296: must be from 0 to 4294967295");
    refused(&|s| s.runs += 1, "sum of statistics.histogram = 100");
    refused(&|s| s.diverged = 101, "statistics.diverged = 101: is damaged: more than runs, which are 100");
    refused(&|s| (s.diverged, s.out_of_range) = (u64::MAX, u64::MAX), "statistics.diverged");
    refused(&|s| (s.diverged, s.out_of_range) = (60, 60), "diverged + out_of_range = 120");
    refused(&|s| s.outside_validity = 101, "statistics.outside_validity = 101");
    refused(&|s| s.largest_radial *= 2, "statistics.largest_radial");
    refused(&|s| s.largest_radial = u64::MAX, "statistics.largest_radial");
    refused(&|s| s.histogram[5] += 1, "sum of statistics.histogram = 101");
    refused(&|s| s.histogram = [u32::MAX; 3501], "sum of statistics.histogram");
    for word in 0..18 {
        refused(&|s| s.sums[word] ^= 1 << 63, "statistics.sums");
    }
    for word in (1..90).step_by(2) {
        refused(&|s| s.products[word] ^= 1 << 62, "no runs have such sums");
    }
    let mut of_none = Statistics { layout: 1, ..Default::default() };
    of_none.sums[4] = 1;
    assert!(of_none.figures().unwrap_err().to_string().starts_with("statistics.sums[2]"));
}

/// Whichever bits are flipped, nothing panics.
#[test]
fn no_damage_does_harm() {
    let mut draws = Draws::new(5);
    let good = of(&samples(&mut draws, 10, [10.0, 1.0, 1e-3], [100.0, 0.1, 1e-4]));
    let mut passed = 0;
    for _ in 0..20_000 {
        let mut bad = good;
        match draws.below(4) {
            0 => bad.sums[draws.below(18)] ^= 1 << draws.below(64),
            1 => bad.products[draws.below(90)] ^= 1 << draws.below(64),
            2 => bad.histogram[draws.below(3501)] ^= 1 << draws.below(32),
            _ => {
                let word = [&mut bad.runs, &mut bad.diverged, &mut bad.largest_radial];
                *word.into_iter().nth(draws.below(3)).unwrap() ^= 1 << draws.below(64);
            }
        }
        let mut into = good;
        if into.merge(&bad).is_ok() {
            passed += 1;
            let figures = into.figures().unwrap();
            assert!(figures.covariance.iter().chain(figures.rms.iter()).all(|x| x.is_finite()));
        }
    }
    println!("{passed} of 20000 were still sums of some runs");
}

fn template(error_model: bool) -> Simulator {
    let options = Options { error_model, vertical: VerticalMode::Damped, ..Default::default() };
    let mut simulator = Simulator::new(&options).unwrap();
    let (gyro, accel) = paper_simulation2();
    let sigma =
        |triad: TriadParameters, size: f64| TriadParameters { bias_sigma: Vector3::repeat(size), ..triad };
    simulator.set_gyro(&sigma(gyro, 1e-7)).unwrap();
    simulator.set_accel(&sigma(accel, 1e-3)).unwrap();
    let initial = InitialErrorParameters { position_sigma_n: Vector3::repeat(5.0), ..Default::default() };
    simulator.set_initial_errors(&initial).unwrap();
    simulator
}

/// Statistics of the error data that exist, before the first step and after 50.
fn statistics_of(error_model: bool, first_run: u64, runs: usize) -> Vec<Statistics> {
    let mut ensemble = Ensemble::new(&template(error_model), first_run, runs).unwrap();
    ensemble.push_sample(&resting_sample(0.0)).unwrap();
    let sources = [ErrorSource::Navigation, ErrorSource::Model];
    let read = |ensemble: &Ensemble| {
        let there_are = sources.iter().take(if error_model { 2 } else { 1 });
        there_are.map(|&source| ensemble.statistics(source).unwrap()).collect::<Vec<_>>()
    };
    let mut statistics = read(&ensemble);
    for k in 1..=50 {
        ensemble.push_sample(&resting_sample(f64::from(k) * 0.1)).unwrap();
        ensemble.step().unwrap();
    }
    statistics.extend(read(&ensemble));
    statistics
}

#[test]
fn an_ensemble_has_the_bits_of_its_parts() {
    for error_model in [false, true] {
        compare_with_parts(error_model);
    }
}

fn compare_with_parts(error_model: bool) {
    let whole = statistics_of(error_model, 7, 40);
    let parts =
        [(7, 1), (8, 22), (30, 17)].map(|(first_run, runs)| statistics_of(error_model, first_run, runs));
    for order in [[0, 1, 2], [2, 0, 1], [1, 2, 0]] {
        for (k, whole) in whole.iter().enumerate() {
            let mut merged = Statistics::default();
            order.iter().for_each(|&part| merged.merge(&parts[part][k]).unwrap());
            assert_eq!(&merged, whole);
        }
    }
    let figures = whole[whole.len() / 2].figures().unwrap();
    assert_eq!((figures.runs, figures.diverged, figures.outside_validity), (40, 0, 0));
    // The drawn position errors have a sigma of 5 m: chi-square of 39 degrees of freedom, all but 1e-6 on either side.
    let sigma_m = figures.covariance[(0, 0)].sqrt();
    assert!(sigma_m > 5.0 * 0.53 && sigma_m < 5.0 * 1.58, "{sigma_m}");
}

#[test]
fn statistics_need_a_sample_and_the_model_its_option() {
    let ensemble = Ensemble::new(&template(true), 0, 2).unwrap();
    let error = ensemble.statistics(ErrorSource::Navigation).unwrap_err();
    assert_eq!((error.kind, error.to_string().as_str()), (ErrorKind::BadState, "no sample yet"));

    let mut ensemble = Ensemble::new(&Simulator::new(&Options::default()).unwrap(), 0, 2).unwrap();
    ensemble.push_sample(&resting_sample(0.0)).unwrap();
    assert_eq!(ensemble.statistics(ErrorSource::Model).unwrap_err().kind, ErrorKind::BadState);
    assert_eq!(ensemble.statistics(ErrorSource::Navigation).unwrap().runs, 2);
}
