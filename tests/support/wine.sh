# To be sourced by the scripts of this project after need.sh: wine as Windows, 64 and 32 bits.

wine32=$PWD/target/wine32
export WINEDEBUG=-all

# have_wine x86_64|i686: sets wine, WINESERVER, WINEPREFIX and WINEARCH. If wine is not available, reports the reason
# with could_not.
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
        elif ! need lib32gcc-s1 /usr/lib32/libgcc_s.so.1; then # comes with the 32-bit C library; wine's threads need it to end
            why="no 32-bit C library to be had"
        elif ! "$wine" --version; then
            why="the kernel runs no 32-bit programs"
        fi
    fi
    [ -z "${why:-}" ] || { could_not "Windows, $1" "$why"; return 1; }
    mkdir -p "$WINEPREFIX"
}

# 32-bit wine, unpacked from its packages: this machine needs no second package architecture and no root rights. The
# download has 100 MB.
fetch_wine32() {
    rm -rf "$wine32"
    fetch_i386 wine32 libwine libz-mingw-w64 || return
    cp "$wine32/usr/i686-w64-mingw32/lib/zlib1.dll" "$wine32/usr/lib/i386-linux-gnu/wine/i386-windows"
    # Wine loads only DLLs with this mark from this folder. Without zlib1.dll, user32.dll does not load.
    printf 'Wine builtin DLL\0' | dd of="$wine32/usr/lib/i386-linux-gnu/wine/i386-windows/zlib1.dll" bs=1 seek=64 conv=notrunc status=none
}

# Libraries for windows on a screen and for fonts; 32-bit wine finds them in LD_LIBRARY_PATH.
fetch_screen32() {
    [ -e "$wine32/usr/lib/i386-linux-gnu/libfontconfig.so.1" ] || fetch_i386 libx11-6 libxcb1 libxau6 libxdmcp6 libbsd0 libmd0 \
        libxext6 libxrender1 libfreetype6 libpng16-16 zlib1g libbrotli1 libfontconfig1 libexpat1 libuuid1 || return
    export LD_LIBRARY_PATH=$wine32/usr/lib/i386-linux-gnu:$wine32/lib/i386-linux-gnu
}

# fetch_i386 PACKAGE...: downloads the packages and unpacks them into $wine32.
fetch_i386() {
    local apt=$wine32/apt
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
    # The update of a source without i386 fails. If packages are missing then, the next line fails.
    apt-get update -qq || true
    (cd "$apt" && apt-get download -qq "$@") || return
    unset APT_CONFIG
    for package in "$apt"/*.deb; do
        dpkg-deb -x "$package" "$wine32" || return
    done
    rm -r "$apt"
}
