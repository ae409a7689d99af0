"""The unit in Ecos, a co-simulation engine in C++, coupled with a unit of a table that PythonFMU makes:
couple.py UNIT.fmu FOLDER SINS, where SINS is the program sins.
The outputs of each step equal the records of the program for this table, to the bit."""

import csv
import subprocess
import sys
from pathlib import Path

from ecospy import EcosSimulation, EcosSimulationStructure
from pythonfmu.csvbuilder import CsvFmuBuilder

FMU, FOLDER, SINS = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), sys.argv[3]
RATE_HZ, FRAMES = 128, 128 * 60  # times are exact in binary, because Ecos sums its steps
INPUTS = ["latitude_rad", "longitude_rad", "height_m", "velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s", "roll_rad",
          "pitch_rad", "heading_rad"]


def truth(frame):
    """Along the equator with 2^-15 rad/s of longitude, rolling to and fro, like host.c."""
    p = frame % 256 / 256
    roll = (p if frame % 512 < 256 else -p) * (1 - p)
    return [frame / RATE_HZ, 0.0, frame / RATE_HZ / 32768, 1000.0, 6379137 / 32768, 0.0, 0.0, roll, 0.0, 1.5]


# The program and PythonFMU both read names without a type.
table = FOLDER / "table.csv"
with open(table, "w", newline="") as file:
    rows = csv.writer(file)
    rows.writerow(["time_s", *INPUTS])
    rows.writerows(truth(frame) for frame in range(FRAMES + 1))
source = CsvFmuBuilder.build_FMU(table, dest=FOLDER)

subprocess.run([SINS, "fly", "c_examples/scenes/fighter.toml", "--log", table, "--out", FOLDER, "--name", "coupled",
                "--force", "--quiet", "--set", f"output.every_s={1 / RATE_HZ}"], check=True)
with open(FOLDER / "coupled.csv") as file:
    records = list(csv.DictReader(file))

COLUMNS = {"time_s": "time_of_solution_s"}
for name in INPUTS:
    COLUMNS[f"navigation_{name}"] = f"navigation.{name}"
for kind, unit in (("position", "m"), ("velocity", "m_s"), ("misalignment", "rad")):
    for axis in ("east", "north", "up"):
        COLUMNS[f"navigation_error_{kind}_{axis}_{unit}"] = f"errors.{kind}_{axis}_{unit}"

with EcosSimulationStructure() as structure:
    structure.add_model("table", source)
    structure.add_model("sins", FMU)
    for name in INPUTS:
        structure.make_real_connection(f"table::{name}", f"sins::truth.{name}")
    structure.add_parameter_set("start", {"sins::scene_file": "fighter.toml", "table::interpolate": False})
    with EcosSimulation(structure=structure, step_size=1 / RATE_HZ) as simulation:
        simulation.init(parameter_set="start")
        flown = {}
        for frame in range(FRAMES):
            simulation.step()
            values = [simulation.get_real(f"sins::{name}") for name in COLUMNS.values()]
            flown[values[0]] = values
        simulation.terminate()

compared = 0
for record in records:
    values = [float(record[name]) for name in COLUMNS]
    if values[0] in flown:
        compared += 1
        if flown[values[0]] != values:
            sys.exit(f"failed: Ecos at {values[0]} s: {flown[values[0]]}, the program: {values}")
if compared < FRAMES - 2 or abs(float(records[-1]["navigation_error_position_north_m"])) == 0.0:
    sys.exit(f"failed: {compared} of {FRAMES} steps compared")
print(f"{compared} records of two coupled units equal to the program's, to the bit")
