"""Placement of magnets, sensors and contact locations on a body, from its own faces.

Shell, magnets and core are tried from generous to tight, sensors from far out to the middle, magnets
from the shortest signal paths to longer ones (`design.placement.paths`), and the first that fits is
taken: what fits is said by `design.fit` and, for gaps that can be cast and printed, by
`design.placement.room`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import chain, product
from math import hypot
from typing import Any

import numpy as np
from pydantic import ValidationError

from design.body.kinds.registry import KINDS
from design.body.surface_chart import FACE_AXES, FaceFrame
from design.errors import InputError, SpecError
from design.fit.everything import can_be_moulded, fits
from design.layout.boards import wire_bundle_mm
from design.layout.body import body_of, core_frames, face_frames
from design.layout.core_hold import least_bore_mm
from design.layout.places.contact_places import MOST_COUNT, contact_places
from design.layout.places.positions import board_sinks_mm, sensor_layout
from design.placement.paths import long_path_mm
from design.placement.patterns import (
    Shares,
    along_longer_side,
    magnet_patterns,
    sensor_patterns,
)
from design.placement.room import (
    low_rim,
    narrow_heads,
    outlet_room_mm,
    thin_beside_wire_hole,
    thin_over_outlet,
    thin_round_bore,
    tight_core,
    tight_marks,
    tight_middle,
    tight_rim,
    tight_shell,
)
from design.spec.base import complaints
from design.spec.object import ObjectSpec

Tables = dict[str, Any]
"""Tables of a specification with what differs from the paper's cube, and keys above them such as its name."""

SHARES = tuple(np.arange(0.66, 0.2, -0.04).round(2).tolist())
"""Shares of a face's half extents: how far out parts are tried."""
COARSE = SHARES[::3]
"""Fewer of them, while a size that works is looked for."""
_COUNTS = (5, 4, 3, 2, 1)
_FEWEST = (1, 2)
"""Numbers of magnets, where none is asked for: as many as fit, or one, or two where its pocket in the
middle of the face is in the way."""
_SIDE_HOLE_MM = 3.0
_LEAST_BORE_MM = 4.0
_FLOOR_MM = 1.0
"""Thickness of a core's wall behind a recess: more than the printer's thinnest by a quarter."""
_HALF_RECESS_MM = 3.25
"""Half length of a recess along the board, a little longer than the board."""


@dataclass(frozen=True)
class ShellVariant:
    """A shell and its magnets, disks as wide as their pockets, on whose floors they lie (mm)."""

    thickness_mm: float
    pocket_diameter_mm: float
    pocket_depth_mm: float
    magnet_height_mm: float = 1.0

    @property
    def table(self) -> dict[str, float]:
        """The shell's own keys."""
        keys = ("thickness_mm", "pocket_diameter_mm", "pocket_depth_mm")
        return {key: getattr(self, key) for key in keys}


def shell_variant_of(tables: Tables) -> ShellVariant:
    """Return the shell and the magnets' height of tables."""
    return ShellVariant(**tables["shell"], magnet_height_mm=tables["magnets"].get("height_mm", 1.0))


SHELL_VARIANTS = (
    ShellVariant(8.0, 6.0, 3.0),
    ShellVariant(7.0, 5.0, 3.0),
    ShellVariant(6.0, 4.0, 3.0),
    ShellVariant(5.0, 4.0, 2.5),
)
STRONGER = (
    ShellVariant(5.0, 4.0, 3.0, 1.5),
    ShellVariant(6.0, 4.0, 3.5, 2.0),
    ShellVariant(6.0, 6.0, 3.5, 2.0),
    ShellVariant(7.0, 6.0, 4.0, 2.0),
    ShellVariant(7.0, 8.0, 4.0, 2.0),
    ShellVariant(8.0, 6.0, 5.0, 3.0),
    ShellVariant(8.0, 8.0, 5.0, 3.0),
    ShellVariant(8.0, 10.0, 5.0, 3.0),
    ShellVariant(12.0, 10.0, 6.0, 3.0),
    ShellVariant(12.0, 15.0, 8.0, 5.0),
    ShellVariant(16.0, 15.0, 8.0, 5.0),
    ShellVariant(24.0, 20.0, 9.0, 5.0),
)
"""The same with stronger magnets, stock sizes, for bodies whose first ones are seen too little."""
_TIP_RADII_MM = (5.0, 4.0, 3.0, 2.0)
PITCHES_MM = (3.0, 2.5, 2.0, 1.5, 1.0)
_MOST_IN_A_ROW = 26
"""Contact locations along the longest face, from which on the pitch follows the size."""
_LEAST_PLACES = 16
"""Contact locations of every face."""


