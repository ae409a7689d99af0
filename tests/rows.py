#!/usr/bin/env python3
"""Writes what the tests print into the tables of tests/README.md:

    cargo test --workspace -- --show-output 2>&1 | tests/rows.py [--long] [--check]

A row that names a test in its last cell, as `robustness::rest::a_month`, has in the cell before it the figure that the test prints, as
"figure: 3.9e-8 m"; figures of several tests follow each other in the order of their names. `--long`: the tests ran with
`--features long-tests`; figures that differ then stand behind "*long*:". `--check`: writes nothing, and fails if a figure differs by more
than the mathematics of another machine makes it: by more than a tenth and one in its last digit, a power of ten by more than a half.

Ends with an error if a row names a test or a module that does not exist, if no row names a test that prints a figure, or if a test failed.
"""

import pathlib
import re
import sys

README = pathlib.Path(__file__).with_name("README.md")
NAME = re.compile(r"`((?:\w+::)+\w+)`")
LONG = re.compile(r"(?:; )?\*long\*: ")
NUMBER = re.compile(r"(\d+(?:\.(\d+))?(?:e(-?\d+))?)")


def read(lines):
    """The names of the tests that ran, and their figures."""
    names, figures, binary, shown = set(), {}, None, None
    for line in lines:
        if found := re.search(r"Running .*\(\S*/deps/(\w+)-[0-9a-f]+\)", line):
            binary, shown = found[1], None
        elif found := re.match(r"---- (\S+) stdout ----", line):
            shown = f"{binary}::{found[1]}"
        elif found := re.match(r"test (\S+)(?: - should panic)? \.\.\. (\w+)", line):
            if found[2] == "FAILED":
                sys.exit(f"rows.py: {binary}::{found[1]} failed")
            names.add(f"{binary}::{found[1]}")
        elif line.startswith("figure: ") and shown:
            if shown in figures:
                sys.exit(f"rows.py: {shown} prints two figures")
            figures[shown] = grouped(line.removeprefix("figure: ").strip())
    return names, figures


def grouped(text):
    """The text with a space between the thousands of integers of five digits and more, as the documents have them."""
    return re.sub(r"(?<![\w.])\d{5,}(?![\w.])", lambda number: f"{int(number[0]):_}".replace("_", " "), text)


def is_near(old, new):
    """Whether texts are equal but for numbers that are near to each other."""
    def is_close(before, after):
        (a, digits, exponent), (b, _, _) = before, after
        a, b = float(a), float(b)
        last = 10.0 ** (int(exponent or 0) - len(digits))
        return abs(a - b) <= max(1.01 * last, (0.5 if exponent else 0.1) * abs(a))

    numbers, words = zip(*((NUMBER.findall(text), NUMBER.sub("", text)) for text in (old.replace(" ", ""), new.replace(" ", ""))))
    return words[0] == words[1] and all(map(is_close, *numbers))


def cell(old, new, is_long):
    """The cell with the new figure of ordinary runs, or of long ones."""
    short, *long = LONG.split(old, maxsplit=1)
    if is_long:
        long = [new] if new != short else []
    else:
        short = new
    return "; *long*: ".join([short, *long])


def main():
    options = set(sys.argv[1:])
    if not options <= {"--long", "--check"}:
        sys.exit(__doc__)
    names, figures = read(sys.stdin)
    if not names:
        sys.exit("rows.py: no tests ran")
    binaries = {name.split("::")[0] for name in names}
    ran = lambda name: name.split("::")[0] in binaries
    text, unused, faults = [], dict(figures), []
    for number, line in enumerate(README.read_text().splitlines(), 1):
        cells = [part.strip() for part in line.split("|")[1:-1]]
        tests = [name for name in NAME.findall(cells[-1]) if ran(name)] if len(cells) > 2 else []
        exists = lambda name: name in names or any(one.startswith(f"{name}::") for one in names)
        faults += [f"line {number} names {name}, which does not exist" for name in tests if not exists(name)]
        if new := "; ".join(unused.pop(name) for name in tests if name in unused):
            old, cells[-2] = cells[-2], cell(cells[-2], new, "--long" in options)
            line = "|" + "|".join(f" {part} " if part else " " for part in cells) + "|"
            if "--check" in options and not is_near(old, cells[-2]):
                faults.append(f"line {number} has\n    {old}\nwhere the tests print\n    {cells[-2]}")
        text.append(line)
    faults += [f"no row names {name}, which prints: {figure}" for name, figure in unused.items()]
    if "--check" not in options:
        README.write_text("\n".join(text) + "\n")
    for fault in faults:
        print(f"tests/README.md: {fault}")
    if faults:
        sys.exit("rows.py: the tables differ from what the tests print")


main()
