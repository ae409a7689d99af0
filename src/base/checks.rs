//! Checks of numbers against the ranges of their tables.

use crate::base::error::{Error, Rule, check_range};
use crate::base::parameter::{Field, Range, Shape};

/// Checks a number of `field`. `of` is the field and the number of the parameter whose correlation time or distance this is.
pub fn check_value(
    field: &Field,
    value: f64,
    of: impl FnOnce(&'static str) -> (&'static str, f64),
) -> Result<(), Error> {
    let (low, high) = field.range.ends();
    let (of, is_needed) = match field.range.needed_by().map(of) {
        Some((of, sigma)) => (of, sigma != 0.0),
        None => ("", true),
    };
    match field.range {
        Range::OffOr(..) => check_off_or(field.path, value, low, high),
        Range::OrDefault(..) if value == 0.0 => Ok(()),
        Range::OrDefault(..) => {
            with_rule(check_range(field.path, value, low, high), Rule::DefaultOr(low, high))
        }
        _ if !is_needed => check_range(field.path, value, 0.0, high),
        Range::Within(..) | Range::DistanceOf(..) => check_range(field.path, value, low, high),
        Range::TimeOf(..) => {
            with_rule(check_range(field.path, value, low, high), Rule::NeededBy(low, high, of))
        }
    }
}

/// Checks the numbers of a parameter. `of` gives the field and the numbers of the named parameter, whose correlation time or distance this
/// is.
pub fn check_numbers<'n>(
    field: &Field,
    shape: Shape,
    numbers: &[f64],
    of: impl Fn(&'static str) -> (&'static str, &'n [f64]),
) -> Result<(), Error> {
    for index in 0..shape.count() {
        let value = numbers[shape.place(index)];
        let checked = match shape {
            Shape::OffDiagonal(rule) if index % 4 == 0 && value != 0.0 => {
                Err(Error::invalid(field.path, value, Rule::Sentence(rule)))
            }
            _ => check_value(field, value, |name| {
                let (sigma, numbers) = of(name);
                (sigma, numbers.get(index).copied().unwrap_or_default())
            }),
        };
        checked.map_err(|error| if shape.count() == 1 { error } else { error.at(index) })?;
    }
    Ok(())
}

/// Checks a number that is 0, which means none, or from `low` to `high`.
fn check_off_or(field: &'static str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if value == 0.0 {
        Ok(())
    } else {
        with_rule(check_range(field, value, low, high), Rule::OffOr(low, high))
    }
}

/// `rule` in place of the limits alone.
fn with_rule(checked: Result<(), Error>, rule: Rule) -> Result<(), Error> {
    checked.map_err(
        |error| if matches!(error.rule, Rule::Between(..)) { Error { rule, ..error } } else { error },
    )
}
