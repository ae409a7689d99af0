"""Strapdown inertial navigation: flights, errors and ensembles of an INS, from numpy arrays.

    import sins

    run = sins.fly("patrol", hours=2, gyro="tactical", accel={"bias_micro_g": 50})
    run.position_error_m[-1]                    # navigation less truth at the end: east, north, up [m]
    run.plot().savefig("patrol.png")

    truth = sins.trajectory(frame, time_s="t", latitude_deg="lat", longitude_deg="lon", height_m="alt",
                            roll_deg="roll", pitch_deg="pitch", heading_deg="yaw")      # of a pandas.DataFrame
    drawn = sins.ensemble(truth, runs=1000, gyro="navigation", accel="navigation")
    drawn.figures().cep50_m                     # with its interval

What flies is a built-in scene by its name, a file (scene.toml, log.csv, flight.igc), the text of a scene, or a `Trajectory`. Settings are sections of
a scene with its keys, in the units of data sheets; `sins keys` of the program lists them. Errors are `sins.Error`, with the sentence of
the library. Arrays are of numpy, in SI units and radians, unless a name ends in another unit.

Frames. Vectors of position, velocity and misalignment are along east, north, up. Roll is positive right wing down, pitch nose up, heading
clockwise from true north, rotated in the order heading, pitch, roll. Latitude is geodetic, height is above the ellipsoid.
Signals of the sensors are along the sensor block: right, forward, up, unless a scene sets `options.axes` or a boresight.
Errors are computed less true.

`sins.c` is the interface in C, name by name. This module imports numpy and the library with the first use of what it has.
"""

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sins import c as c
    from sins._analysis import Budget as Budget, Recommendation as Recommendation
    from sins._analysis import budget as budget, recommend as recommend
    from sins._ensemble import Ensemble as Ensemble, Figures as Figures, ensemble as ensemble
    from sins._flight import Flight as Flight, Run as Run, fly as fly
    from sins._identify import Check as Check, Identified as Identified, Parameter as Parameter, Span as Span, identify as identify
    from sins._judge import Finding as Finding, LogWarning as LogWarning
    from sins._scene import Trajectory as Trajectory, trajectory as trajectory

    Error = c.Error
    __version__: str

_HOME = {
    "_analysis": ("Budget", "Recommendation", "budget", "recommend"),
    "_ensemble": ("Ensemble", "Figures", "ensemble"),
    "_flight": ("Flight", "Run", "fly"),
    "_identify": ("Check", "Identified", "Parameter", "Span", "identify"),
    "_judge": ("Finding", "LogWarning"),
    "_scene": ("Trajectory", "trajectory"),
    "c": ("Error",),
}
__all__ = sorted(["c", *(name for names in _HOME.values() for name in names)])


def __getattr__(name: str) -> Any:
    if name == "c":
        return importlib.import_module("sins.c")
    if name == "__version__":
        return importlib.import_module("sins.c").version_string()
    for module, names in _HOME.items():
        if name in names:
            return getattr(importlib.import_module(f"sins.{module}"), name)
    raise AttributeError(f"module 'sins' has no attribute {name!r}; the names of the header are in sins.c")


def __dir__() -> "list[str]":
    return [*__all__, "__version__"]