_TURNED = {4: 2, 5: 3}
"""Faces as others are after half a turn about z, by which all bodies but those of files stay the same."""


@dataclass(frozen=True)
class Request:
    """Request of a user: kind of body, its box (mm), sensors and magnets per face.

    Without a number of magnets, as many as fit, five at most; fewer sensors where these find no room, if
    `takes_fewer`. An imported body has `size_mm` of its
    file, and the keys of `[body]` that read it in `file`. Without `faces` all are sensed on which
    everything finds room. Sizes that work are looked for under the `thinnest` shell.
    """

    kind: str
    size_mm: tuple[float, float, float]
    sensors: int = 3
    magnets: int | None = None
    file: tuple[tuple[str, Any], ...] = ()
    faces: tuple[int, ...] | None = None
    thinnest: ShellVariant = SHELL_VARIANTS[-1]
    takes_fewer: bool = False


def first_fit(
    request: Request,
    shells: tuple[ShellVariant, ...] = SHELL_VARIANTS,
    shares: tuple[float, ...] = SHARES,
) -> Tables | None:
    """The same, or None where nothing fits of these shells and shares of the faces' half extents.

    Where not all faces take everything, the faces that do by themselves are sensed.
    """
    return next(fitting(request, shells, shares), None)


def fitting(
    request: Request, shells: tuple[ShellVariant, ...], shares: tuple[float, ...]
) -> Iterator[Tables]:
    """Yield the tables of each shell that takes everything: on all faces, else on faces that do by
    themselves, else on the largest that do together."""
    has_tables = False
    for tables in fitting_tables(request, shells, shares):
        has_tables = True
        yield tables
    if has_tables or request.faces is not None:
        return
    for fewer in (roomy_faces, _largest_together):
        faces = fewer(request)
        for tables in (
            fitting_tables(replace(request, faces=faces), shells, shares) if faces else ()
        ):
            has_tables = True
            yield tables
        if has_tables:
            return


def fitting_most(
    request: Request, shells: tuple[ShellVariant, ...], shares: tuple[float, ...]
) -> Iterator[Tables]:
    """Yield the same; of a request that takes fewer sensors, with the number of a face of which the whole
    body takes most."""
    best, most = iter(()), 0
    for sensors in range(request.sensors, 0 if request.takes_fewer else request.sensors - 1, -1):
        layouts = fitting(replace(request, sensors=sensors), shells, shares)
        first = next(layouts, None)
        if first is None:
            continue
        sensors_of_body = sensors * len(spec_of(first).body.sensed)
        if sensors_of_body > most:
            best, most = chain([first], layouts), sensors_of_body
        # all faces take them, or fewer on every face would be no more of them
        if "sensed_faces" not in first["body"] or most >= (sensors - 1) * len(FACE_AXES):
            break
    yield from best


def fitting_tables(
    request: Request,
    shells: tuple[ShellVariant, ...],
    shares: tuple[float, ...],
    counts: tuple[int, ...] = _COUNTS,
) -> Iterator[Tables]:
    """Yield the tables of each shell that takes everything; at last as sizes are tried, so that one that
    is named works."""
    has_tables = False
    for tables in _tables_of_shells(request, shells, shares, counts):
        has_tables = True
        yield tables
    if not has_tables and shares != COARSE:
        yield from _roughly(request)


def _roughly(request: Request) -> Iterator[Tables]:
    """Yield tables as sizes are tried: under the thinnest shell, which leaves the most room, with few
    magnets."""
    return fitting_tables(request, (request.thinnest,), COARSE, _FEWEST)


