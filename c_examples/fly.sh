#!/usr/bin/env bash
# Builds the program, flies the paper's two simulations and two real flights, and writes the report, with the errors of
# simulation 2 as a picture of its own. Needs Rust alone.
# FLY_HOURS: duration of the simulations, 48 unless stated. Output: target/flights.
set -eu

cd "$(dirname "$0")/.."
hours=${FLY_HOURS:-48}
out=target/flights

cargo build --release --quiet -p sins-cli
sins=${CARGO_TARGET_DIR:-target}/release/sins

rm -rf "$out"
fly() {
    echo
    "$sins" fly "$@" --out "$out"
}
rest="--set flight.builtin=rest"
# An eight of the patrol takes 560 s: enough records to show it round.
eights="--set output.every_s=10"
for simulation in simulation1 simulation2; do
    fly $simulation --set flight.hours="$hours" $rest --name ${simulation}_rest
    fly $simulation --set flight.hours="$hours" $eights --name ${simulation}_patrol
done
fly c_examples/flights/airliner_cruise.csv
fly c_examples/flights/fighter_aerobatics.csv

echo
"$sins" report -o "$out/report.html" --picture "$out/simulation2.svg" \
    "$out/simulation2_patrol.csv" "$out/simulation2_rest.csv" \
    "$out/simulation1_patrol.csv" "$out/simulation1_rest.csv" \
    "$out/airliner_cruise.csv" "$out/fighter_aerobatics.csv"
echo "picture: $PWD/$out/simulation2.svg"
