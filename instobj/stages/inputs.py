"""Inputs of a stage: everything that its result depends on, for its content key."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from design.spec.object import ObjectSpec
from instobj.store.stage import Stage


def _shell_bodies(spec: ObjectSpec) -> dict[str, Any]:
    """Place and outline of what is cast into the silicone: all that mechanics knows of it; of bodies of
    one size as before there were others, so that stored results stay."""
    from design.layout.places.positions import shell_body_layout

    layout = shell_body_layout(spec)
    sizes = [(asdict(body.outline), body.height_mm) for body in layout.bodies]
    alike = all(size == sizes[0] for size in sizes)
    outlines, heights_mm = sizes[0] if alike else zip(*sizes, strict=True)
    return {
        "centre_mm": layout.centre_mm.tolist(),
        "frame": layout.frame.tolist(),
        "outline": outlines,
        "height_mm": heights_mm,
    }


def _sensors(spec: ObjectSpec) -> dict[str, Any]:
    """Their table, and by how much a curved core's recesses set them deeper."""
    from design.layout.places.positions import board_sinks_mm

    table, sinks = spec.sensors.model_dump(mode="json"), board_sinks_mm(spec)
    if table["rotations_deg"] is None:
        del table["rotations_deg"]
    in_core = spec.arrangement == "sensors-in-core"
    return table | {"sinks_mm": sinks} if in_core and any(map(any, sinks)) else table


def _contact_grid(spec: ObjectSpec) -> dict[str, Any]:
    """Return what is pressed, however it was asked for: a filled grid that all faces share is its counts.

    Curved faces' grids were once even in the plane's x and y, and their results are others.
    """
    from design.layout.body import face_frames
    from design.layout.places.contact_places import contact_places, grid_count

    grid: dict[str, Any] = {
        "count": list(grid_count(spec)),
        "pitch_mm": spec.contact_grid.pitch_mm,
    }
    if not all(frame.flat for frame in face_frames(spec)):
        grid["steps"] = "along the surface"
    places = contact_places(spec)
    if places.all():
        return grid
    return grid | {
        "places": ["".join("01"[has_place] for has_place in face) for face in places.tolist()]
    }


def _shell(spec: ObjectSpec) -> dict[str, Any]:
    """Its table; without dents as before there was a key for them, so that stored results stay."""
    table = spec.shell.model_dump(mode="json")
    return table if table["dent_mm"] else {k: v for k, v in table.items() if k != "dent_mm"}


def _mould(spec: ObjectSpec) -> dict[str, Any]:
    """Its table; templates of flat faces alone as before there was a key for them."""
    table = spec.mould.model_dump(mode="json")
    if table["magnet_templates"] == "flat":
        del table["magnet_templates"]
    return table


def _dents(spec: ObjectSpec) -> list[list[float]] | None:
    from design.layout.dents import dents_mm

    depth = dents_mm(spec)
    return depth.tolist() if depth.any() else None


def stage_inputs(
    stage: Stage, spec: ObjectSpec, origins: dict[str, str], versions: dict[str, str]
) -> dict[str, Any]:
    """Everything that a stage's result depends on, JSON-able, for its content key.

    `origins` holds key and content of the results that it is made from: the mesher, for one, gives
    another mesh from the same specification.
    """
    from design.body.imported import file_digest

    bodies, silicone = _shell_bodies(spec), spec.silicone.model_dump(mode="json")
    if not silicone["layers"]:  # results of specifications without newer keys stay
        del silicone["layers"]
    content = spec.model_dump(mode="json") | {
        "body": spec.body.model_dump(mode="json") | {"file": file_digest(spec.body.file)},
        "silicone": silicone,
        "sensors": _sensors(spec),
        "contact_grid": _contact_grid(spec),
        "shell": _shell(spec),
        "mould": _mould(spec),
        "dents": _dents(spec),
        "shell_bodies": bodies,
        "shell_body_cylinder": [bodies["outline"], bodies["height_mm"]],
    }
    parts: dict[str, Any] = {}
    for name in stage.depends_on:
        if name == "silicone.layers" and "layers" not in silicone:
            continue
        value: Any = content
        for part in name.split("."):
            value = value[part]
        if name != "dents" or value is not None:
            parts[name] = value
    return {
        "spec": parts,
        "needs": origins,
        "version": stage.version,
        "libraries": versions,
    }
