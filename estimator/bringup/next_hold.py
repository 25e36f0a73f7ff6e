"""Choice of the next hold of the magnet: the one that tells most about the least known gains."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from estimator.bringup.asking.asked import MOST_FURTHER, Asked, Recordings, further_holds
from estimator.bringup.asking.held_magnet import held_magnet, stated_pose
from estimator.bringup.asking.hold_places import hold_places
from estimator.bringup.diagnosis.chip_findings import widest_gain_sd
from estimator.bringup.diagnosis.chip_fit import Fitted, JointFit, fitted, gain_intervals
from estimator.bringup.diagnosis.findings import HALF_95
from estimator.bringup.verdict import held_so_far

_LOOKED_AT = 40
"""Candidates nearest to the chip whose gain is known least."""


def next_hold(
    spec: ObjectSpec, recordings: Recordings, left_out: Collection[str] = ()
) -> Asked | None:
    """The next further hold; None where a gain of 1.1 would be told of every chip, or at their limit.

    Intervals are those that the fit will state once drift is followed, as a second still recording does.
    A candidate's readings are predicted for the magnet exactly where it is asked for; its pose counts
    as unknown. `left_out` are names of holds that shall not be asked for; they count as asked.
    """
    every = further_holds(spec)
    over = {hold.name for hold in every if hold.name in recordings or hold.name in left_out}
    if len(over) >= MOST_FURTHER:
        return None
    so_far = held_so_far(spec, recordings, drift_followed=True)
    if so_far is None:
        return None
    fit = fitted(*so_far)
    problem, gains = fit.problem, fit.problem.gains
    matrices, covariance = problem.matrices(fit.unknown), fit.covariance[gains, gains]
    wide = gain_intervals(matrices, covariance, problem.known) / HALF_95
    limits = widest_gain_sd(spec, problem.known.sum(axis=1))
    if not np.any((wide > limits) & (limits > 0)):
        return None
    own = slice(problem.poses, None)
    known = np.linalg.inv(fit.covariance[own, own])
    near = _nearest(spec, [h for h in every if h.name not in over], fit, int(np.nanargmax(wide)))
    return min(near, key=lambda hold: _left_wide(spec, fit, known, hold), default=None)


def _nearest(spec: ObjectSpec, holds: list[Asked], fit: Fitted, chip: int) -> list[Asked]:
    places = hold_places(spec)
    at = places[int(fit.problem.found.site[chip])].foot_mm
    return sorted(holds, key=lambda h: float(np.linalg.norm(places[h.part].foot_mm - at)))[
        :_LOOKED_AT
    ]


def _left_wide(
    spec: ObjectSpec, fit: Fitted, known: Float[np.ndarray, "own own"], hold: Asked
) -> float:
    """Sum over chips of the fourth powers of their gains' intervals after the hold: wide ones count.

    `known` is the information about the chips' matrices and seats so far.
    """
    problem = fit.problem
    after = np.linalg.inv(known + _information(spec, problem, hold))
    entries = slice(9 * problem.chips)
    intervals = gain_intervals(
        problem.matrices(fit.unknown), after[entries, entries], problem.known
    )
    return float(np.nansum(intervals**4))


def _information(spec: ObjectSpec, problem: JointFit, hold: Asked) -> Float[np.ndarray, "own own"]:
    """Of a hold about the chips' matrices and seats, its own pose left unknown."""
    given = problem.readings
    counts = np.where(problem.known, 0.0, np.nan)[None]
    noise = given.noise_counts.min(axis=0, keepdims=True)
    found = replace(problem.found, model=held_magnet(spec, [hold.part]), pose=stated_pose(1))
    one = JointFit.of(replace(given, counts=counts, noise_counts=noise), found)
    slope = one.slopes(one.start)
    rows = np.r_[: counts.size + one.poses]  # readings, and the prior of the pose
    normal, pose = slope[rows].T @ slope[rows], one.poses
    across = normal[pose:, :pose]
    return normal[pose:, pose:] - across @ np.linalg.solve(normal[:pose, :pose], across.T)
