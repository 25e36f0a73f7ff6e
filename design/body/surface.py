"""Closed triangle surfaces of the body's outside and of the core's cavity, for the mesh.

Curved surfaces are triangulated so finely that edges leave them by about half of the mesh's envelope,
and enclose the same volume.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from design.body.blocks import Block, core_keys, relief_slits
from design.body.kinds import base_top_mm, core_half_mm, sphere_centre_mm
from design.body.surface_chart import FACE_AXES

if TYPE_CHECKING:
    import trimesh

    from design.spec.object import ObjectSpec

_OVERSHOOT_MM = 1.0
_SUPPORT_RING_MM = 2.0
_ICOSAHEDRON_EDGE = 1.05


def outer_surface(spec: ObjectSpec) -> trimesh.Trimesh:
    """The silicone's outside as if it were solid, mm."""
    return _OUTER[spec.body.kind](spec)


def cavity_surface(spec: ObjectSpec) -> trimesh.Trimesh | None:
    """What the core and its passage out of the open faces keep free, 1 mm beyond them; or None."""
    return _CAVITIES[spec.body.kind](spec)


def sealed_body_surface(spec: ObjectSpec) -> trimesh.Trimesh:
    """The silicone with its pockets filled; keys of the core and relief slits are left out."""
    import trimesh

    outer, cavity = outer_surface(spec), cavity_surface(spec)
    left_out = [block_surface(block) for block in (*core_keys(spec), *relief_slits(spec))]
    if cavity is not None:
        left_out.insert(0, cavity)
    return trimesh.boolean.difference([outer, *left_out]) if left_out else outer


def block_surface(block: Block) -> trimesh.Trimesh:
    """A block as a closed surface in the object's frame."""
    import trimesh

    placed = np.eye(4)
    placed[:3, :3], placed[:3, 3] = block.axes, block.centre_mm
    return trimesh.creation.box(2 * block.half_mm, placed)


def support_rings(spec: ObjectSpec) -> list[trimesh.Trimesh]:
    """Closed rings in the cavity's walls, from the end of the core a little towards an open face."""
    width = min(_SUPPORT_RING_MM, spec.shell.thickness_mm / 3)
    return [_support_ring(spec, normal, width) for normal, _ in support_ends(spec)]


def support_ends(spec: ObjectSpec) -> list[tuple[np.ndarray, float]]:
    """Planes in which a core with straight walls ends: normal towards the open face, level in mm."""
    if spec.body.kind not in ("box", "cylinder"):
        return []
    normals = [np.asarray(FACE_AXES[face][0], float) for face in spec.body.opened]
    return [(normal, float(abs(normal) @ core_half_mm(spec))) for normal in normals]


def largest_edge_mm(spec: ObjectSpec, radius_mm: float) -> float:
    """Edge whose chord leaves a circle of that radius by half of the mesh's envelope."""
    return float(np.sqrt(4 * radius_mm * spec.mesh.envelope_mm))


def _box_between(low_mm: np.ndarray, high_mm: np.ndarray) -> trimesh.Trimesh:
    import trimesh

    box = trimesh.creation.box(np.asarray(high_mm) - low_mm)
    box.apply_translation((np.asarray(low_mm) + high_mm) / 2)
    return box


def _cylinder_between(
    spec: ObjectSpec, radius_mm: float, low_mm: float, high_mm: float
) -> trimesh.Trimesh:
    """About z; its triangles are as wide as they may be."""
    import trimesh

    sections = max(24, int(np.ceil(2 * np.pi * radius_mm / largest_edge_mm(spec, radius_mm))))
    angle = 2 * np.pi / sections
    radius = radius_mm * float(np.sqrt(angle / np.sin(angle)))
    solid = trimesh.creation.cylinder(radius, high_mm - low_mm, sections=sections)
    solid.apply_translation((0, 0, (low_mm + high_mm) / 2))
    return solid


def ball(spec: ObjectSpec, radius_mm: float, centre_mm: np.ndarray) -> trimesh.Trimesh:
    """A sphere."""
    import trimesh

    finest = _ICOSAHEDRON_EDGE * radius_mm / largest_edge_mm(spec, radius_mm)
    sphere = trimesh.creation.icosphere(max(2, round(float(np.log2(finest)))), radius_mm)
    sphere.apply_scale((4 / 3 * np.pi * radius_mm**3 / sphere.volume) ** (1 / 3))
    sphere.apply_translation(centre_mm)
    return sphere


