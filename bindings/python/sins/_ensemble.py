"""Many runs of one flight, each with random numbers of its own."""

import contextlib
import math
import os
import threading
import warnings
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator, Optional, Tuple

import numpy as np
import numpy.typing as npt

from sins import c
from sins._calls import INTERVALS, Progress, in_background
from sins._flight import fly_records, plot_errors
from sins._scene import Floats, Flown, Scene, Setting, whole_number

if TYPE_CHECKING:
    import matplotlib.figure

_FIELDS = ("position_enu_m", "velocity_enu_m_s", "misalignment_enu_rad")

# Of a normal distribution: 95 % are within this many sigmas.
_Z = 1.959963984540054


def _quantile(radial: Floats, fraction: float) -> "Tuple[float, Tuple[float, float]]":
    """A quantile of radii in their order, and its interval (95 %) by the binomial distribution of how many are below it: of any
    distribution. An end that these many radii cannot show is 0 or infinite."""
    runs = len(radial)
    count = np.arange(1, runs + 1)
    log_choose = np.concatenate(([0.0], np.cumsum(np.log((runs + 1 - count) / count))))
    below = np.arange(runs + 1)
    at_most = np.cumsum(np.exp(log_choose + below * math.log(fraction) + (runs - below) * math.log1p(-fraction)))
    ends = [0.0, *radial.tolist(), math.inf]
    low, high = int(np.searchsorted(at_most, 0.025, "right")), int(np.searchsorted(at_most, 0.975)) + 1
    return ends[math.ceil(fraction * runs)], (ends[low], ends[high])


def _rms_factors(runs: int) -> "Tuple[float, float]":
    """Ends of the interval (95 %) of a root mean square of normal numbers about 0, divided by it: chi-squared by Wilson and Hilferty."""
    def chi2(z: float) -> float:
        return runs * max(1 - 2 / (9 * runs) + z * math.sqrt(2 / (9 * runs)), 0.0) ** 3

    low = chi2(-_Z)
    return math.sqrt(runs / chi2(_Z)), math.sqrt(runs / low) if low > 0 else math.inf


@dataclass(frozen=True)
class Figures:
    """Figures of all runs at one time, with intervals of 95 % confidence."""

    time_s: float
    runs: int
    """Runs that did not diverge."""
    cep50_m: float
    """Horizontal radius that half of the runs are within [m]."""
    cep50_interval_m: "Tuple[float, float]"
    r95_m: float
    """Horizontal radius that 95 % of the runs are within [m]."""
    r95_interval_m: "Tuple[float, float]"
    rms_position_enu_m: Floats
    """Root mean square of the position error, shape (3,) [m]."""
    rms_position_interval_enu_m: Floats
    """Its interval, shape (2, 3) [m]."""
    mean_position_enu_m: Floats
    """Mean position error, shape (3,) [m]."""


