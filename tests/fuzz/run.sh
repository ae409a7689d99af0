#!/usr/bin/env bash
# Every fuzz target for so many seconds (20), from its kept corpus. New inputs that reach more and inputs that fail are left in
# target/fuzz; KEEP=1 adds the former to the corpus. What cannot be had is told at the end.
#
#     tests/fuzz/run.sh [SECONDS [TARGET...]]
#
# A target is a program of fuzz_targets (Rust, the library) or a folder with NAME_fuzz.c (C, the harness), and its folder in corpus.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/support/need.sh

seconds=${1:-20}
shift || true
targets=${*:-flight_csv scene calls snapshots}
triple=x86_64-unknown-linux-gnu
folder=$PWD/target/fuzz
mkdir -p "$folder"

# fuzz TARGET PROGRAM OPTIONS...
fuzz() {
    local kept=tests/fuzz/corpus/$1 new=$folder/corpus/$1
    mkdir -p "$new" "$folder/findings"
    echo "== fuzzing $1, $seconds s"
    "$2" -max_total_time="$seconds" -timeout=60 -max_len=8192 -len_control=0 -print_final_stats=1 -verbosity=0 "${@:3}" \
        -artifact_prefix="$folder/findings/$1-" "$new" "$kept"
    if [ -n "${KEEP:-}" ]; then
        "$2" -merge=1 -verbosity=0 "$kept" "$new"
    fi
}

# In C, by clang, which has the engine.
fuzz_c() {
    local sources
    if ! echo 'int LLVMFuzzerTestOneInput() { return 0; }' | clang -fsanitize=fuzzer -x c - -o "$folder/probe" 2>/dev/null; then
        install clang libclang-rt-dev
    fi
    case $1 in
        flight_csv) sources="flight_csv number" libraries= ;;
        scene)
            sources=$(cd c_examples/harness && echo *.c | sed 's/\.c//g')
            cargo rustc --quiet --release --lib --crate-type staticlib
            libraries="target/release/libsins.a -lpthread -ldl"
            ;;
    esac
    clang -std=c99 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -DSINS_STATIC -I include \
        "tests/fuzz/$1/$1_fuzz.c" $(printf 'c_examples/harness/%s.c ' $sources) $libraries -lm -o "$folder/$1"
    fuzz "$1" "$folder/$1" -close_fd_mask=3 # the harness tells what is wrong
}

# As cargo fuzz builds it, without that tool.
fuzz_rust() {
    local sanitizer="-Zsanitizer=address -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4
        -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table
        -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=1 --cfg fuzzing"
    RUSTFLAGS=$(echo $sanitizer) cargo +nightly build --quiet --release --manifest-path tests/fuzz/Cargo.toml --bin "$1" \
        --target "$triple" --target-dir target/sanitizers
    fuzz "$1" "target/sanitizers/$triple/release/$1"
}

need g++ c++
for target in $targets; do
    if [ -d "tests/fuzz/$target" ]; then
        fuzz_c "$target"
    elif rustup run nightly rustc --version >/dev/null 2>&1 || rustup toolchain install nightly --profile minimal; then
        fuzz_rust "$target"
    else
        could_not "fuzzing of $target" "no nightly Rust to be had"
    fi
done
report_not_run
