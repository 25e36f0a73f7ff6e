"""Calibration of nuisances on recorded presses: pose of the core in the shell, remanence, modulus.

Eight numbers with Gaussian priors, fitted by least squares to the mean recorded changes of each
case. A fit with eight numbers can follow almost anything, so it is judged on presses that it has
not seen, and by what the same procedure reaches with the places exchanged.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.positions import slipped
from design.spec.mechanics import SlipSpec
from design.spec.object import ObjectSpec
from estimator.calibration.most_probable import Unknown, Values, most_probable
from estimator.calibration.recorded_presses import (
    PredictedMotions,
    RecordedPresses,
    own_channels,
    pressed_faces,
)
from estimator.field.models import MagnetsModel
from estimator.tolerances.assembly import Assembly, counts_of

LARGEST_SHIFT_MM = 3.0
"""Largest shift of each coordinate in a fit; sensors come nearer to magnets by about this at most."""
CORE = {
    "shift_mm": Unknown(1.0, (3,), bound=LARGEST_SHIFT_MM),
    "rotation_deg": Unknown(3.0, (3,), bound=10.0),
}
"""Pose of the core in the shell: its shift, and its rotation vector."""
REMANENCE = {"ln_remanence": Unknown(0.02, bound=0.1)}
"""Logarithm of the remanence's scale: a grade's range."""
MODULUS = {"ln_modulus": Unknown(0.5, bound=1.5)}
"""Logarithm of the modulus' scale."""
ALL = CORE | REMANENCE | MODULUS
GROUPS = {
    "pose of the core": CORE,
    "strength of the magnets": REMANENCE,
    "modulus, that is depth": MODULUS,
}
"""Unknowns that are freed by themselves."""
_FLOOR_COUNTS = 20.0
"""Error of the model, at least."""
_MODEL_ERROR = 0.2
"""Error of the model over the rms of the recorded signal."""
_EVALUATIONS = 15
"""Evaluations of a fit, at most."""


@dataclass(frozen=True)
class Calibration:
    """Nuisances of one object against its specification."""

    shift_mm: tuple[float, float, float]
    rotation_deg: tuple[float, float, float]
    remanence_scale: float
    modulus_scale: float

    @staticmethod
    def from_values(values: Values) -> Calibration:
        """Return the nuisances of unknowns of `ALL`; what is not among them is as designed."""
        x, y, z, a, b, c = np.concatenate([values.get(name, np.zeros(3)) for name in CORE]).tolist()
        scales = (float(np.exp(values.get(name, 0.0))) for name in REMANENCE | MODULUS)
        return Calibration((x, y, z), (a, b, c), *scales)

    def applied(self, design: Assembly) -> Assembly:
        """The design with what sits in the core moved, magnets and silicone scaled."""
        place, slip = design.scene, SlipSpec(shift_mm=self.shift_mm, rotation_deg=self.rotation_deg)
        magnets = replace(place.magnets, strength=place.magnets.strength * self.remanence_scale)
        if place.sensors_move:
            moved = replace(place, magnets=slipped(magnets, slip))
        else:
            moved = replace(place, magnets=magnets, sensors=slipped(place.sensors, slip))
        return replace(design, scene=moved, modulus_ratio=design.modulus_ratio * self.modulus_scale)


@dataclass(frozen=True)
class Judged:
    """Means over unseen presses: cosine of each face's own channels and of all, and the share of
    the recorded change (rms) that predictions leave, √Σ|r|²/Σ|S|²."""

    own_cosine: float
    all_cosine: float
    left_share: float


@dataclass(frozen=True)
class CalibrationTest:
    """Gain of calibration on unseen presses.

    `design` and `after` are without and with it; `null` the medians of the same procedure with the
    places exchanged (training and test alike), `p_*` the shares of these that do at least as well.
    """

    unseen: str
    design: Judged
    after: Judged
    null: Judged
    p_own_cosine: float
    p_left_share: float
    permutations: int


@dataclass(frozen=True)
class Problem:
    """Inputs that fits and tests share."""

    spec: ObjectSpec
    design: Assembly
    presses: RecordedPresses
    moving: PredictedMotions
    rest: Float[np.ndarray, "body 6"]
    model: MagnetsModel

    def predicted(
        self, assembly: Assembly, rows: Int[np.ndarray, "some"], case: Int[np.ndarray, "press"]
    ) -> Float[np.ndarray, "some channel"]:
        """Change of counts of some presses, each as a case."""
        ratio = float(np.clip(assembly.modulus_ratio, 0.2, 3.0))
        motion = self.moving.motion_of_cases(case, ratio, rows)
        states = np.concatenate([self.rest[None], motion])
        shown = counts_of(self.spec, assembly.scene, states, self.model)
        return (shown[1:] - shown[0]).reshape(len(rows), -1)


def fit(
    problem: Problem,
    rows: Int[np.ndarray, "some"],
    case: Int[np.ndarray, "press"],
    free: Mapping[str, Unknown] = ALL,
) -> Calibration:
    """Nuisances from some presses; `case` (of every press) may have been exchanged.

    What is not `free` stays at the design.
    """
    first, recorded, sigma = means_of_cases(problem, rows)
    is_recorded = np.isfinite(recorded)

    def misfit(values: Values) -> Float[np.ndarray, "residual"]:
        assembly = Calibration.from_values(values).applied(problem.design)
        return ((recorded - problem.predicted(assembly, first, case)) / sigma)[is_recorded]

    solution = most_probable(misfit, free, max_nfev=_EVALUATIONS, diff_step=1e-4)
    return Calibration.from_values(solution.values)


