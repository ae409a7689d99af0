//! The script of pages with drawings: cursor, enlarged parts, files of a drawing. Without it a page is complete.

use minifier::js;

const SCRIPT: &str = include_str!("page.js");

/// The script without comments and spaces.
pub fn script() -> String {
    // The source is a constant: what the minifier cannot read, a browser can.
    js::minify(SCRIPT).map_or_else(|_| SCRIPT.to_owned(), |short| short.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest size of the script in a page [bytes].
    const MOST: usize = 8192;

    #[test]
    fn the_script_is_short_and_ends_nowhere_else() {
        let script = script();
        assert!(script.len() <= MOST, "{} bytes", script.len());
        assert!(script.len() < SCRIPT.len() && !script.contains("</"), "it would end in the middle");
        for outside in ["http", "fetch", "import", "eval"] {
            assert!(!script.contains(outside), "{outside}");
        }
    }
}
