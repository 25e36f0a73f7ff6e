"""Placement of magnets, sensors and contact locations on a body, from its own faces.

Shell, magnets and core are tried from generous to tight, sensors from far out to the middle, magnets
from the shortest signal paths to longer ones (`design.placement.paths`), and the first that fits is
taken: what fits is said by `design.fit` and, for gaps that can be cast and printed, by
`design.placement.room`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import product
from math import hypot
from typing import Any

import numpy as np
from pydantic import ValidationError

from design.body.kinds.pad import Pad
from design.body.kinds.registry import KINDS
from design.body.surface_chart import FaceFrame
from design.errors import InputError, SpecError
from design.fit.everything import can_be_moulded, fits
from design.layout.boards import wire_bundle_mm
from design.layout.body import body_of, core_frames, face_frames
from design.layout.places.contact_places import MOST_COUNT, contact_places
from design.layout.places.positions import board_sinks_mm, sensor_layout
from design.placement.paths import long_path_mm
from design.placement.patterns import Shares, magnet_patterns, sensor_patterns
from design.placement.room import (
    low_rim,
    outlet_room_mm,
    tight_core,
    tight_middle,
    tight_rim,
    tight_shell,
)
from design.spec.base import complaints
from design.spec.body import LONGEST_EDGE_MM
from design.spec.object import ObjectSpec

Tables = dict[str, dict[str, Any]]
"""Tables of a specification, with what differs from the paper's cube."""

_SHARES = tuple(np.arange(0.66, 0.2, -0.04).round(2).tolist())
"""Of a face's half extents: how far out parts are tried."""
_COARSE = _SHARES[::3]
"""Fewer of them, while a size that works is looked for."""
_COUNTS = (5, 4, 3, 2, 1)
_FEWEST = (1, 2)
"""Of magnets, where none is asked for: as many as fit, or one, or two where its pocket in the middle of
the face is in the way."""
_SIDE_HOLE_MM = 3.0
_LEAST_BORE_MM = 4.0
_FLOOR_MM = 1.0
"""Of a core's wall behind a recess: more than the printer's thinnest by a quarter."""
_GROWTH, _LARGEST_GROWTH, _LARGEST_BESIDE, _HALVINGS = 1.25, 8.0, 3.1, 3
"""Steps in which a larger size is looked for, how far, how far where longer short edges help, and how
often the last step is halved."""
_PLATE = 0.5
"""Of the shorter of the other edges, up to which a height is that of a plate."""
_HALF_RECESS_MM = 3.25
"""Of a recess along the board, a little longer than the board."""


@dataclass(frozen=True)
class Trim:
    """A shell and its magnets, disks 1 mm high that fill their pockets (mm)."""

    thickness_mm: float
    pocket_diameter_mm: float
    pocket_depth_mm: float


_TRIMS = (
    Trim(8.0, 6.0, 3.0),
    Trim(7.0, 5.0, 3.0),
    Trim(6.0, 4.0, 3.0),
    Trim(5.0, 4.0, 2.5),
)
_TIP_RADII_MM = (5.0, 4.0, 3.0, 2.0)
_PITCHES_MM = (3.0, 2.5, 2.0, 1.5, 1.0)
_LEAST_PLACES = 16
"""Contact locations of every face."""


@dataclass(frozen=True)
class Request:
    """What a user asks for: kind of body, its box (mm), sensors and magnets per face.

    Without a number of magnets, as many as fit, five at most. An imported body has `size_mm` of its
    file, and the keys of `[body]` that read it in `file`. Without `faces` all are sensed on which
    everything finds room.
    """

    kind: str
    size_mm: tuple[float, float, float]
    sensors: int = 3
    magnets: int | None = None
    file: tuple[tuple[str, Any], ...] = ()
    faces: tuple[int, ...] | None = None


def placed(request: Request) -> Tables:
    """Tables of a specification in which everything fits and can be made.

    Raises
    ------
    SpecError
        The kind takes no such size, or it is too small; with the smallest that works.
    """
    return next(placements(request))


