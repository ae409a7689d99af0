//! Writes the interface for other languages from its Rust sources. `read` reads the sources into a `model`; each other file writes
//! one language. cbindgen writes the C headers.

use std::fs;
use std::path::Path;

#[cfg(feature = "header")]
use super::c_header;
use super::model::Interface;
use super::template::{Source, Template};
use super::{
    ada, c_calls, c_functions, c_layout, c_struct_calls, fortran, javascript, own, python, typescript,
};

/// The headers. Each includes those above it whose types it uses.
const HEADERS: [(&str, &str); 6] = [
    ("include/sins.h", include_str!("sins.h")),
    ("include/sins_flight.h", include_str!("sins_flight.h")),
    ("include/sins_analysis.h", include_str!("sins_analysis.h")),
    ("include/sins_unit.h", include_str!("sins_unit.h")),
    ("include/sins_ensemble.h", include_str!("sins_ensemble.h")),
    ("include/sins_scene.h", include_str!("sins_scene.h")),
];

/// A generated file: its path and its text.
pub type Output = (&'static str, String);

pub struct Outputs {
    /// Committed: the headers, if the package is build/header, and the tables of functions and structs for hosts and tests.
    pub headers: Vec<Output>,
    /// For hosts in other languages: beside the library.
    pub bindings: Vec<Output>,
    /// For the crate: the check of the sizes.
    pub size_checks: String,
    /// For the crate: the names of the statuses.
    pub status_names: String,
}

/// Everything, of the sources in `abi` and of those in `generated`, by their names. One of these may also stand where a source includes it.
pub fn generate(abi: &Path, generated: &[(String, String)], work: &Path) -> Outputs {
    let templates = HEADERS.map(|(name, text)| Template::new(name, text));
    let read = |name: &str| {
        if let Some((_, own)) = generated.iter().find(|(of, _)| *of == name) {
            return own.clone();
        }
        let path = abi.join(format!("{name}.rs"));
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        generated.iter().fold(text, |text, (name, own)| {
            text.replace(&format!("include!(concat!(env!(\"OUT_DIR\"), \"/{name}.rs\"));"), own)
        })
    };
    let names = templates.iter().flat_map(Template::sources);
    let sources = names.map(|name| {
        let items = syn::parse_file(&read(name)).expect("a source of src/abi parses").items;
        Source { name: name.to_owned(), items }
    });
    let sources: Vec<Source> = sources.collect();
    let interface = Interface::read(HEADERS[0].1, &sources);
    // JavaScript comes with a module of its own, which may have less.
    let is_on =
        |feature: &str| std::env::var_os(format!("CARGO_FEATURE_{}", feature.to_uppercase())).is_some();
    let module = Interface::read(HEADERS[0].1, sources.iter().filter(|one| one.feature().is_none_or(is_on)));
    Outputs {
        headers: headers(&templates, &interface, &sources, work),
        bindings: [
            ("sins.f90", fortran::write(&interface)),
            ("sins.ads", ada::write(&interface)),
            ("sins.mjs", javascript::write(&module)),
            ("sins.d.ts", typescript::write(&module)),
        ]
        .into_iter()
        .chain(python::write(&interface))
        .collect(),
        size_checks: own::check(&interface),
        status_names: own::names(&interface),
    }
}

#[cfg(feature = "header")]
fn headers(templates: &[Template], interface: &Interface, sources: &[Source], work: &Path) -> Vec<Output> {
    let written = |template: &Template| (template.name, c_header::write(template, interface, sources, work));
    let outputs: Vec<Output> = templates.iter().map(written).collect();
    c_header::check(interface, &outputs);
    outputs.into_iter().chain(tables(interface)).collect()
}

#[cfg(not(feature = "header"))]
fn headers(_: &[Template], interface: &Interface, _: &[Source], _: &Path) -> Vec<Output> {
    tables(interface).into()
}

fn tables(interface: &Interface) -> [Output; 4] {
    [
        ("include/sins_functions.h", c_functions::write(interface)),
        ("tests/c/every_call.h", c_calls::write(interface)),
        ("tests/c/every_struct.h", c_struct_calls::write(interface)),
        ("tests/c/layout.c", c_layout::write(interface)),
    ]
}
