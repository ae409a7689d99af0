"""A real INS, by the program `sins` alone: real_imu.py PROGRAM FOLDER, in an environment with onavdata and pandas.

Prints each figure with its bars, and exits with 1 if one is beyond them. Bars are wide where a figure hangs on few flights.
"""

import contextlib
import io
import json
import subprocess
import sys
from pathlib import Path

import onavdata

PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2])
DRIVE = "2021-04-27 HGuide n380 Car Hill Driving"
UAV = "2012 UMN-UAV THOR60"
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
    found = json.loads(
        sins(
            *("identify", "drive.csv", "--columns", "aligned.toml", "--imu", "drive.csv", "--prior", "tactical"),
            *("--check", "--truth-sigma", "velocity_m_s=0.03,tilt_arcmin=1.5,heading_arcmin=10"),
            *("-o", "sensor.toml", "--force", "--json"),
        )
    )
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


def aircraft():
    """An aircraft with fixes of 1 Hz: refused as it is, flown when it is smoothed; its path has other forces than its sensors measured."""
    export(UAV, FOLDER / "uav.csv")
    sins("log", "uav.csv", "--map", "uav.toml", "--force", code=2)
    contains("judge of the aircraft", sins("log", "uav.csv", "--columns", "uav.toml", code=2), "smooth the log")
    sins("log", "uav.csv", "--columns", "uav.toml", "--smooth", "-o", "uav.path.csv", "--force")
    sins("fly", "uav.path.csv", "--quiet", "-o", "uav", "--force")
    said = sins("identify", "uav.path.csv", "--imu", "uav.csv", "-o", "uav.sensor.toml", code=2)
    print("sensors of the aircraft:", said.strip())
    contains("sensors of the aircraft", said, "at least 0.8 if the path has its forces")


drive()
aircraft()
for wrong in WRONG:
    print("wrong:", wrong)
sys.exit(1 if WRONG else 0)
