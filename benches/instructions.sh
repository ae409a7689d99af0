#!/usr/bin/env bash
# Instructions of a step by callgrind; they do not depend on the speed of the machine. Without an argument: of the whole chain
# through sins_run. With `matrix`: of push and step for each scheme, number of subsamples and axes, as CSV for
# `sins curve --instructions`. With `ensemble`: of simulation 2 alone, and in ensembles of several numbers of runs.
set -euo pipefail
cd "$(dirname "$0")"
source counting.sh
cargo build --release --quiet --bin steps
row() {
    local count
    count=$(per_step 500 1500 target/release/steps "$1")
    echo "$1,$count"
}
if [ "${1:-}" = matrix ]; then
    echo scheme,subsamples,updates_per_sample,frame,instructions_per_step
    for frame in earth geographic; do
        for rung in paper,{1,2},1 exact,{1..5},1 polynomial,{1..5},1; do
            row "$rung,$frame"
        done
    done
    row exact,2,2,earth
    row polynomial,4,2,earth
elif [ "${1:-}" = ensemble ]; then
    alone=$(per_step 500 1500 target/release/steps simulation2)
    echo "a simulator: $alone instructions a step"
    for runs in 1 2 3 4 5 8 16 17 18 33; do
        count=$(per_step 500 1500 target/release/steps "runs,$runs")
        share=$(awk "BEGIN { printf \"%.2f\", $count / $runs / $alone }")
        echo "$runs runs: $count instructions a step; a run takes $share of a simulator's"
    done
else
    for what in simulation2 calls reads nav shown align att record ideal free; do
        count=$(per_step 10000 20000 target/release/steps $what)
        echo "$what: $count instructions a step"
    done
    for what in save load; do
        count=$(per_step 100 1100 target/release/steps $what)
        echo "$what: $count instructions a snapshot of simulation 2"
    done
fi
