//! Sequences of calls, by libFuzzer. See `src/lib.rs`.
#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use sins_fuzz::{RECORD, Random, records, run};

/// Largest number of calls of a sequence.
const CALLS: usize = 256;

fuzz_target!(|bytes: &[u8]| {
    let mut sequence = records(bytes);
    sequence.truncate(CALLS);
    run(&sequence);
});

// Whole calls are inserted, removed, duplicated and moved. libFuzzer mutates the bytes within a call.
fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    let mut random = Random(u64::from(seed));
    let mut sequence = records(&data[..size]);
    let most = (max_size / RECORD).min(CALLS);
    let place = |word: u64, count: usize| word as usize % count.max(1);
    let count = sequence.len();
    let (kind, at, from) = (random.word() % 6, place(random.word(), count), place(random.word(), count));
    match kind {
        0 if count < most => sequence.insert(place(random.word(), count + 1), random.record()),
        1 if count > 1 => drop(sequence.remove(at)),
        2 if count > 0 && count < most => sequence.insert(at, sequence[from]),
        3 if count > 1 => sequence.swap(at, from),
        _ if count == 0 => sequence.push(random.record()),
        _ => {
            fuzzer_mutate(&mut sequence[at], RECORD, RECORD);
        }
    }
    sequence.truncate(most);
    let bytes = sequence.as_flattened();
    data[..bytes.len()].copy_from_slice(bytes);
    bytes.len()
});
