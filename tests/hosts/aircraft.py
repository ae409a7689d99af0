"""aircraft.py on a synthetic research aircraft: aircraft.py SINS FOLDER. The program sins makes the flight and the INS; the script must
state the R50 and the error that the program states, from a netCDF file and from comma-separated values, with records missing."""

import csv
import math
import pathlib
import subprocess
import sys

import numpy
from scipy.io import netcdf_file

COLUMNS = {"LAT": "navigation_latitude_rad", "LON": "navigation_longitude_rad", "VEW": "navigation_velocity_east_m_s",
           "VNS": "navigation_velocity_north_m_s", "PITCH": "navigation_pitch_rad", "ROLL": "navigation_roll_rad",
           "THDG": "navigation_heading_rad", "GGLAT": "truth_latitude_rad", "GGLON": "truth_longitude_rad",
           "GGALT": "truth_height_m", "GGVEW": "truth_velocity_east_m_s", "GGVNS": "truth_velocity_north_m_s",
           "GGVSPD": "truth_velocity_up_m_s"}
SINS, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "c_examples/python/aircraft.py"
RUN = 5


def fly():
    """The records of an hour with sensors of navigation grade, one a second, as columns of the aircraft; R50 of the program."""
    options = ["--preset", "navigation", "--set", "start.preset=ideal", "--set", f"options.run={RUN}"]
    options += ["--set", "output.every_s=1", "--set", "flight.rate_hz=50", "--set", "options.vertical=follow"]
    command = [SINS, "fly", "racetrack", *options, "--out", FOLDER, "--name", "flight", "-q"]
    subprocess.run(command, check=True)
    records = numpy.genfromtxt(FOLDER / "flight.csv", delimiter=",", names=True)
    scale = {name: math.degrees(1) if field.endswith("_rad") else 1.0 for name, field in COLUMNS.items()}
    columns = {name: records[field] * scale[name] for name, field in COLUMNS.items()}
    with open(FOLDER / "flight_summary.csv", newline="") as file:
        figures = {row[0]: row[1] for row in csv.reader(file) if len(row) > 1}
    radial = numpy.hypot(records["navigation_error_position_east_m"], records["navigation_error_position_north_m"])
    return {"Time": 3600.0 * 12 + records["time_s"], **columns}, float(figures["r50_nmi_h"]), radial[-1]


def write_csv(columns, path):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values()))


def write_netcdf(columns, path):
    """Positions in double precision, the others in single precision, as the aircraft's files have."""
    with netcdf_file(path, "w") as file:
        file.createDimension("Time", len(columns["Time"]))
        for name, column in columns.items():
            exact = name in ("Time", "LAT", "LON", "GGLAT", "GGLON", "GGALT")
            file.createVariable(name, "d" if exact else "f", ("Time",))[:] = column


def stated(path, *options):
    """Numbers that the script prints: R50 and error at the end of the INS, R50 of the ensemble, share of the time within R95."""
    command = [sys.executable, SCRIPT, path, "--sins", SINS, "--runs", "128", *options]
    said = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    words = [line.split() for line in said]
    return float(words[1][7]), float(words[1][-2]), float(words[2][4]), float(words[3][-5])


def rejected(path, words):
    done = subprocess.run([sys.executable, SCRIPT, path, "--sins", SINS], capture_output=True, text=True)
    assert done.returncode == 1 and words in done.stderr, done


columns, r50, end_m = fly()
write_csv(columns, FOLDER / "whole.csv")
write_netcdf(columns, FOLDER / "whole.nc")
picture = FOLDER / "aircraft.png"
for path, options in [("whole.csv", []), ("whole.nc", ["-o", picture])]:
    of_ins, of_end_m, of_ensemble, share = stated(FOLDER / path, *options)
    # Four digits after the point; the script's metres are those of the true place, the program's are chords: a part in 1e3 of 1 km.
    assert abs(of_ins - r50) < 1e-3 * r50 + 1e-4 and abs(of_end_m - end_m) < 1e-3 * end_m + 0.1, (of_ins, r50, of_end_m, end_m)
    # A navigation grade INS; a run of the ensemble's own distribution is within its R95 most of the time.
    assert 0.1 < of_ensemble < 2.0 and share > 80.0, (of_ensemble, share)
assert picture.stat().st_size > 10000
# Ten records with missing values, and a longitude beyond the date line.
some = {name: column.copy() for name, column in columns.items()}
some["LAT"][1000:1010] = -32767.0
some["LON"] += 360.0
write_csv(some, FOLDER / "some.csv")
gaps = stated(FOLDER / "some.csv")
assert abs(gaps[0] - r50) < 2e-3 * r50 + 1e-4, (gaps, r50)
write_csv({name: column for name, column in columns.items() if name != "GGLAT"}, FOLDER / "less.csv")
rejected(FOLDER / "less.csv", "no column GGLAT")
write_csv({name: column[:100] for name, column in columns.items()}, FOLDER / "short.csv")
rejected(FOLDER / "short.csv", "too short for R50")
print(f"aircraft: R50 {r50:.4f} nmi/h, {end_m:.1f} m at the end: as sins states; ensemble {of_ensemble:.4f} nmi/h")
