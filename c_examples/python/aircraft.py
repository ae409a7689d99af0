#!/usr/bin/env python3
"""Compares the INS of a research aircraft with an ensemble of simulated ones: aircraft.py RF01.nc --sins target/release/sins -o rf01.png

The file has the columns of the NSF/NCAR aircraft (GV, C-130), one record a second, as netCDF or as comma-separated values. The INS is
in LAT, LON, or in VEW, VNS, or in both; beside it is a GPS receiver in GGLAT, GGLON, or in GGVEW, GGVNS. `sins ensemble` flies the
true motion (GGLAT, GGLON, GGALT, PITCH, ROLL, THDG) many times with sensors of navigation grade, or with those of --scene. The picture
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

# Names of a column in the files, the usual one first. GPS, INS: the receiver and the INS, whose names can have a suffix.
GPS = {"latitude": ["GGLAT"], "longitude": ["GGLON"], "height": ["GGALT", "ALTX"], "east": ["GGVEW"], "north": ["GGVNS"]}
INS = {"ins_latitude": ["LAT"], "ins_longitude": ["LON"], "ins_east": ["VEW"], "ins_north": ["VNS"], "roll": ["ROLL"],
       "pitch": ["PITCH"], "heading": ["THDG"]}
TIME = ["Time", "time_offset", "UTC"]
# A filter's mixture of GPS and INS: good enough for a path, but no reference for a position.
MIXED = {"latitude": ["LATC"], "longitude": ["LONC"]}
# The path has no velocity: that of a receiver contradicts its positions, and a constant contradiction is an error of the truth that grows.
PATH = {"time": "time_s", "latitude": "latitude_deg", "longitude": "longitude_deg", "height": "height_m", "roll": "roll_deg",
        "pitch": "pitch_deg", "heading": "heading_deg"}
POSITION = ["ins_latitude", "ins_longitude"]
VELOCITY = ["ins_east", "ins_north", "east", "north"]
MISSING = -32767.0
NMI_H = 1852.0 / 3600.0
WINDOW_S = 300.0  # the window of R50 begins there, as in the figures of sins
EQUATOR_M, E2 = 6378137.0, 6.69437999014e-3  # WGS 84


def read_netcdf(path):
    """The names of the variables of a netCDF file, and a function that reads one; missing values become not a number."""
    try:
        from netCDF4 import Dataset
        data = Dataset(path)
        data.set_auto_maskandscale(False)  # a range of another type than its variable would be a warning
        variables = data.variables
    except ImportError:  # scipy reads the classic format alone
        from scipy.io import netcdf_file
        variables = netcdf_file(path, mmap=False).variables

    def column(name):
        variable = variables[name]
        values = numpy.array(variable[:], dtype=float)
        values = values if values.ndim == 1 else values[:, 0]  # the first of the samples of a second
        fill = getattr(variable, "_FillValue", MISSING)
        return numpy.where((values == fill) | (values == MISSING), numpy.nan, values)

    return {name for name in variables if variables[name].shape}, column


def number(text):
    """A number, a time of the day in seconds, or not a number."""
    if ":" in text:
        hours, minutes, seconds = text.split(":")
        return 3600 * float(hours) + 60 * float(minutes) + float(seconds)
    return float(text or "nan")


def read_csv(path):
    """As read_netcdf."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file, skipinitialspace=True))

    def column(name):
        values = numpy.array([number(row[name]) for row in rows])
        return numpy.where(values == MISSING, numpy.nan, values)

    return set(rows[0] if rows else ()), column


