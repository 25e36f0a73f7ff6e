"""A template that hugs a curved face, to set its magnets, with the polarity of each engraved.

A sheet of even thickness over the pockets, with a hole along the axis of every one; it is turned until
every hole lies over its pocket. Beside each hole stands + where the magnet's north pole points outward,
− where it points inward; a notch in the rim is at the face's +x, +y. It is made of triangles, from the
face's own surface, whatever the kind of body.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Int

from design.body.meshes import one_closed_surface
from design.body.sampled import measured_distance_mm
from design.body.surface_chart import FaceFrame
from design.body.triangles import Block, block_surface
from design.layout.body import body_of
from design.layout.pockets import Pocket
from design.layout.template_marks import bars, mark_places, pockets_by_face
from design.solids.magnet_template import MARK_DEPTH_MM, PLATE_MM
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

    from design.body.kinds.base import BodyKind

RIM_MM = 6.0
"""Width of the sheet beyond the pockets, where the face is as large."""
NOTCH_MM = 2.0
_WITHIN = 1 - 1e-9
"""Used share of a face: rounding puts some of its rim beyond it, where the surface is not known."""
_SMALLER, _INNER, _EDGE_DEG = (1.0, 0.95, 0.9, 0.85), 0.75, 25.0
"""Shares of the sheet that are tried where its rim leans that much more than the surface farther inside, on a
body's rounded edge, where a sheet grows thinner."""
_LINES, _FEW, _SECTIONS, _OVER_MM, _ALIKE_MM = 49, 9, 48, 1.0, 0.05


def curved_template_faces(spec: ObjectSpec) -> dict[int, tuple[int, ...]]:
    """First face → the faces of its surface and pockets, which one template serves."""
    groups: list[tuple[np.ndarray, list[int]]] = []
    for frame, pockets in pockets_by_face(spec):
        sheet = _lattice(frame, _FEW).share * sheet_half_mm(frame, pockets)
        shape = np.concatenate([sheet, _centres(pockets)])
        alike = np.column_stack([shape, frame.relief.evaluate(shape)[0]])
        for group_shape, numbers in groups:
            if group_shape.shape == alike.shape and np.abs(group_shape - alike).max() < _ALIKE_MM:
                numbers.append(frame.number)
                break
        else:
            groups.append((alike, [frame.number]))
    return {numbers[0]: tuple(numbers) for _, numbers in groups}


def make_curved_template(spec: ObjectSpec, face: int) -> trimesh.Trimesh:
    """Template of one face in that face's frame (mm), origin at the middle of the face's surface.

    Raises
    ------
    InputError
        The holes cut the sheet into pieces.
    """
    import trimesh

    frame, pockets = next(pair for pair in pockets_by_face(spec) if pair[0].number == face)
    play, half = spec.printer.clearance_mm, sheet_half_mm(frame, pockets)
    sheet = _sheet(body_of(spec), frame, half, play)
    tools = [_hole(frame, pocket, play) for pocket in pockets]
    corner = np.asarray(half) * (0.5**0.5 if frame.round else 1.0)
    # marks keep to the rectangle within a round rim, or next to it
    places = mark_places(spec, pockets, (float(corner[0]), float(corner[1])))
    for place, polarity in zip(places, spec.magnets.polarities, strict=True):
        tools += _mark(frame, place, polarity, play + PLATE_MM)
    tools.append(_rod(frame, corner, NOTCH_MM))
    part = trimesh.boolean.difference([sheet, *tools], engine="manifold")
    turned = np.eye(4)
    turned[:3, :3], turned[:3, 3] = frame.axes.T, -frame.axes.T @ frame.centre_mm
    return one_closed_surface(part.apply_transform(turned), "magnet_template")


def sheet_half_mm(frame: FaceFrame, pockets: tuple[Pocket, ...]) -> tuple[float, float]:
    """Half extents of the sheet: the pockets and a rim, within the face, and off its rounded edge where the
    pockets leave room for that."""
    far = np.max([pocket.reach_mm for pocket in pockets], axis=0)
    most = _WITHIN * np.asarray(frame.half_extents_mm)
    half = np.minimum((2**0.5 if frame.round else 1.0) * far + RIM_MM, most)
    norm = 2 if frame.round else np.inf
    reach = max(np.linalg.norm(p.reach_mm / half, norm) for p in pockets)
    for smaller in (share * half for share in _SMALLER if share > reach):
        if not _rim_leans(frame, smaller):
            half = smaller
            break
    return float(half[0]), float(half[1])


def _rim_leans(frame: FaceFrame, half_mm: Float[np.ndarray, "2"]) -> bool:
    """Return whether a sheet's rim lies on a rounded edge."""
    ring = _lattice(frame, _FEW)
    rim = ring.share[ring.rim] * half_mm
    return bool(np.max(_lean_deg(frame, rim) - _lean_deg(frame, _INNER * rim)) >= _EDGE_DEG)


