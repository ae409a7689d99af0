# shellcheck shell=bash disable=SC2034,SC2154 # variables of the scripts that source it
# To be sourced by the scripts of this folder, at the top of the project: version and time of a build, flags with which one commit gives
# the same bytes in every folder, and archives with the same bytes.

version=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
umask 022 # a wheel has the modes of its files

need cmake cmake

# flags TOOLCHAIN FLAG...: prints the flags of every crate, which also keep paths of this machine out of the build
# (cmake/remap.cmake). They are encoded, because a path may have blanks.
flags() {
    local list flag
    list=$(cmake -DSOURCE="$PWD" "-DRUSTC=rustc;+$1" -P cmake/remap.cmake | paste -s -d $'\x1f')
    shift
    for flag in "$@"; do list+=$'\x1f'$flag; done
    printf %s "$list"
}

# Prints the functions of the header, sorted.
functions() {
    sed -nE 's/^ *X\([^,]*, (sins_[a-z0-9_]+), .*/\1/p' include/sins_functions.h | LC_ALL=C sort
}

# step NAME: prints the time since the start, and what begins.
step() {
    printf '%5d s: %s\n' "$SECONDS" "$1"
}

# archive FOLDER SUFFIX: packs the folder into $dist, sorted, with the time of the commit and without a user of this machine as owner.
archive() {
    local name=${1##*/}
    chmod -R u=rwX,go=rX "$1"
    rm -f "$dist/$name.$2"
    case $2 in
        tar.gz)
            tar -C "${1%/*}" --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --format=gnu -c "$name" |
                gzip -n9 >"$dist/$name.$2"
            ;;
        zip)
            need zip zip
            find "$1" -exec touch -d "@$SOURCE_DATE_EPOCH" {} +
            (cd "${1%/*}" && find "$name" | LC_ALL=C sort | TZ=UTC zip -qX9 -@ "$dist/$name.$2")
            ;;
    esac
}
