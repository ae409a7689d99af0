#!/usr/bin/env bash
# Makes the site: FOLDER/index.html, static pages that need no network. The page that flies, the documents with search, a gallery of what
# the commands draw, and the reference of the headers. The interface in Rust has 18 MB of pages by rustdoc, so it is not among them.
#
#     release/site.sh FOLDER
#
# SINS_PAGE: a folder that release/page.sh has made; SINS_PROGRAM: the program sins. Both are built without.
set -euo pipefail
[ $# -eq 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh
need python3 python3

tool=0.4.52
book=$(command -v mdbook || echo "$PWD/target/supply/bin/mdbook")
if ! [ -x "$book" ]; then
    step "mdbook $tool"
    cargo install --quiet --locked --root target/supply "mdbook@$tool"
fi
page=${SINS_PAGE:-target/site/page}
if [ -z "${SINS_PAGE:-}" ]; then
    step "the page"
    release/page.sh "$page"
fi
program=${SINS_PROGRAM:-$PWD/target/quick/sins}
if [ -z "${SINS_PROGRAM:-}" ]; then
    step "the program"
    cargo build --quiet --locked --profile quick --package sins-cli
fi
work=$PWD/target/site/work source=$PWD/target/site/work/src
rm -rf "$work" "$out/docs.new"
mkdir -p "$source"

step "documents"
git ls-files README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE-APACHE LICENSE-MIT docs include tests/README.md \
    'benches/*.svg' c_examples | grep -vE '\.(sh|csv)$' | while read -r file; do
    command install -Dm644 "$file" "$source/$file"
done
release/documents.py --site "$source"
cp release/site/book.toml "$work"
cp release/site/SUMMARY.md "$source" # has links to what follows
release/manual.sh "$source/headers" >/dev/null
cp "$page/sins.html" "$source"
cat >"$source/try.md" <<'PAGE'
# Fly it here

The page computes in the browser. [Alone in the window](sins.html); [what it has](docs/web.md).

<iframe src="sins.html" title="SINS in a page" style="width: 100%; height: 85vh; border: 1px solid #888"></iframe>
PAGE
cat >"$source/reference.md" <<'PAGE'
# The headers

[Functions and structs of `sins.h` and its parts](headers/index.html), by subject, with units, frames, defaults and errors.
PAGE

# drawn TITLE PAGE COMMAND...: runs commands of the program, of which the last draws PAGE, and adds the page to the gallery.
gallery=$source/gallery
drawings=$work/drawings
mkdir "$gallery" "$drawings"
ln -s "$PWD/c_examples" "$drawings"
printf '# A gallery\n\nWhat commands of the program draw, each on one page:\n\n' >"$source/gallery.md"
drawn() {
    local command commands=""
    step "gallery: $1"
    for command in "${@:3}"; do
        commands+=" \`sins $command\`"
        # shellcheck disable=SC2086
        (cd "$drawings" && "$program" $command) >"$work/log" 2>&1 || { cat "$work/log" >&2; return 1; }
    done
    mv "$drawings/sins_out/$2" "$gallery"
    printf -- '- [%s](gallery/%s):%s\n' "$1" "${2##*/}" "$commands" >>"$source/gallery.md"
}
drawn "The paper: 48 hours" report.html "fly simulation2 --set output.every_s=60" "report sins_out/simulation2.csv"
drawn "How large the errors get, and how often" patrol_ensemble.html \
    "ensemble patrol --preset navigation --set flight.hours=1 --runs 200"
drawn "Which errors matter" budget/budget.html "budget c_examples/scenes/fighter.toml"
drawn "What accuracy costs" curve/curve.html "curve aerobatics --quick"
drawn "The noise of an IMU" imu_allan.html "fly rest --preset consumer --set flight.hours=1 --imu imu.csv" "allan sins_out/imu.csv"

drawn "The errors of an IMU" identify.html \
    "fly aerobatics --preset tactical --set flight.hours=0.11 --set flight.rate_hz=50 --imu record.csv" \
    "identify aerobatics --set flight.hours=0.11 --set flight.rate_hz=50 --imu sins_out/record.csv --prior tactical --check --page sins_out/identify.html"

step "pages"
"$book" build "$work" --dest-dir "$work/book" >/dev/null
python3 release/site/check.py "$work/book" "$source/SUMMARY.md"
rm -rf "${out:?}"/*
cp -r "$work/book/." "$out"
step "done: $(du -sh --apparent-size "$out" | cut -f1) in $out"
