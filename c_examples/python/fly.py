#!/usr/bin/env python3
"""Flies a scene and draws the errors of its navigation: fly.py c_examples/scenes/patrol.toml -o patrol.png

The flight is built-in, made of manoeuvres, or a log. sins_play_run() flies it with all that the scene plans:
temperature, failures, updates, the unit and its panel.
"""

import argparse
import os
import sys

import matplotlib
from sins import c as sins
from matplotlib import pyplot

matplotlib.use("Agg")  # draws into a file, without a window


def open_scene(name, hours):
    """The scene of a file, or a built-in one, and its log or None. `hours` replaces its duration."""
    if name.endswith(".toml"):
        with open(name, "rb") as file:
            scene = sins.scene_parse(file.read())
    else:
        scene = sins.scene_create_builtin(name)
    if hours is not None:
        sins.scene_set_values(scene, f"flight.hours = {hours}")
    if sins.scene_get_setup(scene).flight != sins.SCENE_FLIGHT_LOG:
        return scene, None
    log = os.path.join(os.path.dirname(name), sins.scene_get_text(scene, sins.SCENE_TEXT_LOG))
    with open(log, "rb") as file:
        return scene, sins.log_parse(file.read(), scene)[0]


def fly(scene, log):
    """Flies the whole flight and returns the records as a numpy array."""
    samples = sins.scene_get_samples(scene, log)
    records = sins.array(sins.record, samples.count // samples.record_every + 2)
    with sins.play_create(scene, log) as play:
        return records[: sins.play_run(play, records)]


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
        scene, log = open_scene(arguments.scene, arguments.hours)
        records = fly(scene, log)
        title = sins.scene_get_text(scene, sins.SCENE_TEXT_TITLE) or arguments.scene
        if arguments.output:
            draw(records, title, arguments.output)
    except sins.Error as error:
        sys.exit(f"fly.py: {error} ({sins.status_string(error.status)})")
    except (OSError, ValueError) as error:  # ValueError: unknown picture format
        sys.exit(f"fly.py: {error}")
    errors = records["navigation_errors"][-1]
    print("errors at the end, navigation - truth, east-north-up")
    print("position m      ", *errors["position_enu_m"].tolist())
    print("velocity m/s    ", *errors["velocity_enu_m_s"].tolist())
    print("misalignment rad", *errors["misalignment_enu_rad"].tolist())


if __name__ == "__main__":
    main()
