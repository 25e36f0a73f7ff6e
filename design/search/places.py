"""Places of magnets and sensors in a search: linear in its variables, under a symmetry.

Sensors on a ring are linear in radius and azimuth. One map thus serves a single layout and a batch
with gradients. Symmetry turns and mirrors one magnet's variables about the face's centre.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from design.catalogue.magnets import magnet_grade
from design.layout.pockets import magnet_bodies
from design.search.faces import group_labels, layout_groups
from design.spec.object import ObjectSpec
from design.spec.search import VarySpec


@dataclass(frozen=True)
class Seat:
    """Where a magnet or sensor comes from: variables of `label`, moved and turned by matrices."""

    label: str
    place: tuple[tuple[float, float], tuple[float, float]]
    turn: tuple[tuple[float, float], tuple[float, float]]


@dataclass(frozen=True)
class PlaceMap:
    """Places of parts as constant + matrix · continuous variables; `polar`: radius and azimuth.

    Columns of a magnet: x, y, depth (mm), tilt about x and y (degrees). Of a sensor: x, y (mm), or
    radius (mm) and azimuth (degrees).
    """

    constant: Float[np.ndarray, "part column"]
    matrix: Float[np.ndarray, "part column variable"]
    polar: bool = False

    def at(self, values: Float[np.ndarray, "variable"]) -> Float[np.ndarray, "part column"]:
        found = self.constant + self.matrix @ values
        if not self.polar:
            return found
        radius, azimuth = found[:, 0], np.deg2rad(found[:, 1])
        return np.stack([radius * np.cos(azimuth), radius * np.sin(azimuth)], axis=1)


def magnet_maps(structured: ObjectSpec, names: tuple[str, ...]) -> tuple[PlaceMap, ...]:
    """Where magnets are, of what `with_structure` made, for each of `layout_groups`; `names` are the
    continuous variables'."""
    count = structured.magnets.count
    tilts = structured.magnets.tilt_deg or ((0.0, 0.0),) * count
    seats = seats_of(structured.search.magnet_symmetry, count)
    columns = {"x_mm": 0, "y_mm": 1, "depth_mm": 2, "tilt_x_deg": 3, "tilt_y_deg": 4}
    found = []
    for group, label in zip(layout_groups(structured), group_labels(structured), strict=True):
        bodies = magnet_bodies(structured)[structured.body.sensed.index(group[0])]
        base = np.array(
            [[*(b.centre_mm * [1, 1, -1]), *tilt] for b, tilt in zip(bodies, tilts, strict=True)]
        )
        found.append(
            _place_map(structured.search.vary, names, "magnet", seats, base, columns, label)
        )
    return tuple(found)


def sensor_maps(structured: ObjectSpec, names: tuple[str, ...]) -> tuple[PlaceMap, ...]:
    """Where sensors are, where they move: one layout for every face of a group."""
    count, vary = structured.sensors.count_per_face, structured.search.vary
    labels = group_labels(structured)
    if structured.search.sensor_symmetry == "ring":
        around = np.column_stack([np.zeros(count), 360.0 * np.arange(count) / count])
        return tuple(_ring_map(around, names, label) for label in labels)
    seats, still = seats_of(structured.search.sensor_symmetry, count), np.zeros((count, 2))
    columns = {"x_mm": 0, "y_mm": 1}
    return tuple(
        _place_map(vary, names, "sensor", seats, still, columns, label) for label in labels
    )


def _ring_map(around: Float[np.ndarray, "part 2"], names: tuple[str, ...], label: str) -> PlaceMap:
    matrix = np.zeros((len(around), 2, len(names)))
    matrix[:, 0, names.index(f"{label}sensor_radius_mm")] = 1.0
    matrix[:, 1, names.index(f"{label}sensor_azimuth_deg")] = 1.0
    return PlaceMap(around, matrix, polar=True)


