"""What flies: a scene with its settings, and its samples."""

import difflib
import os
import re
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from sins import c

Floats = npt.NDArray[np.float64]
Setting = Union[str, Mapping[str, Any]]

_DEGREES = np.pi / 180

# Quantities of a trajectory: the field of a sample, and the place in it.
_SINGLE = {
    "time_s": "time_s",
    "latitude_rad": "latitude_rad",
    "longitude_rad": "longitude_rad",
    "height_m": "height_m",
    "roll_rad": "roll_rad",
    "pitch_rad": "pitch_rad",
    "heading_rad": "heading_rad",
}
_TRIPLES = {
    ("velocity_east_m_s", "velocity_north_m_s", "velocity_up_m_s"): "velocity_enu_m_s",
    ("rate_x_rad_s", "rate_y_rad_s", "rate_z_rad_s"): "angular_rate_rad_s",
    ("force_x_m_s2", "force_y_m_s2", "force_z_m_s2"): "specific_force_m_s2",
}
_ANGLES = [name for name in _SINGLE if name.endswith("_rad")]
_COLUMNS = [
    *_SINGLE, *(name[:-3] + "deg" for name in _ANGLES), *(name for names in _TRIPLES for name in names), "temperature_c"
]


class Trajectory:
    """True motion as samples: `trajectory` makes it."""

    def __init__(self, samples: "npt.NDArray[Any]") -> None:
        self.samples = samples
        """Structured array of `sins.c.flight_sample`, shape (samples,)."""
        self.log = c.log_create(samples)

    def __len__(self) -> int:
        return len(self.samples)

    def __repr__(self) -> str:
        times = self.samples["time_s"]
        return f"<sins.Trajectory: {len(times)} samples, {times[0]:g} to {times[-1]:g} s>"


def trajectory(data: Any = None, **columns: Any) -> Trajectory:
    """Makes a trajectory of arrays: a pandas.DataFrame, a dict of arrays, a structured array, or keywords alone.

    The names are those of the columns of a flight log: time_s, latitude_rad or latitude_deg, longitude_rad or _deg, height_m (above the
    ellipsoid), roll, pitch and heading likewise; if there are any, velocity_east_m_s, velocity_north_m_s, velocity_up_m_s; rate_x_rad_s and
    so on (against inertial space), force_x_m_s2 and so on (specific force), both in sensor axes; temperature_c. A keyword says where a
    quantity comes from: the name of a column of `data` (latitude_deg="lat"), an array of shape (samples,), or a number for all samples.
    Quantities without a keyword are taken from the column of their own name. Without velocities the library derives them.

    Raises `sins.Error` with the number of the sample: times not in order, a value out of its range.
    """
    for name in columns:
        if name not in _COLUMNS:
            close = difflib.get_close_matches(name, _COLUMNS, 1, 0)
            raise TypeError(f"no such quantity: {name}; did you mean {close[0]}?")

    def has(name: str) -> bool:
        return data is not None and name in (data.dtype.names or () if isinstance(data, np.ndarray) else data)

    def find(name: str) -> Optional[Any]:
        source = columns.get(name, name if has(name) else None)
        if isinstance(source, str):
            if not has(source):
                raise KeyError(f"{name}: the data has no column {source!r}")
            source = data[source]
        if source is None:
            return None
        try:
            return np.asarray(source, dtype=np.float64)
        except (TypeError, ValueError):
            raise TypeError(f"{name}: not numbers") from None

    def angle(name: str) -> Optional[Any]:
        degrees = find(name[:-3] + "deg")
        radians = find(name)
        if degrees is not None and radians is not None and name not in columns and name[:-3] + "deg" not in columns:
            raise TypeError(f"{name} and {name[:-3]}deg: give one of them")
        if name in columns or degrees is None:
            return radians
        return degrees * _DEGREES

    found = {name: angle(name) if name in _ANGLES else find(name) for name in _SINGLE}
    for name, values in found.items():
        if values is None:
            degrees = f" or {name[:-3]}deg" if name in _ANGLES else ""
            raise TypeError(f"no {name}{degrees}: name its column by a keyword")
    times: Any = found["time_s"]
    if times.ndim != 1:
        raise ValueError(f"time_s has the shape {times.shape}: expected (samples,)")
    samples: "npt.NDArray[Any]" = c.array(c.flight_sample, len(times))
    flags = np.zeros(len(times), dtype=np.uint32)

    def put(name: str, field: Any, values: Any) -> None:
        try:
            field[...] = values
        except ValueError:
            raise ValueError(f"{name} has the shape {values.shape}: expected {times.shape}, as time_s") from None

    for name, values in found.items():
        put(name, samples[name], values)
    given = {}
    for names, field in _TRIPLES.items():
        parts = [find(name) for name in names]
        lacking = [name for name, part in zip(names, parts) if part is None]
        if lacking and len(lacking) < 3:
            raise TypeError(f"no {', '.join(lacking)}: all three of {', '.join(names)}, or none")
        given[field] = not lacking
        for axis, (name, part) in enumerate(zip(names, parts)):
            if not lacking:
                put(name, samples[field][:, axis], part)
    temperature = find("temperature_c")
    if temperature is not None:
        put("temperature_c", samples["temperature_c"], temperature)
    for is_on, flag in (
        (not given["velocity_enu_m_s"], c.SAMPLE_NO_VELOCITY),
        (given["angular_rate_rad_s"], c.SAMPLE_ANGULAR_RATE),
        (given["specific_force_m_s2"], c.SAMPLE_SPECIFIC_FORCE),
        (temperature is not None, c.SAMPLE_TEMPERATURE),
    ):
        flags |= np.uint32(flag if is_on else 0)
    samples["flags"] = flags
    return Trajectory(samples)


