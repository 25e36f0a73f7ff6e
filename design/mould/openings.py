"""Holes through a mould: for pouring where no side is open, and vents where air would be caught.

Air rises along the silicone's surface and stays at local high points. They are found on its
triangles, with the pouring holes joined to them, and each gets a straight vent: upwards if nothing
but mould lies above it, else out along the surface's normal, or between the two.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

import cadquery as cq
import numpy as np
from jaxtyping import Float

from design.body.meshes import Trap, high_points, manifold_of
from design.body.triangles import cylinder_between
from design.errors import InputError
from design.layout.body import body_of
from design.layout.mould_closure import flange_span_mm
from design.layout.mould_frame import (
    MouldFrame,
    mould_frame,
    mould_style,
    thin_at_seam,
    thin_beside,
    up,
)
from design.layout.mould_pins import Pin, exit_mm, loose_pins
from design.layout.pockets import distance_of_segments_mm
from design.solids.sampled import cast_surface, sampled_shell
from design.spec.object import ObjectSpec
from design.spec.worked_out import once

if TYPE_CHECKING:
    import trimesh
    from manifold3d import Manifold

_SECTIONS = 48
_SKIN_MM = 0.05
_POUR_SHIFTS = (0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0, 1.25, -1.25, 1.5, -1.5)
"""Along the flange, over the distance from the rod's axis across it."""
_MOST_CORNERS = 200
_LEAST_TRAP_MM = 0.1
"""Bubbles less high than this are left: triangles of curved surfaces make dents of a third of it."""
_SHIFTS_MM, _WAYS = (0.5, 1.0, 1.5, 2.0), 12
"""From a high point to where a vent stands as well, and directions of these."""
_LOWER_MM = 0.5 * _LEAST_TRAP_MM
"""By which a vent that is shifted may begin below its high point."""


@dataclass(frozen=True)
class Hole:
    """A straight round hole from within the silicone, where `top_mm` is on its surface, to outside the
    mould."""

    use: Literal["pour", "vent"]
    start_mm: Float[np.ndarray, "3"]
    top_mm: Float[np.ndarray, "3"]
    end_mm: Float[np.ndarray, "3"]
    diameter_mm: float

    @property
    def outside(self) -> Hole:
        """The part of it that begins at the silicone's surface."""
        return replace(self, start_mm=self.top_mm)

    def solid(self) -> cq.Solid:
        way = self.end_mm - self.start_mm
        length = float(np.linalg.norm(way))
        start = cq.Vector(*self.start_mm)
        return cq.Solid.makeCylinder(self.diameter_mm / 2, length, start, cq.Vector(*way))

    def surface(self) -> trimesh.Trimesh:
        import trimesh

        ends = [self.start_mm, self.end_mm]
        return trimesh.creation.cylinder(self.diameter_mm / 2, segment=ends, sections=_SECTIONS)


def vent_diameter_mm(spec: ObjectSpec) -> float:
    """`mould.vent_mm`, else the narrowest hole that the printer keeps open."""
    given = spec.mould.vent_mm
    return spec.printer.hole_mm if given is None else given


@once
def mould_holes(spec: ObjectSpec) -> tuple[Hole, ...]:
    """Pouring holes, then vents."""
    pour = pour_holes(spec)
    return (*pour, *_vents(spec, pour))


@once
def seal_holes(spec: ObjectSpec) -> tuple[Hole, ...]:
    """The same of the mould for the seal layer, where that is in halves."""
    if not spec.shell.seal_layer_mm or mould_frame(spec).opening == "open":
        return ()
    pour, shell = pour_holes(spec, finished_surface(spec)), sealed_round(spec)
    pins = _pins_of(spec, first=False)
    vents = [_vent(spec, shell, pins, trap) for trap in air_traps(spec, shell, pour)]
    return (*pour, *(vent for vent in vents if vent is not None))


def finished_surface(spec: ObjectSpec) -> trimesh.Trimesh:
    """The outside of the finished silicone, as a closed surface."""
    return body_of(spec).outer_surface()


