#!/usr/bin/env bash
# Sets the version of the next release wherever it must stand as text: release/version.sh VERSION. Everything else reads the first line
# `version = "..."` of Cargo.toml. `cargo test -p tests --test interface versions::` compares all places.
set -euo pipefail
cd "$(dirname "$0")/.."
is_version='^(0|[1-9][0-9]{0,2})\.(0|[1-9][0-9]{0,2})\.(0|[1-9][0-9]{0,2})$' # CMake's versions have no more
if ! [[ $# -eq 1 && $1 =~ $is_version ]]; then
    echo "usage: $0 MAJOR.MINOR.PATCH; each number from 0 to 999" >&2
    exit 2
fi
new=$1 major=${BASH_REMATCH[1]} minor=${BASH_REMATCH[2]} patch=${BASH_REMATCH[3]}
old=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
was=${old//./\\.}

sed -i "0,/^version = \".*\"/s//version = \"$new\"/" Cargo.toml
sed -i "s/^version: .*/version: $new/" CITATION.cff
sed -i "s/^  \"version\": \".*\"/  \"version\": \"$new\"/" release/vcpkg/sins/vcpkg.json
for part in "MAJOR $major" "MINOR $minor" "PATCH $patch"; do
    sed -i -E "s/^(pub const SINS_VERSION_${part% *}: u32 = ).*/\1${part#* };/" src/abi/version.rs
done
# Names of packages, and what a program prints of its library. Measured figures keep the version that was measured.
git ls-files README.md docs/*.md tests/commands.py | xargs sed -i -E "s/sins-$was([^0-9])/sins-$new\1/g; s/sins $was(, with| is older)/sins $new\1/g"
grep -qxF "## $new" CHANGELOG.md || sed -i "0,/^## /s//## $new\n\n&/" CHANGELOG.md

cargo update --quiet --workspace # in Cargo.lock
SINS_WRITE_HEADER=1 cargo check --quiet -p header
git diff --stat
