//! Any bytes as a flight log, through the C interface, by libFuzzer. See `src/texts.rs`.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| sins_fuzz::check_log(bytes));
