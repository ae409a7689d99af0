//! `include/sins.h`: the preamble, and below it all that the interface has.

use super::c_types::{argument_list, declaration};
use super::model::{Constant, Enumeration, Function, Interface, Struct};
use super::text::filled;

/// Longest line of a prototype, and of the index.
const WIDTH: usize = 118;

/// Line of the preamble in whose place the index of functions stands.
const INDEX: &str = " * INDEX\n";

pub fn write(interface: &Interface, preamble: &str) -> String {
    let (head, rest) = preamble.split_once(INDEX).expect("the preamble has a place for the index");
    let mut text = format!("{head}{}{rest}\n", index(&interface.functions));
    for family in &interface.enumerations {
        text += &enumeration(family);
    }
    text += &constants(&interface.constants);
    for alias in &interface.aliases {
        text += &comment("", &alias.doc);
        text += &format!("typedef {};\n\n", declaration(interface, &alias.kind, &alias.name));
    }
    for one in &interface.structs {
        text += &structure(interface, one);
    }
    text += &sizes(&interface.structs);
    for function in &interface.functions {
        text += &comment("", &function.doc);
        text += &format!("{}\n\n", prototype(interface, function));
    }
    text + "#ifdef __cplusplus\n}\n#endif\n\n#endif /* SINS_H */\n"
}

/// The functions of each subject, in the order of the header.
fn index(functions: &[Function]) -> String {
    let mut text = String::new();
    for group in functions.chunk_by(|one, next| one.subject == next.subject) {
        let names: Vec<&str> = group.iter().map(|function| function.name.as_str()).collect();
        let list = format!("{}: {}", group[0].subject, names.join(", "));
        text += &format!(" *   {}\n", filled(&[list], WIDTH - 7).join("\n *     "));
    }
    text
}

/// The last constant without a comma, for C90 and C++98.
fn enumeration(family: &Enumeration) -> String {
    let mut text = comment("", &family.doc) + &format!("enum {} {{\n", family.name);
    let last = family.constants.len() - 1;
    for (index, Constant { name, value, doc }) in family.constants.iter().enumerate() {
        text += &comment("    ", doc);
        text += &format!("    {name} = {value}{}\n", if index == last { "" } else { "," });
    }
    text + "};\n\n"
}

/// Macros, those of one family without a blank line between.
fn constants(constants: &[Constant]) -> String {
    let family = |constant: &Constant| constant.name.split('_').nth(1).map(str::to_owned);
    let mut text = String::new();
    for (index, constant) in constants.iter().enumerate() {
        if index > 0 && family(&constants[index - 1]) != family(constant) {
            text += "\n";
        }
        text += &comment("", &constant.doc);
        text += &format!("#define {} {}\n", constant.name, constant.value);
    }
    text + "\n"
}

fn structure(interface: &Interface, one: &Struct) -> String {
    let mut text = comment("", &one.doc) + &format!("typedef struct {} {{\n", one.name);
    for field in &one.fields {
        text += &comment("    ", &field.doc);
        text += &format!("    {};\n", declaration(interface, &field.kind, &field.name));
    }
    text + &format!("}} {};\n\n", one.name)
}

fn sizes(structs: &[Struct]) -> String {
    let values: Vec<String> =
        structs.iter().map(|one| format!("    {} = {}", one.size_constant(), one.size)).collect();
    format!(
        "/* Sizes of the structs in bytes, the same on every platform. In languages other than C, set struct_size to these values. */\n\
         enum sins_sizeof {{\n{}\n}};\n\n",
        values.join(",\n")
    )
}

/// In one line, or with the arguments on lines of their own.
fn prototype(interface: &Interface, function: &Function) -> String {
    let head = format!("SINS_API {}", declaration(interface, &function.result, "SINS_CALL "));
    let arguments = argument_list(interface, function);
    let text = format!("{head}{}({});", function.name, arguments.join(", "));
    if text.len() <= WIDTH {
        return text;
    }
    let mut broken = format!("{head}{}(\n   ", function.name);
    let mut column = 3;
    for (index, argument) in arguments.iter().enumerate() {
        let end = if index + 1 < arguments.len() { "," } else { ");" };
        if column + 1 + argument.len() + end.len() > WIDTH {
            broken += "\n   ";
            column = 3;
        }
        broken += &format!(" {argument}{end}");
        column += 1 + argument.len() + end.len();
    }
    broken
}

/// A comment of one line on that line, a longer one with a star a line.
fn comment(indent: &str, lines: &[String]) -> String {
    if let [only] = lines {
        return format!("{indent}/* {only} */\n");
    }
    let starred = lines.iter().map(|text| format!("{indent} * {text}").trim_end().to_owned() + "\n");
    format!("{indent}/*\n{}{indent} */\n", starred.collect::<String>())
}
