//! That the sizes which hosts are told are those of the structs: Rust checks it when it compiles the library.

use super::model::Interface;

pub fn check(interface: &Interface) -> String {
    let assert = |one: &super::model::Struct| {
        format!("const _: () = assert!(size_of::<{}>() == {});\n", one.name, one.size)
    };
    interface.structs.iter().map(assert).collect()
}
