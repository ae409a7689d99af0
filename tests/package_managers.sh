#!/usr/bin/env bash
# Makes the packages of docs/packages.md, "Package managers", and uses each as the users of its package manager do: Debian's in a new
# Debian, RPM's in an empty tree, Conan's with a project that finds it by CMakeDeps, vcpkg's port with stand-ins for the functions of vcpkg.
#
#     tests/package_managers.sh             all
#     tests/package_managers.sh deb rpm     these
#
# SINS_LIB_DIR: as in c_examples/build.sh.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/debian.sh
managers="deb rpm conan vcpkg"
out=$PWD/target/package_managers
hosts=$PWD/tests/install
version=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
abi=$(sed -n 's/^#define SINS_HEADER_ABI //p' include/sins.h)
bindings=$(sed s,^,share/sins/, cmake/bindings.txt)
headers=$(cd include && printf 'include/%s\n' *.h *.hpp)
need g++ c++
need cmake cmake
need make make
need pkgconf pkg-config
need file file

fail() {
    echo "$*" >&2
    exit 1
}

# equal EXPECTED FOUND WHAT: both are lists of lines.
equal() {
    diff <(sort <<<"$1") <(sort <<<"$2") || fail "$3: not the expected ones"
}

# same PROGRAM EXAMPLE: the program prints the same as the example that c_examples/build.sh built.
same() {
    diff <("$1") "$out/$2.txt" || fail "$1 prints something else"
}

# package KIND OPTION...: builds the library, with the cargo folder of tests/install.sh, and packs it.
package() {
    rm -rf "${out:?}/$1"
    cmake -S . -B "$out/$1/build" -DCMAKE_INSTALL_PREFIX=/usr -DSINS_CARGO_TARGET_DIR="$PWD/target/install/build/cargo" "${@:2}" >/dev/null
    cmake --build "$out/$1/build"
    cpack --config "$out/$1/build/CPackConfig.cmake" -G "${1^^}" -B "$out/$1" >"$out/$1/log" || { cat "$out/$1/log"; return 1; }
}

# found FOLDER OPTION...: the project tests/install finds the library below FOLDER by find_package.
found() {
    cmake -S "$hosts" -B "$1/hosts" -DCMAKE_PREFIX_PATH="$1/usr" "${@:2}" >/dev/null
    grep -F "sins_DIR:PATH=$1/" "$1/hosts/CMakeCache.txt" || fail "find_package found another sins"
    cmake --build "$1/hosts" >/dev/null
    for example in minimal cpp_host; do
        same "$1/hosts/${example}_sins" $example
        same "$1/hosts/${example}_static" $example
    done
}

# development LIBRARIES DOCUMENTS: the files of the package for developers, below /usr.
development() {
    printf '%s\n' "$headers" "$1"/cmake/sins/sinsConfig{,Version}.cmake "$1"/libsins.{a,so} "$1/pkgconfig/sins.pc" "$bindings"
}

