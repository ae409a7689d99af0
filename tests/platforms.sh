#!/usr/bin/env bash
# The same bits on other processors and word sizes, and the effects of a host on the library there: Rust's pinned digests, the runs
# of ensembles compared with single simulators, and the programs of tests/c. ARM is emulated. 32-bit x86 runs on the machine itself
# if its kernel allows it, because the emulator raises no floating-point exceptions. This machine runs the library as released, also on an
# emulated processor without AVX. (That of the package in tests/packages.sh is not optimised in .ci/run.) Tests that could not run are
# reported at the end.
#
# WebAssembly runs in Node and in Chromium: the digests, by the interface for JavaScript.
#
#     tests/platforms.sh          all: i686, aarch64, wasm32, and this machine
#     tests/platforms.sh i686     some of: i686 aarch64 wasm32 here
#
# SINS_LIB_DIR: a folder with a libsins.so to use for this machine.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/built.sh
. tests/support/node.sh

programs="digests float_environment misuse run ensemble threads"

# fly COMPILER LIBRARY RUNNER...: builds and runs the programs with a library, in a folder of this script alone: several may run at once.
fly() {
    local compiler=$1 library=$2 folder
    shift 2
    mkdir -p target/platforms
    folder=$(mktemp -d "$PWD/target/platforms/XXXXXX")
    cp "$library" "$folder/libsins.so"
    ln -sf libsins.so "$folder/libsins.so.1" # the name within an installed library
    for name in $programs; do
        "$compiler" -std=c99 -O1 -I include "tests/c/$name.c" -o "$folder/$name" -L "$folder" -lsins -lm -lpthread \
            -Wl,-rpath,"$folder"
        "$@" "$folder/$name"
    done
    rm -r "$folder"
}

# other PROCESSOR DEBIANS_NAME RUNNER...: tests another processor with Linux.
other() {
    local processor=$1 target=$1-unknown-linux-gnu compiler=$1-linux-gnu-gcc variable library
    need "gcc-$processor-linux-gnu" "$compiler"
    need "libc6-dev-$2-cross" "/usr/$processor-linux-gnu/lib/libc.so"
    library=target/$target/debug/deps/libsins.so
    shift 2
    echo "== $processor"
    rustup target add "$target"
    variable=CARGO_TARGET_$(echo "$processor" | tr a-z A-Z)_UNKNOWN_LINUX_GNU
    env "${variable}_LINKER=$compiler" "${variable}_RUNNER=$*" cargo test -p tests --target "$target" \
        --test state -- determinism:: ensemble_widths::
    fly "$compiler" "$library" "$@"
    tests/loading.sh "$compiler -std=c99" "$library" "$@"
}

i686() {
    local programs="$programs reentry"
    local loader=/usr/i686-linux-gnu/lib/ld-linux.so.2
    need libc6-i386-cross "$loader"
    if "$loader" --version >/dev/null 2>&1; then
        other i686 i386 "$loader" --library-path /usr/i686-linux-gnu/lib:. # tests/loading.sh has its library in the current folder
    else
        could_not "unmasked floating-point exceptions and x87 on 32-bit x86" "the kernel runs no 32-bit programs; emulated"
        other i686 i386 qemu-i386 -L /usr/i686-linux-gnu
    fi
}

aarch64() {
    other aarch64 arm64 qemu-aarch64 -L /usr/aarch64-linux-gnu
}

wasm32() {
    echo "== wasm32, in Node and in Chromium"
    release/wasm.sh target/wasm
    need chromium chromium
    node_packages "$playwright"
    node tests/web/digests.mjs target/wasm
    node tests/web/digests_in_chromium.mjs target/wasm
}

here() {
    echo "== here, as released, with and without AVX"
    programs=digests
    build_library
    fly gcc "$built/libsins.so"
    fly gcc "$built/libsins.so" qemu-x86_64 -cpu Nehalem
}

need g++ c++
need qemu-user qemu-aarch64
[ $# -gt 0 ] || set -- i686 aarch64 wasm32 here
for platform in "$@"; do
    $platform
done
report_not_run