def groups_freed(problem: Problem) -> dict[str, Judged]:
    """Each group of numbers fitted by itself to all sets of places but one and judged on that one, in
    turn; that which leaves least first, with the design."""
    presses = problem.presses
    judged = {"the design": judged_pose(problem, folds_by_case(presses), presses.case, {})}
    for name, free in GROUPS.items():
        judged[name] = judged_pose(problem, folds_by_case(presses), presses.case, free)
    return dict(sorted(judged.items(), key=lambda item: item[1].left_share))


def means_of_cases(
    problem: Problem, rows: Int[np.ndarray, "some"]
) -> tuple[Int[np.ndarray, "case"], Float[np.ndarray, "case channel"], Float[np.ndarray, "case 1"]]:
    """One typical press (that of the median force) for each case, and the mean recorded change."""
    presses = problem.presses
    typical, means = [], []
    for case in np.unique(presses.case[rows]):
        same = rows[presses.case[rows] == case]
        force = presses.face_force_n[same].sum(axis=1)
        typical.append(same[np.argsort(force)[len(same) // 2]])
        means.append(presses.signal_counts[same].mean(axis=0))
    recorded = np.array(means)
    size = np.sqrt(np.nanmean(recorded**2, axis=1, keepdims=True))
    return np.array(typical), recorded, np.hypot(_FLOOR_COUNTS, _MODEL_ERROR * size)


def folds_by_case(presses: RecordedPresses) -> list[Int[np.ndarray, "some"]]:
    """Test presses of each fold: all of one case, whose places no fitted press has."""
    return [np.flatnonzero(presses.case == case) for case in range(len(presses.cases))]


def folds_by_press(presses: RecordedPresses) -> list[Int[np.ndarray, "some"]]:
    """Two folds, every other press of each case."""
    order = np.zeros(len(presses), int)
    for case in range(len(presses.cases)):
        same = np.flatnonzero(presses.case == case)
        order[same] = np.arange(len(same)) % 2
    return [np.flatnonzero(order == half) for half in range(2)]


def calibration_test(
    problem: Problem,
    unseen: str,
    folds: Sequence[Int[np.ndarray, "_"]],
    exchanged: Int[np.ndarray, "permutation case"],
    progress: Callable[[str], None] = lambda _: None,
) -> CalibrationTest:
    """Fit on all folds but one, judge on that one, in turn; and so with every exchange of places."""
    after = judged_pose(problem, folds, problem.presses.case, ALL)
    null = []
    for number, order in enumerate(exchanged):
        progress(f"{unseen}: places exchanged, {number + 1} of {len(exchanged)}")
        null.append(judged_pose(problem, folds, order[problem.presses.case], ALL))
    medians = [float(np.median([getattr(n, f) for n in null])) for f in Judged.__annotations__]
    cosine = [after.own_cosine, *(n.own_cosine for n in null)]
    left_shares = [after.left_share, *(n.left_share for n in null)]
    return CalibrationTest(
        unseen,
        judged_pose(problem, folds, problem.presses.case, {}),
        after,
        Judged(*medians),
        float(np.mean(np.array(cosine) >= after.own_cosine)),
        float(np.mean(np.array(left_shares) <= after.left_share)),
        len(exchanged),
    )


def judged_pose(
    problem: Problem,
    folds: Sequence[Int[np.ndarray, "_"]],
    case: Int[np.ndarray, "press"],
    free: Mapping[str, Unknown],
) -> Judged:
    presses = problem.presses
    predicted = np.empty(presses.signal_counts.shape)
    for test in folds:
        assembly = problem.design
        if free:
            train = np.setdiff1d(np.arange(len(presses)), test)
            assembly = fit(problem, train, case, free).applied(problem.design)
        predicted[test] = problem.predicted(assembly, test, case)
    recorded = presses.signal_counts
    predicted = np.where(np.isfinite(recorded), predicted, 0.0)
    recorded = np.nan_to_num(recorded)
    square_share = np.sum((recorded - predicted) ** 2) / np.sum(recorded**2)
    return Judged(
        mean_own_cosine(problem, recorded, predicted),
        float(np.mean(case_cosines(recorded, predicted))),
        float(np.sqrt(square_share)),
    )


def mean_own_cosine(
    problem: Problem,
    recorded: Float[np.ndarray, "press channel"],
    predicted: Float[np.ndarray, "press channel"],
) -> float:
    """Mean over presses and the faces that they press, own channels."""
    values = []
    for face in pressed_faces(problem.presses):
        rows = problem.presses.face_of_case(face)[problem.presses.case]
        face_channels = own_channels(problem.spec, face)
        values.append(
            case_cosines(recorded[rows][:, face_channels], predicted[rows][:, face_channels])
        )
    return float(np.mean(np.concatenate(values)))


def case_cosines(
    recorded: Float[np.ndarray, "some c"], predicted: Float[np.ndarray, "some c"]
) -> Float[np.ndarray, "some"]:
    size = np.linalg.norm(recorded, axis=1) * np.linalg.norm(predicted, axis=1)
    # Cosine of each case p over its channels c; 1e-12 avoids 0/0 where nothing is recorded.
    return np.einsum("pc,pc->p", recorded, predicted) / np.maximum(size, 1e-12)
