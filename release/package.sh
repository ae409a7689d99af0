#!/usr/bin/env bash
# Makes packages for machines without Rust in target/dist, with SHA256SUMS. docs/packages.md lists the content of each package.
#
#     release/package.sh [linux-x86_64] [linux-i686] [linux-arm64] [windows-x64] [windows-x86] [fmu]       default: all six
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh

packages=("$@")
[ $# -gt 0 ] || packages=(linux-x86_64 linux-i686 linux-arm64 windows-x64 windows-x86 fmu)
for package in "${packages[@]}"; do
    case $package in
        linux-x86_64 | linux-i686 | linux-arm64 | windows-x64 | windows-x86 | fmu) ;;
        *)
            echo "release/package.sh: package $package: must be linux-x86_64, linux-i686, linux-arm64, windows-x64, windows-x86 or fmu" >&2
            exit 2
            ;;
    esac
done
need python3 python3
umask 022
dist=$PWD/target/dist
mkdir -p "$dist"

# texts FOLDER TARGET TOOLCHAIN: copies the files of all packages: documents with their pictures, examples with scenes and flights,
# licences.
texts() {
    local file
    git ls-files README.md CHANGELOG.md CITATION.cff docs 'benches/*.svg' c_examples | grep -v '\.sh$' | while read -r file; do
        command install -Dm644 "$file" "$1/$file"
    done
    cp -r "$manual" "$1/docs/sins.h"
    while read -r file; do
        command install -Dm644 "target/release/bindings/$file" "$1/share/sins/$file"
    done <cmake/bindings.txt
    release/documents.py "$1"
    command install -Dm644 -t "$1/licences" LICENSE-MIT LICENSE-APACHE
    release/licences.py "$2" >"$1/licences/crates.txt"
    command install -m644 "$(rustc "+$3" --print sysroot)/share/doc/rust/COPYRIGHT-library.html" "$1/licences/rust-library.html"
}

# wheel LIBRARY PLATFORM FOLDER: the package for Python with the library.
wheel() {
    if [ ! -x target/wheel/bin/pip ]; then
        python3 -c 'import ensurepip' 2>/dev/null || install python3-venv
        python3 -m venv target/wheel
    fi
    SINS_WHEEL_BINDINGS=$PWD/target/release/bindings SINS_WHEEL_LIBRARY=$1 SINS_WHEEL_PLATFORM=$2 \
        target/wheel/bin/pip wheel --quiet --disable-pip-version-check --no-deps --wheel-dir "$3/share/sins" ./release/python
}

# linux NAME PROCESSOR
linux() {
    local folder=$staging/sins-$version-$1
    release/linux.sh "$2" "$folder"
    texts "$folder" "$2-unknown-linux-gnu" "$stable"
    wheel "$folder/lib/libsins.so.1" "manylinux_2_17_$2" "$folder"
    archive "$folder" tar.gz
    archive "$folder-debug" tar.gz
}

# windows NAME PROCESSOR
windows() {
    local folder=$staging/sins-$version-$1
    local bin=$folder/bin lib=$folder/lib gcc=$2-w64-mingw32-gcc
    release/windows.sh "$2" "$bin" program
    mkdir -p "$lib" "$folder/include"
    mv "$bin"/{sins.def,sins.lib,libsins.dll.a} "$lib"
    cp include/*.h include/*.hpp "$folder/include"
    # Installs only the CMake package; nothing is built.
    need cmake cmake
    rustup target add "$2-pc-windows-gnu" 2>/dev/null
    cmake -S . -B "$staging/cmake-$2" -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR="$2" -DCMAKE_C_COMPILER="$gcc" \
        -DSINS_CARGO_TARGET="$2-pc-windows-gnu"
    cmake --install "$staging/cmake-$2" --component cmake --prefix "$folder"
    texts "$folder" "$2-win7-windows-gnu" "$nightly"
    # The licence of the C library's start-up code and of winpthreads.
    command install -m644 /usr/share/doc/mingw-w64-common/copyright "$folder/licences/mingw-w64.txt"
    "$gcc" -std=c99 -O2 -municode -static -s -Wl,--no-insert-timestamp -I include -o "$bin/loadlibrary.exe" \
        c_examples/loadlibrary.c
    if [ -e apps/emulator/build.sh ]; then
        apps/emulator/build.sh "$2" "$bin"
    fi
    local platform=win32
    [ "$2" = i686 ] || platform=win_amd64
    wheel "$bin/sins.dll" $platform "$folder"
    # Lines end as old editors of Windows need it.
    find "$folder" -type f \( -name '*.md' -o -name '*.txt' -o -name '*.cff' -o -name '*.h' -o -name '*.hpp' -o -name '*.c' -o -name '*.cpp' \
        -o -name '*.toml' -o -name 'LICENSE-*' \) -exec sed -i 's/$/\r/' {} +
    archive "$folder" zip
}

stable=$(rustup show active-toolchain | cut -d' ' -f1)
staging=$PWD/target/release-packages
manual=$staging/manual
rm -rf "$staging"
step "documents"
release/manual.sh "$manual"
cargo check --quiet --release # writes the interfaces for other languages
for package in "${packages[@]}"; do
    step "$package"
    case $package in
        linux-x86_64) linux linux-x86_64 x86_64 ;;
        linux-i686) linux linux-i686 i686 ;;
        linux-arm64) linux linux-arm64 aarch64 ;;
        windows-x64) windows windows-x64 x86_64 ;;
        windows-x86) windows windows-x86 i686 ;;
        fmu)
            release/fmu.sh "$staging/fmu"
            cp "$staging/fmu/sins.fmu" "$dist/sins-$version.fmu"
            ;;
    esac
done
step "done"
cd "$dist"
shopt -s nullglob # some kinds of packages may be missing
sha256sum sins-"$version"{-*.tar.gz,-*.zip,*.fmu} >SHA256SUMS
ls -l
