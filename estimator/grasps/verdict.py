"""Verdict on a gripper's grasps: good, not good, or not to be said, with the reason.

A grasp is good where three things are so in the median of the grasps: it needs less friction than there is
(security), its contacts do not slide and the grip is not lost (hold), and at most 5 % of the fruits would be
damaged, where a limit is given. Each is judged by its interval, not by its figure. Contacts of a held object
balance: where the contacts read do not, some contact was not felt or a force is wrong, and nothing is
said.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from estimator.grasps.holding import LEAST_SLIP_MM
from estimator.grasps.measures import Conditions, MeasuredGrasp, Reading
from estimator.grasps.ranking import LEVEL, median_interval

MOST_DAMAGED = 0.05
"""Share of fruits that a good grasp may damage; ours, as no standard gives one."""
_LOST_GRIP = 0.5
"""Regrasps of a grasp from which the median of several says that the grip was lost."""
Answer = Literal["good", "not good", "cannot be said"]


@dataclass(frozen=True)
class Judged:
    """One measure against its limit.

    Attributes
    ----------
    median : over the grasps with its interval
    most : limit that a good grasp stays below
    good : None where the interval holds the limit, or the measure is not known
    """

    name: str
    median: Reading
    most: float

    @property
    def good(self) -> bool | None:
        """Return whether the whole interval is on the good side."""
        if self.median.high <= self.most:
            return True
        return False if self.median.low > self.most else None


@dataclass(frozen=True)
class Verdict:
    """Answer, what it rests on, and the chance that the contacts balance."""

    answer: Answer
    judged: tuple[Judged, ...]
    balance: Reading

    @property
    def balanced(self) -> bool:
        """Return whether the contacts balance within their uncertainty, or nothing says that they do not."""
        return not self.balance.high < LEVEL

    def named(self, good: bool | None) -> list[Judged]:
        """Return the measures that are good, not good, or open."""
        return [judged for judged in self.judged if judged.good is good]


def verdict_of(grasps: Sequence[MeasuredGrasp], conditions: Conditions) -> Verdict:
    """Judge the grasps of one gripper by their medians."""
    limits = {"friction_needed": conditions.friction, "slip_mm": LEAST_SLIP_MM}
    if any(np.isfinite(grasp.readings["friction_used"].value) for grasp in grasps):
        limits["friction_used"] = conditions.friction
    limits["regrasps"] = _LOST_GRIP
    limits |= {f"damage_{limit.name}": MOST_DAMAGED for limit in conditions.limits}
    judged = tuple(Judged(name, median_of(grasps, name), most) for name, most in limits.items())
    balance = median_of(grasps, "equilibrium_p")
    states = [measure.good for measure in judged]
    verdict = Verdict("good", judged, balance)
    if not verdict.balanced:
        return Verdict("cannot be said", judged, balance)
    if False in states:
        return Verdict("not good", judged, balance)
    return verdict if all(states) else Verdict("cannot be said", judged, balance)


def median_of(grasps: Sequence[MeasuredGrasp], measure: str) -> Reading:
    """Median with the widest of two intervals: 95 % by bootstrap over grasps, and the medians of the grasps'
    own ends, as errors of the estimator may be common to all of them."""
    readings = [grasp.readings[measure] for grasp in grasps]
    value, *scatter = median_interval(np.array([reading.value for reading in readings]))
    if np.isnan(value):
        return Reading(value)
    ends = [
        median_interval(np.array([getattr(reading, end) for reading in readings]))[0]
        for end in ("low", "high")
    ]
    # a single grasp scatters not at all, a measure without ends has those of the scatter alone
    low, high = np.nanmin([value, scatter[0], ends[0]]), np.nanmax([value, scatter[1], ends[1]])
    return Reading(value, float(low), float(high))


def force_half_width(grasps: Sequence[MeasuredGrasp]) -> float:
    """Half of the 90 % interval of the held force over that force, in the median; NaN without any."""
    readings = [grasp.readings["mean_n"] for grasp in grasps]
    return median_interval(np.array([(r.high - r.low) / 2 / r.value for r in readings]))[0]
