//! The package for Python in the folder `bindings` of a build: the files of `bindings/python/sins`. `c.py` has all that the
//! interface has at its marks; the others stand as they are.

use super::c_calls::may_be_null;
use super::model::{Constant, Enumeration, Function, Interface, Struct, Type, Unit};
use super::text::{self, filled};

/// Longest line of documentation.
const WIDTH: usize = 118;

const TEXT: &str = include_str!("../bindings/python/sins/c.py");

/// The files of the package with their paths.
pub fn write(interface: &Interface) -> Vec<(&'static str, String)> {
    let fixed = [
        ("sins/__init__.py", include_str!("../bindings/python/sins/__init__.py")),
        ("sins/_analysis.py", include_str!("../bindings/python/sins/_analysis.py")),
        ("sins/_calls.py", include_str!("../bindings/python/sins/_calls.py")),
        ("sins/_ensemble.py", include_str!("../bindings/python/sins/_ensemble.py")),
        ("sins/_flight.py", include_str!("../bindings/python/sins/_flight.py")),
        ("sins/_identify.py", include_str!("../bindings/python/sins/_identify.py")),
        ("sins/_judge.py", include_str!("../bindings/python/sins/_judge.py")),
        ("sins/_scene.py", include_str!("../bindings/python/sins/_scene.py")),
        ("sins/c.pyi", include_str!("../bindings/python/sins/c.pyi")),
        ("sins/py.typed", include_str!("../bindings/python/sins/py.typed")),
    ];
    let fixed = fixed.map(|(name, text)| (name, text.to_owned()));
    [("sins/c.py", module(interface))].into_iter().chain(fixed).collect()
}

fn module(interface: &Interface) -> String {
    let constants: String =
        interface.constants.iter().map(constant).chain(interface.units.iter().map(unit)).collect();
    let mut types: Vec<String> = interface.enumerations.iter().map(enumeration).collect();
    types.extend(interface.aliases.iter().map(|one| format!("{} = {}", plain(&one.name), value(&one.kind))));
    types.extend(interface.handles.iter().map(|name| handle(interface, name)));
    types.extend(interface.structs.iter().map(structure));
    let functions: Vec<String> = interface.functions.iter().map(|one| function(interface, one)).collect();
    TEXT.replace("# <constants>", constants.trim_end())
        .replace("# <types>", &types.join("\n\n\n"))
        .replace("# <functions>", &functions.join("\n\n\n"))
}

/// A name without the prefix that it has in C: the module's own name stands for it.
fn plain(name: &str) -> &str {
    name.trim_start_matches("sins_").trim_start_matches("SINS_")
}

/// A text with the names as Python has them.
fn words(text: &str) -> String {
    text.replace("sins_", "sins.").replace("SINS_", "sins.")
}

fn constant(one: &Constant) -> String {
    let doc: String = one.doc.iter().map(|line| format!("# {}\n", words(line))).collect();
    format!("{doc}{} = {}\n", plain(&one.name), one.value)
}

fn unit(one: &Unit) -> String {
    format!("{} = {:?}  # {}\n", plain(&one.name), one.value, one.doc.join(" "))
}

/// A documentation string: what it is, and what each of its parts is.
fn documentation<'a>(doc: &[String], parts: impl Iterator<Item = (String, &'a [String])>) -> String {
    let doc: Vec<String> = doc.iter().map(|line| words(line)).collect();
    let mut text = text::comment("   ", &doc, WIDTH);
    for (index, (name, doc)) in parts.enumerate() {
        let part = filled(&[words(&format!("{name}: {}", doc.join(" ")))], WIDTH - 8);
        text += &format!("{}    {}\n", if index == 0 { "\n" } else { "" }, part.join("\n        "));
    }
    let text = text.trim();
    format!("    \"\"\"{text}{}\"\"\"\n", if text.contains('\n') { "\n    " } else { "" })
}

fn enumeration(family: &Enumeration) -> String {
    let name = plain(&family.name);
    let base = if name.ends_with("_flags") { "IntFlag" } else { "IntEnum" };
    let parts = family.constants.iter().map(|one| (plain(&one.name).to_owned(), &one.doc[..]));
    let doc = documentation(&family.doc, parts);
    let members: String =
        family.constants.iter().map(|one| format!("\n    {} = {}", plain(&one.name), one.value)).collect();
    format!("@_exported\nclass {name}(enum.{base}):\n{doc}{members}")
}

