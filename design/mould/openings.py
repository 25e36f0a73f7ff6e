"""Holes through a mould: for pouring where no side is open, and vents where air would be caught.

Air rises along the silicone's surface and stays at local high points. They are found on its
triangles, with the pouring holes joined to them, and each gets a straight vent: upwards if nothing
but mould lies above it, else out along the surface's normal, or between the two.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.meshes import Trap, boolean_of, high_points, manifold_of
from design.body.triangles import cylinder_between
from design.layout.body import body_of
from design.layout.mould.closure import flange_span_mm
from design.layout.mould.frame import Parting, mould_frame, thin_beside, up
from design.layout.mould.pins import Pin
from design.layout.mould.pouring import (
    Hole,
    far_mm,
    hole_from,
    hole_thins_the_seam,
    hole_within_mould,
    is_clear,
    pins_of,
    pour_holes,
    thin_beside_others,
)
from design.layout.surface import finished_surface
from design.solids.kernel import cq
from design.solids.sampled import sampled_shell
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh
    from manifold3d import Manifold

_SKIN_MM = 0.05
_LEAST_TRAP_MM = 0.1
"""Bubbles less high than this are left: triangles of curved surfaces make dents of a third of it."""
_SHIFTS_MM, _WAYS = (0.5, 1.0, 1.5, 2.0), 12
"""From a high point to where a vent stands as well, and directions of these."""
_LEANS = (0.5, 1.0)
"""Steps aside for one upwards, of vents that lean."""
_ROUND = 24
"""Number of places along the rim of a bore."""
_LOWER_MM = 0.5 * _LEAST_TRAP_MM
"""Depth by which a vent that is shifted may begin below its high point."""


def hole_solid(hole: Hole) -> cq.Solid:
    """CadQuery solid of a hole."""
    way = hole.end_mm - hole.start_mm
    length = float(np.linalg.norm(way))
    start = cq.Vector(*hole.start_mm)
    return cq.Solid.makeCylinder(hole.diameter_mm / 2, length, start, cq.Vector(*way))


@cached_geometry
def mould_holes(spec: ObjectSpec) -> tuple[Hole, ...]:
    """Pouring holes, then vents."""
    pour = pour_holes(spec)
    return (*pour, *_vents(spec, pour))


@cached_geometry
def seal_holes(spec: ObjectSpec) -> tuple[Hole, ...]:
    """The same of the mould for the seal layer, where that is in halves."""
    if not spec.shell.seal_layer_mm or mould_frame(spec).opening == "open":
        return ()
    pour, shell = pour_holes(spec, first=False), sealed_round(spec)
    pins = pins_of(spec, first=False)
    return (*pour, *_vents_of(spec, shell, pins, pour))


def sealed_round(spec: ObjectSpec) -> trimesh.Trimesh:
    """Return what is within the finished silicone but for a bore and pins: air meets the outside alone."""
    surface, body = finished_surface(spec), body_of(spec)
    if body.opening == "bore":
        return surface.difference(_bore(spec))
    return surface


def _bore(spec: ObjectSpec) -> trimesh.Trimesh:
    body = body_of(spec)
    low = -body.size_mm[2] / 2 - 1.0
    return cylinder_between(body.bore_mm / 2, low, 0.5 * body.core_floor_mm, body.envelope_mm)


def air_traps(spec: ObjectSpec, shell: trimesh.Trimesh, holes: tuple[Hole, ...]) -> list[Trap]:
    """High points of the silicone that neither the open side nor a hole drains."""
    frame, way = mould_frame(spec), up(spec)
    whole = shell
    if holes:
        whole = boolean_of("union", [shell, *(hole.surface() for hole in holes)])
    rim = frame.rim_mm if frame.opening != "closed" else float(far_mm(spec)) / 2
    return high_points(whole, way, rim, max(_LEAST_TRAP_MM, 1.5 * spec.mesh.envelope_mm))


def _vents(spec: ObjectSpec, pour: tuple[Hole, ...]) -> list[Hole]:
    return _vents_of(spec, sampled_shell(spec), pins_of(spec, first=True), pour)


def _vents_of(
    spec: ObjectSpec, silicone: trimesh.Trimesh, pins: tuple[Pin, ...], pour: tuple[Hole, ...]
) -> list[Hole]:
    """One for every high point, each next to pouring holes and the vents before it."""
    vents = list[Hole]()
    for trap in air_traps(spec, silicone, pour):
        vent = vent_for(spec, silicone, pins, trap, [*pour, *vents])
        vents += [] if vent is None else [vent]
    return vents


def vent_for(
    spec: ObjectSpec,
    shell: trimesh.Trimesh,
    pins: tuple[Pin, ...],
    trap: Trap,
    holes: Sequence[Hole] = (),
) -> Hole | None:
    """The first of some ways on which neither silicone nor a pin is, and which leaves no thin wall to the
    seam, to a side of the flange or to another hole, if there is one; or None."""
    solid, fallback = manifold_of(shell), None
    for top, way in _ways_out(spec, solid, trap):
        hole = hole_from(spec, "vent", top, way / np.linalg.norm(way), spec.printer.hole_mm)
        way = (hole.end_mm - hole.start_mm) / np.linalg.norm(hole.end_mm - hole.start_mm)
        start = top + _SKIN_MM * (way + trap.normal)
        if solid.ray_cast(tuple(start), tuple(hole.end_mm)) or not is_clear(hole, pins):
            continue
        if not (
            hole_thins_the_seam(spec, hole)
            or _thin_at_flange(spec, hole)
            or thin_beside_others(spec, hole, pins, holes)
        ):
            return hole
        fallback = fallback or hole
    return fallback


def _ways_out(
    spec: ObjectSpec, solid: Manifold, trap: Trap
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield where a vent may begin, and in which direction: from the high point, then next to it straight
    up, or elsewhere on the level rim round a bore; at last from the high point, leaning any way."""
    above = up(spec)
    yield from ((trap.place_mm, above + outward * trap.normal) for outward in (0.0, 0.5, 1.0, 2.0))
    side = np.cross(above, np.eye(3)[int(abs(above).argmin())])
    side /= np.linalg.norm(side)
    turns = 2 * np.pi * np.arange(_WAYS)[:, None] / _WAYS
    round_about = np.cos(turns) * side + np.sin(turns) * np.cross(above, side)
    for shift in _SHIFTS_MM:
        for aside in round_about:
            place = trap.place_mm + shift * aside
            ends = tuple(place + above), tuple(place - _LOWER_MM * above)
            hits = solid.ray_cast(*ends)
            if hits:
                yield np.asarray(hits[0].position), above
    if mould_frame(spec).opening == "bore":
        yield from ((place, above) for place in _round_the_rod(solid, trap.place_mm, above))
    yield from ((trap.place_mm, above + lean * aside) for lean in _LEANS for aside in round_about)


