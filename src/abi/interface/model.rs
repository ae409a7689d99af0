//! The C interface as data, read from its Rust sources: what every writer of this folder writes in another language.

use syn::{Attribute, Expr, FnArg, Item, Lit, Meta, Pat, ReturnType, Visibility};

/// Everything that a host can name.
#[derive(Default)]
pub struct Interface {
    /// Units of data sheets in SI, from the preamble of the header.
    pub units: Vec<Unit>,
    /// Constants that a host may need when it is compiled: versions, sizes of buffers.
    pub constants: Vec<Constant>,
    pub enumerations: Vec<Enumeration>,
    /// Other names of plain types: `sins_status`.
    pub aliases: Vec<Alias>,
    /// Opaque types, of which a host has pointers alone.
    pub handles: Vec<String>,
    /// In the order in which the functions need them, those within others first.
    pub structs: Vec<Struct>,
    pub functions: Vec<Function>,
}

pub struct Unit {
    pub name: String,
    pub value: f64,
    pub doc: Vec<String>,
}

pub struct Constant {
    pub name: String,
    pub value: String,
    pub doc: Vec<String>,
}

/// An enumeration, or flags. Fields and arguments hold its values as `kind`, as an `enum` of C has no size that all compilers
/// agree on.
pub struct Enumeration {
    pub name: String,
    pub kind: Type,
    pub doc: Vec<String>,
    pub constants: Vec<Constant>,
}

pub struct Alias {
    pub name: String,
    pub kind: Type,
    pub doc: Vec<String>,
}

pub struct Struct {
    pub name: String,
    pub doc: Vec<String>,
    pub fields: Vec<Variable>,
    /// In bytes. No struct has padding: `interface_struct!`.
    pub size: usize,
}

pub struct Function {
    pub name: String,
    pub doc: Vec<String>,
    pub arguments: Vec<Variable>,
    pub result: Type,
}

/// A field of a struct, or an argument of a function, which has no documentation of its own.
pub struct Variable {
    pub name: String,
    pub kind: Type,
    pub doc: Vec<String>,
}

#[derive(Clone, PartialEq)]
pub enum Type {
    /// Behind a pointer alone.
    Void,
    Char,
    Int32,
    Uint32,
    Int64,
    Uint64,
    Size,
    Double,
    /// A struct, a handle or an alias.
    Named(String),
    Const(Box<Type>),
    Mut(Box<Type>),
    Array(Box<Type>, usize),
}

impl Interface {
    /// Of the sources, in their order, and of the units of the preamble.
    pub fn read(preamble: &str, sources: &[String]) -> Self {
        let mut interface = Self { units: super::units::read(preamble), ..Self::default() };
        let mut structs = Vec::new();
        for source in sources {
            for item in syn::parse_file(source).expect("a source of src/abi parses").items {
                interface.add(item, &mut structs);
            }
        }
        for index in 0..interface.functions.len() {
            let needed: Vec<String> =
                interface.functions[index].arguments.iter().filter_map(|a| a.kind.name()).collect();
            needed.iter().for_each(|name| interface.need(name, &mut structs));
        }
        interface
    }

    fn add(&mut self, item: Item, structs: &mut Vec<Struct>) {
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
        for within in one.fields.iter().filter_map(|field| field.kind.name()) {
            self.need(&within, structs);
        }
        one.size = one.fields.iter().map(|field| self.size(&field.kind)).sum();
        self.structs.push(one);
    }

    /// Bytes of a field.
    fn size(&self, kind: &Type) -> usize {
        match kind {
            Type::Char => 1,
            Type::Int32 | Type::Uint32 => 4,
            Type::Int64 | Type::Uint64 | Type::Double => 8,
            Type::Array(element, count) => self.size(element) * count,
            Type::Named(name) => match self.structs.iter().find(|one| one.name == *name) {
                Some(one) => one.size,
                None => self.size(
                    &self.aliases.iter().find(|alias| alias.name == *name).expect("it is declared").kind,
                ),
            },
            Type::Void | Type::Size | Type::Const(_) | Type::Mut(_) => {
                panic!("not the same size on every platform")
            }
        }
    }

    /// Whether a type is one of which a host has pointers alone.
    pub fn is_handle(&self, kind: &Type) -> bool {
        matches!(kind, Type::Named(name) if self.handles.contains(name))
    }
}

impl Struct {
    /// The constant that states its size: SINS_SIZEOF_OPTIONS of sins_options.
    pub fn size_constant(&self) -> String {
        self.name.replacen("sins_", "sins_sizeof_", 1).to_uppercase()
    }
}

impl Function {
    /// Whether a library without the feature `scenes` lacks it.
    pub fn is_of_scenes(&self) -> bool {
        ["sins_scene_", "sins_log_"].iter().any(|part| self.name.starts_with(part))
    }

    /// Whether an argument points to an array: a number of elements follows it.
    pub fn is_array(&self, argument: usize) -> bool {
        self.arguments.get(argument + 1).is_some_and(|next| next.kind == Type::Size)
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

    /// The struct, handle or alias in it.
    fn name(&self) -> Option<String> {
        match self {
            Self::Named(name) => Some(name.clone()),
            Self::Const(inner) | Self::Mut(inner) | Self::Array(inner, _) => inner.name(),
            _ => None,
        }
    }

    /// Numbers of rows and columns of an array, row by row, of one row if it is no matrix: matrices are 3 by 3, and the parts of
    /// an increment 5 rows of x, y, z.
    pub fn shape(count: usize) -> (usize, usize) {
        match count {
            9 => (3, 3),
            15 => (5, 3),
            _ => (1, count),
        }
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The lines of a doc comment.
fn doc(attributes: &[Attribute]) -> Vec<String> {
    let lines = attributes.iter().filter_map(|attribute| match &attribute.meta {
        Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
            Expr::Lit(line) => match &line.lit {
                Lit::Str(text) => Some(text.value().trim().to_owned()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    });
    lines.collect()
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
