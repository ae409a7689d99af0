#!/usr/bin/env bash
# Tests of the Functional Mock-up Unit. With FMPy from PyPI: its validator and the schema of the standard, flights compared with
# the program to the bit, states, many instances, bad inputs. With a master in C (fmu/host.c): every platform that the unit has a
# binary for. With Ecos from PyPI: coupled with another unit. Tests that could not run are reported at the end.
#
#     tests/fmu.sh                                        with a unit that has this machine's binary
#     release/fmu.sh OUT && FMU=OUT/sins.fmu tests/fmu.sh with the unit of the release
#
# SINS_LIB_DIR: a folder with a program sins, used instead of building it.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/wine.sh
. tests/support/built.sh
. tests/support/folders.sh

folder=$PWD/target/fmu
mkdir -p "$folder"
need g++ c++
need unzip unzip
need python3-venv /usr/share/doc/python3-venv

build_program
is_of_release=${FMU:-}
if [ -z "${FMU:-}" ]; then
    FMU=$folder/sins.fmu
    cargo build --quiet --release -p sins-fmu --lib
    cargo build --quiet --profile unoptimised -p sins-fmu --bin pack-fmu
    for unit in "$FMU" "$folder/again.fmu"; do
        target/unoptimised/pack-fmu "$unit" binaries/linux64/sins_fmu.so=target/release/libsins_fmu.so
    done
    cmp "$FMU" "$folder/again.fmu"
fi

# from_pypi VENV PACKAGE...: makes a Python environment with these packages.
from_pypi() {
    [ -x "$folder/$1/bin/python" ] || python3 -m venv "$folder/$1"
    "$folder/$1/bin/pip" install --quiet --disable-pip-version-check "${@:2}"
}

echo "== FMPy"
if from_pypi venv fmpy==0.3.32 numpy; then
    "$folder/venv/bin/python" tests/fmu/fly.py "$FMU" "$folder" "$built/sins"
    # The program of docs/fmu.md runs in a folder with the files that it names.
    sed -n '/^```python$/,/^```$/{/^```/d;p}' docs/fmu.md >"$folder/ten_lines.py"
    ln -sfn "$PWD/c_examples" "$folder/c_examples"
    [ "$FMU" -ef "$folder/sins.fmu" ] || cp "$FMU" "$folder/sins.fmu"
    found=$(cd "$folder" && venv/bin/python ten_lines.py 2>/dev/null | tail -n1)
    grep -qF "# $found" docs/fmu.md || { echo "docs/fmu.md: its program prints $found" >&2; exit 1; }
    python3 tests/fmu/draw.py "$folder/errors.csv" "$folder/fmu.svg"
    cmp "$folder/fmu.svg" docs/fmu.svg
else
    could_not "the Functional Mock-up Unit by FMPy" "no FMPy to be had"
fi

echo "== Ecos"
if need libtbb12 /usr/lib/x86_64-linux-gnu/libtbb.so.12 && from_pypi ecos ecospy==0.7.2 pythonfmu==0.7.0; then
    PATH=$folder/ecos/bin:$PATH python tests/fmu/couple.py "$FMU" "$folder" "$built/sins"
else
    could_not "the Functional Mock-up Unit by Ecos" "no Ecos to be had"
fi

# The name of the folder has non-ASCII letters; the unit gets it as a URI.
unit="$folder/Übungsflüge 100 %"
rm -rf "$unit"
unzip -q "$FMU" -d "$unit"
# What cargo alone builds names the folders of its crates.
[ -z "$is_of_release" ] || name_no_folder "$unit"
uri=$(python3 -c 'import pathlib, sys; print(pathlib.Path(sys.argv[1], "resources").as_uri())' "$unit")
cp "$unit/modelDescription.xml" "$folder"
digest=

# host PLATFORM "COMPILER OPTION" URI RUNNER...: the digest must equal that of the first platform.
host() {
    local found
    rm -f "$folder"/sins_fmu.*
    cp "$unit/binaries/$1"/sins_fmu.* "$folder"
    ${2% *} -std=c99 -O2 -Wall -Wextra -Wpedantic -Werror tests/fmu/host.c -o "$folder/host_$1.exe" "${2#* }"
    found=$(cd "$folder" && "${@:4}" "./host_$1.exe" ./sins_fmu.* modelDescription.xml "$3" 2>"$folder/log" | tr -d '\r') ||
        { cat "$folder/log"; exit 1; }
    echo "$1: $found"
    [ "${digest:=$found}" = "$found" ] || { echo "$1: not the $digest of the first platform" >&2; exit 1; }
}

echo "== a master in C"
for platform in $(ls "$unit/binaries"); do
    case $platform in
        linux64) host linux64 "cc -ldl" "$uri" env ;;
        aarch64-linux)
            need gcc-aarch64-linux-gnu aarch64-linux-gnu-gcc
            need libc6-dev-arm64-cross /usr/aarch64-linux-gnu/lib/libc.so
            need qemu-user qemu-aarch64
            host aarch64-linux "aarch64-linux-gnu-gcc -ldl" "$uri" qemu-aarch64 -L /usr/aarch64-linux-gnu
            ;;
        win64 | win32)
            processor=x86_64
            [ "$platform" = win64 ] || processor=i686
            need "gcc-mingw-w64-$(echo "$processor" | tr _ -)" "$processor-w64-mingw32-gcc"
            if "$processor-w64-mingw32-objdump" -p "$unit/binaries/$platform/sins_fmu.dll" | grep -w sins_create; then
                echo "$platform: exports functions of the library" >&2
                exit 1
            fi
            if have_wine "$processor"; then
                host "$platform" "$processor-w64-mingw32-gcc -static" "file:///Z:${uri#file://}" "$wine"
            fi
            ;;
    esac
done
report_not_run
