# For the scripts of this folder, to be sourced after need.sh: the C compiler and linker of Linux for an old glibc. Zig has the
# symbols of every glibc: another linker binds to the newest versions of the glibc that it finds.

glibc=2.17 # the oldest that Rust's standard library takes
need python3-venv /usr/share/doc/python3-venv
need llvm llvm-readelf
tools=$PWD/target/release-tools
if ! [ -x "$tools/bin/cargo-zigbuild" ]; then
    python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check cargo-zigbuild==0.24.0 ziglang==0.17.1
fi

# zig_cc PROCESSOR FILE: writes the compiler's command. cargo-zigbuild gives Zig's the options of gcc's that rustc writes. Zig compiles
# its own parts of the C library when a program first needs them: their debug symbols name folders of this machine, and their archives
# have the order in which its threads were ready. A second link takes them without symbols, sorted.
zig_cc() {
    cat >"$2" <<CC
#!/bin/sh
export PATH="$tools/bin:\$PATH" ZIG_GLOBAL_CACHE_DIR="$2-cache"
link() { "$tools/bin/cargo-zigbuild" zig cc -- -target $1-linux-gnu.$glibc "\$@"; }
link "\$@" || exit
find "$2-cache/o" -name '*.[oa]' -exec llvm-strip --strip-debug {} + 2>/dev/null
find "$2-cache/o" -name '*.a' 2>/dev/null | while read -r archive; do
    parts=\${archive%.a}
    rm -rf "\$parts"
    mkdir "\$parts"
    (cd "\$parts" && llvm-ar x "\$archive" && rm "\$archive" && LC_ALL=C && llvm-ar rcs "\$archive" *.o) || exit
done || exit
link "\$@"
CC
    chmod +x "$2"
}

# check_glibc FILE: as a linker may bind to a newer glibc after all.
check_glibc() {
    local newest
    newest=$(llvm-readelf -V "$1" | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n1)
    if [ "$(printf '%s\n' "$newest" "GLIBC_$glibc" | sort -V | tail -n1)" != "GLIBC_$glibc" ]; then
        echo "$1 needs $newest" >&2
        return 1
    fi
    echo "$1: needs $newest"
}
