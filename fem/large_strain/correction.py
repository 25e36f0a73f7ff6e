"""Correction of the small-strain table for large deformation, fitted to a few nonlinear presses.

At depth δ in a shell of thickness t, with x = δ/t, s the largest inward shift of a magnet of the
pressed face over δ, and each magnet's small-strain shift u and rotation vector ω:

    F → F (1 + x (a + b s)),    u → u (1 + c x) + d ω × u,    ω → ω (1 + e x).

s says whether silicone is squeezed between tip and magnet, which stiffens, or flows around, which
does not. ω × u is the shift carried along by the magnet's own rotation, the leading term of second
order (d is near 1). On seven places of the paper's cube down to half the thickness this halves the
errors of force (root mean square of 6.1 to 3.9 %, largest 16 to 8 %) and of shifts (worst magnet,
share of the press's largest shift: 21 to 12 %, largest 67 to 27 %), each place predicted from the
other six; rotations gain little (41 to 38 %). Quadratic terms in x gain nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.body import face_frames
from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.large_strain.results import LargeStrainPress
from fem.presses.results import MagnetMotions, PressForces


@dataclass(frozen=True)
class StrainCorrection:
    """Coefficients; zeros correct nothing. `force` (a, b), `shift` (c, d), `rotation` (e,)."""

    thickness_mm: float
    force: tuple[float, float] = (0.0, 0.0)
    shift: tuple[float, float] = (0.0, 0.0)
    rotation: tuple[float] = (0.0,)


@dataclass(frozen=True)
class PressPair:
    """One press in both models, with the own face's magnets and outward normal."""

    depth_mm: Float[np.ndarray, "step"]
    force_n: Float[np.ndarray, "step"]
    linear_force_n: Float[np.ndarray, "step"]
    motion: Float[np.ndarray, "step magnet 6"]
    linear_motion: Float[np.ndarray, "step magnet 6"]
    on_pressed_face: Bool[np.ndarray, "magnet"]
    normal: Float[np.ndarray, "3"]


@dataclass(frozen=True)
class QuantityError:
    """Error of a quantity against the nonlinear presses: rms and largest, as shares."""

    uncorrected_rms: float
    uncorrected_largest: float
    corrected_rms: float
    corrected_largest: float

    @property
    def helps(self) -> bool:
        """Return whether a place left out is predicted better with the correction."""
        return self.corrected_rms < self.uncorrected_rms


@dataclass(frozen=True)
class CorrectionError:
    """Errors with every place predicted from the other ones.

    Of the force; of the worst magnet's shift, over the press's largest shift; of the worst magnet's
    rotation, over the press's largest.
    """

    force: QuantityError
    shift: QuantityError
    rotation: QuantityError


def press_pair(spec: ObjectSpec, press: LargeStrainPress) -> PressPair:
    """Return what the correction needs of a press, depths without contact left out."""
    kept = (press.force_n > 0) & (press.linear_force_n > 0)
    return PressPair(
        press.depth_mm[kept],
        press.force_n[kept],
        press.linear_force_n[kept],
        press.motion[kept],
        press.linear_motion[kept],
        *own_bodies(spec, press.face),
    )


def fit_correction(pairs: Sequence[PressPair], thickness_mm: float) -> StrainCorrection:
    """Least squares over all depths; each press's motions count relative to its largest.

    A quantity that the correction does not predict better at places left out stays uncorrected.
    """
    fitted = _fit(pairs, thickness_mm)
    error = leave_one_out(pairs, thickness_mm)
    nothing = StrainCorrection(thickness_mm)
    unhelpful = {
        name: getattr(nothing, name)
        for name in ("force", "shift", "rotation")
        if not getattr(error, name).helps
    }
    return replace(fitted, **unhelpful)


def leave_one_out(pairs: Sequence[PressPair], thickness_mm: float) -> CorrectionError:
    """Predict each press from a fit to all others."""
    nothing = StrainCorrection(thickness_mm)
    uncorrected = [_errors(pair, nothing) for pair in pairs]
    corrected = [
        _errors(pair, _fit([*pairs[:index], *pairs[index + 1 :]], thickness_mm))
        for index, pair in enumerate(pairs)
    ]
    return CorrectionError(
        *(
            _quantity(
                [errors[part] for errors in uncorrected], [errors[part] for errors in corrected]
            )
            for part in range(3)
        )
    )


def corrected_table(
    spec: ObjectSpec, forces: PressForces, motions: MagnetMotions, correction: StrainCorrection
) -> tuple[PressForces, MagnetMotions]:
    """The table with every press corrected; fitted on one face, taken to hold on all."""
    force, motion = forces.force_n.copy(), motions.motion.copy()
    for index, (face, here) in enumerate(zip(forces.faces.tolist(), motions.pressed, strict=True)):
        force[index, here], motion[index, here] = corrected_presses(
            correction,
            forces.depth_mm,
            forces.force_n[index, here],
            motions.motion[index, here],
            *own_bodies(spec, face),
        )
    return replace(forces, force_n=force), replace(motions, motion=motion)


