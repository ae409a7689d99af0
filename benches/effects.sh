#!/usr/bin/env bash
# Cost of the effects of the sensors, in instructions by callgrind, which do not depend on the speed of the machine.
#   effects.sh            prints the table: the cost that each effect adds to a step, with times; as Markdown
#   effects.sh --check    checks that an effect that is off costs nothing: in each scene without the effect, a step takes as
#                         many instructions as with a library that is built without the effect, within 0.5 %; each effect
#                         alone, and all at once (twenty minutes)
#   effects.sh --check A,B C   checks with a library without A and B, and with one without C ("all": all effects; "catalogue":
#                              all effects that simulation 2 does not have)
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

paper="bias random_walk"
catalogue="size_effect bandwidth linear asymmetry quadratic g_sensitivity temperature failures gauss_markov flicker
    rate_random_walk ramp dead_zone range quantization altimeter"
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
    local build effects scenes status=0 scene off without
    cargo build --release --quiet --bin steps
    counts simulation2 reads ideal free >target/off.txt
    printf '%-20s %-12s %10s %10s %8s\n' "built without" scene off without %
    for build in "$@"; do
        case $build in
        all) effects="$catalogue $paper" ;;
        catalogue) effects=$catalogue ;;
        *) effects=${build//,/ } ;;
        esac
        # Simulation 2 has the effects of the paper, so a library without one of them flies only the scenes with ideal sensors.
        scenes="ideal free"
        grep -Eq "(^| )(${paper// /|})( |$)" <<<"$effects" || scenes="simulation2 reads $scenes"
        SINS_WITHOUT=$effects cargo build --release --quiet --bin steps
        counts $scenes >target/without.txt
        while read -r scene without; do
            off=$(sed -n "s/^$scene //p" target/off.txt)
            awk -v build="$build" -v scene="$scene" -v off="$off" -v without="$without" -v limit=$limit 'BEGIN {
                excess = 100 * (off - without) / without
                printf "%-20s %-12s %10d %10d %8.2f\n", build, scene, off, without, excess
                exit (excess > limit || excess < -limit)
            }' || status=1
        done <target/without.txt
    done
    [ $status -eq 0 ] || echo "an effect that is off costs more than $limit %" >&2
    return $status
}

case ${1:-} in
--check)
    shift
    [ $# -gt 0 ] || set -- all catalogue $paper $catalogue
    check "$@"
    ;;
"") table ;;
*)
    sed -n '2,/^set/{/^#/p}' "$0" >&2
    exit 2
    ;;
esac
