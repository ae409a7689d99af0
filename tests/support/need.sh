# For the scripts of this project, to be sourced: what they need is installed, and what cannot be had is told at the end.

# What is built lies in target, wherever the caller builds his own.
unset CARGO_TARGET_DIR

# The nightly Rust of all scripts, for sanitizers, fuzzing and the standard library for Windows 7. By its date: another one may have
# other flags, and packages have the same bytes only if it is the same.
nightly=nightly-2026-05-20

# has_nightly: whether there is that nightly Rust, with the sources of its standard library.
has_nightly() {
    rustup component list --installed --toolchain "$nightly" 2>/dev/null | grep -qx rust-src ||
        rustup toolchain install "$nightly" --profile minimal --component rust-src
}

# need PACKAGE PROGRAM: installs the Debian package if the program, or the file where a path is given, is not there. Recommended
# packages do not come along: g++ brings the headers of the C library, gcc alone does not.
need() {
    case $2 in
        */*) [ -e "$2" ] || install "$1" ;;
        *) command -v "$2" >/dev/null || install "$1" ;;
    esac
}

# One at a time, when scripts run side by side. The lists of packages are fetched where they are missing or old.
install() {
    apt_install "$@" 2>/dev/null || {
        as_root flock /var/lib/apt apt-get update -qq
        apt_install "$@"
    }
}

apt_install() {
    as_root flock /var/lib/apt env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

not_run=()

# could_not WHAT WHY
could_not() {
    not_run+=("$1: $2")
    echo "not run: $1: $2"
}

# Says again, at the end, what was not run.
report_not_run() {
    if [ "${#not_run[@]}" -gt 0 ]; then
        printf '\n%s:\n' "${0##*/} could not run"
        printf '    %s\n' "${not_run[@]}"
    fi
}
