"""Contact locations that each sensed face has, out of one lattice that all of them share.

Faces differ in size and shape; tables of presses do not. So all faces take their locations from one
centred lattice, as large as the largest face needs, and each has a mask of the locations that lie on it. Its
steps are lengths along the surface (`design.body.section_lengths`), so that locations lie evenly on
curved faces too.
With `contact_grid.count = "fill"` these are all at which the tip lands on the face, anywhere within
half a pitch, with a pair of counts all of the lattice on every face. Over the border of a flat face
the tip may hang; beyond that of a curved patch it may touch.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from math import ceil
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import SpecError
from design.layout.body import face_frames
from design.layout.tips import footprint_mm, path_mm, tip_heights_mm, tip_places_mm, tip_shape
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec

LEAST_COUNT, MOST_COUNT = 2, 100
"""Contact locations along an axis of a face."""
_ROUND_MARGIN_MM = 0.1
"""Length by which a flat round face's mesh, of straight edges, may fall short of its circle."""
_RING_POINTS = 24
_ONE_TIP_MM = np.zeros((1, 2))
_FINER, _FINER_STEPS = 0.8, 16
"""Pitches that are tried where too few locations find room, each so much of the last."""


@dataclass(frozen=True)
class _Lattice:
    """Locations along x and y of the lattice, and which of them each sensed face has."""

    count: tuple[int, int]
    places: Bool[np.ndarray, "face nx ny"]


def grid_count(spec: ObjectSpec) -> tuple[int, int]:
    """Locations along x and y of the lattice that all faces share."""
    return _lattice(spec).count


@cached_geometry
def contact_places(spec: ObjectSpec) -> Bool[np.ndarray, "face place"]:
    """Return which places of the contact grid each sensed face has."""
    places = _lattice(spec).places
    return places.reshape(len(places), -1)


def shared_counts(spec: ObjectSpec) -> tuple[int, int]:
    """Counts of the largest grid that all faces have, where each has a rectangle of locations."""
    shared = np.asarray(_lattice(spec).places.all(axis=0))
    return int(shared.any(axis=1).sum()), int(shared.any(axis=0).sum())


def outermost_mm(spec: ObjectSpec) -> Float[np.ndarray, "2"]:
    """Largest x and y of the first face's contact locations."""
    has_place = _lattice(spec).places[0]
    last = [np.flatnonzero(has_place.any(axis=across))[-1] for across in (1, 0)]
    return (np.array(last) - (np.array(has_place.shape) - 1) / 2) * spec.contact_grid.pitch_mm


def face_rows(spec: ObjectSpec, faces: Int[np.ndarray, "face"]) -> Int[np.ndarray, "face"]:
    """Rows of `contact_places` and `pressed_nodes` that hold these faces."""
    return np.array([spec.body.sensed.index(face) for face in faces.tolist()], int)


@cached_geometry
def pressed_nodes(spec: ObjectSpec) -> Bool[np.ndarray, "face node"]:
    """Return which places of the press lattice are pressed: each contact location and its eight neighbours.

    These are what interpolation within half a pitch of a contact location stands on.
    """
    places = _lattice(spec).places
    faces, nx, ny = places.shape
    nodes = np.zeros((faces, 2 * nx + 1, 2 * ny + 1), bool)
    for right, up in product(range(3), repeat=2):
        nodes[:, right : right + 2 * nx : 2, up : up + 2 * ny : 2] |= places
    return nodes.reshape(faces, -1)


def place_problems(spec: ObjectSpec) -> Iterator[str]:
    """Yield what is wrong with faces on which no two by two contact locations find room."""
    too_few = [
        (frame, counts)
        for frame, places in zip(face_frames(spec), _lattice(spec).places, strict=True)
        if min(counts := (places.any(axis=1).sum(), places.any(axis=0).sum())) < LEAST_COUNT
    ]
    if too_few:
        pitch = nearest_pitch_mm(spec)
        smaller = f"contact_grid.pitch_mm of {pitch:g}, " if pitch else ""
        for frame, counts in too_few:
            half = frame.half_lengths_mm
            yield (
                f'contact_grid.count = "fill" finds room for {counts[0]} × {counts[1]} locations on face '
                f"{frame.number} (±{half[0]:.4g}, ±{half[1]:.4g} mm), {spec.contact_grid.pitch_mm:g} mm "
                f"apart; 2 × 2 are needed. Use {smaller}a smaller indenter or lesser press.depths_mm, or "
                "leave the face out of body.sensed_faces"
            )


