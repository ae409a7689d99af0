//! The model of the interface, from the Rust sources of `src/abi`.

use syn::{Attribute, Expr, FnArg, Item, Lit, Meta, Pat, ReturnType, Visibility};

use super::model::{Alias, Constant, Enumeration, Function, Interface, Struct, Type, Variable};
use super::template::Source;

/// The documentation of a field whose own fields are, in C, those of the struct that it is in.
pub const FLAT: &str = "Flat in C.";

impl Interface {
    /// Of the sources in their order, and of the units of the header.
    pub fn read<'a>(preamble: &str, sources: impl IntoIterator<Item = &'a Source>) -> Self {
        let mut interface = Self { units: super::header_units::read(preamble), ..Self::default() };
        let mut structs = Vec::new();
        for source in sources {
            source.items.iter().for_each(|item| interface.add(item, source.feature(), &mut structs));
        }
        for index in 0..interface.functions.len() {
            let needed: Vec<String> =
                interface.functions[index].arguments.iter().filter_map(|a| a.kind.name()).collect();
            needed.iter().for_each(|name| interface.need(name, &mut structs));
        }
        interface
    }

    fn add(&mut self, item: &Item, feature: Option<&'static str>, structs: &mut Vec<Struct>) {
        match item {
            Item::Type(item) if is_public(&item.vis) => {
                let (name, kind, doc) = (item.ident.to_string(), Type::of(&item.ty), doc(&item.attrs));
                // One that has constants becomes an enumeration with the first of them.
                self.aliases.push(Alias { name, kind, doc });
            }
            Item::Const(item) if is_public(&item.vis) => {
                let (name, doc) = (item.ident.to_string(), doc(&item.attrs));
                let constant = Constant { name, value: number(&item.expr), doc };
                match Type::of(&item.ty) {
                    Type::Named(family) => self.enumeration(&family).constants.push(constant),
                    _ => self.constants.push(constant),
                }
            }
            Item::Struct(item) if is_public(&item.vis) => {
                let name = item.ident.to_string();
                if item.fields.iter().all(|field| !is_public(&field.vis)) {
                    self.handles.push(name);
                    return;
                }
                let fields = item.fields.iter().map(|field| {
                    let name = field.ident.as_ref().expect("a field has a name").to_string();
                    Variable { name, kind: Type::of(&field.ty), doc: doc(&field.attrs) }
                });
                structs.push(Struct { name, doc: doc(&item.attrs), fields: fields.collect(), size: 0 });
            }
            Item::Fn(item) if is_public(&item.vis) && item.sig.abi.is_some() => {
                let arguments = item.sig.inputs.iter().map(|argument| {
                    let FnArg::Typed(argument) = argument else { panic!("no methods in the interface") };
                    let Pat::Ident(pattern) = &*argument.pat else { panic!("an argument has a name") };
                    Variable {
                        name: pattern.ident.to_string(),
                        kind: Type::of(&argument.ty),
                        doc: Vec::new(),
                    }
                });
                let ReturnType::Type(_, result) = &item.sig.output else { panic!("functions have results") };
                self.functions.push(Function {
                    name: item.sig.ident.to_string(),
                    doc: doc(&item.attrs),
                    arguments: arguments.collect(),
                    result: Type::of(result),
                    feature,
                });
            }
            _ => {}
        }
    }

    fn enumeration(&mut self, name: &str) -> &mut Enumeration {
        if let Some(index) = self.aliases.iter().position(|alias| alias.name == name) {
            let Alias { name, kind, doc } = self.aliases.remove(index);
            self.enumerations.push(Enumeration { name, kind, doc, constants: Vec::new() });
        }
        let mut found = self.enumerations.iter_mut();
        found.find(|family| family.name == name).unwrap_or_else(|| panic!("{name} is not declared"))
    }

    /// Moves the struct of a name, behind those within it, from `structs` to the interface.
    fn need(&mut self, name: &str, structs: &mut Vec<Struct>) {
        let Some(index) = structs.iter().position(|one| one.name == name) else { return };
        let mut one = structs.remove(index);
        one.fields = one.fields.into_iter().flat_map(|field| self.flat(field, structs)).collect();
        for within in one.fields.iter().filter_map(|field| field.kind.name()) {
            self.need(&within, structs);
        }
        one.size = one.fields.iter().map(|field| self.size(&field.kind)).sum();
        self.structs.push(one);
    }

    /// The fields of the struct that a field is, where its documentation is [`FLAT`]: structs of C with the same fields share one
    /// definition, and a host writes no name more.
    fn flat(&self, field: Variable, structs: &[Struct]) -> Vec<Variable> {
        if field.doc != [FLAT] {
            return vec![field];
        }
        let is_it = |one: &&Struct| Some(&one.name) == field.kind.name().as_ref();
        let found = structs.iter().chain(&self.structs).find(is_it);
        found.unwrap_or_else(|| panic!("{} is no struct", field.name)).fields.clone()
    }
}

impl Type {
    fn of(kind: &syn::Type) -> Self {
        match kind {
            syn::Type::Ptr(pointer) => {
                let target = Box::new(Self::of(&pointer.elem));
                if pointer.mutability.is_some() { Self::Mut(target) } else { Self::Const(target) }
            }
            syn::Type::Array(array) => {
                let count = number(&array.len).parse().expect("the length of an array is a number");
                Self::Array(Box::new(Self::of(&array.elem)), count)
            }
            syn::Type::Path(path) => match path.path.require_ident().map(ToString::to_string).as_deref() {
                Ok("c_void") => Self::Void,
                Ok("c_char") => Self::Char,
                Ok("i32") => Self::Int32,
                Ok("u32") => Self::Uint32,
                Ok("i64") => Self::Int64,
                Ok("u64") => Self::Uint64,
                Ok("usize") => Self::Size,
                Ok("f64") => Self::Double,
                Ok(name) if name.starts_with("sins_") => Self::Named(name.to_owned()),
                _ => panic!("a type that the interface does not have"),
            },
            _ => panic!("a kind of type that the interface does not have"),
        }
    }
}

pub fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The lines of a doc comment, without the example in C at its end.
pub fn doc(attributes: &[Attribute]) -> Vec<String> {
    let lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
            Expr::Lit(line) => match &line.lit {
                Lit::Str(text) => {
                    let text = text.value();
                    Some(text.strip_prefix(' ').unwrap_or(&text).trim_end().to_owned())
                }
                _ => None,
            },
            _ => None,
        },
        _ => None,
    });
    let mut lines: Vec<String> = lines.take_while(|line| line != "```c").collect();
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    lines
}

/// A whole number.
fn number(expression: &Expr) -> String {
    match expression {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(value) => value.base10_digits().to_owned(),
            _ => panic!("a constant is a whole number"),
        },
        Expr::Unary(negative) => format!("-{}", number(&negative.expr)),
        _ => panic!("a constant is a whole number, written out"),
    }
}
