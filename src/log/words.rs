//! Words of the names of columns, and the units among them.

use super::quantity::{Dimension, unit_of};

/// Spellings of units.
const SPELLINGS: &[(&str, &str)] = &[
    ("s", "s"),
    ("sec", "s"),
    ("secs", "s"),
    ("seconds", "s"),
    ("ms", "ms"),
    ("msec", "ms"),
    ("millisecond", "ms"),
    ("milliseconds", "ms"),
    ("us", "us"),
    ("usec", "us"),
    ("microseconds", "us"),
    ("ns", "ns"),
    ("nsec", "ns"),
    ("nanoseconds", "ns"),
    ("min", "min"),
    ("mins", "min"),
    ("minute", "min"),
    ("minutes", "min"),
    ("hr", "h"),
    ("hrs", "h"),
    ("hour", "h"),
    ("hours", "h"),
    ("day", "d"),
    ("days", "d"),
    ("deg", "deg"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("rad", "rad"),
    ("radians", "rad"),
    ("m", "m"),
    ("meter", "m"),
    ("meters", "m"),
    ("metres", "m"),
    ("ft", "ft"),
    ("feet", "ft"),
    ("mm", "mm"),
    ("cm", "cm"),
    ("km", "km"),
    ("cms", "cm/s"),
    ("cm s", "cm/s"),
    ("mms", "mm/s"),
    ("mm s", "mm/s"),
    ("rad s", "rad/s"),
    ("deg s", "deg/s"),
    ("dps", "deg/s"),
    ("m s2", "m/s2"),
    ("g", "g"),
    ("mps", "m/s"),
    ("m s", "m/s"),
    ("m sec", "m/s"),
    ("kt", "kt"),
    ("kts", "kt"),
    ("kn", "kt"),
    ("knot", "kt"),
    ("knots", "kt"),
    ("fps", "ft/s"),
    ("ft s", "ft/s"),
    ("fpm", "ft/min"),
    ("ft min", "ft/min"),
    ("mph", "mph"),
    ("kmh", "km/h"),
    ("km h", "km/h"),
    ("kph", "km/h"),
    ("c", "deg C"),
    ("wgs84", ""),
    ("wgs84 deg", "deg"),
    ("wgs84 ft", "ft"),
    ("wgs84 m", "m"),
    ("deg c", "deg C"),
    ("degc", "deg C"),
];

/// Spellings that are units only in brackets, or alone in a cell.
const LETTERS: &[(&str, &str)] = &[("h", "h"), ("d", "d")];

/// Words behind the unit of a height: what it is above.
const ABOVE: [&str; 4] = ["msl", "amsl", "asl", "agl"];

/// The unit in a name, and its words without it; empty: there is none. It stands at the end, before the word that says what a height is
/// above, or as the first of several words in brackets.
pub fn unit_and_words(name: &str) -> (&'static str, Vec<String>) {
    let mut words = words(name);
    let above = words.pop_if(|word| ABOVE.contains(&word.as_str()));
    let count = words.len();
    let in_brackets = name.rsplit_once(['(', '[']).filter(|(_, inside)| inside.ends_with([')', ']']));
    let inside = in_brackets.map(|(before, _)| self::words(before).len());
    let at_end = [2, 1].map(|length| (count.checked_sub(length), length));
    let at_begin = [2, 1].map(|length| (inside.filter(|begin| begin + length <= count), length));
    let places = at_end.into_iter().chain(at_begin);
    let mut spelled = places.filter_map(|(begin, length)| {
        let begin = begin.filter(|begin| *begin > 0)?;
        let spelled = words[begin..begin + length].join(" ");
        let letters = if inside.is_some_and(|inside| begin >= inside) { LETTERS } else { &[] };
        let (_, known) = SPELLINGS.iter().chain(letters).find(|(spelling, _)| *spelling == spelled)?;
        Some((begin..begin + length, *known))
    });
    let unit = spelled.next().map_or("", |(place, unit)| {
        words.drain(place);
        unit
    });
    words.extend(above);
    (unit, words)
}

/// The unit of this dimension that a name states.
pub fn unit_in_name(name: &str, dimension: Dimension) -> Option<&'static str> {
    let (unit, _) = unit_and_words(name);
    let unit = if unit == "ms" && dimension == Dimension::Speed { "m/s" } else { unit };
    unit_of(dimension, unit).filter(|_| !unit.is_empty()).map(|(unit, _)| unit)
}

/// Words of a line of units that change no unit.
const BESIDE: [&str; 8] = ["msl", "amsl", "asl", "true", "wgs84", "ellipsoid", "ned", "north"];

/// Whether a line of units says nothing of a column, or a unit of this dimension and nothing else.
pub fn is_understood(cell: &str, dimension: Dimension) -> bool {
    let words = words(&cell.replace(['°', 'º'], " deg "));
    let kept: Vec<&str> = words.iter().map(String::as_str).filter(|word| !BESIDE.contains(word)).collect();
    let spelled = kept.join(" ");
    let mut units = SPELLINGS.iter().chain(LETTERS).filter(|(spelling, _)| *spelling == spelled);
    kept.is_empty() || units.any(|(_, unit)| unit_of(dimension, unit).is_some())
}

/// The unit that a cell of a line of units has; empty: one that a quantity has anyway.
pub fn unit(cell: &str) -> Option<&'static str> {
    let words = words(&cell.replace(['°', 'º'], " deg "));
    let of = |length: usize| {
        let spelled = words.get(..length)?.join(" ");
        SPELLINGS.iter().chain(LETTERS).find(|(spelling, _)| *spelling == spelled).map(|(_, unit)| *unit)
    };
    // What a height is above may stand behind its unit.
    of(words.len()).or_else(|| of(1))
}

/// The words of a name in lower case: they end at marks, where a capital follows a small letter, and before a capital with a small letter
/// behind it.
pub fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let (mut before, mut letters) = (' ', name.chars().peekable());
    while let Some(letter) = letters.next() {
        let is_small_next = letters.peek().is_some_and(|next| next.is_lowercase());
        let begins =
            letter.is_uppercase() && (before.is_lowercase() || before.is_uppercase() && is_small_next);
        if (begins || !letter.is_alphanumeric()) && words.last().is_some_and(|word| !word.is_empty()) {
            words.push(String::new());
        }
        if let (true, Some(word)) = (letter.is_alphanumeric(), words.last_mut()) {
            word.extend(letter.to_lowercase());
        }
        before = letter;
    }
    words.retain(|word| !word.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_stands_at_the_end_or_in_brackets() {
        for (name, unit) in [
            ("Altitude (ft AGL)", Some("ft")),
            ("Alt [mm above sea]", Some("mm")),
            ("My height in ft", Some("ft")),
            ("Altitude (above the sea)", None),
            ("UTC Time (hh:mm:ss)", None),
            ("Altitude", None),
        ] {
            assert_eq!(unit_in_name(name, Dimension::Length), unit, "{name}");
        }
    }
}
