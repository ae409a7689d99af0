//! The script of pages with drawings: cursor, enlarged parts, files of a drawing. Without it a page is complete.

use minifier::js;

const SCRIPT: &str = include_str!("page.js");

/// Names of the script's own things that have one letter in a page: the first A, the second B and so on. None is a property, or a
/// word in a text.
const NAMES: [&str; 17] = [
    "clamp", "drag", "ends", "extent", "first", "found", "group", "here", "isList", "isLone", "isMap",
    "marks", "middle", "parent", "sheet", "wide", "words",
];

/// The script without comments and spaces, with short names.
pub fn script() -> String {
    // The source is a constant: what the minifier cannot read, a browser can.
    let script = js::minify(SCRIPT).map_or_else(|_| SCRIPT.to_owned(), |short| short.to_string());
    words(&script).map(short).collect()
}

/// The names, and what stands between them, letter by letter.
fn words(script: &str) -> impl Iterator<Item = &str> {
    let is_of_name = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    let mut rest = script;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let end = rest.find(|letter| !is_of_name(letter)).filter(|end| *end > 0);
        let end = end.unwrap_or(if is_of_name(first) { rest.len() } else { first.len_utf8() });
        let (word, behind) = rest.split_at(end);
        rest = behind;
        Some(word)
    })
}

fn short(word: &str) -> &str {
    const LETTERS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    match NAMES.iter().position(|name| *name == word) {
        Some(at) => &LETTERS[at..=at],
        None if word == "const" => "let",
        None => word,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest size of the script in a page [bytes].
    const MOST: usize = 8192;

    /// A short name must be free, and a long one must not be a property, or a word in a text.
    #[test]
    fn names_that_are_shortened_are_the_scripts_own() {
        let code: String = SCRIPT.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        let words: Vec<&str> = words(&code).collect();
        for k in (0..words.len()).filter(|k| NAMES.contains(&words[*k])) {
            let near = words[k.saturating_sub(8)..(k + 8).min(words.len())].concat();
            let is_property = words[k - 1] == "." && words[k - 2] != ".";
            assert!(
                !is_property && !["'", "-", "`", "#"].contains(&words[k - 1]) && words[k + 1] != "'",
                "{near}"
            );
            let is_key = words[k + 1] == ":" && ["{", ","].contains(&words[k - 2]);
            assert!(!is_key, "{near}");
        }
        assert!(NAMES.iter().all(|name| words.contains(name)));
        let is_letter = |word: &&&str| word.len() == 1 && word.starts_with(|w: char| w.is_ascii_uppercase());
        // Letters of the paths of drawings.
        assert!(words.iter().filter(is_letter).all(|word| *word == "M"));
    }

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