def nearest_pitch_mm(spec: ObjectSpec) -> float | None:
    """The largest pitch found with which every face has two by two locations; None: the tip is too wide."""

    def works(pitch: float) -> bool:
        try:
            places = filled_places(spec, pitch).places
        except SpecError:
            return False
        counts = [places.any(axis=axis).sum(axis=1).min() for axis in (2, 1)]
        return bool(min(counts) >= LEAST_COUNT)

    given = spec.contact_grid.pitch_mm
    tried = (round(given * _FINER**k, 2) for k in range(1, _FINER_STEPS))
    low = next((pitch for pitch in tried if pitch > 0 and works(pitch)), None)
    if low is None:
        return None
    high = min(low / _FINER, given)
    while high - low > 0.02:
        middle = round((low + high) / 2, 2)
        low, high = (middle, high) if works(middle) else (low, middle)
    return low


@cached_geometry
def _lattice(spec: ObjectSpec) -> _Lattice:
    given = spec.contact_grid.count
    if given == "fill":
        return filled_places(spec, spec.contact_grid.pitch_mm)
    return _Lattice(given, np.ones((len(face_frames(spec)), *given), bool))


def filled_places(spec: ObjectSpec, pitch_mm: float) -> _Lattice:
    """Even or odd counts along each axis, whichever gives more locations on all faces together."""
    step = pitch_mm / 2
    half = np.max([abs(frame.lengths_mm).max(axis=0) for frame in face_frames(spec)], axis=0)
    most = np.floor(half / step).astype(int)
    if max(most) >= MOST_COUNT + 2:
        least = ceil(100 * (2 * max(half) / (MOST_COUNT + 2) + 1e-6)) / 100
        raise SpecError(
            f"contact_grid.pitch_mm = {2 * step:g} would fill a face of {2 * max(half):.4g} mm with more "
            f"than {MOST_COUNT} locations along an axis. Use a pitch of {least:g} or more"
        )
    x, y = (np.arange(-n, n + 1) * step for n in most)
    nodes = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    free = np.stack([tip_stays(spec, frame, nodes) for frame in face_frames(spec)])
    free = all_around(free.reshape(len(free), len(x), len(y)))
    choices = [nodes_of_parity(free, (a, b)) for a, b in product((False, True), repeat=2)]
    return max(choices, key=lambda lattice: lattice.places.sum())


def all_around(free: Bool[np.ndarray, "face i j"]) -> Bool[np.ndarray, "face i j"]:
    """Nodes that are free with their eight neighbours."""
    padded = np.pad(free, ((0, 0), (1, 1), (1, 1)))
    _, rows, columns = free.shape
    around = [padded[:, i : i + rows, j : j + columns] for i, j in product(range(3), repeat=2)]
    return np.logical_and.reduce(around)


def nodes_of_parity(free: Bool[np.ndarray, "face i j"], odd: tuple[bool, bool]) -> _Lattice:
    """Every second node of the half-pitch lattice, cut to what any face uses."""
    middle = np.array(free.shape[1:]) // 2
    slices = [slice((m + (not is_odd)) % 2, None, 2) for m, is_odd in zip(middle, odd, strict=True)]
    places = free[:, slices[0], slices[1]]
    for axis in (1, 2):
        used = np.flatnonzero(places.any(axis=(0, 3 - axis)))
        least = min(LEAST_COUNT + odd[axis - 1], places.shape[axis])
        spare = (places.shape[axis] - least) // 2
        ends = min(used[0], spare) if len(used) else spare
        places = np.moveaxis(
            np.moveaxis(places, axis, 0)[ends : places.shape[axis] - ends], 0, axis
        )
    return _Lattice(places.shape[1:], places)  # pyright: ignore[reportArgumentType]


