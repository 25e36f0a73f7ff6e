"""Random specifications: objects as `instobj new` places them, then edited as users do.

Everything follows from the seed.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from design.placement.objects import Request, Tables, first_fit
from tests.support.objects.random_objects import made_surface

KINDS = ("box", "pad", "cylinder", "capsule", "sphere", "ellipsoid", "dome", "imported")
Edit = Callable[[np.random.Generator, Tables], None]
_MOST_EDITS = 4


def drawn(seed: int, folder: Path) -> Tables | None:
    """The specification of a seed, as parsed TOML; None where the body is too small for its parts.

    A file that it reads is written to the folder.
    """
    rng = np.random.default_rng(seed)
    kind = kind_of(seed)
    tables = first_fit(_request(rng, kind, folder))
    if tables is None:
        return None
    edits = [edit for edit, kinds in EDITS if kind in kinds]
    for number in rng.choice(len(edits), rng.integers(_MOST_EDITS + 1), replace=False):
        edits[number](rng, tables)
    return {"name": f"seed_{seed}", **tables}


def kind_of(seed: int) -> str:
    """Kinds take turns, so that any run of seeds holds all of them evenly."""
    return KINDS[seed % len(KINDS)]


def _request(rng: np.random.Generator, kind: str, folder: Path) -> Request:
    size = _size_mm(rng, kind)
    sensors, magnets = int(rng.integers(1, 5)), int(rng.integers(1, 7))
    if kind != "imported":
        return Request(kind, size, sensors, magnets)
    waves = [
        {
            "along": rng.uniform(-2, 2, 3).tolist(),
            "phase": float(rng.uniform(0, 6.28)),
            "height": float(rng.uniform(-0.04, 0.04)),
        }
        for _ in range(4)
    ]
    path = folder / "made.stl"
    made_surface({"size_mm": list(size), "waves": waves}).export(path)
    from design.body.imported import body_of_file

    read = body_of_file(path)
    return Request(kind, tuple(read["size_mm"]), sensors, magnets, (("file", read["file"]),))


def _size_mm(rng: np.random.Generator, kind: str) -> tuple[float, float, float]:
    """From a fingertip's to a bottle's; most between 40 and 80 mm."""
    x, y, z = (float(edge) for edge in np.exp(rng.normal(np.log(58), 0.25, 3)).round(1))
    if kind == "pad":
        return x, y, round(float(rng.uniform(10, 16)), 1)
    if kind == "dome":
        return x, x, round(x / 2 + float(rng.uniform(4, 8)), 1)
    if kind == "sphere":
        return x, x, x
    if kind == "capsule":
        return min(x, z), min(x, z), max(x, z) + 5.0
    return (x, x, z) if kind == "cylinder" else (x, y, z)


def _set(where: str, *choices: Any) -> Edit:
    """One of some values for a key."""
    *tables_above, key = where.split(".")

    def edit(rng: np.random.Generator, tables: Tables) -> None:
        holder: dict[str, Any] = tables
        for name in tables_above:
            holder = holder.setdefault(name, {})
        holder[key] = choices[rng.integers(len(choices))]

    return edit


def _between(where: str, low: float, high: float) -> Edit:
    """A uniform number for a key."""

    def edit(rng: np.random.Generator, tables: Tables) -> None:
        _set(where, round(float(rng.uniform(low, high)), 2))(rng, tables)

    return edit


def _moved_magnets(rng: np.random.Generator, tables: Tables) -> None:
    magnets = tables["magnets"]
    places = np.array(magnets["positions_mm"])
    magnets["positions_mm"] = (places + rng.normal(0, 2, places.shape)).round(2).tolist()


def _tilted(rng: np.random.Generator, tables: Tables) -> None:
    count = np.shape(tables["magnets"]["positions_mm"])[-2]
    tables["magnets"]["tilt_deg"] = rng.uniform(-15, 15, (count, 2)).round(1).tolist()


def _channels(rng: np.random.Generator, tables: Tables) -> None:
    width, depth = rng.uniform([0.5, 0.4], [3.0, 2.0]).round(2)
    tables["core"] |= {"wire_channel_mm": [float(width), float(depth)]}


def _keyed(rng: np.random.Generator, tables: Tables) -> None:
    places = rng.uniform(-11, 11, (int(rng.integers(1, 3)), 2)).round(1).tolist()
    width, length, height = rng.uniform(1.0, 4.0, 3).round(1).tolist()
    keys = {"positions_mm": places, "size_mm": [width, length, height]}
    tables["core"]["keys"] = keys


def _outward_chips(rng: np.random.Generator, tables: Tables) -> None:
    tables["sensors"] |= {"chip": "outward", "depth_below_core_face_mm": 0.7}


def _resized(rng: np.random.Generator, tables: Tables) -> None:
    shell = tables["shell"]
    shell["thickness_mm"] = round(shell["thickness_mm"] + float(rng.uniform(-1, 1)), 2)


_BORED = ("capsule", "sphere", "ellipsoid", "imported")
EDITS: tuple[tuple[Edit, tuple[str, ...]], ...] = (
    (_moved_magnets, KINDS),
    (_resized, KINDS),
    (_channels, KINDS),
    (_outward_chips, KINDS),
    (_between("shell.pocket_depth_mm", 1.5, 4.5), KINDS),
    (_between("shell.pocket_diameter_mm", 4.0, 8.0), KINDS),
    (_between("core.wall_mm", 3.0, 8.0), KINDS),
    (_between("core.wire_hole_side_diameter_mm", 1.5, 5.0), KINDS),
    (_between("core.recess_depth_mm", 2.9, 4.0), KINDS),
    (_between("mould.parting_azimuth_deg", 0.0, 180.0), KINDS),
    (_between("mould.wall_mm", 1.2, 4.0), KINDS),
    (_set("mould.style", "split"), KINDS),
    (_set("printer.name", "resin", "sls", "fdm-0.25"), KINDS),
    (_set("magnets.shape", "block"), KINDS),
    (_set("sensors.package_mm", [4.0, 4.0, 1.6], [6.0, 5.0, 1.0]), KINDS),
    (_set("body.open_faces", []), (*_BORED, "box", "cylinder")),
    (_between("body.bore_mm", 3.0, 14.0), _BORED),
    (_set("body.open_faces", [1], [3], [5, 6], [2, 6], [1, 2, 6]), ("box",)),
    (_set("body.open_faces", [1], [1, 6]), ("cylinder",)),
    (_set("body.inside", "silicone", "air"), ("dome",)),
    (_tilted, ("box", "pad")),
    (_set("arrangement", "sensors-in-shell"), ("box",)),
    (_between("shell.slits.depth_mm", 1.0, 6.0), ("box", "cylinder")),
    (_between("shell.seal_layer_mm", 0.3, 1.0), KINDS),
    (_keyed, tuple(kind for kind in KINDS if kind != "pad")),
    (_set("core.bay_mm", [10.0, 10.0, 10.0], [16.0, 14.0, 12.0]), ("box", "cylinder")),
    (_set("core.bay_mm", [10.0, 8.0, 3.0], [20.0, 14.0, 5.0]), ("dome", "pad")),
)
"""What users change, and of which kinds."""
