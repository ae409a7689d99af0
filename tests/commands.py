"""Runs the commands of README.md and docs as printed: commands.py BUILT FOLDER

BUILT has the shared library, its interfaces and the program sins. A command that flies for longer is interrupted after 10 s, and must end
as after Ctrl-C; docs/renew.sh runs those whose figures the pages have to their ends. FOLDER has for each page a folder that stands for the project: its files
are links, and what the commands make stays in it. Each indented line of a page whose first word is a program or a file of the project is
run, or is in one of the lists below; so is each `sins ...` within a sentence that sets a key.
"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

PROJECT = pathlib.Path(__file__).resolve().parents[1]
PAGES = [PROJECT / "README.md", *sorted((PROJECT / "docs").glob("*.md"))]

# Beginnings of lines that are not run here, and why.
ELSEWHERE = {
    # what a command prints
    "sins 0.1.0, with scenes, in a program of 32 bits": "tests/loading.sh compares",
    # other tests
    "c_examples/build.sh": "the README's commands run it",
    "apps/emulator/build.sh x86_64 OUT": "tests/emulator.sh",
    "c_examples/ensemble_mpi.sh": "tests/mpi.sh",
    "c_examples/fly.sh": "the main job of .ci/run",
    "c_examples/jsbsim/build.sh": "tests/jsbsim.sh",
    "sins fly target/jsbsim/twin_truth.csv ": "tests/jsbsim.sh",
    "sins report --picture jsbsim.svg sins_out/twin.csv": "tests/jsbsim.sh",
    "target/jsbsim/host ": "tests/jsbsim.sh",
    "cargo rustc --release --lib --crate-type cdylib": "BUILT has its library",
    "cargo test --workspace": ".ci/run",
    "cargo test -p tests --features long-tests --test analysis smooth_cep": "a part of it runs in .ci/run",
    "cargo test -p tests --test analysis smooth_assumed ": ".ci/run",
    "cc c_examples/minimal.c -o minimal ": "tests/packages.sh",
    "cc host.c -o host $(pkg-config ": "tests/install.sh",
    "cc host.c -o host -static $(pkg-config ": "tests/install.sh",
    "cc host.c -o host -DSINS_STATIC ": "tests/install.sh",
    "cc host.c -o host -I include -L lib ": "tests/packages.sh",
    "cd sins-0.1.0-linux-x86_64": "tests/packages.sh",
    "export PKG_CONFIG_PATH=$PWD/lib/pkgconfig": "tests/packages.sh",
    "gcc host.c ": "tests/packages.sh",
    "./minimal": "tests/packages.sh",
    "tar xf sins-0.1.0-linux-x86_64.tar.gz": "tests/packages.sh",
    "cmake -B target/cmake && ": "tests/install.sh",
    "cmake -B target/cmake_mingw -DCMAKE_SYSTEM_NAME=Windows ": "tests/install.sh",
    "cmake -B target/cpack -DCMAKE_INSTALL_PREFIX=/usr ": "tests/package_managers.sh",
    "i686-w64-mingw32-gcc ": "tests/loading.sh",
    "i686-w64-mingw32-gfortran ": "fortran_windows of tests/hosts.sh",
    "mpicc ": "tests/mpi.sh",
    "mpirun ": "tests/mpi.sh",
    "release/all.sh": ".ci/weekly",
    "release/fmu.sh target/unit": ".ci/run",
    "tests/real_imu.sh": ".ci/weekly",
    "release/package.sh": "tests/packages.sh",
    "release/page.sh ": "tests/web.sh",
    "release/wasm.sh ": "tests/hosts.sh javascript",
    "tests/reproducible.sh": ".ci/weekly",
    # not on every machine
    "apt-get install ": "tests/hosts.sh installs",
    "cl host.c ": "Visual Studio",
    "cp sins.dll OUT": "a DLL of a package",
    "fgfs ": "FlightGear",
    "mex ": "MATLAB",
    "python3 c_examples/python/aircraft.py RF01.nc ": "the file is fetched by hand; tests/hosts/aircraft.py makes one",
    "python3 -m venv target/peers ": "packages from the network",
    "export PYTHONPATH=target/release/bindings SINS_LIBRARY=target/release/libsins.so": "with the packages of the line before",
    "target/peers/bin/python ": "the same",
    # minutes to hours; docs/renew.sh runs them
    "benches/": "benchmarks",
    "cargo run --release --manifest-path benches/Cargo.toml ": "a benchmark",
}

# Files of the reader that commands name.
README, ENSEMBLES = ((PROJECT / name).read_text() for name in ("README.md", "docs/ensembles.md"))
FILES = {
    "LOG.csv": PROJECT / "c_examples/flights/fighter_aerobatics.csv",
    "host.c": re.search("```c\n(.*?)```", README, re.DOTALL)[1],
    "specification.toml": re.search("```toml\n(title.*?)```", ENSEMBLES, re.DOTALL)[1],
    "imu.csv": "t,GyrX,GyrY,GyrZ\n" + "".join(f"{k}0000,{k * 7919 % 97},{k * 7907 % 89},{k * 7901 % 83}\n" for k in range(6000)),
    "POS.csv": "TimeUS,Lat,Lng,Alt,RelHomeAlt\n" + "".join(f"{k * 200000},{48 + k * 9e-5:.7f},11,500,0\n" for k in range(60)),
    "ATT.csv": "TimeUS,Roll,Pitch,Yaw\n" + "".join(f"{k * 40000},0,2,0\n" for k in range(300)),
    "flight.igc": "AXXX001\nHFDTE250726\n" + "".join(f"B1200{k:02}4830{k * 13:03}N01130000EA0100001060\n" for k in range(60)),
    "SCENE.toml": "[flight]\nbuiltin = 'rest'\nhours = 2\nrate_hz = 1\n[gyro]\npreset = 'navigation'\n",
}

# Time after which a command is interrupted [s], and its exit code then.
LONGEST_S, INTERRUPTED = 10, 130

# Exit codes of commands that answer: 3 is no, 4 too few runs. The scenes of this file answer for no real INS.
ENDS = {"ensemble": [0, 3, 4]}

# Programs that a machine may lack: the rest of a section that needs one of them is left out.
OPTIONAL = {"gfortran", "gnatmake", "mkoctfile"}

# Programs that pages name and that no folder of the search path needs to have.
PROGRAMS = {"apt-get", "cargo", "cc", "cd", "cl", "cmake", "cp", "export", "fgfs", "gcc", "gfortran", "gnatmake", "i686-w64-mingw32-gcc",
            "i686-w64-mingw32-gfortran", "mex", "mkoctfile", "mpicc", "mpirun", "octave-cli", "python3", "release/package.sh", "sins", "tar"}


def is_command(line):
    word = line.split()[0]
    return word in PROGRAMS or word.split("/")[0] in ("release", "apps", "c_examples", "tests", "benches", "target", ".") and "/" in word


def commands(text):
    """The commands of each section, in order: (title, [command])."""
    sections, is_code, rest = [("the beginning", [])], False, ""
    for line in text.splitlines():
        if line.startswith("```"):
            is_code = not is_code
        elif is_code:
            continue
        elif line.startswith("## "):
            sections.append((line[3:], []))
        elif rest or line.startswith("    ") and line.strip() and is_command(line):
            rest += line.strip()
            if rest.endswith("\\"):
                rest = rest[:-1]
                continue
            sections[-1][1].append(rest)
            rest = ""
        else:
            sections[-1][1].extend(span for span in re.findall("`(sins [^`]* --set [^`]*)`", line) if not re.search(" [A-Z]+ ", span))
    return sections


def folder_of(built, folder):
    """A folder that stands for the project."""
    (folder / "target").mkdir(parents=True)
    for name in ["include", "c_examples", "docs"]:
        (folder / name).symlink_to(PROJECT / name)
    (folder / "target/release").symlink_to(built)
    (folder / "target/c_examples").symlink_to(PROJECT / "target/c_examples")
    (folder / "bin").mkdir()
    (folder / "bin/python3").symlink_to("/usr/bin/python3")
    for name, content in FILES.items():
        if isinstance(content, str):
            (folder / name).write_text(content)
        else:
            (folder / name).symlink_to(content)


# Two commands that listen may have the same port.
listening = threading.Lock()


def listen(page, title, line, folder, environment):
    session = subprocess.Popen(["bash", "-c", f"exec {line}"], cwd=folder, env=environment,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    first = session.stdout.readline()
    session.send_signal(signal.SIGINT)
    rest = "".join(session.communicate(timeout=60))
    if not first.startswith("listening at udp:"):
        sys.exit(f"{page}, {title}: {line}\n{first}{rest}")


def run(page, title, line, folder, environment):
    """Runs a command. Decoded words are compared with the comment beside them."""
    if line.startswith("sins live "):
        with listening:
            return listen(page, title, line, folder, environment)
    is_ours = line.startswith("sins ")
    command = subprocess.Popen(["bash", "-c", f"exec {line}" if is_ours else line], cwd=folder, env=environment,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    interrupted = False
    try:
        # The next commands fly a scene that is written.
        ends = not is_ours or " --write " in line
        out, errors = command.communicate(timeout=None if ends else LONGEST_S)
    except subprocess.TimeoutExpired:
        interrupted = True
        command.send_signal(signal.SIGINT)
        out, errors = command.communicate()
        # The next ensemble may have the same name.
        for checkpoint in folder.glob("sins_out/*.checkpoint"):
            checkpoint.unlink()
    if command.returncode not in ([0, INTERRUPTED] if interrupted else ENDS.get(line.split()[1], [0]) if is_ours else [0]):
        sys.exit(f"{page}, {title}: {line}\n{out}{errors}{command.returncode}")
    said = line.partition("#")[2].split()
    if line.startswith("sins bus decode ") and out.split() != said:
        sys.exit(f"{page}, {title}: {line}\nprints {out}")
    return interrupted


def run_page(path, built, folder):
    """Runs the commands of a page in a folder of its own. Returns how many it ran, how many of them were interrupted, what is lacking on
    this machine, and the words of ELSEWHERE that it has."""
    page, own = str(path.relative_to(PROJECT)), folder / path.stem
    folder_of(built, own)
    environment = {**os.environ, "PATH": f"{own}/bin:{built}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1"}
    count, interrupted, lacking, used = 0, 0, [], set()
    for title, lines in commands(path.read_text()):
        used |= {word for word in ELSEWHERE for line in lines if line.startswith(word)}
        for line in lines:
            if any(line.startswith(word) for word in ELSEWHERE):
                continue
            if line.split()[0] in OPTIONAL and not shutil.which(line.split()[0]):
                lacking.append(f"{page}, {title}: {line.split()[0]}")
                break
            if line.startswith("export "):
                name_values = subprocess.check_output(["bash", "-c", f"{line}; env -0"], cwd=own, env=environment)
                environment = dict(pair.split("=", 1) for pair in name_values.decode().split("\0") if pair)
                continue
            interrupted += bool(run(page, title, line, own, environment))
            count += 1
    return count, interrupted, lacking, used


def check_folders():
    """A folder in which CMake builds has the same options in every command that makes it: CMake keeps those of the first."""
    options, texts = {}, [path.read_text() for path in PAGES]
    for folder, given in re.findall(r"^    cmake -B (\S+)(.*?)(?: && .*)?$", "\n".join(texts), re.MULTILINE):
        if options.setdefault(folder, given) != given:
            sys.exit(f"cmake -B {folder}: with{given or 'out options'}, and with{options[folder] or 'out options'}")
    for folder in re.findall(r"--config (\S+)/CPackConfig.cmake", "\n".join(texts)):
        if "-DCMAKE_INSTALL_PREFIX=/usr" not in options.get(folder, ""):
            sys.exit(f"cpack packs {folder}, which no command configures for packages")


def main():
    check_folders()
    built, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    shutil.rmtree(folder, ignore_errors=True)
    with ThreadPoolExecutor(os.cpu_count()) as pages:
        ran = list(pages.map(lambda path: run_page(path, built, folder), PAGES))
    counts, interrupted, lacking, used = zip(*ran)
    if unused := set(ELSEWHERE).difference(*used):
        sys.exit(f"no page has such a line: {sorted(unused)}")
    for what in sum(lacking, []):
        print(f"not run: {what} and what follows")
    print(f"commands of README.md and docs: {sum(counts)} run as printed, {sum(interrupted)} of them for {LONGEST_S} s")


if __name__ == "__main__":
    main()
