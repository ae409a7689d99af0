"""The errors of real sensors, from a record of their increments and the true path of the same motion."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy as np
import numpy.typing as npt

from sins import c
from sins._calls import INTERVALS, Progress, in_background
from sins._scene import Floats, Flown, Scene, Setting, numbers

if TYPE_CHECKING:
    import matplotlib.figure

_GRADES = ("strategic", "navigation", "tactical", "industrial", "consumer")
# Names of a record, with the name of the same integrated over the interval.
_SIGNALS = (("rate_rad_s", "angle_rad"), ("force_m_s2", "velocity_m_s"))


@dataclass(frozen=True)
class Parameter:
    """A parameter of real sensors; `Identified.parameters` has all."""

    name: str
    """Such as "gyro bias x"; "misalignment xy" is the error of sensor x by a signal along y."""
    value: float
    """Mean [unit]."""
    interval: "Tuple[float, float]"
    """Interval of 95 % [unit]."""
    unit: str
    """SI unit, such as "rad/s"; "1" for a ratio."""
    sigma: float
    """Standard deviation [unit]; 0 of noise, whose distribution is not normal."""
    prior: float
    """Standard deviation before the record [unit]; 0 of noise."""
    is_seen: bool
    """Whether the record shows it: it narrows the prior to less than a half."""
    reason: str
    """If not, why, and what motion would show it."""

    def __str__(self) -> str:
        low, high = self.interval
        return f"{self.name}: {self.value:.4g} ({low:.4g} to {high:.4g}) {self.unit}" if self.is_seen else f"{self.name}: {self.reason}"


@dataclass(frozen=True)
class Identified:
    """What a record shows of its sensors: `identify` makes it."""

    parameters: "Tuple[Parameter, ...]"
    """Clock, mounting, then bias, scale factors, misalignments and noise of the gyros and of the accelerometers."""
    rotation: Floats
    """Signals of the record are this matrix times the signals of the vehicle, shape (3, 3)."""
    boresight_rad: Floats
    """Attitude of the sensor block in the vehicle: roll, pitch, heading, shape (3,) [rad]."""
    axes_are_seen: bool
    """Whether the motion excludes all other axes."""
    used_s: float
    """Time of the record that was compared with the path [s]."""
    text: str
    """The scene that `scene` returns."""

    def __getitem__(self, name: str) -> Parameter:
        """A parameter by its name."""
        for one in self.parameters:
            if one.name == name:
                return one
        raise KeyError(f"{name!r}: the parameters are {', '.join(one.name for one in self.parameters)}")

    def __str__(self) -> str:
        return "\n".join(map(str, self.parameters))

    def scene(self) -> str:
        """The text of a scene whose sensors have what was found; its vehicle is at rest: give a log or other settings to `fly`."""
        return self.text

    def plot(self) -> "matplotlib.figure.Figure":
        """A figure of matplotlib: each parameter with its 95 % interval, in standard deviations of its prior; grey, the 95 % interval of the
        prior; hollow, what the record does not show. Noise has no prior, and the shift of the clock none about 0: they are not drawn."""
        from matplotlib.figure import Figure

        drawn = [one for one in self.parameters if one.prior > 0 and one.name != "clock shift"]
        panels = [[one for one in drawn if one.name.split()[0] == sensor] for sensor in ("gyro", "accelerometer")]
        panels.insert(0, [one for one in drawn if not any(one in panel for panel in panels)])
        figure = Figure(figsize=(9, 0.3 * len(drawn) + 1.5), layout="constrained")
        axes = figure.subplots(len(panels), 1, sharex=True, squeeze=False, gridspec_kw={"height_ratios": [len(panel) for panel in panels]})[:, 0]
        for axis, panel in zip(axes, panels):
            axis.axvspan(-1.96, 1.96, color="0.9")
            for place, one in enumerate(panel):
                ends = [end / one.prior for end in one.interval]
                axis.plot(ends, [place, place], color="C0", linewidth=2, alpha=1.0 if one.is_seen else 0.4)
                axis.plot([one.value / one.prior], [place], "o", color="C0", fillstyle="full" if one.is_seen else "none")
            axis.set_yticks(range(len(panel)), [one.name for one in panel])
            axis.invert_yaxis()
            axis.grid(alpha=0.3)
        # What is seen is far narrower than its prior.
        axes[-1].set_xscale("symlog", linthresh=1e-3)
        axes[-1].set_xlabel("standard deviations of the prior")
        return figure


def _increments(imu: Any) -> "npt.NDArray[Any]":
    """The record as the library takes it."""
    if getattr(getattr(imu, "dtype", None), "names", None) and "measured_angle_rad" in imu.dtype.names:
        imu = {"time_s": imu["time_s"], "interval_s": imu["interval_s"], "angle_rad": imu["measured_angle_rad"],
               "velocity_m_s": imu["measured_velocity_m_s"]}
    elif getattr(getattr(imu, "dtype", None), "names", None):
        imu = {name: imu[name] for name in imu.dtype.names}
    if "time_s" not in imu:
        raise TypeError("no time_s in the record")
    time_s = numbers("time_s", imu["time_s"])
    if time_s.ndim != 1 or len(time_s) < 2:
        raise ValueError(f"time_s has the shape {time_s.shape}: expected (rows,), two or more")
    made: "npt.NDArray[Any]" = c.array(c.recorded_increment, len(time_s))
    made["time_s"] = time_s
    interval_s = numbers("interval_s", imu["interval_s"] if "interval_s" in imu else np.median(np.diff(time_s)))
    if interval_s.shape not in ((), time_s.shape):
        raise ValueError(f"interval_s has the shape {interval_s.shape}: expected {time_s.shape}, as time_s, or a number")
    made["interval_s"] = interval_s
    for signal, integral in _SIGNALS:
        given = [name for name in (signal, integral) if name in imu]
        if len(given) != 1:
            raise TypeError(f"give one of {signal} and {integral}, of the shape (rows, 3)")
        values = numbers(given[0], imu[given[0]])
        if values.shape != (len(time_s), 3):
            raise ValueError(f"{given[0]} has the shape {values.shape}: expected {(len(time_s), 3)}")
        made[integral] = values if given[0] == integral else values * made["interval_s"][:, np.newaxis]
    return made


def _axes(text: str) -> "list[int]":
    """The numbers of axes such as "y x -z"."""
    words = text.replace(",", " ").split()
    if sorted(word.lstrip("+-") for word in words) != ["x", "y", "z"]:
        raise ValueError(f"axes = {text!r}: must be x, y and z once each with or without '-', as 'y x -z'")
    return [("xyz".index(word[-1]) + 1) * (-1 if word.startswith("-") else 1) for word in words]


def _parameter(one: Any) -> Parameter:
    name, unit, reason = (bytes(getattr(one, field)).split(b"\0")[0].decode() for field in ("name", "unit", "reason"))
    return Parameter(name, one.value, (one.low, one.high), unit, one.sigma, one.prior, bool(one.flags & c.IDENTIFIED_SEEN), reason)


def identify(
    flown: Flown, imu: Any, hours: Optional[float] = None, *, prior: str = "consumer", axes: Optional[str] = None,
    shift_s: Optional[float] = None, progress: bool = False, **settings: Setting,
) -> Identified:
    """Finds the errors of real sensors: compares their record with what perfect sensors measure along the true path.

    flown, hours and settings are those of the path, as in `fly`; of the settings, the Earth, gravity and axes count. imu is the record:
    the increments of `Flight.fly`, or a dict of arrays: time_s, the end of each interval on the clock of the record, shape (rows,) [s];
    rate_rad_s (against inertial space) or its integral angle_rad, shape (rows, 3) [rad/s], [rad]; force_m_s2 (specific force) or its
    integral velocity_m_s, shape (rows, 3) [m/s2], [m/s]; interval_s, a number or of shape (rows,), without it the median of the times [s].
    Clock and axes of the record need not be those of the path: they are found.

    prior: what is known of the sensors, strategic, navigation, tactical, industrial or consumer, the widest. axes: the axes of the vehicle
    along x, y and z of the record, if they are known, such as "y x -z". shift_s: time of the path less time of the record, if it is known to 10 s.
    progress: a line on standard error shows the time that has passed. docs/identify.md says what a record can show.

    Raises `sins.Error`, with the reason, for a record of another motion, in other units, too short, or with a sensor that is stuck.
    """
    if prior not in _GRADES:
        raise ValueError(f"prior = {prior!r}: must be {', '.join(_GRADES[:-1])} or {_GRADES[-1]}")
    request = c.identify_request(prior=getattr(c, f"GRADE_{prior.upper()}"))
    if axes is not None:
        request.axes = tuple(_axes(axes))
    if shift_s is not None:
        request.flags, request.shift_s = c.IDENTIFY_SHIFT, float(shift_s)
    increments = _increments(imu)
    scene = Scene(flown, hours, settings)
    handle = c.identify_create(c.scene_get_options(scene.handle), request)

    def solve() -> Any:
        for begin in range(0, scene.info.count, INTERVALS):
            c.identify_push_samples(handle, scene.piece(begin, min(begin + INTERVALS, scene.info.count)))
        c.identify_push_increments(handle, increments)
        return c.identify_solve(handle)

    found = in_background(solve, progress=Progress("identifying") if progress else None)
    parameters = tuple(_parameter(c.identify_get_parameter(handle, index)) for index in range(c.IDENTIFIED_PARAMETERS))
    return Identified(parameters, np.array(found.rotation).reshape(3, 3), np.array(found.boresight_rad),
                      bool(found.flags & c.IDENTIFIED_SEEN), found.used_s, c.identify_get_scene(handle))
