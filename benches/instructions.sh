#!/usr/bin/env bash
# Instructions of a step by callgrind; they do not depend on the speed of the machine. Without an argument: of the whole chain
# through sins_run. With `matrix`: of push and step for each scheme, number of subsamples and axes, as CSV for
# `sins curve --instructions`. With `ensemble`: of simulation 2 alone, and in ensembles of several numbers of runs. With `--check`:
# whether some of these have grown by more than 2 % since .ci/all passed, which keeps them in .ci/instructions.txt; a new count is
# written to benches/target/instructions.txt.
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
elif [ "${1:-}" = --check ]; then
    for what in simulation2 calls nav align att runs,1 runs,17; do
        steps="5000 10000"
        [[ $what != runs* ]] || steps="500 1500"
        # shellcheck disable=SC2086
        count=$(per_step $steps target/release/steps "$what")
        echo "$what $count"
    done >target/instructions.txt
    awk -v limit=2 '
        NR == FNR { before[$1] = $2; next }
        !($1 in before) { printf "%-12s %10d, new\n", $1, $2; next }
        {
            change = 100 * ($2 / before[$1] - 1)
            printf "%-12s %10d, %+.2f %%\n", $1, $2, change
            grown += change > limit
        }
        END { if (grown) print "instructions have grown by more than " limit " %: mend it, or renew .ci/instructions.txt and say why" }
        END { exit grown > 0 }' ../.ci/instructions.txt target/instructions.txt
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
