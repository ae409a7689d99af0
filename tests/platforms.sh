#!/usr/bin/env bash
# The pinned digests on other processors, by emulation. Needs the cross compilers and emulators that the names below say
# (Debian: gcc-i686-linux-gnu gcc-aarch64-linux-gnu qemu-user).
set -eu
cd "$(dirname "$0")/.."
# digests TRIPLE EMULATOR
digests() {
    rustup target add "$1-unknown-linux-gnu"
    variable=CARGO_TARGET_$(echo "$1" | tr a-z A-Z)_UNKNOWN_LINUX_GNU
    env "${variable}_LINKER=$1-linux-gnu-gcc" "${variable}_RUNNER=$2 -L /usr/$1-linux-gnu" \
        cargo test --target "$1-unknown-linux-gnu" --test determinism
}
digests i686 qemu-i386
digests aarch64 qemu-aarch64