def read(path, gps_suffix, ins_suffix):
    """The columns of the records that have all of them, by our names; the time begins at 0."""
    there, column = read_netcdf(path) if path.endswith(".nc") else read_csv(path)
    columns, unknown = {}, {}
    for table, suffix in (({"time": TIME}, ""), (GPS, gps_suffix), (INS, ins_suffix)):
        for ours, names in table.items():
            found = [name + suffix for name in names if name + suffix in there]
            if found:
                columns[ours] = column(found[0])
            else:
                unknown[ours] = names[0] + suffix
    mixed = not {"latitude", "longitude"} <= columns.keys() and all(names[0] in there for names in MIXED.values())
    if mixed:
        columns |= {ours: column(names[0]) for ours, names in MIXED.items()}
        print(f"no {unknown.get('latitude', unknown.get('longitude'))}: the path is that of LATC and LONC, which mix GPS and INS")
    position = all(name in columns for name in POSITION) and not mixed
    velocity = all(name in columns for name in VELOCITY)
    needed = [*PATH, *([] if position or velocity or mixed else POSITION), *(VELOCITY if mixed else [])]
    missing = [unknown[name] for name in needed if name not in columns]
    if missing:
        sys.exit(f"{path}: no column {', '.join(missing)}")
    used = [*PATH, *(POSITION if position else []), *(VELOCITY if velocity else [])]
    columns = {name: columns[name] for name in used}
    good = numpy.all([numpy.isfinite(values) for values in columns.values()], axis=0)
    if good.sum() < 2:
        sys.exit(f"{path}: {good.sum()} records have all columns; at least 2 are needed")
    columns = {name: values[good] for name, values in columns.items()}
    columns["time"] = columns["time"] - columns["time"][0]
    if columns["time"][-1] < 0.0:  # over midnight
        columns["time"] = columns["time"] % 86400.0
    return columns, position, velocity


def position_error(columns):
    """Error of the INS east and north [m], less that of the first record."""
    latitude = numpy.radians(columns["latitude"])
    square = 1.0 - E2 * numpy.sin(latitude) ** 2
    prime = EQUATOR_M / numpy.sqrt(square)
    meridian = prime * (1.0 - E2) / square
    turn = (columns["ins_longitude"] - columns["longitude"] + 180.0) % 360.0 - 180.0
    east = numpy.radians(turn) * (prime + columns["height"]) * numpy.cos(latitude)
    north = numpy.radians(columns["ins_latitude"] - columns["latitude"]) * (meridian + columns["height"])
    return east - east[0], north - north[0]


def velocity_error(columns):
    """Error of the INS east and north [m/s], less that of the first record."""
    east, north = columns["ins_east"] - columns["east"], columns["ins_north"] - columns["north"]
    return east - east[0], north - north[0]


def ensemble_of(columns, arguments, folder):
    """Flies the truth as a log, and returns the statistics of the runs over time."""
    log = folder / "flight.csv"
    numpy.savetxt(log, numpy.column_stack([columns[name] for name in PATH]), delimiter=",", fmt="%.12g", header=",".join(PATH.values()),
                  comments="")
    scene = [arguments.scene, "--log"] if arguments.scene else []
    # Records may be missing: the true motion between the others is then that of the library's interpolation.
    gap = ["--set", f"options.max_gap_s={math.ceil(numpy.diff(columns['time']).max() + 0.5)}"]
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


