//! Sizes of the structs of the header, for hosts in languages that know no `sizeof` of C.

use std::collections::BTreeMap;

/// Name and size of each struct in `declarations`, in their order. No struct has padding: `interface_struct!`.
pub fn of_structs(declarations: &str) -> Vec<(String, usize)> {
    let mut sizes = Vec::new();
    let mut known = BTreeMap::new();
    for definition in declarations.split("typedef struct ").skip(1) {
        let Some((name, body)) = definition.split_once(" {\n") else { continue };
        let (body, _) = body.split_once("\n}").expect("a struct has an end");
        let fields = body.lines().map(str::trim).filter(|line| !line.starts_with(['/', '*']));
        let size =
            fields.filter_map(|line| line.strip_suffix(';')).map(|field| field_size(field, &known)).sum();
        known.insert(name.to_owned(), size);
        sizes.push((name.to_owned(), size));
    }
    sizes
}

fn field_size(field: &str, structs: &BTreeMap<String, usize>) -> usize {
    let (kind, name) = field.rsplit_once(' ').expect("a field has a type and a name");
    let element = match kind {
        "char" => 1,
        "int32_t" | "uint32_t" | "sins_status" => 4,
        "int64_t" | "uint64_t" | "double" => 8,
        _ => *structs
            .get(kind.trim_start_matches("struct "))
            .unwrap_or_else(|| panic!("{field}: of what size?")),
    };
    let count =
        name.split_once('[').map_or(1, |(_, count)| count.trim_end_matches(']').parse().expect("a count"));
    element * count
}

/// The name of the constant: SINS_SIZEOF_OPTIONS of sins_options.
fn constant(name: &str) -> String {
    name.replacen("sins_", "sins_sizeof_", 1).to_uppercase()
}

/// The sizes as C declares them.
pub fn declare(sizes: &[(String, usize)]) -> String {
    let values: Vec<String> =
        sizes.iter().map(|(name, size)| format!("    {} = {size}", constant(name))).collect();
    format!(
        "/* Sizes of the structs in bytes, the same on every platform: what struct_size is set to in other languages than C. */\n\
         enum sins_sizeof {{\n{}\n}};",
        values.join(",\n")
    )
}

/// The sizes as Rust checks them when it compiles the library.
pub fn check(sizes: &[(String, usize)]) -> String {
    sizes
        .iter()
        .map(|(name, size)| format!("const _: () = assert!(size_of::<{name}>() == {size});\n"))
        .collect()
}
