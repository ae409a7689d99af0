#!/bin/sh
# Runs UNIT_LINKER for the binaries of the Functional Mock-up Unit, which export only its own functions. rustc also lists the
# functions of the library: in a version script for ELF, in a .def file for Windows.
for argument; do
    case $argument in
        -Wl,--version-script=*) list=${argument#*script=} ;;
        -Wl,*.def) list=${argument#-Wl,} ;;
        *sins_fmu*.so | *sins_fmu*.dll) is_unit=yes ;;
    esac
done
[ -z "$list" ] || [ -z "$is_unit" ] || sed -i '/^ *"*sins_/d' "$list"
exec "$UNIT_LINKER" "$@"