def placements(request: Request) -> Iterator[Tables]:
    """The same for each shell that takes everything, the most generous first.

    Raises
    ------
    SpecError
        As `placed`.
    """
    found = False
    for tables in _fitting(request, _TRIMS, _SHARES):
        found = True
        yield tables
    if not found:
        raise SpecError(_too_small(request))


def first_fit(
    request: Request, trims: tuple[Trim, ...] = _TRIMS, shares: tuple[float, ...] = _SHARES
) -> Tables | None:
    """The same, or None where nothing fits of these trims and shares of the faces' half extents.

    Where not all faces take everything, those that do by themselves are sensed.
    """
    return next(_fitting(request, trims, shares), None)


def _fitting(
    request: Request, trims: tuple[Trim, ...], shares: tuple[float, ...]
) -> Iterator[Tables]:
    found = False
    for tables in _fits(request, trims, shares):
        found = True
        yield tables
    if found or request.faces is not None:
        return
    for fewer in (_roomy_faces, _largest_together):
        faces = fewer(request)
        for tables in _fits(replace(request, faces=faces), trims, shares) if faces else ():
            found = True
            yield tables
        if found:
            return


def _fit(request: Request, trims: tuple[Trim, ...], shares: tuple[float, ...]) -> Tables | None:
    return next(_fits(request, trims, shares), None)


def _fits(
    request: Request,
    trims: tuple[Trim, ...],
    shares: tuple[float, ...],
    counts: tuple[int, ...] = _COUNTS,
) -> Iterator[Tables]:
    """Of each shell that takes everything; at last as sizes are tried, so that one that is named works."""
    found = False
    for tables in _of_shells(request, trims, shares, counts):
        found = True
        yield tables
    if not found and shares != _COARSE:
        yield from _roughly(request)


def _roughly(request: Request) -> Iterator[Tables]:
    """As sizes are tried: under the thinnest shell, which leaves the most room, with few magnets."""
    return _fits(request, _TRIMS[-1:], _COARSE, _FEWEST)


def _of_shells(
    request: Request, trims: tuple[Trim, ...], shares: tuple[float, ...], counts: tuple[int, ...]
) -> Iterator[Tables]:
    for trim in trims:
        tables = _with_sensors(request, trim, shares)
        tables = tables and _with_magnets(request, tables, shares, counts)
        tables = tables and _with_contacts(tables)
        if tables:
            yield tables


def _roomy_faces(request: Request) -> tuple[int, ...]:
    """Faces on which everything finds room by itself, under the thinnest shell; () where all have it."""
    every = spec_of(_body(request, _TRIMS[-1])).body.sensed
    if len(every) == 1:
        return ()
    found = tuple(face for face in every if _fits_roughly(replace(request, faces=(face,))))
    return found if len(found) < len(every) else ()


def _largest_together(request: Request) -> tuple[int, ...]:
    """The most faces, largest first, that take everything together; () where there are none."""
    every = spec_of(_body(request, _TRIMS[-1])).body.sensed
    frames = [frame for face in every for frame in _frame_where_there_is(request, face)]
    frames = sorted(frames, key=lambda frame: -float(np.prod(frame.half_extents_mm)))
    for count in range(min(len(frames), len(every) - 1), 0, -1):
        faces = tuple(sorted(frame.number for frame in frames[:count]))
        if _fits_roughly(replace(request, faces=faces)):
            return faces
    return ()


def _frame_where_there_is(request: Request, face: int) -> tuple[FaceFrame, ...]:
    """Of a face by itself; () where the surface about it is too steep or too small for a patch."""
    try:
        return face_frames(spec_of(_body(replace(request, faces=(face,)), _TRIMS[-1])))
    except InputError:
        return ()


def spec_of(tables: Tables) -> ObjectSpec:
    """The specification of these tables, not yet checked for fit."""
    return ObjectSpec.model_validate({"name": "placed", **tables})


