//! Values of a scene's text, and how they get into a draft.

use toml::de::{DeInteger, DeTable, DeValue};

use super::Scene;
use super::column::column_of;
use super::draft::Draft;
use super::key::{Key, Target};
use super::limits::{Limits, limits};
use crate::base::error::{Error, Rule};
use crate::base::parameter::Shape;
use crate::base::text::too_deep;
use crate::base::text::{MAX_TEXT_VALUE, excerpt, nearest, number_text};
use crate::log::LogColumn;

/// The value of a key.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Text(String),
    Flag(bool),
    /// A whole number with all its digits; also a number.
    Whole(i128),
    Number(f64),
    Numbers(Vec<f64>),
    /// Parts with their names, in braces.
    Table(Vec<(String, Value)>),
    /// A value that no key takes: what it is, or the number beyond all numbers as it was written.
    Other(String),
}

impl Value {
    pub fn of(value: &DeValue<'_>) -> Self {
        match value {
            DeValue::String(text) => Self::Text(text.to_string()),
            DeValue::Boolean(flag) => Self::Flag(*flag),
            DeValue::Integer(integer) => i128::from_str_radix(integer.as_str(), integer.radix())
                .map_or_else(|_| Self::of_number(value, integer.as_str()), Self::Whole),
            DeValue::Float(float) => Self::of_number(value, float.as_str()),
            DeValue::Array(array) => {
                let numbers = array.iter().map(|element| finite(number(element.get_ref()))).collect();
                let numbers: Option<Vec<f64>> = numbers;
                numbers.map_or_else(
                    || Self::Other("an array with elements that are not numbers".to_owned()),
                    Self::Numbers,
                )
            }
            DeValue::Datetime(_) => Self::Other("a date".to_owned()),
            DeValue::Table(table) => {
                let part = |(name, value): (&toml::Spanned<_>, &toml::Spanned<DeValue<'_>>)| {
                    let name: &std::borrow::Cow<'_, str> = name.get_ref();
                    (name.to_string(), Self::of(value.get_ref()))
                };
                Self::Table(table.iter().map(part).collect())
            }
        }
    }

    fn of_number(value: &DeValue<'_>, written: &str) -> Self {
        finite(number(value)).map_or_else(|| Self::Other(excerpt(written)), Self::Number)
    }

    /// The value of a setting outside of the text: a value of TOML, or else a text without quotes.
    pub fn of_setting(text: &str) -> Self {
        let line = format!("value = {text}");
        if too_deep(&line).is_some() {
            return Self::Text(text.to_owned());
        }
        let (table, errors) = DeTable::parse_recoverable(&line);
        let table = table.get_ref();
        match table.get("value") {
            Some(value) if errors.is_empty() && table.len() == 1 => Self::of(value.get_ref()),
            _ => Self::Text(text.to_owned()),
        }
    }

    /// The value as a message can quote it.
    fn shown(&self) -> String {
        match self {
            Self::Text(text) => format!("\"{}\"", excerpt(text)),
            Self::Flag(flag) => flag.to_string(),
            Self::Whole(whole) => whole.to_string(),
            // With its point: it is no whole number.
            Self::Number(number) if number.fract() == 0.0 && number.abs() < 1e7 => format!("{number:.1}"),
            Self::Number(number) => number_text(*number),
            Self::Numbers(numbers) => format!("an array of {}", numbers.len()),
            Self::Table(_) => "a table".to_owned(),
            Self::Other(what) => what.clone(),
        }
    }

    /// What a message adds about a number with a decimal comma.
    fn point(&self) -> &'static str {
        match self {
            Self::Text(text) if text.replacen(',', ".", 1).parse::<f64>().is_ok() => {
                "; decimals follow a point"
            }
            _ => "",
        }
    }

    /// The value as a single number.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Whole(whole) => Some(*whole as f64),
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }

    fn numbers(&self) -> Option<Vec<f64>> {
        match self {
            Self::Numbers(numbers) => Some(numbers.clone()),
            _ => self.number().map(|number| vec![number]),
        }
    }
}

/// The number in a value; NaN if the value is not a number.
fn number(value: &DeValue<'_>) -> f64 {
    match value {
        DeValue::Integer(integer) => whole_number(integer),
        DeValue::Float(float) => float.as_str().parse().unwrap_or(f64::NAN),
        _ => f64::NAN,
    }
}

fn whole_number(integer: &DeInteger<'_>) -> f64 {
    if integer.radix() == 10 {
        return integer.as_str().parse().unwrap_or(f64::NAN);
    }
    i128::from_str_radix(integer.as_str(), integer.radix()).map_or(f64::NAN, |whole| whole as f64)
}

fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}

