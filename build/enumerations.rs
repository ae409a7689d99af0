//! Enumerations of the interface that are enumerations of the crate, as Rust sources.

use std::fs;
use std::path::Path;

use syn::parse::{Parse, ParseStream, Parser};
use syn::token::Brace;
use syn::{Attribute, Expr, Ident, Item, ItemEnum, Lit, LitInt, LitStr, Token, Variant, braced};

use super::read::doc;

/// The enumeration of the interface, what its constants begin with, and the enumeration of the crate with its file.
///
/// The numbers of the constants are those of snapshots (`codes!`), or else those that the enumeration states: the order of the
/// variants says nothing.
const ENUMERATIONS: [(&str, &str, &str, &str); 17] = [
    ("sins_frame", "SINS_FRAME", "Frame", "mechanization/mod.rs"),
    ("sins_scheme", "SINS_SCHEME", "Scheme", "mechanization/mod.rs"),
    ("sins_vertical", "SINS_VERTICAL", "VerticalMode", "mechanization/vertical.rs"),
    ("sins_earth", "SINS_EARTH", "Ellipsoid", "earth/mod.rs"),
    ("sins_gravity", "SINS_GRAVITY", "GravityModel", "earth/gravity.rs"),
    ("sins_axes", "SINS_AXES", "BodyAxes", "earth/state.rs"),
    ("sins_alignment", "SINS_ALIGNMENT", "Alignment", "sensors/initial.rs"),
    ("sins_grade", "SINS_GRADE", "Grade", "sensors/preset.rs"),
    ("sins_errors_source", "SINS_ERRORS", "ErrorSource", "simulator/mod.rs"),
    ("sins_decision", "SINS_DECISION", "Decision", "ensemble/statistics/meets.rs"),
    ("sins_bus_word_status", "SINS_BUS", "WordStatus", "unit/bus/word.rs"),
    ("sins_finding_kind", "SINS_FINDING", "Kind", "judge/finding.rs"),
    ("sins_finding_level", "SINS_LEVEL", "Level", "judge/finding.rs"),
    ("sins_channel", "SINS_CHANNEL", "Channel", "truth/flight/manoeuvre.rs"),
    ("sins_unit_power", "SINS_UNIT_POWER", "Power", "unit/panel.rs"),
    ("sins_unit_alignment", "SINS_UNIT_ALIGNMENT", "AlignmentKind", "unit/panel.rs"),
    ("sins_unit_state", "SINS_UNIT_STATE", "State", "unit/panel.rs"),
];

/// Kinds of the crate (`kinds!`) as an enumeration of the interface.
struct KindsOf {
    name: &'static str,
    prefix: &'static str,
    doc: &'static str,
    /// Word of the number 0 and its meaning, if it is no kind.
    none: Option<(&'static str, &'static str)>,
    own: &'static str,
    file: &'static str,
}

const KINDS: [KindsOf; 2] = [
    KindsOf {
        name: "sins_manoeuvre_kind",
        prefix: "SINS_MANOEUVRE",
        doc: "Kinds of manoeuvre.",
        none: None,
        own: "Manoeuvre",
        file: "truth/flight/manoeuvre.rs",
    },
    KindsOf {
        name: "sins_failure_kind",
        prefix: "SINS_FAILURE",
        doc: "Kinds of failure.",
        none: Some(("NONE", "No failure: clears the failure that is set.")),
        own: "Failure",
        file: "sensors/failure.rs",
    },
];

/// The enumerations of the interface: sources by their names. The crate is in the folder `src`.
pub fn interface(src: &Path) -> Vec<(String, String)> {
    let made = ENUMERATIONS.map(|(name, prefix, own, file)| {
        let items = items(src, file);
        let found = items.iter().find_map(|item| match item {
            Item::Enum(item) if item.ident == own => Some(item),
            _ => None,
        });
        let found = found.unwrap_or_else(|| panic!("{file} has no {own}"));
        (name.to_owned(), constants(found, &numbers(found, &items), name, prefix))
    });
    let kinds = KINDS.map(|KindsOf { name, prefix, doc, none, own, file }| {
        let found = items(src, file).iter().find_map(|item| kinds_of(item, own));
        let kinds = found.unwrap_or_else(|| panic!("{file} has no {own}"));
        let mut text = format!("/// {doc}\npub type {name} = i32;\n\n");
        let none = none.map(|(word, doc)| format!("/// {doc}\npub const {prefix}_{word}: {name} = 0;\n"));
        text += &none.unwrap_or_default();
        for Kind { docs, name: kind, number } in &kinds {
            docs.iter().for_each(|line| text += &format!("/// {line}\n"));
            text += &format!("pub const {prefix}{}: {name} = {number};\n", upper(&kind.to_string()));
        }
        (name.to_owned(), text)
    });
    made.into_iter().chain(kinds).collect()
}

