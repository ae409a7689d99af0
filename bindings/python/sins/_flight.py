"""A flight: as a whole, or in stretches with the increments of the sensors and corrections."""

import difflib
import threading
import warnings
from typing import TYPE_CHECKING, Any, Iterator, Optional, Tuple

import numpy as np
import numpy.typing as npt

from sins import c
from sins._calls import INTERVALS, in_background
from sins._scene import Floats, Flown, Scene, Setting, numbers

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas

_ENU = ("east", "north", "up")


def _columns(part: "npt.NDArray[Any]", begin: str) -> "Iterator[Tuple[str, Floats]]":
    """The numbers of a part of a record, named as in the files of the program."""
    for name in part.dtype.names or ():
        values = part[name]
        if values.dtype != np.float64 or name == "quaternion_nb":
            continue
        if values.ndim == 1:
            if begin.endswith("error_") and not name.startswith("misalignment"):
                continue  # the same errors in other coordinates
            yield begin + name, values
        else:
            stem, unit = name.split("_enu_")
            for axis, of_axis in zip(_ENU, values.T):
                yield f"{begin}{stem}_{axis}_{unit}", of_axis


def plot_errors(
    hours: Floats, panels: "list[Tuple[Floats, str]]", title: str, over: "Optional[list[Floats]]" = None
) -> "matplotlib.figure.Figure":
    """Panels of curves east, north, up over time; over: curves that are dotted."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3 * len(panels)), layout="constrained")
    axes = figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
    for index, (axis, (values, label)) in enumerate(zip(axes, panels)):
        axis.plot(hours, values, linewidth=1.5, label=_ENU[: values.shape[1]])
        if over:
            axis.set_prop_cycle(None)
            axis.plot(hours, over[index], ":", linewidth=1)
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    axes[0].legend(ncol=3, fontsize="small")
    axes[0].set_title(title)
    axes[-1].set_xlabel("time [h]")
    return figure


class Run:
    """A flight that was flown: `fly` makes it. Errors are computed less true; axes are east, north, up."""

    def __init__(self, records: "npt.NDArray[Any]", title: str) -> None:
        self.records = records
        """Structured array of `sins.c.record`, shape (records,): truth, navigation, navigation_errors, model_errors."""
        self.title = title

    def __len__(self) -> int:
        return len(self.records)

    def __repr__(self) -> str:
        errors = self.position_error_m[-1]
        return f"<sins.Run {self.title!r}: {self.time_s[-1] - self.time_s[0]:g} s, {np.hypot(errors[0], errors[1]):.6g} m off at the end>"

    @property
    def time_s(self) -> Floats:
        """Times of the records, shape (records,) [s]."""
        return np.asarray(self.records["time_s"])

    @property
    def position_error_m(self) -> Floats:
        """Error of the navigated position, shape (records, 3) [m]."""
        return np.asarray(self.records["navigation_errors"]["position_enu_m"])

    @property
    def velocity_error_m_s(self) -> Floats:
        """Error of the navigated velocity, shape (records, 3) [m/s]."""
        return np.asarray(self.records["navigation_errors"]["velocity_enu_m_s"])

    @property
    def misalignment_rad(self) -> Floats:
        """Misalignment about east, north, up, shape (records, 3) [rad]."""
        return np.asarray(self.records["navigation_errors"]["misalignment_enu_rad"])

    @property
    def has_model(self) -> bool:
        """Whether the error differential equations were integrated: options={"error_model": "rk4"}."""
        return not bool((self.records["model_errors"]["flags"] & c.ERRORS_NOT_COMPUTED).any())

    def dataframe(self) -> "pandas.DataFrame":
        """A pandas.DataFrame with a row for each record; names, units and numbers are those of the program's files."""
        import pandas

        columns = {"time_s": self.time_s}
        parts = {"truth": "truth_", "navigation": "navigation_", "navigation_errors": "navigation_error_"}
        if self.has_model:
            parts["model_errors"] = "model_error_"
        for part, begin in parts.items():
            columns.update(_columns(self.records[part], begin))
        return pandas.DataFrame(columns)

    def plot(self) -> "matplotlib.figure.Figure":
        """A figure of matplotlib: errors of position, velocity and attitude; dotted, the error equations if they were integrated."""
        model = self.records["model_errors"]
        fields = (("position_enu_m", 1.0, "position [m]"), ("velocity_enu_m_s", 1.0, "velocity [m/s]"),
                  ("misalignment_enu_rad", c.ARCSEC, "misalignment [arcsec]"))
        errors = self.records["navigation_errors"]
        panels = [(np.asarray(errors[field] / unit), label) for field, unit, label in fields]
        over = [np.asarray(model[field] / unit) for field, unit, _ in fields] if self.has_model else None
        return plot_errors((self.time_s - self.time_s[0]) / 3600, panels, self.title, over)


