#!/usr/bin/env bash
# Builds the library and the C and C++ examples into target/c_examples.
# SINS_LIB_DIR: a folder with a libsins.so, used instead of building one.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
out=$root/target/c_examples
warnings="-O2 -Wall -Wextra -Wpedantic -Werror"

if [ -n "${SINS_LIB_DIR:-}" ]; then
    lib=$(cd "$SINS_LIB_DIR" && pwd)
    cd "$root"
else
    cd "$root"
    cargo rustc --release --lib --crate-type cdylib
    lib=$(cd "${CARGO_TARGET_DIR:-target}/release" && pwd)
fi
cd c_examples

mkdir -p "$out"

# build PROGRAM COMPILER FLAGS... SOURCE...: at once in its place, because another script may be running the program.
build() {
    program=$1
    shift
    "$@" $warnings -I../include -o "$out/$program.$$" -L"$lib" -lsins -lm -Wl,-rpath,"$lib"
    mv "$out/$program.$$" "$out/$program"
}

build minimal ${CC:-cc} -std=c99 minimal.c
build harness ${CC:-cc} -std=c99 harness.c
build recommend ${CC:-cc} -std=c99 recommend.c
build budget ${CC:-cc} -std=c99 budget.c
build unit_day ${CC:-cc} -std=c99 unit_day.c
build bus ${CC:-cc} -std=c99 bus.c
build gnss_filter ${CC:-cc} -std=c99 gnss_filter.c
build cpp_host ${CXX:-c++} -std=c++11 cpp_host.cpp
# loadlibrary loads the library at run time.
${CC:-cc} -std=c99 $warnings -I../include -o "$out/loadlibrary" loadlibrary.c -ldl
echo "built in target/c_examples: minimal harness recommend budget gnss_filter unit_day bus cpp_host loadlibrary"
