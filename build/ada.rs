//! `sins.ads` in the folder `bindings` of a build: the interface as a package of Ada 2012.

use std::collections::BTreeSet;

use super::model::{Constant, Function, Interface, Struct, Type, Variable};
use super::text::{broken, comment};

const WIDTH: usize = 132;

/// How to use the package.
const HEAD: &str = include_str!("../bindings/ada/head.ads");

pub fn write(interface: &Interface) -> String {
    let mut text = HEAD.to_owned();
    for unit in &interface.units {
        text += &remark("   ", &unit.doc);
        text += &format!("   {} : constant double := {};\n", unit.name, float(unit.value));
    }
    text += "\n";
    text += &constants(&interface.constants, "");
    for alias in &interface.aliases {
        text += "\n";
        text += &remark("   ", &alias.doc);
        text += &format!("   subtype {} is {};\n", alias.name, plain(&alias.kind));
    }
    for family in &interface.enumerations {
        text += "\n";
        text += &remark("   ", &family.doc);
        text += &format!("   subtype {} is {};\n", family.name, plain(&family.kind));
        text += &constants(&family.constants, &family.name);
    }
    for handle in &interface.handles {
        text += &format!("\n   type {handle}_object is limited null record;\n");
        text += &format!("   type {handle} is access all {handle}_object with Convention => C;\n");
    }
    text += "\n";
    for one in &interface.structs {
        text += &format!("   {} : constant Unsigned_32 := {};\n", one.size_constant(), one.size);
    }
    text += &arrays(interface);
    for one in &interface.structs {
        text += &structure(interface, one);
    }
    for function in &interface.functions {
        text += &prototype(interface, function);
    }
    text + "\nend Sins;\n"
}

fn remark(indent: &str, doc: &[String]) -> String {
    comment(&format!("{indent}-- "), doc, WIDTH)
}

/// Ada's numbers of floating point have a point.
fn float(value: f64) -> String {
    let text = format!("{value:e}");
    let (digits, exponent) = text.split_once('e').expect("it has an exponent");
    format!("{digits}{}e{exponent}", if digits.contains('.') { "" } else { ".0" })
}

/// Numbers without a type if none is named: they fit wherever they are used.
fn constants(constants: &[Constant], kind: &str) -> String {
    let mut text = String::new();
    for Constant { name, value, doc } in constants {
        text += &remark("   ", doc);
        text +=
            &format!("   {name} : constant {kind}{}:= {value};\n", if kind.is_empty() { "" } else { " " });
    }
    text
}

/// The types of the arrays in structs, and of arrays of numbers that functions take, each once.
fn arrays(interface: &Interface) -> String {
    let kinds = interface.structs.iter().flat_map(|one| &one.fields).map(|field| &field.kind);
    let mut types: BTreeSet<String> = kinds.filter_map(array).collect();
    let takes_numbers = |function: &Function| {
        let mut arguments = function.arguments.iter().enumerate();
        arguments.any(|(index, argument)| {
            matches!(&argument.kind, Type::Const(of) if **of == Type::Double) && function.is_array(index)
        })
    };
    if interface.functions.iter().any(takes_numbers) {
        types.insert(array_of("double"));
    }
    "\n".to_owned() + &types.into_iter().collect::<String>()
}

/// The type of an array of any length.
fn array_of(element: &str) -> String {
    format!("   type {element}_array is array (size_t range <>) of aliased {element} with Convention => C;\n")
}

fn array(kind: &Type) -> Option<String> {
    let Type::Array(element, count) = kind else { return None };
    let name = named(kind);
    Some(match (element.as_ref(), Type::shape(*count)) {
        (Type::Char, _) => format!("   subtype {name} is char_array (0 .. {});\n", count - 1),
        (element, (1, count)) => {
            format!(
                "   type {name} is array (0 .. {}) of {} with Convention => C;\n",
                count - 1,
                named(element)
            )
        }
        (element, (rows, columns)) => format!(
            "   type {name} is array (0 .. {}, 0 .. {}) of {} with Convention => C;\n",
            rows - 1,
            columns - 1,
            named(element)
        ),
    })
}

