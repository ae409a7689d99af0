//! The shortest sequence that still fails in the same way.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};

use crate::{RECORD, Record, run, trace};

thread_local! {
    static MESSAGE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Stores the message of a panic instead of printing it. Must be called before any other function of the library.
pub fn catch_failures() {
    set_hook(Box::new(|info| {
        let place =
            info.location().map_or(String::new(), |place| format!("{}:{}", place.file(), place.line()));
        let words = info.payload_as_str().unwrap_or_default();
        MESSAGE.set(format!("{words}{} ({place})", trace::circumstances()));
    }));
}

/// The message of the failure of a sequence, if it fails.
pub fn failure(records: &[Record]) -> Option<String> {
    catch_unwind(AssertUnwindSafe(|| run(records))).is_err().then(|| MESSAGE.take())
}

/// The kind of a failure: its message without the text in square brackets.
pub fn kind(failure: &str) -> String {
    let mut depth = 0;
    failure
        .chars()
        .filter(|c| {
            let is_outside = depth == 0;
            depth += i32::from(*c == '[') - i32::from(*c == ']');
            is_outside && depth == 0
        })
        .collect()
}

/// Removes records and then sets bytes to 0, if the sequence still fails with the same kind.
pub fn minimal(mut records: Vec<Record>, wanted: &str) -> Vec<Record> {
    let fails = |records: &[Record]| failure(records).is_some_and(|failure| kind(&failure) == wanted);
    let mut size = records.len().div_ceil(2);
    while size > 0 {
        let mut at = 0;
        while at < records.len() {
            let mut fewer = records.clone();
            fewer.drain(at..records.len().min(at + size));
            if fails(&fewer) {
                records = fewer;
            } else {
                at += size;
            }
        }
        size = if size == 1 { 0 } else { size.div_ceil(2) };
    }
    for index in 0..records.len() {
        for byte in (0..RECORD).rev() {
            let kept = std::mem::take(&mut records[index][byte]);
            if kept != 0 && !fails(&records) {
                records[index][byte] = kept;
            }
        }
    }
    records
}
