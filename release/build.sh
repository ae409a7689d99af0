# For the scripts of this folder, to be sourced at the top of the project: version and time of what is built, and how one commit
# gives the same bytes in every folder.

version=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

# flags TOOLCHAIN FLAG...: flags of every crate, and no path of this machine in what is built. Encoded, as a path may have blanks.
flags() {
    local list="--remap-path-prefix=$PWD=/sins" flag
    list+=$'\x1f'"--remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=/cargo"
    list+=$'\x1f'"--remap-path-prefix=$(rustc "+$1" --print sysroot)/lib/rustlib/src/rust=/rust"
    shift
    for flag in "$@"; do list+=$'\x1f'$flag; done
    printf %s "$list"
}

# The functions of the header, sorted.
functions() {
    sed -nE 's/^ *X\([^,]*, (sins_[a-z0-9_]+), .*/\1/p' include/sins_functions.h | LC_ALL=C sort
}
