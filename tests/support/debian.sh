# shellcheck shell=bash
# To be sourced after need.sh: a new Debian of this machine's release, by debootstrap, without Rust.

# debian ROOT PACKAGE...: makes it in the folder, with these packages and a C compiler, once. Ends with an error if it cannot be made.
debian() {
    local root=$1 packages=gcc,libc6-dev,pkgconf
    shift
    for package in "$@"; do packages+=,$package; done
    need debootstrap /usr/sbin/debootstrap
    [ "$(cat "$root/ready" 2>/dev/null)" != "$packages" ] || return 0
    as_root rm -rf "$root"
    as_root debootstrap --variant=minbase --include="$packages" "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$root" \
        >"$root.log" || { tail "$root.log"; return 1; }
    as_root sh -c "echo $packages >'$root/ready'"
}

# inside ROOT COMMAND: a command of the shell in it, with nothing of this machine's environment.
inside() {
    as_root env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C chroot "$1" sh -ec "$2"
}