class Ensemble:
    """The errors of many runs: `ensemble` makes it. Axes are east, north, up; the errors of a run that diverged are NaN from then on."""

    def __init__(self, time_s: Floats, errors: "dict[str, Floats]", first_run: int, title: str) -> None:
        self.time_s = time_s
        """Times of the errors, shape (times,) [s]."""
        self.position_error_m = errors["position_enu_m"]
        """Shape (runs, times, 3) [m]."""
        self.velocity_error_m_s = errors["velocity_enu_m_s"]
        """Shape (runs, times, 3) [m/s]."""
        self.misalignment_rad = errors["misalignment_enu_rad"]
        """Shape (runs, times, 3) [rad]."""
        self.first_run = first_run
        """Element k of the arrays is what `fly` flies with options={"run": first_run + k}."""
        self.title = title

    def __len__(self) -> int:
        return len(self.position_error_m)

    def __repr__(self) -> str:
        return f"<sins.Ensemble {self.title!r}: {len(self)} runs, {len(self.time_s)} times to {self.time_s[-1]:g} s>"

    @property
    def radial_error_m(self) -> Floats:
        """Horizontal distance from the truth, shape (runs, times) [m]."""
        return np.asarray(np.hypot(self.position_error_m[..., 0], self.position_error_m[..., 1]))

    def figures(self, at: int = -1) -> Figures:
        """Figures at a time, by its place in time_s; -1 is the end."""
        errors = self.position_error_m[:, at]
        errors = errors[np.isfinite(errors).all(axis=1)]
        runs = len(errors)
        if runs == 0:
            raise ValueError(f"no run is left at {self.time_s[at]:g} s: all have diverged")
        radial = np.sort(np.hypot(errors[:, 0], errors[:, 1]))
        half, far = _quantile(radial, 0.5), _quantile(radial, 0.95)
        rms = np.sqrt((errors**2).mean(axis=0))
        return Figures(float(self.time_s[at]), runs, *half, *far, rms,
                       np.outer(_rms_factors(runs), rms), errors.mean(axis=0))

    def envelope_plot(self) -> "matplotlib.figure.Figure":
        """A figure of matplotlib: radii that half and 95 % of the runs are within, and root mean squares of position and velocity."""
        radial = np.nanquantile(self.radial_error_m, [0.5, 0.95], axis=0).T
        rms = [np.sqrt(np.nanmean(errors**2, axis=0)) for errors in (self.position_error_m, self.velocity_error_m_s)]
        panels = [(rms[0], "position, rms [m]"), (rms[1], "velocity, rms [m/s]")]
        hours = (self.time_s - self.time_s[0]) / 3600
        figure = plot_errors(hours, [(radial, "radial position [m]"), *panels], f"{self.title}: {len(self)} runs")
        figure.axes[0].legend(["half of the runs", "95 % of the runs"], fontsize="small")
        figure.axes[1].legend(["east", "north", "up"], ncol=3, fontsize="small")
        return figure