def _lean_deg(frame: FaceFrame, places_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
    slopes = frame.relief.evaluate(places_mm)[1]
    return np.rad2deg(np.arctan(np.linalg.norm(slopes, axis=1)))


@dataclass(frozen=True)
class _Lattice:
    """Places as shares of the sheet's half extents, triangles between them, and the outermost in order."""

    share: Float[np.ndarray, "n 2"]
    triangles: Int[np.ndarray, "triangle 3"]
    rim: Int[np.ndarray, "m"]


def _lattice(frame: FaceFrame, lines: int) -> _Lattice:
    return ring_lattice(lines) if frame.round else row_lattice(lines)


def row_lattice(lines: int) -> _Lattice:
    """A square lattice of an odd number of lines."""
    across, side = np.linspace(-1, 1, lines), np.arange(lines - 1)
    share = np.column_stack([part.ravel() for part in np.meshgrid(across, across)])
    corner = (side[:, None] * lines + side).ravel()
    first = np.column_stack([corner, corner + 1, corner + lines + 1])
    second = np.column_stack([corner, corner + lines + 1, corner + lines])
    last = lines * (lines - 1)
    ends = [side, lines - 1 + lines * side, lines * lines - 1 - side, last - lines * side]
    return _Lattice(share, np.vstack([first, second]), np.concatenate(ends))


def ring_lattice(lines: int) -> _Lattice:
    """A place in the middle and rings about it."""
    rings, spokes = lines // 2, 2 * lines
    radius, angle = np.arange(1, rings + 1) / rings, 2 * np.pi * np.arange(spokes) / spokes
    way = np.column_stack([np.cos(angle), np.sin(angle)])
    share = np.vstack([np.zeros((1, 2)), (radius[:, None, None] * way).reshape(-1, 2)])
    here = 1 + np.arange(spokes)
    after = np.roll(here, -1)
    triangles = [np.column_stack([0 * here, here, after])]
    for ring in range(rings - 1):
        a, b = here + spokes * ring, after + spokes * ring
        triangles += [
            np.column_stack([a, a + spokes, b + spokes]),
            np.column_stack([a, b + spokes, b]),
        ]
    return _Lattice(share, np.vstack(triangles), here + spokes * (rings - 1))


def _centres(pockets: tuple[Pocket, ...]) -> Float[np.ndarray, "n 2"]:
    return np.stack([pocket.body.centre_mm[:2] for pocket in pockets])


def _sheet(
    body: BodyKind, frame: FaceFrame, half_mm: tuple[float, float], play_mm: float
) -> trimesh.Trimesh:
    """Closed sheet of even thickness, its lower side that play above the body, in the object's frame.

    On a rounded edge it goes on in the direction of the normals farther inside: its own cross each other.
    """
    import trimesh

    lattice = _lattice(frame, _LINES)
    count, rim, after = len(lattice.share), lattice.rim, np.roll(lattice.rim, -1)
    places = lattice.share * half_mm
    far = np.linalg.norm(lattice.share, 2 if frame.round else np.inf, axis=1)
    inner = _INNER if _rim_leans(frame, np.asarray(half_mm)) else 1.0
    up = frame.axes_at(places * np.minimum(1.0, inner / np.maximum(far, inner))[:, None])[..., 2]
    foot = frame.to_object(np.column_stack([places, np.zeros(count)]))
    low = foot + play_mm * up
    if body.sampled:
        # what a slanting way and a rounded relief leave too little, by the cosine between both normals
        near = play_mm - measured_distance_mm(body.outer_surface(), low)
        cosine = np.sum(up * frame.axes_at(places)[..., 2], axis=1)
        low += (near.clip(min=0) / cosine)[:, None] * up
    high = low + PLATE_MM * up
    walls = [
        np.column_stack([rim, after, after + count]),
        np.column_stack([rim, after + count, rim + count]),
    ]
    faces = np.vstack([lattice.triangles + count, lattice.triangles[:, ::-1], *walls])
    return trimesh.Trimesh(np.vstack([low, high]), faces)


def _rod(frame: FaceFrame, xy_mm: np.ndarray, radius_mm: float) -> trimesh.Trimesh:
    """A round hole along the surface's normal, through all that lies on it."""
    import trimesh

    ends = np.array([[*xy_mm, -_OVER_MM], [*xy_mm, 2 * PLATE_MM + _OVER_MM]])
    return trimesh.creation.cylinder(radius_mm, segment=frame.to_object(ends), sections=_SECTIONS)


def _hole(frame: FaceFrame, pocket: Pocket, play: float) -> trimesh.Trimesh:
    xy = pocket.body.centre_mm[:2]
    if pocket.outline.round:
        return _rod(frame, xy, pocket.outline.half_mm[0] + play)
    half = np.append(np.asarray(pocket.outline.half_mm) + play, PLATE_MM + _OVER_MM)
    axes = frame.axes_at(xy) @ pocket.body.frame
    return block_surface(Block(frame.to_object(np.append(xy, PLATE_MM)), axes, half))


def _mark(
    frame: FaceFrame, place_mm: np.ndarray, polarity: int, top_mm: float
) -> list[trimesh.Trimesh]:
    """Bars of + or −, cut into the outside of the sheet."""
    half = (MARK_DEPTH_MM + _OVER_MM) / 2
    centre = frame.to_object(np.append(place_mm, top_mm - MARK_DEPTH_MM + half))
    axes = frame.axes_at(place_mm)
    return [block_surface(Block(centre, axes, np.array([*bar, half]))) for bar in bars(polarity)]
