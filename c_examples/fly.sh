#!/usr/bin/env bash
# The main job: builds the library and the C and C++ examples, and flies one scene with the C host; builds the program sins, and flies
# with it the paper's two simulations and two logs of a flight simulator, all at once; draws one page with all flights, and the errors of
# simulation 2 as a separate picture. Needs Rust and a C and C++ compiler.
# FLY_HOURS: duration of the simulations [h], default 48. Output: target/flights.
# SINS_LIB_DIR: a folder with libsins.so and the program sins, used instead of building them.
set -eu

cd "$(dirname "$0")/.."
hours=${FLY_HOURS:-48}
out=target/flights
target=${CARGO_TARGET_DIR:-target}
sins=$target/release/sins

# Library and program, with the profile that is built in the shortest time. The dependencies have more features for the program than
# for the library alone. So both builds name both packages, and the second takes the library of the first.
build() {
    cargo build --profile quick --package sins --package sins-cli "$@"
}

if [ -z "${SINS_LIB_DIR:-}" ]; then
    echo "building the library"
    build --lib
fi
SINS_LIB_DIR=${SINS_LIB_DIR:-$target/quick} c_examples/build.sh

rm -rf "$out"
mkdir -p "$out"
scene=c_examples/scenes/fighter.toml
printf '\ntarget/c_examples/harness %s, first and last lines of %s/harness.txt:\n' "$scene" "$out"
target/c_examples/harness "$scene" >"$out/harness.txt"
head -n 4 "$out/harness.txt"
echo ...
tail -n 14 "$out/harness.txt"

if [ -n "${SINS_LIB_DIR:-}" ]; then
    sins=$SINS_LIB_DIR/sins
else
    printf '\nbuilding the program\n'
    build --quiet
    mkdir -p "$target/release"
    ln -f "$target/quick/sins" "$sins"
fi

# Starts a flight; print_flights prints what it writes.
flights=()
trap 'kill "${flights[@]}" 2>/dev/null || true' EXIT
fly() {
    "$sins" fly "$@" --out "$out" >"$out/flight${#flights[@]}.txt" 2>&1 &
    flights+=($!)
}

# In the order of their starts, each when it has ended.
print_flights() {
    local status=0
    for flight in "${!flights[@]}"; do
        echo
        wait "${flights[$flight]}" || status=$?
        cat "$out/flight$flight.txt"
        [ "$status" -eq 0 ] || exit "$status"
        rm "$out/flight$flight.txt"
    done
    flights=()
}

printf '\nflying the six flights\n'
rest="--set flight.builtin=rest"
# A figure-eight of the patrol takes 560 s: these are enough records to draw it round.
eights="--set output.every_s=10"
for simulation in simulation1 simulation2; do
    fly $simulation --set flight.hours="$hours" $rest --name ${simulation}_rest
    fly $simulation --set flight.hours="$hours" $eights --name ${simulation}_patrol
done
# As in the simulations: height and vertical velocity follow the truth, and the errors come from both error data.
paper="--set options.vertical=follow --set options.error_model=rk4"
fly c_examples/flights/airliner_cruise.csv $paper
fly c_examples/flights/fighter_aerobatics.csv $paper
print_flights

echo
"$sins" report -o "$out/report.html" --picture "$out/simulation2.svg" \
    "$out/simulation2_patrol.csv" "$out/simulation2_rest.csv" \
    "$out/simulation1_patrol.csv" "$out/simulation1_rest.csv" \
    "$out/airliner_cruise.csv" "$out/fighter_aerobatics.csv" >/dev/null
printf '\nopen the page: %s\nthe picture:   %s\n' "$PWD/$out/report.html" "$PWD/$out/simulation2.svg"
