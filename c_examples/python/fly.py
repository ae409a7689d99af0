#!/usr/bin/env python3
"""Flies a scene and draws the errors of its navigation: fly.py c_examples/scenes/patrol.toml -o patrol.png

The flight is built-in or made of manoeuvres. sins_run() flies it, ten minutes in each call: the
samples of all 48 hours of the patrol would need 2.5 GB.
"""

import argparse
import sys

import matplotlib
import numpy
import sins
from matplotlib import pyplot

matplotlib.use("Agg")  # draws into a file, without a window
CALL_S = 600.0


def open_scene(name, hours):
    """The scene of a file, or a built-in one. `hours` replaces its duration."""
    if name.endswith(".toml"):
        with open(name, "rb") as file:
            scene = sins.scene_parse(file.read())
    else:
        scene = sins.scene_create_builtin(name)
    if hours is not None:
        sins.scene_set_values(scene, f"flight.hours = {hours}")
    setup = sins.scene_get_setup(scene)
    failures = sins.scene_get_failure_count(scene)
    if setup.flight == sins.SCENE_FLIGHT_LOG or setup.has_temperature or failures:
        sys.exit(f"{name}: a log, a temperature or failures want sins.scene_prepare() before each sample: see harness.c")
    return scene, setup


def fly(scene, setup):
    """Flies the whole flight and returns the records as a numpy array, and the last record."""
    count = int(setup.flown_s * setup.rate_hz + 1e-6) + 1  # 1e-6: rounding
    every = max(1, round((setup.every_s or setup.flown_s / 1000) * setup.rate_hz))
    times_s = numpy.minimum(numpy.arange(count) / setup.rate_hz, setup.flown_s)
    with sins.scene_create_simulator(scene) as sim, sins.scene_create_flight(scene) as flight:
        parts = numpy.array_split(times_s, int(setup.flown_s / CALL_S) + 1)
        records = [sins.fly(sim, sins.samples_at(flight, part), every) for part in parts]
        return numpy.concatenate(records), sins.get_record(sim)


def draw(records, title, path):
    """Draws the errors: navigation minus truth, and over them the errors of the error differential equations, if these were on."""
    hours, model = records["time_s"] / 3600, records["model_errors"]
    rows = [("position_enu_m", 1e3, "position [km]"), ("velocity_enu_m_s", 1, "velocity [m/s]"),
            ("misalignment_enu_rad", sins.ARCSEC, "misalignment [arcsec]")]
    figure, axes = pyplot.subplots(3, 1, figsize=(9, 9), sharex=True, constrained_layout=True)
    for axis, (field, unit, label) in zip(axes, rows):
        axis.plot(hours, records["navigation_errors"][field] / unit, linewidth=1.5, label=["east", "north", "up"])
        if not (model["flags"] & sins.ERRORS_NOT_COMPUTED).any():
            axis.plot(hours, model[field] / unit, "k:", linewidth=1, label=["error equations", None, None])
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    axes[0].legend(ncol=4, fontsize="small")
    axes[0].set_title(title)
    axes[-1].set_xlabel("time [h]")
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scene", help="a scene, SCENE.toml, or the name of a built-in one")
    parser.add_argument("--hours", type=float, help="how long to fly, in place of what the scene states")
    parser.add_argument("-o", "--output", help="the picture, .png or .svg")
    arguments = parser.parse_args()
    try:
        scene, setup = open_scene(arguments.scene, arguments.hours)
        records, last = fly(scene, setup)
        title = sins.scene_get_text(scene, sins.SCENE_TEXT_TITLE) or arguments.scene
        if arguments.output:
            draw(records, title, arguments.output)
    except sins.Error as error:
        sys.exit(f"fly.py: {error} ({sins.status_string(error.status)})")
    except (OSError, ValueError) as error:  # ValueError: unknown picture format
        sys.exit(f"fly.py: {error}")
    errors = last.navigation_errors
    print("errors at the end, navigation - truth, east-north-up")
    print("position m      ", *errors.position_enu_m)
    print("velocity m/s    ", *errors.velocity_enu_m_s)
    print("misalignment rad", *errors.misalignment_enu_rad)


if __name__ == "__main__":
    main()
