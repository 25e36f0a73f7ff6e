"""The nearest object to a log: pose, scale of travel, magnets, order and axes of chips.

Ten numbers at most are common to all chips, so that nothing but order and axes is free for one of them. They
are fitted to some of the places pressed, and to the field at rest, and judged on the other places.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.optimize import least_squares

from design.errors import InputError
from estimator.adoption.convention import Convention, best_convention
from estimator.calibration.known_travel.agreement import TravelAgreement, agreement_of, figures
from estimator.calibration.known_travel.model import SYMMETRIES, Pose, TravelModel
from estimator.field.models import MagnetsModel
from estimator.signals.field_setup import Scene, sensed_field, zero_motion

CHANGE_ERROR, RESTING_ERROR = 0.12, 0.06
"""Shares of the rms change, and of the field at rest, that models of printed objects leave."""
SCALES = (3.0, 3.0, 0.1, 1.0, 0.3, 0.3, 1.0, 1.0, 1.0)
"""Sizes: shift (two, mm), turn (rad), contact (mm), ln travel scale, ln strength, magnets' shift (mm)."""
PRIOR = 3.0
"""Standard deviations of all numbers, in these sizes."""
BEYOND_MM = 1.0
"""Travel beyond which a press is judged by itself."""
_CONTACTS_MM = (0.5, 3.0)
"""Heights above the zero of travel at which contact is first assumed."""
_KEPT, _ROUNDS = 3, 30
_ALIKE = 1.05
"""Ratio of costs up to which two fits are alike."""

Motion = Callable[
    [Float[np.ndarray, "press 2"], Float[np.ndarray, "press"], Float[np.ndarray, "extra"]],
    Float[np.ndarray, "press body 6"],
]


@dataclass(frozen=True)
class Pressed:
    """Presses of one face by a machine: places (mm, on its grid), travel (mm), and readings (mT)."""

    xy_mm: Float[np.ndarray, "press 2"]
    travel_mm: Float[np.ndarray, "press"]
    place: Int[np.ndarray, "press"]
    change_mt: Float[np.ndarray, "press chip 3"]
    resting_mt: Float[np.ndarray, "chip 3"]

    @property
    def complete(self) -> Pressed:
        """Presses in which every chip answered."""
        return self.select(np.flatnonzero(np.isfinite(self.change_mt).all(axis=(1, 2))))

    def select(self, rows: np.ndarray) -> Pressed:
        """Some of the presses."""
        return replace(
            self,
            xy_mm=self.xy_mm[rows],
            travel_mm=self.travel_mm[rows],
            place=self.place[rows],
            change_mt=self.change_mt[rows],
        )


@dataclass(frozen=True)
class Moving:
    """An object whose shell's bodies move as `motion` says, by numbers of its own beyond `SCALES`.

    `deepest_mm` is the travel up to which motions are known.
    """

    scene: Scene
    field: MagnetsModel
    motion: Motion
    deepest_mm: float
    extra: tuple[float, ...] = ()

    @classmethod
    def from_table(cls, model: TravelModel) -> Moving:
        """Motions of the simulated presses."""

        def motion(xy: np.ndarray, travel: np.ndarray, extra: np.ndarray) -> np.ndarray:
            return model.motion(xy, travel)

        return cls(model.scene, model.field, motion, float(model.travel_mm[-1]))

    def field_mt(
        self, scene: Scene, motion: Float[np.ndarray, "press body 6"]
    ) -> Float[np.ndarray, "press sensor 3"]:
        """Flux density along the chips' axes, mT."""
        # T → mT along each chip's axes: s sensor, j coordinate, i chip axis, n press
        field_t = sensed_field(scene, motion, self.field)
        return 1e3 * np.einsum("sij,nsj->nsi", scene.sensors.axes, field_t)


