#!/usr/bin/env bash
# The library and the program for Linux with glibc 2.17 and later: libsins.so, libsins.a and sins into OUT, and the debug symbols
# of the first and the last beside them.
#
#     release/linux.sh x86_64|aarch64 OUT
#
# Zig links, for it has the symbols of every glibc: the linker of a Debian binds to the newest versions of that Debian's own.
set -euo pipefail
mkdir -p "$2"
out=$(cd "$2" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh

case $1 in
    x86_64 | aarch64) target=$1-unknown-linux-gnu ;;
    *) echo "release/linux.sh: processor $1: must be x86_64 or aarch64" >&2; exit 2 ;;
esac
glibc=2.17 # the oldest that Rust's standard library takes
toolchain=$(rustup show active-toolchain | cut -d' ' -f1)
need llvm llvm-objcopy
need python3-venv /usr/share/doc/python3-venv
tools=$PWD/target/release-tools
if ! [ -x "$tools/bin/cargo-zigbuild" ]; then
    python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check cargo-zigbuild==0.24.0 ziglang==0.17.1
fi
rustup target add "$target" 2>/dev/null
built=target/$target/release

# build OPTION...: lines for the debugger, which go into files of their own.
build() {
    PATH=$tools/bin:$PATH CARGO_PROFILE_RELEASE_DEBUG=line-tables-only \
        CARGO_ENCODED_RUSTFLAGS=$(flags "$toolchain") \
        cargo-zigbuild rustc --quiet --locked --release --target "$target.$glibc" "$@"
}

# part FILE: without its debug symbols, which go beside it.
part() {
    llvm-objcopy --only-keep-debug "$built/$1" "$out/$1.debug"
    llvm-objcopy --strip-debug "$built/$1" "$out/$1"
    (cd "$out" && llvm-objcopy --add-gnu-debuglink="$1.debug" "$1")
}

# One kind at a time: together they are not optimised across crates.
build --lib --crate-type cdylib
part libsins.so
build --lib --crate-type staticlib
llvm-objcopy --strip-debug "$built/libsins.a" "$out/libsins.a"
build --package sins-cli --bin sins
part sins
