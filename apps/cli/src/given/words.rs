//! Errors of the library about a sample, in the words of scenes and logs.

use sins::log::column_of;
use sins::units::DEG;
use sins::{Error, Rule};

/// The sentence of `error`. The unit of a log's angle is not known here: angles are in degrees.
pub fn of_sample(error: &Error) -> String {
    let angle = error.field.strip_prefix("sample.").and_then(|field| field.strip_suffix("_rad"));
    if let Some(angle) = angle
        && let Error { value: Some(value), rule: Rule::Between(low, high), .. } = error.in_unit(DEG)
    {
        return format!("{angle} = {value} deg: must be from {low} to {high} deg");
    }
    let text = match column_of(error) {
        // Only a temperature can be missing. The scene can have it too.
        Some(_) if error.value.is_none() => error.sentence_about("flight.temperature_c"),
        Some(field) => Error { field, index: None, ..*error }.to_string(),
        None => error.to_string(),
    };
    text.replace("sample.", "")
}