def corrected_joint(
    spec: ObjectSpec,
    faces: Int[np.ndarray, "tip"],
    depth_mm: Float[np.ndarray, "step tip"],
    force_n: Float[np.ndarray, "step tip"],
    motion: Float[np.ndarray, "step magnet 6"],
    correction: StrainCorrection,
) -> tuple[Float[np.ndarray, "step tip"], Float[np.ndarray, "step magnet 6"]]:
    """Several tips pressed together, each face with its own magnets and its deepest tip.

    The magnets of faces that nothing presses follow the first face. Jaws that were squeezed to one
    force differ afterwards by as much as their corrections do.
    """
    force, moved = force_n.copy(), None
    for face in dict.fromkeys(faces.tolist()):
        here, (on_face, normal) = faces == face, own_bodies(spec, face)
        deepest = depth_mm[:, here].max(axis=1)
        face_force_n, motions = corrected_presses(
            correction, deepest, force_n[:, here].T, motion, on_face, normal
        )
        force[:, here] = face_force_n.T
        moved = motions if moved is None else moved
        moved[:, on_face] = motions[:, on_face]
    return force, motion if moved is None else moved


def _fit(pairs: Sequence[PressPair], thickness_mm: float) -> StrainCorrection:
    force, shift, rotation = [], [], []
    for pair in pairs:
        share = pair.depth_mm / thickness_mm
        squeeze = _squeeze(pair.depth_mm, pair.linear_motion, pair.on_pressed_face, pair.normal)
        columns = [share, share * squeeze]
        force.append(_row(columns, pair.force_n / pair.linear_force_n - 1))
        moved, turned = pair.linear_motion[..., :3], pair.linear_motion[..., 3:]
        depth_share = share[:, None, None]
        difference = pair.motion - pair.linear_motion
        weight = 1 / _largest(moved)[:, None, None]
        columns = [weight * depth_share * moved, weight * np.cross(turned, moved)]
        shift.append(_row(columns, weight * difference[..., :3]))
        weight = 1 / _largest(turned)[:, None, None]
        rotation.append(_row([weight * depth_share * turned], weight * difference[..., 3:]))
    a, b = _solve(force)
    c, d = _solve(shift)
    return StrainCorrection(thickness_mm, (a, b), (c, d), (_solve(rotation)[0],))


def _row(columns: list[np.ndarray], right: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.stack([column.ravel() for column in columns], axis=1), right.ravel()


def _solve(rows: list[tuple[np.ndarray, np.ndarray]]) -> list[float]:
    matrix, right = (np.concatenate(part) for part in zip(*rows, strict=True))
    return [float(value) for value in np.linalg.lstsq(matrix, right)[0]]


def _squeeze(
    depth_mm: np.ndarray, motion: np.ndarray, on_pressed_face: np.ndarray, normal: np.ndarray
) -> np.ndarray:
    """s: the largest inward shift of a magnet of the pressed face over the depth; ≥ 0."""
    inward = -(motion[..., on_pressed_face, :3] @ normal)
    return np.maximum(inward.max(axis=-1, initial=0), 0) / depth_mm


def own_bodies(
    spec: ObjectSpec, face: int
) -> tuple[Bool[np.ndarray, "magnet"], Float[np.ndarray, "3"]]:
    """Return which magnets are a face's own, and its outward normal."""
    frame = next(frame for frame in face_frames(spec) if frame.number == face)
    return np.asarray(shell_body_layout(spec).face) == face, np.asarray(frame.normal, float)


def corrected_presses(
    correction: StrainCorrection,
    depth_mm: Float[np.ndarray, "step"],
    force_n: Float[np.ndarray, "*any step"],
    motion: Float[np.ndarray, "*some step magnet 6"],
    on_pressed_face: Bool[np.ndarray, "magnet"],
    normal: Float[np.ndarray, "3"],
) -> tuple[Float[np.ndarray, "*any step"], Float[np.ndarray, "*some step magnet 6"]]:
    """Presses of a face corrected; `on_pressed_face` and `normal` are those of `own_bodies`."""
    (a, b), (c, d), (e,) = correction.force, correction.shift, correction.rotation
    share = depth_mm / correction.thickness_mm
    squeeze = _squeeze(depth_mm, motion, on_pressed_face, normal)
    moved, turned = motion[..., :3], motion[..., 3:]
    depth_share = share[:, None, None]
    shift = moved * (1 + c * depth_share) + d * np.cross(turned, moved)
    rotation = turned * (1 + e * depth_share)
    return (
        force_n * (1 + share * (a + b * squeeze)),
        np.concatenate([shift, rotation], axis=-1),
    )


def _errors(
    pair: PressPair, correction: StrainCorrection
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Errors of force, shift and rotation at every depth, as shares of the nonlinear press."""
    force, motion = corrected_presses(
        correction,
        pair.depth_mm,
        pair.linear_force_n,
        pair.linear_motion,
        pair.on_pressed_face,
        pair.normal,
    )
    off = motion - pair.motion
    shift = _largest(off[..., :3]) / _largest(pair.motion[..., :3])
    rotation = _largest(off[..., 3:]) / _largest(pair.motion[..., 3:])
    return abs(force / pair.force_n - 1), shift, rotation


def _largest(vectors: np.ndarray) -> np.ndarray:
    """Largest norm over the magnets at every step."""
    return np.linalg.norm(vectors, axis=-1).max(axis=-1)


def _quantity(
    uncorrected_parts: list[np.ndarray], corrected_parts: list[np.ndarray]
) -> QuantityError:
    uncorrected, corrected = np.concatenate(uncorrected_parts), np.concatenate(corrected_parts)
    return QuantityError(
        float(np.sqrt((uncorrected**2).mean())),
        float(uncorrected.max()),
        float(np.sqrt((corrected**2).mean())),
        float(corrected.max()),
    )
