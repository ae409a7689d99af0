//! `sins.d.ts` in the folder `bindings` of a build: the file of that name in `bindings/javascript`, with all that the interface has at its
//! marks, and the documentation of the header.

use super::javascript::{Argument, arguments, left_out, plain};
use super::model::{Function, Interface, Struct, Type};
use super::text::comment;

/// Longest line of documentation.
const WIDTH: usize = 130;

const TEXT: &str = include_str!("../bindings/javascript/sins.d.ts");

pub fn write(interface: &Interface) -> String {
    let handles: String = interface.handles.iter().map(|name| handle(plain(name))).collect();
    let structs: Vec<String> = interface.structs.iter().map(|one| structure(interface, one)).collect();
    TEXT.replace("// <handles>\n", &handles)
        .replace("// <structs>\n", &structs.join("\n"))
        .replace("    // <members>\n", &members(interface))
}

/// A private member makes the handles of two kinds different types.
fn handle(name: &str) -> String {
    format!("export interface {name} extends Handle {{\n    readonly \"of sins_{name}\": never;\n}}\n")
}

/// A comment of documentation, with the names as JavaScript has them.
fn documentation(indent: &str, doc: &[String]) -> String {
    let doc: Vec<String> = doc
        .iter()
        .map(|line| line.replace("sins_", "sins.").replace("SINS_", "sins.").replace("*/", "* /"))
        .collect();
    match &doc[..] {
        [] => String::new(),
        [line] if indent.len() + line.len() + 8 <= WIDTH => format!("{indent}/** {line} */\n"),
        _ => format!("{indent}/**\n{}{indent} */\n", comment(&format!("{indent} *"), &doc, WIDTH)),
    }
}

fn structure(interface: &Interface, one: &Struct) -> String {
    let fields: String = one
        .fields
        .iter()
        .map(|field| {
            let name = &field.name;
            documentation("    ", &field.doc)
                + &match &field.kind {
                    Type::Array(element, _) if **element == Type::Char => format!("    {name}: string;\n"),
                    Type::Array(element, _) => {
                        accessor(name, view(interface, element), "ArrayLike<number | bigint>")
                    }
                    kind => match value(interface, kind) {
                        "bigint" => accessor(name, "bigint", "number | bigint"),
                        kind => format!("    {name}: {kind};\n"),
                    },
                }
        })
        .collect();
    format!("{}export interface {} {{\n{fields}}}\n", documentation("", &one.doc), plain(&one.name))
}

/// A field that may be set to more types than it has.
fn accessor(name: &str, read: &str, set: &str) -> String {
    format!("    get {name}(): {read};\n    set {name}(value: {set});\n")
}

/// The type of a view of several numbers.
fn view(interface: &Interface, element: &Type) -> &'static str {
    match (value(interface, element), element) {
        ("bigint", _) => "BigUint64Array",
        (_, Type::Double) => "Float64Array",
        (_, Type::Uint32) => "Uint32Array",
        _ => "Int32Array",
    }
}

/// The type of one value.
fn value<'a>(interface: &Interface, kind: &'a Type) -> &'a str {
    match kind {
        Type::Int64 | Type::Uint64 => "bigint",
        Type::Named(name) if interface.is_struct(kind) => plain(name),
        Type::Const(_) => "string",
        _ => "number",
    }
}

fn members(interface: &Interface) -> String {
    let mut text = String::new();
    for unit in &interface.units {
        text += &documentation("    ", &unit.doc);
        text += &format!("    readonly {}: number;\n", plain(&unit.name));
    }
    let enumerated = interface.enumerations.iter().flat_map(|one| &one.constants);
    for constant in interface.constants.iter().chain(enumerated) {
        text += &documentation("    ", &constant.doc);
        text += &format!("    readonly {}: {};\n", plain(&constant.name), constant.value);
    }
    for name in &interface.handles {
        // Only a call makes a handle.
        text += &format!("    readonly {0}: abstract new (...key: never) => {0};\n", plain(name));
    }
    for one in &interface.structs {
        text += &format!("    readonly {0}: Class<{0}>;\n", plain(&one.name));
    }
    for function in &interface.functions {
        text += &declaration(interface, function);
    }
    text
}

/// One signature with the structs that the call makes, and one with places that are given for all of them.
fn declaration(interface: &Interface, one: &Function) -> String {
    let arguments = arguments(interface, one);
    let given: Vec<&(&str, Argument)> = arguments.iter().filter(|(_, own)| !own.is_returned()).collect();
    let first_left_out = given.len() - left_out(&arguments);
    let named = |arguments: &[&(&str, Argument)]| {
        let named: Vec<String> =
            arguments.iter().map(|(name, own)| format!("{name}: {}", argument(interface, own))).collect();
        named.join(", ")
    };
    let results = |makes_structs: bool| {
        let results = arguments.iter().filter_map(|(_, own)| match own {
            Argument::New(kind) => Some((*kind).to_owned()),
            Argument::Scalar(kind) => Some(value(interface, kind).to_owned()),
            Argument::Buffer => Some("string".to_owned()),
            Argument::Out(kind) if makes_structs => Some(format!("Struct<{kind}>")),
            _ => None,
        });
        results.collect::<Vec<_>>()
    };
    let has_none_yet = one.doc.iter().any(|line| line.contains("SINS_NEED_SAMPLE"));
    let end = |results: Vec<String>| match &results[..] {
        [] => value(interface, &one.result).to_owned(),
        [result] if has_none_yet => format!("{result} | null"),
        [result] => result.clone(),
        several => format!("[{}]", several.join(", ")),
    };
    let name = plain(&one.name);
    let doc = documentation("    ", &one.doc);
    let is_left_out = first_left_out < given.len();
    let shorter =
        format!("{doc}    {name}({}): {};\n", named(&given[..first_left_out]), end(results(is_left_out)));
    if is_left_out {
        shorter + &format!("    {name}({}): {};\n", named(&given), end(results(false)))
    } else {
        shorter
    }
}

fn argument(interface: &Interface, own: &Argument) -> String {
    match own {
        Argument::Handle(kind) => format!("{kind} | null"),
        Argument::In(kind) => format!("Values<{kind}> | null"),
        Argument::Out(kind) => format!("{kind} | null"),
        Argument::Number(kind) if value(interface, kind) == "bigint" => "number | bigint".to_owned(),
        Argument::Number(_) => "number".to_owned(),
        Argument::Text => "string".to_owned(),
        Argument::Bytes => "string | ArrayBuffer | ArrayBufferView | null".to_owned(),
        Argument::Room => "Uint8Array | null".to_owned(),
        Argument::Numbers => "ArrayLike<number> | null".to_owned(),
        Argument::Structs(kind) => format!("readonly Values<{kind}>[] | StructArray<{kind}> | null"),
        Argument::Records(kind) => format!("StructArray<{kind}> | null"),
        Argument::New(_) | Argument::Scalar(_) | Argument::Buffer => unreachable!("the call returns it"),
    }
}
