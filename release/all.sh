#!/usr/bin/env bash
# Makes everything of a release in target/dist, from a clean checkout: packages and wheels, the sources for Python and as a whole, the
# packages of npm, Debian and RPM, the page, the crate, licences, an SBOM, the toolchains, the notes and SHA256SUMS.
# docs/packages.md, "A release". Ends with what could not be made, and then with an error.
#
#     release/all.sh
#
# DEBFULLNAME, DEBEMAIL: the maintainer of the packages for Debian. SINS_RELEASE_URL: the address of the folder from which the release will
# be downloaded; with it, there are recipes for Conan and vcpkg too.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh

if [ -n "$(git status --porcelain)" ]; then
    echo "release/all.sh: these files differ from the commit; a release is made of a commit:" >&2
    git status --short >&2
    exit 1
fi
dist=$PWD/target/dist
staging=$PWD/target/release-all
rm -rf "$dist" "$staging"
mkdir -p "$dist" "$staging"
release/notes.sh >"$dist/RELEASE_NOTES.md" # first: a version without notes is found at once

step "packages"
release/package.sh
cp target/release-packages/sins-"$version"-*/share/sins/*.whl "$dist"

step "sources"
git archive --format=tar --prefix="sins-$version-source/" HEAD | gzip -n9 >"$dist/sins-$version-source.tar.gz"
# For `pip install` where no wheel fits: what cargo builds, with the files of release/python at the top, as pip expects them.
need unzip unzip
folder=$staging/sins-$version
mkdir "$folder"
git archive HEAD Cargo.toml Cargo.lock build.rs bindings build src include apps/cli apps/fmu tests/Cargo.toml tests/inside LICENSE-MIT LICENSE-APACHE |
    tar -x -C "$folder"
cp release/python/{pyproject.toml,setup.py,README.md} "$folder"
unzip -p "$dist/sins-$version"-py3-none-manylinux_2_17_x86_64.whl "sins-$version.dist-info/METADATA" >"$folder/PKG-INFO"
archive "$folder" tar.gz
cargo package --quiet --locked --package sins --target-dir "$staging/crate"
cp "$staging/crate/package/sins-$version.crate" "$dist"

if [ -n "${SINS_RELEASE_URL:-}" ]; then
    release/recipes.sh "$dist/sins-$version-source.tar.gz" "$SINS_RELEASE_URL" "$staging/sins-$version-recipes"
    archive "$staging/sins-$version-recipes" tar.gz
else
    echo "no recipes for Conan and vcpkg: SINS_RELEASE_URL, from where they would download the sources, is not set"
fi

step "npm and the page"
need npm npm
release/wasm.sh "$staging/wasm"
npm pack --silent "$staging/wasm" --pack-destination "$dist"
mv "$dist/sins-$version.tgz" "$dist/sins-$version-npm.tgz"
SINS_WASM=$staging/wasm release/page.sh "$staging/page"
cp "$staging/page/sins.html" "$dist/sins-$version.html"

step "Debian and RPM"
need rpm rpmbuild
need file file
need dpkg-dev dpkg-shlibdeps
export DEBFULLNAME=${DEBFULLNAME:-The sins developers} DEBEMAIL=${DEBEMAIL:-sins@sins.invalid}
for kind in DEB RPM; do
    libraries=()
    [ "$kind" = DEB ] || libraries=(-DCMAKE_INSTALL_LIBDIR=lib64)
    # Without the setting of CMake, cpack would build all of it again: library and program overwrite what the other has in cargo's folder.
    cmake -S . -B "$staging/$kind" -DCMAKE_INSTALL_PREFIX=/usr -DSINS_PROGRAM=ON -DSINS_CARGO_TARGET_DIR="$staging/cargo" \
        -DCMAKE_SKIP_INSTALL_ALL_DEPENDENCY=ON "${libraries[@]}"
    cmake --build "$staging/$kind"
    cpack --config "$staging/$kind/CPackConfig.cmake" -G "$kind" -B "$staging/$kind/packages"
done
cp "$staging"/DEB/packages/*.deb "$staging"/RPM/packages/*.rpm "$dist"

step "licences, SBOM, toolchains"
targets=$(printf '%s,' {x86_64,i686,aarch64}-unknown-linux-gnu {x86_64,i686}-win7-windows-gnu wasm32-unknown-unknown)
release/licences.py "${targets%,}" sins sins-cli sins-fmu >"$dist/LICENCES.txt"
release/sbom.sh "$dist/sins-$version.cdx.json" || could_not "the SBOM" "release/sbom.sh failed"
{
    echo "commit $(git rev-parse HEAD)"
    echo "time of the commit $(date -u -d "@$SOURCE_DATE_EPOCH" +%FT%TZ)"
    sed -n 's/^PRETTY_NAME="\(.*\)"/system \1/p' /etc/os-release
    rustc --version
    rustc "+$nightly" --version
    sed -nE 's/.* (cargo-zigbuild==[0-9.]+) (ziglang==[0-9.]+)$/\1\n\2/p' release/zig.sh
    sed -nE 's/^requires = \["(.*)"\]$/\1/p' release/python/pyproject.toml
    for tool in cmake cpack npm node; do printf '%s %s\n' $tool "$($tool --version | head -n 1)"; done
    # shellcheck disable=SC2016
    dpkg-query -W -f '${Package} ${Version}\n' 'gcc-mingw-w64-*-win32' 'g++-mingw-w64-*-posix' llvm gcc libc6-dev rpm doxygen zip gzip tar 2>/dev/null || true # also of what is not installed
} >"$dist/TOOLCHAINS.txt"

step "SHA256SUMS"
(cd "$dist" && rm -f SHA256SUMS && find . -type f -printf '%P\n' | LC_ALL=C sort | xargs -d '\n' sha256sum >"$staging/SHA256SUMS")
mv "$staging/SHA256SUMS" "$dist"
ls -l "$dist"
step "done"
report_not_run
[ ${#not_run[@]} -eq 0 ]