class Flight:
    """A flight in stretches, for a filter of one's own: increments out, corrections in.

        with sins.Flight("racetrack", gyro="tactical", accel="tactical") as flight:
            while len(imu := flight.fly(1.0)):                  # a structured array of sins.c.imu, one element for each interval
                imu["measured_angle_rad"]                       # integrals of the angular rate, shape (intervals, 3) [rad]
                flight.correct(position_enu_m=flight.record["navigation_errors"]["position_enu_m"])
    """

    def __init__(self, flown: Flown, hours: Optional[float] = None, **settings: Setting) -> None:
        scene = Scene(flown, hours, settings)
        self.title = scene.title
        self.period_s: float = scene.info.period_s
        """Length of an interval; of a log or a trajectory, the mean [s]."""
        self.duration_s: float = scene.info.duration_s
        self._intervals = scene.info.count - 1
        self._play = c.play_create(scene.handle, scene.log)
        c.play_next(self._play)  # the first sample: no interval yet

    def __enter__(self) -> "Flight":
        return self

    def __reduce_ex__(self, _: Any) -> Any:
        raise TypeError("a sins.Flight can be neither copied nor pickled: it is one INS in flight. sins.fly and sins.ensemble fly many")

    def __exit__(self, *_: object) -> None:
        self._play.close()

    def fly(self, seconds: Optional[float] = None) -> "npt.NDArray[Any]":
        """Flies a stretch, or all that remains, and returns the signals: a structured array of `sins.c.imu`, shape (intervals,).

        Fields of shape (intervals, 3): measured_angle_rad and measured_velocity_m_s, the increments of the sensors with their errors;
        compensated_..., on which the INS navigates; ideal_..., of perfect sensors. The array is empty at the end of the flight.
        After an interrupt (Ctrl-C) the flight stands where it was interrupted; `record` says when.
        """
        if seconds is not None and not 0 < seconds < np.inf:
            raise ValueError(f"seconds = {seconds}: must be more than 0")
        count = self._intervals if seconds is None else max(1, round(seconds / self.period_s))
        count = min(count, self._intervals)
        if count == 0:
            return c.array(c.imu, 0)  # type: ignore[no-any-return]
        signals: "npt.NDArray[Any]" = np.zeros(count, c.array(c.imu, 0).dtype)
        done = 0
        while done < count:
            written = c.c_size_t()
            piece = signals[done : done + INTERVALS]
            piece["struct_size"] = signals.itemsize
            try:
                status = c.play_run_imu(self._play, piece, written)
            finally:
                self._intervals -= written.value
            done += written.value
            if status == c.PLAY_END:
                break
        return signals[:done]

    @property
    def record(self) -> Any:
        """Truth, navigation and errors of this moment, at first of the start: a structured scalar of `sins.c.record`."""
        made = c.array(c.record, 1)
        c.get_record(c.play_get_simulator(self._play), c.record.from_buffer(made))
        return made[0]

    def correct(self, **errors: Any) -> None:
        """Removes estimated errors from the solution, and compensates the sensors from now on: the fields of `sins.c.correction`,
        position_enu_m, velocity_enu_m_s, misalignment_enu_rad, gyro_bias_rad_s, gyro_scale_factor, accel_bias_m_s2,
        accel_scale_factor, of three numbers each. Errors are computed less true."""
        names = [name for name, *_ in c.correction._fields_ if name != "struct_size" and name != "reserved"]
        given = {}
        for name, values in errors.items():
            if name not in names:
                raise TypeError(f"no such error: {name}; did you mean {difflib.get_close_matches(name, names, 1, 0)[0]}?")
            given[name] = numbers(name, values)
            if given[name].shape != (3,):
                raise ValueError(f"{name} has the shape {given[name].shape}: expected (3,)")
        c.correct(c.play_get_simulator(self._play), c.correction(**given))


def fly_records(scene: Any, log: Any, stop: threading.Event) -> "npt.NDArray[Any]":
    """All records of the flight of a scene, or those before it was stopped."""
    info = c.scene_get_samples(scene, log)
    records: "npt.NDArray[Any]" = c.array(c.record, info.count // info.record_every + 2)
    piece = max(1, INTERVALS // info.record_every)
    done = 0
    with c.play_create(scene, log) as play:
        while done < len(records) and not stop.is_set():
            written = c.c_size_t()
            status = c.play_run(play, records[done : done + piece], written)
            done += written.value
            if status == c.PLAY_END:
                break
    return records[:done]


def fly(flown: Flown, hours: Optional[float] = None, *, every_s: Optional[float] = None, **settings: Setting) -> Run:
    """Flies a scene, a log or a trajectory, and returns its records.

    flown: a built-in scene ("patrol"), a file (scene.toml, log.csv, flight.igc), the text of a scene, or a `Trajectory`. hours: how long, in place of
    what it says. every_s: spacing of the records [s]; without it there are about 2000. Keywords are sections of a scene, each a dict of its
    keys or the name of a preset: gyro="tactical", accel={"bias_micro_g": [10, 20, 30]}, start={"heading_deg": 0.1},
    options={"seed": 7, "error_model": "rk4"}. All that a scene plans is flown: failures, updates, its unit.

    Raises `sins.Error`: a setting out of its range, a sample that no INS can follow.
    """
    scene = Scene(flown, hours, settings, every_s)
    stop = threading.Event()
    run = Run(in_background(lambda: fly_records(scene.handle, scene.log, stop), stop.set), scene.title)
    if run.has_model and (run.records["model_errors"]["flags"] & c.ERRORS_OUTSIDE_VALIDITY).any():
        warnings.warn("the errors are too large for the error differential equations at some records", stacklevel=2)
    return run