def draw(time_s, errors, statistics, path):
    """A row of plots for each axis of each error in `errors`, and one for the horizontal position error."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    hours, simulated = time_s / 3600, (statistics["time_s"] - statistics["time_s"][0]) / 3600
    rows = 2 * len(errors) + ("position" in errors)
    figure, axes = pyplot.subplots(rows, 1, figsize=(9, 3 * rows), sharex=True, constrained_layout=True)
    free = iter(axes)
    for quantity, error in errors.items():
        unit, scale = {"position": ("km", 1e-3), "velocity": ("m/s", 1.0)}[quantity]
        suffix = {"position": "m", "velocity": "m_s"}[quantity]
        for values, name in zip(error, ("east", "north")):
            axis = next(free)
            mean, sigma = (scale * statistics[f"{what}_{quantity}_{name}_{suffix}"] for what in ("mean", "sigma"))
            for width in (3, 1):
                band = mean - width * sigma, mean + width * sigma
                axis.fill_between(simulated, *band, color="C0", alpha=0.2, label=f"ensemble, {width} sigma")
            axis.plot(hours, scale * values, "k", linewidth=1.2, label="INS of the aircraft")
            axis.set_ylabel(f"{quantity} {name} [{unit}]")
        if quantity == "position":
            axis = next(free)
            axis.plot(simulated, scale * statistics["r95_m"], "C0--", label="ensemble, R95")
            axis.plot(simulated, scale * statistics["cep50_m"], "C0", label="ensemble, CEP50")
            axis.plot(hours, scale * numpy.hypot(*error), "k", linewidth=1.2, label="INS of the aircraft")
            axis.set_ylabel(f"horizontal [{unit}]")
    axes[-1].set_xlabel("time since the first record [h]")
    for axis in axes:
        axis.grid(alpha=0.3)
        axis.legend(fontsize="small", loc="upper left")
    figure.savefig(path, dpi=120)


def print_position(time_s, error, statistics):
    simulated_s = statistics["time_s"] - statistics["time_s"][0]
    radial = numpy.hypot(*error)
    inside = numpy.mean(radial[1:] <= numpy.interp(time_s[1:], simulated_s, statistics["r95_m"]))
    squares = statistics["rms_position_east_m"] ** 2 + statistics["rms_position_north_m"] ** 2
    print(f"R50 of the INS of the aircraft {r50(time_s, radial**2):.4f} nmi/h, error at the end {radial[-1]:.1f} m")
    cep50_m, r95_m = (statistics[name][-1] for name in ("cep50_m", "r95_m"))
    print(f"R50 of the ensemble {r50(simulated_s, squares):.4f} nmi/h, at the end CEP50 {cep50_m:.1f} m, R95 {r95_m:.1f} m")
    print(f"the INS is within R95 of the ensemble for {100 * inside:.1f} % of the flight")


def print_velocity(time_s, error, statistics):
    simulated_s = statistics["time_s"] - statistics["time_s"][0]
    for values, name in zip(error, ("east", "north")):
        rms = numpy.interp(time_s, simulated_s, statistics[f"rms_velocity_{name}_m_s"])
        ins, ensemble = (math.sqrt(numpy.mean(one**2)) for one in (values, rms))
        print(f"RMS velocity error {name}: INS of the aircraft {ins:.3f} m/s, ensemble {ensemble:.3f} m/s")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("flight", help="the file of the aircraft, .nc or .csv")
    parser.add_argument("--sins", default="sins", help="the program sins")
    parser.add_argument("--scene", help="a scene with the sensors of the ensemble, instead of those of navigation grade")
    parser.add_argument("--runs", type=int, default=200, help="number of runs of the ensemble")
    parser.add_argument("--ins", default="", metavar="SUFFIX", help="suffix of another INS: _IRS2 reads LAT_IRS2, PITCH_IRS2 ...")
    parser.add_argument("--gps", default="", metavar="SUFFIX", help="suffix of another receiver: _GMN reads GGLAT_GMN, GGALT_GMN ...")
    parser.add_argument("-o", "--output", help="the picture, .png or .svg")
    arguments = parser.parse_args()
    columns, position, velocity = read(arguments.flight, arguments.gps, arguments.ins)
    time_s = columns["time"]
    errors = ({"position": position_error(columns)} if position else {}) | ({"velocity": velocity_error(columns)} if velocity else {})
    with tempfile.TemporaryDirectory() as folder:
        statistics = ensemble_of(columns, arguments, pathlib.Path(folder))
    if arguments.output:
        draw(time_s, errors, statistics, arguments.output)
    print(f"records {len(time_s)}, {time_s[-1] / 3600:.2f} h")
    if position:
        print_position(time_s, errors["position"], statistics)
    if velocity:
        print_velocity(time_s, errors["velocity"], statistics)


if __name__ == "__main__":
    main()
