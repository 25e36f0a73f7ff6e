"""A second draw of specifications, with other habits: examples of other sizes with changed keys, and
bodies of all sizes and shapes as `instobj new` places their parts, half of these changed too.

Everything follows from the seed.
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from design.body.imported import body_of_file
from design.placement.objects import Request, Tables, first_fit
from design.spec.body import MM
from tests.random_designs.draw import KINDS, kind_of
from tests.random_designs.edits import EDITS, put
from tests.random_designs.foreign_shapes import foreign_shape
from tests.support.pages import ROOT

EXAMPLES = {
    "box": ("paper_cube", "better_cube", "locked_cube", "relief_cube", "reverse_cube"),
    "pad": ("hall_skin", "eflesh_pad"),
    "cylinder": ("handle",),
    "capsule": ("capsule",),
    "sphere": ("ball",),
    "ellipsoid": ("egg",),
    "dome": ("three_axis_dome", "hollow_dome"),
    "imported": ("pear",),
}
_STREAM = 2
"""So that seeds draw other numbers than the first generator's."""


def drawn(seed: int, folder: Path) -> Tables | None:
    """The specification of a seed, as parsed TOML; None where the body is too small for its parts.

    A file that it reads is written to the folder. Examples and bodies for `instobj new` take turns
    after each round of kinds.
    """
    rng, kind = np.random.default_rng([_STREAM, seed]), kind_of(seed)
    if of_example(seed):
        tables, count = _example(rng, kind, folder), int(rng.integers(1, 6))
    else:
        placed = first_fit(_request(rng, kind, folder))
        if placed is None:
            return None
        tables, count = placed, int(max(0, rng.integers(-2, 3)))
    edits = [edit for edit, kinds in EDITS if kind in kinds]
    for number in rng.choice(len(edits), count, replace=False):
        edits[number](rng, tables)
    return {**tables, "name": f"edits_{seed}"}


def of_example(seed: int) -> bool:
    return seed // len(KINDS) % 2 == 0


def _example(rng: np.random.Generator, kind: str, folder: Path) -> Tables:
    """One of the kind's examples; two of three have another size."""
    names = EXAMPLES[kind]
    text = (ROOT / "examples" / f"{names[rng.integers(len(names))]}.toml").read_text()
    tables = tomllib.loads(text)
    if kind == "imported":
        tables["body"] |= _pear(rng, folder)
    elif rng.random() < 2 / 3:
        size = tables.get("body", {}).get("size_mm", [42.0, 42.0, 42.0])
        put(tables, "body.size_mm", _scaled(rng, kind, size, tables))
    return tables


def _scaled(rng: np.random.Generator, kind: str, size: list[float], tables: Tables) -> list[float]:
    """More often larger than smaller; edges that may differ do, by up to a third."""
    grown = float(np.exp(rng.uniform(np.log(0.85), np.log(2.6))))
    x, y, z = (np.array(size) * grown * np.exp(rng.uniform(-0.15, 0.15, 3))).round(1).tolist()
    if kind == "pad":
        slab = tables["shell"]["thickness_mm"]
        return [x, y, round(slab + float(rng.uniform(3.5, 9.0)), 1)]
    if kind == "dome":
        return [x, x, round(x / 2 + float(rng.uniform(3.6, 9.0)), 1)]
    if kind == "sphere":
        return [x, x, x]
    if kind == "capsule":
        return [x, x, round(max(z, x + 2.0), 1)]
    return [x, x, z] if kind == "cylinder" else [x, y, z]


def _pear(rng: np.random.Generator, folder: Path) -> dict[str, Any]:
    """The example's file, stretched and written in one of four units, read larger or smaller."""
    surface = trimesh.load_mesh(ROOT / "examples" / "bodies" / "pear.stl")
    surface.apply_transform(np.diag([*np.exp(rng.uniform(-0.12, 0.12, 3)), 1.0]))
    return _written(rng, surface, folder, round(float(rng.uniform(0.9, 2.0)), 2))


def _written(
    rng: np.random.Generator, surface: trimesh.Trimesh, folder: Path, scale: float = 1.0
) -> dict[str, Any]:
    """What `[body]` takes of a surface (mm) once it is written in some unit."""
    unit, path = list(MM)[rng.integers(len(MM))], folder / "foreign.stl"
    surface.copy().apply_scale(1 / MM[unit]).export(path)
    return {"scale": MM[unit] * scale} | body_of_file(path, MM[unit] * scale)


def _request(rng: np.random.Generator, kind: str, folder: Path) -> Request:
    """What a user asks `instobj new` for: 18 to 160 mm, up to six sensors and nine magnets per face."""
    sensors = int(rng.integers(1, 7))
    magnets = None if rng.random() < 0.3 else int(rng.integers(1, 10))
    if kind == "imported":
        longest = float(np.exp(rng.uniform(np.log(40), np.log(160))))
        body = _written(rng, foreign_shape(rng, longest), folder)
        keys = tuple((key, body[key]) for key in ("file", "scale"))
        return Request(kind, tuple(body["size_mm"]), sensors, magnets, keys)
    return Request(kind, _size_mm(rng, kind), sensors, magnets)


def _size_mm(rng: np.random.Generator, kind: str) -> tuple[float, float, float]:
    x, y, z = np.exp(rng.uniform(np.log(18), np.log(160), 3)).round(1).tolist()
    if kind == "pad":
        return x, y, round(float(rng.uniform(9, 22)), 1)
    if kind == "dome":
        return x, x, round(x / 2 + float(rng.uniform(3.6, 12)), 1)
    if kind == "sphere":
        return x, x, x
    if kind == "capsule":
        return min(x, z), min(x, z), round(max(x, z) + 2.0, 1)
    return (x, x, z) if kind == "cylinder" else (x, y, z)
