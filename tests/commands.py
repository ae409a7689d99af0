"""Runs the commands of docs/hosts.md as they stand there: commands.py BUILT FOLDER

BUILT has the shared library, its interfaces and the program sins; FOLDER stands for the project: its files are links, and what the commands
make stays in it. Every indented line of the page is run, or stands in one of the lists below.
"""

import os
import pathlib
import shutil
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PAGE = PROJECT / "docs/hosts.md"

# Lines that commands print. tests/loading.sh and tests/hosts.sh compare those of the first and of the last two; those between are of a
# file that is fetched by hand.
PRINTED = """\
sins 0.1.0, with scenes, in a program of 32 bits
60 s of a turn, digest da39a2ea36b6398d
no GGLAT: the path is that of LATC and LONC, which mix GPS and INS
records 301, 0.08 h
RMS velocity error east: INS of the aircraft 0.278 m/s, ensemble 0.044 m/s
RMS velocity error north: INS of the aircraft 0.016 m/s, ensemble 0.039 m/s
sins:SINS_ERROR_TIME_ORDER
sins_fly: row 3: sample.time_s = 0.01: must be at least 5e-5 s after the previous sample, at 0.01
"""

# Beginnings of commands that are not run here, and why.
ELSEWHERE = {
    "cmake -B target/cmake && ": "tests/install.sh installs",
    "cc host.c -o host ": "tests/install.sh builds hosts with what is installed",
    "cmake -B target/cmake -DCMAKE_SYSTEM_NAME=Windows ": "tests/install.sh builds with both cross compilers",
    "i686-w64-mingw32-gcc ": "tests/loading.sh builds and runs the program in wine",
    "i686-w64-mingw32-gfortran ": "fortran_windows of tests/hosts.sh builds with the package's DLL",
    "apt-get install ": "tests/hosts.sh installs",
    "cargo rustc --release --lib --crate-type cdylib": "BUILT has its library",
    "python3 c_examples/python/aircraft.py RF01.nc ": "the file is fetched by hand; tests/hosts/aircraft.py makes one",
    "mex ": "MATLAB is not free",
    "c_examples/jsbsim/build.sh": "tests/jsbsim.sh",
    "target/jsbsim/host ": "tests/jsbsim.sh",
    "sins fly target/jsbsim/twin_truth.csv ": "tests/jsbsim.sh",
    "sins report --picture jsbsim.svg sins_out/twin.csv": "tests/jsbsim.sh",
}

# Programs that a machine may lack. The commands that follow in the section are then left out as well.
OPTIONAL = {"gfortran", "gnatmake", "mkoctfile"}


def commands(text):
    """The commands of each section, in order: (title, [command])."""
    sections, is_code, rest = [], False, ""
    for line in text.splitlines():
        if line.startswith("```"):
            is_code = not is_code
        elif is_code:
            continue
        elif line.startswith("## "):
            sections.append((line[3:], []))
        elif line.startswith("    ") and line.strip():
            rest += line.strip()
            if rest.endswith("\\"):
                rest = rest[:-1]
                continue
            sections[-1][1].append(rest)
            rest = ""
    return sections


def folder_of(built, folder):
    """The folder that stands for the project."""
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "target").mkdir(parents=True)
    for name in ["include", "c_examples", "docs"]:
        (folder / name).symlink_to(PROJECT / name)
    (folder / "target/release").symlink_to(built)
    (folder / "bin").mkdir()
    (folder / "bin/python3").symlink_to(sys.executable)


def main():
    built, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    folder_of(built, folder)
    sections = commands(PAGE.read_text())
    listed = {line: [word for word in ELSEWHERE if line.startswith(word)] + [line] * (line in PRINTED.splitlines())
              for _, lines in sections for line in lines}
    unused = (set(PRINTED.splitlines()) | set(ELSEWHERE)).difference(*listed.values())
    if unused:
        sys.exit(f"docs/hosts.md has no such line: {sorted(unused)}")
    counts = [0, 0]
    for title, lines in sections:
        script = [line for line in lines if not listed[line]]
        lacks = [index for index, line in enumerate(script) if line.split()[0] in OPTIONAL and not shutil.which(line.split()[0])]
        if lacks:
            print(f"not run: {title}: {script[lacks[0]].split()[0]} and what follows")
            script = script[:lacks[0]]
            counts[1] += 1
        if not script:
            continue
        path = f"{folder}/bin:{built}:{os.environ['PATH']}"
        environment = {**os.environ, "PATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(["bash", "-e", "-c", "\n".join(script)], cwd=folder, env=environment, capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"docs/hosts.md, {title}: {chr(10).join(script)}\n{done.stdout}{done.stderr}")
        counts[0] += len(script)
    print(f"commands of docs/hosts.md: {counts[0]} run as printed, {counts[1]} sections without their compiler")


if __name__ == "__main__":
    main()
