//! Output of the program: results on standard output, everything else on standard error.

use std::ffi::OsStr;
use std::io::{ErrorKind, Write};

use crate::failure::{Failure, Kind, printable};

/// A word of a command, in quotation marks if it has other letters than those of names.
pub fn quoted(word: impl AsRef<OsStr>) -> String {
    let word = word.as_ref().to_string_lossy();
    let is_plain = |letter: char| letter.is_alphanumeric() || "-_./=:,+%@\\".contains(letter);
    if !word.is_empty() && word.chars().all(is_plain) { word.into_owned() } else { format!("\"{word}\"") }
}

/// Writes a result on standard output. A reader that has closed the pipe (`sins keys | head`) is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut output = std::io::stdout().lock();
    match output.write_all(printable(text).as_bytes()).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::of_kind(Kind::Failed, format!("standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Writes a message on standard error. A message that cannot be written is no failure.
pub fn say(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{}", printable(text));
}