def _body(request: Request, trim: Trim) -> Tables:
    kind = KINDS[request.kind]
    body: dict[str, Any] = {"kind": request.kind, **dict(request.file)}
    body["size_mm"] = list(request.size_mm)
    if request.faces is not None:
        body["sensed_faces"] = list(request.faces)
    if kind.openable and not kind.opens_sides:
        room = min(request.size_mm) - 2 * trim.thickness_mm
        body["bore_mm"] = float(np.clip(np.floor(room / 2), _LEAST_BORE_MM, 10.0))
    shell = {
        "thickness_mm": trim.thickness_mm,
        "pocket_diameter_mm": trim.pocket_diameter_mm,
        "pocket_depth_mm": trim.pocket_depth_mm,
    }
    # one tiny magnet and few places, until there are sensors
    return {
        "body": body,
        "shell": shell,
        "magnets": {"diameter_mm": 0.5, "height_mm": 0.5, "positions_mm": [[0.0, 0.0]]},
        "contact_grid": {"count": [2, 2], "pitch_mm": 0.5},
        "indenter": {"radius_mm": _TIP_RADII_MM[-1]},
        "press": {"depths_mm": list(_DEPTHS_MM[:2])},
    }


_DEPTHS_MM = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0)


def _with_sensors(request: Request, trim: Trim, shares: tuple[float, ...]) -> Tables | None:
    body = _body(request, trim)
    try:
        start = spec_of(body)
    except ValidationError as error:
        raise SpecError("\n".join(complaints(error, ObjectSpec))) from None
    room, _ = body_of(start).room_for_recesses
    if room <= start.core.recess_depth_mm:
        return None
    try:
        halves = [np.array(frame.half_extents_mm) for frame in core_frames(start)]
    except InputError:  # no core lies that deep, or a face of it has no patch
        return None
    if min(min(half) for half in halves) <= 0:
        return None
    for patterns in sensor_patterns(request.sensors):
        found = _with_patterns(request, body, halves, [*product(shares, patterns)])
        if found is not None:
            return found
    return None


def _with_patterns(
    request: Request,
    body: Tables,
    halves: list[np.ndarray],
    tried: list[tuple[float, Shares]],
) -> Tables | None:
    """The first share and pattern that fit; if need be one whose recesses end in the core's slope."""
    on_slopes = []
    for share, pattern in tried:
        tables = body | _electronics(request, [share * half * pattern for half in halves])
        spec = spec_of(tables)
        if tight_middle(spec) or tight_core(spec, sunk=False):
            continue
        wall = _wall_mm(spec)
        if wall is None or tight_core(spec) or tight_rim(spec):
            continue
        tables["core"]["wall_mm"] = wall
        if body_of(spec).opening == "bore":
            bore = min(spec.body.bore_mm, float(np.floor(2 * outlet_room_mm(spec))))
            if bore < _LEAST_BORE_MM:
                continue
            tables["body"] = tables["body"] | {"bore_mm": bore}
        if low_rim(spec):
            on_slopes.append(tables)
        elif fits(spec_of(tables)):
            return tables
    return next((tables for tables in on_slopes if fits(spec_of(tables))), None)


def _electronics(request: Request, faces: list[Shares]) -> Tables:
    """Recesses about the boards' middles, sensors in them, and holes for their wires (mm)."""
    places = [_rounded(face) for face in faces]
    radius = round(max(3.5, min(hypot(*xy) for face in places for xy in face)), 2)
    hole = _hole_mm(request.sensors)
    core = {
        "recess_inner_radius_mm": round(radius - _HALF_RECESS_MM, 2),
        "recess_outer_radius_mm": round(radius + _HALF_RECESS_MM, 2),
        "wire_hole_top_diameter_mm": hole,
        "wire_hole_side_diameter_mm": max(_SIDE_HOLE_MM, hole),
        "hub_radius_mm": max(_SIDE_HOLE_MM, hole) / 2,
    }
    sensors = {
        "count_per_face": request.sensors,
        "radius_mm": radius,
        "positions_mm": _per_face(places),
    }
    return {"core": core, "sensors": sensors}


def _hole_mm(sensors: int) -> float:
    bundle = wire_bundle_mm(spec_of({"sensors": {"count_per_face": sensors}}))
    return max(2.0, float(np.ceil(2.2 * bundle)) / 2)


def _wall_mm(spec: ObjectSpec) -> float | None:
    """Core wall that leaves a floor behind the deepest recess; None where a board finds no room."""
    room, _ = body_of(spec).room_for_recesses
    deepest = spec.core.recess_depth_mm + float(np.max(board_sinks_mm(spec)))
    if not deepest < room:
        return None
    return max(4.0, float(np.ceil(2 * (deepest + _FLOOR_MM))) / 2)


