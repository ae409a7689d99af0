//! Sequences of random calls at full speed. See `src/lib.rs`.
//!
//!     random_calls [--calls N] [--seconds S] [--first SEED] [--folder FOLDER] [FILE...]
//!
//! Runs one sequence for each seed from SEED (default 0). Seed k always makes the same calls, so that processes can share a
//! range. Each kind of failure is reported once, with its seed and the fewest calls that show it, and saved in FOLDER
//! (default .). If the process dies, random_calls-SEED.seed in FOLDER has the current seed. FILE: prints the calls of a
//! saved sequence.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};
use std::{fs, io};

use sins_fuzz::minimal::{catch_failures, failure, kind, minimal};
use sins_fuzz::{Random, Record, records, trace};

/// Largest number of records of a sequence.
const LONGEST: u64 = 1024;

/// Time between two lines of progress.
const REPORT: Duration = Duration::from_secs(30);

fn sequence(seed: u64) -> Vec<Record> {
    let mut random = Random(Random(seed).word());
    let count = 1 + random.word() % LONGEST;
    (0..count).map(|_| random.record()).collect()
}

struct Arguments {
    calls: u64,
    seconds: f64,
    first: u64,
    folder: PathBuf,
    files: Vec<PathBuf>,
}

fn arguments() -> Result<Arguments, String> {
    let mut arguments =
        Arguments { calls: u64::MAX, seconds: 20.0, first: 0, folder: ".".into(), files: Vec::new() };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or(format!("{word} needs a value"));
        let number = |text: String| text.parse::<f64>().map_err(|error| format!("{text}: {error}"));
        match word.as_str() {
            "--calls" => (arguments.calls, arguments.seconds) = (number(value()?)? as u64, f64::INFINITY),
            "--seconds" => arguments.seconds = number(value()?)?,
            "--first" => arguments.first = number(value()?)? as u64,
            "--folder" => arguments.folder = value()?.into(),
            _ => arguments.files.push(word.into()),
        }
    }
    Ok(arguments)
}

/// Prints the calls of a sequence and its failure.
fn tell(sequence: &[Record]) -> Option<String> {
    trace::tell(true);
    let failure = failure(sequence);
    trace::tell(false);
    println!("{}", failure.as_deref().unwrap_or("no failure"));
    failure
}

fn run(arguments: &Arguments) -> io::Result<bool> {
    fs::create_dir_all(&arguments.folder)?;
    let at_work = arguments.folder.join(format!("random_calls-{}.seed", arguments.first));
    let start = Instant::now();
    let (mut calls, mut seed, mut reported) = (0, arguments.first, start);
    let mut kinds = BTreeMap::<String, u64>::new();
    let mut is_last = false;
    while !is_last {
        fs::write(&at_work, format!("{seed}\n"))?;
        let sequence = sequence(seed);
        if let Some(failure) = failure(&sequence) {
            let kind = kind(&failure);
            let count = kinds.entry(kind.clone()).or_default();
            *count += 1;
            if *count == 1 {
                let file = arguments.folder.join(format!("random_calls-{seed}"));
                println!("seed {seed}: {failure}; the fewest calls, kept as {}:", file.display());
                let fewest = minimal(sequence.clone(), &kind);
                fs::write(&file, fewest.as_flattened())?;
                tell(&fewest);
            }
        }
        (calls, seed) = (calls + sequence.len() as u64, seed + 1);
        let elapsed = start.elapsed();
        is_last = calls >= arguments.calls || elapsed.as_secs_f64() >= arguments.seconds;
        if is_last || reported.elapsed() > REPORT {
            reported = Instant::now();
            println!(
                "{calls} calls ({} of functions) of seeds {} to {} in {:.0} s, {:.0} a second; failures: {kinds:?}",
                trace::calls(),
                arguments.first,
                seed - 1,
                elapsed.as_secs_f64(),
                calls as f64 / elapsed.as_secs_f64()
            );
        }
    }
    fs::remove_file(at_work)?;
    Ok(kinds.is_empty())
}

fn main() -> ExitCode {
    catch_failures();
    let outcome = arguments().and_then(|arguments| {
        if arguments.files.is_empty() {
            return run(&arguments).map_err(|error| error.to_string());
        }
        let mut is_clean = true;
        for file in &arguments.files {
            let bytes = fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?;
            is_clean &= tell(&records(&bytes)).is_none();
        }
        Ok(is_clean)
    });
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
