//! What the program says: results on standard output, everything else on standard error.

use std::io::{ErrorKind, Write};

use crate::failure::{Failure, Kind};

/// `text` without what would steer a terminal, or hide in it: control characters but line feeds and tabs, and those that turn the
/// direction of writing.
pub fn printable(text: &str) -> String {
    let is_turning = |letter: char| matches!(letter, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let is_steering = |letter: char| letter.is_control() && letter != '\n' && letter != '\t';
    text.chars().map(|letter| if is_steering(letter) || is_turning(letter) { '?' } else { letter }).collect()
}

/// Writes a result on standard output. That its reader has gone (`sins keys | head`) is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut output = std::io::stdout().lock();
    match output.write_all(printable(text).as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::of_kind(Kind::Failed, format!("standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Says on standard error what is being done; nobody reading it is no failure.
pub fn say(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{}", printable(text));
}
