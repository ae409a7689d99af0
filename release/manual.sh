#!/usr/bin/env bash
# Makes HTML pages of the headers: release/manual.sh OUT. The first page has the preamble of sins.h and the data flow of the library;
# each subject has a page of its own. An item of a header without a comment is an error.
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: $0 OUT" >&2; exit 2; }
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
    # The preamble; the subjects of the other headers are among the groups.
    printf '# sins.h, sins_flight.h, sins_analysis.h, sins_unit.h, sins_ensemble.h, sins_scene.h\n\n```\n'
    sed -n '2,/^ \*\/$/{/^ \*\/$/!{s|^ \* ?||;s|^ \*$||;s|^ \* ||;p}}' include/sins.h
    printf '```\n\n## Data flow\n\n'
    sed -n '/^\/\/! ```text$/,/^\/\/! ```$/{s|^//! ?||;s|^//! ||;s|^```text|```|;p}' src/lib.rs
} >"$SINS_WORK/first_page.md"
doxygen release/Doxyfile
