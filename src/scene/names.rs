//! Words of a user in messages: the word that was probably meant, and the text as it can be quoted.

/// The word of `words` that is nearest to `word`, if it is near enough to be meant.
pub fn nearest<'w>(word: &str, words: impl Iterator<Item = &'w str>) -> Option<&'w str> {
    // Longer than any word of the library: the distance takes the product of both lengths.
    const LONGEST: usize = 64;
    if word.len() > LONGEST {
        return None;
    }
    // A third of the letters may be wrong.
    let most = 1 + word.chars().count() / 3;
    words
        .filter(|other| other.len() <= LONGEST)
        .map(|other| (strsim::osa_distance(word, other), other))
        .filter(|(distance, _)| *distance <= most)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, other)| other)
}

/// A user's text as a message can quote it: short, without control characters.
pub fn excerpt(text: &str) -> String {
    const MOST: usize = 40;
    let printable = |letter: char| if letter.is_control() { '?' } else { letter };
    let mut short: String = text.chars().take(MOST).map(printable).collect();
    if text.chars().nth(MOST).is_some() {
        short.push_str("...");
    }
    short
}

/// Names of a user, as a message can list them.
pub fn listed<'w>(names: impl Iterator<Item = &'w str>) -> String {
    const MOST: usize = 12;
    let mut names = names.map(excerpt);
    let mut list: Vec<String> = names.by_ref().take(MOST).collect();
    if names.next().is_some() {
        list.push("...".to_owned());
    }
    list.join(", ")
}

/// The sentence about a name that there is not, and the `near`est that there is.
pub(super) fn unknown(what: &str, name: &str, near: Option<&str>) -> String {
    let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
    format!("no such {what}: {}{near}", excerpt(name))
}
