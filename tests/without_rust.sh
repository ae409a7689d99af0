#!/usr/bin/env bash
# What a release has, used without Rust: archive, Debian's packages and wheel in a new Debian of debootstrap; the package of npm by the Node
# of this machine, in empty folders without its environment. Each flies the README's hour. Other tests use the archives of other systems
# (tests/packages.sh), and RPM, Conan and vcpkg (tests/package_managers.sh).
#
#     tests/without_rust.sh [FOLDER]      with the files that release/all.sh has made there; default: target/dist
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/debian.sh
dist=$(cd "${1:-target/dist}" && pwd)
version=$(sed -n '/^version = /{s/.*"\(.*\)"/\1/p;q}' Cargo.toml)
out=$PWD/target/without_rust
root=$out/debian
mkdir -p "$out"
(cd "$dist" && sha256sum --quiet --check SHA256SUMS)

# flown WHAT COMMAND...: the command prints the errors at the end of the README's hour, as text or in the table of `sins fly`.
flown() {
    local what=$1 printed
    shift
    printed=$("$@")
    grep -Eq '^-145 m east, -1336 m north$|^  position \[m\] +-145\.[0-9]+ +-1336\.[0-9]+ ' <<<"$printed" || {
        printf '%s\n%s: does not end at -145 m east, -1336 m north\n' "$printed" "$what" >&2
        exit 1
    }
    echo "$what: -145 m east, -1336 m north"
}

# The host, the command and the lines of JavaScript that README.md and release/npm/README.md print.
mkdir -p "$out/taken"
awk '/^```c$/ { inside = 1; next } /^```$/ && inside { exit } inside' README.md >"$out/taken/host.c"
awk '/^```js$/ { inside = 1; next } /^```$/ && inside { exit } inside' release/npm/README.md >"$out/taken/host.mjs"
hour=$(sed -nE 's,^    bin/(sins fly [^#]*[^ #]) *#.*,\1,p' README.md)
[ -n "$hour" ]
cp "$dist/sins-$version-linux-x86_64.tar.gz" "$dist"/*.deb "$dist"/*manylinux*x86_64.whl "$out/taken"
cp -r tests/install "$out/taken"

if debian "$root" cmake make g++ python3-venv python3-numpy; then
    inside "$root" '! command -v cargo; ! command -v rustc; dpkg --purge sins libsins-dev libsins1 2>/dev/null; rm -rf /taken /used; mkdir /used'
    as_root cp -r "$out/taken" "$root"
    archive=/used/sins-$version-linux-x86_64
    inside "$root" "tar -C /used -xf /taken/sins-$version-linux-x86_64.tar.gz"
    flown "archive: program" inside "$root" "cd $archive && bin/$hour"
    flown "archive: C" inside "$root" "cd $archive && cp /taken/host.c . && cc host.c -o host -I include -L lib -lsins -Wl,-rpath,\$PWD/lib && ./host"
    # tests/install takes its sources from the project.
    inside "$root" "ln -sfn $archive/c_examples /c_examples && cd /taken/install && cmake -S . -B /used/cmake -DCMAKE_PREFIX_PATH=$archive >/dev/null &&
        cmake --build /used/cmake >/dev/null && /used/cmake/minimal_sins >/dev/null && /used/cmake/minimal_static >/dev/null"
    echo "archive: find_package, shared and static"
    flown "wheel" inside "$root" "cd /used && python3 -m venv --system-site-packages venv && venv/bin/pip install --quiet --no-index /taken/*.whl &&
        venv/bin/python -c 'if True:
            import sins
            run = sins.fly(\"rest\", hours=1, gyro={\"bias_deg_h\": [0.01, 0, 0]})
            print(\"%.0f m east, %.0f m north\" % tuple(run.position_error_m[-1, :2]))'"
    inside "$root" 'dpkg -i /taken/*.deb >/dev/null'
    flown "Debian: program" inside "$root" "cd /used && $hour"
    flown "Debian: C" inside "$root" 'cd /used && cc /taken/host.c -o host $(pkg-config --cflags --libs sins) && ./host'
    inside "$root" 'dpkg --verify sins libsins1 libsins-dev; dpkg -L sins | grep -Fx /usr/share/bash-completion/completions/sins >/dev/null &&
        dpkg -L sins | grep -Fx /usr/share/man/man1/sins-fly.1.gz >/dev/null && dpkg --purge sins libsins-dev libsins1 >/dev/null'
    ! inside "$root" 'command -v sins' || { echo "the removal leaves the program" >&2; exit 1; }
else
    could_not "archive, Debian's packages and wheel in a new Debian" "debootstrap failed"
fi

need npm npm
rm -rf "$out/npm" && mkdir -p "$out/npm/home" "$out/npm/own"
cp "$out/taken/host.mjs" "$out/npm/own"
npm_alone() { (cd "$out/npm/own" && env -i PATH=/usr/bin:/bin HOME="$out/npm/home" "$@"); }
npm_alone npm install --silent --offline --no-audit "$dist/sins-$version-npm.tgz"
flown "npm" npm_alone node host.mjs
report_not_run
