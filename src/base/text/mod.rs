//! Texts of a user, in messages and in files: faults, names, numbers.

mod fault;
mod names;
mod nesting;
mod toml;

pub use fault::{About, Fault};
pub use names::{excerpt, listed, nearest, unknown};
pub use nesting::{MAX_NESTING, too_deep};
pub use toml::{number_text, text_in_quotes};

/// Largest size of a text in a scene [bytes].
pub const MAX_TEXT_VALUE: usize = 4096;