def _tables_of_shells(
    request: Request,
    shells: tuple[ShellVariant, ...],
    shares: tuple[float, ...],
    counts: tuple[int, ...],
) -> Iterator[Tables]:
    for shell in shells:
        tables = _with_sensors(request, shell, shares)
        tables = tables and next(_with_magnets(request, shell, tables, shares, counts), None)
        tables = tables and with_contacts(tables)
        if tables:
            yield tables


def fits_roughly(request: Request) -> bool:
    """Return whether the thinnest shell takes everything: trying all is slow."""
    return next(_roughly(request), None) is not None


def roomy_faces(request: Request) -> tuple[int, ...]:
    """Faces on which everything finds room by itself, under the thinnest shell; () where all have it."""
    all_faces = spec_of(bare_tables(request, request.thinnest)).body.sensed
    if len(all_faces) == 1:
        return ()
    roomy = dict[int, bool]()
    for face in all_faces:
        alike = None if KINDS[request.kind].from_file else _TURNED.get(face)
        is_roomy = roomy.get(alike) if alike else None
        roomy[face] = (
            fits_roughly(replace(request, faces=(face,))) if is_roomy is None else is_roomy
        )
    with_room = tuple(face for face in all_faces if roomy[face])
    return with_room if len(with_room) < len(all_faces) else ()


def _largest_together(request: Request) -> tuple[int, ...]:
    """The most faces, largest first, that take everything together; () where there are none."""
    all_faces = spec_of(bare_tables(request, request.thinnest)).body.sensed
    frames = [frame for face in all_faces for frame in _frame_where_there_is(request, face)]
    frames = sorted(frames, key=lambda frame: -float(np.prod(frame.half_extents_mm)))
    for count in range(min(len(frames), len(all_faces) - 1), 0, -1):
        faces = tuple(sorted(frame.number for frame in frames[:count]))
        if fits_roughly(replace(request, faces=faces)):
            return faces
    return ()


def _frame_where_there_is(request: Request, face: int) -> tuple[FaceFrame, ...]:
    """Return the frame of a face; () where the surface about it is too steep or too small for a patch."""
    try:
        return face_frames(spec_of(bare_tables(replace(request, faces=(face,)), request.thinnest)))
    except InputError:
        return ()


def spec_of(tables: Tables) -> ObjectSpec:
    """The specification of these tables, not yet checked for fit."""
    return ObjectSpec.model_validate({"name": "placed", **tables})


def bare_tables(request: Request, shell: ShellVariant) -> Tables:
    """Tables of a body without sensors and with one tiny magnet, to begin with."""
    kind = KINDS[request.kind]
    body: dict[str, Any] = {"kind": request.kind, **dict(request.file)}
    body["size_mm"] = list(request.size_mm)
    if request.faces is not None:
        body["sensed_faces"] = list(request.faces)
    if kind.openable and not kind.opens_sides:
        room = min(request.size_mm) - 2 * shell.thickness_mm
        body["bore_mm"] = float(np.clip(np.floor(room / 2), _LEAST_BORE_MM, 10.0))
    # one tiny magnet and few places, until there are sensors
    return {
        "body": body,
        "shell": shell.table,
        "magnets": {"diameter_mm": 0.5, "height_mm": 0.5, "positions_mm": [[0.0, 0.0]]},
        "contact_grid": {"count": [2, 2], "pitch_mm": 0.5},
        "indenter": {"radius_mm": _TIP_RADII_MM[-1]},
        "press": {"depths_mm": list(_DEPTHS_MM[:2])},
    }


_DEPTHS_MM = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0)


def _with_sensors(
    request: Request, shell: ShellVariant, shares: tuple[float, ...]
) -> Tables | None:
    body = bare_tables(request, shell)
    try:
        start = spec_of(body)
    except ValidationError as error:
        raise SpecError("\n".join(complaints(error, ObjectSpec))) from None
    room, _ = body_of(start).room_for_recesses
    if room <= start.core.recess_depth_mm:
        return None
    try:
        halves = [np.array(frame.half_extents_mm) for frame in core_frames(start)]
        if body_of(start).sampled:
            body_of(start).core_surface()
    # no core lies that deep, it falls into pieces, as in a bottle's neck, or a face of it has no patch
    except InputError:
        return None
    if min(min(half) for half in halves) <= 0:
        return None
    for patterns in sensor_patterns(request.sensors):
        tables = with_patterns(request, body, halves, [*product(shares, patterns)])
        if tables is not None:
            return tables
    return None


