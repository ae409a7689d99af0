//! Prints the calls of a sequence.

use std::cell::{Cell, RefCell};

use sins::abi::sins_status;

thread_local! {
    static TELLING: Cell<bool> = const { Cell::new(false) };
    static CALLS: Cell<u64> = const { Cell::new(0) };
    static FORGED: Cell<bool> = const { Cell::new(false) };
    static NOTES: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// Whether calls are printed from now on.
pub fn tell(telling: bool) {
    TELLING.set(telling);
    NOTES.take();
}

/// A sequence begins.
pub fn begin() {
    FORGED.set(false);
    NOTES.take();
}

/// A forged snapshot was accepted.
pub fn forge() {
    FORGED.set(true);
}

/// Number of calls of interface functions on this thread.
pub fn calls() -> u64 {
    CALLS.get()
}

/// Additional information about a failure.
pub fn circumstances() -> &'static str {
    if FORGED.get() { ", after a forged snapshot" } else { "" }
}

/// Adds an argument of the next call.
pub fn note(text: impl FnOnce() -> String) {
    if TELLING.get() {
        NOTES.with_borrow_mut(|notes| notes.push(text()));
    }
}

/// Counts a call, and prints it if calls are printed.
pub fn called(function: &str, status: sins_status) {
    CALLS.set(CALLS.get() + 1);
    if TELLING.get() {
        println!("{function}({}) = {status}", NOTES.take().join(", "));
    }
}

/// A struct as text without the fields that are 0.
pub fn without_zeros(debug: &str) -> String {
    let (name, fields) = debug.split_once(" { ").unwrap_or((debug, ""));
    let mut kept = Vec::new();
    let (mut start, mut depth) = (0, 0);
    let fields = fields.trim_end_matches(" }");
    for (at, byte) in fields.bytes().enumerate().chain([(fields.len(), b',')]) {
        depth += i32::from(byte == b'[') - i32::from(byte == b']');
        if byte == b',' && depth == 0 {
            let field = fields[start..at].trim();
            let value = field.split_once(": ").map_or("", |(_, value)| value);
            if !field.starts_with("struct_size") && value.contains(|c| !"0., []".contains(c)) {
                kept.push(field);
            }
            start = at + 1;
        }
    }
    format!("{name} {{ {} }}", kept.join(", "))
}

/// Calls a function of the interface and asserts that its status is one of the header and not SINS_ERROR_INTERNAL.
#[macro_export]
macro_rules! call {
    ($function:ident($($argument:expr),* $(,)?)) => {{
        // SAFETY: every pointer has as many bytes as its struct says; handles may be anything.
        #[allow(unused_unsafe)]
        let status = unsafe { $function($($argument),*) };
        $crate::trace::called(stringify!($function), status);
        assert!((-13..=4).contains(&status), "{}: status {status}", stringify!($function));
        status
    }};
}
