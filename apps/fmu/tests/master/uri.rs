//! The place of the resources, which a master gives as a URI.

use std::path::PathBuf;

use sins_fmu::uri::folder;

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
