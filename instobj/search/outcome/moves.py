"""Moves and changes of a search, from the start to the found layout."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from design.layout.pockets import magnet_bodies
from design.spec.object import ObjectSpec
from instobj.search.outcome.figures import draw_moves, paired


def moved_parts(start: ObjectSpec, found: ObjectSpec, folder: Path) -> dict[str, Any]:
    """Picture, rows of moved magnets and sensors, and other changes, as the page shows them."""
    draw_moves(start, found, folder / "moves.png")
    before, after = magnet_bodies(start)[0], magnet_bodies(found)[0]
    old, new = (np.array([b.centre_mm for b in bodies]) for bodies in (before, after))
    tilts = found.magnets.tilt_deg or ((0.0, 0.0),) * len(new)
    rows = [
        [
            f"magnet {j + 1}",
            _point(old[i]),
            _point(new[j]),
            f"{np.linalg.norm(new[j] - old[i]):.1f}",
            f"{tilts[j][0]:g}, {tilts[j][1]:g}",
            "outward" if found.magnets.polarities[j] > 0 else "inward",
        ]
        for i, j in paired(old[:, :2], new[:, :2])
    ]
    seen = [np.array([p[:2] for p in one.sensors.places[0]]) for one in (start, found)]
    rows += [
        [
            f"sensor {j + 1}, face 1",
            _point(seen[0][i]),
            _point(seen[1][j]),
            f"{np.linalg.norm(seen[1][j] - seen[0][i]):.1f}",
            "",
            "",
        ]
        for i, j in paired(*seen)
    ]
    others = [
        f"{label} {old_value} → {new_value}"
        for label, old_value, new_value in _other_changes(start, found)
        if old_value != new_value
    ]
    return {"moves_picture": folder / "moves.png", "moves": rows, "other_changes": others}


def _other_changes(start: ObjectSpec, found: ObjectSpec) -> list[tuple[str, str, str]]:
    def stated(spec: ObjectSpec) -> list[str]:
        size = " × ".join(f"{edge:g}" for edge in spec.body.size_mm)
        magnets, sensors = spec.magnets, spec.sensors
        return [
            str(magnets.count),
            f"Ø{magnets.diameter_mm:g} × {magnets.height_mm:g} mm",
            str(sensors.count_per_face),
            f"{sensors.chip}, turned {sensors.mount_rotation_deg[2]:g}°",
            f"±{sensors.range_mt:g} mT",
            f"{spec.shell.thickness_mm:g} mm",
            spec.silicone.name,
            f"{size} mm",
        ]

    labels = ("magnets per face", "magnet", "sensors per face", "chips", "range", "shell", "silicone",
              "body")  # fmt: skip
    return list(zip(labels, stated(start), stated(found), strict=True))


def _point(values: np.ndarray) -> str:
    return ", ".join(f"{abs(v) if k == 2 else v:.2f}" for k, v in enumerate(values))
