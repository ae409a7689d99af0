//! The place of the resources, which the master gives as a URI.

use std::path::PathBuf;

/// The folder of a URI: "file:///home/a%20b", "file:/C:/resources", "file://server/share" of Windows. Other schemes: none.
pub fn folder(uri: &str) -> Option<PathBuf> {
    let path = percent_encoding::percent_decode_str(uri.strip_prefix("file:")?).decode_utf8().ok()?;
    let path = match path.strip_prefix("//") {
        // No host, or this one.
        Some(rest) if rest.starts_with('/') => rest,
        Some(rest) if rest.starts_with("localhost/") => &rest["localhost".len()..],
        _ => &path,
    };
    let has_drive = path.as_bytes().get(2) == Some(&b':') && path.starts_with('/');
    Some(PathBuf::from(if has_drive { &path[1..] } else { path }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_of_uris() {
        for (uri, expected) in [
            ("file:///home/a%20b", "/home/a b"),
            ("file:/home/a", "/home/a"),
            ("file://localhost/home/a", "/home/a"),
            ("file:///C:/Program%20Files/resources", "C:/Program Files/resources"),
            ("file:/C:/resources", "C:/resources"),
            ("file:///%C3%9Cbung/100%20%25", "/Übung/100 %"),
            ("file://server/share/resources", "//server/share/resources"),
            ("file:", ""),
            ("file:/", "/"),
        ] {
            assert_eq!(folder(uri), Some(PathBuf::from(expected)), "{uri}");
        }
    }

    #[test]
    fn other_places_are_none() {
        for uri in ["", "/home/a", "http://host/a", "C:\\resources", "file:///%FF"] {
            assert_eq!(folder(uri), None, "{uri}");
        }
    }
}
