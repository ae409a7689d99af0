#!/usr/bin/env bash
# The commands of README.md and docs, as printed there; scripts that need arguments state them. Compilers of other languages are used if
# they are installed, as after tests/hosts.sh.
#
# SINS_LIB_DIR: a folder with libsins.so, its `bindings` and the program sins of the same build, used instead of building them.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/built.sh

# says_usage SCRIPT ARGUMENT...
says_usage() {
    local status=0 said
    said=$("$@" 2>&1) || status=$?
    [ "$status" -eq 2 ] && [[ $said == "usage: $1 "* ]] || { echo "$*: ends with $status: $said" >&2; exit 1; }
}
for script in release/{fmu,manual}.sh; do says_usage "$script"; done
for script in release/{linux,windows}.sh apps/emulator/build.sh tests/loading.sh; do
    says_usage "$script"
    says_usage "$script" x86_64
done

need python3 /usr/bin/python3
for package in numpy matplotlib; do
    need "python3-$package" "/usr/lib/python3/dist-packages/$package/__init__.py"
done
build_program
if [ -z "${SINS_LIB_DIR:-}" ]; then
    # Each build overwrites the other's library.
    mkdir -p target/commands.built
    cp target/release/sins target/commands.built
    build_library
    cp -r target/release/{libsins.so,bindings} target/commands.built
    export SINS_LIB_DIR=$PWD/target/commands.built
fi
c_examples/build.sh >target/commands.build 2>&1 || { cat target/commands.build; exit 1; }
/usr/bin/python3 tests/commands.py "$SINS_LIB_DIR" target/commands
