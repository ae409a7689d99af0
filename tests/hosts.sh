#!/usr/bin/env bash
# Hosts in languages other than C. Each is built with its compiler's warnings as errors and flies built-in scenes to the bits of the
# C host. Its calls with arrays, matrices, texts and bytes give the same results as in C. Its structs and fields have the offsets,
# and its constants have the values, of the header.
#
#     tests/hosts.sh             all hosts
#     tests/hosts.sh fortran     one of them
#
# SINS_LIB_DIR: a folder with a libsins.so and the interfaces `bindings` of the same build, used instead of building them.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/built.sh
. tests/support/node.sh

hosts="fortran ada python notebooks javascript octave fortran_windows"
scenes="aerobatics commuter"
out=$PWD/target/hosts
bindings=$built/bindings
link=("-L$built" -lsins "-Wl,-rpath,$built")

# The C host and the C compiler give the expected results.
c() {
    need g++ c++
    c_examples/build.sh >"$out/build_c" 2>&1 || { cat "$out/build_c"; return 1; }
    for scene in $scenes; do
        target/c_examples/harness "$scene" >"$out/$scene.c"
    done
    mkdir -p "$out/c"
    awk -f tests/hosts/layout_c.awk include/sins.h include/sins_flight.h include/sins_analysis.h include/sins_unit.h include/sins_ensemble.h include/sins_scene.h >"$out/c/layout.c"
    for program in tests/hosts/calls.c "$out/c/layout.c"; do
        cc -std=c99 -Wall -Wextra -Wpedantic -Werror -I include -o "$out/c/$(basename "$program" .c)" "$program" "${link[@]}"
    done
    numbers c
    echo "c: $(grep -c . "$out/numbers.c") numbers; scenes $scenes"
}

fortran() {
    need gfortran gfortran
    fortran_programs fortran gfortran "${link[@]}"
    same_as_c fortran
}

# fortran_programs FOLDER COMPILER LIBRARY...
fortran_programs() {
    local folder=$out/$1 compiler=$2 program
    shift 2
    mkdir -p "$folder"
    awk -f tests/hosts/layout_fortran.awk "$bindings/sins.f90" >"$folder/layout.f90"
    for program in c_examples/fortran/fly.f90 tests/hosts/calls.f90 "$folder/layout.f90"; do
        "$compiler" -std=f2008 -Wall -Wextra -Werror -O2 -J "$folder" -o "$folder/$(basename "$program" .f90)" \
            "$bindings/sins.f90" "$program" "$@"
    done
}

# Uses the DLLs and the wine of tests/windows.sh.
fortran_windows() {
    fortran_under_wine 64 x86_64 "$PWD/target/wine" /usr/lib/wine/wine64 /usr/lib/wine/wineserver64
    fortran_under_wine 32 i686 "$PWD/target/wine32/prefix" "$PWD/target/wine32/usr/lib/wine/"{wine,wineserver32}
}

