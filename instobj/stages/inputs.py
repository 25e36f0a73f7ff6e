"""Inputs of a stage: everything that its result depends on, for its content key."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from design.spec.object import ObjectSpec
from instobj.store.stage import Stage


def _shell_bodies(spec: ObjectSpec) -> dict[str, Any]:
    """Places, and outlines with heights, of what is cast into the silicone: all that mechanics knows of
    it. Bodies of one size have one outline, however many they are."""
    from design.layout.places.positions import shell_body_layout

    layout = shell_body_layout(spec)
    sizes = [[asdict(body.outline), body.height_mm] for body in layout.bodies]
    alike = all(size == sizes[0] for size in sizes)
    return {
        "centre_mm": layout.centre_mm.tolist(),
        "frame": layout.frame.tolist(),
        "sizes": sizes[:1] if alike else sizes,
    }


def _sinks_mm(spec: ObjectSpec) -> Any:
    """Return by how much a curved core's recesses set sensors deeper, which signals depend on."""
    from design.layout.places.positions import board_sinks_mm

    return board_sinks_mm(spec) if spec.arrangement == "sensors-in-core" else None


def _contact_grid(spec: ObjectSpec) -> dict[str, Any]:
    """Return what is pressed, however it was asked for: a filled grid is its counts and its places."""
    from design.layout.places.contact_places import contact_places, grid_count

    return {
        "count": list(grid_count(spec)),
        "pitch_mm": spec.contact_grid.pitch_mm,
        "places": [
            "".join("01"[place] for place in face) for face in contact_places(spec).tolist()
        ],
    }


def stage_inputs(
    stage: Stage, spec: ObjectSpec, origins: dict[str, str], versions: dict[str, str]
) -> dict[str, Any]:
    """Everything that a stage's result depends on, JSON-able, for its content key.

    `origins` holds key and content of the results that it is made from: the mesher, for one, gives
    another mesh from the same specification.
    """
    from design.body.imported import file_digest
    from design.layout.dents import dents_mm

    content, bodies = spec.model_dump(mode="json"), _shell_bodies(spec)
    content["body"]["file"] = file_digest(spec.body.file)
    content["sensors"]["sinks_mm"] = _sinks_mm(spec)
    content |= {
        "contact_grid": _contact_grid(spec),
        "dents": dents_mm(spec).tolist(),
        "shell_bodies": bodies,
        "shell_body_cylinder": bodies["sizes"],
    }
    parts: dict[str, Any] = {}
    for name in stage.depends_on:
        value: Any = content
        for part in name.split("."):
            value = value[part]
        parts[name] = value
    return {
        "spec": parts,
        "needs": origins,
        "version": stage.version,
        "libraries": versions,
    }
