#!/usr/bin/env bash
# c_examples/loadlibrary.c flies with a library, also with one without scenes and with one in a folder with non-ASCII letters. It
# prints one sentence for each file that it cannot use.
#
#     tests/loading.sh COMPILER LIBRARY [RUNNER...]
#
# COMPILER: a compiler with its options, for the library's system and word size. RUNNER: runs its programs if this machine cannot.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh

[ $# -ge 2 ] || { echo "usage: $0 COMPILER LIBRARY [RUNNER...]" >&2; exit 2; }
compiler=$1 library=$(realpath "$2")
runner=("${@:3}")
machine=$($compiler -dumpmachine)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export LC_ALL=C.UTF-8 # the names of files, for wine

# host NAME OPTION...: builds the host with the compiler and these options.
host() {
    $compiler -O2 -Wall -Wextra -Wpedantic -Werror -I include -o "$folder/$1" "${@:2}" c_examples/loadlibrary.c $system
}

# shared NAME COMPILER TEXT: builds a library from a C source.
shared() {
    echo "$3" >"$folder/source.c"
    $2 -shared -fPIC -o "$folder/$1$dll" "$folder/source.c"
}

# without NAME SED_COMMAND: copies the library and renames functions in it, so that they are not found.
without() {
    sed "$2" "$library" >"$folder/$1$dll"
}

answer() {
    (cd "$folder" && LD_LIBRARY_PATH=. "${runner[@]}" "./$program" "$@" 2>&1 | tr -d '\r')
}

# flies SCENES ARGUMENT...: the host must print the digest of docs/hosts.md.
flies() {
    expect 0 "sins $version, $1 scenes, in a program of $bits bits"$'\n'"$digest" "${@:2}"
}

# says SENTENCE FILE: the host must print only this sentence.
says() {
    expect 1 "loadlibrary: $2: $1" "$2"
}

# expect STATUS TEXT ARGUMENT...
expect() {
    local status=0 text
    text=$(answer "${@:3}") || status=$?
    if [ "$status" -ne "$1" ] || [ "$text" != "$2" ]; then
        printf '%s %s\n  expected (%s): %s\n  found (%s): %s\n' "$program" "${*:3}" "$1" "$2" "$status" "$text" >&2
        exit 1
    fi
}

version=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
digest=$(sed -n 's/^ *\(60 s of a turn, digest [0-9a-f]*\)$/\1/p' docs/hosts.md)
bits=32 other=x86_64-w64-mingw32-gcc
case $machine in x86_64* | aarch64*) bits=64 other=i686-w64-mingw32-gcc ;; esac

case $machine in
    *mingw*)
        system=-municode end=.exe dll=.dll name=sins.dll
        need "gcc-mingw-w64-$(sed 's/-w64.*//; s/_/-/' <<<"$other")" "$other"
        shared other_size "$other" "int other;"
        missing="no such file, or a DLL that it needs is missing (Windows error 126)"
        text="not a DLL for programs of $bits bits, as this one is (Windows error 193)"
        other_size=$text
        ;;
    *)
        system=-ldl end="" dll=.so name=libsins.so.1
        # Changes the byte of an ELF file that gives its word size: 1 or 2.
        sed "1s/^\(.ELF\)[\x01\x02]/\1\x$((bits == 64 ? 1 : 2))/" "$library" >"$folder/other_size$dll"
        missing="cannot open shared object file: No such file or directory"
        text="invalid ELF header"
        other_size="wrong ELF class: ELFCLASS$((96 - bits))"
        ;;
esac

# All functions that a library without features lacks, with another letter before their last word, by which exports stay sorted: their
# ends are also those of other names, as that of sins_scene_write is `write`.
without lean "$(sed '1,/SINS_FUNCTIONS_SCENES(X)/d' include/sins_functions.h | sed -nE 's/^ *X\([^,]*, (sins_[a-z_]*)[a-z](_[a-z]+), .*/s\/\\x00\1[a-z]\2\\x00\/\\x00\1z\2\\x00\/g/p')"
without old_engine 's/\x00sins_step\x00/\x00sins_steX\x00/g'
without old_scenes 's/\x00sins_scene_prepare\x00/\x00sins_scene_preparX\x00/g'
export_c='#if defined(__cplusplus)
extern "C"
#endif
#if defined(_WIN32)
__declspec(dllexport)
#endif
'
shared other_abi "$compiler" "${export_c}unsigned sins_abi_version(void) { return 7; }
${export_c}const char *sins_version_string(void) { return \"9.8.7\"; }"
shared foreign "$compiler" "int foreign;"
cp README.md "$folder/text$dll"
cp "$library" "$folder/$name"
mkdir "$folder/Übungsflüge 飛行"
cp "$library" "$folder/Übungsflüge 飛行/$name"

host host$end
program=host$end
flies with
flies with "./Übungsflüge 飛行/$name"
flies without ./lean$dll
says "$missing" ./none$dll
says "$text" ./text$dll
says "$other_size" ./other_size$dll
says "a library, but not sins" ./foreign$dll
says "sins 9.8.7 has version 7 of the interface, this program needs version 1" ./other_abi$dll
says "sins $version is older than this program: it has no function sins_step" ./old_engine$dll
says "sins $version is older than this program: it has no function sins_scene_prepare" ./old_scenes$dll

# Old hosts: x87 arithmetic with 24 bits, as Direct3D sets it, with 53, as Windows sets it, and with 64.
if [ "$bits" -eq 32 ]; then
    for word in 0x07f 0x27f 0x37f; do
        program=host_$word$end
        host "$program" -march=i586 -mno-sse -mfpmath=387 -DCONTROL_WORD=$word tests/c/control_word.c
        flies with
    done
fi
echo "loading, $machine: the host flies, and says what it cannot use"
