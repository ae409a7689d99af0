#!/usr/bin/env bash
# Instructions a step, by callgrind: they do not depend on the machine's mood. Without an argument of the whole chain through
# sins_run; with `matrix` of push and step for each scheme, number of subsamples and axes, as CSV for
# `sins_report curve --instructions`.
set -eu
cd "$(dirname "$0")"
cargo build --release --quiet --bin steps
# per_step SHORT LONG WHAT...: the difference of two runs.
per_step() {
    local short=$1 long=$2 count first second
    shift 2
    for count in "$short" "$long"; do
        first=${second:-}
        second=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null target/release/steps "$@" "$count" 2>&1 |
            sed -n 's/.*Collected : //p')
    done
    echo $(((second - first) / (long - short)))
}
row() {
    echo "$1,$(per_step 500 1500 "$1")"
}
if [ "${1:-}" = matrix ]; then
    echo scheme,subsamples,updates_per_sample,frame,instructions_per_step
    for frame in Earth-fixed geographic; do
        for rung in paper,{1,2},1 exact,{1..5},1 polynomial,{1..5},1; do
            row "$rung,$frame"
        done
    done
    row exact,2,2,Earth-fixed
    row polynomial,4,2,Earth-fixed
else
    for what in simulation2 ideal free; do
        echo "$what: $(per_step 10000 20000 $what) instructions a step"
    done
    for what in save load; do
        echo "$what: $(per_step 100 1100 $what) instructions a snapshot of simulation 2"
    done
fi
