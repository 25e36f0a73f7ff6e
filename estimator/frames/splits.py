"""Splits of a data set into training, validation and test parts that share no press.

Neighbouring frames of one press are nearly equal, so a random split of frames measures memory,
not generalisation: it exists for comparison with Knopke et al. (RA-L 2024) alone, under its own
name. Rest frames travel with the press that they belong to.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Int

from design.errors import InputError
from estimator.frames.dataset import FrameSet

SHARES = (0.6, 0.2, 0.2)
"""Shares of the presses for training, validation and test."""


@dataclass(frozen=True)
class Split:
    """Masks over the frames; every frame is in exactly one part."""

    train: Bool[np.ndarray, "frame"]
    validation: Bool[np.ndarray, "frame"]
    test: Bool[np.ndarray, "frame"]


def split_presses(frames: FrameSet, seed: int) -> Split:
    """Whole presses, each contact case divided by `SHARES`.

    Of a case with two presses one trains, and the other one validates or tests; cases of a single
    press are pooled. So every case with two presses or more is trained on, and the test holds new
    presses of known cases (and those single presses that fell to it).

    Raises
    ------
    InputError
        Fewer than three presses.
    """
    presses, places = press_places(frames)
    _check_enough(len(presses), "presses")
    names, counts = np.unique(places, return_counts=True)
    rng = np.random.default_rng(seed)
    part = np.zeros(len(presses), dtype=int)
    for case in names[counts >= 3]:
        members = np.flatnonzero(places == case)
        part[rng.permutation(members)] = split_parts(len(members))
    pairs = [np.flatnonzero(places == case) for case in names[counts == 2]]
    spare = rng.permutation([int(rng.choice(pair)) for pair in pairs]).astype(int)
    validating = round(len(spare) * SHARES[1] / (SHARES[1] + SHARES[2]))
    part[spare] = np.where(np.arange(len(spare)) < validating, 1, 2)
    single = np.isin(places, names[counts == 1])
    pooled = rng.permutation(np.flatnonzero(single))
    part[pooled] = split_parts(len(pooled))
    return _split_of_groups(frames.press_id, presses, fill_empty(part, single))


def only_trained_places(frames: FrameSet, split: Split) -> bool:
    """Return whether every held-out press lies at a place of the training."""
    trained, tested = (
        set(np.unique(frames.place_id[part & frames.valid & (frames.place_id >= 0)]).tolist())
        for part in (split.train, split.test)
    )
    return tested <= trained


def split_places(frames: FrameSet, seed: int) -> Split:
    """Whole contact cases, so that tested places were never trained on.

    Raises
    ------
    InputError
        Fewer than three contact cases.
    """
    presses, places = press_places(frames)
    cases = np.unique(places[places >= 0])
    _check_enough(len(cases), "contact cases")
    rng = np.random.default_rng(seed)
    part_of_case = dict(
        zip(rng.permutation(cases).tolist(), split_parts(len(cases)).tolist(), strict=True)
    )
    part = np.array([part_of_case.get(int(place), 0) for place in places])
    return _split_of_groups(frames.press_id, presses, part)


def split_paper_random_frames(frames: FrameSet, seed: int) -> Split:
    """The paper's split: single frames at random, so that every press is in every part.

    Raises
    ------
    InputError
        Fewer than three frames.
    """
    _check_enough(len(frames), "frames")
    part = np.empty(len(frames), dtype=int)
    part[np.random.default_rng(seed).permutation(len(frames))] = split_parts(len(frames))
    return Split(part == 0, part == 1, part == 2)


def press_places(frames: FrameSet) -> tuple[Int[np.ndarray, "press"], Int[np.ndarray, "press"]]:
    """Press ids, and the contact case that each press shows most (-1 if it is only rest)."""
    presses, index = np.unique(frames.press_id, return_inverse=True)
    places = np.full(len(presses), -1)
    pressed = frames.place_id >= 0
    cases, case_index = np.unique(frames.place_id[pressed], return_inverse=True)
    if len(cases) == 0:
        return presses, places
    counts = np.zeros((len(presses), len(cases)), dtype=int)
    np.add.at(counts, (index[pressed], case_index), 1)
    return presses, np.where(counts.any(axis=1), cases[counts.argmax(axis=1)], -1)


def split_parts(count: int) -> Int[np.ndarray, "n"]:
    """Part (0 train, 1 validation, 2 test) of each of `count` members; none empty from three on."""
    sizes = np.floor(np.asarray(SHARES) * count + 1e-9).astype(int)
    remainder = np.asarray(SHARES) * count - sizes
    for part in np.argsort(-remainder, kind="stable")[: count - sizes.sum()]:
        sizes[part] += 1
    for part in range(3):
        if count >= 3 and sizes[part] == 0:
            sizes[np.argmax(sizes)] -= 1
            sizes[part] = 1
    return np.repeat(np.arange(3), sizes)


def fill_empty(
    part: Int[np.ndarray, "press"], single: Bool[np.ndarray, "press"]
) -> Int[np.ndarray, "press"]:
    """Move one press into each part that is empty, the only one of its case where there is one."""
    part = part.copy()
    for missing in sorted(set(range(3)) - set(part.tolist())):
        crowded = part == np.bincount(part, minlength=3).argmax()
        spared = crowded & single if np.any(crowded & single) else crowded
        part[np.flatnonzero(spared)[-1]] = missing
    return part


def _split_of_groups(
    frame_group: Int[np.ndarray, "frame"],
    groups: Int[np.ndarray, "group"],
    part: Int[np.ndarray, "group"],
) -> Split:
    masks = [np.isin(frame_group, groups[part == number]) for number in range(3)]
    return Split(*masks)


def _check_enough(count: int, what: str) -> None:
    if count < 3:
        raise InputError(
            f"a split into training, validation and test needs at least 3 {what}; got {count}. "
            "Add recordings or simulate more presses"
        )
