"""Resting levels beside the design: wrong conventions, and assemblies that differ by a few numbers.

Every candidate exchanges the boards of the faces, the chips of a board and the axes of a chip, the
latter two alike on all boards. Candidates are judged by the cosine over all channels, which does
not know sizes; the null is the whole search in levels exchanged among the channels. What a few
numbers common to all faces explain is fitted to all faces but one and judged on that one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import permutations
from math import factorial

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.optimize import least_squares

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.adoption.convention import TURNS
from estimator.adoption.findings import share_as_high
from estimator.calibration.pose_fit import Calibration
from estimator.field.models import MagnetsModel, magnets_model
from estimator.signals.field_setup import Scene, min_distance_mm, zero_motion
from estimator.tolerances.assembly import counts_of, designed, face_axes

MOST_CANDIDATES = 500_000
COMMON = {
    "nothing": (),
    "strength": (0,),
    "depth": (1,),
    "strength, depth": (0, 1),
    "core": (2, 3, 4, 5, 6, 7),
    "all": (0, 1, 2, 3, 4, 5, 6, 7),
}
"""Name → which of the numbers are fitted: ln of all magnets' strength, their distance from the core
(mm outwards), shift (mm) and rotation vector (degrees) of the core."""
PRIOR = np.array([0.3, 1.0, 1.0, 1.0, 1.0, 3.0, 3.0, 3.0])
"""Standard deviations, several times those of any careful assembly."""
BOUNDS = np.array([1.5, 3.0, 3.0, 3.0, 3.0, 10.0, 10.0, 10.0])
_SPREAD_COUNTS = 300.0
"""Of levels about a fitted object: offsets of the chips (±0.3 mT) and seats of single magnets."""


@dataclass(frozen=True)
class RestingSearch:
    """Cosine as documented and of the best candidate, the median best of the null, and two p.

    `p` is that of the best candidate, corrected for the search; `p_documented` that of the
    documented convention alone. `best` numbers its boards, chips and axes (all 0: as documented).
    """

    documented: float
    found: float
    best: tuple[int, int, int]
    candidates: int
    null_median: float
    p: float
    p_documented: float


@dataclass(frozen=True)
class CommonFit:
    """What numbers common to all faces leave of the levels (rms, 1: no field predicted at all).

    `left` is that of a fit to all faces, `left_elsewhere` that on each face of the fit to the others;
    `cosine_elsewhere` goes with the latter. `numbers` are those of the fit to all, in the order of
    `PRIOR`.
    """

    name: str
    left: float
    left_elsewhere: float
    cosine_elsewhere: float
    numbers: tuple[float, ...]


def search_resting(
    predicted: Float[np.ndarray, "channel"],
    levels: Float[np.ndarray, "channel"],
    faces: int,
    exchanges: int,
    seed: int,
) -> RestingSearch:
    """Search all candidates; chips with a channel that is NaN count nothing.

    Raises
    ------
    InputError
        More candidates than can be searched.
    """
    chips = len(levels) // (3 * faces)
    boards = np.array(list(permutations(range(faces))))
    count = len(boards) * factorial(chips) * len(TURNS)
    if count > MOST_CANDIDATES:
        raise InputError(
            f"{faces} faces of {chips} chips have {count} conventions, at most {MOST_CANDIDATES} are "
            "searched. Give an object with fewer chips on a face"
        )
    rng = np.random.default_rng((seed, 12))
    every = resting_cosines(predicted, levels, faces, boards)
    best = np.unravel_index(int(np.argmax(every)), every.shape)
    known = np.flatnonzero(np.isfinite(levels))
    null, alone = [], []
    for _ in range(exchanges):
        exchanged = levels.copy()
        exchanged[known] = levels[rng.permutation(known)]
        found = resting_cosines(predicted, exchanged, faces, boards)
        null.append(float(found.max()))
        alone.append(float(found[0, 0, 0]))
    return RestingSearch(
        documented=float(every[0, 0, 0]),
        found=float(every[best]),
        best=(int(best[0]), int(best[1]), int(best[2])),
        candidates=count,
        null_median=float(np.median(null)),
        p=share_as_high(null, float(every[best])),
        p_documented=share_as_high(alone, float(every[0, 0, 0])),
    )


def resting_cosines(
    predicted: Float[np.ndarray, "channel"],
    levels: Float[np.ndarray, "channel"],
    faces: int,
    boards: Int[np.ndarray, "exchange face"],
) -> Float[np.ndarray, "exchange order turn"]:
    """Of every candidate, over the chips that answer on all axes."""
    model = predicted.reshape(faces, -1, 3)
    seen = levels.reshape(faces, -1, 3)
    live = np.all(np.isfinite(seen), axis=2)
    seen = np.where(live[..., None], seen, 0.0)
    orders = [list(order) for order in permutations(range(seen.shape[1]))]
    product = np.stack(
        [np.einsum("fca,tab,gcb->fgt", seen[:, o], np.stack(TURNS), model) for o in orders]
    )
    power = np.stack([live[:, o].astype(float) @ (model**2).sum(axis=2).T for o in orders])
    at = np.arange(faces)
    above = product[:, at, boards].sum(axis=2)  # order, exchange, turn
    size = np.linalg.norm(seen) * np.sqrt(power[:, at, boards].sum(axis=2))
    return np.moveaxis(above / size[..., None], 0, 1)


class RestingObject:
    """Resting counts of an object with eight numbers common to all its faces."""

    def __init__(self, spec: ObjectSpec) -> None:
        self._spec, self._design = spec, designed(spec)
        place = self._design.scene
        self._outwards = face_axes(spec, place.magnets.face)[:, :, 2]
        self._model = near_model(spec, place)

    @property
    def designed_counts(self) -> Float[np.ndarray, "channel"]:
        """Expected counts at rest of the object as specified."""
        return self.counts(np.zeros(len(PRIOR)))

    def counts(self, numbers: Float[np.ndarray, "8"]) -> Float[np.ndarray, "channel"]:
        """The same with the numbers in the order of `PRIOR`."""
        strength, depth_mm, *pose = numbers.tolist()
        core = Calibration(tuple(pose[:3]), tuple(pose[3:]), float(np.exp(strength)), 1.0)
        place = core.applied(self._design).scene
        further = place.magnets.centre_mm + depth_mm * self._outwards
        moved = replace(place, magnets=replace(place.magnets, centre_mm=further))
        return counts_of(self._spec, moved, zero_motion(moved), self._model)[0].ravel()


def near_model(spec: ObjectSpec, place: Scene) -> MagnetsModel:
    """A field that is right where bounds bring a chip and a magnet together, if ever."""
    nearest = min_distance_mm(place, zero_motion(place)) - BOUNDS[1] - np.linalg.norm(BOUNDS[2:5])
    return magnets_model(spec.magnets, max(float(nearest), 1.0))


def common_fits(
    spec: ObjectSpec,
    levels: Float[np.ndarray, "channel"],
    faces: int,
    names: tuple[str, ...] = tuple(COMMON),
) -> Iterator[CommonFit]:
    """Fit the named sets of numbers of `COMMON`; channels that are NaN count nothing.

    Raises
    ------
    InputError
        Sensors in the shell: the numbers are those of magnets in the shell and a core of sensors.
    """
    if spec.arrangement != "sensors-in-core":
        raise InputError(
            f"resting levels are fitted for sensors in the core; {spec.name} has them in the shell"
        )
    whole, known = RestingObject(spec), np.isfinite(levels)
    face = np.arange(len(levels)) // (len(levels) // faces)
    for name in names:
        free = COMMON[name]
        numbers = _fitted(whole, levels, known, free)
        elsewhere = np.empty(len(levels))
        for one in range(faces):
            others = _fitted(whole, levels, known & (face != one), free)
            elsewhere[face == one] = whole.counts(others)[face == one]
        seen, size = levels[known], np.linalg.norm(levels[known])
        yield CommonFit(
            name,
            float(np.linalg.norm(seen - whole.counts(numbers)[known]) / size),
            float(np.linalg.norm(seen - elsewhere[known]) / size),
            float(seen @ elsewhere[known] / size / np.linalg.norm(elsewhere[known])),
            tuple(numbers.tolist()),
        )


def _fitted(
    whole: RestingObject,
    levels: Float[np.ndarray, "channel"],
    used: Bool[np.ndarray, "channel"],
    free: tuple[int, ...],
) -> Float[np.ndarray, "8"]:
    """The most probable numbers, those that are not free at the design."""
    chosen = list(free)
    if not chosen:
        return np.zeros(len(PRIOR))

    def all_numbers(values: np.ndarray) -> np.ndarray:
        numbers = np.zeros(len(PRIOR))
        numbers[chosen] = values
        return numbers

    def residual(values: np.ndarray) -> np.ndarray:
        off = (whole.counts(all_numbers(values)) - levels)[used] / _SPREAD_COUNTS
        return np.concatenate([off, values / PRIOR[chosen]])

    found = least_squares(
        residual,
        np.zeros(len(chosen)),
        bounds=(-BOUNDS[chosen], BOUNDS[chosen]),
        diff_step=1e-3,
        ftol=1e-4,
        xtol=1e-4,
        max_nfev=30,
    )
    return all_numbers(found.x)
