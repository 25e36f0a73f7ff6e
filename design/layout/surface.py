"""Closed triangle surfaces of the silicone, and of the rings where its support ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

from design.body.triangles import block_surface
from design.layout.blocks import core_keys, relief_slits
from design.layout.body import body_of

if TYPE_CHECKING:
    import trimesh

    from design.spec.object import ObjectSpec

_SUPPORT_RING_MM = 2.0


def finished_surface(spec: ObjectSpec) -> trimesh.Trimesh:
    """The outside of the finished silicone."""
    return body_of(spec).outer_surface()


def cast_surface(spec: ObjectSpec) -> trimesh.Trimesh:
    """The outside of what the first pour casts."""
    if not spec.shell.seal_layer_mm:
        return finished_surface(spec)
    return body_of(spec).cast_surface(spec.shell.seal_layer_mm, spec.body.sensed)


def sealed_body_surface(spec: ObjectSpec) -> trimesh.Trimesh:
    """The silicone with its pockets filled; keys of the core and relief slits are left out."""
    import trimesh

    body = body_of(spec)
    outer, cavity = body.outer_surface(), body.cavity_surface()
    left_out = [block_surface(block) for block in (*core_keys(spec), *relief_slits(spec))]
    if cavity is not None:
        left_out.insert(0, cavity)
    return trimesh.boolean.difference([outer, *left_out]) if left_out else outer


def support_rings(spec: ObjectSpec) -> list[trimesh.Trimesh]:
    """Closed rings in the cavity's walls, from the end of the core a little towards an open face."""
    body = body_of(spec)
    slabs = body.end_slabs(min(_SUPPORT_RING_MM, body.thickness_mm / 3))
    cavity = body.cavity_surface() if slabs else None
    return slabs if cavity is None else [slab.difference(cavity) for slab in slabs]
