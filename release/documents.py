#!/usr/bin/env python3
"""Fits the documents of the source tree to a package, or to the site: release/documents.py [--site] FOLDER.

A link to a file that is not in FOLDER becomes its text alone, and in the site one to a folder too. README.md of a package says where its user
begins.
"""
import pathlib
import re
import sys

LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)#]+)(#[^)]*)?\)")
NOTE = (
    "*This copy is part of a package. [`docs/packages.md`](docs/packages.md) lists what is in it and how to begin. Commands that build"
    " the library need the source tree.*"
)


def fitted(page):
    def link(match):
        text, target, _ = match.groups()
        file = page.parent / target
        is_there = "://" in target or (file.is_file() if is_site else file.exists())
        return match[0] if is_there else text

    return LINK.sub(link, page.read_text(encoding="utf-8"))


is_site = sys.argv[1] == "--site"
folder = pathlib.Path(sys.argv[-1])
for page in sorted(folder.rglob("*.md")):
    text = fitted(page)
    if page == folder / "README.md" and not is_site:
        title, rest = text.split("\n", 1)
        text = f"{title}\n\n{NOTE}\n{rest}"
    page.write_text(text, encoding="utf-8", newline="\n")
