"""A real INS, by the program `sins` alone: real_imu.py PROGRAM FOLDER, in an environment with onavdata and pandas.

Prints each figure with its bars, and exits with 1 if one is beyond them. Bars are wide where a figure hangs on few flights.
"""

import contextlib
import io
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import onavdata
import pandas as pd

PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2])
DOCS = Path(__file__).resolve().parent.parent / "docs"
DRIVE = "2021-04-27 HGuide n380 Car Hill Driving"
# Three flights of unmanned aircraft, and the cut-off that smoothing of their fixes of 1 Hz leaves [Hz].
UAVS = {"thor60": "2012 UMN-UAV THOR60", "thor75": "2012 UMN-UAV THOR75", "thor77": "2012 UMN-UAV THOR77"}
CUTOFF_HZ = 0.45
# The drive's own filter aligns until 186 s, by the deviations that it states: rows before 206 s are left out.
ALIGNED = 16500
WRONG = []

# Half to twice what least squares in Python found in other parts of the drive, root mean squares [m].
TWICE = 2.0
FREE_M = {10.0: 1.1, 30.0: 25.0, 60.0: 190.0, 120.0: 1300.0}
REAL_M = {10.0: 0.6, 30.0: 3.5, 60.0: 13.8, 120.0: 61.7}
# Its means of the gyros over four minutes, and how far a bias may walk within the drive [deg/h].
BIASES_DEG_H = {"x": (48.3, 20.0), "y": (118.8, 30.0), "z": (-55.6, 40.0)}
# The attitude of the drive's filter jumps at its fixes. These steps count as noise of the sensors, so that the model is too bad.
RATIO = (0.7, 5.0)
# Means over a second of the forces of the path less those that the sensors measured, root mean square [m/s2].
FORCE_M_S2 = 0.05
# Biases of the first aircraft by least squares in Python, means of its halves, and how far they may be off: gyros [deg/s], accelerometers [mg].
BIASES = {"gyro": [(-1.29, 0.2), (0.0, 0.3), (0.2, 0.5)], "accelerometer": [(52.0, 30.0), (-43.0, 25.0), (-22.0, 25.0)]}
# The attitude of these aircraft is one sample of 20 ms late [ms].
LATE_MS = (12.0, 28.0)


def export(name, path):
    """The table as the package gives it, without a choice of rows or columns."""
    with contextlib.redirect_stdout(io.StringIO()):
        onavdata.get_data(name).to_csv(path)


def sins(*arguments, code=0):
    ended = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=FOLDER, check=False)
    if ended.returncode != code:
        WRONG.append(f"{' '.join(map(str, arguments))}: exit code {ended.returncode} for {code}")
        print(ended.stdout, ended.stderr)
    return ended.stdout + ended.stderr if code else ended.stdout


def within(name, value, low, high):
    print(f"{name}: {value:.4g} ({low:g} to {high:g})")
    if not low <= value <= high:
        WRONG.append(f"{name}: {value:.4g}, expected {low:g} to {high:g}")


def contains(name, text, words):
    if words not in text:
        WRONG.append(f"{name}: no \"{words}\" in: {text}")


def drive():
    export(DRIVE, FOLDER / "drive.csv")
    said = sins("log", "drive.csv", "--map", "drive.toml", "--force")
    contains("judge of the drive", said, "nothing is doubtful")
    sins("fly", "drive.csv", "--columns", "drive.toml", "--quiet", "-o", "drive", "--force")
    mapping = (FOLDER / "drive.toml").read_text()
    (FOLDER / "aligned.toml").write_text(mapping.replace("[log]\n", f"[log]\nskip = {ALIGNED}\n"))
    forces()
    order = (
        *("identify", "drive.csv", "--columns", "aligned.toml", "--imu", "drive.csv", "--prior", "tactical"),
        *("--check", "--truth-sigma", "velocity_m_s=0.03,tilt_arcmin=1.5,heading_arcmin=10"),
        *("-o", "sensor.toml", "--picture", "drift.svg", "--force"),
    )
    found = json.loads(sins(*order, "--json"))
    # The drifts and their picture are those that the documents show.
    table = sins(*order).partition("  after  flights")[2].partition("\n\n")[0].splitlines()[1:]
    for row in table:
        contains("docs/trust.md", (DOCS / "trust.md").read_text(), row.strip())
    if len(table) != len(found["check"]["spans"]):
        WRONG.append(f"{len(table)} rows of drifts")
    if (FOLDER / "drift.svg").read_text() != (DOCS / "drift.svg").read_text():
        WRONG.append(f"docs/drift.svg is not {FOLDER / 'drift.svg'}")
    within("clock [ms]", 1e3 * found["clock_shift_s"]["value"], -0.05, 0.05)
    for axis, (bias, walk) in BIASES_DEG_H.items():
        value = found["gyro"][f"bias {axis}"]["value"]
        within(f"gyro bias {axis} [deg/h]", value * 206264.806, bias - walk, bias + walk)
    for span in found["check"]["spans"]:
        duration_s = span["duration_s"]
        for what, value, expected in (
            ("as recorded", span["free_m"], FREE_M[duration_s]),
            ("errors removed", span["real_m"], REAL_M[duration_s]),
        ):
            within(f"after {duration_s:g} s, {what} [m]", value, expected / TWICE, expected * TWICE)
        within(f"after {duration_s:g} s, predicted over real", span["predicted_m"] / span["real_m"], *RATIO)
    print("verdict:", found["check"]["verdict"], found["check"]["factor"])


