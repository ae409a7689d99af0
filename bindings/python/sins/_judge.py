"""What the judge finds in a flight before an INS flies it."""

import sys
import warnings
from dataclasses import dataclass
from typing import Any, Iterable

from sins import c

_LEVELS = {c.LEVEL_NOTE: "note", c.LEVEL_DOUBTFUL: "doubtful", c.LEVEL_UNUSABLE: "unusable"}
_KINDS = {getattr(c, name): name[len("FINDING_"):].lower() for name in dir(c) if name.startswith("FINDING_")}


class LogWarning(UserWarning):
    """A flight is doubtful, or unusable: the errors of an INS on it are not those on the flight that was meant."""


@dataclass(frozen=True)
class Finding:
    """One that was found; str() is its sentence."""

    level: str
    """"note": it harms little; "doubtful": the flight is not that of the vehicle in every respect; "unusable": errors of an INS on it say
    nothing."""
    kind: str
    """What was found, as "velocity_unit": SINS_FINDING_... of the header."""
    sample: int
    """Its first sample, or that where it is largest."""
    time_s: float
    """Time stamp of that sample [s]."""
    count: int
    """How often; 0: the whole flight."""
    figure: float
    """Its figure, see SINS_FINDING_... of the header."""
    acceleration_m_s2: float
    """False acceleration that is flown for it; 0: none, or unknown [m/s2]."""
    ins_error_m: float
    """Largest horizontal error of an INS with ideal sensors for it; 0: none, or unknown [m]."""
    sentence: str
    """It, and what to do about it."""

    def __str__(self) -> str:
        return f"{self.level}: {self.sentence}"


def findings(log: Any, options: Any = None) -> "tuple[Finding, ...]":
    """What is found in the samples of a log, the worst first."""
    judge = c.judge_create(options)
    c.judge_push_log(judge, log)
    array = c.array(c.finding, c.FINDINGS_MAX)
    found = (c.finding * len(array)).from_buffer(array)
    count = c.judge_get_findings(judge, array)
    return tuple(
        Finding(_LEVELS[one.level], _KINDS[one.kind], one.sample, one.time_s, one.count, one.figure, one.acceleration_m_s2,
                one.ins_error_m, bytes(one.sentence).split(b"\0")[0].decode())
        for one in found[:count]
    )


def warn(doubts: "Iterable[Finding]") -> None:
    """Warns of findings at the line outside this package that the user wrote."""
    depth = 1
    while sys._getframe(depth).f_globals.get("__name__", "").startswith("sins."):
        depth += 1
    for one in doubts:
        warnings.warn(str(one), LogWarning, stacklevel=depth + 1)
