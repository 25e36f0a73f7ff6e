"""Signals of one object as it may be assembled: a twin of the design, with its own errors.

Poses, remanences, chips and modulus come from an `Assembly` (`estimator.tolerances.assembly`), mechanics from
any table of presses, the design's or a better one. A magnet that sits aside is moved as if the press
lay as far aside the other way (`estimator.tolerances.result.SEAT_ERROR` says how well).
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float

from design.spec.object import ObjectSpec
from estimator.field.models import MagnetsModel, magnets_model
from estimator.signals.continuation import continued
from estimator.signals.field_setup import min_distance_mm
from estimator.signals.press_states import rest_motion
from estimator.signals.presses import Progress, Signals
from estimator.tolerances.assembly import Assembly, counts_of, designed, draw
from fem.presses.results import MagnetMotions, PressForces

_NEARER_MM = 1.0
"""Distance by which tolerances may bring magnet and sensor nearer than the table's presses do."""


def drawn_assembly(spec: ObjectSpec, seed: int) -> Assembly:
    """An object within `spec.tolerances`, always the same for one seed."""
    return draw(spec, designed(spec), np.random.default_rng((seed, 8)))


def twin_signals(
    spec: ObjectSpec,
    assembly: Assembly,
    forces: PressForces,
    motions: MagnetMotions,
    progress: Progress | None = None,
) -> Signals:
    """Expected signals of an assembled object in every press of a table.

    Forces scale with its modulus. The object is not turned between zeroing and the press, so that
    Earth's field does not show.
    """
    model, rest = twin_model(spec, assembly, motions.all_motions), rest_motion(motions)
    baseline = counts_of(spec, assembly.scene, rest[None], model)[0]
    delta = np.full((*motions.motion.shape[:3], *baseline.shape), np.nan)
    for index, (face, here) in enumerate(zip(motions.faces.tolist(), motions.pressed, strict=True)):
        moved = _moved_aside(assembly, motions, index)[here]
        counts = counts_of(spec, assembly.scene, moved.reshape(-1, *rest.shape), model)
        delta[index, here] = counts.reshape(-1, *delta.shape[2:]) - baseline
        if progress is not None:
            progress(f"face {face}: {len(counts)} presses of the twin")
    return Signals(
        motions.faces,
        motions.lattice,
        motions.depth_mm,
        forces.force_n * assembly.modulus_ratio,
        delta,
        baseline,
    )


def twin_changes(
    spec: ObjectSpec, assembly: Assembly, motion: Float[np.ndarray, "press body 6"]
) -> Float[np.ndarray, "press sensor 3"]:
    """Changes of counts against rest under given motions; bodies that sit aside keep theirs."""
    model = twin_model(spec, assembly, motion)
    rest = np.zeros((1, *motion.shape[1:]))
    still = counts_of(spec, assembly.scene, rest, model)
    return counts_of(spec, assembly.scene, motion, model) - still


def twin_model(
    spec: ObjectSpec, assembly: Assembly, motion: Float[np.ndarray, "*press body 6"]
) -> MagnetsModel:
    """The field model that serves an assembled object in these motions."""
    nearest = min_distance_mm(assembly.scene, motion.reshape(-1, assembly.scene.bodies, 6))
    return magnets_model(spec.magnets, nearest - _NEARER_MM)


def _moved_aside(
    assembly: Assembly, motions: MagnetMotions, index: int
) -> Float[np.ndarray, "place step body 6"]:
    """The table of one face with the face's own bodies where they sit."""
    is_on_face = assembly.scene.body_face == motions.faces[index]
    if not assembly.aside_mm[is_on_face].any():
        return motions.motion[index]
    moved = _whole(motions, index).copy()
    slope = aside_slopes(motions, index, is_on_face)
    # of every body its own two directions
    # b body, k direction (x, y), p place, s step, c of 6 motions
    moved[:, :, is_on_face] -= np.einsum("bk,kpsbc->psbc", assembly.aside_mm[is_on_face], slope)
    return moved


def aside_slopes(
    motions: MagnetMotions, index: int, is_on_face: Bool[np.ndarray, "body"]
) -> Float[np.ndarray, "2 place step own 6"]:
    """Change of some bodies' motions in one face's table with the press's x and y, per mm."""
    lattice, motion = motions.lattice, _whole(motions, index)[:, :, is_on_face]
    shape = (*lattice.shape, *motion.shape[1:])
    slopes = [
        slope_along(motion.reshape(shape), nodes, axis).reshape(motion.shape)
        for axis, nodes in enumerate((lattice.x_mm, lattice.y_mm))
    ]
    return np.stack(slopes)


def _whole(motions: MagnetMotions, index: int) -> Float[np.ndarray, "place step body 6"]:
    """One face's table, continued to places that the face has not."""
    return continued(motions.motion[index], motions.pressed[index], motions.lattice.shape)


def slope_along(values: np.ndarray, nodes_mm: np.ndarray, axis: int) -> np.ndarray:
    from scipy.interpolate import make_interp_spline

    spline = make_interp_spline(nodes_mm, values, k=3, axis=axis)
    return np.moveaxis(np.moveaxis(spline(nodes_mm, nu=1), axis, 0), 0, axis)
