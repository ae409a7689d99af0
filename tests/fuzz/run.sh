#!/usr/bin/env bash
# Runs every fuzz target for SECONDS (default 20), from its stored corpus. New inputs with more coverage and inputs that fail are
# left in target/fuzz. KEEP=1 reduces the corpus to the fewest and smallest inputs with the same coverage. Targets that could not
# run are reported at the end.
#
#     tests/fuzz/run.sh [SECONDS [TARGET...]]
#
# A target is a program of fuzz_targets and its folder in corpus. random_calls does not use libFuzzer: it needs only stable Rust and
# runs at full speed, from seed FIRST (default 0).
# SANITIZER=none builds the libFuzzer targets without a sanitizer: twice as fast. SANITIZER=address also builds random_calls with
# AddressSanitizer.
set -euo pipefail
cd "$(dirname "$0")/../.."
. tests/support/need.sh

seconds=${1:-20}
shift || true
targets=${*:-scene_text scene_values log_text calls snapshots random_calls}
triple=x86_64-unknown-linux-gnu
# An execution frees less than 16 MB. With the default of 256 MB, its memory comes fresh from the kernel: half as many executions.
export ASAN_OPTIONS=quarantine_size_mb=16${ASAN_OPTIONS:+:$ASAN_OPTIONS}
folder=$PWD/target/fuzz
findings=$folder/findings
mkdir -p "$findings"

# fuzz TARGET PROGRAM OPTIONS...
fuzz() {
    local kept=tests/fuzz/corpus/$1 new=$folder/corpus/$1
    mkdir -p "$new"
    echo "== fuzzing $1, $seconds s"
    "$2" -max_total_time="$seconds" -timeout=60 -max_len=8192 -len_control=0 -print_final_stats=1 -verbosity=0 "${@:3}" \
        -artifact_prefix="$findings/$1-" "$new" "$kept"
    if [ -n "${KEEP:-}" ]; then
        rm -rf "$folder/fewest"
        mkdir "$folder/fewest"
        "$2" -set_cover_merge=1 -use_counters=0 -verbosity=0 "$folder/fewest" "$kept" "$new"
        rm -f "$kept"/*
        cp "$folder"/fewest/* "$kept"
    fi
}

# build TOOLCHAIN FLAGS FOLDER OPTIONS...
build() {
    RUSTFLAGS=$(echo $2) cargo "+$1" build --quiet --release --manifest-path tests/fuzz/Cargo.toml --target "$triple" \
        --target-dir "target/$3" "${@:4}"
    program=target/$3/$triple/release
}

# instrumented TARGET: builds it like cargo fuzz does, without that tool.
instrumented() {
    local coverage="-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4
        -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table
        -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=1 --cfg fuzzing"
    if [ "${SANITIZER:-address}" = none ]; then
        build "$nightly" "$coverage" fuzz-coverage --bin "$1"
    else
        build "$nightly" "-Zsanitizer=address $coverage" sanitizers --bin "$1"
    fi
}

random_calls() {
    if [ "${SANITIZER:-none}" = address ]; then
        instrumented random_calls
    else
        build stable "" fuzz-plain --no-default-features --bin random_calls
    fi
    echo "== random calls, $seconds s"
    "$program/random_calls" --seconds "$seconds" --first "${FIRST:-0}" --folder "$findings"
}

for target in $targets; do
    if [ "$target" = random_calls ] && [ "${SANITIZER:-none}" != address ]; then
        random_calls
        continue
    fi
    need g++ g++
    if ! has_nightly; then
        could_not "fuzzing of $target" "no nightly Rust to be had"
    elif [ "$target" = random_calls ]; then
        random_calls
    else
        instrumented "$target"
        fuzz "$target" "$program/$target"
    fi
done
report_not_run
