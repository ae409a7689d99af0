"""Many runs of one flight, each with random numbers of its own."""

import math
import os
import warnings
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Optional, Tuple

import numpy as np
import numpy.typing as npt

from sins import c
from sins._flight import fly_records, plot_errors
from sins._scene import Floats, Flown, Scene, Setting

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
    **settings: Setting,
) -> Ensemble:
    """Flies many runs, and returns their errors.

    flown, hours and settings as in `fly`. The first run is that of options={"run": ...}, 0 without it; run k has the bits of `fly` with
    this option k. times: about how many times there are errors of, evenly spaced; the start and the end are among them. threads: how many
    runs are flown at once; without it, one for each core. A scene with a unit flies each run with its unit, which costs a single flight
    for each run. The answer takes 72 bytes for each run and time.

    Raises `sins.Error` as `fly`. Warns of runs that diverged.
    """
    if runs < 1 or times < 2:
        raise ValueError(f"runs = {runs}, times = {times}: at least 1 run and 2 times")
    scene = Scene(flown, hours, settings)
    every = max(1, (scene.info.count - 1) // (times - 1))
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    workers = min(runs, threads or cores)
    first_run = c.scene_get_options(scene.handle).run
    fly_all = _with_units if scene.plans("[unit]") else _side_by_side
    time_s, errors = fly_all(scene, first_run, runs, every, workers)
    diverged = int(np.isnan(errors[_FIELDS[0]][:, -1, 0]).sum())
    if diverged:
        warnings.warn(f"{diverged} of {runs} runs diverged; their errors are NaN", stacklevel=2)
    return Ensemble(time_s, errors, first_run, scene.title)


def _empty(runs: int, times: int) -> "dict[str, Floats]":
    return {field: np.full((runs, times, 3), np.nan) for field in _FIELDS}


def _with_units(scene: Scene, first_run: int, runs: int, every: int, workers: int) -> "Tuple[Floats, dict[str, Floats]]":
    """Each run as a scene in flight."""
    def one(run: int) -> "npt.NDArray[Any]":
        with c.scene_parse(scene.text) as own:
            c.scene_set_values(own, f"options.run = {run}\noutput.every_s = {every * scene.info.period_s!r}")
            return fly_records(own, scene.log)

    with ThreadPoolExecutor(workers) as pool:
        flown = list(pool.map(one, range(first_run, first_run + runs)))
    errors = _empty(runs, len(flown[0]))
    for run, records in enumerate(flown):
        for field in _FIELDS:
            errors[field][run, : len(records)] = records["navigation_errors"][field]
    return np.array(flown[0]["time_s"]), errors


def _side_by_side(scene: Scene, first_run: int, runs: int, every: int, workers: int) -> "Tuple[Floats, dict[str, Floats]]":
    """Runs in as many ensembles as there are threads, over the same samples."""
    parts = np.linspace(0, runs, workers + 1).astype(int).tolist()
    with c.scene_create_simulator(scene.handle) as sim:
        made = [c.ensemble_create(sim, first_run + begin, end - begin) for begin, end in zip(parts, parts[1:])]
    ends = [0, *range(every, scene.info.count - 1, every), scene.info.count - 1]
    errors, time_s = _empty(runs, len(ends)), np.empty(len(ends))
    fly = _stretch_with_plan(scene) if scene.setup.has_temperature or scene.plans("[[failure]]", "[[update]]") else c.ensemble_run

    def stretch(part: int, at: int, samples: "npt.NDArray[Any]") -> None:
        fly(made[part], samples)
        found = c.array(c.errors, parts[part + 1] - parts[part])
        c.ensemble_get_all_errors(made[part], c.ERRORS_NAVIGATION, found)
        is_good = (found["flags"] & c.ERRORS_NOT_COMPUTED) == 0
        for field in _FIELDS:
            errors[field][parts[part] : parts[part + 1], at][is_good] = found[field][is_good]

    with ThreadPoolExecutor(workers) as pool:
        begin = 0
        waiting: "list[Any]" = []
        for at, end in enumerate(ends):
            samples = scene.piece(begin, end + 1)  # while the threads fly the piece before
            for one in waiting:
                one.result()
            time_s[at] = samples["time_s"][-1]
            waiting = [pool.submit(stretch, part, at, samples) for part in range(workers)]
            begin = end + 1
        for one in waiting:
            one.result()
    return time_s, errors


def _stretch_with_plan(scene: Scene) -> "Callable[[Any, npt.NDArray[Any]], None]":
    """Flies samples one by one, with failures, updates and temperature of the scene."""
    start_s: float = scene.info.start_s

    def fly(made: Any, samples: "npt.NDArray[Any]") -> None:
        for own in (c.flight_sample * len(samples)).from_buffer_copy(samples):
            c.scene_prepare_ensemble(scene.handle, made, start_s, own)
            c.ensemble_push_sample(made, own)
            c.ensemble_step(made)

    return fly
