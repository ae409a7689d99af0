#!/usr/bin/env bash
# Builds SINS_Emulator.exe: build.sh ARCH OUT, where ARCH is x86_64 or i686. Needs no Rust: the program loads sins.dll from its own
# folder when it starts. For Windows 7 and later, without additional files of the compiler.
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: $0 x86_64|i686 OUT" >&2; exit 2; }
arch=$1
mkdir -p "$2"
out=$(cd "$2" && pwd)
cd "$(dirname "$0")"
. ../../tests/support/need.sh
need "g++-mingw-w64-$(echo "$arch" | tr _ -)-posix" "$arch-w64-mingw32-g++-posix"

parts=$(mktemp -d)
trap 'rm -rf "$parts"' EXIT
version=$(sed -n 's/^version = "\(.*\)"/\1/p' ../../Cargo.toml | head -1)
# No warning about fields that an initializer leaves out: they are zero. -mfpmath=sse: figures equal those of the library to the
# bit, also with 32 bits.
flags="-std=c++20 -O2 -Wall -Wextra -Wpedantic -Wno-missing-field-initializers -Werror -msse2 -mfpmath=sse -D_WIN32_WINNT=0x0601 -DNOMINMAX -DUNICODE -D_UNICODE -I../../include"
flags="$flags -DPROGRAM_VERSION=\"$version\""
printf '#define VERSION_TEXT "%s"\n#define VERSION_NUMBERS %s, 0\n' "$version" "$(echo "${version%%-*}" | sed 's/\./, /g')" >"$parts/version.h"
"$arch-w64-mingw32-windres" -c 65001 -I "$parts" -i emulator.rc -o "$parts/resources.o"
"$arch-w64-mingw32-g++-posix" $flags -I. -municode -mwindows -static -s -Wl,--no-insert-timestamp -o "$out/SINS_Emulator.exe" main.cpp "$parts/resources.o" \
    -lcomctl32 -lcomdlg32 -lgdi32 -lgdiplus -lshell32 -ladvapi32 -luuid -lole32 -lwinmm -lws2_32
