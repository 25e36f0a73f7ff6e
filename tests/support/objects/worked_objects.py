"""Objects off their symmetries, one for every way in which parts are worked out as numbers."""

from functools import cache

from design.spec.object import ObjectSpec

_GRID = {"contact_grid": {"count": [3, 2], "pitch_mm": 2.5}, "press": {"depths_mm": [0.5, 1.5]}}
_CORE = {
    "recess_inner_radius_mm": 2.5,
    "recess_outer_radius_mm": 6.5,
    "recess_width_mm": 4.0,
    "recess_depth_mm": 2.6,
    "wire_hole_top_diameter_mm": 2.2,
    "wire_hole_side_diameter_mm": 3.0,
}
_SENSORS = {
    "positions_mm": [[4.2, 1.5], [-2.0, 5.0]],
    "radius_mm": 4.8,
    "package_mm": [3.8, 3.6, 1.2],
    "chip_mm": [1.9, 1.7, 0.9],
}
_MAGNETS = {
    "positions_mm": [[3.0, -6.0], [-7.0, 2.0], [5.0, 5.5]],
    "diameter_mm": 4.0,
    "height_mm": 1.2,
    "north": ["outward", "inward", "outward"],
}
_POCKETS = {"pocket_diameter_mm": 4.2, "pocket_depth_mm": 3.1}


def _object(body, **tables):
    content = {
        "core": _CORE,
        "sensors": _SENSORS,
        "magnets": _MAGNETS,
        "shell": {"thickness_mm": 8.0, **_POCKETS},
        **_GRID,
    }
    for name, values in tables.items():
        content[name] = content.get(name, {}) | values
    return {"name": "worked", "body": body, **content}


_OWN_LISTS = [[[1.0 + 0.3 * k, -4.0], [-6.0, 3.0 - 0.4 * k], [6.0, 4.5]] for k in range(4)]
_OBLONG = {"size_mm": [46.0, 50.0, 56.0]}
_ONE = {"positions_mm": [[0.0, 0.0]], "north": ["inward"]}
_SLITS = {"slits": {"depth_mm": 3.5, "width_mm": 0.9}}
_ROUND = {"positions_mm": [[1.5, -4.0], [-4.5, 2.0]], "north": ["outward", "inward"]}
_FEW = {"positions_mm": [[3.9, 1.0]]}
OBJECTS = {
    "box": _object(
        _OBLONG,
        core={
            "keys": {"positions_mm": [[10.5, -10.0]], "size_mm": [2.0, 1.5, 1.1]},
            "wire_channel_mm": [1.5, 0.8],
            "bay_mm": [15.0, 16.0, 12.0],
        },
        shell={**_SLITS, "seal_layer_mm": 0.4},
        magnets={"tilt_deg": [[0, 0], [6.0, -4.0], [0.0, 8.0]], "depth_mm": [2.4, 2.6, 2.9]},
    ),
    "box open at a side": _object(
        _OBLONG | {"open_faces": [5, 6]},
        magnets={"positions_mm": _OWN_LISTS},
        shell=_SLITS,
        mould={"style": "split", "wall_mm": 2.2},
        printer={"clearance_mm": 0.15},
    ),
    "closed box": _object(_OBLONG | {"open_faces": []}, shell={"seal_layer_mm": 0.5}),
    "reverse box": _object(
        _OBLONG,
        arrangement={},
        core={"wall_mm": 5.0},
        magnets={
            "positions_mm": [[5.5, -2.0], [-3.0, 6.0]],
            "north": [],
            "shape": "block",
            "size_mm": [4.0, 3.0],
            "depth_below_core_face_mm": 0.3,
        },
        sensors={"chip": "outward"},
    ),
    "pad": _object({"kind": "pad", "size_mm": [40.0, 34.0, 13.0]}),
    "cylinder": _object(
        {"kind": "cylinder", "size_mm": [46.0, 46.0, 54.0]},
        core={
            "keys": {"positions_mm": [[11.0, 6.0]], "size_mm": [2.0, 1.5, 1.1]},
            "wire_channel_mm": [1.5, 1.0],
            "bay_mm": [9.0, 10.0, 12.0],
        },
        shell=_SLITS,
        mould={"style": "split"},
    ),
    "sleeve": _object(
        {"kind": "cylinder", "size_mm": [46.0, 46.0, 54.0], "open_faces": [1, 6]},
        magnets=_ROUND,
    ),
    "closed cylinder": _object(
        {"kind": "cylinder", "size_mm": [46.0, 46.0, 54.0], "open_faces": []}, magnets=_ONE
    ),
    "capsule": _object(
        {"kind": "capsule", "size_mm": [48.0, 48.0, 66.0], "bore_mm": 7.0},
        magnets=_ROUND,
        shell={"seal_layer_mm": 0.4},
    ),
    "closed capsule": _object(
        {"kind": "capsule", "size_mm": [48.0, 48.0, 66.0], "open_faces": []}, magnets=_ROUND
    ),
    "sphere": _object({"kind": "sphere", "size_mm": [50.0] * 3, "bore_mm": 7.5}, magnets=_ROUND),
    "closed sphere": _object(
        {"kind": "sphere", "size_mm": [50.0] * 3, "open_faces": []}, magnets=_ROUND
    ),
    "ellipsoid": _object(
        {"kind": "ellipsoid", "size_mm": [62.0, 56.0, 50.0], "bore_mm": 8.0}, magnets=_ROUND
    ),
    "dome": _object({"kind": "dome", "size_mm": [48.0, 48.0, 31.0]}, magnets=_ROUND),
    "dome of silicone": _object(
        {"kind": "dome", "size_mm": [40.0, 40.0, 27.0], "inside": "silicone"}, magnets=_ROUND
    ),
    "hollow dome": _object(
        {"kind": "dome", "size_mm": [44.0, 44.0, 29.0], "inside": "air"}, magnets=_ROUND
    ),
}
OBJECTS["reverse box"]["arrangement"] = "sensors-in-shell"


@cache
def worked(name: str) -> ObjectSpec:
    """The object of that name, which fits."""
    return ObjectSpec.model_validate(OBJECTS[name])


WORKED_TIPS = {
    "flat": {"kind": "flat", "radius_mm": 3.0, "fillet_mm": 0.8, "turn_deg": (0.0, 4.0, -6.0)},
    "cuboid": {
        "kind": "cuboid",
        "size_mm": [6.0, 4.0],
        "turn_deg": (25.0, 0.0, 0.0),
        "tip_count": 3,
    },
    "cylinder": {
        "kind": "cylinder",
        "radius_mm": 2.0,
        "size_mm": (7.0, 9.0),
        "turn_deg": (0.0, 0.0, 5.0),
    },
    "stl": {"kind": "stl", "vertices_mm": [[0, 0, 0], [6, 0, 8], [-6, 5, 8], [-6, -5, 8]]},
}
"""Indenters of the pages of physics."""
