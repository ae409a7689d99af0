//! The C interface as data: what every writer of this folder writes in another language.

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
    /// Of Cargo; a library without it lacks the function.
    pub feature: Option<&'static str>,
}

/// A field of a struct, or an argument of a function, which has no documentation of its own.
#[derive(Clone)]
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
    /// Bytes of a field.
    pub fn size(&self, kind: &Type) -> usize {
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

    /// The names of its structs, handles, enumerations and aliases.
    #[cfg(feature = "header")]
    pub fn type_names(&self) -> impl Iterator<Item = &str> {
        let structs = self.structs.iter().map(|one| &*one.name);
        let enumerations = self.enumerations.iter().map(|one| &*one.name);
        let aliases = self.aliases.iter().map(|one| &*one.name);
        structs.chain(enumerations).chain(aliases).chain(self.handles.iter().map(|name| &**name))
    }

    pub fn is_struct(&self, kind: &Type) -> bool {
        matches!(kind, Type::Named(name) if self.structs.iter().any(|one| one.name == *name))
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
    /// Whether an argument points to an array: a number of elements follows it.
    pub fn is_array(&self, argument: usize) -> bool {
        self.arguments.get(argument + 1).is_some_and(|next| next.kind == Type::Size)
    }
}

impl Type {
    /// The struct, handle or alias in it.
    pub fn name(&self) -> Option<String> {
        match self {
            Self::Named(name) => Some(name.clone()),
            Self::Const(inner) | Self::Mut(inner) | Self::Array(inner, _) => inner.name(),
            _ => None,
        }
    }

    /// Numbers of rows and columns of an array, row by row, of one row if it is no matrix: matrices are 3 by 3 or 9 by 9, and the parts of
    /// an increment 5 rows of x, y, z.
    pub fn shape(count: usize) -> (usize, usize) {
        match count {
            9 => (3, 3),
            15 => (5, 3),
            81 => (9, 9),
            _ => (1, count),
        }
    }
}
