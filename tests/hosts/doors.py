"""Every scene ends alike through every door of Python: doors.py FOLDER, a folder that apps/cli/tests/program/doors.rs has written.

The doors are the example fly.py, and of the package fly(), Flight() and the first of two runs of ensemble(). ends.txt has for each
scene the bits of the nine errors, and of what the INS shows; or "stopped" if an entry at the panel came at the wrong moment.
"""

import pathlib
import struct
import sys
import warnings

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "c_examples/python"))

import fly as example
import sins
from sins import c

FOLDER = pathlib.Path(sys.argv[1])
FIELDS = "position_enu_m", "velocity_enu_m_s", "misalignment_enu_rad"


def words(numbers):
    return [struct.pack(">d", number).hex() for number in numbers]


def errors(record):
    return words(number for field in FIELDS for number in record["navigation_errors"][field])


def by_example(path):
    return errors(example.fly(*example.open_scene(path, None))[-1])


def by_package(path):
    return errors(sins.fly(path).records[-1])


def by_flight(path):
    with sins.Flight(path) as flight:
        while len(flight.fly(10.0)):
            pass
        status, shown = c.unit_status(), c.unit_navigation()
        c.play_get_shown(flight._play, status, shown)
        return errors(flight.record) + words(
            [shown.latitude_rad, shown.longitude_rad, shown.height_m, *shown.velocity_enu_m_s, shown.roll_rad, shown.pitch_rad,
             shown.heading_rad]) + [str(status.validity), str(status.state)]


def by_ensemble(path):
    try:
        drawn = sins.ensemble(path, runs=2, times=2)
    except ValueError as error:
        if "nothing is random" not in str(error):
            raise
        drawn = sins.ensemble(path, runs=1, times=2)
    ends = drawn.position_error_m, drawn.velocity_error_m_s, drawn.misalignment_rad
    return words(number for errors in ends for number in errors[0, -1])


DOORS = {
    "fly.py": by_example,
    "sins.fly": by_package,
    "sins.Flight": by_flight,
    "sins.ensemble": by_ensemble,
}
warnings.simplefilter("ignore")  # of large errors
count = 0
for line in (FOLDER / "ends.txt").read_text().splitlines():
    name, *end = line.split()
    for door, flies in DOORS.items():
        try:
            found = flies(str(FOLDER / f"{name}.toml"))
        except sins.Error as error:
            assert error.status == c.ERROR_BAD_STATE and "panel" in str(error), f"{door}, {name}: {error}"
            found = ["stopped"]
        # Of two runs the second may be ended where the first is not.
        if found != ["stopped"] or door != "sins.ensemble":
            assert found == end[: len(found)], f"{door}, {name}: ends with {found}, not with {end[: len(found)]}"
    count += 1
assert count > 40, count
print(f"python: {count} scenes end alike through {', '.join(DOORS)}")
