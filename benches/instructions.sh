#!/usr/bin/env bash
# Instructions a step of the whole chain through sins_run, by callgrind: they do not depend on the machine's mood.
set -eu
cd "$(dirname "$0")"
cargo build --release --quiet --bin steps
count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null target/release/steps "$1" "$2" 2>&1 |
        sed -n 's/.*Collected : //p'
}
for what in simulation2 ideal free; do
    short=$(count $what 10000)
    long=$(count $what 20000)
    echo "$what: $(((long - short) / 10000)) instructions a step"
done
