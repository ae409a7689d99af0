#!/usr/bin/env bash
# Builds library and program for Linux with glibc 2.17 and later, and installs them with CMake into OUT. The debug symbols
# go to OUT-debug.
#
#     release/linux.sh x86_64|i686|aarch64 OUT
set -euo pipefail
[ $# -ge 2 ] || { echo "usage: $0 x86_64|i686|aarch64 OUT" >&2; exit 2; }
mkdir -p "$2" "$2-debug"
out=$(cd "$2" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh
. release/zig.sh

case $1 in
    x86_64 | i686 | aarch64) target=$1-unknown-linux-gnu ;;
    *) echo "release/linux.sh: processor $1: must be x86_64, i686 or aarch64" >&2; exit 2 ;;
esac
need cmake cmake
need make make
need llvm llvm-objcopy
rustup target add "$target" 2>/dev/null

work=$PWD/target/release-linux/$1
mkdir -p "$work"
zig_cc "$1" "$work/cc"

CARGO_ENCODED_RUSTFLAGS=$(flags "$(rustup show active-toolchain | cut -d' ' -f1)")
export CARGO_ENCODED_RUSTFLAGS
export CARGO_PROFILE_RELEASE_DEBUG=line-tables-only # line numbers for the debugger
cmake -S . -B "$work/build" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="$1" -DCMAKE_C_COMPILER="$work/cc" \
    -DCMAKE_INSTALL_LIBDIR=lib -DSINS_PROGRAM=ON
cmake --build "$work/build"
cmake --install "$work/build" --prefix "$out"

# split FILE: moves its debug symbols into a separate file, which debuggers find by a link.
split() {
    mkdir -p "$(dirname "$out-debug/$1")"
    llvm-objcopy --only-keep-debug "$out/$1" "$out-debug/$1.debug"
    llvm-objcopy --strip-debug --add-gnu-debuglink="$out-debug/$1.debug" "$out/$1"
}
split "lib/$(readlink "$out/lib/libsins.so")"
split bin/sins
llvm-objcopy --strip-debug "$out/lib/libsins.a"

check_glibc "$out/lib/libsins.so"
check_glibc "$out/bin/sins"