# fortran_under_wine BITS PROCESSOR PREFIX WINE SERVER
fortran_under_wine() {
    local host=fortran_windows_$1 program
    if ! [ -e "target/windows/$1/sins.dll" ] || ! [ -d "$3" ]; then
        could_not "Fortran on $1-bit Windows" "there is no DLL and no wine before tests/windows.sh"
        return
    fi
    need "gfortran-mingw-w64-$(echo "$2" | tr _ -)-win32" "$2-w64-mingw32-gfortran-win32"
    mkdir -p "$out/$host"
    cp "target/windows/$1"/*.dll "$out/$host"
    fortran_programs "$host" "$2-w64-mingw32-gfortran-win32" "$out/$host/sins.dll" -static
    for program in fly calls layout; do
        printf '#!/bin/sh\nWINEDEBUG=-all WINEPREFIX=%s WINESERVER=%s exec %s %s.exe "$@"\n' \
            "$3" "$5" "$4" "$out/$host/$program" >"$out/$host/$program"
        chmod +x "$out/$host/$program"
    done
    same_as_c "$host"
}

ada() {
    need gnat gnatmake
    mkdir -p "$out/ada"
    awk -f tests/hosts/layout_ada.awk "$bindings/sins.ads" >"$out/ada/layout.adb"
    for program in "$PWD/c_examples/ada/fly.adb" "$PWD/tests/hosts/calls.adb" "$out/ada/layout.adb"; do
        (cd "$out/ada" && gnatmake -q -gnat2012 -gnatwa -gnatwe -O2 -I"$bindings" "$program" -largs "${link[@]}")
    done
    same_as_c ada
}

# Uses Debian's own Python, because Debian's packages are for it.
python() {
    local packages=/usr/lib/python3/dist-packages
    need python3 /usr/bin/python3
    need mypy mypy
    for package in numpy matplotlib scipy pandas pycparser; do
        need "python3-$package" "$packages/$package/__init__.py"
    done
    export SINS_LIBRARY=$built/libsins.so PYTHONPATH=$bindings PYTHONDONTWRITEBYTECODE=1
    mkdir -p "$out/python"
    for program in fly:c_examples/python/fly.py layout:tests/hosts/layout_python.py calls:tests/hosts/calls.py; do
        printf '#!/bin/sh\nexec /usr/bin/python3 "%s" "$@"\n' "$PWD/${program#*:}" >"$out/python/${program%:*}"
        chmod +x "$out/python/${program%:*}"
    done
    same_as_c python
    sed 's/^hours = .*/hours = 1/' c_examples/scenes/patrol.toml >"$out/patrol.toml"
    target/c_examples/harness "$out/patrol.toml" >"$out/patrol.c"
    for picture in png svg; do
        "$out/python/fly" "$out/patrol.toml" -o "$out/patrol.$picture" >"$out/patrol.python"
        same_figures patrol python
    done
    doors
    /usr/bin/python3 tests/hosts/doors.py "$doors"
    /usr/bin/python3 tests/hosts/test_sins.py 2>"$out/test_sins" || { cat "$out/test_sins"; return 1; }
    build_program
    /usr/bin/python3 tests/hosts/test_package.py "$built/sins" 2>"$out/test_package" || { cat "$out/test_package"; return 1; }
    mypy --config-file tests/hosts/mypy.ini --cache-dir "$out/mypy" "$bindings/sins"
    echo "python: $(cat "$out/test_sins" "$out/test_package" | grep "^Ran "); the patrol is drawn in target/hosts/patrol.png"
    /usr/bin/python3 tests/hosts/xplane.py
    mkdir -p "$out/aircraft"
    /usr/bin/python3 tests/hosts/aircraft.py "$built/sins" "$out/aircraft"
    # The day in the south, over the date line.
    sed 's/^latitude_deg = .*/latitude_deg = -34.5/; s/^longitude_deg = .*/longitude_deg = 179.9/' c_examples/scenes/day.toml >"$out/south.toml"
    for scene in c_examples/scenes/day.toml "$out/south.toml" over_the_pole; do
        rm -rf "$out/bus"
        "$built/sins" fly "$scene" --quiet --out "$out/bus" --name flight --bus words.csv --imu imu.csv
        /usr/bin/python3 tests/hosts/arinc429.py "$out"/bus/{words,flight,imu}.csv $(ls "$out"/bus/flight_unit.csv 2>/dev/null)
    done
    /usr/bin/python3 tests/hosts/arinc429.py
}

# The notebooks of c_examples, beside pyins (PyPI: python-ins).
notebooks() {
    local folder=$PWD/target/notebooks
    need python3-venv /usr/share/doc/python3-venv
    [ -x "$folder/bin/python" ] || python3 -m venv "$folder"
    "$folder/bin/pip" install --quiet --disable-pip-version-check -r tests/hosts/notebooks.txt || {
        could_not "notebooks" "their packages cannot be installed from PyPI"
        return
    }
    SINS_LIBRARY=$built/libsins.so PYTHONPATH=$bindings "$folder/bin/python" tests/hosts/notebooks.py 2>"$out/notebooks" ||
        { cat "$out/notebooks"; return 1; }
}