/// The items of a source.
fn items(src: &Path, file: &str) -> Vec<Item> {
    let path = src.join(file);
    println!("cargo:rerun-if-changed={}", path.display());
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    syn::parse_file(&text).expect("a source of the crate parses").items
}

/// A kind of `kinds!`.
struct Kind {
    docs: Vec<String>,
    name: Ident,
    number: u32,
}

/// The kinds, if the item is `kinds!` of the enumeration `own`.
fn kinds_of(item: &Item, own: &str) -> Option<Vec<Kind>> {
    let Item::Macro(item) = item else { return None };
    let is_it = item.mac.path.is_ident("kinds");
    let kinds = |input: ParseStream<'_>| {
        input.call(Attribute::parse_outer)?;
        if input.parse::<Ident>()? != own {
            return Err(input.error("another enumeration"));
        }
        // The quantities of the flat form are in the first braces.
        skip_to_brace(input)?;
        skip(input)?;
        skip_to_brace(input)?;
        let rows;
        braced!(rows in input);
        let mut kinds = Vec::new();
        while !rows.is_empty() {
            let docs = doc(&rows.call(Attribute::parse_outer)?);
            let name = rows.parse()?;
            rows.parse::<Token![=]>()?;
            kinds.push(Kind { docs, name, number: rows.parse::<LitInt>()?.base10_parse()? });
            while !rows.is_empty() && rows.parse::<Option<Token![,]>>()?.is_none() {
                skip(&rows)?;
            }
        }
        Ok(kinds)
    };
    is_it.then(|| kinds.parse2(item.mac.tokens.clone()).ok()).flatten()
}

fn skip(input: ParseStream<'_>) -> syn::Result<()> {
    input.step(|at| match at.token_tree() {
        Some((_, rest)) => Ok(((), rest)),
        None => Err(at.error("expected more")),
    })
}

fn skip_to_brace(input: ParseStream<'_>) -> syn::Result<()> {
    while !input.peek(Brace) {
        skip(input)?;
    }
    Ok(())
}

/// The number of each variant: of `codes!` among the items of its file, or its own.
fn numbers(own: &ItemEnum, items: &[Item]) -> Vec<u32> {
    let codes = items.iter().find_map(|item| match item {
        Item::Macro(item) if item.mac.path.is_ident("codes") => {
            Codes::parse.parse2(item.mac.tokens.clone()).ok().filter(|codes| codes.of == own.ident)
        }
        _ => None,
    });
    let number = |variant: &Variant| match (&codes, &variant.discriminant) {
        (Some(codes), _) => {
            codes.numbers.iter().find(|(of, _)| *of == variant.ident).map(|(_, number)| *number)
        }
        (None, Some((_, Expr::Lit(literal)))) => match &literal.lit {
            Lit::Int(number) => number.base10_parse().ok(),
            _ => None,
        },
        _ => None,
    };
    let stated = |variant: &Variant| {
        number(variant).unwrap_or_else(|| panic!("{}::{} has no number", own.ident, variant.ident))
    };
    own.variants.iter().map(stated).collect()
}

/// What `codes!` says: the enumeration, and the number of each variant.
struct Codes {
    of: Ident,
    numbers: Vec<(Ident, u32)>,
}

impl Parse for Codes {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let of = input.parse()?;
        let lines;
        braced!(lines in input);
        let mut numbers = Vec::new();
        while !lines.is_empty() {
            let variant = lines.parse()?;
            lines.parse::<Token![=]>()?;
            numbers.push((variant, lines.parse::<LitInt>()?.base10_parse()?));
            lines.parse::<LitStr>()?;
            lines.parse::<Option<Token![,]>>()?;
        }
        Ok(Self { of, numbers })
    }
}

/// The constants in the order of their numbers.
fn constants(own: &ItemEnum, numbers: &[u32], name: &str, prefix: &str) -> String {
    let comment =
        |lines: Vec<String>| -> String { lines.iter().map(|line| format!("/// {line}\n")).collect() };
    let mut text = comment(doc(&own.attrs)) + &format!("pub type {name} = i32;\n\n");
    let mut choices = String::new();
    let mut variants: Vec<_> = own.variants.iter().zip(numbers).collect();
    variants.sort_by_key(|(_, number)| **number);
    for (variant, number) in variants {
        let constant = format!("{prefix}{}", upper(&variant.ident.to_string()));
        text += &comment(doc(&variant.attrs));
        text += &format!("pub const {constant}: {name} = {number};\n");
        choices += &format!("    {} = {constant},\n", variant.ident);
    }
    text + &format!("\nchoices!({name}: {} {{\n{choices}}});\n", own.ident)
}

/// A name of several words as a constant has it, with a line before each: _FOLLOW_TRUTH.
fn upper(words: &str) -> String {
    let parted = |letter: char| if letter.is_uppercase() { vec!['_', letter] } else { vec![letter] };
    words.chars().flat_map(parted).collect::<String>().to_uppercase()
}