def _with_magnets(
    request: Request, tables: Tables, shares: tuple[float, ...], counts: tuple[int, ...]
) -> Tables | None:
    """Most magnets first; of their patterns and spreads, over each face or alike on all, the one with the
    shortest signal paths."""
    diameter = tables["shell"]["pocket_diameter_mm"]
    counts = counts if request.magnets is None else (request.magnets,)
    halves = np.array([frame.half_extents_mm for frame in face_frames(spec_of(tables))])
    smallest = np.broadcast_to(halves.min(axis=0), halves.shape)
    spreads = [smallest] if np.allclose(halves, smallest) else [halves, smallest]
    sensors = sensor_layout(spec_of(tables))
    for count in counts:
        tried = []
        for places in _different_places(count, shares, spreads):
            magnets = {"diameter_mm": diameter, "positions_mm": places}
            spec = spec_of(tables | {"magnets": magnets})
            tried.append((long_path_mm(spec, sensors), magnets, spec))
        for _, magnets, spec in sorted(tried, key=lambda one: one[0]):
            if fits(spec, mould=False) and not tight_shell(spec) and can_be_moulded(spec):
                return tables | {"magnets": magnets}
    return None


def _different_places(
    count: int, shares: tuple[float, ...], spreads: list[np.ndarray]
) -> list[list[Any]]:
    """Of every pattern, share and spread; once those that come out alike, as one in the middle does."""
    found = list[list[Any]]()
    for pattern, share, spread in product(magnet_patterns(count), shares, spreads):
        places = _per_face([_rounded(share * half * pattern) for half in spread])
        if places not in found:
            found.append(places)
    return found


def _with_contacts(tables: Tables) -> Tables | None:
    """The widest tip, and the coarsest pitch that leaves every face a few contact locations."""
    deepest = tables["shell"]["thickness_mm"] / 2
    for radius, pitch in product(_TIP_RADII_MM, _pitches_mm(spec_of(tables))):
        more = {
            "indenter": {"radius_mm": radius},
            "contact_grid": {"count": "fill", "pitch_mm": pitch},
            "press": {"depths_mm": [d for d in _DEPTHS_MM if d <= deepest and d < radius]},
        }
        spec = spec_of(tables | more)
        if fits(spec, mould=False) and contact_places(spec).sum(axis=1).min() >= _LEAST_PLACES:
            return tables | more
    return None


def _pitches_mm(spec: ObjectSpec) -> tuple[float, ...]:
    """Coarser ones where a lattice may not have as many locations as the largest face would take."""
    widest = 2 * float(np.max([abs(frame.lengths_mm) for frame in face_frames(spec)]))
    least = widest / MOST_COUNT
    return _PITCHES_MM if least < _PITCHES_MM[0] else (float(np.ceil(least)),)


def _per_face(places: list[list[list[float]]]) -> list[Any]:
    """One list for all faces where they are alike."""
    return places[0] if all(face == places[0] for face in places) else places


def _rounded(places_mm: Shares) -> list[list[float]]:
    return [[round(float(x), 2) + 0.0 for x in xy] for xy in places_mm]


def _too_small(request: Request) -> str:
    size = " × ".join(f"{edge:g}" for edge in request.size_mm)
    body = "an imported body" if request.file else f"a body of kind {request.kind}"
    sensors = f"{request.sensors} sensor{'s' * (request.sensors > 1)}"
    magnets = f"{request.magnets} magnets" if (request.magnets or 1) > 1 else "a magnet"
    message = f"{body} of {size} mm is too small for {sensors} and {magnets} per face"
    ways = [*_larger(request), *_on_base(request), *_fewer(request)]
    if not ways:
        return f"{message}, whatever its size. Choose another shape"
    return f"{message}. {'; or '.join(ways)}"