/// Puts `value` where `key` says, in the key's unit or in SI; on an error what was expected.
pub fn put(draft: &mut Draft, key: &Key, in_si: bool, value: &Value) -> Result<(), String> {
    let refused = |expected: String| format!("{} = {}: expected {expected}", key.path(), value.shown());
    match key.target {
        Target::Numbers { shape, unit, place, .. } => {
            let numbers = value.numbers().and_then(|numbers| elements(shape, value, &numbers));
            let Some(numbers) = numbers else {
                return Err(refused(shape.expected().to_owned() + &unit.behind() + value.point()));
            };
            let unit_si = if in_si { 1.0 } else { unit.si };
            let in_si: Vec<f64> = numbers.iter().map(|number| number * unit_si).collect();
            if let Some(index) = in_si.iter().position(|number| number.is_infinite()) {
                return Err(beyond_all(key, numbers[index]));
            }
            place.of(draft).zip(in_si).for_each(|(to, number)| *to = number);
        }
        Target::Choice { words, set, .. } => {
            let found = match value {
                Value::Text(text) => words.iter().position(|word| word == text),
                _ => None,
            };
            let Some(index) = found else {
                let near = match value {
                    Value::Text(text) => nearest(text, words.iter().copied()),
                    _ => None,
                };
                let near = near.map_or(String::new(), |near| format!("; did you mean {near}?"));
                return Err(refused(words.join(", ") + &near));
            };
            set(draft, index);
        }
        Target::Count { set, .. } => {
            let whole = if let Value::Whole(whole) = value { u64::try_from(*whole).ok() } else { None };
            let Some(whole) = whole else {
                let (low, high) =
                    limits(key).map_or((0, u64::MAX), |limits| (limits.low as u64, limits.high as u64));
                return Err(refused(format!("a whole number from {low} to {high}")));
            };
            set(draft, whole);
        }
        Target::Text { example, place } => match value {
            Value::Text(text) if text.chars().any(char::is_control) => {
                return Err(format!("{}: must not have control characters", key.path()));
            }
            Value::Text(text) if text.len() > MAX_TEXT_VALUE => {
                return Err(format!(
                    "{}: {} bytes: a text has at most {MAX_TEXT_VALUE}",
                    key.path(),
                    text.len()
                ));
            }
            Value::Text(text) if !text.is_empty() => place(draft).clone_from(text),
            _ => return Err(refused(format!("a text, as \"{example}\""))),
        },
        Target::Flag { set, .. } => {
            let Value::Flag(flag) = value else { return Err(refused("true or false".to_owned())) };
            set(draft, *flag);
        }
        Target::Column(quantity) => {
            draft.columns_mut(key.section)[quantity] = column_of(value, key, quantity)?;
        }
    }
    Ok(())
}

/// Puts one number of several where `key` says; an empty text puts 0.
pub fn put_element(
    draft: &mut Draft,
    key: &Key,
    in_si: bool,
    element: usize,
    value: &Value,
) -> Result<(), String> {
    let Target::Numbers { unit, place, .. } = key.target else { return Ok(()) };
    let number = match value {
        Value::Whole(whole) => *whole as f64,
        Value::Number(number) => *number,
        Value::Text(text) if text.is_empty() => 0.0,
        _ => {
            let (path, unit) = (key.path(), unit.behind());
            return Err(format!(
                "{path}[{element}] = {}: expected a number{unit}{}",
                value.shown(),
                value.point()
            ));
        }
    };
    let number_si = number * if in_si { 1.0 } else { unit.si };
    if number_si.is_infinite() {
        return Err(beyond_all(key, number));
    }
    if let Some(to) = place.of(draft).nth(element) {
        *to = number_si;
    }
    Ok(())
}

/// Puts the default in the place of the value of a key. Returns whether the value was another one.
pub fn put_back(draft: &mut Draft, key: &Key) -> bool {
    let mut default = Draft::from(&Scene::default());
    match key.target {
        Target::Numbers { place, .. } => {
            let mut has_changed = false;
            for (number, default) in place.of(draft).zip(place.of(&mut default)) {
                has_changed |= number.to_bits() != default.to_bits();
                *number = *default;
            }
            has_changed
        }
        Target::Count { get, set, .. } => {
            let has_changed = get(draft) != get(&default);
            set(draft, get(&default));
            has_changed
        }
        Target::Column(quantity) => {
            let column = core::mem::take(&mut draft.columns_mut(key.section)[quantity]);
            column != LogColumn::default()
        }
        _ => false,
    }
}

/// What is wrong with a number that is infinite in SI.
fn beyond_all(key: &Key, number: f64) -> String {
    let rule = match limits(key) {
        Some(Limits { low, high, .. }) => Rule::Between(low, high),
        None => Rule::Finite,
    };
    key.sentence_of(&Error::invalid("", number, rule))
}

/// All numbers of a shape, where a single one may stand for several.
fn elements(shape: Shape, value: &Value, numbers: &[f64]) -> Option<Vec<f64>> {
    if let Value::Numbers(_) = value {
        // A number alone is written without brackets.
        return (shape != Shape::Number && numbers.len() == shape.count()).then(|| numbers.to_vec());
    }
    let [single] = numbers else { return None };
    (0..shape.count()).map(|index| Some(if shape.single_sets(index)? { *single } else { 0.0 })).collect()
}
