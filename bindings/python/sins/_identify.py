"""The errors of real sensors, from a record of their increments and the true path of the same motion."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from sins import c
from sins._calls import INTERVALS, Progress, in_background
from sins._scene import Floats, Flown, Scene, Setting, numbers

if TYPE_CHECKING:
    import matplotlib.figure

_GRADES = ("strategic", "navigation", "tactical", "industrial", "consumer")
_AGREEMENTS = {c.AGREEMENT_AGREES: "agrees", c.AGREEMENT_TOO_GOOD: "too_good", c.AGREEMENT_TOO_BAD: "too_bad"}
_ALSO = {"lever_arm": c.IDENTIFY_LEVER_ARM, "g_sensitivity": c.IDENTIFY_G_SENSITIVITY, "asymmetry": c.IDENTIFY_ASYMMETRY,
         "temperature": c.IDENTIFY_TEMPERATURE}
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


def _words(agreement: str, factor: float) -> str:
    return "agrees" if agreement == "agrees" else f"the model is {agreement.replace('_', ' ')} by {factor:.2g}"


@dataclass(frozen=True)
class Span:
    """Flights of one duration of a `Check`. A drift is the horizontal distance from the path at the end of a flight; it is infinite if the
    flight diverged."""

    duration_s: float
    """The duration [s]."""
    flights: int
    """Number of flights."""
    apart: int
    """Number of flights that do not overlap."""
    free_m: float
    """Median drift on the record as it is [m]."""
    real_m: float
    """Median drift with the errors removed that were found [m]."""
    real_interval_m: "Tuple[float, float]"
    """Interval of 95 % of real_m, for the number of flights that do not overlap [m]."""
    real_rms_m: float
    """Root mean square of the drifts with the errors removed [m]."""
    predicted_m: float
    """Median drift of the flights of a twin: mean of the twins [m]."""
    predicted_interval_m: "Tuple[float, float]"
    """Interval that 95 % of the twins keep at all durations together [m]."""
    predicted_rms_m: float
    """Root mean square of the drifts of the twins [m]."""
    verdict: str
    """"agrees", "too_good" or "too_bad": the model of the sensors."""
    factor: float
    """How many times as far the real sensors drift (too_good), or the model (too_bad); otherwise 1."""

    def __str__(self) -> str:
        real, predicted = (f"{value:.4g} ({low:.4g} to {high:.4g})" for value, (low, high) in
                           ((self.real_m, self.real_interval_m), (self.predicted_m, self.predicted_interval_m)))
        return f"{self.duration_s:g} s: drift {real} m, predicted {predicted} m: {_words(self.verdict, self.factor)}"


@dataclass(frozen=True)
class Check:
    """Whether a record keeps what was found in it: `Identified.check` makes it. str() has all durations and the sentence."""

    spans: "Tuple[Span, ...]"
    """Each duration: 10, 30, 60, 120, 300, 600 s, as long as two of them have room."""
    verdict: str
    """"agrees", "too_good" or "too_bad": of the duration that is farthest off."""
    factor: float
    """How many times as far the real sensors drift (too_good), or the model (too_bad); otherwise 1."""
    length_s: float
    """Length of the half of the record that was checked [s]."""
    twins: int
    """Number of twins."""
    diverged_s: Optional[float]
    """Shortest duration that is left out, because half of the flights of the record or of a twin diverge; longer ones are too [s]."""
    sentence: str
    """The verdict in words."""

    def __str__(self) -> str:
        return "\n".join([*map(str, self.spans), self.sentence])


@dataclass(frozen=True)
class _Given:
    """What sensors are identified from."""

    flown: Flown
    hours: Optional[float]
    settings: "Mapping[str, Setting]"
    increments: "npt.NDArray[Any]"
    request: Any

    def handle(self, flags: int = 0) -> "Tuple[Any, Scene]":
        """A handle without rows, and the path."""
        request = type(self.request).from_buffer_copy(self.request)
        request.flags |= flags
        scene = Scene(self.flown, self.hours, self.settings)
        options = c.scene_get_options(scene.handle)
        if scene.log is None:
            options.sample_period_s = scene.info.period_s  # as the simulator of a scene with a flight of its own
        return c.identify_create(options, request), scene

    def push(self, handle: Any, scene: Scene) -> None:
        """Adds the path and the record."""
        for begin in range(0, scene.info.count, INTERVALS):
            c.identify_push_samples(handle, scene.piece(begin, min(begin + INTERVALS, scene.info.count)))
        c.identify_push_increments(handle, self.increments)


@dataclass(frozen=True, eq=False)
class Identified:
    """What a record shows of its sensors: `identify` makes it."""

    parameters: "Tuple[Parameter, ...]"
    """Clock, mounting, then bias, scale factors, misalignments and noise of the gyros and of the accelerometers; last what was asked for
    beside."""
    rotation: Floats
    """Signals of the record are this matrix times the signals of the vehicle, shape (3, 3)."""
    boresight_rad: Floats
    """Attitude of the sensor block in the vehicle: roll, pitch, heading, shape (3,) [rad]."""
    axes_are_seen: bool
    """Whether the motion excludes all other axes."""
    used_s: float
    """Time of the record that was compared with the path [s]."""
    reference_temperature_c: Optional[float]
    """Temperature at which the biases hold, if their changes with it were asked for [deg C]."""
    text: str
    """The scene that `scene` returns."""
    _given: _Given = field(repr=False)
    """Path and record, for `check`."""

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

    def check(
        self, *, twins: int = 100, position_m: float = 0.0, velocity_m_s: float = 0.0, tilt_rad: float = 0.0, heading_rad: float = 0.0,
        progress: bool = False,
    ) -> Check:
        """Whether the record keeps the prediction, as `sins identify --check`: identifies the first half of the rows that the path has, and
        navigates the other half from many starts, with the errors removed that were found. Twins (40 to 1000), sensors drawn from what was
        found, fly the same starts.

        Standard deviations of the errors of the path, with which each flight of a twin begins: position_m and velocity_m_s of each axis,
        tilt_rad about east and about north, heading_rad. A file or a log of the path is read again. It takes seconds to minutes; progress: a
        line on standard error shows the time that has passed. docs/identify.md explains the verdict.
        """
        if not 40 <= twins <= 1000:
            raise ValueError(f"twins = {twins}: must be from 40 to 1000")
        request = c.identify_check_request(twins=twins, position_m=position_m, velocity_m_s=velocity_m_s, tilt_rad=tilt_rad, heading_rad=heading_rad)
        handle, scene = self._given.handle(c.IDENTIFY_STATES)

        def check() -> Any:
            self._given.push(handle, scene)
            return c.identify_check(handle, request)

        checked = in_background(check, progress=Progress("checking") if progress else None)
        verdict, is_exact = _AGREEMENTS[checked.agreement], not any((position_m, velocity_m_s, tilt_rad, heading_rad))
        sentence = "the prediction agrees with the record" if verdict == "agrees" else _words(verdict, checked.factor)
        if not is_exact:
            sentence += ", with the errors of the path that were given"
        elif verdict == "too_good":
            sentence += "; the path is taken for exact: check(velocity_m_s=...) and the like state its errors"
        return Check(tuple(_span(c.identify_get_span(handle, index)) for index in range(checked.spans)), verdict, checked.factor,
                     checked.length_s, checked.twins, checked.diverged_s or None, sentence)

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


def _span(one: Any) -> Span:
    return Span(one.duration_s, one.flights, one.apart, one.free_m, one.real_m, (one.real_low_m, one.real_high_m), one.real_rms_m,
                one.predicted_m, (one.predicted_low_m, one.predicted_high_m), one.predicted_rms_m, _AGREEMENTS[one.agreement], one.factor)


def identify(
    flown: Flown, imu: Any, hours: Optional[float] = None, *, prior: str = "consumer", axes: Optional[str] = None,
    shift_s: Optional[float] = None, cutoff_hz: Optional[float] = None, also: Sequence[str] = (), progress: bool = False,
    **settings: Setting,
) -> Identified:
    """Finds the errors of real sensors: compares their record with what perfect sensors measure along the true path.

    flown, hours and settings are those of the path, as in `fly`; of the settings, the Earth, gravity and axes count. imu is the record:
    the increments of `Flight.fly`, or a dict of arrays: time_s, the end of each interval on the clock of the record, shape (rows,) [s];
    rate_rad_s (against inertial space) or its integral angle_rad, shape (rows, 3) [rad/s], [rad]; force_m_s2 (specific force) or its
    integral velocity_m_s, shape (rows, 3) [m/s2], [m/s]; interval_s, a number or of shape (rows,), without it the median of the times [s].
    Clock and axes of the record need not be those of the path: they are found.

    prior: what is known of the sensors, strategic, navigation, tactical, industrial or consumer, the widest. axes: the axes of the vehicle
    along x, y and z of the record, if they are known, such as "y x -z". shift_s: time of the path less time of the record, if it is known to 10 s.
    cutoff_hz: the frequency above which the path lacks motion, as a smoothed one does [Hz]: path and record are then compared by their means
    over a period of it. also: what is found beside, of lever_arm (from the point of the path to the accelerometers), g_sensitivity (of the
    gyros), asymmetry (of the scale factors) and temperature (changes of the biases with the temperature_c of the path); it makes all others
    less certain. progress: a line on standard error shows the time that has passed. docs/identify.md says what a record can show.

    Raises `sins.Error`, with the reason, for a record of another motion, in other units, too short, or with a sensor that is stuck.
    """
    if prior not in _GRADES:
        raise ValueError(f"prior = {prior!r}: must be {', '.join(_GRADES[:-1])} or {_GRADES[-1]}")
    request = c.identify_request(prior=getattr(c, f"GRADE_{prior.upper()}"))
    for name in [also] if isinstance(also, str) else also:
        if name not in _ALSO:
            raise ValueError(f"also = {name!r}: must be {', '.join(list(_ALSO)[:-1])} or {list(_ALSO)[-1]}")
        request.flags |= _ALSO[name]
    if axes is not None:
        request.axes = tuple(_axes(axes))
    if shift_s is not None:
        request.flags, request.shift_s = request.flags | c.IDENTIFY_SHIFT, float(shift_s)
    if cutoff_hz is not None:
        if not 1e-3 <= cutoff_hz <= 1e6:
            raise ValueError(f"cutoff_hz = {cutoff_hz!r}: must be from 0.001 to 1e6")
        request.cutoff_hz = float(cutoff_hz)
    given = _Given(flown, hours, settings, _increments(imu), request)
    handle, scene = given.handle()

    def solve() -> Any:
        given.push(handle, scene)
        return c.identify_solve(handle)

    found = in_background(solve, progress=Progress("identifying") if progress else None)
    every = (_parameter(c.identify_get_parameter(handle, index)) for index in range(c.IDENTIFIED_PARAMETERS))
    return Identified(tuple(one for one in every if one.reason != "not asked for"), np.array(found.rotation).reshape(3, 3), np.array(found.boresight_rad),
                      bool(found.flags & c.IDENTIFIED_SEEN), found.used_s,
                      found.reference_temperature_c if request.flags & c.IDENTIFY_TEMPERATURE else None, c.identify_get_scene(handle), given)
