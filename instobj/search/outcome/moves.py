"""Moves and changes of a search, from the start to the found layout."""

from __future__ import annotations

from typing import Any

import numpy as np
from jaxtyping import Float

from design.layout.pockets import magnet_bodies, sensor_places
from design.search.faces import layout_groups
from design.spec.object import ObjectSpec


def moved_parts(start: ObjectSpec, changed: ObjectSpec) -> dict[str, Any]:
    """Rows of moved magnets and sensors, and other changes, as the page shows them."""
    rows = []
    for group, label in zip(layout_groups(changed), _faces_in_words(changed), strict=True):
        face = changed.body.sensed.index(group[0])
        rows += _moved_magnets(start, changed, face, label)
        rows += _moved_sensors(start, changed, face, label)
    others = [
        f"{label} {old_value} → {new_value}"
        for label, old_value, new_value in _other_changes(start, changed)
        if old_value != new_value
    ]
    return {
        "moves": rows,
        "kinds": _kinds_differ(changed),
        "other_changes": others,
    }


def paired(
    old_places: Float[np.ndarray, "n 2"], new_places: Float[np.ndarray, "m 2"]
) -> list[tuple[int, int]]:
    """Return which of the old places became which of the new, by the least total distance."""
    from scipy.optimize import linear_sum_assignment

    away = np.linalg.norm(old_places[:, None] - new_places, axis=-1)
    rows, columns = linear_sum_assignment(away)
    return list(zip(rows.tolist(), columns.tolist(), strict=True))


def _kinds_differ(changed: ObjectSpec) -> bool:
    return changed.search.vary.magnet_sizes is not None


def _faces_in_words(spec: ObjectSpec) -> list[str]:
    """Name each group of faces that share a layout; nothing where one serves all."""
    groups = layout_groups(spec)
    if len(groups) == 1:
        return [""]
    return [f", face{'s' * (len(g) > 1)} {', '.join(map(str, g))}" for g in groups]


def _moved_magnets(
    start: ObjectSpec, changed: ObjectSpec, face: int, label: str
) -> list[list[str]]:
    old, new = (
        np.array([b.centre_mm for b in magnet_bodies(spec)[face]]) for spec in (start, changed)
    )
    tilts = changed.magnets.tilt_deg or ((0.0, 0.0),) * len(new)
    return [
        [
            f"magnet {j + 1}{label}",
            _point(old[i]),
            _point(new[j]),
            f"{np.linalg.norm(new[j] - old[i]):.1f}",
            f"{tilts[j][0]:g}, {tilts[j][1]:g}",
            f"{'outward' if changed.magnets.polarities[j] > 0 else 'inward'}{_kind(changed, j)}",
        ]
        for i, j in paired(old[:, :2], new[:, :2])
    ]


def _kind(changed: ObjectSpec, magnet: int) -> str:
    return f", {changed.magnets.kinds[magnet]}" if _kinds_differ(changed) else ""


def _moved_sensors(
    start: ObjectSpec, changed: ObjectSpec, face: int, label: str
) -> list[list[str]]:
    old, new = (np.array(sensor_places(spec)[face])[:, :2] for spec in (start, changed))
    label = label or f", face {changed.body.sensed[face]}"
    return [
        [
            f"sensor {j + 1}{label}",
            _point(old[i]),
            _point(new[j]),
            f"{np.linalg.norm(new[j] - old[i]):.1f}",
            "",
            "",
        ]
        for i, j in paired(old, new)
    ]


def _other_changes(start: ObjectSpec, changed: ObjectSpec) -> list[tuple[str, str, str]]:
    def stated(spec: ObjectSpec) -> list[str]:
        magnets, sensors = spec.magnets, spec.sensors
        return [
            str(magnets.count),
            ", ".join(size.told for size in magnets.distinct_sizes),
            str(sensors.count_per_face),
            sensors.chip,
        ]

    labels = ("magnets per face", "magnet", "sensors per face", "chips")
    return list(zip(labels, stated(start), stated(changed), strict=True))


def _point(values: np.ndarray) -> str:
    return ", ".join(f"{abs(v) if k == 2 else v:.2f}" for k, v in enumerate(values))
