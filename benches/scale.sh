#!/usr/bin/env bash
# Scaling of an ensemble (docs/ensembles.md): measures the time of a step of a run on one core, and prints how many runs an hour
# 1, 64 and 1024 such cores fly. SINS: program sins to use instead of building it. NS: time of a step [ns] to use instead of a
# measurement.
set -euo pipefail
cd "$(dirname "$0")/.."
measured() {
    local out user_s
    if [ -z "${SINS:-}" ]; then
        cargo build --release --quiet -p sins-cli
        SINS=${CARGO_TARGET_DIR:-target}/release/sins
    fi
    out=$(mktemp -d)
    # Simulation 2's errors with error data 2, a quarter of an hour. Processor time is measured, because other programs may be busy.
    TIMEFORMAT=%U
    user_s=$({ time "$SINS" ensemble simulation2 --set options.error_model=off --set flight.hours=0.25 --runs 256 --threads 1 \
        --quiet --out "$out"; } 2>&1)
    rm -r "$out"
    awk -v user_s="$user_s" 'BEGIN { printf "%.1f", 1e9 * user_s / (256 * 0.25 * 360000) }'
}

ns=${NS:-$(measured)}
awk -v ns="$ns" '
    # Two digits.
    function rounded(x,  step) {
        step = 10 ^ (int(log(x) / log(10)) - 1)
        return int(x / step + 0.5) * step
    }
    # In groups of three digits, as docs/ writes numbers from 10 000 on.
    function spaced(x,  text, groups) {
        text = sprintf("%.0f", x)
        while (x >= 10000 && length(text) > 3) {
            groups = " " substr(text, length(text) - 2) groups
            text = substr(text, 1, length(text) - 3)
        }
        return text groups
    }
    BEGIN {
        printf "A step of a run takes %s ns.\n\n", ns
        print "| flight at 100 Hz | one run takes | a block of 64 runs | runs an hour on 1 core | on 64 | on 1024 |"
        print "|---|---|---|---|---|---|"
        split("0.0833333 1 48", hours, " ")
        split("5 min,1 h,48 h", names, ",")
        for (k = 1; k <= 3; k++) {
            run_s = ns * 1e-9 * hours[k] * 360000
            printf "| %s | %.3g s | %.3g s | %s | %s | %s |\n", names[k], run_s, 64 * run_s, spaced(rounded(3600 / run_s)),
                spaced(rounded(64 * 3600 / run_s)), spaced(rounded(1024 * 3600 / run_s))
        }
    }'
