//! The place of the resources, which the master gives as a URI.

use std::path::PathBuf;

/// The folder of a URI: "file:///home/a%20b", "file:/C:/resources", "file://server/share" of Windows. `None` for other schemes.
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
