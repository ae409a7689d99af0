//! Writes the structs of the table of sensor parameters, and the header with its counterparts in other languages.
//!
//! `SINS_WRITE_HEADER=1 cargo check -p header` renews the committed headers; without the variable it compares them with the
//! sources. The files for other languages go to the folder `bindings` beside the library.

#[path = "build/ada.rs"]
mod ada;
#[allow(dead_code, reason = "the crate uses the rest")]
#[path = "src/base"]
mod base {
    pub mod parameter;
    pub mod units;
}
#[path = "build/c_calls.rs"]
mod c_calls;
#[path = "build/c_functions.rs"]
mod c_functions;
#[cfg(feature = "header")]
#[path = "build/c_header.rs"]
mod c_header;
#[path = "build/c_layout.rs"]
mod c_layout;
#[path = "build/c_struct_calls.rs"]
mod c_struct_calls;
#[path = "build/c_types.rs"]
mod c_types;
#[path = "build/enumerations.rs"]
mod enumerations;
#[path = "build/fortran.rs"]
mod fortran;
#[path = "build/header_units.rs"]
mod header_units;
#[path = "build/interface.rs"]
mod interface;
#[path = "build/javascript.rs"]
mod javascript;
#[path = "build/model.rs"]
mod model;
#[path = "build/own.rs"]
mod own;
#[path = "build/python.rs"]
mod python;
#[path = "build/read.rs"]
mod read;
#[path = "build/sensor_structs.rs"]
mod sensor_structs;
#[path = "build/table_structs.rs"]
mod table_structs;
#[path = "build/tables.rs"]
mod tables;
#[cfg_attr(not(feature = "header"), allow(dead_code, reason = "c_header uses the rest"))]
#[path = "build/template.rs"]
mod template;
#[path = "build/text.rs"]
mod text;
#[path = "build/typescript.rs"]
mod typescript;

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    // Cargo runs this script in the folder of its package: the library, build/header or tests/inside.
    let root = Path::new(if Path::new("build.rs").exists() { "." } else { "../.." });
    for source in [
        "build.rs",
        "build",
        "src/abi",
        "src/ensemble/statistics/layout.rs",
        "src/base/parameter.rs",
        "src/base/units.rs",
    ]
    .iter()
    .chain(&tables::FILES)
    {
        println!("cargo:rerun-if-changed={}", root.join(source).display());
    }
    println!("cargo:rerun-if-env-changed=SINS_WRITE_HEADER");

    // A library without any effect of the sensors shows what effects cost that are off: benches/effects.sh.
    println!("cargo:rustc-check-cfg=cfg(sins_bare)");
    println!("cargo:rerun-if-env-changed=SINS_BARE");
    if env::var_os("SINS_BARE").is_some() {
        println!("cargo:rustc-cfg=sins_bare");
    }

    let out = PathBuf::from(variable("OUT_DIR"));
    let mut generated_sources = table_structs::interface();
    generated_sources.push(("sensor_params".to_owned(), sensor_structs::interface()));
    generated_sources.extend(enumerations::interface(&root.join("src")));
    write(&out.join("triad_parameters.rs"), &sensor_structs::triad());
    for (name, text) in table_structs::own().iter().chain(&generated_sources) {
        write(&out.join(format!("{name}.rs")), text);
    }

    let outputs = interface::generate(&root.join("src/abi"), &generated_sources, &out.join("declarations"));
    write(&out.join("sizes.rs"), &outputs.size_checks);
    write(&out.join("status_names.rs"), &outputs.status_names);
    let renews = env::var_os("SINS_WRITE_HEADER").is_some();
    assert!(!renews || cfg!(feature = "header"), "SINS_WRITE_HEADER is for: cargo check -p header");
    let generated = out.join("generated");
    let _ = fs::remove_dir_all(&generated); // files of an earlier build
    for (path, text) in outputs.headers {
        write(&generated.join(path), &text);
        let committed = root.join(path);
        if renews {
            write(&committed, &text);
        } else if cfg!(feature = "header") {
            let is_same = fs::read_to_string(&committed).is_ok_and(|old| old == text);
            assert!(
                is_same,
                "{path} is not what src/abi declares: SINS_WRITE_HEADER=1 cargo check -p header"
            );
        }
    }
    println!("cargo:rustc-env=SINS_GENERATED={}", generated.display());
    // OUT_DIR is PROFILE/build/sins-.../out, and the libraries are in PROFILE.
    let bindings = out.ancestors().nth(3).expect("cargo's folder of a profile").join("bindings");
    for (name, text) in outputs.bindings {
        write(&bindings.join(name), &text);
    }
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|_| panic!("cargo sets {name}"))
}

fn write(path: &Path, text: &str) {
    let folder = path.parent().expect("a file lies in a folder");
    fs::create_dir_all(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    fs::write(path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
}
