//! Templates of the headers: text, and lines that name the sources whose declarations stand there.

/// A header: its name and its parts.
pub struct Template {
    pub name: &'static str,
    pub parts: Vec<Part>,
}

pub enum Part {
    Text(String),
    /// The declarations of a source of this name: a line `@options`.
    Source(String),
    /// The sizes of the structs above: a line `@sizes`.
    Sizes,
}

/// A source of the interface.
pub struct Source {
    pub name: String,
    pub items: Vec<syn::Item>,
}

impl Source {
    /// The feature of Cargo without which a library lacks its functions: as in `src/abi/mod.rs`.
    pub fn feature(&self) -> Option<&'static str> {
        match self.name.split('/').next() {
            Some("scene") => Some("scenes"),
            Some("identify") => Some("identify"),
            _ => None,
        }
    }
}

impl Template {
    pub fn new(name: &'static str, text: &str) -> Self {
        let mut parts = Vec::new();
        for line in text.split_inclusive('\n') {
            match (line.strip_prefix('@'), parts.last_mut()) {
                (Some("sizes\n"), _) => parts.push(Part::Sizes),
                (Some(names), _) => {
                    parts.extend(names.split_whitespace().map(|name| Part::Source(name.to_owned())));
                }
                (None, Some(Part::Text(text))) => *text += line,
                (None, _) => parts.push(Part::Text(line.to_owned())),
            }
        }
        Self { name, parts }
    }

    /// The names of its sources, in order.
    pub fn sources(&self) -> impl Iterator<Item = &str> {
        self.parts.iter().filter_map(|part| if let Part::Source(name) = part { Some(&**name) } else { None })
    }
}
