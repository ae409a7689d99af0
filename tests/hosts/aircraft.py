"""aircraft.py on a synthetic research aircraft: aircraft.py SINS FOLDER. The program sins makes the flight and the INS; the script must
state the R50 and the errors that the program states, from netCDF files of the structure that those of the aircraft have, and from
comma-separated values, with records missing."""

import csv
import math
import os
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
BLOCKED = FOLDER / "blocked"
RUN = 5


def fly():
    """The records of an hour with sensors of navigation grade, one a second, as columns of the aircraft; R50 of all its seconds from
    300 s on: an hour is too short for that of the program."""
    options = ["--preset", "navigation", "--set", "start.preset=ideal", "--set", f"options.run={RUN}"]
    options += ["--set", "output.every_s=1", "--set", "flight.rate_hz=50", "--set", "options.vertical=follow"]
    command = [SINS, "fly", "racetrack", *options, "--out", FOLDER, "--name", "flight", "-q"]
    subprocess.run(command, check=True)
    records = numpy.genfromtxt(FOLDER / "flight.csv", delimiter=",", names=True)
    scale = {name: math.degrees(1) if field.endswith("_rad") else 1.0 for name, field in COLUMNS.items()}
    columns = {name: records[field] * scale[name] for name, field in COLUMNS.items()}
    radial = numpy.hypot(records["navigation_error_position_east_m"], records["navigation_error_position_north_m"])
    late = records["time_s"] >= 300
    rate = radial[late] / records["time_s"][late]
    r50 = math.sqrt(math.log(2) * numpy.mean(rate**2)) * 3600 / 1852
    return {"Time": 3600.0 * 12 + records["time_s"], **columns}, r50, radial[-1]


def write_csv(columns, path):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values()))


def write_netcdf(columns, path, square=False):
    """As the aircraft's files: whole seconds, all else in single precision, with the attributes of the files of 2013; `square`: with the
    dimension of the samples of a second."""
    with netcdf_file(path, "w") as file:
        file.createDimension("Time", len(columns["GGALT" if "GGALT" in columns else "ALTX"]))
        file.createDimension("sps1", 1)
        for name, column in columns.items():
            whole = name in ("Time", "time_offset")
            variable = file.createVariable(name, "i" if whole else "f", ("Time", "sps1") if square and not whole else ("Time",))
            variable[:] = column.reshape(variable.shape)
            if whole:
                variable.units = "seconds since 2013-10-01 00:00:00 +0000"
                variable.valid_range = numpy.array([0.0, 86400.0], dtype="f")
            else:
                variable._FillValue = numpy.float32(-32767.0)


def run(path, *options, without_netcdf4=False, note=""):
    """What the script says; `without_netcdf4`: where scipy alone is installed; `note`: what the program notes of the log."""
    command = [sys.executable, "-W", "error", SCRIPT, path, "--sins", SINS, "--runs", "128", *options]
    environment = {**os.environ, **({"PYTHONPATH": str(BLOCKED)} if without_netcdf4 else {})}
    done = subprocess.run(command, check=True, capture_output=True, text=True, env=environment)
    assert note in done.stderr and bool(note) == bool(done.stderr), done
    return [line.split() for line in done.stdout.splitlines()]


def stated(path, *options):
    """Numbers that the script prints: R50 and error at the end of the INS, R50 of the ensemble, share of the time within R95."""
    words = run(path, *options)
    return float(words[1][7]), float(words[1][-2]), float(words[2][4]), float(words[3][-5])


def velocities(words):
    """RMS of the velocity error of the INS, and of the ensemble, each east and north."""
    return numpy.array([[float(line[8]), float(line[11])] for line in words if line[:2] == ["RMS", "velocity"]]).T


def rejected(path, words):
    done = subprocess.run([sys.executable, SCRIPT, path, "--sins", SINS], capture_output=True, text=True)
    assert done.returncode == 1 and words in done.stderr, done


columns, r50, end_m = fly()
write_csv(columns, FOLDER / "whole.csv")
write_netcdf(columns, FOLDER / "whole.nc")
picture = FOLDER / "aircraft.png"
for path, options, resolution_m in [("whole.csv", [], 0.1), ("whole.nc", ["-o", picture], 1.0)]:
    of_ins, of_end_m, of_ensemble, share = stated(FOLDER / path, *options)
    # Four digits after the point; the script's metres are those of the true place, the program's are chords: a part in 1e3 of 1 km.
    # Single precision resolves 0.4 m of latitude.
    assert abs(of_ins - r50) < 1e-3 * r50 + 1e-3 * resolution_m, (path, of_ins, r50)
    assert abs(of_end_m - end_m) < 1e-3 * end_m + resolution_m, (path, of_end_m, end_m)
    # A navigation grade INS; a run of the ensemble's own distribution is within its R95 most of the time.
    assert 0.1 < of_ensemble < 2.0 and share > 80.0, (of_ensemble, share)
