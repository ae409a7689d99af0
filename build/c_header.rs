//! The C headers: cbindgen writes the declarations of each source at the place where a template names it.

use std::fs;
use std::path::Path;

use cbindgen::{Builder, Config};
use quote::quote;
use syn::{Field, Item, ItemStruct};

use super::model::Interface;
use super::read::{FLAT, doc, is_public};
use super::template::{Part, Source, Template};
use super::text::broken;

/// Of cbindgen. The package is build/header.
const SETTINGS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../cbindgen.toml");

/// Longest line of a prototype.
const WIDTH: usize = 118;

/// The text of a header. cbindgen reads files: they lie in `work`.
pub fn write(template: &Template, interface: &Interface, sources: &[Source], work: &Path) -> String {
    let structs: Vec<&ItemStruct> = sources
        .iter()
        .flat_map(|source| &source.items)
        .filter_map(|item| if let Item::Struct(item) = item { Some(item) } else { None })
        .collect();
    let mut text = String::new();
    for part in &template.parts {
        match part {
            Part::Text(lines) => text += lines,
            Part::Source(name) => {
                let Source { items, .. } = sources.iter().find(|of| of.name == *name).expect("it was read");
                let path = work.join(format!("{}.rs", name.replace('/', "_")));
                let source: String =
                    items.iter().map(|item| declared(item, items, interface, &structs)).collect();
                fs::create_dir_all(work).expect("the folder of the build can be written");
                fs::write(&path, source).expect("the folder of the build can be written");
                text += &declarations(&path, interface);
            }
            Part::Sizes => text += &sizes(interface, &text),
        }
    }
    while text.contains("\n\n\n") {
        text = text.replace("\n\n\n", "\n\n");
    }
    text
}

/// cbindgen's text for a source, in the form that each compiler of C and C++ takes.
fn declarations(source: &Path, interface: &Interface) -> String {
    let mut config = Config::from_file(Path::new(SETTINGS)).expect("build/cbindgen.toml is read");
    config.export.include = interface.type_names().map(str::to_owned).collect();
    let bindings =
        Builder::new().with_config(config).with_src(source).generate().expect("cbindgen reads src/abi");
    let mut bytes = Vec::new();
    bindings.write(&mut bytes);
    let text = String::from_utf8(bytes).expect("cbindgen writes UTF-8");
    // A comma behind the last constant is an error in C90 and C++98.
    let text = short_comments(&text).replace(",\n}", "\n}");
    let lines = text.lines().map(|line| match line.trim_start().split(' ').next() {
        Some("SINS_API") => broken(&with_calling_convention(&line.replace("struct ", "")), ", ", WIDTH, ""),
        Some("struct") => format!("{}\n", line.replacen("struct ", "", 1)),
        _ => format!("{line}\n"),
    });
    lines.collect::<String>().trim_end().to_owned() + "\n\n"
}

/// SINS_CALL before the name of a function.
fn with_calling_convention(prototype: &str) -> String {
    let (head, arguments) = prototype.split_once('(').expect("a function has arguments");
    let place = head.rfind("sins_").expect("a function has a name");
    format!("{}SINS_CALL {}({arguments}", &head[..place], &head[place..])
}

/// A comment of one line on that line.
fn short_comments(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for line in text.lines() {
        let count = lines.len();
        if line.trim() == "*/" && count >= 2 && lines[count - 2].trim() == "/**" {
            let only = lines.pop().expect("it is there");
            let words = only.trim_start().trim_start_matches("* ");
            let opening = lines.pop().expect("it is there");
            lines.push(format!("{opening} {words} */"));
        } else {
            lines.push(line.to_owned());
        }
    }
    lines.join("\n") + "\n"
}

