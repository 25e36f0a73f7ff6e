"""Comments of a new specification that differ from the cube's, kind by kind."""

from __future__ import annotations

from design.body.kinds.base import BodyKind
from design.body.kinds.registry import KINDS

_BORE = "[6]: a bore through -z, by whose rod the core is held while it is cast in; []: none"
_ROUND = {
    "body.open_faces": _BORE,
    "body.bore_mm": "through the open face 6",
    "core.keys.positions_mm": "x, y on every sensed face of the core, beside recesses and wire hole",
}
_SIZES = {
    "box": "edges along x, y, z, silicone and core together",
    "pad": "the slab's edges along x and y, its height with the plate under it",
    "cylinder": "the diameter twice, the height; along z",
    "capsule": "the diameter twice, the whole length along z",
    "sphere": "the diameter, three times",
    "ellipsoid": "the diameters along x, y, z",
    "dome": "the diameter twice, the height with the rigid base",
}
_OF_KIND: dict[str, dict[str, str]] = {
    "box": {"core.keys.positions_mm": _ROUND["core.keys.positions_mm"]},
    "cylinder": {
        "body.open_faces": "[6], [1] or both: ends at which the core's cavity runs out; []: closed",
        "shell.slits": "relief slits halfway between the sides 2 to 5",
        "shell.slits.depth_mm": "from the surface inwards; 0: none",
        "shell.slits.end_mm": "how far before the ends they stop",
        "core.keys.positions_mm": _ROUND["core.keys.positions_mm"],
    },
    "dome": {"core.keys.positions_mm": _ROUND["core.keys.positions_mm"]},
    "capsule": _ROUND,
    "sphere": _ROUND,
    "ellipsoid": _ROUND,
    "imported": _ROUND,
}
BAYS_MM = {
    "box": (10.0, 10.0, 10.0),
    "cylinder": (10.0, 10.0, 10.0),
    "pad": (10.0, 8.0, 2.0),
    "dome": (10.0, 8.0, 2.0),
}
"""Bays small enough for most bodies of a kind, as examples."""


def comment_of(name: str, kind: type[BodyKind]) -> str | None:
    """What stands beside a key or above a table of a placed object; None: the template's own words."""
    if name == "body.kind":
        others = ", ".join(other for other in KINDS if other != kind.name)
        return f"or {others}: `instobj docs bodies`"
    if name == "body.size_mm":
        return _SIZES.get(kind.name)
    if name == "contact_grid.count":
        return "as many as fit on each face; or x and y for all of them, such as [10, 10]"
    return _OF_KIND.get(kind.name, {}).get(name)
