"""Judgement of one random specification: by booleans of triangles on the parts that are built.

Bodies are made of the specification's numbers here (magnets, boards, chips as cylinders and blocks),
parts are those of the build; nothing of the checks of fit or fabrication is asked.
"""

from __future__ import annotations

import resource
import time
import traceback
from collections.abc import Callable
from itertools import combinations
from pathlib import Path
from typing import Any

import manifold3d
import numpy as np
import trimesh

from design.body.meshes import manifold_of
from design.build.parts import parts_of
from design.errors import InputError
from design.fabrication.check import check_fabrication
from design.fit.seam import seam_in_words
from design.layout.boards import mounted_sensors
from design.layout.body import body_of
from design.layout.places.positions import magnet_layout
from design.solids.booleans import convert_to_triangles
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from tests.random_designs import draw, draw_edits
from tests.random_designs.draw import kind_of
from tests.random_designs.openings import (
    blocked_ways,
    left_over,
    meeting_pins,
    placed_pins,
    thin_covers,
)
from tests.random_designs.summary import LONGEST_S

GENERATORS = {"placed": draw.drawn, "edits": draw_edits.drawn}
"""How seeds become specifications: as placed and edited by a few keys, or with other habits."""
MOST_S = 5 * LONGEST_S
"""Processor time after which a seed is given up: its process ends by SIGXCPU."""
SKIN_MM = 0.02
"""Triangles leave curved surfaces by so much: of common volume, that times the smaller's area is none."""
_CLEAR_MM = 1e-3
"""By which magnets, boards and chips are drawn in: of faces that touch, booleans of triangles may take
the wrong side (1.2 of a block magnet's 25 mm³ in a pocket that it fills)."""
_MEETING = [("core", f"mould_{part}") for part in ("plug", "box", "half_a", "half_b")]
_FIRST = ("mould_box", "mould_half_a", "mould_half_b")
_SEAL = ("mould_seal_box", "mould_seal_half_a", "mould_seal_half_b")
_MOULD = (*_FIRST, *_SEAL, "mould_plug", "mould_holder")


def work_of(work: Callable[..., Any]) -> Callable[..., Any]:
    """Return the work itself: a process of its own has nothing to prepare."""
    return work


def judged(question: dict[str, Any]) -> dict[str, Any]:
    """What became of the seed in `question`, of the generator named there, in processor seconds.

    `outcome` is "too small" (by the placement), "refused by check", "refused by build", "crash",
    "violates", "told by check" (with what its mould's seam does), "told by fabrication" (whose checks fail)
    or "sound".
    """
    started = time.process_time()
    _, hard = resource.getrlimit(resource.RLIMIT_CPU)
    resource.setrlimit(resource.RLIMIT_CPU, (int(started + MOST_S) + 1, hard))
    try:
        tables = GENERATORS[question["generator"]](question["seed"], Path(question["folder"]))
        outcome, why = outcome_of(tables)
    except Exception:
        outcome, why = "crash", traceback.format_exc(limit=-4)
    seconds = time.process_time() - started
    return {
        "generator": question["generator"],
        "seed": question["seed"],
        "kind": kind_of(question["seed"]),
        "outcome": outcome,
        "seconds": round(seconds, 1),
        "why": why,
    }


def outcome_of(tables: draw.Tables | None) -> tuple[str, str]:
    if tables is None:
        return "too small", ""
    try:
        spec = parse_spec(tables, tables["name"])
    except InputError as error:
        return "refused by check", str(error)
    what = f"{spec.body.kind} {spec.body.size_mm}: "
    try:
        parts = {part.name: convert_to_triangles(part.make()) for part in parts_of(spec)}
    except InputError as error:
        return "refused by build", what + str(error)
    wrong = violations(spec, parts)
    if not wrong:
        return "sound", what
    if warned := seam_in_words(spec):
        return "told by check", what + "; ".join([*wrong, *(f"told: {one}" for one in warned)])
    told = [f for f in check_fabrication(spec).findings if f.status == "fail"]
    outcome = "told by fabrication" if told else "violates"
    return outcome, what + "; ".join([*wrong, *(f"told: {f.check}, {f.part}" for f in told)])


