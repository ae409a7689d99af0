#!/usr/bin/env bash
# Builds packages (release/package.sh, with the same arguments) and uses each like a user: unpacks it into an empty folder, builds
# examples with it and runs them. Tests that could not run are reported at the end.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/wine.sh
. tests/support/pe.sh
. tests/support/folders.sh
. release/build.sh

packages=("$@")
[ $# -gt 0 ] || packages=(linux-x86_64 linux-i686 linux-arm64 windows-x64 windows-x86 fmu)
warnings="-std=c99 -O2 -Wall -Wextra -Wpedantic -Werror"
dist=target/dist
out=$PWD/target/packages
digests=$(sed -n 's/.*the same on all platforms: `\([0-9a-f ]*\)`.*/\1/p' tests/README.md)
glibc=2.17
need g++ cc
need pkgconf pkg-config
rm -rf "$out"
mkdir -p "$out"

# flies RUNNER...: runs a program of tests/c, which must print the digests of tests/README.md.
flies() {
    local found
    found=$("$@" | tr -d '\r' | sed -n 's/^digests: \([0-9a-f]*\) .*/\1/p' | uniq | paste -sd' ')
    [ -n "$digests" ] && [ "$found" = "$digests" ] || fail "$*: digests $found, not $digests"
}

# states WHAT VERSION: checks that a part of a package has the version of the release.
states() {
    [ "$2" = "$version" ] || fail "$1: version $2, not $version"
}

# files FOLDER NAME...: checks that the files of every package and these files exist.
files() {
    local folder=$1 name page
    shift
    for name in include/{sins,sins_flight,sins_analysis,sins_unit,sins_ensemble,sins_scene,sins_functions}.h \
        include/{sins,sins_handle,sins_flight,sins_analysis,sins_unit,sins_ensemble,sins_scene}.hpp \
        $(sed s,^,share/sins/, cmake/bindings.txt) c_examples/{harness.c,loadlibrary.c,sins_loader.h} \
        c_examples/scenes/patrol.toml README.md CHANGELOG.md CITATION.cff docs/packages.md docs/sins.h/index.html \
        licences/{LICENSE-MIT,LICENSE-APACHE,crates.txt,rust-library.html} "$@"; do
        [ -s "$folder/$name" ] || fail "$folder: no $name"
    done
    find "$folder" -name '*.md' | while read -r page; do
        { grep -oE '\]\([^) ]+' "$page" || true; } | sed -E 's/..//; s/#.*//; /:\/\//d; /^$/d' | while read -r name; do
            [ -e "${page%/*}/$name" ] || fail "$page: no file $name"
        done
    done
    for name in 'One object, nine functions' 'flight simulator *FlightSample'; do
        grep -q "$name" "$folder/docs/sins.h/index.html" || fail "$folder: the manual does not begin with \"$name\""
    done
    grep -rq 'Failures of sensors' "$folder"/docs/sins.h/group__*.html || fail "$folder: the manual has no subjects"
    name_no_folder "$folder"
}

# wheel FOLDER: installs the package for Python from the file in the package, and flies: by the interface in C without numpy, and with it.
wheel() {
    local found
    python3 -c 'import ensurepip' 2>/dev/null || install python3-venv
    python3 -m venv "$out/python"
    "$out/python/bin/pip" install --quiet --no-index --no-deps "$1"/share/sins/sins-*.whl
    found=$("$out/python/bin/python" -c 'import importlib.metadata; print(importlib.metadata.version("sins"))')
    states "$1: the wheel" "$found"
    states "$1: sins.__version__" "$("$out/python/bin/python" -c 'import sins; print(sins.__version__)')"
    (cd "$out" && "$out/python/bin/python" -c 'if True:
        from sins import c as sins
        with sins.create(None) as sim:
            sins.set_gyro(sim, sins.gyro_params(bias_rad_s=(0.01 * sins.DEG_PER_HOUR, 0, 0)))
            for second in range(3601):
                sins.push_sample(sim, sins.flight_sample(time_s=second, latitude_rad=39.9 * sins.DEG))
                sins.step(sim)
            print(f"{sins.get_errors(sim, sins.ERRORS_NAVIGATION).position_enu_m[0]:.0f} m east")') | grep -x -- '-145 m east' ||
        fail "$1: the wheel does not fly"
    "$out/python/bin/pip" install --quiet numpy
    (cd "$out" && "$out/python/bin/python" -c 'if True:
        import sins
        run = sins.fly("rest", hours=1, gyro={"bias_deg_h": [0.01, 0, 0]})
        print(f"{run.position_error_m[-1, 0]:.0f} m east")') | grep -x -- '-145 m east' || fail "$1: the package of the wheel does not fly"
}

# as_it_stands FOLDER SYSTEM PREFIX: each header compiles alone, in C and C++; the host of the README, built in the folder by the README's
# command for the system, with the compilers whose names begin with PREFIX. Sets host to the program.
as_it_stands() {
    local folder=$1 header language standard compiler command
    for header in "$folder"/include/*.h*; do
        for language in c:c99:gcc c++:c++11:g++; do
            IFS=: read -r language standard compiler <<<"$language"
            [[ $header = *.hpp && $language = c ]] || "$3$compiler" -x "$language" -std="$standard" -Wall -Wextra -Wpedantic -Werror \
                -I "$folder/include" -include "$header" -fsyntax-only /dev/null || fail "$header does not compile alone as $standard"
        done
    done
    tr -d '\r' <"$folder/README.md" >"$out/README"
    awk '/^```c$/ { inside = 1; next } /^```$/ && inside { exit } inside' "$out/README" >"$folder/host.c"
    command=$(sed -nE "s/^    ((cc|gcc) host\.c .*[^ ]) +# $2\$/\1/p" "$out/README")
    host=$folder/$(sed -E 's/.* -o ([^ ]+) .*/\1/' <<<"$command")
    (cd "$folder" && eval "$3gcc ${command#* }") || fail "$folder: the README's host for $2 is not built by: $command"
}

# as_printed RUNNER... HOST: the README's host prints what stands beside its last line.
as_printed() {
    local expected
    expected=$(sed -nE 's,.*printf\(.*/\* (.*) \*/$,\1,p' "$out/README" | head -n 1)
    [ -n "$expected" ] && [ "$("$@" | tr -d '\r')" = "$expected" ] || fail "$*: not \"$expected\""
}

# documents FOLDER RUNNER... PROGRAM: each command of the program has a manual page, and its completions are those that it prints.
documents() {
    local folder=$1 command
    shift
    for command in '' $("$@" --help | sed -nE '/^Commands:/,/^$/s/^  ([a-z]+) .*/-\1/p' | grep -vx -- -help); do
        gzip -t "$folder/share/man/man1/sins$command.1.gz" || fail "$folder: no manual page of sins${command/-/ }"
    done
    "$@" completions bash | diff - "$folder/share/bash-completion/completions/sins" || fail "$folder: other completions"
}

# linux NAME PROCESSOR RUNNER...
linux() {
    local name=sins-$version-$1 compiler=$2-linux-gnu-gcc folder=$out/sins-$version-$1 file flags
    local readelf=$2-linux-gnu-readelf runner=("${@:3}")
    tar -C "$out" -xzf "$dist/$name.tar.gz"
    tar -C "$out" -xzf "$dist/$name-debug.tar.gz"
    name_no_folder "$folder-debug"
    files "$folder" bin/sins lib/{libsins.a,libsins.so,libsins.so.1,pkgconfig/sins.pc,cmake/sins/sinsConfig.cmake}
    for file in "$folder/lib/libsins.so" "$folder/bin/sins"; do
        "$readelf" -VW "$file" | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n1 >"$out/newest"
        echo "GLIBC_$glibc" | cat "$out/newest" - | sort -VC || fail "$file needs $(cat "$out/newest")"
        "$readelf" -lW "$file" | grep -E 'LOAD.* RWE|GNU_STACK.*E ' && fail "$file: memory both written and run"
    done
    # Tables of handles are zeros, which take no room in the file.
    local data
    data=$("$readelf" -SW "$folder/lib/libsins.so" | sed -nE 's/.* \.data +PROGBITS +[0-9a-f]+ [0-9a-f]+ ([0-9a-f]+) .*/\1/p')
    [ $((16#$data)) -le 16384 ] || fail "$folder/lib/libsins.so: 0x$data bytes of data"
    diff <(functions) <("$readelf" --dyn-syms -W "$folder/lib/libsins.so" | awk '$5 == "GLOBAL" && $7 != "UND" { print $8 }' | LC_ALL=C sort) ||
        fail "$folder: exports are not the functions of the header"

    # The link that debuggers follow to the debug file, which must have the line numbers.
    file=$("$readelf" -p .gnu_debuglink "$folder/lib/libsins.so" | grep -o 'libsins[^ ]*debug')
    "$readelf" -SW "$folder-debug/lib/$file" | grep debug_line >/dev/null || fail "$file: no debug symbols"

    flags=$(PKG_CONFIG_PATH=$folder/lib/pkgconfig pkg-config --cflags --libs sins)
    "$compiler" $warnings c_examples/minimal.c -o "$out/minimal" $flags -lm -Wl,-rpath,"$folder/lib"
    "$compiler" $warnings -D_GNU_SOURCE tests/c/digests.c -o "$out/digests" $flags -lm -lpthread -Wl,-rpath,"$folder/lib"
    flags=$(PKG_CONFIG_PATH=$folder/lib/pkgconfig pkg-config --static --cflags --libs sins)
    "$compiler" $warnings c_examples/minimal.c -o "$out/minimal_static" -static $flags
    "${runner[@]}" "$out/minimal" >"$out/minimal.txt"
    "${runner[@]}" "$out/minimal_static" | diff "$out/minimal.txt" - || fail "$folder: libsins.a gives another flight"
    flies "${runner[@]}" "$out/digests"
    as_it_stands "$folder" Linux "$2-linux-gnu-"
    as_printed "${runner[@]}" "$host"
    states "$folder: sins --version" "$("${runner[@]}" "$folder/bin/sins" --version | sed 's/^sins //')"
    documents "$folder" "${runner[@]}" "$folder/bin/sins"
    states "$folder: sins.pc" "$(PKG_CONFIG_PATH=$folder/lib/pkgconfig pkg-config --modversion sins)"
    states "$folder: sinsConfigVersion.cmake" \
        "$(sed -nE 's/^set\(PACKAGE_VERSION "(.*)"\)$/\1/p' "$folder/lib/cmake/sins/sinsConfigVersion.cmake")"
    [ "$2" != "$(uname -m)" ] || wheel "$folder"
    echo "$name: $(cat "$out/newest"), exports, digests"
}

# windows NAME PROCESSOR
windows() {
    local name=sins-$version-$1 folder=$out/sins-$version-$1 compiler=$2-w64-mingw32-gcc library file status
    need unzip unzip
    need clang clang
    need lld lld-link
    need cmake cmake
    need "g++-mingw-w64-$(echo "$2" | tr _ -)" "$2-w64-mingw32-g++"
    unzip -q "$dist/$name.zip" -d "$out"
    files "$folder" bin/{sins.dll,sins.exe,loadlibrary.exe} lib/{sins.lib,libsins.dll.a,sins.def,cmake/sins/sinsConfig.cmake} licences/mingw-w64.txt
    check_pe "$folder/bin/sins.dll" "$2" kernel32.dll msvcrt.dll ntdll.dll
    check_pe "$folder/bin/sins.exe" "$2" advapi32.dll kernel32.dll msvcrt.dll ntdll.dll ws2_32.dll
    for file in "$folder"/bin/*; do
        "$2-w64-mingw32-objdump" -p "$file" | grep '^Time/Date.*1970' >/dev/null || fail "$file: has the time of its build"
    done
    "$2-w64-mingw32-windres" -i "$folder/bin/sins.dll" -J coff -O rc | grep -F "\"FileVersion\", \"$version\"" ||
        fail "$folder: sins.dll has no version"
    [ -s "$(echo "$folder"/share/sins/sins-*-py3-none-win*.whl)" ] || fail "$folder: no wheel"
    for file in README.md include/sins.h licences/LICENSE-MIT; do
        if grep -vq $'\r$' "$folder/$file"; then fail "$folder/$file: lines end without a carriage return"; fi
    done
    as_it_stands "$folder" "Windows: .*" "$2-w64-mingw32-"
    have_wine "$2" || return 0
    as_printed "$wine" "$host"
    for library in sins.lib libsins.dll.a; do
        "$compiler" $warnings c_examples/minimal.c -I "$folder/include" "$folder/lib/$library" -o "$folder/bin/minimal.exe"
        "$wine" "$folder/bin/minimal.exe" >"$out/$library.txt"
        "$compiler" -std=c99 -D__USE_MINGW_ANSI_STDIO=1 -O1 tests/c/digests.c -I "$folder/include" "$folder/lib/$library" \
            -o "$folder/bin/digests.exe" -static -lpthread
        flies "$wine" "$folder/bin/digests.exe"
    done
    [ -s "$out/sins.lib.txt" ] && diff "$out/sins.lib.txt" "$out/libsins.dll.a.txt" || fail "$folder: the import libraries differ"
    cmake -S tests/install -B "$out/cmake-$2" -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_EXE_LINKER_FLAGS=-static \
        -DCMAKE_C_COMPILER="$compiler" -DCMAKE_CXX_COMPILER="$2-w64-mingw32-g++" -DCMAKE_PREFIX_PATH="$folder"
    cmake --build "$out/cmake-$2"
    cp "$out/cmake-$2"/*_sins.exe "$folder/bin"
    "$wine" "$folder/bin/minimal_sins.exe" | diff "$out/sins.lib.txt" - || fail "$folder: find_package gives another flight"
    "$wine" "$folder/bin/cpp_host_sins.exe" >/dev/null
    # As with MSVC's linker, but without MSVC's C library.
    cat >"$out/host.c" <<'END'
__declspec(dllimport) unsigned __cdecl sins_abi_version(void);
int start(void) { return 40 + (int)sins_abi_version(); }
END
    clang "--target=$2-pc-windows-msvc" -c "$out/host.c" -o "$out/host.obj"
    lld-link /nologo /entry:start /subsystem:console /nodefaultlib "$out/host.obj" "$folder/lib/sins.lib" \
        "/out:$folder/bin/host.exe"
    status=0
    "$wine" "$folder/bin/host.exe" || status=$?
    [ "$status" -eq 41 ] || fail "$folder: a host linked with sins.lib as by MSVC ends with $status"
    (cd "$folder/bin" && "$wine" loadlibrary.exe)
    states "$folder: sins.exe --version" "$(cd "$folder/bin" && "$wine" sins.exe --version | tr -d '\r' | sed 's/^sins //')"
    echo "$name: exports, imports, version, digests by both import libraries"
}

# fmu: tests/fmu.sh uses the unit.
fmu() {
    need unzip unzip
    states "sins-$version.fmu" "$(unzip -p "$dist/sins-$version.fmu" modelDescription.xml |
        tr '\n' ' ' | sed -nE 's/.*<fmiModelDescription[^>]* version="([^"]*)".*/\1/p')"
}

release/package.sh "${packages[@]}"
(cd "$dist" && sha256sum --check SHA256SUMS)
for package in "${packages[@]}"; do
    echo "== $package"
    case $package in
        linux-x86_64) linux linux-x86_64 x86_64 env ;;
        linux-i686)
            need g++-i686-linux-gnu i686-linux-gnu-g++
            need libc6-dev-i386-cross /usr/i686-linux-gnu/lib/libc.so
            need qemu-user qemu-i386
            linux linux-i686 i686 qemu-i386 -L /usr/i686-linux-gnu
            ;;
        linux-arm64)
            need g++-aarch64-linux-gnu aarch64-linux-gnu-g++
            need libc6-dev-arm64-cross /usr/aarch64-linux-gnu/lib/libc.so
            need qemu-user qemu-aarch64
            linux linux-arm64 aarch64 qemu-aarch64 -L /usr/aarch64-linux-gnu
            ;;
        windows-x64) windows windows-x64 x86_64 ;;
        windows-x86) windows windows-x86 i686 ;;
        fmu) fmu ;;
    esac
done

report_not_run
