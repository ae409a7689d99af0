//! The committed header is what the sources generate, and the shared library exports what it declares, no more.

#[path = "support/c_side.rs"]
mod c_side;

use std::collections::BTreeSet;
use std::process::Command;

use c_side::{project_file, shared_library};

#[test]
fn committed_header_is_the_generated_one() {
    let generated = std::fs::read_to_string(env!("SINS_GENERATED_HEADER")).unwrap();
    let committed = std::fs::read_to_string(project_file("include/sins.h")).unwrap();
    assert!(
        generated == committed,
        "include/sins.h is not what src/abi declares; renew it with: SINS_WRITE_HEADER=1 cargo build"
    );
}

/// Names that follow `SINS_CALL` in the header.
fn declared() -> BTreeSet<String> {
    let header = std::fs::read_to_string(project_file("include/sins.h")).unwrap();
    let after = header.split("SINS_CALL ").skip(1);
    after
        .filter_map(|text| text.split('(').next())
        .filter(|name| name.starts_with("sins_"))
        .map(str::to_owned)
        .collect()
}

#[test]
fn exported_symbols_are_exactly_the_interface() {
    let output = Command::new("nm").args(["-D", "--defined-only"]).arg(shared_library()).output().unwrap();
    assert!(output.status.success());
    let exported: BTreeSet<String> = String::from_utf8(output.stdout)
        .unwrap()
        .lines()
        .filter_map(|line| line.split_whitespace().last().map(str::to_owned))
        .collect();
    let mut declared = declared();
    assert!(declared.len() >= 27, "{declared:?}");
    if cfg!(not(feature = "scenes")) {
        declared.retain(|name| !name.starts_with("sins_scene_") && !name.starts_with("sins_log_"));
    }
    assert_eq!(exported, declared);
}

#[test]
fn the_library_is_named_after_the_version_of_its_interface() {
    let output = Command::new("readelf").arg("-d").arg(shared_library()).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let name = format!("libsins.so.{}", sins::abi::SINS_ABI_VERSION);
    assert!(text.contains(&format!("[{name}]")), "{text}");
}

#[test]
fn the_version_macros_are_the_packages_version() {
    use sins::abi::{SINS_VERSION_MAJOR, SINS_VERSION_MINOR, SINS_VERSION_PATCH};
    let version = format!("{SINS_VERSION_MAJOR}.{SINS_VERSION_MINOR}.{SINS_VERSION_PATCH}");
    assert_eq!(version, env!("CARGO_PKG_VERSION"));
}
