#!/usr/bin/env bash
# Prints the notes of a release: its part of CHANGELOG.md, by subject.
#
#     release/notes.sh [VERSION]      default: that of Cargo.toml
set -euo pipefail
cd "$(dirname "$0")/.."
version=${1:-$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)}
notes=$(awk -v heading="## $version" '/^## / { inside = $0 == heading; next } inside' CHANGELOG.md | sed '/./,$!d')
if [ -z "$notes" ]; then
    echo "release/notes.sh: CHANGELOG.md has no entries for version $version" >&2
    exit 1
fi
printf '# sins %s\n\n%s\n' "$version" "$notes"
