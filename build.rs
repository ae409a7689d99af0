//! Writes the structs of the table of sensor parameters, and the header with its counterparts in other languages.
//!
//! `SINS_WRITE_HEADER=1 cargo build` renews the committed files: `include/sins.h` and those for other languages. They go to the
//! build's own folder too, where a test compares them with the committed ones.

#[path = "src/abi/interface/mod.rs"]
mod interface;
#[allow(dead_code, reason = "the crate uses the rest")]
#[path = "src/sensors/parameter.rs"]
mod parameter;
#[path = "src/sensors/table.rs"]
mod table;
#[allow(dead_code, reason = "the crate uses the rest")]
#[path = "src/units.rs"]
mod units;

use std::path::{Path, PathBuf};
use std::{env, fs};

use interface::sensor_structs;

fn main() {
    println!("cargo:rerun-if-changed=src/abi");
    for source in [
        "build.rs",
        "src/statistics/layout.rs",
        "src/sensors/parameter.rs",
        "src/sensors/table.rs",
        "src/units.rs",
    ] {
        println!("cargo:rerun-if-changed={source}");
    }
    println!("cargo:rerun-if-env-changed=SINS_WRITE_HEADER");

    // A library without any effect of the sensors shows what effects cost that are off: benches/effects.sh.
    println!("cargo:rustc-check-cfg=cfg(sins_bare)");
    println!("cargo:rerun-if-env-changed=SINS_BARE");
    if env::var_os("SINS_BARE").is_some() {
        println!("cargo:rustc-cfg=sins_bare");
    }

    let root = PathBuf::from(variable("CARGO_MANIFEST_DIR"));
    let out = PathBuf::from(variable("OUT_DIR"));
    let sensor_params = sensor_structs::interface();
    write(&out.join("triad_parameters.rs"), &sensor_structs::triad());
    write(&out.join("sensor_params.rs"), &sensor_params);

    let (outputs, size_checks) = interface::generate(&root.join("src/abi"), &sensor_params);
    write(&out.join("sizes.rs"), &size_checks);
    let generated = out.join("generated");
    for (path, text) in outputs {
        write(&generated.join(path), &text);
        if env::var_os("SINS_WRITE_HEADER").is_some() {
            write(&root.join(path), &text);
        }
    }
    println!("cargo:rustc-env=SINS_GENERATED={}", generated.display());
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"))
}

fn write(path: &Path, text: &str) {
    let folder = path.parent().expect("a file lies in a folder");
    fs::create_dir_all(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    fs::write(path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}