deb() {
    local root=$out/debian multiarch tree=$out/deb/tree
    need lintian lintian
    need dpkg-dev dpkg-shlibdeps
    export DEBFULLNAME=${DEBFULLNAME:-The sins developers} DEBEMAIL=${DEBEMAIL:-sins@debian.org} # lintian wants an address
    package deb
    lintian --allow-root --fail-on error "$out"/deb/*.deb
    multiarch=$(dpkg-architecture -qDEB_HOST_MULTIARCH)
    for one in "$out"/deb/*.deb; do dpkg-deb -x "$one" "$tree"; done
    equal "$(development "lib/$multiarch")
$(printf '%s\n' share/doc/libsins-dev/{changelog.Debian.gz,changelog.gz,copyright})" \
        "$(contents "$out"/deb/libsins-dev_*.deb)" "the files of libsins-dev"
    equal "$(printf '%s\n' "lib/$multiarch/libsins.so.$abi"{,.0.0} "share/doc/libsins$abi"/{changelog.Debian.gz,changelog.gz,copyright,crates.txt})" \
        "$(contents "$out/deb/libsins$abi"_*.deb)" "the files of libsins$abi"
    found "$tree"

    # A Debian of this machine's release. Its compiler builds the host.
    debian "$root" || { could_not "Debian's packages in a new Debian" "debootstrap failed"; return 0; }
    inside "$root" 'dpkg --purge libsins-dev libsins1 2>/dev/null; rm -rf /packages' # of a test that failed
    as_root mkdir "$root/packages"
    as_root cp "$out"/deb/*.deb c_examples/minimal.c "$root/packages"
    files "$root" >"$out/before"
    inside "$root" 'cd /packages && apt-get install -qq -y -o Dpkg::Use-Pty=0 ./libsins1_*.deb ./libsins-dev_*.deb </dev/null'
    inside "$root" "ldconfig -p" | grep "libsins.so.$abi" >/dev/null || fail "the loader does not know libsins.so.$abi"
    inside "$root" 'cd /packages && cc minimal.c -o shared $(pkg-config --cflags --libs sins) -lm && ./shared' | diff "$out/minimal.txt" -
    inside "$root" 'cd /packages && cc minimal.c -o static -static $(pkg-config --static --cflags --libs sins) 2>/dev/null && ./static' | diff "$out/minimal.txt" -
    inside "$root" 'apt-get purge -qq -y -o Dpkg::Use-Pty=0 libsins-dev libsins1 </dev/null && rm /packages/shared /packages/static'
    files "$root" | diff "$out/before" - || fail "the removal leaves files"
    ! inside "$root" "ldconfig -p" | grep sins || fail "the loader still knows a library"
    echo "deb: $(cd "$out/deb" && echo *.deb): installed, used and removed in a new Debian; lintian has no errors"
}

# contents FILE.deb: its files, below /usr.
contents() {
    dpkg-deb --fsys-tarfile "$1" | tar -t | sed -n 's,^\./usr/\(.*[^/]\)$,\1,p'
}

# files ROOT: the names of all files but those that apt and dpkg keep of what they do.
files() {
    (cd "$1" && as_root find . -xdev \( -path ./proc -o -path ./sys -o -path ./var/log -o -path ./var/cache -o -path ./var/lib/apt \
        -o -path ./var/lib/dpkg \) -prune -o -print | LC_ALL=C sort)
}

rpm() {
    local root=$out/rpm/root database
    need rpm rpmbuild
    package rpm -DCMAKE_INSTALL_LIBDIR=lib64
    database=$(command rpm --eval '%_dbpath')
    command rpm --root "$root" --initdb
    # The empty tree has no C library.
    command rpm --root "$root" -i --nodeps "$out"/rpm/*.rpm
    equal "$(development lib64)
$(printf '%s\n' "lib64/libsins.so.$abi"{,.0.0} "share/doc/libsins$abi"/{copyright,crates.txt})" \
        "$(cd "$root/usr" && find . -type f -o -type l | sed 's,^\./,,' | grep -v "^${database#/usr/}")" "the files of RPM's packages"
    command rpm --root "$root" -V --nodeps "libsins$abi" libsins-devel
    command rpm -qp --requires "$out"/rpm/libsins-devel-*.rpm | grep -x "libsins$abi = $version-1" >/dev/null || fail "libsins-devel does not require libsins$abi"
    command rpm -qp --provides "$out/rpm/libsins$abi"-*.rpm | grep -F "libsins.so.$abi()" >/dev/null || fail "libsins$abi does not provide its SONAME"
    found "$root" -Dsins_DIR:PATH="$root/usr/lib64/cmake/sins" # CMake does not search lib64 on Debian
    rm -r "$root/hosts"
    if command rpm --root "$root" -e "libsins$abi"; then fail "libsins$abi is removed although libsins-devel needs it"; fi
    command rpm --root "$root" -e "libsins$abi" libsins-devel
    equal "" "$(cd "$root" && find . -name '*sins*')" "what the removal leaves"
    echo "rpm: $(cd "$out/rpm" && echo *.rpm): installed, used and removed in an empty tree"
}

# recipes: the recipes of a release with the sources of this tree, to be downloaded from a folder.
recipes() {
    local sources=$out/sins-$version-source.tar.gz
    git ls-files -z | tar -cz --null -T - --transform "s,^,sins-$version-source/,S" -f "$sources"
    release/recipes.sh "$sources" "file://$out" "$out/recipes"
}

# The package is built in Conan's own folder, once for each kind of library: the shared one from this tree, the static one by the recipe
# of a release.
conan() {
    local tools=$PWD/target/conan-tools shared kind recipe=release/conan
    recipes
    need python3-venv /usr/share/doc/python3-venv
    [ -x "$tools/bin/conan" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install --quiet --disable-pip-version-check conan==2.34.0; }
    export CONAN_HOME=$out/conan
    rm -rf "$CONAN_HOME" "$out/conan_hosts"
    "$tools/bin/conan" profile detect 2>/dev/null >&2
    printf '%s\n' "tools.cmake.cmaketoolchain:user_presets=" "tools.cmake.cmake_layout:test_folder=$out/conan_hosts/test" \
        >"$CONAN_HOME/global.conf" # nothing is written into the sources
    for shared in True False; do
        "$tools/bin/conan" create "$recipe" -o "sins/*:shared=$shared" >"$out/conan.log" 2>&1 || { cat "$out/conan.log"; return 1; }
        "$tools/bin/conan" install --requires "sins/$version" -o "sins/*:shared=$shared" -g CMakeDeps -g CMakeToolchain \
            -of "$out/conan_hosts/$shared" >"$out/conan.log" 2>&1 || { cat "$out/conan.log"; return 1; }
        cmake -S "$hosts" -B "$out/conan_hosts/$shared/build" -DCMAKE_BUILD_TYPE=Release \
            -DCMAKE_TOOLCHAIN_FILE="$out/conan_hosts/$shared/conan_toolchain.cmake" >/dev/null
        cmake --build "$out/conan_hosts/$shared/build" >/dev/null
        for example in minimal cpp_host; do
            same "$out/conan_hosts/$shared/build/${example}_sins" $example
        done
        kind=$(readelf -d "$out/conan_hosts/$shared/build/minimal_sins" | grep -c libsins || true)
        [ "$kind" = "$([ $shared = True ] && echo 1 || echo 0)" ] || fail "conan: shared=$shared gives the other library"
        recipe=$out/recipes/conan
    done
    # Other sources than those of the recipe are refused.
    sed -i 's/sha256: "..../sha256: "0000/' "$out/recipes/conan/conandata.yml"
    if "$tools/bin/conan" create "$recipe" >"$out/conan.log" 2>&1; then fail "conan: sources with another hash are built"; fi
    grep -q "sha256 hash failed" "$out/conan.log" || { cat "$out/conan.log"; fail "conan: says something else"; }
    echo "conan: sins/$version, shared from this tree and static from a release, built by conan create and used by find_package with CMakeDeps"
}

# vcpkg itself is not run: it is in none of the registries from which this script installs.
vcpkg() {
    local linkage port=$PWD/release/vcpkg/sins
    recipes
    for linkage in dynamic static; do
        cmake -DCURRENT_PORT_DIR="$port" -DLINKAGE=$linkage -DFOLDER="$out/vcpkg/$linkage" -DCARGO="$PWD/target/install/build/cargo" -P tests/package_managers/vcpkg.cmake
        equal "$headers
$(printf '%s\n' lib/pkgconfig/sins.pc "$bindings" share/sins/{copyright,sinsConfig.cmake,sinsConfigVersion.cmake,usage})
$([ $linkage = static ] && echo lib/libsins.a || printf '%s\n' lib/libsins.so{,".$abi",".$abi.0.0"})" \
            "$(cd "$out/vcpkg/$linkage/installed" && find . -type f -o -type l | sed 's,^\./,,')" "the files of vcpkg's package"
        cmake -S "$hosts" -B "$out/vcpkg/$linkage/hosts" -DCMAKE_PREFIX_PATH="$out/vcpkg/$linkage/installed" >/dev/null
        cmake --build "$out/vcpkg/$linkage/hosts" >/dev/null
        for example in minimal cpp_host; do
            same "$out/vcpkg/$linkage/hosts/${example}_sins" $example
        done
        port=$out/recipes/vcpkg/sins # as the recipe of a release
    done
    sed -i 's/sha512 ..../sha512 0000/' "$out/recipes/vcpkg/sins/release.cmake"
    if cmake -DCURRENT_PORT_DIR="$port" -DLINKAGE=static -DFOLDER="$out/vcpkg/other" -DCARGO="$PWD/target/install/build/cargo" \
        -P tests/package_managers/vcpkg.cmake >"$out/vcpkg.log" 2>&1; then
        fail "vcpkg: sources with another hash are built"
    fi
    grep -q "HASH mismatch" "$out/vcpkg.log" || { cat "$out/vcpkg.log"; fail "vcpkg: says something else"; }
    echo "vcpkg: the port gives both kinds of packages, which find_package finds"
    could_not "the port by vcpkg itself" "vcpkg is not to be had from a registry"
}

mkdir -p "$out"
c_examples/build.sh
for example in minimal cpp_host; do
    "target/c_examples/$example" >"$out/$example.txt"
done
for manager in ${*:-$managers}; do
    echo "== $manager"
    "$manager"
done
report_not_run
