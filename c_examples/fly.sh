#!/usr/bin/env bash
# Builds the library, the C host and the report program, flies the paper's two simulations and two real flights, and
# writes the report, with the errors of simulation 2 as a picture of its own.
# FLY_HOURS: duration of the simulations, 48 unless stated. Output: target/flights.
set -eu

cd "$(dirname "$0")/.."
hours=${FLY_HOURS:-48}
out=target/flights

c_examples/build.sh
cargo build --release --quiet --features report --bin sins_report
report=${CARGO_TARGET_DIR:-target}/release/sins_report

rm -rf "$out"
fly() {
    echo
    # As in the paper: height and vertical velocity are those of the truth, and the errors come twice.
    target/c_examples/sins_harness "$@" --vertical follow --error-model rk4 --out "$out"
}
fly simulation1 --hours "$hours" --motion rest --name simulation1_rest
# An eight of the patrol takes 560 s: enough records to show it round.
fly simulation1 --hours "$hours" --every 10
fly simulation2 --hours "$hours" --motion rest --name simulation2_rest
fly simulation2 --hours "$hours" --every 10
fly flight c_examples/flights/airliner_cruise.csv
fly flight c_examples/flights/fighter_aerobatics.csv

echo
"$report" -o "$out/report.html" --picture "$out/simulation2.svg" \
    "$out/simulation2_patrol.csv" "$out/simulation2_rest.csv" \
    "$out/simulation1_patrol.csv" "$out/simulation1_rest.csv" \
    "$out/airliner_cruise.csv" "$out/fighter_aerobatics.csv"
echo "report: $PWD/$out/report.html, $PWD/$out/simulation2.svg"
