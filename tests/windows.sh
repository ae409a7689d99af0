#!/usr/bin/env bash
# The released DLLs (release/windows.sh) under wine, 64 and 32 bits, and the programs of tests/c with them. Tests that could not
# run are reported at the end.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/wine.sh
. tests/support/pe.sh
. release/build.sh

programs="digests float_environment misuse sentences run ensemble threads destroyed tls_indexes unload terminated"
need g++ c++

# dll PROCESSOR FOLDER: builds the released DLL, checks it for the loader, and builds the programs.
dll() {
    local compiler=$1-w64-mingw32-gcc
    release/windows.sh "$1" "$2"
    check_pe "$2/sins.dll" "$1" kernel32.dll msvcrt.dll ntdll.dll
    cp "$2/sins.dll" "$2/second.dll"
    for name in $programs; do
        "$compiler" -std=c99 -D__USE_MINGW_ANSI_STDIO=1 -O1 -I include "tests/c/$name.c" -o "$2/$name.exe" \
            "$2/libsins.dll.a" -static -lpthread
    done
}

# run_in FOLDER PROCESSOR: runs the programs, each with two copies of the DLL to load, and the hosts that load it. One wine server
# runs for all of them. The first program makes wine create or update its own folder. Wine then prints messages about fonts and
# windows, which are shown only if a program fails.
run_in() {
    "$WINESERVER" -p60 >/dev/null 2>&1 || true # fails if a server already runs
    "$wine" "$1/sentences.exe" >"$WINEPREFIX/log" 2>&1 || true
    for name in $programs; do
        "$wine" "$1/$name.exe" "$1/sins.dll" "$1/second.dll" || { echo "$name ended with $?"; cat "$WINEPREFIX/log"; exit 1; }
    done
    tests/loading.sh "$2-w64-mingw32-gcc -std=c99" "$1/sins.dll" "$wine"
}

echo "== 64 bits"
if have_wine x86_64; then
    dll x86_64 target/windows/64
    run_in target/windows/64 x86_64
fi

echo "== 32 bits"
if have_wine i686; then
    dll i686 target/windows/32
    run_in target/windows/32 i686
fi
report_not_run
