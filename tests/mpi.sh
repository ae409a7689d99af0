#!/usr/bin/env bash
# An ensemble over the ranks of MPI (c_examples/ensemble_mpi.c), with MPICH and with Open MPI. With 1, 2, 3 and 4 ranks, and when
# killed in the middle and started again with another number of ranks, it writes the bytes of `sins ensemble`. The same holds with a
# log, with a scene with a unit, and with a single run. A damaged checkpoint is flown again; a checkpoint of another ensemble is rejected.
#
#     tests/mpi.sh [mpich] [openmpi]
#
# SINS_LIB_DIR: a folder with libsins.so and the program sins, used instead of building them.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/built.sh

[ $# -gt 0 ] || set -- mpich openmpi
need g++ c++
build_program
build_library
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# Open MPI: allows root, and more ranks than cores.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
scene=scene runs=420
machine=$(c++ -dumpmachine)

# A scene with both error data and a sensor that fails in flight; and the same scene with a log as its flight.
"$built/sins" scene write simulation2 -o "$out/scene.toml" --preset navigation --set flight.hours=0.25 --set flight.rate_hz=20 \
    --set options.error_model=rk4 --set options.run=5
cat >>"$out/scene.toml" <<'END'

[[failure]]
sensor = "gyro"
axis = "x"
kind = "bias_step"
size_deg_h = 3
from_s = 60
until_s = 120
END
"$built/sins" ensemble "$out/scene.toml" --runs $runs --quiet --out "$out"
# A day of a unit, in which no run is valid at first, and both error data.
unit_runs=130
"$built/sins" scene write c_examples/scenes/day.toml -o "$out/unit.toml" --set flight.rate_hz=2 --set options.error_model=rk4 \
    --set options.run=7
"$built/sins" ensemble "$out/unit.toml" --runs $unit_runs --quiet --out "$out"
"$built/sins" scene write simulation2 -o "$out/one.toml" --preset tactical --set flight.hours=0.1 --set flight.rate_hz=20
"$built/sins" ensemble "$out/one.toml" --runs 1 --quiet --out "$out"
log=c_examples/flights/airliner_cruise.csv
"$built/sins" ensemble "$out/scene.toml" --log $log --runs 70 --quiet --out "$out"

fly() { # RANKS OUT.csv
    timeout 300 "$mpirun" -n "$1" "$out/$mpi/ensemble_mpi" "$out/$scene.toml" $runs "$2" 2>"$2.words" || {
        cat "$2.words"
        return 1
    }
}

same() { # OUT.csv WHAT
    cmp "$out/${scene}_ensemble.csv" "$1"
    # Only the table and the messages are left.
    [ "$(ls "$out/$mpi" | grep -c "^$(basename "$1")\.[0-9]")" -eq 0 ]
    echo "$mpi: $2: the bytes of sins ensemble"
}

# Prints all descendants of a process.
below() {
    local child
    for child in $(pgrep -P "$1"); do
        echo "$child"
        below "$child"
    done
}

# Prints the checkpoints that have blocks.
filled() { # OUT.csv
    find "$out/$mpi" -name "$(basename "$1").[0-9]*" -not -name '*.part' -size +1k
}

# Starts a job with RANKS ranks and kills one of them when the first block is in a new file. The job cannot end before: rank 0 opens
# the table as a pipe without a reader, and waits.
kill_a_rank() { # RANKS OUT.csv
    local before
    before=$(filled "$2" | wc -l)
    mkfifo "$2.part"
    "$mpirun" -n "$1" "$out/$mpi/ensemble_mpi" "$out/$scene.toml" $runs "$2" >"$2.words" 2>&1 &
    local job=$! deadline=$((SECONDS + 120)) process victim=
    until [ "$(filled "$2" | wc -l)" -gt "$before" ]; do
        [ $SECONDS -lt $deadline ]
        sleep 0.02
    done
    for process in $(below $job); do
        if [ "$(cat "/proc/$process/comm" 2>/dev/null)" = ensemble_mpi ]; then
            victim=$process
        fi
    done
    kill -9 "$victim"
    if wait $job; then
        echo "$mpi: the job outlived its rank"
        exit 1
    fi
    rm "$2.part"
    [ ! -e "$2" ] || { echo "$mpi: a killed job wrote its table"; exit 1; }
}

for mpi; do
    case $mpi in
        mpich) need libmpich-dev "/usr/include/$machine/mpich/mpi.h" && need mpich /usr/bin/mpirun.mpich ;;
        openmpi) need libopenmpi-dev "/usr/lib/$machine/openmpi/include/mpi.h" && need openmpi-bin /usr/bin/mpirun.openmpi ;;
    esac || {
        could_not "$mpi" "its packages cannot be had"
        continue
    }
    mpirun=mpirun.$mpi
    MPICC=mpicc.$mpi SINS_LIB_DIR=$built c_examples/ensemble_mpi.sh "$out/$mpi" >/dev/null
    for ranks in 1 2 3 4; do
        fly $ranks "$out/$mpi/by_$ranks.csv"
        same "$out/$mpi/by_$ranks.csv" "$ranks ranks"
    done
    "$mpirun" -n 2 "$out/$mpi/ensemble_mpi" "$out/scene.toml" 70 "$out/$mpi/log.csv" $log
    cmp "$out/airliner_cruise_ensemble.csv" "$out/$mpi/log.csv"
    echo "$mpi: a log: the bytes of sins ensemble"

    killed=$out/$mpi/killed.csv
    kill_a_rank 3 "$killed"
    kill_a_rank 2 "$killed"
    fly 4 "$killed"
    grep -E '[1-9][0-9]* of 7 blocks were flown before' "$killed.words"
    same "$killed" "3 ranks, killed; 2 ranks, killed; 4 ranks"

    one=$out/$mpi/one.csv
    scene=one runs=1 fly 2 "$one"
    scene=one same "$one" "a single run"

    unit=$out/$mpi/unit.csv
    for ranks in 1 3; do
        scene=unit runs=$unit_runs fly $ranks "$unit"
        scene=unit same "$unit" "a unit, $ranks ranks"
        rm "$unit"
    done
    scene=unit runs=$unit_runs kill_a_rank 3 "$unit"
    scene=unit runs=$unit_runs fly 2 "$unit"
    grep -E '[1-9] of 3 blocks were flown before' "$unit.words"
    scene=unit same "$unit" "a unit, 3 ranks, killed; 2 ranks"

    damaged=$out/$mpi/damaged.csv
    kill_a_rank 2 "$damaged"
    file=$(filled "$damaged" | head -n 1)
    printf '\x5a' | dd of="$file" bs=1 seek=5000 conv=notrunc status=none
    fly 3 "$damaged"
    grep -F 'is damaged: its blocks are flown again' "$damaged.words"
    same "$damaged" "a damaged file"

    foreign=$out/$mpi/foreign.csv
    kill_a_rank 2 "$foreign"
    file=$(filled "$foreign" | head -n 1)
    cp "$file" "$out/$mpi/kept"
    if runs=419 fly 2 "$foreign"; then
        echo "$mpi: the file of another order was taken"
        exit 1
    fi
    grep -F 'is of another scene, log, number of runs or version: remove it' "$foreign.words" ||
        { echo "$mpi: a refused job did not say why"; exit 1; }
    cmp "$file" "$out/$mpi/kept"
    [ ! -e "$foreign" ] || { echo "$mpi: a refused job wrote its table"; exit 1; }
done
report_not_run
