# shellcheck shell=bash
# To be sourced by the scripts of this folder after need.sh: the C compiler and linker of Linux for an old glibc. Zig has the
# symbols of every glibc. Other linkers bind to the newest versions of the installed glibc.

glibc=2.17 # the oldest version that Rust's standard library supports
need python3-venv /usr/share/doc/python3-venv
need llvm llvm-readelf
tools=$PWD/target/release-tools
if ! [ -x "$tools/bin/cargo-zigbuild" ]; then
    python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet --disable-pip-version-check cargo-zigbuild==0.24.0 ziglang==0.17.1
fi

# zig_cc PROCESSOR FILE: writes the compiler's command to FILE. cargo-zigbuild translates rustc's gcc options into options of Zig.
# Zig compiles its own parts of the C library when a program first needs them: their debug symbols name folders of this machine, and
# their archives have the order in which its threads were ready. After a link that made such parts, the parts are stripped and
# sorted, and the program is linked again. Only one link runs at a time, because all links share the parts.
zig_cc() {
    local processor=$1
    [ "$1" != i686 ] || processor=x86 # the name that Zig has for it
    rm -rf "$2-parts"
    touch -d @0 "$2-sorted"
    cat >"$2" <<CC
#!/bin/bash
set -euo pipefail
export LC_ALL=C PATH="$tools/bin:\$PATH" ZIG_GLOBAL_CACHE_DIR="$2-parts"
link() { "$tools/bin/cargo-zigbuild" zig cc -- -target $processor-linux-gnu.$glibc "\$@"; }
exec 9>"$2-lock"
flock 9
link "\$@"
[ -d "$2-parts/o" ] || exit 0
made=\$(find "$2-parts/o" -name '*.[oa]' -newer "$2-sorted")
[ -n "\$made" ] || exit 0
while read -r file; do
    llvm-strip --strip-debug "\$file"
    if [[ \$file = *.a ]]; then
        mkdir "\${file%.a}"
        (cd "\${file%.a}" && llvm-ar x "\$file" && rm "\$file" && llvm-ar rcs "\$file" *.o)
        rm -r "\${file%.a}"
    fi
done <<<"\$made"
touch "$2-sorted"
link "\$@"
CC
    chmod +x "$2"
}

# check_glibc FILE: checks that FILE needs no newer glibc, because a linker may still bind to one.
check_glibc() {
    local newest
    newest=$(llvm-readelf -V "$1" | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n1)
    if [ "$(printf '%s\n' "$newest" "GLIBC_$glibc" | sort -V | tail -n1)" != "GLIBC_$glibc" ]; then
        echo "$1 needs $newest" >&2
        return 1
    fi
    echo "$1: needs $newest"
}
