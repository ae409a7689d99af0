# To be sourced by the scripts of this project: installs what they need, and reports at the end what could not be installed.

# Builds go to target, also if the caller has set another folder.
unset CARGO_TARGET_DIR

# The nightly Rust of all scripts, for sanitizers, fuzzing and the standard library for Windows 7. The date is fixed: another
# nightly may have other flags, and packages have the same bytes only with the same compiler.
nightly=nightly-2026-05-20

# has_nightly: installs this nightly Rust with the sources of its standard library, if it is missing. Fails if that is impossible.
has_nightly() {
    rustup component list --installed --toolchain "$nightly" 2>/dev/null | grep -qx rust-src ||
        rustup toolchain install "$nightly" --profile minimal --component rust-src
}

# need PACKAGE PROGRAM: installs the Debian package if the program, or the file if a path is given, is missing. Recommended
# packages are not installed: g++ depends on the headers of the C library, gcc does not.
need() {
    case $2 in
        */*) [ -e "$2" ] || install "$1" ;;
        *) command -v "$2" >/dev/null || install "$1" ;;
    esac
}

# Only one installation runs at a time if scripts run in parallel. The package lists are updated if they are missing or old.
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

# Repeats at the end what was not run.
report_not_run() {
    if [ "${#not_run[@]}" -gt 0 ]; then
        printf '\n%s:\n' "${0##*/} could not run"
        printf '    %s\n' "${not_run[@]}"
    fi
}
