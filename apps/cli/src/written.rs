//! The files that a command has written, each with its size, and the next step.

use std::path::{Path, PathBuf};

use crate::terminal::quoted;

/// The files and, if there is one, the next step: what a command says at its end.
pub fn text(paths: &[impl AsRef<Path>], next: Option<&str>) -> String {
    let mut text = "\nwritten\n".to_owned();
    for path in paths.iter().map(AsRef::as_ref) {
        let size = std::fs::metadata(path).map_or(0, |file| file.len());
        text += &format!("  {:<50} {}\n", path.display(), size_text(size));
    }
    text + &next.map_or(String::new(), |next| format!("next: {next}\n"))
}

/// The next step after a page.
pub fn open(page: &Path) -> String {
    format!("open {} in a browser", page.display())
}

/// The next step after a flight, whose records come first.
pub fn report(paths: &[PathBuf]) -> Option<String> {
    paths.first().map(|records| format!("`sins report {}` draws the flight", quoted(records)))
}

/// A size of a file in words.
fn size_text(bytes: u64) -> String {
    match bytes {
        0..1000 => format!("{bytes} B"),
        1000..1_000_000 => format!("{:.1} kB", bytes as f64 / 1e3),
        _ => format!("{:.1} MB", bytes as f64 / 1e6),
    }
}
