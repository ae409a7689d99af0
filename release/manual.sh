#!/usr/bin/env bash
# Makes HTML pages of the header; the first one shows the data flow of the library: release/manual.sh OUT. An item of the header
# without a comment is an error.
set -euo pipefail
mkdir -p "$1"
SINS_OUT=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh
need doxygen doxygen

SINS_VERSION=$version
SINS_WORK=target/release-manual
export SINS_OUT SINS_VERSION SINS_WORK
mkdir -p "$SINS_WORK"
{
    printf '# Data flow\n\nThe headers are sins.h, sins_ensemble.h and sins_scene.h. The first page of each explains its part.\n\n'
    sed -n '/^\/\/! ```text$/,/^\/\/! ```$/{s|^//! ?||;s|^//! ||;s|^```text|```|;p}' src/lib.rs
} >"$SINS_WORK/data_flow.md"
doxygen release/Doxyfile
