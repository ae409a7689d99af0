#!/usr/bin/env bash
# Builds the library for Windows 7 and later into OUT: sins.dll, sins.def, and the import libraries sins.lib (for MSVC) and
# libsins.dll.a (for mingw). With a third argument "program", also sins.exe; with "unit", only the binary of the Functional
# Mock-up Unit (release/fmu.sh).
#
#     release/windows.sh x86_64|i686 OUT [program|unit]
#
# Uses nightly Rust, because only its -Zbuild-std builds the standard library for Windows 7. The standard library of
# *-pc-windows-gnu imports bcryptprimitives.dll and functions of Windows 10.
set -euo pipefail
[ $# -ge 2 ] || { echo "usage: $0 x86_64|i686 OUT [program|unit]" >&2; exit 2; }
mkdir -p "$2"
out=$(cd "$2" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh

arch=$1 target=$1-win7-windows-gnu mingw=$1-w64-mingw32
case $arch in
    x86_64) machine=i386:x86-64 ;;
    i686) machine=i386 ;;
    *) echo "release/windows.sh: processor $arch: must be x86_64 or i686" >&2; exit 2 ;;
esac
# The other variant, posix, has threads of its own in each DLL: a DLL that is loaded when no TLS index is free then aborts its host.
need "gcc-mingw-w64-$(echo "$arch" | tr _ -)-win32" "$mingw-gcc-win32"
need llvm llvm-dlltool
has_nightly

linker=CARGO_TARGET_$(tr a-z- A-Z_ <<<"$target")_LINKER
# All builds use the unit's linker: with another linker, cargo would build everything again, including the standard library.
export RELATIVE_LINKER=$mingw-gcc-win32 UNIT_LINKER=$PWD/release/relative_linker.sh "$linker=$PWD/release/fmu_linker.sh"
built=target/$target/release
work=target/release-windows/$arch
mkdir -p "$work"

# resource FILE KIND DESCRIPTION: makes an object to link with the version information that Explorer shows. This is not in
# build.rs, because a build on Windows would then need windres.
resource() {
    local numbers
    numbers=$(echo "$version" | cut -d- -f1 | tr . ,),0
    cat >"$work/$1.rc" <<RC
1 VERSIONINFO
FILEVERSION $numbers
PRODUCTVERSION $numbers
FILEFLAGSMASK 0x3F
FILEFLAGS 0
FILEOS 0x40004
FILETYPE $2
BEGIN
    BLOCK "StringFileInfo"
    BEGIN
        BLOCK "040904B0"
        BEGIN
            VALUE "FileDescription", "$3"
            VALUE "FileVersion", "$version"
            VALUE "InternalName", "sins"
            VALUE "LegalCopyright", "$(sed -n 's/^Copyright //p' LICENSE-MIT). MIT OR Apache-2.0"
            VALUE "OriginalFilename", "$1"
            VALUE "ProductName", "sins"
            VALUE "ProductVersion", "$version"
        END
    END
    BLOCK "VarFileInfo"
    BEGIN
        VALUE "Translation", 0x409, 1200
    END
END
RC
    "$mingw-windres" "$work/$1.rc" "$work/$1.o"
}

# build FILE OPTION...
build() {
    local object=$PWD/$work/$1.o
    shift
    CARGO_ENCODED_RUSTFLAGS=$(flags "$nightly" -Clink-arg=-Wl,--no-insert-timestamp -Cstrip=symbols) \
        cargo "+$nightly" rustc --quiet --locked --release -Zbuild-std=std,panic_unwind --target "$target" "$@" -- \
        -Clink-arg="$object"
}

if [ "${3:-}" = unit ]; then
    resource sins_fmu.dll 2 "Functional Mock-up Unit of the strapdown inertial navigation system simulator"
    build sins_fmu.dll --package sins-fmu --lib --crate-type cdylib
    cp "$built/sins_fmu.dll" "$out"
    exit
fi

resource sins.dll 2 "Strapdown inertial navigation system simulator"
build sins.dll --lib --crate-type cdylib
cp "$built/sins.dll" "$out"

{ printf 'LIBRARY sins.dll\nEXPORTS\n'; functions | sed 's/^/    /'; } >"$out/sins.def"
llvm-dlltool -m "$machine" -d "$out/sins.def" -l "$out/sins.lib"
# Each tool makes the import library of its own linker. The archive contains the names of this tool's temporary and output files.
(cd "$work" && "$mingw-dlltool" --deterministic-libraries --temp-prefix sins -d "$out/sins.def" -l libsins.dll.a)
mv "$work/libsins.dll.a" "$out"

if [ "${3:-}" = program ]; then
    resource sins.exe 1 "Flies scenes of the strapdown inertial navigation system simulator"
    build sins.exe --package sins-cli --bin sins
    cp "$built/sins.exe" "$out"
fi
