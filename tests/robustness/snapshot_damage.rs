//! Damaged snapshots are refused and change nothing. Forged snapshots with the right checksum are refused too, or give a
//! simulator that works.

use nalgebra::Vector3;
use sins::signal::mounting::MountingParameters;
use sins::snapshot::{SnapshotOf, seal};
use sins::{ErrorKind, Options, Simulator};

use crate::support::draws::Draws;
use crate::support::forged::{forge, wild, words};
use crate::support::moments::{reads, snapshot};
use crate::support::resting_sample;
use crate::support::runs::{Run, everything_at_once, largest, runs};

/// A simulator in flight with every effect on.
fn in_flight() -> Simulator {
    let Run { options, calls, .. } = largest();
    let mut simulator = Simulator::new(&options).unwrap();
    for call in &calls {
        call.make(&mut simulator);
    }
    simulator
}

fn refused(simulator: &mut Simulator, bytes: &[u8]) -> String {
    let error = simulator.load_snapshot(bytes).unwrap_err();
    assert_eq!(error.kind, ErrorKind::Snapshot, "{error}");
    error.to_string()
}

/// Every byte with every other value, and every length.
#[test]
fn an_altered_or_cut_snapshot_is_refused_and_changes_nothing() {
    let mut simulator = in_flight();
    let (good, before) = (snapshot(&simulator), reads(&simulator));
    let mut bytes = good.clone();
    for at in 0..good.len() {
        for change in 1..=255 {
            bytes[at] = good[at] ^ change;
            refused(&mut simulator, &bytes);
        }
        bytes[at] = good[at];
    }
    for length in 0..good.len() {
        refused(&mut simulator, &good[..length]);
    }
    bytes.push(0);
    refused(&mut simulator, &bytes);
    assert_eq!(reads(&simulator), before);
    assert!(snapshot(&simulator) == good);
}

fn forged(words: &[u64]) -> Vec<u8> {
    forge(words, SnapshotOf::Simulator)
}

/// For any content: nothing panics, hangs or overflows, and a new snapshot that loads gives the same bytes again.
fn works(simulator: &mut Simulator, run: &Run, from: usize) {
    reads(simulator);
    for call in run.calls[from..].iter().take(12) {
        call.make(simulator);
        reads(simulator);
    }
    let saved = snapshot(simulator);
    if simulator.load_snapshot(&saved).is_ok() {
        assert!(snapshot(simulator) == saved);
    }
    simulator.reset();
    for call in run.calls.iter().take(12) {
        call.make(simulator);
    }
}

#[test]
fn forged_snapshots_are_refused_or_work() {
    let rounds = if cfg!(feature = "long-tests") { 20_000 } else { 400 };
    let mut draws = Draws::new(0);
    let (mut accepted, mut all) = (0, 0);
    for run in runs() {
        let mut straight = Simulator::new(&run.options).unwrap();
        let cut = run.calls.len().min(80) * 2 / 3;
        for call in &run.calls[..cut] {
            call.make(&mut straight);
        }
        let good = words(&snapshot(&straight));
        assert!(forged(&good) == snapshot(&straight), "{}: the forger's words are the saved ones", run.name);
        for _ in 0..rounds {
            let mut words = good.clone();
            for _ in 0..=draws.below(3) {
                let at = draws.below(words.len());
                words[at] = wild(&mut draws, words[at]);
            }
            match draws.below(20) {
                0 => words.truncate(draws.below(words.len())),
                1 => words.insert(draws.below(words.len()), 1),
                2 => drop(words.remove(draws.below(words.len()))),
                _ => {}
            }
            let mut simulator = Simulator::new(&Options::default()).unwrap();
            let before = reads(&simulator);
            all += 1;
            match simulator.load_snapshot(&forged(&words)) {
                Ok(()) => {
                    accepted += 1;
                    works(&mut simulator, &run, cut);
                }
                Err(error) => {
                    assert_eq!(error.kind, ErrorKind::Snapshot, "{error}");
                    assert_eq!(reads(&simulator), before);
                }
            }
        }
    }
    println!("{accepted} of {all} accepted");
    // Other values of a state in flight are as valid as the true ones.
    assert!(accepted > all / 10 && accepted < all * 9 / 10, "{accepted} of {all}");
}

/// Asserts that everything that is read is a number.
fn finite(simulator: &Simulator, who: impl FnOnce() -> String) {
    let read = reads(simulator);
    assert!(!read.contains("NaN") && !read.contains("inf"), "{}: {read}", who());
}

