//! `tests/c/layout.c`: the size of every struct and the offset of every field, for every compiler, word size and packing.

use super::model::Interface;

const HEAD: &str = "\
/* Sizes and offsets of every struct: the same for every compiler, word size and packing. Compiled, not run, also under
 * -fpack-struct=4 and -fpack-struct=1, as C99 and as C++11.
 *
 * This file is written by build/ from the Rust sources; do not edit it. */

#include \"sins_analysis.h\"
#include \"sins_scene.h\"

#ifdef __cplusplus
#define CHECK(condition) static_assert(condition, #condition)
#else
#define CHECK(condition) extern const char checked[(condition) ? 1 : -1]
#endif

/* Checks also the size that the header states for other languages. */
#define SIZE(type, stated, size) CHECK(sizeof(struct type) == (size) && (stated) == (size))
#define AT(type, field, offset) CHECK(offsetof(struct type, field) == (offset))
";

pub fn write(interface: &Interface) -> String {
    let mut text = HEAD.to_owned();
    for one in &interface.structs {
        text += &format!("\nSIZE({}, {}, {});\n", one.name, one.size_constant(), one.size);
        let mut offset = 0;
        for field in &one.fields {
            text += &format!("AT({}, {}, {offset});\n", one.name, field.name);
            offset += interface.size(&field.kind);
        }
    }
    text
}
