//! The master's logger.

use std::ffi::{CString, c_char, c_int, c_void};

/// Categories of messages, which the master can switch one by one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Category {
    /// Refused calls, with the reason.
    Error,
    /// Notes for the user: a gap, a large turn or a doubt in the truth.
    Warning,
}

impl Category {
    pub const ALL: [Self; 2] = [Self::Error, Self::Warning];

    pub fn name(self) -> &'static str {
        match self {
            Self::Error => "logStatusError",
            Self::Warning => "logStatusWarning",
        }
    }

    pub fn doc(self) -> &'static str {
        match self {
            Self::Error => "a call that was rejected: field, value and limit",
            Self::Warning => {
                "a gap in the truth, a turn in one step that is too large to integrate, or a truth that is doubtful: its units, its noise, its steps"
            }
        }
    }
}

/// Type of the master's function for messages.
pub type LoggerFunction =
    unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char, ...);

/// Sends messages to the master. No message is for debugging: all are sent until the master switches them off.
pub struct Logger {
    function: Option<LoggerFunction>,
    environment: *mut c_void,
    name: CString,
    is_on: [bool; Category::ALL.len()],
}

impl Logger {
    /// # Safety
    /// `function` accepts `environment` during the life of this logger.
    pub unsafe fn new(function: Option<LoggerFunction>, environment: *mut c_void, name: CString) -> Self {
        Self { function, environment, name, is_on: [true; Category::ALL.len()] }
    }

    /// Switches categories on or off; all categories if `names` is empty. `Err` if a name is unknown.
    pub fn switch(&mut self, names: &[&str], is_on: bool) -> Result<(), String> {
        let is_known = |name: &&&str| Category::ALL.iter().all(|known| known.name() != **name);
        if let Some(unknown) = names.iter().find(is_known) {
            return Err(format!("there is no category \"{unknown}\" of messages"));
        }
        for (category, switch) in Category::ALL.iter().zip(&mut self.is_on) {
            if names.is_empty() || names.contains(&category.name()) {
                *switch = is_on;
            }
        }
        Ok(())
    }

    /// Sends `text` to the master; the text explains `status`.
    pub fn say(&self, category: Category, status: c_int, text: &str) {
        let Some(function) = self.function else { return };
        let index = Category::ALL.iter().position(|known| *known == category);
        if !index.is_some_and(|index| self.is_on[index]) {
            return;
        }
        // The text is itself the format and has no arguments, because not every master handles arguments.
        let text = CString::new(text.replace('%', "%%").replace('\0', " "));
        let (Ok(text), Ok(category)) = (text, CString::new(category.name())) else { return };
        // SAFETY: by the promise of `new`.
        unsafe {
            function(self.environment, self.name.as_ptr(), status, category.as_ptr(), text.as_ptr());
        }
    }
}
