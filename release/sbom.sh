#!/usr/bin/env bash
# Writes the SBOM (CycloneDX, JSON) of the library, the program and the FMU: the crates that they contain on all platforms.
# The same commit gives the same bytes.
#
#     release/sbom.sh FILE
set -euo pipefail
[ $# -eq 1 ] || { echo "usage: $0 FILE" >&2; exit 2; }
out=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh
need python3 python3

tool=0.5.9
program=$(command -v cargo-cyclonedx || echo "$PWD/target/supply/bin/cargo-cyclonedx")
[ -x "$program" ] || cargo install --quiet --locked --root target/supply "cargo-cyclonedx@$tool"

# The tool writes beside each Cargo.toml, so it gets a copy.
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git archive HEAD | tar -x -C "$copy"
"$program" cyclonedx --quiet --manifest-path "$copy/Cargo.toml" --format json --target all --no-build-deps --override-filename bom
release/sbom.py "$copy" "$SOURCE_DATE_EPOCH" "$copy"/{,apps/cli/,apps/fmu/}bom.json >"$out"