def polarities(structured: ObjectSpec, params: Mapping[str, Any]) -> list[float]:
    """Polarization of every magnet over that of the specification's first; negative for north inward."""
    magnets, vary = structured.magnets, structured.search.vary
    signs, strengths = magnets.polarities, magnets.strengths
    if vary.magnet_north:
        norths = choices_of_magnets(structured, params, "north")
        signs = tuple(1 if way == "outward" else -1 for way in norths)
    if vary.magnet_grade:
        grades = choices_of_magnets(structured, params, "grade")
        first = magnets.remanences_t[0]
        strengths = tuple(magnet_grade(name).remanence_t / first for name in grades)
    return [float(sign * strength) for sign, strength in zip(signs, strengths, strict=True)]


def choices_of_magnets(
    structured: ObjectSpec, params: Mapping[str, Any], name: Literal["north", "grade", "size"]
) -> list[str]:
    """What a trial chose for every magnet of a face; those of one seat under the symmetry are alike."""
    seats = seats_of(structured.search.magnet_symmetry, structured.magnets.count)
    return [params[f"magnet{seat.label}_{name}"] for seat in seats]


def _place_map(
    vary: VarySpec,
    names: tuple[str, ...],
    part: str,
    seats: tuple[Seat, ...],
    base: Float[np.ndarray, "part column"],
    columns: dict[str, int],
    label: str,
) -> PlaceMap:
    """Columns that have variables are theirs, moved by the seats; all others stay as they are.

    Names of x and y begin with the group's label; depths and tilts are those of all groups.
    """
    constant = base.copy()
    matrix = np.zeros((*base.shape, len(names)))
    for row, seat in enumerate(seats):
        prefix = f"{part}{seat.label}_"
        for first, moved in ((0, seat.place), (3, seat.turn)):
            own = label if first == 0 else ""
            pair = [
                own + prefix + name
                for name, column in columns.items()
                if column in (first, first + 1)
            ]
            if _freed(vary, part, first):
                constant[row, first : first + 2] = 0.0
            for k, name in enumerate(pair):
                if name in names:
                    matrix[row, first : first + 2, names.index(name)] = np.asarray(moved)[:, k]
        if prefix + "depth_mm" in names:
            constant[row, 2] = 0.0
            matrix[row, 2, names.index(prefix + "depth_mm")] = 1.0
    return PlaceMap(constant, matrix)


def _freed(vary: VarySpec, part: str, first_column: int) -> bool:
    if first_column == 0:
        return getattr(vary, f"{part}_reach_mm") is not None
    return part == "magnet" and vary.magnet_tilt_deg is not None


_ONE = ((1.0, 0.0), (0.0, 1.0))
_NONE = ((0.0, 0.0), (0.0, 0.0))
_MIRROR = ((-1.0, 0.0), (0.0, 1.0))
_MIRROR_TURN = ((1.0, 0.0), (0.0, -1.0))
"""Tilts are axial vectors: mirrored in x, that about y changes its sign."""
_ON_X0 = ((0.0, 0.0), (0.0, 1.0))
_ON_X0_TURN = ((1.0, 0.0), (0.0, 0.0))


@cache
def seats_of(symmetry: str, count: int) -> tuple[Seat, ...]:
    if symmetry == "free":
        return tuple(Seat(str(k + 1), _ONE, _ONE) for k in range(count))
    if symmetry == "mirrored":
        pairs = [
            Seat(str(k + 1), *matrices)
            for k in range(count // 2)
            for matrices in ((_ONE, _ONE), (_MIRROR, _MIRROR_TURN))
        ]
        return (*pairs, *([Seat("_axis", _ON_X0, _ON_X0_TURN)] if count % 2 else []))
    quarter = [
        _ONE,
        ((0.0, -1.0), (1.0, 0.0)),
        ((-1.0, 0.0), (0.0, -1.0)),
        ((0.0, 1.0), (-1.0, 0.0)),
    ]
    fours = [Seat(str(k + 1), turn, turn) for k in range(count // 4) for turn in quarter]
    return (*fours, *([Seat("_centre", _NONE, _NONE)] if count % 4 else []))


def generators(symmetry: str, counts: tuple[int, ...]) -> list[Seat]:
    """One seat for each label that any of the counts needs."""
    found: dict[str, Seat] = {}
    for count in sorted(counts):
        for seat in seats_of(symmetry, count):
            found.setdefault(seat.label, seat)
    return list(found.values())