@dataclass(frozen=True)
class ObjectFit:
    """An object fitted to presses: the machine's axes, numbers in units of `SCALES`, and the chips."""

    thing: Moving
    symmetry: int
    numbers: Float[np.ndarray, "number"]
    convention: Convention

    @property
    def pose(self) -> Pose:
        """Pose of the object under the machine."""
        x, y, turn, contact = self.numbers[:4] * SCALES[:4]
        return Pose(np.array([x, y]), float(turn), float(contact), self.symmetry)

    @property
    def mirrored(self) -> bool:
        """Return whether the machine's axes are a mirror image of the object's."""
        return bool(np.linalg.det(SYMMETRIES[self.symmetry]) < 0)

    @property
    def travel_scale(self) -> float:
        """Travel of the shell per travel of the machine."""
        return float(np.exp(SCALES[4] * self.numbers[4]))

    @property
    def strength(self) -> float:
        """Factor on the magnets' polarization."""
        return float(np.exp(SCALES[5] * self.numbers[5]))

    @property
    def magnet_shift_mm(self) -> Float[np.ndarray, "3"]:
        """Shift of all magnets off the design, in the object's frame."""
        return self.numbers[6:9] * SCALES[6:9]

    def shell_presses(self, pressed: Pressed) -> tuple[np.ndarray, Float[np.ndarray, "press"]]:
        """Places in the face's frame and travel of the shell beyond the first contact, mm."""
        tip = np.column_stack([pressed.xy_mm, -pressed.travel_mm])
        xy, travel = self.pose.locate_tips(tip)
        return xy, self.travel_scale * np.maximum(travel, 0.0)

    def predicted(
        self, pressed: Pressed
    ) -> tuple[Float[np.ndarray, "press sensor 3"], Float[np.ndarray, "sensor 3"]]:
        """Changes of the presses and the field at rest, mT, in the order and along the axes of the design."""
        xy, travel = self.shell_presses(pressed)
        magnets = self.thing.scene.magnets
        moved = replace(magnets, centre_mm=magnets.centre_mm + self.magnet_shift_mm)
        scene = replace(self.thing.scene, magnets=moved)
        extra = self.numbers[len(SCALES) :] * np.array(self.thing.extra)
        motion = self.thing.motion(xy, travel, extra)
        still = self.thing.field_mt(scene, zero_motion(scene))
        change = self.thing.field_mt(scene, motion) - still
        return self.strength * change, self.strength * still[0]

    def recorded(self, pressed: Pressed) -> np.ndarray:
        """Recorded changes in the order and along the axes of the design, mT."""
        return self.convention.designed(pressed.change_mt)


def fit_object(thing: Moving, pressed: Pressed, kept: int = _KEPT) -> ObjectFit:
    """Fit an object: every symmetry of the machine's axes is tried, the best `kept` are refined.

    Raises
    ------
    InputError
        The designed object cannot be pressed so.
    """
    return _best(_starts(thing, pressed)[:kept], pressed)[1]


def fit_both_hands(thing: Moving, pressed: Pressed) -> tuple[ObjectFit, ObjectFit | None]:
    """Fit an object, and its mirror image where that leaves as little: a log of places has no handedness.

    Of two that fit alike the one with the designed poles is the first; None where one alone fits.
    """
    starts = _starts(thing, pressed)
    hands = [
        _best([start for start in starts if start.mirrored == mirrored][:_KEPT], pressed)
        for mirrored in (False, True)
    ]
    (cost, fit), (rival_cost, rival) = sorted(hands, key=lambda fit_and_cost: fit_and_cost[0])
    if rival_cost > _ALIKE * cost:
        return fit, None
    return (rival, fit) if fit.convention.reversed_poles else (fit, rival)


