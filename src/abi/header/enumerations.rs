//! Enumerations of the header, from the constants of `src/abi`.
//!
//! `pub type sins_frame = i32;` declares one, `pub const SINS_FRAME_EARTH_FIXED: sins_frame = 0;` is in it. cbindgen
//! would make macros of them.

use crate::comment;

/// An `enum` of C. Its values are handed over as 32-bit integers, as an `enum` has no size that all compilers agree on.
pub struct Enumeration {
    pub name: String,
    doc: Vec<String>,
    constants: Vec<Constant>,
}

struct Constant {
    name: String,
    value: String,
    doc: Vec<String>,
}

impl Enumeration {
    /// Of all that [`declare`] declares.
    pub fn names(&self) -> Vec<String> {
        let constants = self.constants.iter().map(|constant| &constant.name);
        let names = if self.constants.is_empty() { None } else { Some(&self.name) };
        names.into_iter().chain(constants).cloned().collect()
    }
}

/// The enumerations of a source, added to `found`.
pub fn find(source: &str, found: &mut Vec<Enumeration>) {
    let mut doc = Vec::new();
    for line in source.lines() {
        if let Some(text) = line.strip_prefix("///") {
            doc.push(text.trim().to_owned());
            continue;
        }
        let doc = std::mem::take(&mut doc);
        if let Some((name, "i32;" | "u32;")) =
            line.strip_prefix("pub type ").and_then(|rest| rest.split_once(" = "))
        {
            found.push(Enumeration { name: name.to_owned(), doc, constants: Vec::new() });
        } else if let Some((name, (kind, value))) = line
            .strip_prefix("pub const ")
            .and_then(|rest| rest.split_once(": "))
            .and_then(|(name, rest)| Some((name, rest.split_once(" = ")?)))
            && let Some(family) = found.iter_mut().find(|family| family.name == kind)
        {
            let value = value.trim_end_matches(';').to_owned();
            family.constants.push(Constant { name: name.to_owned(), value, doc });
        }
    }
}

/// All that have constants, as C declares them: the last constant without a comma, for C90 and C++98.
pub fn declare(enumerations: &[Enumeration]) -> String {
    let mut lines = Vec::new();
    for family in enumerations.iter().filter(|family| !family.constants.is_empty()) {
        lines.extend(comment("", &family.doc));
        lines.push(format!("enum {} {{", family.name));
        let last = family.constants.len() - 1;
        for (index, Constant { name, value, doc }) in family.constants.iter().enumerate() {
            lines.extend(comment("    ", doc));
            lines.push(format!("    {name} = {value}{}", if index == last { "" } else { "," }));
        }
        lines.extend(["};".to_owned(), String::new()]);
    }
    lines.join("\n")
}