def sealed_round(spec: ObjectSpec) -> trimesh.Trimesh:
    """What is within the finished silicone but for a bore and pins: air meets the outside alone."""
    surface, body = finished_surface(spec), body_of(spec)
    if body.opening == "bore":
        return surface.difference(_bore(spec))
    return surface


def _bore(spec: ObjectSpec) -> trimesh.Trimesh:
    body = body_of(spec)
    low = -body.size_mm[2] / 2 - 1.0
    return cylinder_between(body.bore_mm / 2, low, 0.5 * body.core_floor_mm, body.envelope_mm)


def pour_holes(spec: ObjectSpec, surface: trimesh.Trimesh | None = None) -> tuple[Hole, ...]:
    """Beside the rod through a bore, at both its sides; at the upper corner of a closed mould. They move
    along the flange of the rod, which stays beside them, or go down from that corner, until no pin is
    in their way.

    They begin at a surface, by default that of the first pour.

    Raises
    ------
    InputError
        Wherever they might be, a pin is in the way.
    """
    frame = mould_frame(spec)
    if frame.opening == "open":
        return ()
    pins = _pins_of(spec, first=surface is None)
    surface = cast_surface(spec) if surface is None else surface
    first: tuple[Hole, ...] | None = None
    for tops in _pour_places(spec, surface):
        holes = tuple(_hole(spec, "pour", top, up(spec), spec.mould.pour_mm) for top in tops)
        if all(_clear(hole, pins) for hole in holes):
            if not any(_thin_at_seam(spec, hole) for hole in holes):
                return holes
            first = first or holes
    if first is not None:
        return first
    raise InputError(
        f"wherever the mould's pouring holes (mould.pour_mm = {spec.mould.pour_mm:g}) might be, a pin "
        "of a magnet's pocket is in the way. Make them narrower, or move magnets away from face 6"
    )


def _pour_places(spec: ObjectSpec, surface: trimesh.Trimesh) -> Iterator[list[np.ndarray]]:
    """Tops of the pouring holes on the silicone's surface, the best first."""
    frame, way = mould_frame(spec), up(spec)
    if frame.opening == "closed":
        height = surface.vertices @ way
        for corner in np.argsort(-height, kind="stable")[:_MOST_CORNERS]:
            yield [surface.vertices[corner]]
        return
    aside = float(frame.plug_mm[1, 0]) + spec.mould.pour_mm / 2
    for shift in _POUR_SHIFTS:
        side = aside * (frame.across + shift * frame.along)
        tops = [_below(surface, frame, sign * side) for sign in (-1, 1)]
        yield [top for top in tops if top is not None]


def _pins_of(spec: ObjectSpec, first: bool) -> tuple[Pin, ...]:
    """Pins in the mould of the first pour; the seal layer's has none for pockets."""
    pins = loose_pins(spec) if mould_style(spec) == "split" else ()
    return pins if first else tuple(pin for pin in pins if pin.locator is not None)


def air_traps(spec: ObjectSpec, shell: trimesh.Trimesh, holes: tuple[Hole, ...]) -> list[Trap]:
    """High points of the silicone that neither the open side nor a hole drains."""
    frame, way = mould_frame(spec), up(spec)
    whole = shell
    if holes:
        import trimesh

        surfaces = [shell, *(hole.surface() for hole in holes)]
        whole = trimesh.boolean.union(surfaces, engine="manifold")
    rim = frame.rim_mm if frame.opening != "closed" else float(_far_mm(spec)) / 2
    return high_points(whole, way, rim, max(_LEAST_TRAP_MM, 1.5 * spec.mesh.envelope_mm))


def _vents(spec: ObjectSpec, pour: tuple[Hole, ...]) -> list[Hole]:
    shell = sampled_shell(spec)
    pins = _pins_of(spec, first=True)
    vents = [_vent(spec, shell, pins, trap) for trap in air_traps(spec, shell, pour)]
    return [vent for vent in vents if vent is not None]


