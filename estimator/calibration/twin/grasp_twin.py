"""A whole object calibrated on presses of several tips together, where no single presses are labelled.

Unknown are the same numbers as of `estimator.calibration.twin.digital_twin`, of all pressed faces together:
what a press of one jaw does to the other's sensors is seen as well. The motions of the contacts add
up and the field is exact, as in the inversion. What the numbers leave over is taken as independent
between cases, a share of what each chip shows: a case shows a sum over its contacts alone, and
carried to other places by a Gaussian process it made predictions of the public recordings worse
(docs/measured/validation.md). The share is the one that predicts cases left out best, and whether the
numbers help at all is judged there as well.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from estimator.calibration.twin.pressed_cases import PressedCases
from estimator.calibration.twin.traced_presses import TracedPresses, traced_presses
from estimator.calibration.twin.unknowns import (
    FARTHEST,
    STIFFENING,
    Unknowns,
    count_at_limits,
    most_probable,
    normal_equations,
)
from estimator.signals.monotone import monotone_cubic
from estimator.signals.press_states import rest_motion
from estimator.signals.presses import Signals
from estimator.tolerances.assembly import counts_of
from estimator.tolerances.virtual_object import twin_model
from fem.presses.results import MagnetMotions, PressForces

SIZES = (0.02, 0.05, 0.1, 0.2, 0.5, 1.0)
"""Sizes of what is left over, as shares of what a chip shows."""
_MODULUS = -len(STIFFENING) - 1
_CLEAR = 25.0
"""Changes of a chip whose square is below this many variances of its noise say nothing of shares."""


@dataclass(frozen=True)
class GraspTwin:
    """An object as presses of several contacts together show it.

    Attributes
    ----------
    numbers : most probable ones, 0 where the design predicts cases left out as well
    modulus_error : standard deviation of the modulus, relative
    left : (case, level, channel) of counts that cases left out keep, each time by the others' twin
    left_share, design_share : (case,) rms of that over the signals, noise taken off, and of the design
    """

    unknowns: Unknowns
    numbers: Float[np.ndarray, "number"]
    modulus_error: float
    residual: Float[np.ndarray, "case level channel"]
    left_share: Float[np.ndarray, "case"]
    design_share: Float[np.ndarray, "case"]

    @property
    def helps(self) -> bool:
        """It predicts cases left out better than the design does."""
        return bool(self.numbers.any())

    @property
    def strained(self) -> int:
        """Return how many numbers are at their limits."""
        return count_at_limits(self.numbers)

    def signals(self, forces: PressForces, motions: MagnetMotions) -> Signals:
        """Return the signals of every press of the design's table, done by this object.

        Raises
        ------
        InputError
            Forces that would fall with depth.
        """
        signals_of_table = self.unknowns.signals(self.numbers, forces, motions)
        if signals_of_table is None:
            raise self.unknowns.no_object("the labelled presses")
        return signals_of_table


class GraspMechanics:
    """The contacts of all cases."""

    def __init__(
        self, unknowns: Unknowns, forces: PressForces, motions: MagnetMotions, pressed: PressedCases
    ) -> None:
        self.unknowns, self.pressed, self.rest = unknowns, pressed, rest_motion(motions)
        self.parts: list[tuple[np.ndarray, np.ndarray, TracedPresses]] = []
        for face in pressed.faces:
            case, slot = np.nonzero(pressed.face == face)
            places = traced_presses(unknowns.spec, forces, motions, face, pressed.xy_mm[case, slot])
            self.parts.append((case, slot, places))

    def expected(self, numbers: Float[np.ndarray, "number"]) -> Float[np.ndarray, "row channel"]:
        """Changes of counts of all means, motions of the contacts added up; NaN where forces would
        not grow with depth."""
        spec, pressed = self.unknowns.spec, self.pressed
        cases, levels = pressed.counts.shape[:2]
        assembly, correction = self.unknowns.assembly(numbers), self.unknowns.correction(numbers)
        moved = np.zeros((cases, levels, self.rest.size))
        for case, slot, places in self.parts:
            force, motion = places.assembled(assembly, correction)
            force = np.pad(force, ((0, 0), (1, 0)))
            if np.diff(force, axis=1).min() <= 0:  # no object: a step that goes there is too long
                return np.full((cases * levels, len(pressed.channels)), np.nan)
            motion = np.pad(
                (motion - self.rest).reshape(*motion.shape[:2], -1), ((0, 0), (1, 0), (0, 0))
            )
            held = np.minimum(pressed.force_n[case, :, slot], force[:, -1:])
            np.add.at(moved, case, monotone_cubic(force, motion, held))
        states = self.rest + moved.reshape(-1, *self.rest.shape)
        model = twin_model(spec, assembly, states)
        still = counts_of(spec, assembly.scene, self.rest[None], model)
        change = counts_of(spec, assembly.scene, states, model) - still
        return change.reshape(len(states), -1)[:, pressed.channels]


@dataclass(frozen=True)
class _LeftOver:
    """Independent between cases and channels, alike at all levels of a case."""

    variance: Float[np.ndarray, "row channel"]

    def weighed(
        self, residual: Float[np.ndarray, "row channel *any"]
    ) -> Float[np.ndarray, "row channel *any"]:
        return residual / self.variance.reshape(*self.variance.shape, *[1] * (residual.ndim - 2))


def left_over_of(pressed: PressedCases, size: float) -> _LeftOver:
    levels = pressed.counts.shape[1]
    variance = pressed.noise_counts2 + levels * (size * pressed.chip_counts) ** 2
    return _LeftOver(variance.reshape(-1, len(pressed.channels)))


def calibrate_on_cases(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    pressed: PressedCases,
    progress: Callable[[str], None] = lambda _: None,
) -> GraspTwin:
    """Fit the numbers of all pressed faces to labelled presses of one or several contacts.

    Cases are left out one by one about the linearization at the numbers of all; predictions are exact.
    """
    unknowns = Unknowns(spec, pressed.faces)
    mechanics = GraspMechanics(unknowns, forces, motions, pressed)
    counts = pressed.counts.reshape(-1, len(pressed.channels))
    nothing = np.zeros(len(unknowns))
    design_motion = left_share(pressed, counts - mechanics.expected(nothing))
    first = float(np.clip(np.sqrt(np.mean(design_motion**2)) / 2, SIZES[0], SIZES[-1]))
    progress(f"fitting {len(pressed)} cases")
    fitted, here, jacobian = most_probable(mechanics, left_over_of(pressed, first), counts, nothing)
    right = counts - here + jacobian @ fitted
    progress("cases left out")
    tried = [
        (cases_left_out(mechanics, left_over_of(pressed, size), jacobian, right), size)
        for size in SIZES
    ]
    residual, size = min(tried, key=lambda attempt: np.mean(left_share(pressed, attempt[0]) ** 2))
    shares = left_share(pressed, residual)
    numbers, covariance = _solved(left_over_of(pressed, size), jacobian, right)
    numbers, modulus = (
        np.clip(numbers, -FARTHEST, FARTHEST),
        np.sqrt(covariance[_MODULUS, _MODULUS]),
    )
    if not np.mean(shares**2) < np.mean(design_motion**2):
        numbers, modulus, residual = nothing, 1.0, counts - mechanics.expected(nothing)
    error = spec.tolerances.modulus_relative * float(modulus)
    return GraspTwin(
        unknowns, numbers, error, residual.reshape(pressed.counts.shape), shares, design_motion
    )


def _solved(
    left_over: _LeftOver, jacobian: np.ndarray, right: np.ndarray
) -> tuple[Float[np.ndarray, "number"], Float[np.ndarray, "number number"]]:
    """Most probable numbers and their covariance, where signals are linear in them."""
    precision, pull = normal_equations(left_over, jacobian, right)
    covariance = np.linalg.inv(precision)
    return covariance @ pull, covariance


def cases_left_out(
    mechanics: GraspMechanics, left_over: _LeftOver, jacobian: np.ndarray, right: np.ndarray
) -> Float[np.ndarray, "row channel"]:
    """Return what the twin of all other cases leaves of each; infinite where it is no object."""
    pressed = mechanics.pressed
    case = np.repeat(np.arange(len(pressed)), pressed.counts.shape[1])
    residual = pressed.counts.reshape(len(case), -1).copy()
    for out in range(len(pressed)):
        others = case != out
        part = _LeftOver(left_over.variance[others])
        numbers, _ = _solved(part, jacobian[others], right[others])
        expected = mechanics.expected(np.clip(numbers, -FARTHEST, FARTHEST))
        residual[~others] -= np.where(np.isfinite(expected[~others]), expected[~others], np.inf)
    return residual


def left_share(
    pressed: PressedCases, residual: Float[np.ndarray, "row channel"]
) -> Float[np.ndarray, "case"]:
    """Rms of what is left over of each case's signals, noise taken off both."""
    noise = pressed.noise_counts2.sum(axis=(1, 2))
    wrong, size = (
        np.sum(values.reshape(pressed.counts.shape) ** 2, axis=(1, 2)) - noise
        for values in (residual, pressed.counts)
    )
    return np.sqrt(np.maximum(wrong, 0.0) / np.maximum(size, noise))


def sensor_errors(
    pressed: PressedCases, residual: Float[np.ndarray, "case level channel"], sensors: int
) -> Float[np.ndarray, "sensor 1"]:
    """Relative errors of the model at each sensor, as `estimator.inversion.model.noise` has them: rms over
    cases and levels of what is left over, over what the chip shows. Sensors that never show a clear
    change get the mean of the others."""
    clear = pressed.chip_counts**2 > _CLEAR * pressed.noise_counts2
    share = (residual**2 - pressed.noise_counts2) / np.maximum(pressed.chip_counts**2, 1e-12)
    sensor, squares = pressed.channels // 3, np.full(sensors, np.nan)
    for number in np.unique(sensor):
        sensor_shares = share[..., sensor == number][clear[..., sensor == number]]
        if len(sensor_shares):
            squares[number] = max(sensor_shares.mean(), 0.0)
    return np.sqrt(np.where(np.isnan(squares), np.nanmean(squares), squares))[:, None]