def _larger(request: Request) -> Iterator[str]:
    """Sizes that work: of that shape, and where that helps with the short edges longer alone."""
    flat = min(request.size_mm) < max(request.size_mm) and not request.file
    thicker = _smallest(request, min(request.size_mm), _thickened) if flat else None
    most = _LARGEST_GROWTH if thicker is None else _LARGEST_BESIDE
    whole = _smallest(request, max(request.size_mm), _grown, most)
    if whole is not None:
        scale = f" (scale = {dict(whole.file)['scale']:.4g})" if whole.file else ""
        yield f"The smallest of that shape that works is about {_told(whole)}{scale}"
    if thicker is not None and (whole is None or thicker.size_mm != whole.size_mm):
        yield f"{'with' if whole else 'With'} its short edges longer about {_told(thicker)} works"


def _told(request: Request) -> str:
    faces = request.faces or ()
    sensed = f" with sensors on face{'s' * (len(faces) > 1)} {', '.join(map(str, faces))} alone"
    return " × ".join(f"{edge:g}" for edge in request.size_mm) + " mm" + sensed * bool(faces)


def _smallest(
    request: Request,
    edge_mm: float,
    grown: Callable[[Request, float], Request],
    most: float = _LARGEST_GROWTH,
) -> Request | None:
    """The request at about the least growth, up to `most`, at which everything finds room; or None.

    `edge_mm` is the edge that grows, to what a body may measure at most.
    """

    def working(growth: float) -> Request | None:
        larger = grown(request, growth)
        return _fitting_roughly(larger) if KINDS[larger.kind].takes_size(larger.size_mm) else None

    low, high, found = 1.0, _GROWTH, None
    largest = min(most, LONGEST_EDGE_MM[1] / edge_mm)
    while high <= largest and (found := working(high)) is None:
        low, high = high, high * _GROWTH
    for _ in range(_HALVINGS if found else 0):
        middle = (low + high) / 2
        smaller = working(middle)
        low, high, found = (low, middle, smaller) if smaller else (middle, high, found)
    return found


def _on_base(request: Request) -> Iterator[str]:
    """A plate whose core has no room for its walls, as a slab on a rigid base."""
    x, y, z = request.size_mm
    plate = KINDS[request.kind].cuboid and z <= _PLATE * min(x, y)
    if plate and _fits_roughly(replace(request, kind=Pad.name, faces=None)):
        yield f"--kind {Pad.name}, a slab of that size on a rigid base, sensed from above, would fit"


def _fewer(request: Request) -> Iterator[str]:
    """Fewer sensors, and fewer magnets, that the size takes on all faces."""
    for count in sorted({request.sensors - 1, request.sensors // 2, 1} - {0}, reverse=True):
        if count < request.sensors and _fits_roughly(replace(request, sensors=count)):
            yield f"{count} sensor{'s' * (count > 1)} per face would fit"
            break
    if request.magnets is not None and request.magnets > 1:
        found = _fit(replace(request, magnets=None), _TRIMS[-1:], _COARSE)
        if found is not None:
            count = len(found["magnets"]["positions_mm"])
            yield f"{count} magnet{'s' * (count > 1)} per face would fit"


def _fits_roughly(request: Request) -> bool:
    """Whether the thinnest shell takes everything: trying all is slow."""
    return next(_roughly(request), None) is not None


def _fitting_roughly(request: Request) -> Request | None:
    """The request where it fits roughly, if need be without the faces that do not take everything by
    themselves, as `first_fit` leaves them out; None where it does not."""
    if _fits_roughly(request):
        return request
    faces = () if request.faces is not None else _roomy_faces(request)
    fewer = replace(request, faces=faces)
    return fewer if faces and _fits_roughly(fewer) else None


def _grown(request: Request, growth: float) -> Request:
    x, y, z = (float(np.ceil(2 * growth * edge)) / 2 for edge in request.size_mm)
    file = {**dict(request.file)}
    if file:
        file["scale"] = file.get("scale", 1.0) * growth
    return replace(request, size_mm=(x, y, z), file=tuple(file.items()))


def _thickened(request: Request, growth: float) -> Request:
    floor = float(np.ceil(2 * growth * min(request.size_mm))) / 2
    x, y, z = (max(edge, floor) for edge in request.size_mm)
    return replace(request, size_mm=(x, y, z))
