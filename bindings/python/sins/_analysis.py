"""Questions about a flight: which effects matter, which options it needs."""

from dataclasses import dataclass
from typing import Any, Optional, Tuple

import numpy as np
import numpy.typing as npt

from sins import c
from sins._calls import INTERVALS, Progress, in_background
from sins._scene import Flown, Scene, Setting, whole_number


@dataclass(frozen=True)
class Budget:
    """The error budget of a flight: `budget` makes it."""

    effects: "Tuple[str, ...]"
    """What the rows are of; the first is the mechanization itself."""
    rows: "npt.NDArray[Any]"
    """Structured array of `sins.c.budget_row`, shape (rows,): position_m, velocity_m_s, attitude_rad, largest contributions; end_..."""
    whole: Any
    """`sins.c.budget`: all effects together, what the rows do not explain, and what leaving out costs."""

    def __str__(self) -> str:
        lines = [*zip(self.effects, self.rows["position_m"], self.rows["velocity_m_s"])]
        lines.append(("all together", self.whole.position_m, self.whole.velocity_m_s))
        return "\n".join(f"{effect:32} {position_m:12.6g} m {velocity_m_s:12.6g} m/s" for effect, position_m, velocity_m_s in lines)


@dataclass(frozen=True)
class Recommendation:
    """The cheapest options that meet a requirement: `recommend` makes it."""

    scheme: str
    subsamples: int
    updates_per_sample: int
    is_met: bool
    """If not, these options come closest."""
    cost: Any
    """`sins.c.cost`: predicted errors and what they are made of."""

    @property
    def options(self) -> "dict[str, Any]":
        """For `fly`: options=sins.recommend(...).options."""
        return {"scheme": self.scheme, "subsamples": self.subsamples, "updates_per_sample": self.updates_per_sample}


def _whole(scene: Scene, most: int) -> Any:
    """All samples, which are not those of the user."""
    if scene.info.count > most:
        raise ValueError(f"{scene.info.count} samples: at most {most}; fly fewer hours")
    samples = scene.piece(0, scene.info.count)
    if scene.samples is None:
        return samples
    return np.frombuffer(bytearray(samples), samples.dtype)  # numpy itself copies field by field


def budget(
    flown: Flown, hours: Optional[float] = None, *, runs: int = 16, position_m: float = 0.0, velocity_m_s: float = 0.0,
    attitude_rad: float = 0.0, progress: bool = False, **settings: Setting,
) -> Budget:
    """What each effect of the sensors, the start and the mounting contributes to the errors of a flight; flown, hours and settings as in `fly`.

    runs: runs with all effects together. position_m and so on: effects whose absence changes the errors by less are marked; 0: no limit.
    progress: a line on standard error shows the time that has passed. The samples are in memory, 144 bytes each. Failures, updates and the
    unit of a scene are left out.
    """
    scene = Scene(flown, hours, settings)
    samples = _whole(scene, 10**9)
    request = c.budget_request(runs=whole_number("runs", runs, 0, 2**64 - 1), position_m=position_m, velocity_m_s=velocity_m_s, attitude_rad=attitude_rad)
    rows = c.array(c.budget_row, 128)

    def stop() -> None:
        samples["struct_size"][:: INTERVALS // 8] = 1  # each of which ends the call

    with c.scene_create_simulator(scene.handle) as sim:
        written, whole = in_background(
            lambda: c.error_budget(sim, samples, request, rows), stop, Progress("flying each effect alone") if progress else None)
    effects = tuple(row.effect.decode() for row in (c.budget_row * written).from_buffer(rows))
    return Budget(effects, rows[:written], whole)


def recommend(
    flown: Flown, hours: Optional[float] = None, *, position_m: float = 0.0, velocity_m_s: float = 0.0, attitude_rad: float = 0.0,
    margin: float = 2.0, duration_s: float = 0.0, **settings: Setting,
) -> Recommendation:
    """The cheapest algorithm whose own error stays below the limits; flown, hours and settings as in `fly`.

    The flight is a piece of the host's own, of at most 360000 samples; duration_s is for how long the limits hold, if that is longer.
    At least one limit is needed. docs/accuracy.md says how the error is predicted.
    """
    scene = Scene(flown, hours, settings)
    samples = _whole(scene, 360_000)
    requirement = c.requirement(duration_s=duration_s, position_m=position_m, velocity_m_s=velocity_m_s, attitude_rad=attitude_rad,
                                margin=margin)
    with c.scene_create_simulator(scene.handle) as sim:
        try:
            (options, cost), is_met = in_background(lambda: c.recommend(sim, samples, requirement)), True
        except c.Error as error:
            if error.status != c.REQUIREMENT_NOT_MET:
                raise
            (options, cost), is_met = error.outputs, False
    scheme = c.scheme(options.scheme).name.replace("SCHEME_", "").lower()
    return Recommendation(scheme, options.subsamples, options.updates_per_sample, is_met, cost)
