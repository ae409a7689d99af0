#!/usr/bin/env bash
# The chain of supply, weekly: licences, duplicates, sources and advisories of the crates of each Cargo.lock, by cargo-deny and deny.toml.
# What could not run is reported at the end.
#
#     tests/supply.sh
#     ADVISORIES=FOLDER tests/supply.sh    with a clone of https://github.com/RustSec/advisory-db, where that cannot be reached
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh

version=0.20.2
deny=$(command -v cargo-deny || echo "$PWD/target/supply/bin/cargo-deny")
if ! [ -x "$deny" ] && ! cargo install --quiet --locked --root target/supply "cargo-deny@$version"; then
    could_not "the chain of supply" "no cargo-deny $version to be had"
    report_not_run
    exit
fi

# of_each COMMAND...: runs cargo-deny for each Cargo.lock.
of_each() {
    local manifest
    for manifest in Cargo.toml benches/Cargo.toml tests/fuzz/Cargo.toml; do
        echo "== $manifest: ${*: -1}"
        "$deny" --config deny.toml --manifest-path "$manifest" --locked "$@"
    done
}

of_each check licenses
of_each check sources
of_each check --allow unnecessary-skip bans

need git git
if [ -n "${ADVISORIES:-}" ]; then
    folder=$(cd "$ADVISORIES" && pwd)
    export GIT_CONFIG_COUNT=1 GIT_CONFIG_KEY_0=url.file://$folder.insteadOf
    export GIT_CONFIG_VALUE_0=https://github.com/RustSec/advisory-db
fi
if "$deny" --config deny.toml fetch db; then
    of_each check advisories
else
    could_not "advisories" "their database cannot be reached; ADVISORIES=FOLDER names a clone of it"
fi
report_not_run
