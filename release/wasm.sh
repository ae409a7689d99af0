#!/usr/bin/env bash
# Builds the library for WebAssembly, and the folder of its npm package in OUT: sins.wasm, sins.mjs, sins.d.ts, package.json, README.md
# and licences. It has no sins_identify_..., which no page calls. Checks that the module exports the other functions of the header and
# imports nothing.
#
#     release/wasm.sh OUT
set -euo pipefail
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
. tests/support/need.sh
. release/build.sh

target=wasm32-unknown-unknown
need nodejs node
need python3 python3
rustup target add "$target" 2>/dev/null
stable=$(rustup show active-toolchain | cut -d' ' -f1)

# With instructions for two numbers at a time, which browsers have since 2021 to 2023, a step takes 0.9 times as long, and that of an
# ensemble 0.7 times.
CARGO_ENCODED_RUSTFLAGS=$(flags "$stable" -Ctarget-feature=+simd128 -Cstrip=symbols) \
    cargo rustc --quiet --locked --release --lib --crate-type cdylib --target "$target" --no-default-features --features scenes
built=target/$target/release
command install -m644 -t "$out" "$built/sins.wasm" "$built"/bindings/sins.{mjs,d.ts} release/npm/README.md
sed "s/VERSION/$version/" release/npm/package.json >"$out/package.json"
mkdir -p "$out/licences"
command install -m644 -t "$out/licences" LICENSE-MIT LICENSE-APACHE
release/licences.py "$target" sins >"$out/licences/crates.txt"
command install -m644 "$(rustc --print sysroot)/share/doc/rust/COPYRIGHT-library.html" "$out/licences/rust-library.html"

# The two functions give hosts memory in the module; the two numbers say where the memory begins that the module itself uses.
node -e '
    const module = new WebAssembly.Module(require("fs").readFileSync(process.argv[1]));
    const names = (list) => list.map(({ name }) => name).sort().join("\n");
    console.log(names(WebAssembly.Module.exports(module)));
    console.log(names(WebAssembly.Module.imports(module)));' "$out/sins.wasm" |
    diff <({ functions | grep -v "^sins_identify_" && printf '%s\n' memory __data_end __heap_base sins_wasm_allocate sins_wasm_free; } | LC_ALL=C sort; echo) - ||
    { echo "release/wasm.sh: sins.wasm: these exports are not the functions of the header, or it imports something" >&2; exit 1; }
