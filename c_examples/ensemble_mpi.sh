#!/usr/bin/env bash
# Builds ensemble_mpi, an ensemble on many machines, into a folder (default target/c_examples): ensemble_mpi.sh [FOLDER]. Needs the
# compiler of an MPI: Debian's libmpich-dev or libopenmpi-dev.
# MPICC: this compiler, default mpicc.
# SINS_LIB_DIR: a folder with a libsins.so, used instead of building one.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
out=${1:-$root/target/c_examples}
mkdir -p "$out"
if [ -n "${SINS_LIB_DIR:-}" ]; then
    lib=$(cd "$SINS_LIB_DIR" && pwd)
else
    cd "$root"
    cargo rustc --release --lib --crate-type cdylib
    lib=$(cd "${CARGO_TARGET_DIR:-target}/release" && pwd)
fi
${MPICC:-mpicc} -std=c99 -O2 -Wall -Wextra -Wpedantic -Werror -I"$root/include" -o "$out/ensemble_mpi" \
    "$root/c_examples/ensemble_mpi.c" -L"$lib" -lsins -lm -Wl,-rpath,"$lib"
echo "built: mpirun -n 4 $out/ensemble_mpi SCENE.toml RUNS OUT.csv [LOG.csv]"
