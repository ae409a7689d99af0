#!/usr/bin/env bash
# The page in headless Chromium, opened from its file: flights compared with `sins fly` byte by byte, wrong input, languages, logs, the
# panel, keyboard and small screens, and how long it keeps the processor. Pictures of the page are in target/web.
#
#     tests/web.sh             two hours of the paper's simulation 2
#     HOURS=48 tests/web.sh    all of it
#
# SINS_LIB_DIR: a folder with a program sins, used instead of building it. SINS_WASM: a folder that release/wasm.sh has made.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/built.sh
. tests/support/node.sh

need chromium chromium
need fonts-wqy-microhei /usr/share/fonts/truetype/wqy/wqy-microhei.ttc
node_packages "$playwright" "$axe"
build_program
export SINS_WASM=${SINS_WASM:-$PWD/target/wasm}
[ -e "$SINS_WASM/sins.wasm" ] || release/wasm.sh "$SINS_WASM"
release/page.sh target/web
SINS=$built/sins HOURS=${HOURS:-2} SINS_MODULE=$SINS_WASM/sins.mjs node --test --test-reporter spec tests/web/page.mjs
SINS=$built/sins SINS_MODULE=$SINS_WASM/sins.mjs node --test --test-reporter spec tests/web/teaching.mjs
SINS=$built/sins SINS_MODULE=$SINS_WASM/sins.mjs node --test --test-reporter spec tests/web/lessons.mjs
SINS=$built/sins SINS_MODULE=$SINS_WASM/sins.mjs node --test --test-reporter spec tests/web/choices.mjs
SINS=$built/sins SINS_MODULE=$SINS_WASM/sins.mjs node --test --test-reporter spec tests/web/access.mjs
SINS=$built/sins node --test --test-reporter spec tests/web/pages.mjs
SINS=$built/sins node --test --test-reporter spec tests/web/studies.mjs
report_not_run
