//! Numbers and texts as TOML writes them.

use crate::base::records;

/// The shortest text that reads back to the bit; TOML wants digits on both sides of a point.
pub fn number_text(number: f64) -> String {
    if number == 0.0 && number.is_sign_negative() { "-0.0".to_owned() } else { records::number(number) }
}

/// A text as TOML writes it.
pub fn text_in_quotes(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            _ if letter.is_control() => quoted.push_str(&format!("\\u{:04X}", letter as u32)),
            _ => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}
