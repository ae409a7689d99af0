#!/usr/bin/env bash
# Installs the library into an empty prefix, moves it, and builds and runs two examples with it, in C and C++: with pkg-config
# and with CMake, shared and static. Then uses the source tree as a part of a CMake project. Tests that could not run are
# reported at the end. SINS_LIB_DIR: as in c_examples/build.sh.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/folders.sh

need g++ c++
need cmake cmake
need make make
need pkgconf pkg-config

out=$PWD/target/install
first=$out/first
moved=$out/moved/elsewhere
hosts=$out/hosts
version=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
abi=$(sed -n 's/^#define SINS_HEADER_ABI //p' include/sins.h)
mkdir -p "$out"
warnings="-O2 -Wall -Wextra -Wpedantic -Werror"

fail() {
    echo "$*" >&2
    exit 1
}

# same PROGRAM EXAMPLE: the program prints the same as the example that c_examples/build.sh built.
same() {
    diff <("$1") "$out/$2.txt" || fail "$1 prints something else"
    echo "$1: as $2"
}

# needs PROGRAM: prints the libraries of the project that it is linked with.
needs() {
    readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(libsins.*\)\]/\1/p'
}

# equal EXPECTED FOUND WHAT
equal() {
    [ "$1" = "$2" ] || fail "$3 is \"$2\", not \"$1\""
}

echo "== the plain build, against cargo's own folder"
c_examples/build.sh
for example in minimal cpp_host; do
    "target/c_examples/$example" >"$out/$example.txt"
done

echo "== installed, and moved"
rm -rf "$first" "$moved" "$hosts"
cmake -S . -B "$out/build"
cmake --build "$out/build"
cmake --install "$out/build" --prefix "$first"
mkdir -p "${moved%/*}" "$hosts"
mv "$first" "$moved"
expected="$(cd include && printf 'include/%s\n' *.h *.hpp)
lib/cmake/sins/sinsConfig.cmake
lib/cmake/sins/sinsConfigVersion.cmake
lib/libsins.a
lib/libsins.so
lib/libsins.so.$abi
lib/libsins.so.$abi.0.0
lib/pkgconfig/sins.pc
$(sed s,^,share/sins/, cmake/bindings.txt)"
equal "$(sort <<<"$expected")" "$(cd "$moved" && find . -type f -o -type l | sed 's,^\./,,' | sort)" "the list of files"
name_no_folder "$moved"
library=$moved/lib/libsins.so
equal "libsins.so.$abi" "$(readelf -d "$library" | sed -n 's/.*(SONAME).*\[\(.*\)\]/\1/p')" "SONAME"
equal "" "$(readelf -d "$library" | grep -E 'RPATH|RUNPATH' || true)" "the search path of the library"
equal "$abi.0.0" "$(sed -n '/metadata.capi.library/,/^$/s/^version = "\([^"]*\)".*/\1/p' Cargo.toml)" "cargo-c's version of the library"

echo "== pkg-config"
export PKG_CONFIG_PATH=$moved/lib/pkgconfig
equal "$version" "$(pkg-config --modversion sins)" "the version by pkg-config"
built() {
    local name=$1 example=$2 source=$3
    shift 3
    "$@" $warnings "$source" -o "$hosts/$name" $flags
    same "$hosts/$name" "$example"
}
flags="$(pkg-config --cflags --libs sins) -Wl,-rpath,$moved/lib"
built minimal minimal c_examples/minimal.c cc -std=c99
built cpp_host cpp_host c_examples/cpp_host.cpp c++ -std=c++11
equal "libsins.so.$abi" "$(needs "$hosts/minimal")" "what minimal needs"
flags="$(pkg-config --static --cflags --libs sins) -static"
built minimal_static minimal c_examples/minimal.c cc -std=c99
built cpp_host_static cpp_host c_examples/cpp_host.cpp c++ -std=c++11
flags="-DSINS_STATIC $(pkg-config --cflags sins) $moved/lib/libsins.a -lpthread -ldl -lm"
built minimal_archive minimal c_examples/minimal.c cc -std=c99
equal "" "$(needs "$hosts/minimal_archive")" "what minimal with libsins.a needs"

# cmake_hosts FOLDER ARGUMENTS...: builds and checks the four programs of tests/install.
cmake_hosts() {
    local folder=$1
    shift
    cmake -S tests/install -B "$folder" "$@"
    cmake --build "$folder"
    for example in minimal cpp_host; do
        same "$folder/${example}_sins" $example
        same "$folder/${example}_static" $example
        equal "libsins.so.$abi" "$(needs "$folder/${example}_sins")" "what ${example}_sins needs"
        equal "" "$(needs "$folder/${example}_static")" "what ${example}_static needs"
    done
}

echo "== find_package"
cmake_hosts "$hosts/installed" -DCMAKE_PREFIX_PATH="$moved"
grep -F "sins_DIR:PATH=$moved/" "$hosts/installed/CMakeCache.txt" || fail "find_package found another sins"

echo "== add_subdirectory" # with the libraries that cargo built above
cmake_hosts "$hosts/together" -DSINS_SOURCE="$PWD" -DSINS_CARGO_TARGET_DIR="$out/build/cargo"

echo "== Windows by a cross compiler: configured"
for processor in x86_64 i686; do
    need "gcc-mingw-w64-${processor/_/-}" $processor-w64-mingw32-gcc
    if ! rustup target add $processor-pc-windows-gnu; then
        could_not "configuring for $processor Windows" "no Rust for it to be had"
        continue
    fi
    cmake -S . -B "$hosts/$processor" -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_SYSTEM_PROCESSOR=x86_64 \
        -DCMAKE_C_COMPILER=$processor-w64-mingw32-gcc
    grep -rqF "target $processor-pc-windows-gnu" "$hosts/$processor/CMakeFiles" || fail "not built for $processor Windows"
done
report_not_run