/// Each word of each run's snapshot, flown and with its parameters, is forged in turn: not a number, infinite, of the other sign,
/// huge, zero. An accepted snapshot is a simulator: it reads numbers, flies on and reads numbers. Each word of a run gets a quarter
/// of these values, in the next run another quarter; all of them with `--features long-tests`.
#[test]
fn each_word_forged_is_refused_or_a_simulator_of_numbers() {
    let wild = |word: u64| {
        let value = f64::from_bits(word);
        let numbers = [
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            -value,
            f64::MAX,
            -1e300,
            1e150,
            1e100,
            -1e30,
            1e15,
            -1.0,
            1e-300,
            -1e-310,
        ];
        let words = [0, 1, 2, 255, u64::MAX, u64::MAX >> 1, word.wrapping_add(1)];
        numbers.map(f64::to_bits).into_iter().chain(words)
    };
    let (mut accepted, mut all) = (0, 0);
    let part = if cfg!(feature = "long-tests") { 1 } else { 4 };
    for (turn, run) in runs().into_iter().chain([everything_at_once()]).enumerate() {
        let mut straight = Simulator::new(&run.options).unwrap();
        let cut = run.calls.len().min(1000) * 2 / 3;
        for call in &run.calls[..cut] {
            call.make(&mut straight);
        }
        finite(&straight, || run.name.to_owned());
        let good = words(&snapshot(&straight));
        let mut words = good.clone();
        for at in 0..good.len() {
            for word in wild(good[at]).skip((turn + at) % part).step_by(part) {
                words[at] = word;
                all += 1;
                let who = || format!("{}, word {at}: {word:#x} = {:e}", run.name, f64::from_bits(word));
                let mut simulator = Simulator::new(&Options::default()).unwrap();
                if simulator.load_snapshot(&forged(&words)).is_err() {
                    continue;
                }
                accepted += 1;
                finite(&simulator, who);
                for call in run.calls[cut..].iter().take(4) {
                    call.make(&mut simulator);
                    finite(&simulator, who);
                }
            }
            words[at] = good[at];
        }
    }
    println!("{accepted} of {all} accepted");
    assert!(accepted > all / 20 && accepted < all * 9 / 10, "{accepted} of {all}");
}

/// Random bytes that are not of the format, with a good header.
#[test]
fn noise_with_a_good_header_is_refused() {
    let mut draws = Draws::new(1);
    let mut simulator = in_flight();
    let good = snapshot(&simulator);
    for length in 24..2000 {
        let mut bytes: Vec<u8> = (0..length).map(|_| draws.next() as u8).collect();
        seal(&mut bytes, SnapshotOf::Simulator);
        refused(&mut simulator, &bytes);
        // A piece of a good snapshot that ends too early.
        let mut piece = good[..length].to_vec();
        seal(&mut piece, SnapshotOf::Simulator);
        refused(&mut simulator, &piece);
    }
    assert!(snapshot(&simulator) == good);
}

#[test]
fn a_refusal_names_what_is_wrong() {
    let mut simulator = in_flight();
    let good = words(&snapshot(&simulator));
    // The third word is the number of subsamples.
    let mut words = good.clone();
    words[2] = 9;
    assert_eq!(refused(&mut simulator, &forged(&words)), "options.subsamples = 9: must be from 1 to 5");
    words[0] = 7;
    assert_eq!(
        refused(&mut simulator, &forged(&words)),
        "snapshot: Options.frame = 7: is not a value that this release knows"
    );
    let mut longer = good.clone();
    longer.extend([0, 1, 0, 0, 0, 0, 0, 0]);
    assert_eq!(
        refused(&mut simulator, &forged(&longer)),
        "snapshot bytes left over = 3: must be 0: the snapshot has bytes after its end"
    );
    let error = refused(&mut simulator, &forged(&good[..100]));
    assert!(error.ends_with(": the snapshot ends before it"), "{error}");
}

/// Tiny numbers, by whose squares figures are divided, are refused or give finite figures. The only sample has no other before it,
/// against which its interval could be checked.
#[test]
fn tiny_numbers_are_refused_or_give_finite_figures() {
    let mut simulator = Simulator::new(&Options { covariance: true, ..Options::default() }).unwrap();
    let mounting = MountingParameters { lever_arm_m: Vector3::repeat(0.1), ..MountingParameters::default() };
    simulator.set_mounting(&mounting).unwrap();
    simulator.push_sample(&resting_sample(0.0)).unwrap();
    let words = words(&snapshot(&simulator));
    for (at, tiny) in (0..words.len()).flat_map(|at| [5e-323_f64, 1e-200].map(|tiny| (at, tiny))) {
        let mut altered = words.clone();
        altered[at] = tiny.to_bits();
        if simulator.load_snapshot(&forged(&altered)).is_ok() {
            finite(&simulator, || format!("word {at} of {tiny}"));
        }
    }
}
