# To be sourced by the scripts of this project after release/build.sh: checks of a DLL or program as the loader of Windows sees it.

# check_pe FILE PROCESSOR SYSTEM_DLL...: FILE imports from exactly these DLLs, no section is writable and executable, FILE can
# be loaded at any address, and its data is not executable. A DLL exports exactly the functions of the header, undecorated.
check_pe() {
    local file=$1 objdump=$2-w64-mingw32-objdump flags="DYNAMIC_BASE NX_COMPAT" flag facts sections imports exports
    [ "$2" = i686 ] || flags+=" HIGH_ENTROPY_VA"
    shift 2
    facts=$("$objdump" -p "$file")
    imports=$(sed -n 's/^\tDLL Name: //p' <<<"$facts" | tr A-Z a-z | LC_ALL=C sort -u)
    diff <(printf '%s\n' "$@" | LC_ALL=C sort) <(echo "$imports") || fail "$file: imports are not the stated ones"
    for flag in $flags; do
        grep -qw "$flag" <<<"$facts" || fail "$file: no $flag"
    done
    sections=$("$objdump" -hw "$file")
    grep -q ' \.reloc ' <<<"$sections" || fail "$file: no relocations, so it stands at one place"
    if grep CODE <<<"$sections" | grep -v READONLY; then fail "$file: a section is both written and run"; fi
    if [ "${file##*.}" = dll ]; then
        exports=$(sed -n '/^\[Ordinal\/Name Pointer\]/,/^$/s/^\t.* //p' <<<"$facts" | LC_ALL=C sort)
        diff <(functions) <(echo "$exports") || fail "$file: exports are not the functions of the header"
    fi
    echo "$file: imports ${imports//$'\n'/ }; $flags"
}

fail() {
    echo "$*" >&2
    exit 1
}
