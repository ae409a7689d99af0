#!/usr/bin/env bash
# Packs the page: FOLDER/sins.html, one file with the library within it. docs/web.md describes it.
#
#     release/page.sh FOLDER
#
# SINS_WASM: a folder that release/wasm.sh has made, used instead of building it.
set -euo pipefail
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/node.sh

wasm=${SINS_WASM:-target/wasm}
need libdeflate-tools libdeflate-gzip
[ -n "${SINS_WASM:-}" ] || release/wasm.sh "$wasm"
node_packages "$uplot"
node apps/page/pack/pack.mjs "$wasm" target/node/node_modules/uplot/dist "$out/sins.html"