def with_patterns(
    request: Request,
    body: Tables,
    halves: list[np.ndarray],
    tried: list[tuple[float, Shares]],
) -> Tables | None:
    """The first share and pattern that fit; if need be one whose recesses end in the core's slope."""
    on_slopes = []
    for share, pattern in tried:
        tables = body | electronics_tables(
            request, [share * half * along_longer_side(pattern, half) for half in halves]
        )
        spec = spec_of(tables)
        if tight_middle(spec) or tight_core(spec, sunk=False):
            continue
        wall = wall_mm(spec)
        if wall is None or tight_core(spec) or tight_rim(spec) or thin_beside_wire_hole(spec):
            continue
        tables["core"]["wall_mm"] = wall
        if thin_over_outlet(spec_of(tables)):
            continue
        if body_of(spec).opening == "bore":
            bore = _bore_mm(spec)
            if bore is None:
                continue
            tables["body"] = tables["body"] | {"bore_mm": bore}
        if low_rim(spec):
            on_slopes.append(tables)
        elif fits(spec_of(tables)):
            return tables
    return next((tables for tables in on_slopes if fits(spec_of(tables))), None)


def _bore_mm(spec: ObjectSpec) -> float | None:
    """The widest bore that leaves walls to recesses and to the sides of the core; None where none does."""
    widest = min(spec.body.bore_mm, float(np.floor(2 * outlet_room_mm(spec))))
    least = max(_LEAST_BORE_MM, least_bore_mm(spec))  # all wires go out through it
    for bore in np.arange(widest, least - 1e-9, -1.0).tolist():
        if not thin_round_bore(spec.changed(body=spec.body.changed(bore_mm=bore))):
            return bore
    return None


def electronics_tables(request: Request, faces: list[Shares]) -> Tables:
    """Recesses about the boards' middles, sensors in them, and holes for their wires (mm)."""
    places = [rounded_places(face) for face in faces]
    radius = round(max(3.5, min(hypot(*xy) for face in places for xy in face)), 2)
    hole = hole_mm(request.sensors)
    core = {
        "recess_inner_radius_mm": round(radius - _HALF_RECESS_MM, 2),
        "recess_outer_radius_mm": round(radius + _HALF_RECESS_MM, 2),
        "wire_hole_top_diameter_mm": hole,
        "wire_hole_side_diameter_mm": max(_SIDE_HOLE_MM, hole),
    }
    sensors = {
        "count_per_face": request.sensors,
        "radius_mm": radius,
        "positions_mm": _lists_per_face(places),
    }
    return {"core": core, "sensors": sensors}


def hole_mm(sensors: int) -> float:
    bundle = wire_bundle_mm(spec_of({"sensors": {"count_per_face": sensors}}))
    return max(2.0, float(np.ceil(2.2 * bundle)) / 2)


def wall_mm(spec: ObjectSpec) -> float | None:
    """Core wall that leaves a floor behind the deepest recess; None where a board finds no room."""
    room, _ = body_of(spec).room_for_recesses
    deepest = spec.core.recess_depth_mm + float(np.max(board_sinks_mm(spec)))
    if not deepest < room:
        return None
    return max(4.0, float(np.ceil(2 * (deepest + _FLOOR_MM))) / 2)


HARD_TO_MAKE = (tight_marks, narrow_heads)
"""Faults against which other patterns of magnets are tried."""


