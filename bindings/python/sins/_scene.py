"""What flies: a scene with its settings, and its samples."""

import difflib
import itertools
import operator
import os
import re
import warnings
from typing import Any, Callable, Iterator, Mapping, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from sins import c
from sins._calls import in_background
from sins._judge import Finding, LogWarning, findings, warn

Floats = npt.NDArray[np.float64]
Setting = Union[str, Mapping[str, Any]]

# The quantities of a trajectory: name, field of a sample, place in it, factor.
_QUANTITIES = [
    ("time_s", "time_s", 0, 1.0),
    *((f"{name}_{unit}", f"{name}_rad", 0, factor) for name in ("latitude", "longitude", "roll", "pitch", "heading")
      for unit, factor in (("rad", 1.0), ("deg", np.pi / 180))),
    ("height_m", "height_m", 0, 1.0),
    *((f"velocity_{axis}_m_s", "velocity_enu_m_s", place, 1.0) for place, axis in enumerate(("east", "north", "up"))),
    *((f"rate_{axis}_rad_s", "angular_rate_rad_s", place, 1.0) for place, axis in enumerate("xyz")),
    *((f"force_{axis}_m_s2", "specific_force_m_s2", place, 1.0) for place, axis in enumerate("xyz")),
    ("temperature_c", "temperature_c", 0, 1.0),
]
_FLAGS = {"angular_rate_rad_s": c.SAMPLE_ANGULAR_RATE, "specific_force_m_s2": c.SAMPLE_SPECIFIC_FORCE, "temperature_c": c.SAMPLE_TEMPERATURE}
_OPTIONAL = {"velocity_enu_m_s", *_FLAGS}


class Trajectory:
    """True motion as samples: `trajectory` makes it."""

    def __init__(self, samples: "npt.NDArray[Any]") -> None:
        self.samples = samples
        """Structured array of `sins.c.flight_sample`, shape (samples,)."""
        self.log = c.log_create(samples)

    @property
    def findings(self) -> "tuple[Finding, ...]":
        """What the judge finds in it, the worst first."""
        return findings(self.log)

    def __reduce__(self) -> "tuple[Any, ...]":
        return Trajectory, (self.samples,)

    def __len__(self) -> int:
        return len(self.samples)

    def __repr__(self) -> str:
        times = self.samples["time_s"]
        return f"<sins.Trajectory: {len(times)} samples, {times[0]:g} to {times[-1]:g} s>"


def numbers(name: str, values: Any) -> Floats:
    """An array of numbers, of a user's array that has nothing but numbers."""
    c.check_masks(name, values)
    try:
        if name == "time_s":
            values = _seconds(values)
        if np.asarray(values).dtype.kind in "cmM":
            raise TypeError("complex numbers, dates and times must be made real numbers first")
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name}: not numbers: {error}") from None


def _seconds(values: Any) -> Any:
    """Dates as seconds since the first, in UTC if they have a zone; lengths of time as seconds."""
    array = np.asarray(values)
    if array.dtype == object and hasattr(values, "dtype"):  # pandas: dates with a zone
        array = np.asarray(values, dtype="datetime64[ns]")
    if array.dtype.kind not in "mM" or array.ndim != 1 or not array.size:
        return values
    if np.isnat(array).any():
        raise TypeError(f"{np.isnat(array).sum()} times are missing (NaT)")
    since = array - array[0] if array.dtype.kind == "M" else array
    return since.astype("timedelta64[ns]").astype(np.float64) * 1e-9


def _is_in_radians(found: "Mapping[tuple[str, int], tuple[str, Any]]") -> bool:
    """Whether positions in degrees are those of the sea off Ghana, unless they are in radians."""
    ends = {"latitude": np.pi / 2, "longitude": np.pi}
    named = [found[f"{name}_rad", 0] for name in ends]
    if any(not name.endswith("_deg") for name, _ in named):
        return False
    largest = [np.max(np.abs(values), initial=0) * 180 / np.pi for _, values in named]
    return all(0.05 < value <= end for value, end in zip(largest, ends.values()))


