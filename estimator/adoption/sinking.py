"""Order of chips without mechanics or machine: what presses change, held against bodies that sink.

Whatever a press does, most of it is that bodies in the shell sink towards the core. The changes of all
chips then lie near the span of one pattern for each body, which follows from the design alone. In another
order of the chips they do not.
"""

from __future__ import annotations

from itertools import islice, permutations

import numpy as np
from jaxtyping import Float

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.adoption.findings import Finding
from estimator.field.models import magnets_model
from estimator.signals.field_setup import min_distance_mm, scene, sensed_field, zero_motion

MOST_ORDERS = 720
"""Orders that are compared: all of up to six chips."""
_SINK_MM = 0.2
"""Motion whose difference quotient is a pattern."""


def order_by_sinking(
    spec: ObjectSpec, readings: Float[np.ndarray, "press chip 3"]
) -> tuple[tuple[int, ...], Finding]:
    """Return the column of every designed chip, and the finding with the other orders as its null.

    Readings may hold any level at rest: their mean counts nothing.
    """
    patterns = sinking_patterns(spec)
    chips = patterns.shape[1]
    centred = readings - readings.mean(axis=0)
    base = np.linalg.qr(patterns.reshape(len(patterns), -1).T)[0]
    orders = list(islice(permutations(range(chips)), MOST_ORDERS))
    shares = np.array([_share(centred[:, list(order)], base) for order in orders])
    best = int(np.argmax(shares))
    rank = 1 + int(np.sum(shares > shares[0]))
    columns = ", ".join(str(c + 1) for c in orders[best])
    return orders[best], Finding(
        "order of chips",
        f"designed chips are columns {columns}; the specification's own order is number {rank} of "
        f"{len(orders)}",
        f"{100 * shares[best]:.0f} % of the changes lie in the span of {len(patterns)} sinking bodies",
        f"{100 * np.median(shares):.0f} % in the median of the orders",
        float(np.mean(shares >= shares[best])),
    )


def sinking_patterns(spec: ObjectSpec) -> Float[np.ndarray, "body chip 3"]:
    """Change of the flux density along every chip's axes for each body that sinks, per mm."""
    place = scene(spec)
    normals = {frame.number: frame.axes[:, 2] for frame in face_frames(spec)}
    motion = np.zeros((place.bodies, place.bodies, 6))
    for body, face in enumerate(place.body_face.tolist()):
        motion[body, body, :3] = -_SINK_MM * normals[face]
    model = magnets_model(spec.magnets, min_distance_mm(place, motion))
    change = sensed_field(place, motion, model) - sensed_field(place, zero_motion(place), model)
    # T → along each chip's axes: s sensor, j coordinate, i chip axis, n body
    return np.einsum("sij,nsj->nsi", place.sensors.axes, change) / _SINK_MM


def _share(readings: Float[np.ndarray, "press chip 3"], base: np.ndarray) -> float:
    flat = readings.reshape(len(readings), -1)
    return float(np.sum((flat @ base) ** 2) / np.sum(flat**2))
