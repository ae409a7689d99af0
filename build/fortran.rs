//! `sins.f90` in the folder `bindings` of a build: the interface as a module of Fortran 2008.

use super::model::{Enumeration, Function, Interface, Struct, Type, Variable};
use super::text::{broken, comment};

/// Longest line that the standard allows.
const WIDTH: usize = 132;

/// How to use the module, and the procedures that it has for hosts: Fortran itself.
const HEAD: &str = include_str!("../bindings/fortran/head.f90");
const TAIL: &str = include_str!("../bindings/fortran/tail.f90");

pub fn write(interface: &Interface) -> String {
    let mut text = HEAD.to_owned();
    for unit in &interface.units {
        text += &remark("  ", &unit.doc);
        text += &format!("  real(c_double), parameter :: {} = {:e}_c_double\n", unit.name, unit.value);
    }
    text += "\n";
    for one in &interface.constants {
        text += &remark("  ", &one.doc);
        text += &format!("  integer(c_int), parameter :: {} = {}\n", one.name, one.value);
    }
    for alias in &interface.aliases {
        text += "\n";
        text += &remark("  ", &alias.doc);
        text += &format!("  integer, parameter :: {} = {}\n", alias.name, kind(&alias.kind).1);
    }
    for family in &interface.enumerations {
        text += &enumeration(family);
    }
    text += "\n";
    for one in &interface.structs {
        text += &format!("  integer(c_int32_t), parameter :: {} = {}\n", one.size_constant(), one.size);
    }
    for one in &interface.structs {
        text += &structure(interface, one);
    }
    text += "\n  interface\n";
    for function in &interface.functions {
        text += &prototype(interface, function);
    }
    text + "  end interface\n" + TAIL
}

fn remark(indent: &str, doc: &[String]) -> String {
    comment(&format!("{indent}!>"), doc, WIDTH)
}

fn enumeration(family: &Enumeration) -> String {
    let mut text = "\n".to_owned() + &remark("  ", &family.doc);
    text += &format!("  integer, parameter :: {} = {}\n", family.name, kind(&family.kind).1);
    for constant in &family.constants {
        text += &remark("  ", &constant.doc);
        text += &format!(
            "  integer({}), parameter :: {} = {}\n",
            kind(&family.kind).1,
            constant.name,
            constant.value
        );
    }
    text
}

/// Every variable of it is ready to be used: its struct_size is set, all else is zero.
fn structure(interface: &Interface, one: &Struct) -> String {
    let mut text = "\n".to_owned() + &remark("  ", &one.doc) + &format!("  type, bind(C) :: {}\n", one.name);
    for field in &one.fields {
        text += &remark("    ", &field.doc);
        let (element, shape) = match &field.kind {
            // Fortran's first index is the fastest.
            Type::Array(element, count) => (
                element.as_ref(),
                match Type::shape(*count) {
                    (1, count) => format!("({count})"),
                    (rows, columns) => format!("({columns}, {rows})"),
                },
            ),
            kind => (kind, String::new()),
        };
        let value = match element {
            element if interface.is_struct(element) => String::new(),
            _ if field.name == "struct_size" => format!(" = {}", one.size_constant()),
            Type::Char => " = c_null_char".to_owned(),
            Type::Double => " = 0.0_c_double".to_owned(),
            Type::Named(alias) => format!(" = 0_{alias}"),
            element => format!(" = 0_{}", kind(element).1),
        };
        text += &format!("    {} :: {}{shape}{value}\n", declared(interface, element), field.name);
    }
    text + &format!("  end type {}\n", one.name)
}

/// What a type is declared as, and the name of its kind.
fn kind(kind: &Type) -> (&'static str, &'static str) {
    match kind {
        Type::Char => ("character", "c_char"),
        Type::Int32 | Type::Uint32 => ("integer", "c_int32_t"),
        Type::Int64 | Type::Uint64 => ("integer", "c_int64_t"),
        Type::Size => ("integer", "c_size_t"),
        Type::Double => ("real", "c_double"),
        _ => panic!("not a plain type"),
    }
}

fn declared(interface: &Interface, of: &Type) -> String {
    match of {
        Type::Named(name) if interface.is_struct(of) => format!("type({name})"),
        Type::Named(name) if interface.is_handle(of) => "type(c_ptr)".to_owned(),
        Type::Named(name) => format!("integer({name})"),
        Type::Char => "character(kind=c_char)".to_owned(),
        of => format!("{}({})", kind(of).0, kind(of).1),
    }
}

fn prototype(interface: &Interface, function: &Function) -> String {
    let Function { name, doc, arguments, result, .. } = function;
    let names: Vec<&str> = arguments.iter().map(|argument| argument.name.as_str()).collect();
    let mut text = "\n".to_owned() + &remark("    ", doc);
    let head = format!("    function {name}({}) bind(C, name=\"{name}\")", names.join(", "));
    text += &broken(&head, ", ", WIDTH, " &");
    text += "      import\n";
    for (index, argument) in arguments.iter().enumerate() {
        text += &format!("      {}\n", dummy(interface, argument, function.is_array(index)));
    }
    let result = match result {
        Type::Const(_) => "type(c_ptr)".to_owned(),
        result => declared(interface, result),
    };
    text + &format!("      {result} :: {name}\n    end function {name}\n")
}

/// An argument as Fortran declares it. A handle is handed over by value.
fn dummy(interface: &Interface, Variable { name, kind, .. }: &Variable, is_array: bool) -> String {
    let (target, intent) = match kind {
        Type::Const(target) => (target.as_ref(), "in"),
        Type::Mut(target) => (target.as_ref(), "inout"),
        kind => return format!("{}, value :: {name}", declared(interface, kind)),
    };
    match target {
        Type::Mut(_) => format!("type(c_ptr), intent({intent}) :: {name}"),
        Type::Char => format!("character(kind=c_char), intent({intent}) :: {name}(*)"),
        Type::Void => format!("type(c_ptr), value :: {name}"),
        target if interface.is_handle(target) => format!("type(c_ptr), value :: {name}"),
        target => {
            let shape = if is_array { "(*)" } else { "" };
            format!("{}, intent({intent}) :: {name}{shape}", declared(interface, target))
        }
    }
}