/// A public item as cbindgen takes it; nothing, if it is not of the interface.
fn declared(item: &Item, items: &[Item], interface: &Interface, structs: &[&ItemStruct]) -> String {
    match item {
        Item::Type(item) if is_public(&item.vis) => {
            let name = &item.ident;
            if !interface.enumerations.iter().any(|one| *name == one.name) {
                return quote!(#item).to_string();
            }
            // Constants of a type of their own are an enumeration of C. Rust's would not hold every integer that a host gives.
            let constants = items.iter().filter_map(|item| match item {
                Item::Const(one) if matches!(&*one.ty, syn::Type::Path(of) if of.path.is_ident(name)) => {
                    let (attributes, constant, value) = (&one.attrs, &one.ident, &one.expr);
                    Some(quote!(#(#attributes)* #constant = #value))
                }
                _ => None,
            });
            let attributes = &item.attrs;
            quote!(#(#attributes)* #[repr(C)] pub enum #name { #(#constants),* }).to_string()
        }
        Item::Const(one) if is_public(&one.vis) => match &*one.ty {
            syn::Type::Path(of)
                if interface.enumerations.iter().any(|family| of.path.is_ident(&family.name)) =>
            {
                String::new()
            }
            _ => quote!(#one).to_string(),
        },
        Item::Struct(item) if is_public(&item.vis) => {
            let (name, attributes) = (&item.ident, &item.attrs);
            if interface.handles.iter().any(|handle| *name == handle) {
                // Without #[repr(C)]: opaque.
                let attributes = attributes.iter().filter(|one| one.path().is_ident("doc"));
                return quote!(#(#attributes)* pub struct #name {}).to_string();
            }
            let fields = item.fields.iter().flat_map(|field| flat(field, structs));
            quote!(#(#attributes)* pub struct #name { #(#fields),* }).to_string()
        }
        Item::Fn(item) if is_public(&item.vis) && item.sig.abi.is_some() => {
            let (attributes, head) = (&item.attrs, &item.sig);
            quote!(#(#attributes)* pub #head { loop {} }).to_string()
        }
        _ => String::new(),
    }
}

/// A field, or in its place those of the struct that it is, where its documentation is [`FLAT`].
fn flat(field: &Field, structs: &[&ItemStruct]) -> Vec<Field> {
    if doc(&field.attrs) != [FLAT] {
        return vec![field.clone()];
    }
    let is_it = |one: &&&ItemStruct| matches!(&field.ty, syn::Type::Path(of) if of.path.is_ident(&one.ident));
    structs.iter().find(is_it).expect("a field that is flat is a struct").fields.iter().cloned().collect()
}

/// The constants with the sizes of the structs in a text.
fn sizes(interface: &Interface, text: &str) -> String {
    let is_here = |name: &str| text.contains(&format!("typedef struct {name} {{"));
    let values: Vec<String> = interface
        .structs
        .iter()
        .filter(|one| is_here(&one.name))
        .map(|one| format!("    {} = {}", one.size_constant(), one.size))
        .collect();
    values.join(",\n") + "\n"
}

/// That cbindgen and this folder's own reader found the same: what cbindgen cannot read it leaves out, or leaves opaque.
pub fn check(interface: &Interface, headers: &[(&str, String)]) {
    let text: String = headers.iter().map(|(_, text)| &**text).collect();
    let is_field = |line: &&str| line.ends_with(';') && !line.trim_start().starts_with('*');
    let fields = |body: &str| body.lines().filter(is_field).count();
    for one in &interface.structs {
        let (_, rest) = text.split_once(&format!("typedef struct {} {{\n", one.name)).unwrap_or_default();
        let (body, _) = rest.split_once("\n}").unwrap_or_default();
        assert_eq!(fields(body), one.fields.len(), "cbindgen: fields of {}", one.name);
    }
    let constants = interface.enumerations.iter().flat_map(|family| &family.constants);
    for constant in constants {
        assert!(
            text.contains(&format!(" {} = {}", constant.name, constant.value)),
            "cbindgen: {}",
            constant.name
        );
    }
    for constant in &interface.constants {
        assert!(
            text.contains(&format!("#define {} {}\n", constant.name, constant.value)),
            "cbindgen: {}",
            constant.name
        );
    }
    for function in &interface.functions {
        let start = format!("SINS_CALL {}(", function.name);
        let (_, rest) = text.split_once(&start).unwrap_or_else(|| panic!("cbindgen: {}", function.name));
        let (arguments, _) = rest.split_once(");").unwrap_or_default();
        let count = if arguments == "void" { 0 } else { arguments.split(',').count() };
        assert_eq!(count, function.arguments.len(), "cbindgen: arguments of {}", function.name);
    }
}