def open_span_mm(spec: ObjectSpec, overshoot_mm: float) -> tuple[np.ndarray, np.ndarray]:
    """Corners of the core's box, drawn out through the open faces."""
    half = np.asarray(spec.body.size_mm) / 2 + overshoot_mm
    low, high = -core_half_mm(spec), core_half_mm(spec)
    for face in spec.body.opened:
        normal = np.asarray(FACE_AXES[face][0], float)
        high = np.where(normal > 0, half, high)
        low = np.where(normal < 0, -half, low)
    return low, high


def _box(spec: ObjectSpec) -> trimesh.Trimesh:
    import trimesh

    return trimesh.creation.box(spec.body.size_mm)


def _box_cavity(spec: ObjectSpec) -> trimesh.Trimesh:
    return _box_between(*open_span_mm(spec, _OVERSHOOT_MM))


def _pad(spec: ObjectSpec) -> trimesh.Trimesh:
    half = np.asarray(spec.body.size_mm) / 2
    return _box_between(np.array([-half[0], -half[1], base_top_mm(spec)]), half)


def _cylinder(spec: ObjectSpec) -> trimesh.Trimesh:
    radius, _, half = np.asarray(spec.body.size_mm) / 2
    return _cylinder_between(spec, float(radius), float(-half), float(half))


def _cylinder_cavity(spec: ObjectSpec) -> trimesh.Trimesh:
    low, high = open_span_mm(spec, _OVERSHOOT_MM)
    return _cylinder_between(spec, float(core_half_mm(spec)[0]), float(low[2]), float(high[2]))


def _sphere(spec: ObjectSpec) -> trimesh.Trimesh:
    return ball(spec, spec.body.size_mm[0] / 2, np.zeros(3))


def _sphere_cavity(spec: ObjectSpec) -> trimesh.Trimesh:
    return with_bore(spec, ball(spec, float(core_half_mm(spec)[0]), np.zeros(3)))


def with_bore(spec: ObjectSpec, core: trimesh.Trimesh) -> trimesh.Trimesh:
    """The core's surface with its bore out of face 6, where that is open."""
    if 6 not in spec.body.opened:
        return core
    bottom = -spec.body.size_mm[2] / 2 - _OVERSHOOT_MM
    inside = float(core.bounds[0, 2]) / 2
    return core.union(_cylinder_between(spec, spec.body.bore_mm / 2, bottom, inside))


def _dome(spec: ObjectSpec) -> trimesh.Trimesh:
    """A hemisphere on the base's plane."""
    return _upper_half(spec, spec.body.size_mm[0] / 2)


def _dome_cavity(spec: ObjectSpec) -> trimesh.Trimesh | None:
    if spec.body.inside == "silicone":
        return None
    return ball(spec, spec.body.size_mm[0] / 2 - spec.shell.thickness_mm, sphere_centre_mm(spec))


def _upper_half(spec: ObjectSpec, radius_mm: float) -> trimesh.Trimesh:
    centre = sphere_centre_mm(spec)
    reach = 2 * radius_mm
    above = _box_between(centre - [reach, reach, 0], centre + reach)
    return ball(spec, radius_mm, centre).intersection(above)


def _sampled(spec: ObjectSpec) -> trimesh.Trimesh:
    from design.body.sampled import sampled_outer

    return sampled_outer(spec)


def _sampled_cavity(spec: ObjectSpec) -> trimesh.Trimesh:
    from design.body.sampled import sampled_core

    return with_bore(spec, sampled_core(spec))


def _support_ring(spec: ObjectSpec, normal: np.ndarray, width_mm: float) -> trimesh.Trimesh:
    """The slab below the end of the core, as wide as the core and `width_mm`, less the cavity."""
    half = core_half_mm(spec)
    end, grown = normal * half, half + width_mm
    across = np.where(normal == 0, grown, 0)
    corners = np.stack([end - across, end + across + width_mm * normal])
    if spec.body.kind == "box":
        slab = _box_between(corners.min(axis=0), corners.max(axis=0))
    else:
        low, high = np.sort(corners[:, 2])
        slab = _cylinder_between(spec, float(grown[0]), float(low), float(high))
    cavity = cavity_surface(spec)
    return slab if cavity is None else slab.difference(cavity)


_OUTER: dict[str, Callable[[ObjectSpec], trimesh.Trimesh]] = {
    "box": _box,
    "pad": _pad,
    "cylinder": _cylinder,
    "sphere": _sphere,
    "ellipsoid": _sampled,
    "dome": _dome,
    "imported": _sampled,
}
_CAVITIES: dict[str, Callable[[ObjectSpec], trimesh.Trimesh | None]] = {
    "box": _box_cavity,
    "pad": lambda spec: None,
    "cylinder": _cylinder_cavity,
    "sphere": _sphere_cavity,
    "ellipsoid": _sampled_cavity,
    "dome": _dome_cavity,
    "imported": _sampled_cavity,
}
