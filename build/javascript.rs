//! `sins.mjs` in the folder `bindings` of a build: the file of that name in `bindings/javascript`, with all that the interface has at its
//! marks. The library is WebAssembly there: pointers and sizes have 32 bits.

use super::model::{Function, Interface, Struct, Type, Variable};

const TEXT: &str = include_str!("../bindings/javascript/sins.mjs");

pub fn write(interface: &Interface) -> String {
    let indented = |lines: Vec<String>, indent: &str| lines.join(&format!("\n{indent}"));
    let structs = interface.structs.iter().map(|one| structure(interface, one)).collect();
    let handles = interface.handles.iter().map(|name| handle(interface, name)).collect();
    let functions = interface.functions.iter().map(|one| function(interface, one)).collect();
    TEXT.replace("// <constants>", &indented(constants(interface), "    "))
        .replace("// <structs>", &indented(structs, "        "))
        .replace("// <handles>", &indented(handles, "        "))
        .replace("// <functions>", &indented(functions, "        "))
}

/// A name without the prefix that it has in C: the library's own object stands for it.
pub fn plain(name: &str) -> &str {
    name.trim_start_matches("sins_").trim_start_matches("SINS_")
}

fn constants(interface: &Interface) -> Vec<String> {
    let own = interface.constants.iter().chain(interface.enumerations.iter().flat_map(|one| &one.constants));
    let values = own.map(|one| format!("{}: {},", plain(&one.name), one.value));
    values
        .chain(interface.units.iter().map(|one| format!("{}: {:?},", plain(&one.name), one.value)))
        .collect()
}

fn structure(interface: &Interface, one: &Struct) -> String {
    let mut offset = 0;
    let fields = one.fields.iter().map(|field| {
        let (element, count) = match &field.kind {
            Type::Array(element, count) => (&**element, *count),
            kind => (kind, 1),
        };
        let at = offset;
        offset += interface.size(&field.kind);
        let name = &field.name;
        match element {
            Type::Named(inner) if interface.is_struct(element) => {
                assert!(count == 1, "{name}: an array of structs within a struct");
                format!("[\"{name}\", \"{}\", {at}]", plain(inner))
            }
            element => format!("[\"{name}\", \"{}\", {at}, {count}]", letter(interface, element)),
        }
    });
    let fields: Vec<String> = fields.collect();
    format!("{0}: structure(\"{0}\", {1}, [{2}]),", plain(&one.name), one.size, fields.join(", "))
}

/// The kind of a field: a letter, and the bytes of an element.
fn letter(interface: &Interface, kind: &Type) -> &'static str {
    match kind {
        Type::Char => "c1",
        Type::Int32 => "i4",
        // A size has 32 bits.
        Type::Uint32 | Type::Size => "u4",
        Type::Int64 => "i8",
        Type::Uint64 => "u8",
        Type::Double => "f8",
        Type::Named(name) => {
            let alias = interface.aliases.iter().find(|one| one.name == *name).map(|one| &one.kind);
            let family = interface.enumerations.iter().find(|one| one.name == *name).map(|one| &one.kind);
            letter(interface, alias.or(family).expect("a plain type"))
        }
        _ => panic!("no struct has this type"),
    }
}

/// Its function to destroy it is that of its name; a simulator's has none in its name.
fn handle(interface: &Interface, name: &str) -> String {
    let own = format!("{name}_destroy");
    let destroy = interface.functions.iter().map(|one| &one.name).find(|one| **one == own);
    let destroy = destroy.map_or("sins_destroy", |name| name);
    format!("{0}: handle_class(\"{0}\", \"{destroy}\"),", plain(name))
}

