#!/usr/bin/env bash
# The main job: builds the library, the program sins and the C and C++ examples; flies one scene with the C host; flies the paper's
# two simulations and two logs of a flight simulator with the program; draws one page with all flights, and the errors of simulation
# 2 as a separate picture. Needs Rust and a C and C++ compiler.
# FLY_HOURS: duration of the simulations [h], default 48. Output: target/flights.
set -eu

cd "$(dirname "$0")/.."
hours=${FLY_HOURS:-48}
out=target/flights
target=${CARGO_TARGET_DIR:-target}
sins=$target/release/sins

echo "building (some minutes, once)"
c_examples/build.sh
# The program is built in a separate folder. In the same folder of cargo, the library that is built for the program and the
# shared library of build.sh would replace each other, and both would be built again each time. The program is not optimised
# across crates, which would take as long again.
cargo build --release --quiet -p sins-cli --target-dir "$target/program" --config profile.release.lto=false
ln -f "$target/program/release/sins" "$sins"

rm -rf "$out"
mkdir -p "$out"
scene=c_examples/scenes/fighter.toml
printf '\ntarget/c_examples/harness %s, first and last lines of %s/harness.txt:\n' "$scene" "$out"
target/c_examples/harness "$scene" >"$out/harness.txt"
head -n 4 "$out/harness.txt"
echo ...
tail -n 14 "$out/harness.txt"

fly() {
    echo
    "$sins" fly "$@" --out "$out"
}
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

echo
"$sins" report -o "$out/report.html" --picture "$out/simulation2.svg" \
    "$out/simulation2_patrol.csv" "$out/simulation2_rest.csv" \
    "$out/simulation1_patrol.csv" "$out/simulation1_rest.csv" \
    "$out/airliner_cruise.csv" "$out/fighter_aerobatics.csv" >/dev/null
printf '\nopen the page: %s\nthe picture:   %s\n' "$PWD/$out/report.html" "$PWD/$out/simulation2.svg"
