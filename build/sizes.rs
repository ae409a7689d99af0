//! Checks, when the library is compiled, that the constants SINS_SIZEOF_... are the sizes of the structs.

use super::model::Interface;

pub fn check(interface: &Interface) -> String {
    let assert = |one: &super::model::Struct| {
        format!("const _: () = assert!(size_of::<{}>() == {});\n", one.name, one.size)
    };
    interface.structs.iter().map(assert).collect()
}
