"""Grasps found in a force over time, and their phases: approach, closing, hold, release."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

START_N = 0.6
"""Total force from which two jaws are taken to touch: 0.3 N each, as load cells show a contact."""
HELD_N = 0.5 * START_N
"""Total force below which a grasp has ended: less than that of its start, so that noise ends nothing."""
PAUSE_S = 0.3
"""Time without force that ends a grasp; shorter ones belong to it."""
_LEAST_FRAMES = 4
"""Frames of a grasp above `START_N`, at least."""
HOLD_SHARE = 0.9
"""Share of the level from the first to the last frame of which the hold lasts."""
_LOST_SHARE = 0.5
"""Share of the level below which a grip counts as lost, and regained above it."""


@dataclass(frozen=True)
class Grasp:
    """Frame numbers of one grasp: half-open ranges [start, hold), [hold, release), [release, end).

    `approach` is the first frame after the grasp before, or of the recording. `level_n` is the
    force that is held, `regrasps` how often the grip was lost and taken again.
    """

    number: int
    approach: int
    start: int
    hold: int
    release: int
    end: int
    level_n: float
    regrasps: int


def find_grasps(
    time_s: Float[np.ndarray, "frame"], force_n: Float[np.ndarray, "frame"]
) -> list[Grasp]:
    """Number the grasps of a recording.

    A grasp starts where the total force exceeds half of `START_N`, on the way to more than that, and
    ends where it stays below it. Whether anything touches at all is what the estimator decides, whose
    error of scale must not hide a grasp. The level is the median of the forces above half the peak. The hold
    lasts from the first to the last frame above `HOLD_SHARE` of the level.
    """
    strong, held = force_n > START_N, force_n > HELD_N
    grasps: list[Grasp] = []
    free = 0
    for first, last in joined_runs(time_s, _runs(held), PAUSE_S):
        if strong[first:last].sum() >= _LEAST_FRAMES:
            grasps.append(_grasp(len(grasps) + 1, free, first, last, force_n))
            free = last
    return grasps


def _grasp(
    number: int, approach: int, first: int, last: int, force_n: Float[np.ndarray, "frame"]
) -> Grasp:
    grasped = force_n[first:last]
    level = float(np.median(grasped[grasped >= 0.5 * grasped.max()]))
    full = first + np.flatnonzero(grasped >= HOLD_SHARE * level)
    regrasps = len(_runs(grasped >= _LOST_SHARE * level)) - 1
    hold, release = int(full[0]), int(full[-1]) + 1
    return Grasp(number, approach, first, hold, release, last, level, regrasps)


def joined_runs(
    time_s: Float[np.ndarray, "frame"], ranges: list[tuple[int, int]], pause_s: float
) -> list[tuple[int, int]]:
    """Join ranges of frames that a pause shorter than `pause_s` parts; where time runs back, none."""
    joined: list[tuple[int, int]] = []
    for first, last in ranges:
        if joined and 0 <= time_s[first] - time_s[joined[-1][1] - 1] < pause_s:
            joined[-1] = (joined[-1][0], last)
        else:
            joined.append((first, last))
    return joined


def _runs(mask: np.ndarray) -> list[tuple[int, int]]:
    """Half-open ranges in which a mask holds."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mask.astype(int), [0]])))
    return [(int(first), int(last)) for first, last in edges.reshape(-1, 2)]
