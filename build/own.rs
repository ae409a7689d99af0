//! What the crate itself takes from the interface.

use super::model::{Interface, Struct};

/// Checks, when the library is compiled, that the constants SINS_SIZEOF_... are the sizes of the structs.
pub fn check(interface: &Interface) -> String {
    let assert = |one: &Struct| {
        format!(
            "const _: () = assert!(
    size_of::<{name}>() == {size},
    \"{name}: its fields have {size} bytes. Where a double begins at a multiple of 8 bytes, as on most platforms, the struct has more. \\
     Add a field `reserved: i32` behind the new one, as sins_unit_status has, so that the size is the same everywhere.\"
);\n",
            name = one.name,
            size = one.size
        )
    };
    interface.structs.iter().map(assert).collect()
}

/// The names of the statuses.
pub fn names(interface: &Interface) -> String {
    let family = interface.enumerations.iter().find(|family| family.name == "sins_status_code");
    let names = family.expect("there are statuses").constants.iter().map(|one| &one.name);
    let arms: String = names.map(|name| format!("        {name} => c\"{name}\",\n")).collect();
    format!(
        "fn name(status: sins_status) -> &'static CStr {{
    match status {{
{arms}        _ => c\"unknown status\",
    }}
}}
"
    )
}