def forces():
    """What perfect accelerometers measure along the drive, beside what the real ones measured: right-forward-up and forward-right-down."""
    sins("fly", "drive.csv", "--columns", "aligned.toml", "--imu", "ideal.csv", "--quiet", "-o", "drive", "--force")
    ideal = pd.read_csv(FOLDER / "drive" / "ideal.csv", comment="#")
    record = pd.read_csv(FOLDER / "drive.csv").iloc[ALIGNED:].dropna(subset=["AccelX (m/s^2)"])
    begin_s, end_s = ideal.time_s.iloc[0] + 1.0, ideal.time_s.iloc[-1] - 1.0
    seconds = np.arange(begin_s, end_s)

    def means(times_s, increments):
        return np.diff(np.interp(seconds, times_s, np.cumsum(increments)))

    for name, own, sign, axis in (("X", "y", 1.0, "forward"), ("Y", "x", 1.0, "right"), ("Z", "z", -1.0, "down")):
        measured = means(record["TimeFromStart (s)"], 0.01 * record[f"Accel{name} (m/s^2)"])
        off = measured - sign * means(ideal.time_s, ideal[f"velocity_increment_{own}_m_s"])
        within(f"force {axis}, path less sensor [m/s2]", float(np.sqrt(np.mean(off**2))), 0.0, FORCE_M_S2)


def aircraft(name):
    """An aircraft with fixes of 1 Hz: refused as it is, flown when it is smoothed, and compared with its sensors below the cut-off."""
    export(UAVS[name], FOLDER / f"{name}.csv")
    sins("log", f"{name}.csv", "--map", f"{name}.toml", "--force", code=2)
    contains(f"judge of {name}", sins("log", f"{name}.csv", "--columns", f"{name}.toml", code=2), "smooth the log")
    sins("log", f"{name}.csv", "--columns", f"{name}.toml", "--smooth", "-o", f"{name}.path.csv", "--force")
    sins("fly", f"{name}.path.csv", "--quiet", "-o", name, "--force")
    order = ("identify", f"{name}.path.csv", "--imu", f"{name}.csv", "-o", f"{name}.sensor.toml", "--force")
    # The path lacks the fast forces that the sensors measured.
    said = sins(*order, code=2)
    print(f"{name}, without --cutoff: {said.strip()}")
    found = json.loads(sins(*order, "--cutoff", CUTOFF_HZ, "--json"))
    within(f"{name}: attitude late by [ms]", 1e3 * found["clock_shift_s"]["value"], *LATE_MS)
    for section, unit in (("gyro", 57.29578), ("accelerometer", 1e3 / 9.80665)):
        for axis, (bias, off) in zip("xyz", BIASES[section]):
            value = unit * found[section][f"bias {axis}"]["value"]
            if name == "thor60":
                within(f"{name}: {section} bias {axis}", value, bias - off, bias + off)
            else:
                print(f"{name}: {section} bias {axis}: {value:.4g}")
    sins("fly", f"{name}.sensor.toml", "--quiet", "-o", name, "--force")


drive()
for flight in UAVS:
    aircraft(flight)
for wrong in WRONG:
    print("wrong:", wrong)
sys.exit(1 if WRONG else 0)
