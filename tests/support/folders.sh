# To be sourced by scripts at the top of the project: libraries and programs name no folder of the machine that built them.

# name_no_folder PLACE...: fails if a file at these places names the folder of the sources, that of cargo, or the home.
name_no_folder() {
    if grep -rlF -e "$PWD" -e "${CARGO_HOME:-$HOME/.cargo}/" -e "$HOME/" "$@"; then
        echo "these name a folder of this machine" >&2
        return 1
    fi
}
