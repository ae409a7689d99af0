#!/usr/bin/env python3
"""Prints the licences of all crates in packages of this workspace, for these targets or for "all".
Without PACKAGE: the licences of the library and the program.

    release/licences.py TARGET[,TARGET...]|all [PACKAGE...] >LICENCES.txt

cargo-about is not used, because it takes longer to compile than everything else here.
"""

import json
import pathlib
import subprocess
import sys

NAMES = ("licen", "copying", "unlicense", "notice", "copyright")


def crates(target, own):
    """Crates that are linked: without those of build scripts and tests, and without macros and the crates that only they need."""
    command = ["cargo", "metadata", "--locked", "--format-version", "1"]
    if target != "all":
        command += [word for one in target.split(",") for word in ("--filter-platform", one)]
    metadata = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    linked, todo = set(), [name for name in metadata["workspace_members"] if packages[name]["name"] in own]
    while todo:
        name = todo.pop()
        is_macro = any("proc-macro" in target["kind"] for target in packages[name]["targets"])
        if name not in linked and not is_macro:
            linked.add(name)
            kinds = ((d["pkg"], [k["kind"] for k in d["dep_kinds"]]) for d in nodes[name]["deps"])
            todo += [dependency for dependency, kind in kinds if None in kind]
    others = linked - set(metadata["workspace_members"])
    return sorted((packages[name] for name in others), key=lambda p: (p["name"], p["version"]))


def texts(package):
    folder = pathlib.Path(package["manifest_path"]).parent
    files = sorted(file for file in folder.iterdir() if file.name.lower().startswith(NAMES) and file.is_file())
    if not files and "Apache-2.0" in package["license"]:
        files = [pathlib.Path("LICENSE-APACHE")]  # one of the crate's licences; its text names no owner
    if not files:
        sys.exit(f"release/licences.py: {package['name']} has no licence text")
    return [file.read_text(encoding="utf-8").replace("\r\n", "\n").strip() for file in files]


def main():
    owners = {}
    own = sys.argv[2:] or ["sins", "sins-cli"]
    print(f"Crates in {', '.join(own)}, and their licences. The texts follow.\n")
    for package in crates(sys.argv[1], own):
        name = f"{package['name']} {package['version']}"
        print(f"{name}: {package['license']}; {package['repository']}")
        for text in texts(package):
            owners.setdefault(text, []).append(name)
    for text, names in owners.items():
        print(f"\n{'=' * 80}\n{', '.join(names)}\n{'-' * 80}\n{text}")


main()
