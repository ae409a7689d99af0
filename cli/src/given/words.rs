//! Errors of the library about a sample, in the words of scenes and logs.

use sins::log::column_of;
use sins::units::DEG;
use sins::{Error, Rule};

/// Words of the interface, and those of a scene or of a log's columns.
const WORDS: [(&str, &str); 4] = [
    (
        "temperature_c: is needed, with SINS_SAMPLE_TEMPERATURE in sample.flags,",
        "flight.temperature_c: is needed",
    ),
    ("max_gap_s", "options.max_gap_s"),
    ("max_acceleration_m_s2", "options.max_acceleration_m_s2"),
    ("sample.", ""),
];

/// The sentence of `error`. The unit of a log's angle is not known here: angles are in degrees.
pub fn of_sample(error: &Error) -> String {
    let angle = error.field.strip_prefix("sample.").and_then(|field| field.strip_suffix("_rad"));
    if let Some(angle) = angle
        && let Error { value: Some(value), rule: Rule::Between(low, high), .. } = error.in_unit(DEG)
    {
        return format!("{angle} = {value} deg: must be from {low} to {high} deg");
    }
    let text = match column_of(error) {
        Some(field) => Error { field, index: None, ..*error }.to_string(),
        None => error.to_string(),
    };
    WORDS.iter().fold(text, |text, (interface, own)| text.replace(interface, own))
}
