# To be sourced by the scripts of this folder, at the top of the project: version and time of a build, and flags with which one
# commit gives the same bytes in every folder.

version=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

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
