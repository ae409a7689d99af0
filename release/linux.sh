#!/usr/bin/env bash
# Library and program for Linux with glibc 2.17 and later, installed by CMake into OUT; their debug symbols into OUT-debug.
#
#     release/linux.sh x86_64|aarch64 OUT
#
# Zig links, as it has the symbols of every glibc: another linker binds to the newest versions of the glibc that it finds.
set -euo pipefail
mkdir -p "$2" "$2-debug"
out=$(cd "$2" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh

case $1 in
    x86_64 | aarch64) target=$1-unknown-linux-gnu ;;
    *) echo "release/linux.sh: processor $1: must be x86_64 or aarch64" >&2; exit 2 ;;
esac
glibc=2.17 # the oldest that Rust's standard library takes
need cmake cmake
need make make
need llvm llvm-objcopy
need python3-venv /usr/share/doc/python3-venv
tools=$PWD/target/release-tools
if ! [ -x "$tools/bin/cargo-zigbuild" ]; then
    python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check cargo-zigbuild==0.24.0 ziglang==0.17.1
fi
rustup target add "$target" 2>/dev/null

# The linker: cargo-zigbuild gives Zig's the options of gcc's that rustc writes. Zig compiles its own parts of the C library when
# a program first needs them: their debug symbols name folders of this machine, and their archives have the order in which its
# threads were ready. A second link takes them without symbols, sorted.
work=$PWD/target/release-linux/$1
mkdir -p "$work"
cat >"$work/cc" <<END
#!/bin/sh
export PATH="$tools/bin:\$PATH" ZIG_GLOBAL_CACHE_DIR="$work/zig"
link() { "$tools/bin/cargo-zigbuild" zig cc -- -target $1-linux-gnu.$glibc "\$@"; }
link "\$@" || exit
find "$work/zig/o" -name '*.[oa]' -exec llvm-strip --strip-debug {} +
find "$work/zig/o" -name '*.a' | while read -r archive; do
    parts=\${archive%.a}
    rm -rf "\$parts"
    mkdir "\$parts"
    (cd "\$parts" && llvm-ar x "\$archive" && rm "\$archive" && LC_ALL=C && llvm-ar rcs "\$archive" *.o) || exit
done
link "\$@"
END
chmod +x "$work/cc"

CARGO_ENCODED_RUSTFLAGS=$(flags "$(rustup show active-toolchain | cut -d' ' -f1)")
export CARGO_ENCODED_RUSTFLAGS
export CARGO_PROFILE_RELEASE_DEBUG=line-tables-only # lines for the debugger
cmake -S . -B "$work/build" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="$1" -DCMAKE_C_COMPILER="$work/cc" \
    -DCMAKE_INSTALL_LIBDIR=lib
cmake --build "$work/build"
cmake --install "$work/build" --prefix "$out"
env "CARGO_TARGET_$(tr a-z- A-Z_ <<<"$target")_LINKER=$work/cc" \
    cargo rustc --quiet --locked --release --package sins-cli --bin sins --target "$target" \
        --target-dir "$work/build/cargo"
command install -D "$work/build/cargo/$target/release/sins" "$out/bin/sins"

# split FILE: its debug symbols into a file apart, which debuggers find beside it.
split() {
    mkdir -p "$(dirname "$out-debug/$1")"
    llvm-objcopy --only-keep-debug "$out/$1" "$out-debug/$1.debug"
    llvm-objcopy --strip-debug --add-gnu-debuglink="$out-debug/$1.debug" "$out/$1"
}
split "lib/$(readlink "$out/lib/libsins.so")"
split bin/sins
llvm-objcopy --strip-debug "$out/lib/libsins.a"

# As a linker may bind to a newer glibc after all.
for file in lib/libsins.so bin/sins; do
    newest=$(llvm-readelf -V "$out/$file" | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n1)
    if [ "$(printf '%s\n' "$newest" "GLIBC_$glibc" | sort -V | tail -n1)" != "GLIBC_$glibc" ]; then
        echo "release/linux.sh: $file needs $newest" >&2
        exit 1
    fi
    echo "$file: needs $newest"
done