def _round_the_rod(
    solid: Manifold, place_mm: Float[np.ndarray, "3"], above: Float[np.ndarray, "3"]
) -> Iterator[Float[np.ndarray, "3"]]:
    """Places of the silicone as high as one of its points, turned from there about the axis; the nearest
    first."""
    for step in range(1, _ROUND // 2 + 1):
        for turn in 2 * np.pi / _ROUND * np.array([step, -step]):
            cosine, sine = np.cos(turn), np.sin(turn)
            x, y, z = place_mm
            turned = np.array([cosine * x - sine * y, sine * x + cosine * y, z])
            turned[:2] *= 1 + _SKIN_MM / max(float(np.hypot(x, y)), _SKIN_MM)
            hits = solid.ray_cast(tuple(turned + above), tuple(turned - _LOWER_MM * above))
            if hits:
                yield np.asarray(hits[0].position)


def holes_thin_walls(spec: ObjectSpec) -> bool:
    """Return whether holes for pouring or for air leave walls to the parting plane, to holes of pins or a
    rod, or to each other, that are too thin."""
    pins, holes = pins_of(spec, first=True), mould_holes(spec)
    return any(
        hole_thins_the_seam(spec, hole) or thin_beside_others(spec, hole, pins, holes[:index])
        for index, hole in enumerate(holes)
    )


def _thin_at_flange(spec: ObjectSpec, hole: Hole) -> bool:
    """A side of the flange by which a plug or a rod hangs, through which vents go."""
    frame = mould_frame(spec)
    ends, radius = hole_within_mould(spec, hole), hole.diameter_mm / 2
    sides = [Parting(frame.across, side) for side in flange_span_mm(spec)]
    return frame.plugged and any(thin_beside(spec, ends, side, radius) for side in sides)