/// Its function to destroy it is that of its name; a simulator's has none in its name.
fn handle(interface: &Interface, name: &str) -> String {
    let own = format!("{name}_destroy");
    let destroy = interface.functions.iter().map(|one| &one.name).find(|one| **one == own);
    let destroy = destroy.map_or("sins_destroy", |name| name);
    format!("class {}(_Handle):\n    _destroy = \"{destroy}\"", plain(name))
}

fn structure(one: &Struct) -> String {
    let is_told = |name: &str| name != "struct_size" && !name.starts_with("reserved");
    let parts = one.fields.iter().filter(|field| is_told(&field.name)).map(|field| match field.kind {
        Type::Array(_, count) => (format!("{}[{count}]", field.name), &field.doc[..]),
        _ => (field.name.clone(), &field.doc[..]),
    });
    let doc = documentation(&one.doc, parts);
    let fields: String = one
        .fields
        .iter()
        .map(|field| format!("        (\"{}\", {}),\n", field.name, value(&field.kind)))
        .collect();
    format!(
        "class {}(_Struct):\n{doc}\n    __slots__ = ()\n    _fields_ = [\n{fields}    ]",
        plain(&one.name)
    )
}

fn function(interface: &Interface, one: &Function) -> String {
    // The number of elements behind an array is not an argument here.
    let is_array = |index: usize| match &one.arguments[index].kind {
        Type::Const(target) | Type::Mut(target) => one.is_array(index) && !interface.is_handle(target),
        _ => false,
    };
    let told = || (0..one.arguments.len()).filter(|index| *index == 0 || !is_array(index - 1));
    let kinds = told().map(|index| match (&one.arguments[index].kind, is_array(index)) {
        (Type::Const(target), true) => format!("_Array({}, is_input=True)", value(target)),
        (Type::Mut(target), true) => format!("_Array({})", value(target)),
        (Type::Const(target), false) if **target == Type::Char => "_Text".to_owned(),
        (Type::Mut(target), false) if !interface.is_handle(target) && !matches!(**target, Type::Mut(_)) => {
            format!("_Out({})", value(target))
        }
        (Type::Const(target), false) if may_be_null(&one.name, &one.arguments[index].name) => {
            format!("_MayBeNone({})", pointer(interface, target))
        }
        // A function that reads a handle lends it; the others make one.
        (Type::Mut(target), false) if one.name.contains("_get_") => {
            pointer(interface, target).replace("_New(", "_Lent(")
        }
        (Type::Const(target) | Type::Mut(target), false) => pointer(interface, target),
        (kind, _) => value(kind),
    });
    let result = match &one.result {
        Type::Const(target) if **target == Type::Char => "ctypes.c_char_p".to_owned(),
        kind => value(kind),
    };
    let kinds: Vec<String> = [result].into_iter().chain(kinds).collect();
    let names: Vec<&str> = told().map(|index| &one.arguments[index].name[..]).collect();
    let doc = documentation(&one.doc, std::iter::empty());
    format!(
        "@_function({})\ndef {}({}):\n{}",
        kinds.join(", "),
        plain(&one.name),
        names.join(", "),
        doc.trim_end()
    )
}

/// A type of `ctypes`, or of the module.
fn value(kind: &Type) -> String {
    match kind {
        // Bytes.
        Type::Void | Type::Char => "c_char".to_owned(),
        Type::Int32 => "c_int32".to_owned(),
        Type::Uint32 => "c_uint32".to_owned(),
        Type::Int64 => "c_int64".to_owned(),
        Type::Uint64 => "c_uint64".to_owned(),
        Type::Size => "c_size_t".to_owned(),
        Type::Double => "c_double".to_owned(),
        Type::Named(name) => plain(name).to_owned(),
        Type::Array(element, count) => format!("{} * {count}", value(element)),
        Type::Const(_) | Type::Mut(_) => unreachable!("no struct has a pointer"),
    }
}

/// A pointer to the target as an argument. A handle is one by itself.
fn pointer(interface: &Interface, target: &Type) -> String {
    match target {
        kind if interface.is_handle(kind) => value(kind),
        Type::Mut(handle) => format!("_New({})", pointer(interface, handle)),
        kind => format!("POINTER({})", value(kind)),
    }
}