def ensemble(
    flown: Flown,
    hours: Optional[float] = None,
    *,
    runs: int = 1000,
    times: int = 200,
    threads: Optional[int] = None,
    progress: bool = False,
    **settings: Setting,
) -> Ensemble:
    """Flies many runs, and returns their errors.

    flown, hours and settings as in `fly`. The first run is that of options={"run": ...}, 0 without it; run k has the bits of `fly` with
    this option k. times: about how many times there are errors of, evenly spaced; the start and the end are among them. threads: how many
    runs are flown at once; without it, one for each core. A scene with a unit flies each run with its unit, which costs a single flight
    for each run. progress: a line on standard error shows which part is flown, and the remaining time. The answer takes 72 bytes for each
    run and time.

    Raises `sins.Error` as `fly`, and ValueError if all runs would be equal, because nothing is random. Warns of runs that diverged.
    """
    runs, times = whole_number("runs", runs, 1, 2**32 - 1), whole_number("times", times, 2, 2**63 - 1)
    scene = Scene(flown, hours, settings)
    if runs > 1 and not scene.setup.is_random:
        raise ValueError(f'nothing is random in this scene: all runs would be equal. gyro="navigation" sets random errors; runs=1 flies one run')
    every = max(1, (scene.info.count - 1) // (times - 1))
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    workers = min(runs, cores if threads is None else whole_number("threads", threads, 1, 2**31 - 1))
    first_run = c.scene_get_options(scene.handle).run
    fly_all = _with_units if scene.plans("[unit]") else _side_by_side
    stop = threading.Event()
    shown = Progress(f"flying {runs} runs", runs * scene.info.count)
    time_s, errors = in_background(lambda: fly_all(scene, first_run, runs, every, workers, stop, shown), stop.set, shown if progress else None)
    diverged = int(np.isnan(errors[_FIELDS[0]][:, -1, 0]).sum())
    if diverged:
        warnings.warn(f"{diverged} of {runs} runs diverged; their errors are NaN", stacklevel=2)
    return Ensemble(time_s, errors, first_run, scene.title)


def _empty(runs: int, times: int) -> "dict[str, Floats]":
    return {field: np.full((runs, times, 3), np.nan) for field in _FIELDS}


def _with_units(
    scene: Scene, first_run: int, runs: int, every: int, workers: int, stop: threading.Event, shown: Progress
) -> "Tuple[Floats, dict[str, Floats]]":
    """Each run as a scene in flight."""
    def one(run: int) -> "npt.NDArray[Any]":
        if stop.is_set():
            return c.array(c.record, 0)  # type: ignore[no-any-return]
        with c.scene_parse(scene.text) as own:
            c.scene_set_values(own, f"options.run = {run}\noutput.every_s = {every * scene.info.period_s!r}")
            records = fly_records(own, scene.log, stop)
        shown.add(scene.info.count)
        return records

    with ThreadPoolExecutor(workers) as pool, _ended_by_errors(stop):
        flown = list(pool.map(one, range(first_run, first_run + runs)))
    errors = _empty(runs, len(flown[0]))
    for run, records in enumerate(flown):
        for field in _FIELDS:
            errors[field][run, : len(records)] = records["navigation_errors"][field]
    return np.array(flown[0]["time_s"]), errors


def _side_by_side(
    scene: Scene, first_run: int, runs: int, every: int, workers: int, stop: threading.Event, shown: Progress
) -> "Tuple[Floats, dict[str, Floats]]":
    """Runs in as many ensembles as there are threads, over the same samples."""
    parts = np.linspace(0, runs, workers + 1).astype(int).tolist()
    with c.scene_create_simulator(scene.handle) as sim:
        made = [c.ensemble_create(sim, first_run + begin, end - begin) for begin, end in zip(parts, parts[1:])]
    ends = [0, *range(every, scene.info.count - 1, every), scene.info.count - 1]
    errors, time_s = _empty(runs, len(ends)), np.empty(len(ends))
    has_plan = scene.setup.has_temperature or scene.plans("[[failure]]", "[[update]]")
    fly = _fly_plan if has_plan else _fly

    def stretch(part: int, begin: int, samples: "npt.NDArray[Any]", at: Optional[int]) -> None:
        fly(scene, made[part], begin, samples, stop)
        shown.add(len(samples) * (parts[part + 1] - parts[part]))
        if at is None:
            return
        found = c.array(c.errors, parts[part + 1] - parts[part])
        c.ensemble_get_all_errors(made[part], c.ERRORS_NAVIGATION, found)
        is_good = (found["flags"] & c.ERRORS_NOT_COMPUTED) == 0
        for field in _FIELDS:
            errors[field][parts[part] : parts[part + 1], at][is_good] = found[field][is_good]

    with ThreadPoolExecutor(workers) as pool, _ended_by_errors(stop):
        waiting: "list[Any]" = []
        for begin, end, at in _pieces(ends):
            samples = scene.piece(begin, end)  # while the threads fly the piece before
            for one in waiting:
                one.result()
            if stop.is_set():
                break
            if at is not None:
                time_s[at] = samples["time_s"][-1]
            waiting = [pool.submit(stretch, part, begin, samples, at) for part in range(workers)]
        for one in waiting:
            one.result()
    return time_s, errors


def _pieces(ends: "list[int]") -> "Iterator[Tuple[int, int, Optional[int]]]":
    """Ranges of samples, none of them long, to the last sample of `ends`; with the place in `ends` of the sample at their end, if it is one."""
    begin = 0
    for at, last in enumerate(ends):
        while begin <= last:
            end = min(begin + INTERVALS, last + 1)
            yield begin, end, at if end > last else None
            begin = end


@contextlib.contextmanager
def _ended_by_errors(stop: threading.Event) -> "Iterator[None]":
    """An error of one thread ends the others."""
    try:
        yield
    except BaseException:
        stop.set()
        raise


def _fly(scene: Scene, made: Any, begin: int, samples: "npt.NDArray[Any]", stop: threading.Event) -> None:
    """Flies samples, of which the first is sample `begin` of the flight, in calls that are over soon."""
    piece = max(1, 8 * INTERVALS // c.ensemble_get_runs(made)[1])
    for first in range(0, len(samples), piece):
        if stop.is_set():
            return
        try:
            c.ensemble_run(made, samples[first : first + piece])
        except c.Error as error:
            of_call = error.info.sample
            if of_call >= 0:
                error.info.sample += begin + first
                error.args = (str(error).replace(f"samples[{of_call}]", f"samples[{error.info.sample}]"),)
            raise


def _fly_plan(scene: Scene, made: Any, begin: int, samples: "npt.NDArray[Any]", stop: threading.Event) -> None:
    """Flies samples one by one, with failures, updates and temperature of the scene."""
    for own in (c.flight_sample * len(samples)).from_buffer_copy(samples):
        if stop.is_set():
            return
        c.scene_prepare_ensemble(scene.handle, made, scene.info.start_s, own)
        c.ensemble_push_sample(made, own)
        c.ensemble_step(made)
