"""The digital twin of one object, calibrated on labelled presses of some locations of one face.

Signals at places never pressed come from the design's mechanics with what differs in the object put
in: poses and strengths of the face's magnets, poses and gains of its sensors, the core's pose, the
modulus, and the coefficients by which large deformation departs from the table of presses
(`fem.large_strain.correction`; a corrected table is corrected further). All are Gaussian beforehand, the
first with the standard deviations in `[tolerances]`. What they leave over is a Gaussian process
(`estimator.calibration.twin.discrepancy`), so that pressed places are met and others keep an honest doubt.
Numbers and process are fitted jointly, by Gauss–Newton steps on the posterior (Kennedy & O'Hagan, J. R.
Stat. Soc. B 63, 2001); size and length of the process have the largest marginal likelihood of a few.

On a hidden twin of the paper's cube (finer mesh, large deformation) 25 places leave 2 % of the
signals at the 75 others, where the design leaves 16 to 22 %. Its large deformation has the form of
these coefficients, which that of silicone follows to about 10 % (`fem.large_strain.correction`). Labelled
places count as exact: errors of 0.3 mm per press are 1 % of the signals over six presses, and the
process takes them for its own.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.twin.discrepancy import Discrepancy, Prior
from estimator.calibration.twin.place_mechanics import PlaceMechanics
from estimator.calibration.twin.pressed_places import PressedPlaces
from estimator.calibration.twin.unknowns import FARTHEST, Unknowns, most_probable, normal_equations
from estimator.signals.presses import Signals
from fem.presses.results import MagnetMotions, PressForces

SIZES = (0.02, 0.05, 0.1, 0.2)
"""Relative sizes of the process; meshes of one design differ by the least of them."""
LENGTHS_MM = (6.0, 10.0, 16.0)
"""Lengths of the discrepancy among which the evidence chooses."""
_FIRST = Prior(0.02, 10.0)
_DRAWS = 20
"""Draws from the posterior: for the modulus' spread, and tries until forces grow with depth."""
FOLDS = 5
"""Folds of the cross-validation."""


@dataclass(frozen=True)
class CalibratedTwin:
    """An object as labelled presses of one face show it.

    `forces` and `motions` are the design's table of that face; `numbers` are the posterior's mean,
    `factor` a square root of its covariance; `left` (row, channel) is what they leave over of the
    means, `jacobian` (row, channel, number) how that falls with them, and `discrepancy` spreads it.
    """

    unknowns: Unknowns
    forces: PressForces
    motions: MagnetMotions
    numbers: Float[np.ndarray, "number"]
    factor: Float[np.ndarray, "number number"]
    discrepancy: Discrepancy
    residual: Float[np.ndarray, "row channel"]
    jacobian: Float[np.ndarray, "row channel number"]

    @property
    def modulus_error(self) -> float:
        """Standard deviation of the modulus, relative, that the labelled presses leave."""
        draws = (
            self.numbers
            + (
                self.factor @ np.random.default_rng(0).standard_normal((len(self.numbers), _DRAWS))
            ).T
        )
        ratios = [self.unknowns.assembly(numbers).modulus_ratio for numbers in draws]
        return float(np.std(ratios) / np.mean(ratios))

    def signals(self, rng: np.random.Generator | None = None) -> Signals:
        """Signals of every press of the face's lattice: the most probable ones, or a draw of what
        the labelled presses leave possible.

        Channels of other faces are the design's, with this object's core and modulus.

        Raises
        ------
        InputError
            Forces that fall with depth, in the most probable object or in twenty draws.
        """
        for _ in range(1 if rng is None else _DRAWS):
            numbers = self.numbers
            if rng is not None:
                numbers = numbers + self.factor @ rng.standard_normal(len(numbers))
                numbers = np.clip(numbers, -FARTHEST, FARTHEST)
            signals = self.unknowns.signals(numbers, self.forces, self.motions)
            if signals is not None:
                return self._with_discrepancy(signals, numbers, rng)
        raise InputError(
            f"the labelled presses of face {self.unknowns.face} fit no object of "
            f"{self.unknowns.spec.name!r}: its forces would fall with depth. Give the specification of the "
            "object that was pressed, with true tolerances"
        )

    def _with_discrepancy(
        self,
        signals: Signals,
        numbers: Float[np.ndarray, "number"],
        rng: np.random.Generator | None,
    ) -> Signals:
        """Return what these numbers leave over, spread over the lattice, with a draw of the doubt."""
        lattice_rows = signals.pressed[0]
        xy, force = signals.lattice.xy_mm[lattice_rows], signals.force_n[0, lattice_rows]
        residual = self.residual - self.jacobian @ (numbers - self.numbers)
        added = self.discrepancy.mean(residual, xy, force)
        if rng is not None:
            added = added + self.discrepancy.doubt(xy, force, rng)
        on_face = self.unknowns.design.scene.sensors.face == self.discrepancy.pressed.face
        face_channels = np.flatnonzero(np.repeat(on_face, 3))[self.discrepancy.pressed.channels]
        delta = signals.delta_counts.reshape(*signals.force_n.shape, -1).copy()
        pressed = delta[0, lattice_rows]
        pressed[..., face_channels] += added
        delta[0, lattice_rows] = pressed
        return replace(signals, delta_counts=delta.reshape(signals.delta_counts.shape))


