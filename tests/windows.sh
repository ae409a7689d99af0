#!/usr/bin/env bash
# The DLL of the release under wine, and the programs of tests/c with it. 32-bit wine comes in an i386 Debian of its own under
# target, which WINE32=1 makes (700 MB; it needs root). What cannot be had is told at the end.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh

programs="digests float_environment misuse sentences run threads destroyed"
chroot=$PWD/target/i386
export WINEDEBUG=-all WINEPREFIX=$PWD/target/wine

# dll PROCESSOR FOLDER: the DLL, the programs, and what wine lacks.
dll() {
    local target=$1-pc-windows-gnu compiler=$1-w64-mingw32-gcc
    need "gcc-mingw-w64-$(echo "$1" | tr _ -)" "$compiler"
    rustup target add "$target"
    cargo rustc --quiet --release --lib --crate-type cdylib --target "$target"
    mkdir -p "$2"
    cp "target/$target/release/sins.dll" "$2"
    "$compiler" -shared -Wl,--kill-at -o "$2/bcryptprimitives.dll" tests/c/bcryptprimitives.c
    for name in $programs; do
        "$compiler" -std=c99 -D__USE_MINGW_ANSI_STDIO=1 -O1 -I include "tests/c/$name.c" -o "$2/$name.exe" \
            "target/$target/release/libsins.dll.a" -static -lpthread
    done
}

# run_in FOLDER WINE...: the programs.
run_in() {
    local folder=$1
    shift
    for name in $programs; do
        "$@" "$folder/$name.exe"
    done
}

echo "== 64 bits"
if ! [ -x /usr/lib/wine/wine64 ] && ! install wine64; then
    could_not "64-bit Windows" "no wine to be had"
else
    dll x86_64 target/windows/64
    run_in target/windows/64 /usr/lib/wine/wine64
fi

echo "== 32 bits"
if ! [ -x "$chroot/usr/lib/wine/wine" ] && [ "${WINE32:-}" = 1 ]; then
    need debootstrap debootstrap
    as_root debootstrap --arch=i386 --variant=minbase --include=wine32,wine bookworm "$chroot" ||
        could_not "32-bit Windows" "no i386 Debian to be had"
fi
if [ -x "$chroot/usr/lib/wine/wine" ]; then
    dll i686 "$chroot/programs"
    # wine finds itself through /proc.
    run_in /programs as_root unshare --mount sh -c 'mount -t proc proc "$0/proc" && exec chroot "$0" "$@"' "$chroot" \
        env HOME=/root WINEDEBUG=-all /usr/lib/wine/wine
elif [ "${WINE32:-}" != 1 ]; then
    could_not "32-bit Windows" "there is no 32-bit wine in $chroot; WINE32=1 tests/windows.sh makes it"
fi
report_not_run
