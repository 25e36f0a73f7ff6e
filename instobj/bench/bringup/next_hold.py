"""Choice of the next hold of the magnet: the one that says most about the least known gains."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from instobj.bench.bringup.asking.asked import MOST_FURTHER, Question, Recordings, further_holds
from instobj.bench.bringup.asking.held_magnet import held_magnet, stated_pose
from instobj.bench.bringup.asking.hold_places import hold_places
from instobj.bench.bringup.diagnosis.chip_findings import widest_gain_sd
from instobj.bench.bringup.diagnosis.chip_fit import Fitted, JointFit, fitted, gain_intervals
from instobj.bench.bringup.diagnosis.findings import HALF_95
from instobj.bench.bringup.verdict import held_so_far

_LOOKED_AT = 40
"""Candidates nearest to the chip whose gain is known least."""


def next_hold(
    spec: ObjectSpec, recordings: Recordings, left_out: Collection[str] = ()
) -> Question | None:
    """The next further hold; None where a gain of 1.1 would be noticed at every chip, or at their limit.

    Intervals are the ones that the fit will state once drift is followed, as a second still recording does.
    A candidate's readings are predicted for the magnet exactly where it is asked for; its pose counts
    as unknown. `left_out` are names of holds that shall not be asked for; they count as asked.
    """
    holds = further_holds(spec)
    over = {hold.name for hold in holds if hold.name in recordings or hold.name in left_out}
    if len(over) >= MOST_FURTHER:
        return None
    so_far = held_so_far(spec, recordings, drift_followed=True)
    if so_far is None:
        return None
    fit = fitted(*so_far)
    problem, gains = fit.problem, fit.problem.gains
    matrices, covariance = problem.matrices(fit.unknown), fit.covariance[gains, gains]
    wide = gain_intervals(matrices, covariance, problem.is_read) / HALF_95
    limits = widest_gain_sd(spec, problem.is_read.sum(axis=1))
    if not np.any((wide > limits) & (limits > 0)):
        return None
    chip_entries = slice(problem.poses, None)
    precision = np.linalg.inv(fit.covariance[chip_entries, chip_entries])
    near = _nearest(spec, [h for h in holds if h.name not in over], fit, int(np.nanargmax(wide)))
    if not near:
        return None
    widths = [
        _left_wide(fit, precision + information)
        for information in information_of(spec, problem, near)
    ]
    return near[int(np.argmin(widths))]


def _nearest(spec: ObjectSpec, holds: list[Question], fit: Fitted, chip: int) -> list[Question]:
    places = hold_places(spec)
    foot_mm = places[int(fit.problem.arrangement.site[chip])].foot_mm
    return sorted(holds, key=lambda h: float(np.linalg.norm(places[h.part].foot_mm - foot_mm)))[
        :_LOOKED_AT
    ]


def _left_wide(fit: Fitted, information: Float[np.ndarray, "own own"]) -> float:
    """Sum over chips of the fourth powers of their gains' intervals: wide ones count.

    `information` is that about the chips' matrices and seats.
    """
    problem, after = fit.problem, np.linalg.inv(information)
    entries = slice(9 * problem.chips)
    intervals = gain_intervals(
        problem.matrices(fit.unknown), after[entries, entries], problem.is_read
    )
    return float(np.nansum(intervals**4))


def information_of(
    spec: ObjectSpec, problem: JointFit, holds: Sequence[Question]
) -> Float[np.ndarray, "hold own own"]:
    """Return each hold's information about the chips' matrices and seats, its own pose left unknown."""
    given, count = problem.readings, len(holds)
    counts = np.tile(np.where(problem.is_read, 0.0, np.nan), (count, 1, 1))
    noise = np.tile(given.noise_counts.min(axis=0), (count, 1, 1))
    model = held_magnet(spec, [hold.part for hold in holds])
    arrangement = replace(problem.arrangement, model=model, pose=stated_pose(count))
    fit = JointFit.start_from(replace(given, counts=counts, noise_counts=noise), arrangement)
    return chips_part(fit.slopes(fit.start), fit.poses, count, counts.size)


def chips_part(
    slope: Float[np.ndarray, "residual unknown"], poses: int, holds: int, readings: int
) -> Float[np.ndarray, "hold own own"]:
    """Information of each hold's readings about all unknowns behind the `poses` first, the holds' own poses.

    Rows are the readings of hold after hold, then the priors of all unknowns.
    """
    k = np.arange(holds)
    by_hold = slope[:readings].reshape(holds, -1, slope.shape[1])
    of_pose = by_hold[:, :, :poses].reshape(holds, by_hold.shape[1], holds, -1)[k, :, k]
    chip_frame = by_hold[:, :, poses:]
    prior = slope[readings:][:poses, :poses].reshape(holds, -1, holds, poses // holds)
    normal = of_pose.mT @ of_pose + (prior**2)[k, :, k]
    across = chip_frame.mT @ of_pose
    return chip_frame.mT @ chip_frame - across @ np.linalg.solve(normal, across.mT)
