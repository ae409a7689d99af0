//! Checks of single values.

use super::{Error, Rule, Value};
use crate::base::units::TEMPERATURE_RANGE_C;

/// Checks that an integer is from `low` to `high`.
pub(crate) fn check_integer(
    field: &'static str,
    value: impl Into<Value>,
    low: u64,
    high: u64,
) -> Result<(), Error> {
    let value = value.into();
    let is_within = match value {
        Value::Signed(value) => u64::try_from(value).is_ok_and(|value| (low..=high).contains(&value)),
        Value::Unsigned(value) => (low..=high).contains(&value),
        Value::Word(value) => (low..=high).contains(&value.into()),
        Value::Real(_) => false,
    };
    if is_within { Ok(()) } else { Err(Error::invalid(field, value, Rule::BetweenIntegers(low, high))) }
}

/// Checks that `value` is a finite number from `low` to `high`.
#[inline]
pub(crate) fn check_range(field: &'static str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if (low..=high).contains(&value) { Ok(()) } else { Err(out_of_range(field, value, low, high)) }
}

/// Checks as [`check_range`] does, from the first to the second number of `range`.
pub(crate) fn check_within(field: &'static str, value: f64, range: (f64, f64)) -> Result<(), Error> {
    check_range(field, value, range.0, range.1)
}

#[cold]
fn out_of_range(field: &'static str, value: f64, low: f64, high: f64) -> Error {
    let rule = if value.is_finite() { Rule::Between(low, high) } else { Rule::Finite };
    Error::invalid(field, value, rule)
}

/// Checks each element of `values` as [`check_range`] does.
pub(crate) fn check_ranges(field: &'static str, values: &[f64], low: f64, high: f64) -> Result<(), Error> {
    for (index, &value) in values.iter().enumerate() {
        check_range(field, value, low, high).map_err(|error| error.at(index))?;
    }
    Ok(())
}

/// Checks a temperature [°C].
pub(crate) fn check_temperature(field: &'static str, temperature_c: f64) -> Result<(), Error> {
    check_within(field, temperature_c, TEMPERATURE_RANGE_C)
}
