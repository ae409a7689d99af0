#!/usr/bin/env bash
# Cost of the effects of the sensors, in instructions by callgrind, which do not depend on the speed of the machine.
#   effects.sh            prints the table: the cost that each effect adds to a step, with times; as Markdown
#   effects.sh --check    checks that effects that are off cost nothing: with ideal sensors, a step takes as many instructions as
#                         with a library that is built without any effect, within 0.5 %
set -euo pipefail
cd "$(dirname "$0")"
source counting.sh

table() {
    local names name count
    cargo build --release --quiet --bin effects
    names=$(target/release/effects names)
    while read -r name; do
        count=$(per_step 500 1500 target/release/effects fly "$name")
        echo "$name;$count"
    done <<<"$names" >target/effects.txt
    target/release/effects table target/effects.txt
}

limit=0.5

# counts SCENE...: instructions of a step in each scene, with the library that was built last.
counts() {
    local scene count
    for scene in "$@"; do
        count=$(per_step 500 1500 target/release/steps "$scene")
        echo "$scene $count"
    done
}

check() {
    local status=0 scene off without
    cargo build --release --quiet --bin steps
    counts ideal free >target/off.txt
    SINS_BARE=1 cargo build --release --quiet --bin steps
    counts ideal free >target/bare.txt
    printf '%-12s %10s %10s %8s\n' scene off bare %
    while read -r scene without; do
        off=$(sed -n "s/^$scene //p" target/off.txt)
        awk -v scene="$scene" -v off="$off" -v without="$without" -v limit=$limit 'BEGIN {
            excess = 100 * (off - without) / without
            printf "%-12s %10d %10d %8.2f\n", scene, off, without, excess
            exit (excess > limit || excess < -limit)
        }' || status=1
    done <target/bare.txt
    [ $status -eq 0 ] || echo "effects that are off cost more than $limit %" >&2
    return $status
}

case ${1:-} in
--check) check ;;
"") table ;;
*)
    sed -n '2,/^set/{/^#/p}' "$0" >&2
    exit 2
    ;;
esac