def calibrate(
    spec: ObjectSpec, forces: PressForces, motions: MagnetMotions, pressed: PressedPlaces
) -> CalibratedTwin:
    """Fit a twin to labelled presses; `forces` and `motions` are the design's table.

    Raises
    ------
    InputError
        A core that slipped in the mechanics, or forces beyond the simulated depths.
    """
    if spec.mechanics.slip.slipped:
        raise InputError(
            "a twin is calibrated on the shell as it was cast; mechanics.slip says that the core "
            "slipped. Set it to 0"
        )
    unknowns = Unknowns(spec, pressed.face)
    mechanics = PlaceMechanics(unknowns, forces, motions, pressed)
    counts = pressed.counts.reshape(-1, len(pressed.channels))
    first = Discrepancy(spec, _FIRST, pressed)
    numbers, here, jacobian = most_probable(
        mechanics.expected, first.weighed, counts, np.zeros(len(unknowns))
    )
    right = counts - here + jacobian @ numbers
    choices = (
        Discrepancy(spec, Prior(size, length), pressed)
        for size, length in product(SIZES, LENGTHS_MM)
    )
    chosen = max(choices, key=lambda choice: _log_evidence(choice, jacobian, right))
    numbers, here, jacobian = most_probable(mechanics.expected, chosen.weighed, counts, numbers)
    precision, _ = normal_equations(chosen.weighed, jacobian, counts - here)
    factor = np.linalg.inv(np.linalg.cholesky(precision)).T
    residual = counts - here
    table = rows_of_face(forces, motions, pressed.face)
    return CalibratedTwin(unknowns, *table, numbers, factor, chosen, residual, jacobian)


def _log_evidence(
    discrepancy: Discrepancy, jacobian: np.ndarray, right: Float[np.ndarray, "row channel"]
) -> float:
    """Return the log evidence of `right` under linear numbers and the process, but for a constant."""
    precision, pull = normal_equations(discrepancy.weighed, jacobian, right)
    fitted = np.sum(right * discrepancy.weighed(right)) - pull @ np.linalg.solve(precision, pull)
    determinant = discrepancy.log_determinant + np.linalg.slogdet(precision)[1]
    return float(-0.5 * (fitted + determinant))


def places_left_out(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    pressed: PressedPlaces,
    progress: Callable[[str], None] = lambda _: None,
) -> tuple[Float[np.ndarray, "place"], Float[np.ndarray, "place"]]:
    """Share of each place's signals (rms; noise and errors of the zero taken off) that a twin
    calibrated on other places leaves, and that the design leaves.

    Five folds at random. Each channel counts about its mean at a place: zeros are uncertain.
    """
    calibrated, planned = np.empty(len(pressed)), np.empty(len(pressed))
    folds, order = min(FOLDS, len(pressed)), np.random.default_rng(0).permutation(len(pressed))
    for fold in range(folds):
        progress(f"places left out, {fold + 1} of {folds}")
        out = order % folds == fold
        twin = calibrate(spec, forces, motions, pressed.select_places(~out))
        rest = pressed.select_places(out)
        mechanics = PlaceMechanics(twin.unknowns, forces, motions, rest)
        added = twin.discrepancy.mean(twin.residual, rest.xy_mm, rest.force_n)
        fitted = mechanics.expected(twin.numbers).reshape(rest.counts.shape) + added
        plain = mechanics.expected(0 * twin.numbers).reshape(rest.counts.shape)
        calibrated[out], planned[out] = (left_share(spec, rest, wrong) for wrong in (fitted, plain))
    return calibrated, planned


def left_share(
    spec: ObjectSpec, pressed: PressedPlaces, predicted: np.ndarray
) -> Float[np.ndarray, "place"]:
    """Rms over levels and channels, each about its mean, noise taken off; all of it where the
    prediction is of no object (NaN)."""
    centring = np.eye(pressed.force_n.shape[1]) - 1 / pressed.force_n.shape[1]
    # Noise that centring leaves: trace(C Σ) of each place p, i and j levels; c channel
    zeros = np.einsum("ij,pji->p", centring, pressed.zero_counts2) * len(pressed.channels)
    noise = zeros + np.einsum("ii,pic->p", centring, pressed.white_counts2(spec))
    wrong, size = (
        np.sum((centring @ values) ** 2, axis=(1, 2)) - noise
        for values in (pressed.counts - predicted, pressed.counts)
    )
    share = np.sqrt(np.maximum(wrong, 0.0) / np.maximum(size, noise))
    return np.where(np.isnan(share), 1.0, share)


def rows_of_face(
    forces: PressForces, motions: MagnetMotions, face: int
) -> tuple[PressForces, MagnetMotions]:
    here = motions.faces == face
    return (
        replace(
            forces,
            faces=forces.faces[here],
            force_n=forces.force_n[here],
            contact_area_mm2=forces.contact_area_mm2[here],
        ),
        replace(motions, faces=motions.faces[here], motion=motions.motion[here]),
    )
