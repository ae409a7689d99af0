#!/usr/bin/env bash
# The program sins on Windows, with wine: its unit tests, and the tests of its flights, inputs and outputs. Tests that could not run
# are reported at the end.
#
#     tests/windows_program.sh                       builds it for 64 bits with little optimisation
#     tests/windows_program.sh i686|x86_64 SINS.EXE  tests this program, without the unit tests
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/wine.sh

# The other tests do not depend on the system.
tests="fly:: inputs:: outputs::"

# given PROCESSOR SINS.EXE: the tests are built for this machine and start the program with wine. Tests that need Unix are left out,
# and so is the test of a redirected log: started in this way, the program did not recognize the log as its own output. Without
# arguments this script includes that test.
given() {
    local work=$PWD/target/windows/program
    mkdir -p "$work"
    [ "$1" = x86_64 ] || fetch_screen32 # without fonts wine prints warnings
    # Once in some 2000 starts wine itself dies, of a signal, which no program of Windows can, or because its server ended between two
    # of its words to it, which it says; then it starts again, at most twice, as a start right behind may die too.
    cat >"$work/sins" <<SH
#!/bin/sh
errors="$work/errors.\$\$"
for start in 1 2 3; do
    "$wine" "$(realpath "$2")" "\$@" 2>"\$errors"
    status=\$?
    [ \$status -ge 128 ] || grep -q '^wine client error' "\$errors" || break
    echo >>"$work/died"
done
cat "\$errors" >&2
rm "\$errors"
exit \$status
SH
    : >"$work/died"
    chmod +x "$work/sins"
    export LC_ALL=C.UTF-8 # for the command line in wine
    # One server for all programs. One that still runs from before would end when it has been idle for seconds, under a program that
    # just starts: that end is awaited first.
    timeout 120 "$WINESERVER" -w || true
    "$WINESERVER" -p60 >/dev/null 2>&1
    "$work/sins" --version
    SINS_PROGRAM=$work/sins cargo test --workspace --test program -- $tests --include-ignored \
        --skip a_closed_pipe --skip nodes_and_links --skip pipes_and_standard_input --skip a_log_that_is_redirected
    echo "wine died $(wc -l <"$work/died") times"
}

built() {
    local target=x86_64-pc-windows-gnu
    # The speed of the program does not matter here, and the build takes most of the time.
    export CARGO_PROFILE_DEV_OPT_LEVEL=1
    need gcc-mingw-w64-x86-64 x86_64-w64-mingw32-gcc
    rustup target add "$target"
    # A DLL that this wine lacks; WINEPATH makes wine search this folder.
    mkdir -p target/windows/program
    x86_64-w64-mingw32-gcc -shared -Wl,--kill-at -o target/windows/program/bcryptprimitives.dll tests/c/bcryptprimitives.c
    WINEPATH=$("$wine" winepath -w "$PWD/target/windows/program")
    export WINEPATH CARGO_TARGET_X86_64_PC_WINDOWS_GNU_RUNNER=$wine
    cargo test -p sins-cli --target "$target" --bin sins
    cargo test -p sins-cli --target "$target" --test program -- $tests
}

if have_wine "${1:-x86_64}"; then
    if [ $# -gt 0 ]; then given "$@"; else built; fi
fi
report_not_run
