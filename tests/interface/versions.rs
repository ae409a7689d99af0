//! One version: the texts that must state it. `tests/packages.sh` compares what is built.

use std::ffi::CStr;
use std::fs::{read_dir, read_to_string};

use crate::support::project_file;

/// The packages of the workspace, and so these tests, have the version of `[workspace.package]`.
const VERSION: &str = env!("CARGO_PKG_VERSION");

fn text(path: &str) -> String {
    read_to_string(project_file(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// What stands behind these words at the begin of a line, for the first line that has them.
fn behind<'a>(text: &'a str, words: &str) -> &'a str {
    let line = text.lines().find_map(|line| line.strip_prefix(words));
    line.unwrap_or_else(|| panic!("no line begins with {words:?}")).trim_matches(['"', ',', ' '])
}

#[test]
fn every_text_states_the_version_of_the_workspace() {
    // The scripts of releases, CMake, Conan and the wheel take the first such line.
    assert_eq!(behind(&text("Cargo.toml"), "version = "), VERSION);
    let header = text("include/sins.h");
    let parts = ["MAJOR", "MINOR", "PATCH"].map(|part| {
        let number = behind(&header, &format!("#define SINS_VERSION_{part} "));
        // SINS_VERSION_NUM has three digits for each.
        assert!(number.parse::<u32>().unwrap() < 1000, "{part}: {number}");
        number
    });
    assert_eq!(parts.join("."), VERSION, "include/sins.h");
    // SAFETY: the text lives as long as the library.
    let library = unsafe { CStr::from_ptr(sins::abi::sins_version_string()) };
    assert_eq!(library.to_str().unwrap(), VERSION, "sins_version_string()");
    assert_eq!(behind(&text("CITATION.cff"), "version: "), VERSION, "CITATION.cff");
    assert_eq!(behind(&text("release/vcpkg/sins/vcpkg.json"), "  \"version\": "), VERSION, "vcpkg.json");
    assert_eq!(behind(&text("CHANGELOG.md"), "## "), VERSION, "CHANGELOG.md: the first release");
    assert_eq!(
        behind(&text("release/npm/package.json"), "    \"version\": "),
        "VERSION",
        "filled by wasm.sh"
    );
}

#[test]
fn each_package_of_the_workspace_inherits_the_version() {
    let workspace = text("Cargo.toml");
    let members = workspace.lines().find(|line| line.starts_with("members = ")).unwrap();
    let members: Vec<&str> = members.split('"').skip(1).step_by(2).chain([""]).collect();
    assert!(members.len() > 4, "{members:?}");
    for member in members {
        let package = text(format!("{member}/Cargo.toml").trim_start_matches('/'));
        let head = package.split("[dependencies]").next().unwrap();
        assert!(head.contains("\nversion.workspace = true\n"), "{member}/Cargo.toml");
    }
}

/// Documents name packages of this version, and the test of their commands does.
#[test]
fn names_of_packages_in_documents_have_the_version() {
    let mut pages = vec!["README.md".to_owned(), "tests/commands.py".to_owned()];
    let docs = read_dir(project_file("docs")).unwrap();
    let docs = docs.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    pages.extend(docs.filter(|name| name.ends_with(".md")).map(|name| format!("docs/{name}")));
    let mut count = 0;
    for page in pages {
        for rest in
            text(&page).split("sins-").skip(1).filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
        {
            let is_it = rest
                .strip_prefix(VERSION)
                .is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()));
            assert!(is_it, "{page}: sins-{}", rest.chars().take(16).collect::<String>());
            count += 1;
        }
    }
    assert!(count > 10, "{count} names");
}

/// Entries stand under a subject and are short enough to be read as notes of a release.
#[test]
fn entries_of_the_changelog_are_short_and_have_a_subject() {
    let changelog = text("CHANGELOG.md");
    let (_, releases) = changelog.split_once("\n## ").unwrap();
    let mut subject = None;
    let mut count = 0;
    for line in releases.lines().skip(1).filter(|line| !line.is_empty()) {
        if let Some(entry) = line.strip_prefix("- ") {
            assert!(subject.is_some(), "no subject: {entry}");
            let words = entry.split_whitespace().count();
            assert!(words <= 60, "{words} words: {entry}");
            count += 1;
        } else {
            let is_heading = line.starts_with("## ") || line.starts_with("### ");
            assert!(is_heading, "neither an entry nor a heading: {line}");
            subject = line.strip_prefix("### ");
        }
    }
    assert!(count > 20, "{count} entries");
}
