#!/usr/bin/env bash
# A real INS: the drive of an HGuide n380 and three flights of an unmanned aircraft, which the package onavdata of PyPI has. `sins` finds
# their columns, judges, flies and smooths them, identifies their sensors, and predicts how far those of the n380 drift. Nothing of the data is
# stored in this repository, because their licence is not stated. docs/drift.svg is target/real_imu/drift.svg.
#
#     tests/real_imu.sh
#
# SINS_LIB_DIR: a folder with the program `sins`, used instead of building it.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/built.sh

out=$PWD/target/real_imu
mkdir -p "$out"
build_program
need python3-venv /usr/share/doc/python3-venv
[ -x "$out/venv/bin/python" ] || python3 -m venv "$out/venv"
if "$out/venv/bin/pip" install --quiet --disable-pip-version-check onavdata==0.2.5 pandas; then
    "$out/venv/bin/python" tests/real_imu.py "$built/sins" "$out"
else
    could_not "a real INS" "onavdata cannot be installed from PyPI"
fi
report_not_run
