# To be sourced by the scripts of this project after need.sh: the shared library and the program sins, in the folder $built.
# SINS_LIB_DIR: a folder that has both, used instead of building them. Both builds of Cargo write the library to the same place,
# so each build overwrites the other's library.
built=$(realpath -m "${SINS_LIB_DIR:-target/release}")

# Like c_examples/build.sh.
build_library() {
    [ -n "${SINS_LIB_DIR:-}" ] || cargo rustc --release --quiet --lib --crate-type cdylib
}

build_program() {
    [ -n "${SINS_LIB_DIR:-}" ] || cargo build --release --quiet -p sins-cli
}