def violations(spec: ObjectSpec, parts: dict[str, trimesh.Trimesh]) -> list[str]:
    """What the parts do that their specification forbids."""
    wrong = [f"{name} is open or in pieces" for name, mesh in parts.items() if not _whole(mesh)]
    solid = {
        name: manifold_of(mesh)
        for name, mesh in parts.items()
        if mesh.is_watertight and name in ("core", "shell", *_MOULD)
    }
    outer = manifold_of(body_of(spec).outer_surface())
    cast_in = body_of(spec).opening in ("closed", "bore")
    for a, b in combinations(solid, 2):
        if (a, b) in _MEETING and not cast_in:
            continue  # an open side's plug stands where the core will be
        if (a in _FIRST and b in _SEAL) or ((a, b) == ("core", "mould_seal_box") and not cast_in):
            continue  # one mould after the other
        wrong += _shared(a, solid[a], b, solid[b])
    for name, magnet in _magnets(spec):
        for part in ("core", "shell"):
            if part in solid:
                wrong += _shared(name, magnet, part, solid[part])
        if spec.arrangement == "sensors-in-core" and _beyond(magnet - outer, magnet):
            wrong.append(f"{name} stands out of the body")
    for name, board in _boards(spec):
        for part in ("core", "shell"):
            if part in solid:
                wrong += _shared(name, board, part, solid[part])
    pins = placed_pins(spec, parts)
    return [
        *wrong,
        *(thin_covers(spec, body_of(spec).outer_surface()) if "shell" in solid else []),
        *blocked_ways(spec, solid, pins),
        *meeting_pins(solid, pins),
        *left_over(spec, solid, pins),
    ]


def _whole(mesh: trimesh.Trimesh) -> bool:
    pieces = [piece for piece in mesh.split(only_watertight=False) if piece.volume > 0]
    return bool(mesh.is_watertight and mesh.is_winding_consistent and len(pieces) == 1)


def _shared(
    name: str, one: manifold3d.Manifold, part: str, other: manifold3d.Manifold
) -> list[str]:
    common = one ^ other
    smaller = min(one, other, key=lambda body: body.surface_area())
    if not _beyond(common, smaller):
        return []
    place = np.reshape(common.bounding_box(), (2, 3)).mean(axis=0).round(1).tolist()
    return [f"{name} and {part} share {common.volume():.3g} mm³ at {place}"]


def _beyond(common: manifold3d.Manifold, smaller: manifold3d.Manifold) -> bool:
    """Whether a common volume is thicker than the skin by which triangles leave surfaces."""
    return bool(common.volume() > SKIN_MM * smaller.surface_area() / 2)


def _magnets(spec: ObjectSpec) -> list[tuple[str, manifold3d.Manifold]]:
    magnets, layout, found = spec.magnets, magnet_layout(spec), []
    for k, (centre, axis, side) in enumerate(
        zip(layout.centre_mm, layout.axis, layout.side, strict=True), start=1
    ):
        if magnets.shape == "block":
            edges = np.array([*magnets.size_mm, magnets.height_mm]) - 2 * _CLEAR_MM
            solid = manifold3d.Manifold.cube(tuple(edges), True)
        else:
            radius, height = magnets.diameter_mm / 2 - _CLEAR_MM, magnets.height_mm - 2 * _CLEAR_MM
            solid = manifold3d.Manifold.cylinder(height, radius, radius, 64, True)
        pose = np.column_stack([side, np.cross(axis, side), axis, centre])
        found.append((f"magnet {k}", solid.transform(pose)))
    return found


def _boards(spec: ObjectSpec) -> list[tuple[str, manifold3d.Manifold]]:
    found = []
    for sensor in mounted_sensors(spec):
        for what, block in (("board", sensor.board), ("chip", sensor.chip)):
            cube = manifold3d.Manifold.cube(tuple(2 * (block.half_mm - _CLEAR_MM)), True)
            pose = np.column_stack([block.axes, block.centre_mm])
            if np.linalg.det(block.axes) < 0:
                pose[:, 2] *= -1
            found.append((f"the {what} of {sensor.label}", cube.transform(pose)))
    return found
