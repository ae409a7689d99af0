//! Errors of the library about a sample, in the words of scenes and logs.

use sins::{Error, Rule};

/// Words of the interface, and those of a scene or of a log's columns.
const WORDS: [(&str, &str); 13] = [
    (
        "sample.temperature_c: is needed, with SINS_SAMPLE_TEMPERATURE in sample.flags,",
        "flight.temperature_c: is needed",
    ),
    ("max_gap_s", "options.max_gap_s"),
    ("max_acceleration_m_s2", "options.max_acceleration_m_s2"),
    ("velocity_enu_m_s[0]", "velocity_east_m_s"),
    ("velocity_enu_m_s[1]", "velocity_north_m_s"),
    ("velocity_enu_m_s[2]", "velocity_up_m_s"),
    ("angular_rate_rad_s[0]", "rate_x_rad_s"),
    ("angular_rate_rad_s[1]", "rate_y_rad_s"),
    ("angular_rate_rad_s[2]", "rate_z_rad_s"),
    ("specific_force_m_s2[0]", "force_x_m_s2"),
    ("specific_force_m_s2[1]", "force_y_m_s2"),
    ("specific_force_m_s2[2]", "force_z_m_s2"),
    ("sample.", ""),
];

/// The sentence of `error`. The unit of a log's angle is not known here: angles are in degrees.
pub fn of_sample(error: &Error) -> String {
    let angle = error.field.strip_prefix("sample.").and_then(|field| field.strip_suffix("_rad"));
    if let (Some(angle), Some(value), Rule::Between(low, high)) = (angle, error.value, error.rule) {
        let [value, low, high] =
            [value.as_f64(), low, high].map(|angle| crate::units::six_digits(angle.to_degrees()));
        return format!("{angle} = {value} deg: must be from {low} to {high} deg");
    }
    WORDS.iter().fold(error.to_string(), |text, (interface, own)| text.replace(interface, own))
}
