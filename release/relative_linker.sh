#!/usr/bin/env bash
# RELATIVE_LINKER with the paths of this project made relative. GNU ld sorts imported functions by the paths of the files that name
# them: absolute ones gave sins.exe another order in each folder.
exec "$RELATIVE_LINKER" "${@//"$PWD/"/}"
