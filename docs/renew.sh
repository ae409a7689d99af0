#!/usr/bin/env bash
# Prints every figure of README.md and docs again, and draws the pictures of flights and benchmarks again. Compare target/figures with
# the tables, and copy what changed. Run it on a quiet machine, because some figures are times. It takes some hours.
#   docs/renew.sh              all
#   docs/renew.sh NAME...      some: the names of the functions below
#   docs/renew.sh --check      builds the library and the page, compares their sizes with those in the documents, and fails if one is off
set -euo pipefail
cd "$(dirname "$0")/.."
figures=$PWD/target/figures
sins=target/program/release/sins

long() {
    cargo test --release --features long-tests -p "$@" -- --nocapture
}

# accuracy.md
simulations() { long tests --test physics simulation1::; }
poles() { cargo test -p tests --test robustness poles:: -- --nocapture; }
earth() { cargo test -p tests --test physics earth:: -- --nocapture; }
mounting() { cargo test -p tests --test effects mounting:: -- --nocapture; }
flights() {
    c_examples/fly.sh
    cp target/flights/simulation2.svg c_examples/simulation2.svg
}
steps() {
    cargo bench --manifest-path benches/Cargo.toml
    benches/instructions.sh
}
frames() { cargo run --release --manifest-path benches/Cargo.toml --bin frames; }
stages() { cargo run --release --manifest-path benches/Cargo.toml --bin stages; }
memory() { cargo test -p tests --test interface host_machine:: -- --nocapture; }
recommend() { cargo test -p tests --release --test analysis recommend:: -- --nocapture; }
curve() {
    "$sins" curve --force --flight all c_examples/flights/fighter_aerobatics.csv --out "$figures/curve.out"
    cp "$figures"/curve.out/{aerobatics,cruise}.svg benches/curves/
}

# effects.md
effects() {
    benches/effects.sh
    benches/effects.sh --check all catalogue
}
budget() {
    "$sins" budget --force --time-steps --position 10 --out "$figures/budget.out" simulation2
    "$sins" budget --force --position 30 --preset industrial --set start.preset=ideal --out "$figures/budget.out" c_examples/flights/fighter_aerobatics.csv
    cp "$figures/budget.out/fighter_aerobatics.svg" benches/budget/
}
allan() {
    "$sins" fly simulation2 --set flight.builtin=rest --set flight.hours=4 --set options.error_model=off --name rest \
        --imu rest_imu.csv --force --out "$figures/allan.out"
    "$sins" allan "$figures/allan.out/rest_imu.csv" --force -o "$figures/allan.out/allan.svg"
}
allan_estimator() { long sins-allan; }

# ensembles.md
ensemble() {
    cargo run --release --manifest-path benches/Cargo.toml --bin ensemble
    benches/instructions.sh ensemble
}
scale() { benches/scale.sh; }
covariance() {
    cargo test -p tests --test analysis covariance:: -- --nocapture
    long tests --test analysis covariance_runs::
}

# questions.md
at_rest() {
    local rate
    for rate in 0.1 0.01; do
        "$sins" fly rest --set flight.rate_hz=$rate --set options.max_gap_s=100 --set flight.hours=12 --force --out "$figures/at_rest.out"
    done
}

# scenes.md, host_time.md, hosts.md, packages.md
library_sizes() {
    local features
    for features in scenes,identify scenes ""; do
        cargo rustc --release --lib --crate-type cdylib --no-default-features --features "$features"
        strip -o "$figures/libsins.so" target/release/libsins.so
        stat -c "%s bytes: $features" "$figures/libsins.so"
    done
    cargo rustc --release --lib --crate-type cdylib
}
gaps() { cargo test -p tests --test robustness irregular_samples:: -- --nocapture; }
snapshots() { cargo test -p tests --test state snapshots:: -- --nocapture; }
jsbsim() {
    tests/jsbsim.sh
    target/jsbsim/host target/jsbsim/source c_examples/jsbsim/flight.xml "$figures/twin" ins/slews=0 ins/gyro-failure=0
    "$sins" fly "$figures/twin_truth.csv" --preset navigation --set start.preset=ideal --set options.axes=frd --set options.sample_period_s=0.01 \
        --set output.every_s=4 --name twin --force --out "$figures/jsbsim.out"
    "$sins" report "$figures/jsbsim.out/twin.csv" --force -o "$figures/jsbsim.out/report.html" --picture docs/jsbsim.svg
}
packages() {
    release/package.sh
    ls -l target/dist
}

# trust.md
savage() { cargo test -p tests --test physics savage:: -- --nocapture; }
peers() {
    cargo rustc --release --lib --crate-type cdylib
    PYTHONPATH=target/release/bindings SINS_LIBRARY=target/release/libsins.so target/peers/bin/python benches/peers.py \
        --source gnss-ins-sim=target/gnss-ins-sim
}

all="simulations poles earth mounting flights steps frames stages memory recommend curve effects budget allan
    allan_estimator ensemble scale covariance at_rest library_sizes gaps snapshots jsbsim packages savage peers"
for name in "$@"; do
    if [ "$name" != --check ] && [[ " "${all//$'\n'/ }" " != *" $name "* ]]; then
        echo "$name: none of" $all
        exit 2
    fi
done
mkdir -p "$figures"

# stated VALUE FILE PATTERN [UNIT]: the number that \(...\) of PATTERN matches in a line of FILE is VALUE, or VALUE / UNIT, within 3 %.
stated() {
    local figure
    figure=$(sed -n "s/.*$3.*/\1/p" "$2" | tr -d ' ')
    awk -v value="$1" -v unit="${4:-1}" -v figure="$figure" -v where="$2" 'BEGIN {
        is_off = figure == "" || (figure - value / unit) ^ 2 > (0.03 * value / unit) ^ 2
        printf "%s: %s, and it is %.6g%s\n", where, figure, value / unit, is_off ? ": OFF" : ""
        exit is_off
    }' || off=1
}

# Sizes of the library and of the page.
check() {
    local off=0 number='\([0-9 ]*\)'
    library_sizes | tee "$figures/library_sizes.txt"
    stated "$(sed -n 's/ bytes: scenes,identify$//p' "$figures/library_sizes.txt")" docs/scenes.md "| with both | $number |"
    stated "$(sed -n 's/ bytes: scenes$//p' "$figures/library_sizes.txt")" docs/scenes.md "| with scenes | $number |"
    stated "$(sed -n 's/ bytes: $//p' "$figures/library_sizes.txt")" docs/scenes.md "| with none | $number |"
    release/page.sh "$figures"
    stated "$(stat -c %s "$figures/sins.html")" docs/web.md 'The file has \([0-9.]*\) MB' 1e6
    return $off
}
if [ "${1:-}" = --check ]; then
    check
    exit
fi

# In a folder of its own: the builds of the program and of the shared library replace each other.
cargo build --release -p sins-cli --target-dir target/program
for name in ${*:-$all}; do
    echo "== $name: $figures/$name.txt ($SECONDS s)"
    set +e # in a condition bash would ignore errexit within the function
    (set -e; "$name") >"$figures/$name.txt" 2>&1
    status=$?
    set -e
    [ "$status" -eq 0 ] || echo "$name failed: see $figures/$name.txt"
done
