#!/usr/bin/env bash
# The programs of tests/c with the library under AddressSanitizer, ThreadSanitizer and valgrind. Each tool must first find a planted
# mistake. The first two need nightly Rust. Tests that could not run, or take too long to build, are reported at the end.
#
#     tests/sanitizers.sh [memory] [address] [thread]     default: all; memory is valgrind
#
# SINS_LIB_DIR: a folder with a libsins.so, used for valgrind instead of building one.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/built.sh

target=x86_64-unknown-linux-gnu
folder=$PWD/target/sanitizers/programs
sanitized=target/sanitizers/$target/debug
longest_build_s=900
addressed="misuse struct_sizes sentences run snapshot ensemble recommend budget threads destroyed"
# Programs with short flights: valgrind takes minutes for the others.
checked="misuse sentences run snapshot ensemble"
mkdir -p "$folder"
need g++ c++
need valgrind valgrind

# compile NAME FLAGS...
compile() {
    local name=$1
    shift
    gcc -std=c99 -g -O1 -I include "tests/c/$name.c" -o "$folder/$name" "$@" -lpthread -ldl -lm
}

# clean COMMAND...: must succeed and print no complaint.
clean() {
    echo "$*"
    "$@" 2>"$folder/complaints" && [ ! -s "$folder/complaints" ] || { cat "$folder/complaints"; exit 1; }
}

# finds PATTERN COMMAND...: the tool must stop the program and name the mistake.
finds() {
    local pattern=$1
    shift
    echo "$* (planted)"
    if "$@" >/dev/null 2>"$folder/complaints" || ! grep -q "$pattern" "$folder/complaints"; then
        cat "$folder/complaints"
        echo "the planted mistake was not found"
        exit 1
    fi
}

# library SANITIZER CRATE_TYPE OPTIONS...: builds the instrumented library with the function that injects a panic. Fails if the
# build takes too long.
library() {
    local status=0
    RUSTFLAGS="-Zsanitizer=$1 --cfg sins_fault_injection" timeout "$longest_build_s" cargo "+$nightly" rustc --quiet --lib \
        --crate-type "$2" --target "$target" --target-dir target/sanitizers --config profile.dev.opt-level=1 "${@:3}" || status=$?
    if [ "$status" -eq 124 ]; then
        could_not "the $1 sanitizer" "its build took more than $longest_build_s s"
        return 1
    fi
    [ "$status" -eq 0 ] || exit "$status"
}

address() {
    library address cdylib || return 0
    cp "$sanitized/libsins.so" "$folder/libsins.so"
    for name in planted $addressed panic; do
        compile "$name" -fsanitize=address,undefined -fno-sanitize-recover=all -L "$folder" -lsins -Wl,-rpath,"$folder"
    done
    finds heap-buffer-overflow "$folder/planted" overrun
    for name in $addressed; do
        clean "$folder/$name"
    done
    cp "$sanitized/libsins.so" "$folder/second.so"
    clean "$folder/panic" "$folder/second.so"
}

# The standard library must be instrumented too, because its locks are not seen otherwise. Programs run without address
# randomisation: the shadow memory of ThreadSanitizer has a fixed place.
thread() {
    library thread staticlib -Zbuild-std || return 0
    local runtime
    runtime=$(rustc "+$nightly" --print sysroot)/lib/rustlib/$target/lib/librustc-nightly_rt.tsan.a
    for name in planted threads destroyed; do
        compile "$name" -DSINS_STATIC -fsanitize=thread -c
        mv "$folder/$name" "$folder/$name.o"
        gcc -rdynamic "$folder/$name.o" "$sanitized/libsins.a" -Wl,--whole-archive "$runtime" -Wl,--no-whole-archive \
            -o "$folder/$name" -lpthread -ldl -lm -lgcc_s
    done
    finds "data race" setarch -R "$folder/planted" race
    for name in threads destroyed; do
        clean setarch -R "$folder/$name"
    done
}

memory() {
    build_library
    cp "$built/libsins.so" "$folder/libsins.so"
    local valgrind=(valgrind --quiet --error-exitcode=9 --leak-check=full --errors-for-leak-kinds=definite,indirect)
    for name in planted $checked; do
        compile "$name" -L "$folder" -lsins -Wl,-rpath,"$folder"
    done
    finds "uninitialised" "${valgrind[@]}" "$folder/planted" uninitialized
    for name in $checked; do
        clean "${valgrind[@]}" "$folder/$name"
    done
}

[ $# -gt 0 ] || set -- memory address thread
for tool; do
    if [ "$tool" = memory ] || has_nightly; then
        $tool
    else
        could_not "the $tool sanitizer" "no nightly Rust to be had"
    fi
done
report_not_run
