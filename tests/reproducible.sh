#!/usr/bin/env bash
# One commit gives the same bytes: builds packages twice, in folders of other names and depths, with another time zone, language, umask
# and number of jobs, and compares each file of each package. Needs 3 GB and the network.
#
#     tests/reproducible.sh                          Linux and Windows: libraries, programs and wheels
#     tests/reproducible.sh linux-arm64 fmu          these packages of release/package.sh
#     tests/reproducible.sh all                      the folder that release/all.sh makes
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh

what=("$@")
[ $# -gt 0 ] || what=(linux-x86_64 windows-x86)
[ -z "$(git status --porcelain)" ] || echo "only what is committed is built"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
first=$work/first second="$work/a second folder/of another name"
need unzip unzip

# build SOURCE FOLDER SETTING...: makes the packages in a clone.
build() {
    git clone -q "$1" "$2"
    local command=(release/package.sh "${what[@]}")
    [ "${what[*]}" != all ] || command=(release/all.sh)
    (cd "$2" && env "${@:3}" "${command[@]}") >"$work/log" 2>&1 || { tail -n 50 "$work/log"; return 1; }
    rm -rf "$2/target/release"* # room for the second
}
build . "$first" TZ=UTC LC_ALL=C.UTF-8 CARGO_BUILD_JOBS=2
# Of the same commit, whatever was committed in the meantime.
(umask 077 && build "$first" "$second" TZ=Pacific/Auckland LC_ALL=C CARGO_BUILD_JOBS=1)

# unpacked FILE FOLDER: the files of an archive, those of wheels within it too.
unpacked() {
    mkdir -p "$2"
    case $1 in
        *.tar.gz | *.tgz | *.crate) tar -C "$2" -xzf "$1" ;;
        *.zip | *.whl | *.fmu) unzip -q "$1" -d "$2" ;;
        *.deb) dpkg-deb -R "$1" "$2" ;;
        *) cp "$1" "$2" ;;
    esac
    find "$2" -name '*.whl' -type f | while read -r wheel; do
        unpacked "$wheel" "$wheel.files"
        rm "$wheel"
    done
}

modes() {
    (cd "$1" && find . -printf '%m %p\n' | LC_ALL=C sort -k2)
}

one=$first/target/dist other=$second/target/dist status=0
diff <(cd "$one" && find . -type f | LC_ALL=C sort) <(cd "$other" && find . -type f | LC_ALL=C sort) ||
    { echo "the second build has other files" >&2; status=1; }
for file in "$one"/*; do
    name=${file##*/}
    [ -e "$other/$name" ] && [ "$name" != SHA256SUMS ] || continue
    if cmp -s "$file" "$other/$name"; then
        echo "the same: $name"
        continue
    fi
    status=1
    echo "differs: $name" >&2
    unpacked "$file" "$work/one/$name"
    unpacked "$other/$name" "$work/other/$name"
    diff -rq "$work/one/$name" "$work/other/$name" >&2 || true
    diff <(modes "$work/one/$name") <(modes "$work/other/$name") >&2 || true
done
exit $status