/// The record and the type of an array of them. Every variable of it is ready to be used: its struct_size is set, all else zero.
fn structure(interface: &Interface, one: &Struct) -> String {
    let mut text = "\n".to_owned() + &remark("   ", &one.doc) + &format!("   type {} is record\n", one.name);
    for field in &one.fields {
        text += &remark("      ", &field.doc);
        let value = match &field.kind {
            _ if field.name == "struct_size" => format!(" := {}", one.size_constant()),
            kind if interface.is_struct(kind) => String::new(),
            kind => format!(" := {}", zero(kind)),
        };
        text += &format!("      {} : {}{value};\n", field.name, named(&field.kind));
    }
    text += "   end record with Convention => C;\n";
    text + &array_of(&one.name)
}

fn zero(kind: &Type) -> String {
    match kind {
        Type::Array(element, count) => match Type::shape(*count) {
            (1, _) => format!("(others => {})", zero(element)),
            _ => format!("(others => (others => {}))", zero(element)),
        },
        Type::Char => "nul".to_owned(),
        Type::Double => "0.0".to_owned(),
        _ => "0".to_owned(),
    }
}

/// A plain type.
fn plain(kind: &Type) -> &'static str {
    match kind {
        Type::Char => "char",
        Type::Int32 => "Integer_32",
        Type::Uint32 => "Unsigned_32",
        Type::Int64 => "Integer_64",
        Type::Uint64 => "Unsigned_64",
        Type::Size => "size_t",
        Type::Double => "double",
        _ => panic!("not a plain type"),
    }
}

/// The name of a type; of an array that of its elements with its shape.
fn named(kind: &Type) -> String {
    match kind {
        Type::Named(name) => name.clone(),
        Type::Array(element, count) => match Type::shape(*count) {
            (1, count) => format!("sins_{}_{count}", plain(element).to_lowercase()),
            (rows, columns) => format!("sins_{}_{rows}_{columns}", plain(element).to_lowercase()),
        },
        kind => plain(kind).to_owned(),
    }
}

fn prototype(interface: &Interface, function: &Function) -> String {
    let Function { name, doc, arguments, result, .. } = function;
    let list = arguments.iter().enumerate();
    let list: Vec<String> =
        list.map(|(index, argument)| dummy(interface, argument, function.is_array(index))).collect();
    let list = if list.is_empty() { String::new() } else { format!(" ({})", list.join("; ")) };
    let result = match result {
        Type::Const(_) => "chars_ptr".to_owned(),
        result => named(result),
    };
    "\n".to_owned()
        + &remark("   ", doc)
        + &broken(&format!("   function {name}{list} return {result}"), "; ", WIDTH, "")
        + &format!("     with Import, Convention => C, External_Name => \"{name}\";\n")
}

/// An argument as Ada declares it: by the convention of C, records and arrays are handed over by their addresses, and so is all
/// that goes in and out.
fn dummy(interface: &Interface, Variable { name, kind, .. }: &Variable, is_array: bool) -> String {
    let name = if name == "record" { "the_record" } else { name };
    let (target, mode) = match kind {
        Type::Const(target) => (target.as_ref(), ""),
        Type::Mut(target) => (target.as_ref(), "in out "),
        kind => return format!("{name} : {}", named(kind)),
    };
    match target {
        Type::Mut(handle) => format!("{name} : {mode}{}", named(handle)),
        Type::Char => format!("{name} : {mode}char_array"),
        Type::Void => format!("{name} : System.Address"),
        target if interface.is_handle(target) => format!("{name} : {}", named(target)),
        target => format!("{name} : {mode}{}{}", named(target), if is_array { "_array" } else { "" }),
    }
}
