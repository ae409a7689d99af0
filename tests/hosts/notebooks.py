"""Runs the notebooks of c_examples/notebooks. What their cells print must be what is stored in them; a cell with the tag "varies" prints
times, and only has to run.

    notebooks.py [--renew] NAME...       --renew: stores what the cells print and draw

Needs PYTHONPATH and SINS_LIBRARY, and the packages of tests/hosts/notebooks.txt: see tests/hosts.sh.
"""

import difflib
import pathlib
import sys

import nbformat
from nbclient import NotebookClient

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "c_examples/notebooks"
MOST_BYTES = 250_000  # of a notebook with its pictures


def printed(cell):
    """What a cell prints, and "a picture" for each picture."""
    said = []
    for output in cell.outputs:
        data = output.get("data", {})
        said.append("a picture\n" if "image/png" in data else output.get("text") or data.get("text/plain", str(output)) + "\n")
    return "".join(said)


def run(path, renews):
    """Whether the notebook prints what it stores."""
    stored = nbformat.read(path, as_version=4)
    fresh = nbformat.from_dict(stored)
    NotebookClient(fresh, timeout=600, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}}).execute()
    codes = [(old, new) for old, new in zip(stored.cells, fresh.cells) if new.cell_type == "code"]
    if renews:
        for number, (_, cell) in enumerate(codes, 1):
            cell.metadata.pop("execution", None)
            cell.execution_count = number
        fresh.metadata.pop("language_info", None)
        nbformat.write(fresh, path)
    size = path.stat().st_size
    if size > MOST_BYTES:
        print(f"{path.name}: {size} bytes: at most {MOST_BYTES}")
        return False
    is_same = True
    for old, new in codes:
        if not renews and "varies" not in new.metadata.get("tags", []) and printed(old) != printed(new):
            is_same = False
            print(f"{path.name}: a cell prints something else than it stores:\n{new.source}")
            print("".join(difflib.unified_diff(printed(old).splitlines(True), printed(new).splitlines(True), "stored", "printed")))
    print(f"{path.name}: {len(codes)} cells, {size} bytes")
    return is_same


renews = "--renew" in sys.argv
names = [name for name in sys.argv[1:] if name != "--renew"]
paths = [FOLDER / name for name in names] or sorted(FOLDER.glob("*.ipynb"))
sys.exit(0 if all([run(path, renews) for path in paths]) else 1)
