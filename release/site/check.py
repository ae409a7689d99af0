#!/usr/bin/env python3
"""Checks the site: release/site/check.py BOOK SUMMARY.md

Each document is a page, each link within the site leads to a file and to a place in it, nothing is loaded from the network, and the site has
at most 20 MB.
"""

import html.parser
import pathlib
import sys
import urllib.parse

book, summary = map(pathlib.Path, sys.argv[1:])
LOADS = {("link", "href"), ("script", "src"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("object", "data")}
FOREIGN = ("headers", "gallery", "sins.html")  # pages of other makers: what they load is checked, not their own links


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.places, self.links, self.loads = set(), [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.places.update(attributes[name] for name in ("id", "name") if attributes.get(name))
        for name in ("href", "src", "data"):
            if attributes.get(name):
                (self.loads if (tag, name) in LOADS else self.links).append(attributes[name])


faults = []
pages = {path.resolve(): Page(path) for path in book.rglob("*.html")}
for path, page in pages.items():
    name = path.relative_to(book.resolve())
    faults += [f"{name}: loads {address}" for address in page.loads if address.startswith(("http:", "https:", "//"))]
    if str(name).startswith(FOREIGN):
        continue
    for address in [*page.loads, *page.links]:
        parts = urllib.parse.urlsplit(address)
        if parts.scheme or parts.netloc:
            continue
        target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
        if not target.is_file():
            faults.append(f"{name}: no file {address}")
        elif parts.fragment and target in pages and not str(target.relative_to(book.resolve())).startswith(FOREIGN):
            if urllib.parse.unquote(parts.fragment) not in pages[target].places:
                faults.append(f"{name}: no place {address}")
listed = summary.read_text(encoding="utf-8")
faults += [
    f"SUMMARY.md lacks docs/{path.name}" for path in sorted((summary.parent / "docs").glob("*.md")) if f"(docs/{path.name})" not in listed
]
size = sum(path.stat().st_size for path in book.rglob("*") if path.is_file())
if size > 20e6:
    faults.append(f"{size / 1e6:.1f} MB, more than 20")
for fault in sorted(set(faults)):
    print(fault, file=sys.stderr)
print(f"{len(pages)} pages, {size / 1e6:.1f} MB")
sys.exit(bool(faults))
