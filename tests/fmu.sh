#!/usr/bin/env bash
# The Functional Mock-up Unit by FMPy, from PyPI: its validator and the schema of the standard, flights compared with the program to
# the bit, states, many instances, bad inputs. FMU: a unit to test instead of building one of this machine's binary alone.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh

folder=$PWD/target/fmu
mkdir -p "$folder"
need python3-venv /usr/share/doc/python3-venv
[ -x "$folder/venv/bin/python" ] || python3 -m venv "$folder/venv"
if ! "$folder/venv/bin/python" -c "import fmpy" 2>/dev/null && ! "$folder/venv/bin/pip" install --quiet fmpy numpy; then
    could_not "the Functional Mock-up Unit" "no FMPy to be had"
    report_not_run
    exit
fi

cargo build --quiet --release -p sins-cli
if [ -z "${FMU:-}" ]; then
    FMU=$folder/sins.fmu
    cargo build --quiet --release -p sins-fmu
    target/release/pack-fmu "$FMU" binaries/linux64/sins_fmu.so=target/release/libsins_fmu.so
    target/release/pack-fmu "$folder/again.fmu" binaries/linux64/sins_fmu.so=target/release/libsins_fmu.so
    cmp "$FMU" "$folder/again.fmu"
fi
"$folder/venv/bin/python" tests/fmu/fly.py "$FMU" "$folder"
