"""What the sensors see under loads, and how far the sum of single presses is from them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.layout.positions import PlaceGrid, sensor_layout
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    from instobj.commands.loads import Pressed


def signal_changes(
    spec: ObjectSpec, motion: Float[np.ndarray, "load magnet 6"]
) -> Float[np.ndarray, "load sensor 3"]:
    """Expected changes against rest, counts, for the magnets' motions under some loads."""
    from estimator.signals.presses import press_signals
    from fem.presses.results import MagnetMotions, PressForces

    loads, one = np.arange(1.0, len(motion) + 1), PlaceGrid(np.zeros(1), np.zeros(1))
    faces, none = np.array([1]), np.zeros((1, 1, len(motion)))
    forces = PressForces(faces, one, loads, none, none)
    motions = MagnetMotions(faces, one, loads, motion[None, None])
    return press_signals(spec, forces, motions).delta_counts[0, 0]


def sensor_rows(spec: ObjectSpec, change: Float[np.ndarray, "sensor 3"]) -> list[dict[str, Any]]:
    """Change of every sensor's three channels, and its size in sigmas of a fresh zero."""
    sigma = np.hypot(np.asarray(spec.sensors.noise_counts), spec.sensors.zeroing_counts)
    faces = sensor_layout(spec).face.tolist()
    rows, number = [], 0
    for index, (face, counts) in enumerate(zip(faces, change, strict=True)):
        number = number + 1 if index and face == faces[index - 1] else 1
        row = {"face": face, "sensor": number}
        row |= {f"Δ{axis}": round(float(c), 1) for axis, c in zip("XYZ", counts, strict=True)}
        rows.append(row | {"σ": round(float(np.linalg.norm(counts / sigma)), 1)})
    return rows


def superposition_row(
    pressed: Pressed, changes: Float[np.ndarray, "load sensor 3"]
) -> dict[str, float]:
    """How far single presses to the same depths, summed, are from the joint one, in per cent.

    Force: of the total. Signals: root mean square over all channels against that of the joint
    press; the first of `changes` is the joint press.
    """
    total = float(pressed.curve[-1].force_n.sum())
    alone = sum(float(press.force_n.sum()) for press in pressed.alone)
    off = changes[1:].sum(axis=0) - changes[0]
    return {
        "force off %": 100 * (alone / total - 1),
        "signals off %": 100 * float(np.linalg.norm(off) / np.linalg.norm(changes[0])),
        "largest channel off, counts": float(abs(off).max()),
    }
