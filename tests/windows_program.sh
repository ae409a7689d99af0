#!/usr/bin/env bash
# The program sins on Windows, by wine: the tests within it, and those of hostile files and command lines and of the first flights.
# What cannot be had is told at the end.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh

target=x86_64-pc-windows-gnu
# A folder of wine's own: other scripts end its server for target/wine.
export WINEPREFIX=$PWD/target/windows/program/wine WINEDEBUG=-all WINESERVER=/usr/lib/wine/wineserver64
# What the program does with files and orders does not depend on its speed, and most of the time goes into its build.
export CARGO_PROFILE_DEV_OPT_LEVEL=1
need gcc-mingw-w64-x86-64 x86_64-w64-mingw32-gcc
if ! [ -x /usr/lib/wine/wine64 ] && ! install wine64; then
    could_not "the program on Windows" "no wine to be had"
else
    rustup target add "$target"
    # What this wine lacks; the folder is searched for it.
    mkdir -p "$WINEPREFIX" target/windows/program
    x86_64-w64-mingw32-gcc -shared -Wl,--kill-at -o target/windows/program/bcryptprimitives.dll tests/c/bcryptprimitives.c
    WINEPATH=$(/usr/lib/wine/wine64 winepath -w "$PWD/target/windows/program")
    export WINEPATH CARGO_TARGET_X86_64_PC_WINDOWS_GNU_RUNNER=/usr/lib/wine/wine64
    cargo test -p sins-cli --target "$target" --bin sins -- "$@"
    # The other tests do not depend on the system.
    cargo test -p sins-cli --target "$target" --test program -- fly:: inputs:: outputs:: "$@"
fi
report_not_run
