"""Recorded presses against several interfaces of shell and core: bonded, or with friction.

Every set of places that was pressed together is pressed together in the model too, all tips equally
deep, on the same mesh with every interface. Figures and their nulls are those of
`estimator.calibration.validation`. Whether one interface is preferred is told by the difference of
their cosines, press by press, beside the same difference with the places exchanged.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from jaxtyping import Float, Int

from design.spec.object import ObjectSpec
from estimator.calibration.recorded_presses import (
    MODULUS_RATIOS,
    Contact,
    PredictedMotions,
    RecordedPresses,
    own_channels,
    pressed_faces,
)
from estimator.calibration.validation import (
    Agreement,
    Predictions,
    agreement,
    case_permutations,
    predict,
)
from estimator.field.models import magnets_model
from estimator.signals.field_setup import min_distance_mm
from estimator.tolerances.assembly import designed
from fem.presses.joint import JointPress, Tip, press_path
from studies.loose_core.press import LooseCore, press_loose
from studies.loose_core.response import LooseShell

DEPTHS_MM = (0.5, 1.0, 1.5, 2.0, 3.0, 4.0)
_MOST_SIGNED = 12
INTERFACES: dict[str, LooseCore | None] = {
    "bonded": None,
    "friction 0.05": LooseCore(0.05),
    "friction 0.3": LooseCore(0.3),
    "friction 1": LooseCore(1.0),
    "friction 0.5, 0.2 mm larger core": LooseCore(0.5, 0.2),
}
"""None is a bonded core. 0.05 stands for none: without any, what little holds the shell on its core
takes the iteration many times as long, for forces about 1 % lower."""


@dataclass(frozen=True)
class InterfaceAgreement:
    """One interface against the recordings.

    `travel_mm` is the median travel at which the model bears the recorded forces, `force_at_2_mm` the
    median over the cases of the mean force of a face there, N.
    """

    name: str
    agreements: tuple[Agreement, ...]
    cosine: Float[np.ndarray, "press case"]
    force_at_2_mm: float
    travel_mm: float


@dataclass(frozen=True)
class Preference:
    """Mean over presses of how much larger the cosine of own faces is with `name` than with `other`.

    Both p are two-sided. `p_places` is the share of exchanges of the places, the true order among
    them, that make a difference at least as large: low where the gain belongs to the places pressed.
    `p_cases` is that of changed signs of the cases' own differences: low where the cases agree.
    `better` of the `cases` gain.
    """

    name: str
    other: str
    difference: float
    null_spread: float
    p_places: float
    p_cases: float
    better: int
    cases: int

    def corrected_p(self, tried: int) -> float:
        """The larger p, corrected for so many interfaces that were tried (Bonferroni)."""
        return min(1.0, tried * max(self.p_places, self.p_cases))


def interface_agreement(
    spec: ObjectSpec,
    shell: LooseShell,
    presses: RecordedPresses,
    name: str,
    core: LooseCore | None,
) -> InterfaceAgreement:
    """Press every case with one interface and compare with the recordings."""
    curves = [_curve(spec, shell, core, case) for case in presses.cases]
    moving = motions_on_curves(presses, curves)
    design = designed(spec)
    rest = np.zeros(moving.motion.shape[3:])
    every = np.concatenate([press.motion for curve in curves for press in curve])
    model = magnets_model(
        spec.magnets,
        min_distance_mm(design.scene, every.reshape(-1, *rest.shape)),
    )
    predictions = predict(spec, design, moving, rest, model)
    faces = (*pressed_faces(presses), None)
    found = tuple(agreement(spec, presses, predictions, face, spec.seed) for face in faces)
    at_2 = [np.interp(2.0, [0.0, *DEPTHS_MM], [0.0, *_forces(curve)]) for curve in curves]
    travel = [
        np.interp(force, [0.0, *_forces(curves[case])], [0.0, *DEPTHS_MM])
        for force, case in zip(mean_force_n(presses), presses.case, strict=True)
    ]
    return InterfaceAgreement(
        name,
        found,
        own_cosine(spec, presses, predictions),
        float(np.median(at_2)),
        float(np.median(travel)),
    )


def preference(
    presses: RecordedPresses, one: InterfaceAgreement, other: InterfaceAgreement, seed: int
) -> Preference:
    """Return which of two interfaces the recordings speak for."""
    gain = one.cosine - other.cosine
    order = case_permutations(gain[..., None], presses.case, seed)
    rows = np.arange(len(presses))
    means = np.array([gain[rows, places[presses.case]].mean() for places in order])
    true = gain[rows, presses.case]
    by_case = np.array([true[presses.case == case].mean() for case in np.unique(presses.case)])
    signs = np.array(list(product((1, -1), repeat=min(len(by_case), _MOST_SIGNED))))
    turned = abs(signs @ by_case[: signs.shape[1]])
    return Preference(
        one.name,
        other.name,
        float(means[0]),
        float(means.std()),
        float(np.mean(abs(means) >= abs(means[0]) - 1e-12)),
        float(np.mean(turned >= turned[0] - 1e-12)),
        int(np.sum(by_case > 0)),
        len(by_case),
    )


def _curve(
    spec: ObjectSpec, shell: LooseShell, core: LooseCore | None, case: Sequence[Contact]
) -> tuple[JointPress, ...]:
    tips = [Tip(*contact) for contact in case]
    depths = np.array(DEPTHS_MM)[:, None] * np.ones(len(tips))
    if core is None:
        return press_path(spec, shell.bonded, tips, depths)
    return tuple(press.joint for press in press_loose(spec, shell, core, tips, depths))


def _forces(curve: Sequence[JointPress]) -> list[float]:
    """Mean force of a pressed face at every depth, N."""
    faces = len({tip.face for tip in curve[0].tips})
    return [float(press.force_n.sum() / faces) for press in curve]


def mean_force_n(presses: RecordedPresses) -> Float[np.ndarray, "press"]:
    pressed = presses.face_force_n > 0
    return presses.face_force_n.sum(axis=1) / np.maximum(pressed.sum(axis=1), 1)


def motions_on_curves(
    presses: RecordedPresses, curves: Sequence[Sequence[JointPress]]
) -> PredictedMotions:
    """Motions at the recorded forces, in proportion to force beyond the deepest press."""
    body = curves[0][0].motion.shape
    shape = (len(presses), len(curves), len(MODULUS_RATIOS))
    motion, beyond = np.full((*shape, *body), np.nan), np.zeros(shape, bool)
    newton = mean_force_n(presses)[:, None] / MODULUS_RATIOS
    for number, curve in enumerate(curves):
        force = np.array([0.0, *_forces(curve)])
        states = np.stack([np.zeros(body), *(press.motion for press in curve)])
        at = _linear(force, states.reshape(len(states), -1))
        reached = np.minimum(newton, force[-1])
        extended = newton / np.maximum(reached, 1e-12)
        motion[:, number] = at(reached).reshape(*newton.shape, *body) * extended[..., None, None]
        beyond[:, number] = newton > force[-1]
        faces = np.zeros(presses.face_force_n.shape[1], bool)
        faces[[tip.face - 1 for tip in curve[0].tips]] = True
        motion[np.any((presses.face_force_n > 0) != faces, axis=1), number] = np.nan
    return PredictedMotions(motion, beyond)


def _linear(
    force: Float[np.ndarray, "step"], states: Float[np.ndarray, "step value"]
) -> Callable[[np.ndarray], np.ndarray]:
    def at(newton: np.ndarray) -> np.ndarray:
        place = np.interp(newton, force, np.arange(len(force)))
        low = np.minimum(place.astype(int), len(force) - 2)
        share = (place - low)[..., None]
        return (1 - share) * states[low] + share * states[low + 1]

    return at


def own_cosine(
    spec: ObjectSpec, presses: RecordedPresses, predictions: Predictions
) -> Float[np.ndarray, "press case"]:
    """Of every press as every case, over the live channels of the faces that it presses."""
    cosine = np.zeros(predictions.counts.shape[:2])
    for row in range(len(presses)):
        own = _channels(spec, presses, row)
        recorded = presses.signal_counts[row, own]
        predicted = predictions.counts[row][:, own]
        size = np.linalg.norm(recorded) * np.linalg.norm(predicted, axis=1)
        cosine[row] = predicted @ recorded / size
    return cosine


def _channels(spec: ObjectSpec, presses: RecordedPresses, row: int) -> Int[np.ndarray, "channel"]:
    pressed = np.flatnonzero(presses.face_force_n[row] > 0) + 1
    own = np.concatenate([own_channels(spec, int(face)) for face in pressed])
    return own[np.isfinite(presses.signal_counts[row, own])]
