"""Share of virtual objects in which a chip leaves its range, at rest and at each press depth.

The design may stay within the range where objects as they are assembled do not: a chip 5 mm from a
magnet reads a third more where the core sits 0.3 mm aside. Presses are those in which each channel of
the design reads most, at every depth.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from design.spec.object import ObjectSpec
from estimator.signals.hall import full_scale_counts
from estimator.signals.press_states import rest_motion
from estimator.signals.presses import Signals
from estimator.tolerances.assembly import Assembly, counts_of, designed, draw
from estimator.tolerances.virtual_object import aside_slopes, twin_model
from fem.presses.results import MagnetMotions

KEPT_BY = 0.95
"""Share of virtual objects that are to keep within the range."""
OBJECTS = 200
"""Virtual objects that are drawn."""


@dataclass(frozen=True)
class Saturation:
    """Share of the drawn objects that leave the range, at rest (depth 0) and in presses to each depth.

    `out_share` (depth,) has some chip beyond its range at rest or in a press as deep or less.
    `margin` (depth,) is the share of the range that stays free in `KEPT_BY` of the objects;
    negative where more than the others leave it.
    """

    objects: int
    depth_mm: tuple[float, ...]
    out_share: tuple[float, ...]
    margin: tuple[float, ...]


def saturation(
    spec: ObjectSpec,
    signals: Signals,
    motions: MagnetMotions,
    objects: int = OBJECTS,
    deepest_alone: bool = False,
) -> Saturation:
    """Draw objects within `spec.tolerances` and press them; `signals` are those of the design.

    A share of 5 % of 200 objects is known to 1.5 % (one standard deviation). With `deepest_alone`
    presses to other depths are left out.
    """
    if deepest_alone:
        signals = replace(
            signals,
            depth_mm=signals.depth_mm[-1:],
            force_n=signals.force_n[:, :, -1:],
            delta_counts=signals.delta_counts[:, :, -1:],
        )
        motions = replace(motions, depth_mm=motions.depth_mm[-1:], motion=motions.motion[:, :, -1:])
    rng, design = np.random.default_rng((spec.seed, 9)), designed(spec)
    faces = signals.faces.tolist()
    presses = [_presses_of(signals, motions, face, design.scene.body_face) for face in faces]
    largest = np.array(
        [_largest_counts(spec, draw(spec, design, rng), presses, motions) for _ in range(objects)]
    )
    used = np.maximum.accumulate(largest, axis=1) / full_scale_counts(spec.sensors)
    kept = np.quantile(used, KEPT_BY, axis=0, method="higher")
    return Saturation(
        objects,
        (0.0, *signals.depth_mm.tolist()),
        tuple(np.mean(used > 1, axis=0).tolist()),
        tuple((1 - kept).tolist()),
    )


@dataclass(frozen=True)
class _Presses:
    """Presses in which one face's channels read most; slopes by the pressed face's bodies' seats."""

    read_face: int
    step: Int[np.ndarray, "press"]
    motion: Float[np.ndarray, "press body 6"]
    slope_per_mm: Float[np.ndarray, "2 press body 6"]


def _presses_of(
    signals: Signals, motions: MagnetMotions, face: int, body_face: Int[np.ndarray, "body"]
) -> _Presses:
    """Return the press in which each of a face's own channels reads most by design, at every depth."""
    count = len(signals.baseline_counts) // len(signals.faces)
    first = count * int(np.flatnonzero(signals.faces == face)[0])
    is_own = slice(first, first + count)
    read = abs(signals.baseline_counts[is_own] + signals.delta_counts[..., is_own, :])
    read = np.moveaxis(np.nan_to_num(read), 2, 0)  # step first
    most = read.reshape(*read.shape[:1], -1, 3 * count).argmax(axis=1)
    steps = np.repeat(np.arange(len(most)), most.shape[1])
    chosen = np.unique(np.column_stack([steps, most.ravel()]), axis=0)
    step, (pressed, place) = chosen[:, 0], np.unravel_index(chosen[:, 1], read.shape[1:3])
    motion = motions.motion[pressed, place, step]
    slope = np.zeros((2, *motion.shape))
    for index in np.unique(pressed):
        here, is_own = np.flatnonzero(pressed == index), body_face == motions.faces[index]
        of_table = aside_slopes(motions, int(index), is_own)
        slope[:, here[:, None], np.flatnonzero(is_own)] = of_table[:, place[here], step[here]]
    return _Presses(face, step, motion, slope)


def _largest_counts(
    spec: ObjectSpec, assembly: Assembly, all_presses: Sequence[_Presses], motions: MagnetMotions
) -> Float[np.ndarray, "depth"]:
    """Largest magnitude of any channel, at rest and at each depth."""
    largest = np.zeros(1 + len(motions.depth_mm))
    for presses in all_presses:
        # a body aside moves as if the press lay as far aside the other way
        # b body, k direction (x, y), p press, c of 6 motions
        moved = presses.motion - np.einsum("bk,kpbc->pbc", assembly.aside_mm, presses.slope_per_mm)
        moved = np.concatenate([rest_motion(motions)[None], moved])
        model = twin_model(spec, assembly, moved)
        read = abs(counts_of(spec, assembly.scene, moved, model, presses.read_face))
        np.maximum.at(largest, np.append(0, 1 + presses.step), read.max(axis=(1, 2)))
    return largest