/// What one or more arguments of C are for a host in JavaScript.
pub enum Argument<'a> {
    /// A handle of the name.
    Handle(&'a str),
    /// A struct that the call reads.
    In(&'a str),
    /// A struct that the call writes, or changes.
    Out(&'a str),
    /// A number.
    Number(&'a Type),
    /// A text.
    Text,
    /// Bytes or a text that the call reads, and their number.
    Bytes,
    /// Room for bytes, and its size.
    Room,
    /// Numbers that the call reads, and how many they are.
    Numbers,
    /// Structs that the call reads, and their number.
    Structs(&'a str),
    /// Structs that the call writes, and their number.
    Records(&'a str),
    /// Not an argument there: a handle that the call makes.
    New(&'a str),
    /// Not an argument there: a number that the call writes.
    Scalar(&'a Type),
    /// Not an argument there: a buffer, its size, and the size of the text.
    Buffer,
}

impl Argument<'_> {
    /// Whether the call returns it without being given a place for it.
    pub fn is_returned(&self) -> bool {
        matches!(self, Self::New(_) | Self::Scalar(_) | Self::Buffer)
    }

    fn is_out(&self) -> bool {
        matches!(self, Self::Out(_))
    }
}

/// The arguments of a function, with their names.
pub fn arguments<'a>(interface: &Interface, function: &'a Function) -> Vec<(&'a str, Argument<'a>)> {
    let mut list = Vec::new();
    let mut index = 0;
    while let Some(Variable { name, kind, .. }) = function.arguments.get(index) {
        let target = match kind {
            Type::Const(target) | Type::Mut(target) => Some(&**target),
            _ => None,
        };
        let is_handle = target.is_some_and(|target| interface.is_handle(target));
        let is_array = function.is_array(index) && target.is_some() && !is_handle;
        let (argument, taken) = match (kind, target) {
            (Type::Mut(_), Some(Type::Char)) => (Argument::Buffer, 3),
            (Type::Mut(_), Some(Type::Void)) => (Argument::Room, 2),
            (Type::Mut(_), Some(Type::Mut(inner))) => (Argument::New(named(inner)), 1),
            (Type::Const(_), Some(Type::Char | Type::Void)) if is_array => (Argument::Bytes, 2),
            (Type::Const(_), Some(Type::Double)) if is_array => (Argument::Numbers, 2),
            (Type::Const(_), Some(Type::Char)) => (Argument::Text, 1),
            (_, Some(target)) if is_handle => (Argument::Handle(named(target)), 1),
            (Type::Const(_), Some(target)) if is_array => (Argument::Structs(named(target)), 2),
            (Type::Mut(_), Some(target)) if is_array => (Argument::Records(named(target)), 2),
            (Type::Const(_), Some(target)) => (Argument::In(named(target)), 1),
            (Type::Mut(_), Some(target)) if interface.is_struct(target) => (Argument::Out(named(target)), 1),
            (Type::Mut(_), Some(target)) => (Argument::Scalar(target), 1),
            (kind, _) => (Argument::Number(kind), 1),
        };
        list.push((&**name, argument));
        index += taken;
    }
    list
}

fn named(kind: &Type) -> &str {
    match kind {
        Type::Named(name) => plain(name),
        _ => panic!("a type without a name"),
    }
}

/// The number of arguments at the end that may be left out, because the call makes them: structs that it writes.
pub fn left_out(arguments: &[(&str, Argument)]) -> usize {
    let end = arguments.iter().rev().take_while(|(_, one)| one.is_out() || one.is_returned());
    end.filter(|(_, one)| one.is_out()).count()
}

fn function(interface: &Interface, one: &Function) -> String {
    let arguments = arguments(interface, one);
    let given: Vec<&(&str, Argument)> = arguments.iter().filter(|(_, own)| !own.is_returned()).collect();
    let names: Vec<&str> = given.iter().map(|(name, _)| *name).collect();
    let first_left_out = given.len() - left_out(&arguments);
    // A function that reads a handle lends it; the others make one.
    let lender = one.name.contains("_get_").then(|| names[0].to_owned());
    let mut code = Code { lender, ..Code::default() };
    for own @ (name, argument) in &arguments {
        let is_left_out = given[first_left_out..].iter().any(|one| one.0 == own.0);
        code.add(interface, name, argument, is_left_out);
    }
    let call = format!("wasm.{}({})", one.name, code.passed.join(", "));
    let sim = if matches!(arguments.first(), Some(("sim", Argument::Handle(_)))) { ", $sim" } else { "" };
    let end = match (&code.results[..], &one.result) {
        _ if arguments.iter().any(|(_, own)| matches!(own, Argument::Buffer)) => {
            vec![format!("return written((buffer, capacity, needed) => {call}{sim});")]
        }
        (_, Type::Const(_)) => vec![format!("return text_at({call} >>> 0, TEXT_SIZE);")],
        ([], Type::Uint32) => vec![format!("return {call} >>> 0;")],
        ([], _) => vec![format!("return done({call}{sim});")],
        ([(Some(name), made)], _) => vec![
            format!("const $answer = done({call}{sim});"),
            format!("return {name} !== undefined ? $answer : $answer === NEED_SAMPLE ? null : {made};"),
        ],
        (results, _) => {
            let results = results.iter().map(|(name, made)| match name {
                Some(name) => format!("{name} === undefined ? {made} : undefined"),
                None => made.clone(),
            });
            let results: Vec<String> = results.collect();
            vec![format!("return answer(done({call}{sim}), [{}]);", results.join(", "))]
        }
    };
    let mut lines = vec![format!("{}({}) {{", plain(&one.name), names.join(", ")), "    try {".to_owned()];
    lines.extend(code.places.into_iter().chain(end).map(|line| format!("        {line}")));
    lines.extend(["    } catch (error) {".to_owned(), "        throw trapped(error);".to_owned()]);
    if code.borrows {
        lines.extend(["    } finally {".to_owned(), "        release();".to_owned()]);
    }
    lines.extend(["    }".to_owned(), "},".to_owned()]);
    lines.join("\n        ")
}

/// The code of a call, argument by argument.
#[derive(Default)]
struct Code {
    /// Lines that check the arguments and find their places in the memory of the module.
    places: Vec<String>,
    /// What the function of the module gets.
    passed: Vec<String>,
    /// What the call returns: the argument that must be left out for it, and how it is read.
    results: Vec<(Option<String>, String)>,
    /// The argument that owns the handles that the call returns; `None`: the caller owns them.
    lender: Option<String>,
    /// Bytes of the numbers that the call writes.
    outs: usize,
    /// Whether an argument takes memory for the call.
    borrows: bool,
}

impl Code {
    fn add(&mut self, interface: &Interface, name: &str, argument: &Argument, is_left_out: bool) {
        match argument {
            Argument::Handle(kind) => {
                self.place(name, &format!("as_handle({name}, handles.{kind}, \"{name}\")"))
            }
            Argument::In(kind) => self.place(name, &format!("as_struct({name}, structs.{kind}, \"{name}\")")),
            Argument::Out(kind) if is_left_out => {
                let made = format!("${name}_made");
                self.places
                    .push(format!("const {made} = {name} === undefined ? new structs.{kind}() : {name};"));
                self.place(name, &format!("as_written({made}, structs.{kind}, \"{name}\")"));
                self.results.push((Some(name.to_owned()), made));
            }
            Argument::Out(kind) => {
                self.place(name, &format!("as_written({name}, structs.{kind}, \"{name}\")"))
            }
            Argument::Number(kind) => {
                self.place(name, &format!("as_{}({name}, \"{name}\")", letter(interface, kind)))
            }
            Argument::Text => self.place(name, &format!("as_text({name}, \"{name}\")")),
            Argument::Bytes => self.array(name, &format!("as_bytes({name}, \"{name}\")")),
            Argument::Room => self.array(name, &format!("as_room({name}, \"{name}\")")),
            Argument::Numbers => self.array(name, &format!("as_numbers({name}, \"{name}\")")),
            Argument::Structs(kind) => {
                self.array(name, &format!("as_structs({name}, structs.{kind}, \"{name}\")"))
            }
            Argument::Records(kind) => {
                self.array(name, &format!("as_records({name}, structs.{kind}, \"{name}\")"))
            }
            Argument::New(kind) => {
                let key = self.number("u4");
                let owner = self.lender.as_ref().map_or(String::new(), |lender| format!(", {lender}"));
                self.results.push((None, format!("new handles.{kind}({key}{owner})")));
            }
            Argument::Scalar(kind) => {
                let number = self.number(letter(interface, kind));
                self.results.push((None, number));
            }
            Argument::Buffer => self.passed.extend(["buffer", "capacity", "needed"].map(str::to_owned)),
        }
        self.borrows |= matches!(
            argument,
            Argument::Text | Argument::Bytes | Argument::Numbers | Argument::Structs(_) | Argument::Buffer
        );
    }

    fn place(&mut self, name: &str, found: &str) {
        self.places.push(format!("const ${name} = {found};"));
        self.passed.push(format!("${name}"));
    }

    fn array(&mut self, name: &str, found: &str) {
        self.places.push(format!("const ${name} = {found};"));
        self.passed.extend([format!("${name}.at"), format!("${name}.count")]);
    }

    /// Room for a number that the call writes, and how it is read.
    fn number(&mut self, letter: &str) -> String {
        let at = format!("out + {}", self.outs);
        self.outs += 8;
        let shift = if letter.ends_with('8') { 3 } else { 2 };
        self.passed.push(at.clone());
        format!("views.{letter}()[({at}) >>> {shift}]")
    }
}
