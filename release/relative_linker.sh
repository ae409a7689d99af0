#!/usr/bin/env bash
# Runs RELATIVE_LINKER with relative paths of this project. GNU ld sorts imported functions by the paths of the files that name
# them: with absolute paths, sins.exe would have another order in each folder.
exec "$RELATIVE_LINKER" "${@//"$PWD/"/}"
