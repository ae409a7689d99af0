//! Checks of numbers against the ranges of their tables.

use crate::error::{Error, Rule, check_range};
use crate::parameter::{Field, Range};

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
    let rule = match field.range {
        Range::Within(..) | Range::DistanceOf(..) => Rule::Between(low, high),
        Range::OffOr(..) => return check_off_or(field.path, value, low, high),
        Range::TimeOf(..) => Rule::NeededBy(low, high, of),
    };
    if !is_needed {
        return check_range(field.path, value, 0.0, high);
    }
    check_range(field.path, value, low, high).map_err(|error| match error.rule {
        Rule::Between(..) => Error { rule, ..error },
        _ => error,
    })
}

/// Checks that a value is 0 or within its range.
pub fn check_off_or(field: &'static str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if value == 0.0 {
        return Ok(());
    }
    check_range(field, value, low, high).map_err(|error| match error.rule {
        Rule::Between(..) => Error { rule: Rule::OffOr(low, high), ..error },
        _ => error,
    })
}
