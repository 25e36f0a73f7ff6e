"""Places guessed from the resting level alone: why locations on some recordings must be read with care."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from estimator.recordings.reading import Recording


@dataclass(frozen=True)
class RestOffsetBaseline:
    """Share of contact cases guessed from the raw rest level alone, before any press.

    Nearest case mean over the training presses, judged on the test presses. Whatever an estimator
    scores on location must be read beside this: sessions, and with them places, have their own
    rest levels. `chance` is 1 over the number of cases.
    """

    accuracy: float
    chance: float
    presses: int


def rest_offset_baseline(
    recordings: Sequence[Recording], seed: int, train_share: float = 0.6
) -> RestOffsetBaseline:
    """Contact case guessed from the raw counts at rest before each press.

    Raises
    ------
    InputError
        Some case has fewer than two presses.
    """
    level, case = _rest_levels(recordings)
    rng = np.random.default_rng(seed)
    train = np.zeros(len(case), dtype=bool)
    for name in np.unique(case):
        members = rng.permutation(np.flatnonzero(case == name))
        if len(members) < 2:
            raise InputError(
                f"contact case {name} has one press; this baseline needs at least two of each. Add "
                "recordings"
            )
        train[members[: min(len(members) - 1, max(1, round(train_share * len(members))))]] = True
    names = np.unique(case)
    means = np.array([level[train & (case == name)].mean(axis=0) for name in names])
    distance = np.linalg.norm(level[~train, None] - means, axis=2)
    guess = names[distance.argmin(axis=1)]
    return RestOffsetBaseline(
        float(np.mean(guess == case[~train])), 1 / len(names), int(np.sum(~train))
    )


def _rest_levels(
    recordings: Sequence[Recording],
) -> tuple[Float[np.ndarray, "press channel"], Int[np.ndarray, "press"]]:
    """Raw rest level of each press with contacts, live channels only, and its contact case."""
    places = sorted({place for recording in recordings for place in recording.report.places})
    levels, cases = [], []
    for recording in recordings:
        frames = recording.frames
        for press, level in enumerate(recording.rest_counts):
            ids = frames.place_id[(frames.press_id == press) & (frames.place_id >= 0)]
            if len(ids):
                levels.append(level.ravel())
                cases.append(places.index(recording.report.places[ids[0]]))
    level = np.array(levels)
    return level[:, np.isfinite(level).all(axis=0)], np.array(cases)
