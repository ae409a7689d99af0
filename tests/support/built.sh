# For the scripts of this project, to be sourced after need.sh: the shared library and the program sins, in the folder $built.
# SINS_LIB_DIR: a folder with both to take instead of building them. Cargo has one place for the library of either build, so each
# build discards the other's.
built=$(realpath -m "${SINS_LIB_DIR:-target/release}")

# As c_examples/build.sh.
build_library() {
    [ -n "${SINS_LIB_DIR:-}" ] || cargo rustc --release --quiet --lib --crate-type cdylib
}

build_program() {
    [ -n "${SINS_LIB_DIR:-}" ] || cargo build --release --quiet -p sins-cli
}
