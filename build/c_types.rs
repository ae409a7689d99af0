//! Types as C declares them.

use super::model::{Function, Interface, Type};

/// A variable of a type: `const struct sins_options *options`, `double bias_rad_s[3]`.
pub fn declaration(interface: &Interface, kind: &Type, name: &str) -> String {
    match kind {
        Type::Const(target) => format!("const {}", declaration(interface, target, &format!("*{name}"))),
        Type::Mut(target) => declaration(interface, target, &format!("*{name}")),
        Type::Array(element, count) => format!("{}[{count}]", declaration(interface, element, name)),
        Type::Named(of) if interface.is_struct(kind) => format!("struct {of} {name}"),
        Type::Named(of) => format!("{of} {name}"),
        Type::Void => format!("void {name}"),
        Type::Char => format!("char {name}"),
        Type::Int32 => format!("int32_t {name}"),
        Type::Uint32 => format!("uint32_t {name}"),
        Type::Int64 => format!("int64_t {name}"),
        Type::Uint64 => format!("uint64_t {name}"),
        Type::Size => format!("size_t {name}"),
        Type::Double => format!("double {name}"),
    }
}

/// The arguments of a function, at least `void`.
pub fn argument_list(interface: &Interface, function: &Function) -> Vec<String> {
    if function.arguments.is_empty() {
        return vec!["void".to_owned()];
    }
    let one = |argument: &super::model::Variable| declaration(interface, &argument.kind, &argument.name);
    function.arguments.iter().map(one).collect()
}
