#!/usr/bin/env python3
"""Compares the INS of a research aircraft with an ensemble of simulated ones: aircraft.py RF01.nc --sins target/release/sins -o rf01.png

The file has the columns of the NSF/NCAR aircraft (GV, C-130): the INS in LAT, LON, PITCH, ROLL, THDG and the truth, a GPS receiver, in
GGLAT, GGLON, GGALT; also the truth in GGVEW, GGVNS, GGVSPD if it has these. It is a netCDF file or comma-separated values, one record
a second. `sins ensemble` flies the true motion many times with sensors of navigation grade, or with those of --scene. The picture
has the error of the real INS beside the envelope of the simulated ones. Both begin without an error at the first record.
"""

import argparse
import csv
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy

TRUTH = {"GGLAT": "latitude_deg", "GGLON": "longitude_deg", "GGALT": "height_m", "ROLL": "roll_deg", "PITCH": "pitch_deg",
         "THDG": "heading_deg"}
VELOCITY = {"GGVEW": "velocity_east_m_s", "GGVNS": "velocity_north_m_s", "GGVSPD": "velocity_up_m_s"}
INS = ["LAT", "LON"]
MISSING = -32767.0
NMI_H = 1852.0 / 3600.0
WINDOW_S = 300.0  # the window of R50 begins there, as in the figures of sins
EQUATOR_M, E2 = 6378137.0, 6.69437999014e-3  # WGS 84


def read_netcdf(path):
    """The variables of a netCDF file as a dictionary; several samples a second are reduced to the first one."""
    try:
        from netCDF4 import Dataset
        variables = Dataset(path).variables
    except ImportError:  # scipy reads the classic format alone
        from scipy.io import netcdf_file
        variables = netcdf_file(path, mmap=False).variables
    names = ["Time", *TRUTH, *VELOCITY, *INS]
    columns = {name: numpy.array(variables[name][:], dtype=float) for name in names if name in variables}
    return {name: column if column.ndim == 1 else column[:, 0] for name, column in columns.items()}


