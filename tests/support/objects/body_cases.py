"""A specification of every kind of body, small and off its symmetries where that is possible."""

from design.spec.object import ObjectSpec
from design.spec_io import check

ONE = {
    "magnets": {"positions_mm": [[1.0, -2.0]]},
    "sensors": {"positions_mm": [[2.0, 1.0]], "radius_mm": 3.5, "package_mm": [6.6, 3.0, 1.6]},
}
CORE = {"core": {"recess_inner_radius_mm": 2.0, "recess_outer_radius_mm": 5.0}}
GRID = {"contact_grid": {"count": [2, 2], "pitch_mm": 3.0}, "press": {"depths_mm": [0.5, 1.0]}}
BODIES = {
    "pad": {"body": {"kind": "pad", "size_mm": [40, 30, 10]}, "shell": {"thickness_mm": 6}},
    "cylinder": {"body": {"kind": "cylinder", "size_mm": [40, 40, 50]}},
    "sleeve": {"body": {"kind": "cylinder", "size_mm": [40, 40, 50], "open_faces": [1, 6]}},
    "capsule": {"body": {"kind": "capsule", "size_mm": [40, 40, 64], "bore_mm": 8}},
    "sphere": {"body": {"kind": "sphere", "size_mm": [44, 44, 44], "bore_mm": 8}},
    "solid_dome": {"body": {"kind": "dome", "size_mm": [24, 24, 16], "inside": "silicone"}},
    "hollow_dome": {
        "body": {"kind": "dome", "size_mm": [36, 36, 22], "inside": "air"},
        "shell": {"thickness_mm": 5},
    },
    "dome_on_core": {"body": {"kind": "dome", "size_mm": [40, 40, 24]}},
    "ellipsoid": {"body": {"kind": "ellipsoid", "size_mm": [60, 50, 44], "open_faces": []}},
    "two_open": {"body": {"size_mm": [42, 44, 46], "open_faces": [5, 6]}},
    "closed_box": {"body": {"size_mm": [42, 44, 46], "open_faces": []}},
}


def body_spec(name: str, **changes: dict) -> ObjectSpec:
    """The case of that name; `changes` are merged into its tables."""
    content = {"name": name} | GRID | ONE | CORE | BODIES[name]
    for table, values in changes.items():
        content[table] = content.get(table, {}) | values
    return check(ObjectSpec.model_validate(content))


BESIDE_AN_EDGE = {
    "name": "box",
    "body": {"kind": "box", "size_mm": [38.35, 44.7, 39.5], "open_faces": []},
    "shell": {
        "thickness_mm": 5.83,
        "pocket_diameter_mm": 4.26,
        "pocket_depth_mm": 2.67,
        "seal_layer_mm": 0.53,
    },
    "magnets": {
        "diameter_mm": 4.26,
        "height_mm": 0.8,
        "positions_mm": [[2.247, 0.386], [-2.247, -0.386]],
    },
    "core": {
        "wall_mm": 3.92,
        "recess_depth_mm": 3.42,
        "recess_width_mm": 3.9,
        "recess_inner_radius_mm": 7.2,
        "recess_outer_radius_mm": 10.01,
    },
    "sensors": {
        "count_per_face": 4,
        "radius_mm": 8.61,
        "depth_below_core_face_mm": 1.0,
        "package_mm": [3.9, 2.81, 1.7],
        "chip_mm": [1.95, 1.405, 1.7],
        "first_azimuth_deg": [0.0, 1.0, 0.0, 164.75, 145.37],
    },
    "contact_grid": {"count": [2, 2], "pitch_mm": 2.0},
    "press": {"depths_mm": [0.5, 1.0]},
    "indenter": {"radius_mm": 4.24},
}
"""The place with most room for a pin is where its foot would meet an edge of the core."""