Flown = Union[str, "os.PathLike[str]", Trajectory]


def _value(value: Any) -> str:
    """A value as a scene has it."""
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, (Sequence, np.ndarray)):
        return f"[{', '.join(_value(one) for one in value)}]"
    return repr(value.item() if isinstance(value, np.generic) else value)


def _lines(hours: Optional[float], settings: Mapping[str, Setting]) -> str:
    """Settings as the lines of a change of a scene."""
    lines = [] if hours is None else [f"flight.hours = {_value(hours)}"]
    for section, values in settings.items():
        section = {"accel": "accelerometer"}.get(section, section)
        if isinstance(values, str):
            values = {"preset": values}
        if not isinstance(values, Mapping):
            raise TypeError(f"{section} = {values!r}: expected a dict of keys, or the name of a preset")
        lines += [f"{section}.{key} = {_value(value)}" for key, value in values.items()]
    return "\n".join(lines)


class Scene:
    """A scene with its settings and its log, ready to be flown; not for users, who give its parts to the functions of the package."""

    def __init__(self, flown: Flown, hours: Optional[float], settings: Mapping[str, Setting]) -> None:
        self.samples: "Optional[npt.NDArray[Any]]" = None
        """All samples of a trajectory."""
        self.log: Any = None
        folder = ""
        if isinstance(flown, Trajectory):
            self.handle = c.scene_create()
            c.scene_set_text(self.handle, c.SCENE_TEXT_LOG, "trajectory")
            self.samples, self.log = flown.samples, flown.log
        else:
            name = os.fspath(flown)
            folder = os.path.dirname(name)
            if "\n" in name:
                folder = ""
                self.handle = c.scene_parse(name)
            elif name.endswith(".toml"):
                with open(name, "rb") as file:
                    self.handle = c.scene_parse(file.read())
            elif name.endswith(".csv"):
                self.handle = c.scene_create()
                c.scene_set_text(self.handle, c.SCENE_TEXT_LOG, os.path.basename(name))
            else:
                self.handle = c.scene_create_builtin(name)
        lines = _lines(hours, settings)
        try:
            c.scene_set_values(self.handle, lines)
        except c.Error as error:
            error.args = (re.sub("^line .*?, column .*?: ", "", str(error)),)  # those of keywords mean nothing
            raise
        self.setup = c.scene_get_setup(self.handle)
        if self.log is None and self.setup.flight == c.SCENE_FLIGHT_LOG:
            with open(os.path.join(folder, c.scene_get_text(self.handle, c.SCENE_TEXT_LOG)), "rb") as file:
                self.log = c.log_parse(file.read())[0]
        self.info = c.scene_get_samples(self.handle, self.log)
        """Number of samples, their period and duration."""
        self.title: str = c.scene_get_text(self.handle, c.SCENE_TEXT_TITLE) or c.scene_get_text(self.handle, c.SCENE_TEXT_LOG)
        self._flight: Any = None

    def has(self, path: str) -> bool:
        """Whether the scene has the item or the value, such as update[0]."""
        try:
            return bool(c.scene_get_value(self.handle, path))
        except c.Error:
            return False

    @property
    def has_unit(self) -> bool:
        try:
            c.scene_create_unit(self.handle).close()
        except c.Error as error:
            if error.status != c.ERROR_BAD_STATE:
                raise
            return False
        return True

    @property
    def has_plan(self) -> bool:
        """Whether it plans anything in flight, the unit's panel aside."""
        return bool(self.setup.has_temperature or self.has("failure[0]") or self.has("update[0]"))

    def piece(self, begin: int, end: int) -> "npt.NDArray[Any]":
        """Samples begin to end of the flight."""
        if self.samples is not None:
            return self.samples[begin:end]
        if self.log is not None:
            samples: "npt.NDArray[Any]" = c.array(c.flight_sample, end - begin)
            each = (c.flight_sample * len(samples)).from_buffer(samples)
            for index, sample in enumerate(each, begin):
                c.log_get_sample(self.log, index, sample, None)
            return samples
        if self._flight is None:
            self._flight = c.scene_create_flight(self.handle)
        sampled: "npt.NDArray[Any]" = c.samples_at(self._flight, np.arange(begin, end) / self.setup.rate_hz)
        return sampled