def _starts(thing: Moving, pressed: Pressed) -> list[ObjectFit]:
    """Return fits to begin with under every symmetry of the machine's axes, the most promising first."""
    starts = []
    for symmetry in range(len(SYMMETRIES)):
        for contact in _CONTACTS_MM:
            numbers = np.zeros(len(SCALES) + len(thing.extra))
            deepest = float(pressed.travel_mm.max()) + contact
            numbers[3] = contact / SCALES[3]
            numbers[4] = np.log(min(1.0, thing.deepest_mm / deepest)) / SCALES[4]
            unknown = Convention(np.arange(pressed.change_mt.shape[1]), np.eye(3), -1.0)
            starts.append(_with_convention(ObjectFit(thing, symmetry, numbers, unknown), pressed))
    return sorted(starts, key=lambda fit: -fit.convention.cosine)


def _best(starts: list[ObjectFit], pressed: Pressed) -> tuple[float, ObjectFit]:
    """Return the least cost of some starts, refined, and its fit."""
    refined = [_refined(start, pressed) for start in starts]
    others = [_with_convention(fit, pressed) for _, fit in refined]
    again = [
        _refined(alternative, pressed)
        for alternative, (_, fit) in zip(others, refined, strict=True)
        if not alternative.convention.agrees(fit.convention)
    ]
    return min((*refined, *again), key=lambda fit_and_cost: fit_and_cost[0])


def _with_convention(fit: ObjectFit, pressed: Pressed) -> ObjectFit:
    change, resting = fit.predicted(pressed)
    live = np.isfinite(pressed.change_mt).all(axis=(1, 2))
    readings, predicted = [pressed.change_mt[live]], [change[live]]
    if np.isfinite(pressed.resting_mt).all():
        readings.append(pressed.resting_mt)
        predicted.append(resting)
    return replace(fit, convention=best_convention(readings, predicted))


def _refined(start: ObjectFit, pressed: Pressed) -> tuple[float, ObjectFit]:
    """Return the cost and the fit of least squares, order and axes of the chips held."""
    recorded = start.recorded(pressed)
    resting = start.convention.designed(pressed.resting_mt)
    live = np.isfinite(recorded)
    scale = CHANGE_ERROR * float(np.sqrt(np.mean(recorded[live] ** 2)))
    level = RESTING_ERROR * float(np.sqrt(np.nanmean(np.sum(resting**2, axis=1))))
    size = int(live.sum()) + resting.size + len(start.numbers)

    def residual(numbers: np.ndarray) -> np.ndarray:
        try:
            change, still = replace(start, numbers=numbers).predicted(pressed)
        except InputError:  # a magnet in a chip: as far off as nothing predicted
            return np.full(size, 1 / CHANGE_ERROR)
        off = np.nan_to_num((still - resting) / level).ravel()
        return np.concatenate([(change - recorded)[live] / scale, off, numbers / PRIOR])

    solution = least_squares(residual, start.numbers, max_nfev=_ROUNDS, diff_step=1e-3)
    return float(solution.cost), replace(start, numbers=solution.x)


def halves_of_places(pressed: Pressed, seed: int) -> Bool[np.ndarray, "press"]:
    """Presses of a random half of the places."""
    places = np.unique(pressed.place)
    chosen = np.random.default_rng((seed, 41)).permutation(places)[: (len(places) + 1) // 2]
    return np.isin(pressed.place, chosen)


def judged(fit: ObjectFit, pressed: Pressed, exchanges: int = 99, seed: int = 0) -> TravelAgreement:
    """Judge a fit; places exchanged keep every press's travel and give it the place of another."""
    pressed = pressed.complete
    recorded, predicted = fit.recorded(pressed), fit.predicted(pressed)[0]
    _, travel = fit.shell_presses(pressed)
    rng = np.random.default_rng((seed, 42))
    exchanged = []
    for _ in range(exchanges):
        mixed = replace(pressed, xy_mm=pressed.xy_mm[rng.permutation(len(travel))])
        exchanged.append(figures(fit.predicted(mixed)[0], recorded))
    return agreement_of(predicted, recorded, travel, BEYOND_MM, exchanged, rivals={})