def whole_number(name: str, value: Any, least: int, most: int) -> int:
    """A whole number within its limits."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} = {value!r}: must be a whole number") from None
    if not least <= number <= most:
        raise ValueError(f"{name} = {number}: must be from {least} to {most}")
    return number


def trajectory(data: Any = None, *, judge: str = "warn", **columns: Any) -> Trajectory:
    """Makes a trajectory of arrays: a pandas.DataFrame, a dict of arrays, a structured array, or keywords alone.

    The names are those of the columns of a flight log: time_s, latitude_rad or latitude_deg, longitude_rad or _deg, height_m (above the
    ellipsoid), roll, pitch and heading likewise; if there are any, velocity_east_m_s, velocity_north_m_s, velocity_up_m_s; rate_x_rad_s and
    so on (against inertial space), force_x_m_s2 and so on (specific force), both in sensor axes; temperature_c. A keyword says where a
    quantity comes from: the name of a column of `data` (latitude_deg="lat"), an array of shape (samples,), or a number for all samples.
    Quantities without a keyword are taken from the column of their own name. Without velocities the library derives them. Dates and lengths
    of time (datetime64, timedelta64) become seconds; those of the index of a DataFrame are taken if nothing else is time_s.

    judge: the samples are judged as the program judges a log. "warn": what is doubtful or unusable is a `LogWarning`; "strict": it is a
    ValueError; "off": nothing. `Trajectory.findings` has all that is found.

    Raises `sins.Error` with the number of the sample: times not in order, a value out of its range. Masked values are a ValueError.
    """
    if judge not in ("warn", "strict", "off"):
        raise ValueError(f"judge = {judge!r}: must be 'warn', 'strict' or 'off'")
    names = [name for name, _, _, _ in _QUANTITIES]
    for name in columns:
        if name not in names:
            raise TypeError(f"no such quantity: {name}; did you mean {difflib.get_close_matches(name, names, 1, 0)[0]}?")
    of_data = () if data is None else data.dtype.names or () if isinstance(data, np.ndarray) else data
    index = getattr(data, "index", None)
    if "time_s" not in columns and "time_s" not in of_data and getattr(getattr(index, "dtype", None), "kind", None) in ("m", "M"):
        columns = {**columns, "time_s": index}
    named = {(field, place) for name, field, place, _ in _QUANTITIES if name in columns}
    found: "dict[tuple[str, int], tuple[str, Any]]" = {}
    for name, field, place, factor in _QUANTITIES:
        if name not in columns and (name not in of_data or (field, place) in named):
            continue
        if (field, place) in found:
            raise TypeError(f"{found[field, place][0]} and {name}: give one of them")
        source = columns.get(name, name)
        if isinstance(source, str):
            if source not in of_data:
                raise KeyError(f"{name}: the data has no column {source!r}")
            source = data[source]
        found[field, place] = name, numbers(name, source) * factor
    fields = {field for field, _ in found}
    for _, field, place, _ in _QUANTITIES:
        if (field, place) not in found and (field in fields or field not in _OPTIONAL):
            lacking = " or ".join(name for name, *other, _ in _QUANTITIES if other == [field, place])
            raise TypeError(f"no {lacking}: name its column by a keyword")
    shape = found["time_s", 0][1].shape
    if len(shape) != 1:
        raise ValueError(f"time_s has the shape {shape}: expected (samples,)")
    samples: "npt.NDArray[Any]" = c.array(c.flight_sample, shape[0])
    for (field, place), (name, values) in found.items():
        to = samples[field] if samples[field].ndim == 1 else samples[field][:, place]
        if values.shape not in (shape, ()):
            raise ValueError(f"{name} has the shape {values.shape}: expected {shape}, as time_s")
        to[...] = values
    samples["flags"] = sum(_FLAGS.get(field, 0) for field in fields) + (0 if "velocity_enu_m_s" in fields else c.SAMPLE_NO_VELOCITY)
    made = Trajectory(samples)
    if judge == "off":
        return made
    if _is_in_radians(found):
        what = "latitude_deg and longitude_deg are those of the sea off Ghana, or radians; radians are latitude_rad and longitude_rad"
        warnings.warn(what, LogWarning, 2)
    doubts = [finding for finding in made.findings if finding.level != "note"]
    if judge == "strict" and doubts:
        raise ValueError("; ".join(map(str, doubts)))
    warn(doubts)
    return made


Flown = Union[str, "os.PathLike[str]", Trajectory]


def _value(name: str, value: Any) -> str:
    """A value as a scene has it."""
    c.check_masks(name, value)
    if hasattr(value, "tolist"):  # of numpy or pandas
        value = value.tolist()
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, Sequence):
        if value and all(isinstance(row, Sequence) and not isinstance(row, str) for row in value):
            value = [one for row in value for one in row]  # a matrix, row by row
        return f"[{', '.join(_value(name, one) for one in value)}]"
    return repr(value)


def _lines(paths: Mapping[str, Any], settings: Mapping[str, Setting]) -> str:
    """Keys with their sections, and sections of keys, as the lines of a change of a scene."""
    lines = {path: _value(path, value) for path, value in paths.items() if value is not None}
    for section, values in settings.items():
        section = {"accel": "accelerometer"}.get(section, section)
        if isinstance(values, str):
            values = {"preset": values}
        if not isinstance(values, Mapping):
            raise TypeError(f"{section} = {values!r}: expected a dict of keys, or the name of a preset")
        if not values and section.encode() not in (key.section for key in _all(c.scene_get_key)):
            values = {"preset": ""}  # the library says that there is no such section
        for key, value in values.items():
            path = f"{section}.{key}"
            if path in lines:
                raise TypeError(f"{path} is given twice")
            lines[path] = _value(path, value)
    return "\n".join(f"{path} = {value}" for path, value in lines.items())


def _of_title(text: str, title: str) -> "set[str]":
    """The lines of a scene of which its title may speak; of options, output, rate and hours, those whose value it has."""
    section, lines = "", set()
    for line in text.split("\n"):
        section = line if line.startswith("[") else section
        is_loose = section in ("[options]", "[output]") or line.startswith(("rate_hz = ", "hours = "))
        value = line.partition(" = ")[2].partition("  #")[0].strip('"')
        if not is_loose or (value and re.search(rf"(?<![\w.]){re.escape(value)}(?![\w.])", title)):
            lines.add(line)
    return lines


def _all(read: Callable[[int], Any]) -> "Iterator[Any]":
    """What the library lists by index."""
    try:
        for index in itertools.count():
            yield read(index)
    except c.Error:
        return


def _beside(log: str, name: str) -> str:
    """The file `name` beside a log: a plain file in its folder, or in that to which a link to the log leads. A scene may be another's."""
    place = os.path.join(os.path.dirname(log), name)
    folders = (os.path.realpath(os.path.dirname(log)), os.path.dirname(os.path.realpath(log)))
    if os.path.dirname(os.path.realpath(place)) not in folders:
        raise ValueError(f"{place}: is a link to another folder: expected a file beside the log")
    if os.path.exists(place) and not os.path.isfile(place):
        raise ValueError(f"{place}: is no plain file: expected one beside the log")
    return place


