# For the scripts of this project, to be sourced after need.sh: Windows by wine, 64 and 32 bits.

wine32=$PWD/target/wine32
export WINEDEBUG=-all

# have_wine x86_64|i686: sets wine, WINESERVER, WINEPREFIX and WINEARCH; where there is none, says why by could_not.
have_wine() {
    local why
    if [ "$1" = x86_64 ]; then
        wine=/usr/lib/wine/wine64
        export WINESERVER=/usr/lib/wine/wineserver64 WINEPREFIX=$PWD/target/wine WINEARCH=win64
        [ -x "$wine" ] || install wine64 || why="no wine to be had"
    else
        wine=$wine32/usr/lib/wine/wine
        export WINESERVER=${wine}server32 WINEPREFIX=$wine32/prefix WINEARCH=win32
        if ! [ -x "$wine" ] && ! fetch_wine32; then
            why="no 32-bit wine to be had"
        elif ! need lib32gcc-s1 /usr/lib32/libgcc_s.so.1; then # with the 32-bit C library; wine's threads end by it
            why="no 32-bit C library to be had"
        elif ! "$wine" --version; then
            why="the kernel runs no 32-bit programs"
        fi
    fi
    [ -z "${why:-}" ] || { could_not "Windows, $1" "$why"; return 1; }
    mkdir -p "$WINEPREFIX"
}

# 32-bit wine, unpacked from its packages: no second architecture comes into the packages of this machine, and no root is
# needed. 100 MB to fetch.
fetch_wine32() {
    local apt=$wine32/apt
    rm -rf "$wine32"
    mkdir -p "$apt/lists/partial" "$apt/archives/partial"
    touch "$apt/status"
    cat >"$apt/conf" <<END
APT::Architecture "i386";
APT::Architectures { "i386"; };
APT::Sandbox::User "root";
Dir::State "$apt";
Dir::State::status "$apt/status";
Dir::Cache "$apt";
END
    export APT_CONFIG=$apt/conf
    # A source without i386 fails; what is missing fails in the next line.
    apt-get update -qq || true
    (cd "$apt" && apt-get download -qq wine32 libwine libz-mingw-w64) || return
    unset APT_CONFIG
    for package in "$apt"/*.deb; do
        dpkg-deb -x "$package" "$wine32" || return
    done
    cp "$wine32/usr/i686-w64-mingw32/lib/zlib1.dll" "$wine32/usr/lib/i386-linux-gnu/wine/i386-windows"
    rm -r "$apt"
}
