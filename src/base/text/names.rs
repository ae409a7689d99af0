//! Words of a user in messages: the word that was probably meant, and the text as it can be quoted.

/// The word of `words` that is nearest to `word`, if it is near enough to be meant: one that begins with it, up to an underscore, as a key
/// without its unit; else one that begins with it; else one with a third of its letters wrong.
pub fn nearest<'w>(word: &str, words: impl Iterator<Item = &'w str>) -> Option<&'w str> {
    // Longer than any word of the library: the distance takes the product of both lengths.
    const LONGEST: usize = 64;
    // A shorter beginning is that of many words.
    const SHORTEST_BEGIN: usize = 3;
    if word.len() > LONGEST {
        return None;
    }
    let words: Vec<&str> = words.collect();
    let letters = word.chars().count();
    let is_whole = |other: &&str| other.strip_prefix(word).is_some_and(|rest| rest.starts_with('_'));
    let begins = |other: &&str| letters >= SHORTEST_BEGIN && other.starts_with(word);
    let shortest = |is_meant: &dyn Fn(&&str) -> bool| {
        words.iter().copied().filter(|other| is_meant(other)).min_by_key(|other| other.len())
    };
    if let Some(meant) = shortest(&is_whole).or_else(|| shortest(&begins)) {
        return Some(meant);
    }
    let most = ((1 + letters) / 3).max(1);
    words
        .into_iter()
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
pub fn unknown(what: &str, name: &str, near: Option<&str>) -> String {
    let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
    format!("no such {what}: {}{near}", excerpt(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_beginning_of_a_name_means_the_shortest_that_begins_with_it() {
        let names = ["bias_sigma_deg_h", "bias_deg_h", "bias_rad_s", "baud", "range_deg_s", "axis"];
        for (word, meant) in [
            ("bias", Some("bias_deg_h")),
            ("bias_sigma", Some("bias_sigma_deg_h")),
            ("bais_deg_h", Some("bias_deg_h")),
            ("range", Some("range_deg_s")),
            ("ran", Some("range_deg_s")),
            ("ra", None),
            ("at_s", None),
            ("noise", None),
        ] {
            assert_eq!(nearest(word, names.into_iter()), meant, "{word}");
        }
    }
}
