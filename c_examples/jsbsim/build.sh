#!/usr/bin/env bash
# Builds libJSBSim and the host into target/jsbsim. JSBSim comes from its source distribution on PyPI, which includes aircraft and
# engines. The project contains no part of it. The first build takes some minutes.
# SINS_LIB_DIR: a folder with a libsins.so, used instead of building one.
# Exit status 2: the source is not available.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/support/need.sh

version=1.3.3
sha256=7b2b1f5dc3728f9c5fd98dc95da23c0b12fc31306142373f6d612ebf1a49f899
out=$PWD/target/jsbsim
archive=$out/jsbsim-$version.tar.gz
need g++ c++
need cmake cmake
need make make

if ! [ -e "$archive" ]; then
    need python3-pip pip3 || exit 2
    mkdir -p "$out/fetched"
    pip3 download --quiet --no-deps --no-binary jsbsim --dest "$out/fetched" "jsbsim==$version" || exit 2
    (cd "$out/fetched" && echo "$sha256  jsbsim-$version.tar.gz" | sha256sum --check --quiet)
    rm -rf "$out/source" "$out/build"
    mkdir "$out/source"
    tar -xzf "$out/fetched/jsbsim-$version.tar.gz" --strip-components 1 -C "$out/source"
    mv "$out/fetched/jsbsim-$version.tar.gz" "$archive" # last, so that an existing archive is complete
fi

# This file defines a macro "min", which would affect the files that are compiled together with it.
output=$out/source/src/input_output/FGOutputFG.cpp
grep -qx '#undef min' "$output" || echo '#undef min' >>"$output"
# SKBUILD: builds like the Python package, without the parts that the source distribution lacks. A unity build takes half the time.
cmake -S "$out/source" -B "$out/build" -DSKBUILD=ON -DBUILD_DOCS=OFF -DBUILD_PYTHON_MODULE=OFF -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_UNITY_BUILD=ON >"$out/log"
cmake --build "$out/build" --target libJSBSim --parallel "$(nproc)" >>"$out/log" 2>&1 || { tail "$out/log"; exit 1; }

if [ -z "${SINS_LIB_DIR:-}" ]; then
    cargo rustc --quiet --release --lib --crate-type cdylib
    SINS_LIB_DIR=target/release
fi
cp "$SINS_LIB_DIR/libsins.so" "$out/libsins.so.1"
c++ -std=c++17 -O2 -Wall -Wextra -Wpedantic -Werror -Iinclude -isystem "$out/source/src" c_examples/jsbsim/host.cpp \
    -o "$out/host" "$out/build/src/libJSBSim.a" -L"$out" -l:libsins.so.1 '-Wl,-rpath,$ORIGIN'
echo "built: target/jsbsim/host"