assert picture.stat().st_size > 10000
# Ten records with missing values, and a longitude beyond the date line.
some = {name: column.copy() for name, column in columns.items()}
some["LAT"][1000:1010] = -32767.0
some["LON"] += 360.0
gap = ": note: a gap of 11 s in the time stamps"
for path, write in [("some.csv", write_csv), ("some.nc", write_netcdf)]:
    write(some, FOLDER / path)
    words = run(FOLDER / path, note=gap)
    assert int(words[0][1][:-1]) == len(some["LAT"]) - 10, words
    assert abs(float(words[1][7]) - r50) < 2e-3 * r50 + 1e-3, (path, words, r50)
# The velocity error, and that of the receiver, which contradicts its positions, does not reach the ensemble.
errors = numpy.array([columns["VEW"] - columns["GGVEW"], columns["VNS"] - columns["GGVNS"]])
rms = numpy.sqrt(numpy.mean((errors - errors[:, :1]) ** 2, axis=1))
contradiction = {**columns, "GGVEW": columns["GGVEW"] + 0.1, "VEW": columns["VEW"] + 0.1}
write_csv(contradiction, FOLDER / "contradiction.csv")
plain, other = run(FOLDER / "whole.csv"), run(FOLDER / "contradiction.csv")
assert plain == other, (plain, other)
assert numpy.all(abs(velocities(plain)[0] - rms) < 1e-3) and numpy.all(velocities(plain)[1] > 0.05), (plain, rms)
# The sample of 2013 has neither position of its own, only their mixture; so the velocities alone are compared.
mixture = {name: column for name, column in columns.items() if name not in ("LAT", "LON", "GGLAT", "GGLON")}
mixture |= {"LATC": columns["GGLAT"], "LONC": columns["GGLON"]}
write_netcdf(mixture, FOLDER / "mixture.nc")
words = run(FOLDER / "mixture.nc", "-o", picture)
assert "LATC" in words[0] and len(words) == 4 and numpy.all(abs(velocities(words)[0] - rms) < 1e-3), (words, rms)
# Older files; the second INS and receiver; times of the day over midnight.
old = {"Time": "time_offset", "GGALT": "ALTX"}
write_netcdf({old.get(name, name): column for name, column in columns.items()}, FOLDER / "old.nc", square=True)
BLOCKED.mkdir(exist_ok=True)
(BLOCKED / "netCDF4.py").write_text("raise ImportError\n")
assert run(FOLDER / "old.nc") == run(FOLDER / "whole.nc") == run(FOLDER / "whole.nc", without_netcdf4=True)
assert run(FOLDER / "some.nc", note=gap) == run(FOLDER / "some.nc", without_netcdf4=True, note=gap)
second = {name: column for name, column in columns.items() if name == "Time"}
second |= {name + ("_GMN" if name.startswith("GG") else "_IRS2"): column for name, column in columns.items() if name != "Time"}
write_csv(second, FOLDER / "second.csv")
assert run(FOLDER / "second.csv", "--ins", "_IRS2", "--gps", "_GMN") == plain
clock = [f"{t // 3600 % 24:02}:{t // 60 % 60:02}:{t % 60:02}" for t in (columns["Time"] + 11.5 * 3600).astype(int)]
write_csv({"UTC": clock, **{name: column for name, column in columns.items() if name != "Time"}}, FOLDER / "clock.csv")
assert run(FOLDER / "clock.csv") == plain
write_csv({name: column for name, column in columns.items() if name != "GGLAT"}, FOLDER / "less.csv")
rejected(FOLDER / "less.csv", "no column GGLAT")
write_csv({name: column for name, column in columns.items() if name not in ("LON", "VEW")}, FOLDER / "less.csv")
rejected(FOLDER / "less.csv", "no column LON")
write_csv({name: column[:100] for name, column in columns.items()}, FOLDER / "short.csv")
rejected(FOLDER / "short.csv", "too short for R50")
print(f"aircraft: R50 {r50:.4f} nmi/h, {end_m:.1f} m at the end, RMS velocity error {rms[0]:.3f} and {rms[1]:.3f} m/s: as sins states; "
      f"ensemble {of_ensemble:.4f} nmi/h")