def tip_stays(
    spec: ObjectSpec, frame: FaceFrame, place_mm: Float[np.ndarray, "node 2"]
) -> Bool[np.ndarray, "node"]:
    """Return whether the tips, pressed at places down to the deepest step, land on the face.

    The lowest point of each must. What hangs over the border of a flat face presses nothing, as over
    the ends of a cylinder; beyond that of a curved patch the body goes on (`FaceFrame.touched`).
    Where slits cut the edges the whole outline must stay on the face.
    """
    tips = (
        footprint_mm(spec.indenter) if spec.shell.slits.depth_mm else tip_places_mm(spec.indenter)
    )
    path = path_mm(spec.indenter, spec.press.depths_mm)[-1]
    reach = np.maximum(abs(tips + path), abs(tips)).max(axis=0)
    if not frame.flat:
        return stays_on_patch(frame, place_mm, touched_reach_mm(spec), tip_places_mm(spec.indenter))
    if frame.round:
        radius = min(frame.half_extents_mm) - _ROUND_MARGIN_MM
        return np.linalg.norm(place_mm, axis=1) + np.linalg.norm(reach) <= radius
    return np.all(abs(place_mm) + reach <= np.array(frame.half_extents_mm) + 1e-9, axis=1)


def touched_reach_mm(spec: ObjectSpec) -> float:
    """Return how far from the place pressed the tips touch at the deepest press, on a flat face."""
    deepest, shape = spec.press.depths_mm[-1], tip_shape(spec.indenter)
    radii = np.linspace(0, np.linalg.norm(shape.corners_mm, axis=1).max(), 200)
    angle = np.deg2rad(np.arange(0, 360, 10))
    around = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    lowest = tip_heights_mm(shape, radii[:, None, None] * around).min(axis=1)
    is_round = shape.ellipsoid is not None
    reach = float(radii[lowest <= deepest].max()) if is_round else float(radii[-1])
    return reach + float(np.linalg.norm(tip_places_mm(spec.indenter), axis=1).max())


def stays_on_patch(
    frame: FaceFrame,
    place_mm: Float[np.ndarray, "node 2"],
    reach_mm: float,
    tips_mm: Float[np.ndarray, "tip 2"] = _ONE_TIP_MM,
) -> Bool[np.ndarray, "node"]:
    """Return whether tips land on the patch at places, and touch only where the surface is known.

    A tip touches up to `reach_mm` from its place; its lowest point is `tips_mm` from there.
    """
    xy_mm = frame.to_plane(place_mm)
    stays = frame.covers(xy_mm)
    if not stays.any():
        return stays
    turn = np.linspace(0, 2 * np.pi, _RING_POINTS)
    ring = reach_mm * np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=-1)
    offsets = np.vstack([ring, np.pad(tips_mm, ((0, 0), (0, 1)))])
    places = xy_mm[stays]
    axes = frame.axes_at(places)
    touching = frame.to_object(np.column_stack([places, np.zeros(len(places))]))
    # p place, r point of the ring or a tip, j own axis (columns of `axes`), i object coordinate
    points = touching[:, None] + np.einsum("pij,rj->pri", axes, offsets)
    normals = np.repeat(axes[:, :, 2], len(offsets), axis=0)
    on_plane = frame.project_along(points.reshape(-1, 3), normals)[:, :2]
    on_plane = on_plane.reshape(len(places), len(offsets), 2)
    # where the body itself ends a disk may hang over, a tip not
    half = np.where(frame.ends, frame.half_extents_mm, np.inf)
    on_plane[:, : len(ring)] = np.clip(on_plane[:, : len(ring)], -half, half)
    touched, landed = np.split(
        np.where(np.isfinite(on_plane), on_plane, np.inf), [len(ring)], axis=1
    )
    stays[stays] = frame.touched(touched).all(axis=1) & frame.covers(landed).all(axis=1)
    return stays
