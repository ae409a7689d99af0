#!/usr/bin/env bash
# Builds the Functional Mock-up Unit OUT/sins.fmu for the named platforms, or for all: Linux with glibc 2.17 and later, Windows 7
# and later. The binaries stay in OUT/PLATFORM.
#
#     release/fmu.sh OUT [linux64] [win64] [win32] [aarch64-linux]
#
# FMI 2.0 names no folder for Linux on ARM: "aarch64-linux" is the name of FMI 3.0.
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: $0 OUT [linux64] [win64] [win32] [aarch64-linux]" >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh
. release/zig.sh
need python3 python3

shift
[ $# -gt 0 ] || set -- linux64 win64 win32 aarch64-linux

# linux PLATFORM PROCESSOR
linux() {
    local target=$2-unknown-linux-gnu work=$PWD/target/release-linux/$2
    mkdir -p "$work" "$out/$1"
    rustup target add "$target" 2>/dev/null
    zig_cc "$2" "$work/unit_cc"
    env "CARGO_TARGET_$(tr a-z- A-Z_ <<<"$target")_LINKER=$PWD/release/fmu_linker.sh" UNIT_LINKER="$work/unit_cc" \
        CARGO_ENCODED_RUSTFLAGS="$(flags "$(rustup show active-toolchain | cut -d' ' -f1)" -Cstrip=symbols)" \
        cargo rustc --quiet --locked --release --package sins-fmu --lib --crate-type cdylib --target "$target" \
        --target-dir "$work/build/cargo"
    cp "$work/build/cargo/$target/release/libsins_fmu.so" "$out/$1"
    check_glibc "$out/$1/libsins_fmu.so"
    files+=("binaries/$1/sins_fmu.so=$out/$1/libsins_fmu.so")
}

# windows PLATFORM PROCESSOR
windows() {
    release/windows.sh "$2" "$out/$1" unit
    # The licence of the C library's start-up code and of winpthreads.
    files+=("binaries/$1/sins_fmu.dll=$out/$1/sins_fmu.dll"
        "documentation/licenses/mingw-w64.txt=/usr/share/doc/mingw-w64-common/copyright")
}

release/licences.py all sins-fmu >"$out/crates.txt"
files=("documentation/licenses/crates.txt=$out/crates.txt"
    "documentation/licenses/rust-library.html=$(rustc --print sysroot)/share/doc/rust/COPYRIGHT-library.html")
for platform; do
    case $platform in
        linux64) linux linux64 x86_64 ;;
        aarch64-linux) linux aarch64-linux aarch64 ;;
        win64) windows win64 x86_64 ;;
        win32) windows win32 i686 ;;
        *)
            echo "release/fmu.sh: platform $platform: must be linux64, win64, win32 or aarch64-linux" >&2
            exit 2
            ;;
    esac
done
cargo run --quiet --locked --profile unoptimised --package sins-fmu --bin pack-fmu -- "$out/sins.fmu" "${files[@]}"
