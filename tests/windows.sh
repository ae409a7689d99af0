#!/usr/bin/env bash
# The DLLs that are shipped (release/windows.sh) under wine, 64 and 32 bits, and the programs of tests/c with them. What cannot
# be had is told at the end.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/pe.sh
. release/build.sh

programs="digests float_environment misuse sentences run threads destroyed tls_indexes unload terminated"
wine32=$PWD/target/wine32
export WINEDEBUG=-all
need g++ c++

# dll PROCESSOR FOLDER: the DLL that is shipped, what it is for the loader, and the programs.
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

# run_in FOLDER WINE SERVER PROCESSOR: the programs, each with two copies of the DLL to load, and the hosts that load it; one server
# stays for them. Wine makes or renews its own folder with the first
# that it runs; what it says then of fonts and windows, which they do not have, is told where one of them fails.
run_in() {
    export WINESERVER=$3
    mkdir -p "$WINEPREFIX"
    "$3" -p60 >/dev/null 2>&1 || true # or one is there already
    "$2" "$1/sentences.exe" >"$WINEPREFIX/log" 2>&1 || true
    for name in $programs; do
        "$2" "$1/$name.exe" "$1/sins.dll" "$1/second.dll" || { cat "$WINEPREFIX/log"; exit 1; }
    done
    tests/loading.sh "$4-w64-mingw32-gcc -std=c99" "$1/sins.dll" "$2"
}

# 32-bit wine, unpacked from its packages: no second architecture comes into the packages of this machine, and no root is
# needed. 100 MB to fetch.
fetch_wine32() {
    local apt=$wine32/apt
    rm -rf "$wine32"
    mkdir -p "$apt/lists/partial" "$apt/archives/partial"
    touch "$apt/status"
    cat >"$apt/conf" <<END
APT::Architecture "i386";
APT::Architectures { "i386"; };
APT::Sandbox::User "root";
Dir::State "$apt";
Dir::State::status "$apt/status";
Dir::Cache "$apt";
END
    export APT_CONFIG=$apt/conf
    # A source without i386 fails; what is missing fails in the next line.
    apt-get update -qq || true
    (cd "$apt" && apt-get download -qq wine32 libwine libz-mingw-w64) || return
    unset APT_CONFIG
    for package in "$apt"/*.deb; do
        dpkg-deb -x "$package" "$wine32" || return
    done
    cp "$wine32/usr/i686-w64-mingw32/lib/zlib1.dll" "$wine32/usr/lib/i386-linux-gnu/wine/i386-windows"
    rm -r "$apt"
}

echo "== 64 bits"
if ! [ -x /usr/lib/wine/wine64 ] && ! install wine64; then
    could_not "64-bit Windows" "no wine to be had"
else
    dll x86_64 target/windows/64
    WINEPREFIX=$PWD/target/wine run_in target/windows/64 /usr/lib/wine/wine64 /usr/lib/wine/wineserver64 x86_64
fi

echo "== 32 bits"
wine=$wine32/usr/lib/wine/wine
if ! [ -x "$wine" ] && ! fetch_wine32; then
    could_not "32-bit Windows" "no 32-bit wine to be had"
elif ! need lib32gcc-s1 /usr/lib32/libgcc_s.so.1; then # with the 32-bit C library; wine's threads end by it
    could_not "32-bit Windows" "no 32-bit C library to be had"
elif ! "$wine" --version; then
    could_not "32-bit Windows" "the kernel runs no 32-bit programs"
else
    dll i686 target/windows/32
    WINEARCH=win32 WINEPREFIX=$wine32/prefix run_in target/windows/32 "$wine" "${wine}server32" i686
fi
report_not_run