class Scene:
    """A scene with its settings and its log, ready to be flown; not for users, who give its parts to the functions of the package."""

    def __init__(
        self, flown: Flown, hours: Optional[float], settings: Mapping[str, Setting], every_s: Optional[float] = None
    ) -> None:
        self.samples: "Optional[npt.NDArray[Any]]" = None
        """All samples of a trajectory."""
        self.log: Any = None
        folder = own = ""
        if isinstance(flown, Trajectory):
            self.handle = c.scene_create()
            c.scene_set_text(self.handle, c.SCENE_TEXT_LOG, "trajectory")
            self.samples, self.log = flown.samples, flown.log
        else:
            name = os.fspath(flown)
            folder = os.path.dirname(name)
            own = os.path.basename(name)
            if "\n" in name:
                folder = own = ""
                self.handle = c.scene_parse(name)
            elif name.endswith(".toml"):
                with open(name, "rb") as file:
                    self.handle = c.scene_parse(file.read())
            elif name.lower().endswith((".csv", ".igc", ".gpx", ".fdr")):
                self.handle = c.scene_create()
                c.scene_set_text(self.handle, c.SCENE_TEXT_LOG, os.path.basename(name))
            else:
                try:
                    self.handle = c.scene_create_builtin(name)
                except c.Error as error:
                    error.args = (f"{name!r}: must be a built-in scene ({', '.join(_all(c.scene_builtin_name))}), or a file .toml, .csv, .igc, .gpx or .fdr",)
                    raise
        title = c.scene_get_text(self.handle, c.SCENE_TEXT_TITLE)
        titled = _of_title(c.scene_write(self.handle), title)
        lines = _lines({"flight.hours": hours, "output.every_s": every_s}, settings)
        try:
            c.scene_set_values(self.handle, lines)
        except c.Error as error:
            error.args = (re.sub("^line .*?, column .*?: ", "", str(error)),)  # those of keywords mean nothing
            raise
        self.setup = c.scene_get_setup(self.handle)
        self.text: str = c.scene_write(self.handle)
        if self.log is None and self.setup.flight == c.SCENE_FLIGHT_LOG:
            path = os.path.join(folder, c.scene_get_text(self.handle, c.SCENE_TEXT_LOG))
            with open(path, "rb") as file:
                text = file.read()
            for name in _all(lambda index: c.scene_log_file_name(self.handle, index)):
                with open(_beside(path, name), "rb") as file:
                    c.scene_give_log_file(self.handle, name, file.read())
            self.log = in_background(lambda: c.log_parse(text, self.handle)[0])
            warn(finding for finding in findings(self.log, c.scene_get_options(self.handle)) if finding.level != "note")
        self.info = c.scene_get_samples(self.handle, self.log)
        """Number of samples, their period and duration."""
        is_true = titled <= _of_title(self.text, title)  # or it may speak of what the settings have replaced
        own_title, log, builtin = (c.scene_get_text(self.handle, text) for text in (c.SCENE_TEXT_TITLE, c.SCENE_TEXT_LOG, c.SCENE_TEXT_BUILTIN))
        self.title: str = (own_title if is_true or own_title != title else "") or log or builtin or own
        self._flight: Any = None

    def plans(self, *items: str) -> bool:
        """Whether the scene has one of these items, such as [[update]]."""
        return any(f"\n{item}\n" in self.text for item in items)

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