# The library as WebAssembly in Node. Its hosts use the package that npm installs from the file of `npm pack`.
javascript() {
    local package=$PWD/target/wasm installed=$out/javascript/installed program
    release/wasm.sh "$package"
    need npm npm
    rm -rf "$out/javascript"
    mkdir -p "$installed"
    echo '{ "private": true }' >"$installed/package.json"
    npm pack "$package" --silent --pack-destination "$installed" >/dev/null
    npm install --prefix "$installed" --silent --offline --no-audit --no-fund "$installed"/sins-*.tgz
    cp c_examples/web/fly.mjs "$installed"
    (cd "$installed" && node fly.mjs commuter | grep -q "^position m") || { echo "javascript: the installed package does not fly"; return 1; }
    export SINS_MODULE=$installed/node_modules/sins/sins.mjs
    for program in fly:c_examples/web/fly.mjs layout:tests/hosts/layout_javascript.mjs calls:tests/hosts/calls.mjs; do
        printf '#!/bin/sh\nexec node "%s" "$@"\n' "$PWD/${program#*:}" >"$out/javascript/${program%:*}"
        chmod +x "$out/javascript/${program%:*}"
    done
    same_as_c javascript "identif|recorded_increment|agreement"
    node --expose-gc --test tests/hosts/test_sins.mjs >"$out/test_javascript" || { cat "$out/test_javascript"; return 1; }
    doors
    node tests/hosts/doors.mjs "$doors"
    echo "javascript: $(sed -n 's/^# pass /tests passed: /p' "$out/test_javascript")"
    node_packages $typescript
    cp tests/hosts/types.mts "$installed"
    target/node/node_modules/.bin/tsc --noEmit --strict --target esnext --module nodenext --types node \
        --typeRoots target/node/node_modules/@types "$installed/types.mts"
    echo "javascript: the types are those that TypeScript expects"
}

# The MEX file flies a log: a matrix of samples.
octave() {
    need octave-dev mkoctfile
    mkdir -p "$out/octave"
    mkoctfile --mex -Wall -Wextra -Werror -Iinclude -o "$out/octave/sins_fly.mex" c_examples/octave/sins_fly.c "${link[@]}"
    octave-cli --norc --path "$out/octave" c_examples/octave/fly.m >"$out/fighter.octave"
    grep -q "^sins:SINS_ERROR_TIME_ORDER" "$out/fighter.octave"
    target/c_examples/harness c_examples/scenes/fighter.toml >"$out/fighter.c"
    same_figures fighter octave
    octave-cli --norc --path "$out/octave" tests/hosts/test_octave.m
    echo "octave: flies a log to the bits of C"
}

# doors: every scene with its end, in the folder $doors, which this test writes.
doors() {
    doors=${CARGO_TARGET_DIR:-target}/tmp/program/doors/complete
    [ -e "$doors/ends.txt" ] || cargo test --quiet -p sins-cli --test program doors::
}

# numbers HOST: stores the output of its programs `layout` and `calls`, a name and a number in each line.
numbers() {
    { "$out/$1/layout" | LC_ALL=C sort; "$out/$1/calls"; } >"$out/numbers.$1"
}

# same_as_c HOST [PATTERN]: its program `fly` flies and reports an error, and `layout` and `calls` print the same as in C, but for names
# of the pattern, which the host lacks.
same_as_c() {
    for scene in $scenes; do
        "$out/$1/fly" "$scene" >"$out/$scene.$1"
        same_figures "$scene" "$1"
    done
    if "$out/$1/fly" no_such_scene 2>"$out/refused.$1"; then
        echo "$1: a scene that there is not was flown"
        return 1
    fi
    grep -q "name: must be the name of a built-in scene.*SINS_ERROR_INVALID_ARGUMENT" "$out/refused.$1"
    numbers "$1"
    paste <(grep -viE "${2:-^$}" "$out/numbers.c") "$out/numbers.$1" | awk -v host="$1" '
        NF != 4 || $1 != $3 || $2 + 0 != $4 + 0 { print host ": in C and here: " $0; bad = 1 }
        END { exit bad }'
    echo "$1: flies to the bits of C; sizes, offsets, constants and what calls give are those of C"
}

# same_figures SCENE HOST: the figures that the host printed for the scene equal those of the C host.
same_figures() {
    paste <(figures 1 "$out/$1.c") <(figures 3 "$out/$1.$2") |
        awk -v host="$2 $1" '
            NF != 2 || $1 + 0 != $2 + 0 || $1 == 0 { print host ": line " NR ": " $0; bad = 1 }
            END { if (NR != 9 || bad) { print host ": not the figures of the C host"; exit 1 } }'
}

# figures COUNT FILE: prints the errors at the end of a host's output, one in each line. FILE has COUNT of them in each line, after
# the title. In the output of the C host, the last column belongs to the error equations and is left out.
figures() {
    awk -v count="$1" '
        /errors at the end/ { end = 1; next }
        end && /^ *(position|velocity|misalignment)/ {
            if (count == 1) print $(NF - 1)
            else for (k = NF - count + 1; k <= NF; k++) print $k
        }' "$2"
}

mkdir -p "$out"
c
for host in ${*:-$hosts}; do
    "$host"
done
report_not_run
