#!/usr/bin/env python3
"""Fits the documents of the source tree to a package: release/documents.py FOLDER.

A link to a file that the package does not contain becomes its text alone. README.md says where a user of the package begins.
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
        is_there = "://" in target or (page.parent / target).exists()
        return match[0] if is_there else text

    return LINK.sub(link, page.read_text(encoding="utf-8"))


folder = pathlib.Path(sys.argv[1])
for page in sorted(folder.rglob("*.md")):
    text = fitted(page)
    if page == folder / "README.md":
        title, rest = text.split("\n", 1)
        text = f"{title}\n\n{NOTE}\n{rest}"
    page.write_text(text, encoding="utf-8", newline="\n")
