#!/usr/bin/env bash
# Writes the recipes for Conan and vcpkg that build a release: they download its sources and check their hash.
#
#     release/recipes.sh SOURCES.tar.gz ADDRESS FOLDER
#
# ADDRESS: of the folder from which SOURCES.tar.gz can be downloaded under its name. FOLDER gets conan/ and vcpkg/.
set -euo pipefail
sources=$(realpath "$1") address=${2%/} folder=$(realpath -m "$3")
cd "$(dirname "$0")/.."
version=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
name=${sources##*/}

rm -rf "$folder"
mkdir -p "$folder"
cp -r release/conan release/vcpkg "$folder"
cp c_examples/minimal.c "$folder/conan/test_package"
sed -i 's,\.\./\.\./\.\./c_examples/,,' "$folder/conan/test_package/CMakeLists.txt"
cat >"$folder/conan/conandata.yml" <<END
sources:
  "$version":
    url: "$address/$name"
    sha256: "$(sha256sum <"$sources" | cut -d ' ' -f 1)"
END
cat >"$folder/vcpkg/sins/release.cmake" <<END
set(name "$name")
set(url "$address/$name")
set(sha512 $(sha512sum <"$sources" | cut -d ' ' -f 1))
END
