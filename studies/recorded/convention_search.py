"""Discrete conventions of a recording: order of chips, labels turned or mirrored, axes of the chips.

Every candidate is one of 8 symmetries of a face's labels, 6 orders of its three chips in the columns,
and 24 turns of their axes (the same for all chips): 1152 a face. It is chosen by the mean cosine
over the presses of one recording and judged on another. Its null is the whole search with the places
exchanged among the presses of both recordings, so that p is corrected for the search.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import permutations

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.adoption.convention import TURNS
from estimator.adoption.findings import share_as_high
from estimator.calibration.recorded_presses import RecordedPresses, own_channels
from estimator.field.models import magnets_model
from estimator.signals.field_setup import min_distance_mm
from estimator.tolerances.assembly import counts_of, designed
from fem.linear.response import ResponseOperator
from fem.presses.joint import Tip, press_path
from studies.recorded.interface_fits import DEPTHS_MM, motions_on_curves

SYMMETRIES = tuple(
    np.array(matrix)
    for matrix in (
        [[1, 0], [0, 1]], [[0, -1], [1, 0]], [[-1, 0], [0, -1]], [[0, 1], [-1, 0]],
        [[-1, 0], [0, 1]], [[1, 0], [0, -1]], [[0, 1], [1, 0]], [[0, -1], [-1, 0]],
    )
)  # fmt: skip
"""The labels as they are, turned by 90, 180 and 270°, mirrored in four lines."""
ORDERS = tuple(permutations(range(3)))
CANDIDATES = len(SYMMETRIES) * len(ORDERS) * len(TURNS)
"""Of a face."""


@dataclass(frozen=True)
class Found:
    """A search: cosine as documented and of the candidate chosen, on the recording it was chosen on
    and on the other; numbers of its symmetry, order and turn (all 0: as documented)."""

    documented_chosen_on: float
    documented: float
    chosen_on: float
    judged: float
    candidate: tuple[int, int, int]
    null_median: float
    p: float


def predicted_changes(
    spec: ObjectSpec, response: ResponseOperator, presses: RecordedPresses
) -> Float[np.ndarray, "symmetry press case channel"]:
    """Counts of every press as every case, the labels of all faces under each symmetry."""
    design, found, model = designed(spec), [], None
    count, cases = len(presses), len(presses.cases)
    depths = np.array(DEPTHS_MM)[:, None]
    for symmetry in SYMMETRIES:
        curves = []
        for case in presses.cases:
            tips = [Tip(face, *(symmetry @ np.array([x, y])).tolist()) for face, x, y in case]
            curves.append(press_path(spec, response, tips, depths * np.ones(len(tips))))
        moving = motions_on_curves(presses, curves)
        every = np.stack(
            [moving.motion_of_cases(np.full(count, case), 1.0) for case in range(cases)], axis=1
        )
        every = every.reshape(count * cases, *every.shape[2:])
        if model is None:
            nearest = min_distance_mm(design.scene, np.nan_to_num(every))
            model = magnets_model(spec.magnets, nearest)
        rest = counts_of(spec, design.scene, np.zeros((1, *every.shape[1:])), model)[0]
        change = counts_of(spec, design.scene, every, model) - rest
        found.append(change.reshape(count, cases, -1))
    return np.stack(found)


def search_face(
    spec: ObjectSpec,
    presses: RecordedPresses,
    predicted: Float[np.ndarray, "symmetry press case channel"],
    face: int,
    choose_on: int,
    exchanges: int,
) -> Found:
    """Search the conventions of one pressed face over its own chips; those with a dead axis count nothing.

    Raises
    ------
    InputError
        A face without three chips of three axes, or without one that answers on all of them.
    """
    own = own_channels(spec, face)
    if len(own) != 9:
        raise InputError(
            f"conventions are searched for three chips of three axes per face; face {face} has "
            f"{len(own)} channels. Give an object with sensors.count_per_face = 3"
        )
    rows = presses.face_of_case(face)[presses.case]
    recorded = presses.signal_counts[rows][:, own].reshape(-1, 3, 3)
    if not _answering(recorded).any():
        raise InputError(
            f"no chip of face {face} answers on all three axes in every press: its conventions cannot be "
            "searched. Leave its presses out, or mend the chip"
        )
    model = predicted[:, rows][..., own].reshape(*predicted[:, rows].shape[:3], 3, 3)
    every = cosines(recorded, model)
    return search(
        every, presses.case[rows], presses.recording[rows], choose_on, exchanges, spec.seed
    )


def cosines(
    recorded: Float[np.ndarray, "press 3 3"],
    predicted: Float[np.ndarray, "symmetry press case 3 3"],
) -> Float[np.ndarray, "symmetry order turn press case"]:
    """Of every candidate, were each press any of the cases; over chips without a NaN in any press."""
    live = _answering(recorded)
    seen = np.where(live[:, None], recorded, 0.0)
    power = np.square(predicted).sum(axis=4)
    found, size = [], []
    for order in map(list, ORDERS):
        found.append(np.einsum("pca,spkcb->spkab", seen[:, order], predicted))
        size.append(np.sqrt(power @ live[order]))
    turned = np.einsum("sopkab,tab->sotpk", np.stack(found, axis=1), np.stack(TURNS))
    of_model = np.stack(size, axis=1)[:, :, None]
    return turned / (np.linalg.norm(seen, axis=(1, 2))[:, None] * of_model)


def _answering(recorded: Float[np.ndarray, "press 3 3"]) -> Bool[np.ndarray, "3"]:
    return np.all(np.isfinite(recorded), axis=(0, 2))


def search(
    every: Float[np.ndarray, "symmetry order turn press case"],
    case: Int[np.ndarray, "press"],
    recording: Int[np.ndarray, "press"],
    choose_on: int,
    exchanges: int,
    seed: int,
) -> Found:
    """Choose on one recording, judge on the others; exchanges of the cases within each recording."""
    rng = np.random.default_rng((seed, 11))
    shape = every.shape[:3]
    first = np.flatnonzero(recording == choose_on)
    other = np.flatnonzero(recording != choose_on)

    def judged(place: np.ndarray) -> tuple[float, float, int]:
        chosen = every[..., first, place[first]].mean(axis=-1).ravel()
        best = int(np.argmax(chosen))
        left = every[..., other, place[other]].mean(axis=-1).ravel()
        return float(chosen[best]), float(left[best]), best

    on, off, best = judged(case)
    null = [judged(exchanged_places(case, recording, rng))[1] for _ in range(exchanges)]
    documented = every[0, 0, unturned_labels()]
    return Found(
        float(documented[first, case[first]].mean()),
        float(documented[other, case[other]].mean()),
        on,
        off,
        tuple(int(k) for k in np.unravel_index(best, shape)),  # pyright: ignore[reportArgumentType]
        float(np.median(null)),
        share_as_high(null, off),
    )


def unturned_labels() -> int:
    return next(k for k, turn in enumerate(TURNS) if np.array_equal(turn, np.eye(3)))


def exchanged_places(
    case: Int[np.ndarray, "press"], recording: Int[np.ndarray, "press"], rng: np.random.Generator
) -> Int[np.ndarray, "press"]:
    """The cases of every recording exchanged among themselves."""
    new = case.copy()
    for number in np.unique(recording):
        own = np.unique(case[recording == number])
        into = dict(zip(own.tolist(), rng.permutation(own).tolist(), strict=True))
        rows = recording == number
        new[rows] = [into[one] for one in case[rows].tolist()]
    return new
