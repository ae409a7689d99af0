#!/usr/bin/env python3
"""Flies a scene and draws the errors of its navigation: fly.py c_examples/scenes/patrol.toml --hours 4 -o patrol.png

The flight is of manoeuvres or built-in, as in patrol.toml. It is flown by sins_run(), ten minutes in a call.
"""

import argparse
import ctypes
import sys

import numpy
import sins

CALL_S = 600.0


def open_scene(path, hours):
    """The scene of a file; hours replaces the duration that it states."""
    scene, fault, setup = sins.scene(), sins.fault(), sins.scene_setup()
    with open(path, "rb") as file:
        status = sins.scene_parse(file.read(), scene)
    if status == sins.SCENE_HAS_FAULTS:
        sins.scene_get_fault(scene, 0, fault)
        sys.exit(f"{path}:{fault.line}:{fault.column}: {fault.sentence.decode()}")
    sins.scene_get_setup(scene, setup)
    if hours is not None:
        setup.duration_s = hours * 3600
        sins.scene_set_setup(scene, setup)
        sins.scene_get_setup(scene, setup)
    failures = ctypes.c_size_t()
    sins.scene_get_failure_count(scene, failures)
    if setup.flight == sins.SCENE_FLIGHT_LOG or setup.has_temperature or failures.value:
        sys.exit(f"{path}: a log, a temperature or failures want sins.scene_prepare() before each sample: see harness.c")
    return scene, setup


def fly(scene, setup):
    """The records of the whole flight, in arrays of numpy."""
    count = int(setup.flown_s * setup.rate_hz + 1e-6) + 1  # 1e-6: rounding
    every = max(1, round((setup.every_s or setup.flown_s / 1000) * setup.rate_hz))
    times_s = numpy.minimum(numpy.arange(count) / setup.rate_hz, setup.flown_s)
    with sins.sim() as sim, sins.flight() as flight:
        sins.scene_create_simulator(scene, sim)
        sins.scene_create_flight(scene, flight)
        parts = numpy.array_split(times_s, int(setup.flown_s / CALL_S) + 1)
        records = [sins.fly(sim, sins.samples_at(flight, part), every) for part in parts]
        last = sins.record()
        sins.get_record(sim, last)
    return numpy.concatenate(records), last


def draw(records, title, path):
    """Both ways to the errors, side by side with one another: navigation less truth, and the error differential equations."""
    import matplotlib

    matplotlib.use("Agg")  # into a file, no window
    from matplotlib import pyplot

    rows = [("position_enu_m", 1e-3, "position [km]"), ("velocity_enu_m_s", 1, "velocity [m/s]"),
            ("misalignment_enu_rad", 1 / sins.ARCSEC, "misalignment [arcsec]")]
    hours = records["time_s"] / 3600
    has_model = not (records["model_errors"]["flags"] & sins.ERRORS_NOT_COMPUTED).any()
    figure, axes = pyplot.subplots(3, 1, figsize=(9, 9), sharex=True, constrained_layout=True)
    for axis, (field, scale, label) in zip(axes, rows):
        for k, name in enumerate(("east", "north", "up")):
            line, = axis.plot(hours, scale * records["navigation_errors"][field][:, k], linewidth=1, label=name)
            if has_model:
                axis.plot(hours, scale * records["model_errors"][field][:, k], color="black", linestyle=(k, (1, 5)), linewidth=1,
                          label="error equations" if k == 2 else None)
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    axes[0].legend(ncols=4, fontsize="small")
    axes[0].set_title(title)
    axes[-1].set_xlabel("time [h]")
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scene", help="a scene in TOML")
    parser.add_argument("--hours", type=float, help="how long to fly, in place of what the scene states")
    parser.add_argument("-o", "--output", help="the picture, .png or .svg")
    arguments = parser.parse_args()
    try:
        scene, setup = open_scene(arguments.scene, arguments.hours)
        records, last = fly(scene, setup)
        title = sins.text(sins.scene_get_text, scene, sins.SCENE_TEXT_TITLE)
    except (OSError, sins.Error) as error:
        sys.exit(f"fly.py: {error}")
    if arguments.output:
        draw(records, title, arguments.output)
    errors = last.navigation_errors
    for row in zip(errors.position_enu_m, errors.velocity_enu_m_s, errors.misalignment_enu_rad):
        print("%.17g %.17g %.17g" % row)


if __name__ == "__main__":
    main()