def _vent(
    spec: ObjectSpec, shell: trimesh.Trimesh, pins: tuple[Pin, ...], trap: Trap
) -> Hole | None:
    """The first of some ways on which neither silicone nor a pin is, and which leaves no thin wall to the
    seam or to a side of the flange, if there is one; or None."""
    solid, found = manifold_of(shell), None
    for top, way in _ways_out(spec, solid, trap):
        hole = _hole(spec, "vent", top, way / np.linalg.norm(way), vent_diameter_mm(spec))
        way = (hole.end_mm - hole.start_mm) / np.linalg.norm(hole.end_mm - hole.start_mm)
        start = top + _SKIN_MM * (way + trap.normal)
        if solid.ray_cast(tuple(start), tuple(hole.end_mm)) or not _clear(hole, pins):
            continue
        if not (_thin_at_seam(spec, hole) or _thin_at_flange(spec, hole)):
            return hole
        found = found or hole
    return found


def _ways_out(
    spec: ObjectSpec, solid: Manifold, trap: Trap
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Where a vent may begin, and in which direction: from the high point, then beside it straight up."""
    above = up(spec)
    yield from ((trap.place_mm, above + outward * trap.normal) for outward in (0.0, 0.5, 1.0, 2.0))
    side = np.cross(above, np.eye(3)[int(abs(above).argmin())])
    side /= np.linalg.norm(side)
    for shift in _SHIFTS_MM:
        for turn in 2 * np.pi * np.arange(_WAYS) / _WAYS:
            place = trap.place_mm + shift * (
                np.cos(turn) * side + np.sin(turn) * np.cross(above, side)
            )
            ends = tuple(place + above), tuple(place - _LOWER_MM * above)
            hits = solid.ray_cast(*ends)
            if hits:
                yield np.asarray(hits[0].position), above


def holes_thin_the_seam(spec: ObjectSpec) -> bool:
    """Whether holes for pouring or for air leave walls to the parting plane that are too thin."""
    return any(_thin_at_seam(spec, hole) for hole in mould_holes(spec))


def _thin_at_seam(spec: ObjectSpec, hole: Hole) -> bool:
    split = mould_style(spec) == "split"
    return split and thin_at_seam(spec, _within_mould(spec, hole), hole.diameter_mm / 2)


def _thin_at_flange(spec: ObjectSpec, hole: Hole) -> bool:
    """A side of the flange by which a plug or a rod hangs, through which vents go."""
    frame = mould_frame(spec)
    across = _within_mould(spec, hole) @ frame.across
    return frame.plugged and any(
        thin_beside(spec, across - side, hole.diameter_mm / 2) for side in flange_span_mm(spec)
    )


def _within_mould(spec: ObjectSpec, hole: Hole) -> Float[np.ndarray, "2 3"]:
    """Where a hole's axis leaves the silicone, and where the mould's block."""
    way = hole.end_mm - hole.top_mm
    way /= np.linalg.norm(way)
    return np.stack([hole.top_mm, hole.top_mm + exit_mm(spec, hole.top_mm, way) * way])


def _clear(hole: Hole, pins: tuple[Pin, ...]) -> bool:
    axis, half = np.stack([hole.start_mm, hole.end_mm]), hole.diameter_mm / 2
    return all(
        distance_of_segments_mm(axis, pin.axis_mm) > half + pin.radius_mm
        and distance_of_segments_mm(axis, pin.head_axis_mm) > half + pin.radius_mm + pin.rim_mm
        for pin in pins
    )


def _hole(
    spec: ObjectSpec,
    use: Literal["pour", "vent"],
    top_mm: np.ndarray,
    way: np.ndarray,
    diameter: float,
) -> Hole:
    """From below a point of the surface, so that all of its rim is open, to far outside."""
    return Hole(use, top_mm - diameter * way, top_mm, top_mm + _far_mm(spec) * way, diameter)


def _far_mm(spec: ObjectSpec) -> float:
    return 3 * max(spec.body.size_mm) + spec.mould.flange_mm + spec.mould.wall_mm


def _below(surface: trimesh.Trimesh, frame: MouldFrame, beside_mm: np.ndarray) -> np.ndarray | None:
    """The silicone's surface under a place beside the axis `out`; None where there is none."""
    top = beside_mm + (frame.rim_mm + 1.0) * frame.out
    hits = manifold_of(surface).ray_cast(tuple(top), tuple(beside_mm - frame.rim_mm * frame.out))
    return np.asarray(hits[0].position) if hits else None