def _with_magnets(
    request: Request,
    shell: ShellVariant,
    tables: Tables,
    shares: tuple[float, ...],
    counts: tuple[int, ...],
) -> Iterator[Tables]:
    """Most magnets first; of their patterns and spreads, over each face or alike on all, the ones that
    fit, the one with the shortest signal paths first, but patterns without a template and pins that can be
    printed last."""
    disk = {"diameter_mm": shell.pocket_diameter_mm}
    if shell.magnet_height_mm != ShellVariant.magnet_height_mm:
        disk["height_mm"] = shell.magnet_height_mm
    counts = counts if request.magnets is None else (request.magnets,)
    halves = np.array([frame.half_extents_mm for frame in face_frames(spec_of(tables))])
    smallest = np.broadcast_to(halves.min(axis=0), halves.shape)
    spreads = [smallest] if np.allclose(halves, smallest) else [halves, smallest]
    sensors = sensor_layout(spec_of(tables))
    for count in counts:
        tried = []
        for places in _different_places(count, shares, spreads):
            magnets = disk | {"positions_mm": places}
            spec = spec_of(tables | {"magnets": magnets})
            tried.append((long_path_mm(spec, sensors), magnets, spec))
        spare = []
        for _, magnets, spec in sorted(tried, key=lambda trial: trial[0]):
            if fits(spec, mould=False) and not tight_shell(spec) and can_be_moulded(spec):
                if any(hard(spec) for hard in HARD_TO_MAKE):
                    spare.append(tables | {"magnets": magnets})
                else:
                    yield tables | {"magnets": magnets}
        yield from spare


def relaid(
    request: Request, tables: Tables, shares: tuple[float, ...] = SHARES
) -> Iterator[Tables]:
    """The same shell and sensors with as many magnets elsewhere, where they fit."""
    count = int(np.shape(tables["magnets"]["positions_mm"])[-2])
    shell = shell_variant_of(tables)
    bare = bare_tables(request, shell) | {key: tables[key] for key in ("body", "core", "sensors")}
    for moved in _with_magnets(request, shell, bare, shares, (count,)):
        complete = None if moved["magnets"] == tables["magnets"] else with_contacts(moved)
        if complete is not None:
            yield complete


def _different_places(
    count: int, shares: tuple[float, ...], spreads: list[np.ndarray]
) -> list[list[Any]]:
    """Return the places of every pattern, share and spread, without repeats, as one in the middle gives."""
    different = list[list[Any]]()
    for pattern, share, spread in product(magnet_patterns(count), shares, spreads):
        places = _lists_per_face([rounded_places(share * half * pattern) for half in spread])
        if places not in different:
            different.append(places)
    return different


def with_contacts(tables: Tables) -> Tables | None:
    """The widest tip, and the coarsest pitch that leaves every face a few contact locations."""
    deepest = tables["shell"]["thickness_mm"] / 2
    for radius, pitch in product(_TIP_RADII_MM, pitches_mm(spec_of(tables))):
        more = {
            "indenter": {"radius_mm": radius},
            "contact_grid": {"count": "fill", "pitch_mm": pitch},
            "press": {"depths_mm": [d for d in _DEPTHS_MM if d <= deepest and d < radius]},
        }
        spec = spec_of(tables | more)
        if fits(spec, mould=False) and contact_places(spec).sum(axis=1).min() >= _LEAST_PLACES:
            return tables | more
    return None


def pitches_mm(spec: ObjectSpec) -> tuple[float, ...]:
    """Coarser ones where the largest face would have more locations along an edge than `_MOST_IN_A_ROW`:
    as wide as the silicone is thick at most, or as its lattice allows."""
    widest = 2 * float(np.max([abs(frame.lengths_mm) for frame in face_frames(spec)]))
    # what a press shows changes over about the shell's thickness: a wider pitch would step over weak places
    even = min(float(np.ceil(2 * widest / _MOST_IN_A_ROW)) / 2, spec.shell.thickness_mm)
    coarse = max(even, float(np.ceil(widest / MOST_COUNT)))
    pitches = PITCHES_MM if coarse <= PITCHES_MM[0] else (coarse, *PITCHES_MM)
    return tuple(pitch for pitch in pitches if widest <= pitch * MOST_COUNT)


def _lists_per_face(places: list[list[list[float]]]) -> list[Any]:
    """One list for all faces where they are alike."""
    return places[0] if all(face == places[0] for face in places) else places


def rounded_places(places_mm: Shares) -> list[list[float]]:
    return [[round(float(x), 2) + 0.0 for x in xy] for xy in places_mm]
