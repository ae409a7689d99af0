//! Values of a draft as the text of a scene writes them.

use super::draft::Draft;
use super::key::{Key, Target};
use crate::base::parameter::Shape;
use crate::base::text::{number_text, text_in_quotes};

/// The value of `key`, or one number of it, in TOML; empty: it has none. A number that has no equal in the key's unit is the
/// nearest.
pub fn shown(draft: &mut Draft, key: &Key, in_si: bool, element: Option<usize>) -> String {
    match key.target {
        Target::Numbers { shape, unit, place, .. } => {
            let unit_si = if in_si { 1.0 } else { unit.si };
            let in_unit = |number: &mut f64| divided(*number, unit_si).unwrap_or(*number / unit_si);
            let numbers: Vec<f64> = place.of(draft).map(in_unit).collect();
            match element.and_then(|element| numbers.get(element)) {
                Some(number) => number_text(*number),
                None if numbers.iter().all(|number| number.is_nan()) => String::new(),
                None => numbers_text(shape, &numbers),
            }
        }
        Target::Text { place, .. } if place(draft).is_empty() => String::new(),
        _ => written(draft, key).0,
    }
}

/// The value of `key` in TOML, and whether it is in SI: as short as it can be, and such that it reads back to the bit.
pub fn written(draft: &mut Draft, key: &Key) -> (String, bool) {
    match key.target {
        Target::Numbers { shape, unit, place, .. } => {
            let numbers: Vec<f64> = place.of(draft).map(|number| *number).collect();
            let in_unit: Option<Vec<f64>> = numbers.iter().map(|&number| divided(number, unit.si)).collect();
            match in_unit {
                Some(in_unit) => (numbers_text(shape, &in_unit), false),
                None => (numbers_text(shape, &numbers), true),
            }
        }
        Target::Choice { words, get, .. } => (format!("\"{}\"", words[get(draft)]), false),
        Target::Count { get, .. } => (get(draft).to_string(), false),
        Target::Text { place, .. } => (text_in_quotes(place(draft)), false),
        Target::Flag { get, .. } => (get(draft).to_string(), false),
        Target::Column(quantity) => (draft.columns(key.section)[quantity].text(), false),
    }
}

/// A number that, times `unit` [SI], is `number` to the bit; with few digits, if such a number exists.
pub fn divided(number: f64, unit: f64) -> Option<f64> {
    if unit == 1.0 {
        return Some(number);
    }
    let quotient = number / unit;
    // Few digits first: such a number is probably what a person wrote.
    let short = (1..17).filter_map(|digits| format!("{quotient:.digits$e}").parse().ok());
    let near = [quotient, quotient.next_up(), quotient.next_down()];
    short.chain(near).find(|candidate: &f64| (candidate * unit).to_bits() == number.to_bits())
}

fn numbers_text(shape: Shape, numbers: &[f64]) -> String {
    let single = numbers.iter().enumerate().find(|(index, _)| shape.single_sets(*index) == Some(true));
    if let Some((_, &single)) = single {
        let fits = |(index, number): (usize, &f64)| {
            let expected = if shape.single_sets(index) == Some(true) { single } else { 0.0 };
            number.to_bits() == expected.to_bits()
        };
        if numbers.iter().enumerate().all(fits) {
            return number_text(single);
        }
    }
    let numbers: Vec<String> = numbers.iter().map(|&number| number_text(number)).collect();
    format!("[{}]", numbers.join(", "))
}