def read_csv(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    names = [name for name in ["Time", *TRUTH, *VELOCITY, *INS] if rows and name in rows[0]]
    return {name: numpy.array([float(row[name] or MISSING) for row in rows]) for name in names}


def read(path):
    """The columns of the records that have all of them; the time begins at 0."""
    columns = read_netcdf(path) if path.endswith(".nc") else read_csv(path)
    missing = [name for name in ["Time", *TRUTH, *INS] if name not in columns]
    if missing:
        sys.exit(f"{path}: no column {', '.join(missing)}")
    good = numpy.all([numpy.isfinite(column) & (column != MISSING) for column in columns.values()], axis=0)
    if good.sum() < 2:
        sys.exit(f"{path}: {good.sum()} records have all columns; at least 2 are needed")
    columns = {name: column[good] for name, column in columns.items()}
    columns["Time"] = columns["Time"] - columns["Time"][0]
    return columns


def error_of(columns):
    """Error of the INS east and north [m], less that of the first record."""
    latitude = numpy.radians(columns["GGLAT"])
    square = 1.0 - E2 * numpy.sin(latitude) ** 2
    prime = EQUATOR_M / numpy.sqrt(square)
    meridian = prime * (1.0 - E2) / square
    turn = (columns["LON"] - columns["GGLON"] + 180.0) % 360.0 - 180.0
    east = numpy.radians(turn) * (prime + columns["GGALT"]) * numpy.cos(latitude)
    north = numpy.radians(columns["LAT"] - columns["GGLAT"]) * (meridian + columns["GGALT"])
    return east - east[0], north - north[0]


def ensemble_of(columns, arguments, folder):
    """Flies the truth as a log, and returns the statistics of the runs over time."""
    log = folder / "flight.csv"
    names = {"Time": "time_s", **TRUTH, **(VELOCITY if all(name in columns for name in VELOCITY) else {})}
    numpy.savetxt(log, numpy.column_stack([columns[name] for name in names]), delimiter=",", fmt="%.12g",
                  header=",".join(names.values()), comments="")
    scene = [arguments.scene, "--log"] if arguments.scene else []
    # Records may be missing: the true motion between the others is then that of the library's interpolation.
    gap = ["--set", f"options.max_gap_s={math.ceil(numpy.diff(columns['Time']).max() + 0.5)}"]
    output = ["--runs", str(arguments.runs), "--out", str(folder), "--name", "flight", "-q"]
    command = [arguments.sins, "ensemble", *scene, str(log), *gap, *output]
    if subprocess.run(command).returncode != 0:
        sys.exit(f"aircraft.py: {' '.join(command)} failed")
    statistics = numpy.genfromtxt(folder / "flight_ensemble.csv", delimiter=",", names=True)
    return statistics[statistics["error_data"] == 2]


def r50(time_s, squares):
    """R50 = 0.8326 sqrt(mean RER^2) [nmi/h] of the squares of the horizontal error [m^2], RER = error / time."""
    late = time_s >= WINDOW_S
    if not late.any():
        sys.exit(f"aircraft.py: a flight of {time_s[-1]:.0f} s is too short for R50, whose window begins at {WINDOW_S:.0f} s")
    return math.sqrt(math.log(2.0)) * math.sqrt(numpy.mean(squares[late] / time_s[late] ** 2)) / NMI_H


def draw(time_s, east, north, statistics, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    hours, simulated = time_s / 3600, (statistics["time_s"] - statistics["time_s"][0]) / 3600
    figure, axes = pyplot.subplots(3, 1, figsize=(9, 9), sharex=True, constrained_layout=True)
    for axis, error, name in zip(axes, (east, north), ("east", "north")):
        mean, sigma = (statistics[f"{what}_position_{name}_m"] / 1e3 for what in ("mean", "sigma"))
        for width in (3, 1):
            band = mean - width * sigma, mean + width * sigma
            axis.fill_between(simulated, *band, color="C0", alpha=0.2, label=f"ensemble, {width} sigma")
        axis.plot(hours, error / 1e3, "k", linewidth=1.2, label="INS of the aircraft")
        axis.set_ylabel(f"{name} [km]")
    axes[2].plot(simulated, statistics["r95_m"] / 1e3, "C0--", label="ensemble, R95")
    axes[2].plot(simulated, statistics["cep50_m"] / 1e3, "C0", label="ensemble, CEP50")
    axes[2].plot(hours, numpy.hypot(east, north) / 1e3, "k", linewidth=1.2, label="INS of the aircraft")
    axes[2].set_ylabel("horizontal [km]")
    axes[2].set_xlabel("time since the first record [h]")
    for axis in axes:
        axis.grid(alpha=0.3)
        axis.legend(fontsize="small", loc="upper left")
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("flight", help="the file of the aircraft, .nc or .csv")
    parser.add_argument("--sins", default="sins", help="the program sins")
    parser.add_argument("--scene", help="a scene with the sensors of the ensemble, instead of those of navigation grade")
    parser.add_argument("--runs", type=int, default=200, help="number of runs of the ensemble")
    parser.add_argument("-o", "--output", help="the picture, .png or .svg")
    arguments = parser.parse_args()
    columns = read(arguments.flight)
    time_s = columns["Time"]
    east, north = error_of(columns)
    with tempfile.TemporaryDirectory() as folder:
        statistics = ensemble_of(columns, arguments, pathlib.Path(folder))
    if arguments.output:
        draw(time_s, east, north, statistics, arguments.output)
    simulated_s = statistics["time_s"] - statistics["time_s"][0]
    radial = numpy.hypot(east, north)
    inside = numpy.mean(radial[1:] <= numpy.interp(time_s[1:], simulated_s, statistics["r95_m"]))
    squares = statistics["rms_position_east_m"] ** 2 + statistics["rms_position_north_m"] ** 2
    print(f"records {len(time_s)}, {time_s[-1] / 3600:.2f} h")
    print(f"R50 of the INS of the aircraft {r50(time_s, radial**2):.4f} nmi/h, error at the end {radial[-1]:.1f} m")
    cep50_m, r95_m = (statistics[name][-1] for name in ("cep50_m", "r95_m"))
    print(f"R50 of the ensemble {r50(simulated_s, squares):.4f} nmi/h, at the end CEP50 {cep50_m:.1f} m, R95 {r95_m:.1f} m")
    print(f"the INS is within R95 of the ensemble for {100 * inside:.1f} % of the flight")


if __name__ == "__main__":
    main()
